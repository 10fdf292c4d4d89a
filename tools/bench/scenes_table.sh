#!/usr/bin/env bash
# The table of docs/speed.md, "Each scene", from what ./course bench scenes -- --benchmark_filter=^scene/ --benchmark_format=csv
# prints; read from the standard input.
set -euo pipefail
echo '| scene | everything | what is called for | and sleep | called for / everything | and sleep / everything |'
echo '| --- | --- | --- | --- | --- | --- |'
awk -F, '
  function us(t) { return t < 10 ? sprintf("%.2f", t) : sprintf("%.1f", t) }
  /^"scene\// {  # its counters, sorted by their names, are the last five fields
    split($1, name, "/")
    printf "| %s | %s | %s | %s | %.2f | %.2f |\n", name[2], us($(NF - 4)), us($(NF - 3)), us($(NF - 2)), $(NF - 1), $NF
  }'
