#!/usr/bin/env bash
# A program of one's own, as README.md describes it: another project adds this one's folder, links `pushback`, and compiles the
# README's program with more warnings as errors than are on here. Nothing but the libraries may come along.
#   tests/own_project.sh [COMPILER [LAUNCHER]]
# The other project has no build type: unoptimised is what that README's two lines give, and is built soonest.
set -euo pipefail
root=$(cd "$(dirname "$0")/.." && pwd)
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
cd "$scratch"
wrong() { echo "own_project: $*"; exit 1; }

ln -s "$root" pushback
awk '/^```cpp$/ { shown = 1; next } /^```$/ { shown = 0 } shown' pushback/README.md >main.cpp
grep -q '^int main' main.cpp || wrong "README.md shows no program"
said=$(grep -o '`[a-z_]*([^`]*pushback)`' pushback/README.md | tr -d '`')  # its two lines of CMake, as they stand there
[[ $(wc -l <<<"$said") == 2 ]] || wrong "README.md should show two lines of CMake, but these were found: $said"
cat >CMakeLists.txt <<END
cmake_minimum_required(VERSION 3.25)
project(another LANGUAGES CXX)
enable_testing()
add_compile_options(-Wall -Wextra -Werror -Wconversion -Wsign-conversion)
add_executable(my_program main.cpp)
$said
END

# ccache may take objects from an earlier run, whose folder had another name. Not by the names of headers: behind the link
# they stay the same while their contents change.
export CCACHE_BASEDIR=$scratch CCACHE_NOHASHDIR=1 CCACHE_NODIRECT=1
cmake -S . -B build -G Ninja -DCMAKE_EXPORT_COMPILE_COMMANDS=ON ${1:+-DCMAKE_CXX_COMPILER="$1"} \
  ${2:+-DCMAKE_CXX_COMPILER_LAUNCHER="$2"} >log 2>&1 || { cat log; wrong "the other project cannot be configured"; }

# What came along: the libraries, and no test, option or program of ours.
targets=$(ninja -C build -t targets all | sed -En 's%^([^ ]*): CXX_(STATIC_LIBRARY|EXECUTABLE)_LINKER.*%\1%p' | xargs -n 1 basename | sort | tr '\n' ' ')
[[ $targets == "libpushback.a libpushback_render.a libpushback_simulation.a libpushback_simulation_float.a my_program " ]] ||
  wrong "the other project builds: $targets"
ctest --test-dir build -N | grep -q '^Total Tests: 0$' || wrong "the other project has tests of ours"
! grep -E '^PUSHBACK_(TESTS|BENCH|PEERS|WERROR)' build/CMakeCache.txt || wrong "the other project is asked for what is built only here"

# Its own code: its own warnings, no others, none of them taken back; and the one option that the same bits depend on.
command=$(grep '"command".*main.cpp' build/compile_commands.json)
flags=$(grep -oE -- ' -W[^ ]*' <<<"$command" | tr -d '\n')
[[ $flags == " -Wall -Wextra -Werror -Wconversion -Wsign-conversion" ]] || wrong "its code is compiled with$flags"
[[ $command == *" -ffp-contract=off "* ]] || wrong "its code, which our templates are compiled in, lacks -ffp-contract=off: $command"

cmake --build build -j 2 >log 2>&1 || { cat log; wrong "the other project cannot be built"; }
build/my_program --no-images --seconds 0.5 --out renders >log 2>&1 || { cat log; wrong "its program does not run"; }
grep -q '^| all seven chapters | ' renders/my_experiment/numbers.md || wrong "its program left no numbers behind"
echo "all as expected"
