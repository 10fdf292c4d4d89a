#!/usr/bin/env bash
# The bars of docs/results/time_of_each_phase.md, from what ./course bench phases -- --benchmark_format=csv prints; read from the
# standard input.
set -euo pipefail
awk -F, '
  function bar(t, full,  eighths, drawn) {  # `full`: what one block stands for
    eighths = int(8 * t / full + 0.5)
    drawn = ""
    while (eighths >= 8) { drawn = drawn "█"; eighths -= 8 }
    return drawn parts[eighths]
  }
  BEGIN {
    split("▏|▎|▍|▌|▋|▊|▉", parts, "|")
    split("detection, once|rows, once|normals, then friction, in each substep|the relaxing pass, in each substep|what contacts are told at the end|gravity, and moving the bodies, in each substep|all", names, "|")
    titles["pyramid_in_8_substeps"] = "pyramid of 210 boxes, 8 substeps"
    titles["pile_in_8_substeps"] = "pile of 4,000 boxes, 8 substeps"
    titles["stack_in_32_substeps"] = "stack of 40 boxes, 32 substeps"
    solvers["DetectedOnce"] = "21"; solvers["WideSolver<double>"] = "wide, double"; solvers["WideSolver<float>"] = "wide, float"
    columns = split("DetectedOnce|WideSolver<double>|WideSolver<float>", order, "|")
    count = split("pyramid_in_8_substeps|stack_in_32_substeps|pile_in_8_substeps", scenes, "|")
  }
  /^"[a-z]/ {  # its counters, sorted by their names, are the last eight fields
    gsub(/"/, "", $1)
    scene = $1; sub(/<.*/, "", scene)
    solver = $1; sub(/^[^<]*</, "", solver); sub(/>\/.*/, "", solver)
    for (phase = 1; phase <= 7; ++phase) took[scene, solver, phase] = $(NF - 8 + phase)
  }
  END {
    for (s = 1; s <= count; ++s)
      for (i = 1; i <= columns; ++i)
        if (!((scenes[s], order[i], 1) in took)) {
          print "phases_table.sh: nothing was measured of " scenes[s] "<" order[i] ">: all of them are needed" > "/dev/stderr"
          exit 1
        }
    for (s = 1; s <= count; ++s) {
      scene = scenes[s]
      full = 0
      for (phase = 1; phase < 7; ++phase)
        if (took[scene, "DetectedOnce", phase] / 50 > full) full = took[scene, "DetectedOnce", phase] / 50
      printf "%s: µs of a step\n", titles[scene]
      for (phase = 1; phase <= 7; ++phase) {
        printf "\n%s\n", names[phase]
        for (i = 1; i <= columns; ++i)
          printf phase < 7 ? "  %-12s %6.0f  %s\n" : "  %-12s %6.0f\n", solvers[order[i]], took[scene, order[i], phase],
                 bar(took[scene, order[i], phase], full)
      }
      if (s < count) printf "\n"
    }
  }'
