#!/usr/bin/env bash
# Grading in parts: the scripts that ./course writes for a loop and for Slurm. The grader, sbatch and squeue are stand-ins.
# shellcheck disable=SC2016  # the stand-ins' scripts are quoted as they are
set -uo pipefail
root=$(cd "$(dirname "$0")/../.." && pwd)
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
failures=0
wrong() { echo "line ${BASH_LINENO[0]}: $*"; failures=$((failures + 1)); }

# A copy of the project in which nothing is compiled.
mkdir -p "$scratch"/{bin,home/build/release/programs,home/chapters,ben}
cp "$root/course" "$root/CMakePresets.json" "$scratch/home"
touch "$scratch/home/build/release/build.ninja"
stand_in() { printf '#!/bin/sh\n%s\n' "$2" >"$1" && chmod +x "$1"; }
stand_in "$scratch/bin/cmake" true
stand_in "$scratch/bin/dpkg-query" 'shift 3; for p; do printf " installed:%s " "$p"; done'
stand_in "$scratch/home/build/release/programs/grade" 'echo "$PWD: $*" >>'"$scratch/graded"
cd "$scratch" || exit 1
export PATH=$scratch/bin:$PATH
grade() { output=$(home/course grade "an na" ben --shards 3 "$@" 2>&1 </dev/null); status=$?; }
says() { [[ $output == *"$1"* ]] || wrong "not said: $1; but: $output"; }

# A loop. The last call has no part, so it has all.
grade
says "3 parts, of which 0 are done"
folder=$(echo "$scratch"/home/build/release/parts/grade-*)
says "for part in {1..3}; do bash $folder/part.sh \$part; done && bash $folder/join.sh"
bash "$folder/join.sh" 2>/dev/null && wrong "parts that are missing were joined"
bash "$folder/part.sh" 2
grade
says "3 parts, of which 1 are done"
bash -c "for part in {1..3}; do bash $folder/part.sh \$part; done && bash $folder/join.sh" || wrong "the loop fails"
[[ $(cat graded) == "$scratch: --shard 2/3 an na ben
$scratch: --shard 1/3 an na ben
$scratch: --shard 3/3 an na ben
$scratch: an na ben" ]] || wrong "other calls: $(cat graded)"
grade  # other students may have come since
says "3 parts, of which 0 are done"

# A stand-in for Slurm: what is submitted, how, and what the second time.
stand_in bin/sbatch 'echo "$*" >>'"$scratch"'/asked; echo "$(wc -l <'"$scratch"'/asked);cluster"'
stand_in bin/squeue 'cat '"$scratch"'/queue'
: >asked
: >queue
asked() { local line; line=$(sed -n "$1p" asked); shift; for text; do [[ $line == *"$text"* ]] || wrong "sbatch was not asked for $text: $line"; done; }
grade --slurm="--partition short --time 60"
says "3 submitted as job 1, joined by job 2"
asked 1 "--parsable --job-name pushback-grade --partition short --time 60 --array 1,2,3 --output $folder/%a.said $folder/part.sh"
asked 2 "--partition short --time 60 --dependency afterok:1 --kill-on-invalid-dep yes --output $folder/joined.said $folder/join.sh"
echo "1_2 all pushback" >queue
grade --slurm
((status == 1)) || wrong "exit status $status while jobs are under way"
says "jobs 1,2 are still running"
: >queue
SLURM_ARRAY_TASK_ID=3 bash "$folder/part.sh"
grade --slurm
says "2 submitted as job 3, joined by job 4"
asked 3 "--array 1,2 "
asked 4 "afterok:3"
rm bin/sbatch
if ! command -v sbatch >/dev/null; then
  grade --slurm
  ((status == 1)) || wrong "exit status $status without sbatch"
  says "there is no sbatch here"
fi

((failures == 0)) || { echo "$failures failures"; exit 1; }
echo "all as expected"
