#!/usr/bin/env bash
# What runs on other systems: the files say the commands of README.md and nothing else, and these commands run in a bare Debian.
#   tests/project/bare_system.sh                                    the files alone
#   tests/project/bare_system.sh --run [RELEASE...]                 these commands, in a bare Debian of each release, and their times
#   tests/project/bare_system.sh --commands [RELEASE...] [NAME...]  all commands, or those named, each for a moment
# RELEASE: bookworm or trixie; both if none is named. Exit status 77 where no such system can be made.
set -euo pipefail
root=$(cd "$(dirname "$0")/../.." && pwd)
cd "$root"
wrong() { echo "bare_system: $*"; exit 1; }
skip() { echo "bare_system: skipped: $*"; exit 77; }

tries=(  # each command of ./course --help, for a moment; those that read what others write come after them
  "render 04"
  "test 04"
  "hard-cases stack-20 --quick"
  "effects"
  "run export 07-pyramid /tmp/problem.dat --step 20"
  "run solve /tmp/problem.dat"
  "run growth --tolerance 1e-2"
  "choose 06-slide --error 1mm --seconds 0.5"
  "book --still"
  "test --book build live_page"
  "study --quick -- --only bounce"
  "run prices --rounds 1"
  "run outside sphere_in_slot"
  "run calibration --scenes 5"
  "fuzz -- --scenes 5"
  "bench effects -- --benchmark_filter=frictionless_solving"
  "exercise"
  "mine"
  "run handout /tmp/handout --with 03"
  "grade /tmp/handout --no-sandbox"
  "check --quick"
  "clean"
)

# ---- the words -------------------------------------------------------------------------------------------------------
readme=$(grep -oE '^    \./course [a-z]+' README.md | sed 's/^ *//')
[[ $readme == $'./course render\n./course test' ]] || wrong "README.md begins with other commands: $readme"
run=$(sed -nE 's/^RUN //p; s/^CMD \["(.*)"\]$/\1/p' Containerfile | sed 's/", "/ /g')
said=$run$'\n'$(sed -nE 's/.*"postCreateCommand": "(.*)".*/\1/p' .devcontainer/devcontainer.json)
[[ $said == $'./course render --yes\n./course test --yes\n./course render --yes' ]] || wrong "other commands: $said"
[[ $(sed -n 's/^    \.\/course /&/p' docs/other_systems.md | sed 's/^ *//') == "$readme" ]] || wrong "docs/other_systems.md has other commands"
[[ $(sed -n 's/^FROM //p' Containerfile) == $(sed -nE 's/.*"image": "(.*)".*/\1/p' .devcontainer/devcontainer.json) ]] ||
  wrong "two base systems"
names=$(./course --help | sed -nE '/^$/,/^$/ s/^  ([a-z-]+) .*/\1/p')
[[ $(printf '%s\n' "${tries[@]%% *}" | sort -u) == $(sort <<<"$names") ]] || wrong "not every command is tried, or others are"
what=${1:-}
[[ $what ]] || exit 0
[[ $what == --run || $what == --commands ]] || wrong "unknown option '$what'"
releases=() named=" "
for word in "${@:2}"; do
  if [[ $word == bookworm || $word == trixie ]]; then releases+=("$word")
  elif [[ $what == --commands ]] && grep -qFx -- "$word" <<<"$names"; then named+="$word "
  else wrong "unknown word '$word'"
  fi
done
((${#releases[@]})) || releases=(bookworm trixie)

# ---- the deeds -------------------------------------------------------------------------------------------------------
[[ $(id -u) == 0 ]] || skip "only root can make a system"
command -v mmdebstrap >/dev/null || skip "there is no mmdebstrap"
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

bare() {  # bare RELEASE [PACKAGE...]: a system anew, with the project in it
  rm -rf "$scratch/system"
  mmdebstrap --variant=apt --include="ca-certificates ${*:2}" "$1" "$scratch/system" >"$scratch/log" 2>&1 ||
    { tail -n 5 "$scratch/log"; skip "no system could be made, perhaps for want of a network"; }
  mkdir "$scratch/system/pushback"
  git ls-files -z | tar --null -T - -c | tar -x -C "$scratch/system/pushback"
  cp /etc/resolv.conf /etc/hosts "$scratch/system/etc/" 2>/dev/null || true
  cp /etc/ssl/certs/ca-certificates.crt "$scratch/system/etc/ssl/certs/" 2>/dev/null || true  # the network may need one of its own
}

in_it() {  # in_it COMMAND: in the system, with its processes and devices for as long as it takes
  # shellcheck disable=SC2016
  unshare --mount --fork --pid bash -c '
    mount -t proc proc "$0/proc" && mount --bind /dev "$0/dev"
    exec chroot "$0" env -i HOME=/root NODE_EXTRA_CA_CERTS=/etc/ssl/certs/ca-certificates.crt PATH=/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin CI=true bash -c "cd /pushback && $1"' \
    "$scratch/system" "$1" </dev/null
}

runs() {  # runs WHERE COMMAND
  local began=$SECONDS
  in_it "$2" || { echo "bare_system: in a bare $1, $2 fails"; return 1; }
  echo "bare_system: $1: $2: $((SECONDS - began)) s"
}

for release in "${releases[@]}"; do
  if [[ $what == --run ]]; then
    bare "$release"
    rm "$scratch"/system/pushback/renders/[0-2][0-9]_*/sheet.png
    while read -r command; do runs "$release" "$command" || exit 1; done <<<"$run"
    for sheet in renders/[0-2][0-9]_*/sheet.png; do
      [[ -s $scratch/system/pushback/$sheet ]] || wrong "no $sheet was drawn"
    done
    continue
  fi
  bare "$release" git
  in_it "git init -q && git add -A && git -c user.name=x -c user.email=x@x commit -qm all" || wrong "there is no git"
  for try in "${tries[@]}"; do
    [[ $named == " " || $named == *" ${try%% *} "* ]] || continue
    runs "$release" "./course --yes $try" || failed=yes
  done
done
[[ ! ${failed:-} ]]
