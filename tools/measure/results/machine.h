/// The machine on which times are measured, and its load.
#pragma once

#include <string>

namespace pushback {

/// The processor in /proc/cpuinfo and its number of cores: "AMD EPYC 7B12, 2 cores".
std::string processor();
/// The mean numbers of runnable programs over the last 1, 5 and 15 minutes, from /proc/loadavg, or "unknown" if it does not exist.
std::string load_now();

}  // namespace pushback
