#!/usr/bin/env bash
# The tables of measured numbers in the chapters' READMEs, and in the pages on accuracy and time, on the benchmark, on other methods and on which solver to take, are copies of what the
# programs wrote into renders/: this test compares them. So are the differences in code, which differences.sh writes there.
#   tests/project/readme_numbers.sh           fails, with the difference, where a page is not up to date
#   tests/project/readme_numbers.sh --write   brings every page up to date
# A page marks the place:  <!-- numbers.md -->  table  <!-- end -->,  and so for difference.md
set -euo pipefail
cd "$(dirname "$0")/../.."

passed=0 failed=0
if [[ ${1:-} == --write ]]; then bash tests/project/differences.sh renders
else
  scratch=$(mktemp -d)
  trap 'rm -rf "$scratch"' EXIT
  bash tests/project/differences.sh "$scratch"
  for made in "$scratch"/*/difference.md; do
    shown=renders/${made#"$scratch/"}
    diff "$made" "$shown" && continue
    echo "$shown differs from what the sources say: run tests/project/readme_numbers.sh --write"
    failed=$((failed + 1))
  done
fi
for readme in chapters/[0-9][0-9]_*/README.md docs/accuracy_and_time.md docs/benchmark.md docs/methods.md docs/which_solver.md; do
  name=$(basename "$(dirname "$readme")")
  [[ $readme != docs/accuracy_and_time.md && $readme != docs/benchmark.md ]] || name=19_accuracy_and_time
  [[ $readme != docs/methods.md ]] || name=methods
  [[ $readme != docs/which_solver.md ]] || name=26_to_each_its_own
  numbers=renders/$name
  wanted=$(awk -v folder="$numbers" '
    /^<!-- [a-z]+\.md -->$/ { print; print ""; file = folder "/" $2; while ((getline line < file) > 0) print line; print ""; skip = 1; found = 1 }
    /^<!-- end -->$/        { skip = 0 }
    !skip                   { print }
    END                     { exit found ? 0 : 1 }' "$readme") || { echo "$readme: no place for the numbers"; failed=$((failed + 1)); continue; }
  if [[ -e $numbers/difference.md ]] && ! grep -q '^<!-- difference.md -->$' "$readme"; then
    echo "$readme: no place for the difference in code"
    failed=$((failed + 1))
    continue
  fi
  if [[ ${1:-} == --write ]]; then
    printf '%s\n' "$wanted" >"$readme"
  elif ! printf "%s\n" "$wanted" | diff - "$readme"; then
    echo "$readme differs from $numbers: run tests/project/readme_numbers.sh --write"
    failed=$((failed + 1))
    continue
  fi
  passed=$((passed + 1))
done
echo "$passed passed, $failed failed"
[[ $failed == 0 ]]
