#!/usr/bin/env bash
# The tables of measured numbers in the chapters' READMEs are copies of what the chapters wrote: this test compares them.
#   tests/readme_numbers.sh           fails, with the difference, where a README is not up to date
#   tests/readme_numbers.sh --write   brings every README up to date
# A README marks the place:  <!-- numbers.md -->  table  <!-- end -->
set -euo pipefail
cd "$(dirname "$0")/.."

passed=0 failed=0
for readme in chapters/[0-9][0-9]_*/README.md; do
  name=$(basename "$(dirname "$readme")")
  numbers=renders/$name/numbers.md
  wanted=$(awk -v file="$numbers" '
    /^<!-- numbers.md -->$/ { print; print ""; while ((getline line < file) > 0) print line; print ""; skip = 1; found = 1 }
    /^<!-- end -->$/        { skip = 0 }
    !skip                   { print }
    END                     { exit found ? 0 : 1 }' "$readme") || { echo "$readme: no place for the numbers"; failed=$((failed + 1)); continue; }
  if [[ ${1:-} == --write ]]; then
    printf '%s\n' "$wanted" >"$readme"
  elif ! printf "%s\n" "$wanted" | diff - "$readme"; then
    echo "$readme differs from $numbers: run tests/readme_numbers.sh --write"
    failed=$((failed + 1))
    continue
  fi
  passed=$((passed + 1))
done
echo "$passed passed, $failed failed"
[[ $failed == 0 ]]
