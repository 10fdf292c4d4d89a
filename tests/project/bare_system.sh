#!/usr/bin/env bash
# What runs on other systems: the files say the commands of README.md and nothing else, and these commands run in a bare Debian.
#   tests/project/bare_system.sh [--run]     --run: run them, too. Exit status 77 where that cannot be done.
set -euo pipefail
root=$(cd "$(dirname "$0")/../.." && pwd)
cd "$root"
wrong() { echo "bare_system: $*"; exit 1; }
skip() { echo "bare_system: skipped: $*"; exit 77; }

# ---- the words -------------------------------------------------------------------------------------------------------
readme=$(grep -oE '^    \./course [a-z]+' README.md | sed 's/^ *//')
[[ $readme == $'./course render\n./course test' ]] || wrong "README.md begins with other commands: $readme"
said=$(sed -nE 's/^RUN //p; s/^CMD \["(.*)"\]$/\1/p' Containerfile | sed 's/", "/ /g'
  sed -nE 's/.*"postCreateCommand": "(.*)".*/\1/p' .devcontainer/devcontainer.json)
[[ $said == $'./course render --yes\n./course test --yes\n./course render --yes' ]] || wrong "other commands: $said"
[[ $(sed -n 's/^    \.\/course /&/p' docs/other_systems.md | sed 's/^ *//') == "$readme" ]] || wrong "docs/other_systems.md has other commands"
[[ $(sed -n 's/^FROM //p' Containerfile) == $(sed -nE 's/.*"image": "(.*)".*/\1/p' .devcontainer/devcontainer.json) ]] ||
  wrong "two base systems"
[[ ${1:-} == --run ]] || exit 0

# ---- the deeds -------------------------------------------------------------------------------------------------------
[[ $(id -u) == 0 ]] || skip "only root can make a system"
command -v mmdebstrap >/dev/null || skip "there is no mmdebstrap"
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
sources=$(cat /etc/apt/sources.list /etc/apt/sources.list.d/*.sources /etc/apt/sources.list.d/*.list 2>/dev/null || true)
release=$(. /etc/os-release && echo "$VERSION_CODENAME")
mmdebstrap --variant=apt --include=ca-certificates "$release" "$scratch/system" - <<<"$sources" >"$scratch/log" 2>&1 ||
  { tail -n 5 "$scratch/log"; skip "no system could be made, perhaps for want of a network"; }
mkdir "$scratch/system/pushback"
git ls-files -z | tar --null -T - -c | tar -x -C "$scratch/system/pushback"
cp /etc/resolv.conf /etc/hosts "$scratch/system/etc/" 2>/dev/null || true
in_it() {  # in_it COMMAND: in the system, with its processes and devices for as long as it takes
  # shellcheck disable=SC2016
  unshare --mount --fork --pid bash -c '
    mount -t proc proc "$0/proc" && mount --bind /dev "$0/dev"
    exec chroot "$0" env -i HOME=/root PATH=/usr/sbin:/usr/bin:/sbin:/bin CI=true bash -c "cd /pushback && $1"' "$scratch/system" "$1"
}
sed -n 's/^RUN //p' Containerfile | while read -r command; do
  began=$SECONDS
  in_it "$command" </dev/null || wrong "in a bare $release, $command fails"
  echo "bare_system: $command: $((SECONDS - began)) s"
done
for sheet in renders/[0-2][0-9]_*/sheet.png; do
  [[ -s $scratch/system/pushback/$sheet ]] || wrong "no $sheet was drawn"
done
