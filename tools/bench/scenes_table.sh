#!/usr/bin/env bash
# The tables of docs/results/time_of_each_scene.md and time_of_each_island_its_own_step.md, from what ./course bench scenes --
# --benchmark_filter=^scene/ (or ^islands/) --benchmark_format=csv prints; read from the standard input.
set -euo pipefail
awk -F, '
  function us(t) { return t < 10 ? sprintf("%.2f", t) : sprintf("%.1f", t) }
  function heads(line) { if (!begun++) { print line; print "| --- | --- | --- | --- | --- | --- |" } }
  /^"(scene|islands)\// { split($1, name, "/") }  # its counters, sorted by their names, are the last five fields
  /^"scene\// {
    heads("| scene | everything | what is called for | and sleep | called for / everything | and sleep / everything |")
    printf "| %s | %s | %s | %s | %.2f | %.2f |\n", name[2], us($(NF - 4)), us($(NF - 3)), us($(NF - 2)), $(NF - 1), $NF
  }
  /^"islands\// {
    heads("| scene | one method | each island its own | its own / one | in flight | by half steps |")
    printf "| %s | %s | %s | %.2f | %.0f %% | %.0f %% |\n", name[2], us($(NF - 4)), us($(NF - 3)), $(NF - 2), 100 * $(NF - 1), 100 * $NF
  }'
