/// On which machine, and under what load, times are measured.
#pragma once

#include <string>

namespace pushback {

/// Of /proc/cpuinfo, and how many of them: "AMD EPYC 7B12, 2 cores".
std::string processor();
/// Of /proc/loadavg: how many programs wanted to run, in the mean of the last 1, 5 and 15 minutes. "unknown" where it is not there.
std::string load_now();

}  // namespace pushback
