#!/usr/bin/env bash
# Work in parts: what ./course writes for a loop and for Slurm does what one call on one machine does.
#   tests/project/parts.sh PROGRAMS          a loop, and a stand-in for sbatch
#   tests/project/parts.sh PROGRAMS --slurm  a Slurm of one machine, begun here; exit status 77 where it cannot be
# PROGRAMS: the folder of hard_cases_table and hard_cases_fuzz.
# shellcheck disable=SC2016,SC2054  # the stand-ins' scripts are quoted as they are; stages are divided by commas
set -uo pipefail
programs=$(realpath "$1") root=$(cd "$(dirname "$0")/../.." && pwd)
scratch=$(mktemp -d)
daemons=()
stop() { for pid in "${daemons[@]}"; do kill "$(cat "$pid" 2>/dev/null)" 2>/dev/null; done; sleep 0.2; rm -rf "$scratch"; }
trap stop EXIT
failures=0
wrong() { echo "line ${BASH_LINENO[0]}: $*"; failures=$((failures + 1)); }
skip() { echo "parts: skipped: $*"; exit 77; }

# A copy of the project in which nothing is compiled.
mkdir -p "$scratch"/{bin,home/build/release,home/chapters}
cp "$root/course" "$root/CMakePresets.json" "$scratch/home"
ln -s "$programs" "$scratch/home/build/release/programs"
touch "$scratch/home/build/release/build.ninja"
stand_in() { printf '#!/bin/sh\n%s\n' "$2" >"$scratch/bin/$1" && chmod +x "$scratch/bin/$1"; }
stand_in cmake true
stand_in dpkg-query 'shift 3; for p; do printf " installed:%s " "$p"; done'
cd "$scratch/home" || exit 1
export PATH=$scratch/bin:$PATH
course() { output=$(./course "$@" 2>&1 </dev/null); status=$?; }
says() { [[ $output == *"$1"* ]] || wrong "not said: $1; but: $output"; }

table=(hard-cases contacts-twice bounces stack-10) table_options=(-- --stages 01,07 --starts 1 --no-images)
fuzz=(fuzz) fuzz_options=(-- --first 5 --scenes 7 --stage "07 warm start")
course "${table[@]}" "${table_options[@]}"
((status == 0)) || wrong "the whole table: $output"
mv renders whole
"$programs/hard_cases_fuzz" "${fuzz_options[@]:1}" >whole/fuzz.said
same() {  # the table and the random scenes, by what has just been joined
  local file
  for file in table.csv table.md; do
    cmp "whole/hard_cases/part/$file" "renders/hard_cases/part/$file" || wrong "$1: another $file than of one call"
  done
  cmp whole/fuzz.said "$2" || wrong "$1: the random scenes say something else"
  rm -rf renders
}
again() { rm -rf build/release/parts renders; }
result() {
  ((failures == 0)) || { echo "$failures failures"; exit 1; }
  echo "all as expected"
}

if [[ ${2:-} == --slurm ]]; then
  [[ $(id -u) == 0 ]] || skip "only root can begin a Slurm of one machine"
  for tool in munged slurmctld slurmd sbatch; do command -v $tool >/dev/null || skip "there is no $tool"; done
  id munge >/dev/null 2>&1 || skip "there is no user munge"
  export SLURM_CONF=$scratch/slurm.conf
  mkdir -p "$scratch"/{state,spool,munge}
  dd if=/dev/urandom of="$scratch/munge/key" bs=128 count=1 status=none
  chown -R munge "$scratch/munge" && chmod 755 "$scratch" && chmod 700 "$scratch/munge" && chmod 400 "$scratch/munge/key"
  # A socket, a key and ports of its own: another Slurm may run here.
  mkdir -m 755 "$scratch/socket" && chown munge "$scratch/socket"
  su -s /bin/sh munge -c "munged --force --key-file='$scratch/munge/key' --socket='$scratch/socket/s' --pid-file='$scratch/munge/pid' \
    --log-file='$scratch/munge/log' --seed-file='$scratch/munge/seed'" || skip "munged does not begin"
  host=$(hostname)
  cat >"$SLURM_CONF" <<END
