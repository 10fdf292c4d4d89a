#!/usr/bin/env bash
# Counts habits that make pages hard to read, and fails if a page has more than `limit` of them in 1,000 words, or the comments of all
# headers more than `most_in_comments`. It helps the writer: a line that is right as it stands ends with <!-- plain -->.
#   tests/project/plain_english.sh [--list] [PAGE...]     all pages and headers by default; --list: each hit, with its line
set -euo pipefail
cd "$(dirname "$0")/../.."

limit=12
most_in_comments=60
list=""
if [[ ${1:-} == --list ]]; then list=1 && shift; fi
pages=("$@")
((${#pages[@]})) || mapfile -t pages < <(git ls-files --cached --others --exclude-standard -- '*.md' ':!renders' ':!docs/results' \
  ':!CHANGELOG.md' 'common/*.h' 'engine/*.h' 'chapters/*.h')

awk -v list="$list" -v limit="$limit" -v most_in_comments="$most_in_comments" '
  BEGIN {
    habit["a fronted Of"] = "(^|[.!?] )Of [a-z]"
    habit["who without a noun"] = "(^|[.!?] )Who [a-z]+s |(^| )([Ff]or|by|of|to) who "
    habit["anew"] = "(^| )anew[ .,;]"
    habit["nobody, somebody"] = "([Nn]o|[Ss]ome)body[ .,;]"
    habit["that of, those of"] = "(^| )(that|those) of "
    habit["asks for, wants"] = "(row|contact|joint|solver|scene)s? (asks?|asked|wants?|wanted)( |$)"
    habit["a clause after a colon"] = "[a-z)]: [a-z][a-z]+ [a-z]+ [a-z]+ [a-z]"
    habit["a semicolon"] = "[a-z0-9)]; [a-z]"
    habit[", and no"] = ", and no(thing)? "
    habit["is of"] = " (is|are|was|were) of [a-z]"
    habit["beside"] = "(^| )beside "
    habit["what as a noun"] = "(^|[.:;,] )[Ww]hat (is|has|was|moves|rests|falls|slides|touches|stands|carries|bounces|they|it|a|the) "
    habit["takes the place"] = "takes? the place of"
  }
  function hits_in(line, skipped,   name, rest, found) {
    for (name in habit) {
      rest = line
      while (name !~ skipped && match(rest, habit[name])) {
        ++found
        if (FILENAME !~ /\.h$/) ++count[name]
        if (list) printf "%s:%d: %s: …%s…\n", FILENAME, FNR, name, substr(rest, RSTART, 60)
        rest = substr(rest, RSTART + RLENGTH)
      }
    }
    return found
  }
  function end_page(   rate) {
    if (page == "") return
    rate = words ? 1000 * hits / words : 0
    if (words >= 100 && rate > limit) {
      printf "%s: %d in %d words, %.1f in 1,000; at most %d\n", page, hits, words, rate, limit
      failed = 1
    }
    all_hits += hits
    all_words += words
  }
  FNR == 1 { end_page(); page = FILENAME; hits = words = 0; code = math = 0 }
  FILENAME ~ /\.h$/ {
    if (!match($0, /(^|[ \t])\/\/\/?<? /)) next
    behind_code = index(substr($0, RSTART, RLENGTH), "<")  # where a colon or a semicolon separates a unit from a definition
    line = substr($0, RSTART + RLENGTH)
    gsub(/`[^`]*`:?/, "x", line)
    in_comments += hits_in(line, behind_code ? "colon" : "^$")
    next
  }
  /^```/ { code = !code; next }
  /^\$\$/ && !/\$\$.*\$\$/ { math = !math; next }
  code || /^\|/ || /^    / || /^#/ || /^\$\$/ { next }
  math { if (/\$\$/) math = 0; next }
  /<!-- plain -->/ { next }
  {
    line = $0
    gsub(/<!--[^>]*-->/, "", line)
    gsub(/!\[[^]]*\]\([^)]*\)/, "", line)
    gsub(/\]\([^)]*\)/, "]", line)
    gsub(/`[^`]*`/, "x", line)
    gsub(/\$[^$]*\$/, "x", line)
    words += split(line, word, /[ \t]+/)
    hits += hits_in(line, "^$")
  }
  END {
    end_page()
    for (name in count) printf "%5d  %s\n", count[name], name | "sort -rn"
    close("sort -rn")
    if (all_words) printf "%d in %d words, %.1f in 1,000\n", all_hits, all_words, 1000 * all_hits / all_words
    if (in_comments > most_in_comments) failed = 1
    if (in_comments) printf "%d in the comments of headers; at most %d\n", in_comments, most_in_comments
    exit failed
  }' "${pages[@]}"
