#!/usr/bin/env bash
# The tables of measured numbers on the chapters' pages, and on the pages of docs/ that `folder_of` lists, are copies of what the
# programs wrote into renders/: this test compares them. So are the differences in code, which differences.sh writes there.
#   tests/project/readme_numbers.sh           fails, with the difference, where a page is not up to date
#   tests/project/readme_numbers.sh --write   brings every page up to date
# A page marks the place:  <!-- numbers.md -->  table  <!-- end -->,  and so for difference.md. If a chapter has several pages, a
# page names its tables by their scenes, and what stands below them as remarks:  <!-- numbers.md: a ball | a stack | remarks -->
set -euo pipefail
cd "$(dirname "$0")/../.."

passed=0 failed=0
wrong() { echo "$*"; failed=$((failed + 1)); }
if [[ ${1:-} == --write ]]; then bash tests/project/differences.sh renders
else
  scratch=$(mktemp -d)
  trap 'rm -rf "$scratch"' EXIT
  bash tests/project/differences.sh "$scratch"
  for made in "$scratch"/*/difference*.md; do
    shown=renders/${made#"$scratch/"}
    diff "$made" "$shown" || wrong "$shown differs from what the sources say: run tests/project/readme_numbers.sh --write"
  done
fi

# filled PAGE FOLDER: the page with the files of the folder in their places. Fails if it has no place.
filled() {
  awk -v folder="$2" '
    # The parts of a file are separated by empty lines. A part is a table, which its first cell names, or the remarks.
    function name_of(line, cells) { split(line, cells, / *\| */); return line ~ /^\|/ ? cells[2] : "remarks" }
    function show(file, names,   line, name, before, shown, wanted, count, i) {
      count = split(names, wanted, / \| /)  # none: all parts
      while ((getline line < file) > 0) {
        if (before == "") name = name_of(line)
        before = line
        for (i = count; i > 0 && wanted[i] != name; --i) continue
        if (!count || i) print shown = line
      }
      close(file)
      if (shown != "") print ""
    }
    /^<!-- [a-z_]+\.md(: .*)? -->$/ {
      print
      print ""
      name = names = $0
      sub(/^<!-- /, "", name)
      sub(/(: .*)? -->$/, "", name)
      if (!sub(/^[^:]*: /, "", names)) names = ""
      sub(/ -->$/, "", names)
      show(folder "/" name, names)
      skip = found = 1
    }
    /^<!-- end -->$/ { skip = 0 }
    !skip            { print }
    END              { exit found ? 0 : 1 }' "$1"
}

declare -A folder_of=([docs/which_solver.md]=26_to_each_its_own [docs/results/scenes_from_outside.md]=outside)  # of a page outside the chapters, the folder in renders/
for result in cheapest_settings choices_by_robust_errors detected_once effect_of_a_doubling errors_by_motion fastest_by_regime gain_of_half_steps large_frozen_problems settings_and_machine times_beside_other_engines \
  times_for_1_mm; do folder_of[docs/results/$result.md]=19_accuracy_and_time; done
for result in error_limits hard_cases time_for_1_mm with_equal_work; do folder_of[docs/results/methods_$result.md]=methods; done
while read -r page; do
  [[ ${folder_of[$page]:-} ]] || wrong "$page has a place for numbers, but readme_numbers.sh names no folder for it"
done < <(grep -lE '^<!-- [a-z_]+\.md(: .*)? -->$' docs/*.md docs/*/*.md)

for readme in chapters/[0-9][0-9]_*/README.md "${!folder_of[@]}"; do
  name=${folder_of[$readme]:-$(basename "$(dirname "$readme")")}
  numbers=renders/$name
  pages=("$readme")
  [[ $readme == docs/* ]] || pages=("${readme%/*}"/*.md)
  before=$failed
  for page in "${pages[@]}"; do
    wanted=$(filled "$page" "$numbers") || { [[ $page != "$readme" ]] || wrong "$page: no place for the numbers"; continue; }
    if [[ ${1:-} == --write ]]; then printf '%s\n' "$wanted" >"$page"
    elif ! printf '%s\n' "$wanted" | diff - "$page"; then
      wrong "$page differs from $numbers: run tests/project/readme_numbers.sh --write"
    fi
  done
  if [[ $readme == chapters/* ]]; then  # every line is on one of the pages
    for file in "$numbers"/numbers.md "$numbers"/difference*.md; do
      [[ -e $file ]] || continue
      missing=$(grep . "$file" | grep -vxFf <(cat "${pages[@]}") || true)
      [[ -z $missing ]] || wrong "$readme: no place for these lines of $file:"$'\n'"$missing"
    done
  fi
  ((failed > before)) || passed=$((passed + 1))
done
echo "$passed passed, $failed failed"
[[ $failed == 0 ]]
