#!/usr/bin/env bash
# The table of floors of docs/speed.md, "Where the time goes", from what ./course bench floors -- --benchmark_format=csv prints; read
# from the standard input.
set -euo pipefail
echo '| pass | numbers | measured, µs | least by its operations | least by its bytes | measured / the larger of both |'
echo '| --- | --- | --- | --- | --- | --- |'
awk -F, '
  /^"[a-z]+\// {  # its counters, sorted by their names, are the last seven fields
    gsub(/"/, "", $1)
    split($1, name, "/")
    if ($(NF - 6) > 0) printf "| %s | %s | %.0f | %.0f | %.0f | %.1f |\n", name[1], name[2], $(NF - 6), $(NF - 5), $(NF - 4), $(NF - 3)
  }'
