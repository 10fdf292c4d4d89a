#!/usr/bin/env bash
# Writes FOLDER/NN_name/difference.md for each chapter that has the whole solver as a plain loop (flat.h and flat.cpp) and a
# place for it in one of its pages: the lines that change against the loop with which the page compares it. For chapter 12's first
# loop (flat_a) it writes difference_a.md. The first loop of all is compared with none and shown whole.
#   tests/project/differences.sh FOLDER
set -euo pipefail
cd "$(dirname "$0")/../.."

# Without what differs for no reason of the chapter's: comment of the file, includes, namespaces, and empty lines left over.
bare() {
  awk 'FNR == 1 && /^\/\/\//, !/^\/\/\// { next }
       /^#/ || /^(}  \/\/ )?namespace/   { next }
       NF || last                        { print }
                                         { last = NF }' "$1"
}

# changes BEFORE AFTER .h|.cpp: of two loops, each under the name of the function or type that it is in. Where lines were only
# aligned anew, those of AFTER are shown.
changes() {
  awk -v file="${2##*/}$3" '
    NR == FNR { after[FNR] = $0; next }
    FNR <= 2  { next }
    /^@@/     {
      split($3, place, /[+,]/)
      line = place[2]
      for (i = line + place[3] - 1; i > 0 && after[i] !~ /^[a-zA-Z].*[{]$/; --i) continue
      split(after[i], word, / /)
      name = after[i]
      sub(/\(.*/, "", name)
      sub(/.*[ :]/, "", name)
      print "@@ " file ", " (word[1] ~ /struct|class/ ? word[2] : name) " @@"
      next
    }
    /^ /      { print (after[line] == "" ? "" : " ") after[line]; ++line; next }
    /^\+/     { ++line }
              { print }' <(bare "$2$3") <(diff -bU2 <(bare "$1$3") <(bare "$2$3"))
}

block() { printf '\140\140\140%s\n%s\n\140\140\140\n' "$1" "$(cat)"; }  # between two lines of three backquotes

for flat in chapters/[0-9][0-9]_*/flat.cpp chapters/[0-9][0-9]_*/flat_a.cpp; do
  chapter=$(dirname "$flat") loop=${flat%.cpp}
  name=difference${loop##*/flat}.md
  page=$(grep -l "^<!-- $name -->$" "$chapter"/*.md) || continue
  before=$(sed -n "s|.*(${flat##*/}), against \\[.*\\](\\(.*\\)\\.cpp).*|\\1|p" "$page")
  mkdir -p "$1/${chapter#*/}"
  if [[ $before ]]; then for file in .h .cpp; do changes "$chapter/$before" "$loop" $file; done | block diff
  else bare "$flat" | sed -n '/^\/\/\/ J V/,$p' | block cpp
  fi >"$1/${chapter#*/}/$name"
done
