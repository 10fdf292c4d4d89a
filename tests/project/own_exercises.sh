#!/usr/bin/env bash
# Exercises in a folder of a student's own, outside the tree, with nothing but an installed Pushback, wherever that has been
# moved to: the build compiles what is written, and says the verdict.
#   tests/project/own_exercises.sh BUILD     BUILD: where this project has been built
set -euo pipefail
root=$(cd "$(dirname "$0")/../.." && pwd)
. "$root/tests/support/whole_path.sh"
built=$(cd "$1" && pwd)
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
cd "$scratch"
wrong() { printf 'own_exercises: %s\n' "$@"; exit 1; }
says() { [[ $output == *"$1"* ]] || wrong "not said: $1" "$output"; }
says_not() { [[ $output != *"$1"* ]] || wrong "said: $1" "$output"; }
verdict() { output=$(cmake --build mine/build 2>&1) || wrong "the build fails" "$output"; }
no_verdict() { ! output=$(cmake --build mine/build 2>&1) || wrong "a wrong answer builds" "$output"; }

cmake --install "$built" --component exercises --prefix "$scratch/prefix" >log 2>&1 || { cat log; wrong "nothing can be installed"; }
mkdir elsewhere
mv prefix elsewhere/
program=$scratch/elsewhere/prefix/bin/pushback-exercise
! grep -rqE -e "$(whole "$root")" -e "$(whole "$scratch")" elsewhere/prefix/share || wrong "what is installed knows where it came from"
! find elsewhere -name '*.cpp' | grep -v answer.cpp || wrong "sources are installed"

env -i "PATH=$PATH" "$program" --new mine >log 2>&1 || { cat log; wrong "no folder is made"; }
(cd mine && find . -type f | sort) >files
for file in CMakeLists.txt README.md 02_clamping.h 02_clamping.md; do grep -qFx "./$file" files || wrong "no $file"; done
! grep -rl "course exercise" mine || wrong "the command is another one there"
! "$program" --new mine >log 2>&1 || wrong "a folder that is not empty is written into"

cmake -S mine -B mine/build -G Ninja >log 2>&1 || { cat log; wrong "it cannot be configured"; }
[[ -s elsewhere/prefix/share/pushback/pages/chapters/02_clamping/README.md ]] || wrong "the page is not installed"
grep -q "share/pushback/pages/chapters/02_clamping/README.md" mine/02_clamping.md || wrong "the task does not say where the page is"
grep -q "    pushback-exercise 02 --hint" mine/02_clamping.md || wrong "the task has another command"
verdict
says "next: pushback-exercise 0"
says_not "✗"
cp mine/02_clamping.h stub
gap() { sed '/TODO/,/TODO ends/c\'"$1" stub >mine/02_clamping.h; }
gap 'rows[0].apply(-rows[0].effective_mass * rows[0].speed())'
no_verdict
says "It does not compile. Line "
least='const Real least = -force * h / static_cast<Real>(rows.size());'
gap "$least"' for (Row\& row : rows) { const Real lambda = std::max(least, -row.effective_mass * (row.speed() + row.bias)); row.impulse += lambda; row.apply(lambda); }'
no_verdict
says "02           begun" && [[ ${output##*begun} == *"The accumulated impulse is at least"* ]] || wrong "the verdict is not the last" "$output"
[[ $(grep -c begun <<<"$output") == 1 ]] || wrong "untouched files are begun" "$output"
says "The accumulated impulse is at least -F h." && says "For another hint: pushback-exercise 02 --hint"
gap "$least"' for (Row\& row : rows) { const Real sum = std::max(least, row.impulse - row.effective_mass * (row.speed() + row.bias)); row.apply(sum - row.impulse); row.impulse = sum; }'
verdict
says "Solved."
verdict
says "02           solved" && says_not "Solved."
output=$(cd mine && env -i "PATH=$PATH" "$program" 02) || wrong "in the folder itself it is not solved" "$output"
says "Solved."
echo "all as expected"