ClusterName=parts
SlurmctldHost=$host(127.0.0.1)
SlurmctldPort=16817
SlurmdPort=16818
AuthType=auth/munge
AuthInfo=socket=$scratch/socket/s
SlurmUser=root
StateSaveLocation=$scratch/state
SlurmdSpoolDir=$scratch/spool
SlurmctldPidFile=$scratch/ctld.pid
SlurmdPidFile=$scratch/d.pid
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
ReturnToService=2
NodeName=$host NodeAddr=127.0.0.1 CPUs=$(nproc) State=UNKNOWN
PartitionName=all Nodes=ALL Default=YES MaxTime=INFINITE State=UP
END
  daemons=("$scratch/d.pid" "$scratch/ctld.pid" "$scratch/munge/pid")
  slurmctld -f "$SLURM_CONF" -L "$scratch/ctld.log" || skip "slurmctld does not begin: $(tail -n 3 "$scratch/ctld.log")"
  slurmd -f "$SLURM_CONF" -L "$scratch/d.log" || skip "slurmd does not begin: $(tail -n 3 "$scratch/d.log")"
  for ((i = 0; i < 100; ++i)); do [[ $(sinfo --noheader --format %T 2>/dev/null) == idle ]] && break; sleep 0.2; done
  ended() { for ((i = 0; i < 600; ++i)); do [[ $(squeue --noheader) ]] || return 0; sleep 0.2; done; wrong "jobs do not end: $(squeue)"; }

  # A part that fails, here for want of a place for its results: nothing is joined. Then this part alone is submitted, and the join.
  course "${table[@]}" --shards 3 "${table_options[@]}"
  folder=$(echo "$PWD"/build/release/parts/hard-cases-*)
  mkdir -p "$folder/out/hard_cases/part"
  touch "$folder/out/hard_cases/part/shard_2_of_3"
  course "${table[@]}" --shards 3 --slurm="--comment tables" "${table_options[@]}"
  says "3 submitted as job "
  ended
  [[ ! -e renders ]] || wrong "something was joined of parts that are missing"
  [[ -e $folder/1.done && ! -e $folder/2.done && -e $folder/3.done ]] || wrong "not parts 1 and 3 are done: $(ls "$folder")"
  rm "$folder/out/hard_cases/part/shard_2_of_3"
  course "${table[@]}" --shards 3 --slurm "${table_options[@]}"
  says "1 submitted as job "
  course "${fuzz[@]}" --shards 3 --slurm "${fuzz_options[@]}"
  ended
  same "Slurm, after a failure" build/release/parts/fuzz-*/joined.said
  course "${table[@]}" --shards 3 --slurm "${table_options[@]}"
  says "all are joined"
  result
  exit
fi

