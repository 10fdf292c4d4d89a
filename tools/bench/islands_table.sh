#!/usr/bin/env bash
# The table of docs/speed.md, "Each island its own step", from what ./course bench islands -- --benchmark_format=csv prints; read from
# the standard input.
set -euo pipefail
echo '| scene | one method | each island its own | its own / one | in flight | by half steps |'
echo '| --- | --- | --- | --- | --- | --- |'
awk -F, '
  function us(t) { return t < 10 ? sprintf("%.2f", t) : sprintf("%.1f", t) }
  /^"scene\// {  # its counters, sorted by their names, are the last five fields
    split($1, name, "/")
    printf "| %s | %s | %s | %.2f | %.0f %% | %.0f %% |\n", name[2], us($(NF - 4)), us($(NF - 3)), $(NF - 2), 100 * $(NF - 1), 100 * $NF
  }'
