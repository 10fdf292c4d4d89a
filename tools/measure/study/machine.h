/// Where, of what and under what load was measured: without these a time says nothing.
#pragma once

#include <chrono>

#include "pushback/tools/measure/results/origin.h"
#include "pushback/tools/measure/study/rounds.h"

namespace pushback::study {

/// Of /proc/loadavg: how many programs wanted to run, in the mean of the last 1, 5 and 15 minutes. "unknown" where it is not there.
std::string load_now();

/// What is told of a run that is over.
struct MachineReport {
  std::string load_before, load_after;
  std::chrono::duration<double> took;
  std::vector<std::string> versions;  ///< of the engines, in their order
  int resumed = 0;                    ///< motions that were measured before, by a run that was ended
};

/// Markdown: the machine and the engines, and how many settings of each were tried.
std::string table_of_machine(const MachineReport& run, const std::vector<Engine>& engines, const AllMeasured& all);

}  // namespace pushback::study