# A loop.
course "${table[@]}" --shards 3 "${table_options[@]}"
says "3 parts, of which 0 are done"
says "for part in {1..3}; do bash $PWD/build/release/parts/hard-cases-"
folder=$(echo "$PWD"/build/release/parts/hard-cases-*)
echo 0123456789ab >"$folder/commit"  # as it was when these programs were built: no later commit is written down for a part
bash "$folder/join.sh" 2>/dev/null && wrong "parts that are missing were joined"
bash "$folder/part.sh" 2 >/dev/null
course "${table[@]}" --shards 3 "${table_options[@]}"
[[ $(cat "$folder"/out/hard_cases/part/shard_2_of_3/origin.txt) == *$'\n'"commit: 0123456789ab" ]] || wrong "the part is of another commit"
course "${table[@]}" --shards 3 "${table_options[@]}"
says "3 parts, of which 1 are done"
course "${fuzz[@]}" --shards 3 "${fuzz_options[@]}"
loops=$(for one in build/release/parts/*; do echo "for part in 1 2 3; do bash $one/part.sh \$part; done && bash $one/join.sh >$one/joined.said"; done)
bash -c "$loops" >/dev/null || wrong "the loops fail"
same "a loop" build/release/parts/fuzz-*/joined.said

# A stand-in for Slurm: what is submitted, how, and what the second time.
again
stand_in sbatch 'echo "$*" >>'"$scratch"'/asked; echo "$(wc -l <'"$scratch"'/asked);cluster"'
stand_in squeue 'cat '"$scratch"'/queue'
: >"$scratch/asked"
: >"$scratch/queue"
asked() { local line; line=$(sed -n "$1p" "$scratch/asked"); shift; for text; do [[ $line == *"$text"* ]] || wrong "sbatch was not asked for $text: $line"; done; }
course "${table[@]}" --shards 4 --slurm="--partition short --time 60" "${table_options[@]}"
says "4 submitted as job 1, joined by job 2"
folder=$(echo "$PWD"/build/release/parts/hard-cases-*)
asked 1 "--parsable --job-name pushback-hard-cases --partition short --time 60 --array 1,2,3,4 --output $folder/%a.said $folder/part.sh"
asked 2 "--partition short --time 60 --dependency afterok:1 --kill-on-invalid-dep yes --output $folder/joined.said $folder/join.sh"
[[ $(cat "$scratch/asked") != *--exclusive* ]] || wrong "what is not timed gets machines of its own"
echo "1_2 all pushback" >"$scratch/queue"
course "${table[@]}" --shards 4 --slurm "${table_options[@]}"
((status == 1)) || wrong "exit status $status while jobs are under way"
says "jobs 1,2 are still running"
: >"$scratch/queue"
SLURM_ARRAY_TASK_ID=3 bash "$folder/part.sh" >/dev/null
bash "$folder/part.sh" 1 >/dev/null
course "${table[@]}" --shards 4 --slurm "${table_options[@]}"
says "2 submitted as job 3, joined by job 4"
asked 3 "--array 2,4 "
asked 4 "afterok:3"
for part in 2 4; do bash "$folder/part.sh" $part >/dev/null; done
bash "$folder/join.sh" >/dev/null
course "${table[@]}" --shards 4 --slurm "${table_options[@]}"
says "all are joined"
[[ $(wc -l <"$scratch/asked") == 4 ]] || wrong "more was submitted: $(cat "$scratch/asked")"
# Times are taken by one part on a machine.
for name in study frozen motion motion_float motion_wide; do [[ -e $programs/$name ]] || touch "$scratch/missing"; done
if [[ ! -e $scratch/missing ]]; then
  course study --quick --slurm --shards 4
  asked 5 "--exclusive --array 1,2,3,4 "
  [[ $(cat build/release/parts/study-*/part.sh) == *"/study --quick"*"--shard \$part/4"*"/frozen --quick"*"--shard \$part/4"* ]] ||
    wrong "another part of the study: $(cat build/release/parts/study-*/part.sh)"
fi
# A class: the last call has no part, so it has all.
if [[ -e $programs/grade ]]; then
  mkdir "$scratch/ben" && touch "$scratch/ben/03_baumgarte.h"
  grade() { output=$(cd "$scratch" && home/course grade "an na" ben --shards 3 2>&1); }
  grade
  grading=$(cat build/release/parts/grade-*/part.sh) all=$(cat build/release/parts/grade-*/join.sh)
  [[ $grading == *"cd $scratch"*"/programs/grade  --shard \$part/3 an\ na ben "* ]] || wrong "another part of grading: $grading"
  [[ $all == *"cd $scratch"*"/programs/grade  an\ na ben "* ]] || wrong "another whole of grading: $all"
  folder=$(echo build/release/parts/grade-*)
  touch "$folder"/{1,2,3}.done
  grade
  says "3 parts, of which 3 are done"
  touch "$folder/joined"
  grade
  says "3 parts, of which 0 are done"
fi
rm "$scratch/bin/sbatch"
if ! command -v sbatch >/dev/null; then
  course fuzz --slurm
  ((status == 1)) || wrong "exit status $status without sbatch"
  says "there is no sbatch here"
fi
result
