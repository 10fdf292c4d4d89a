#include "pushback/tools/classroom/mine/lap.h"

#include <fmt/format.h>

#include <sstream>

#include "pushback/common/basics/process.h"

namespace pushback {

std::string line_of(const Lap& lap) {
  return fmt::format("lap {} {} {} {} {}", lap.ms_per_step, lap.overlap, lap.moved, lap.speed, lap.energy_gained);
}

std::optional<Lap> read_lap(const std::string& printed) {
  const std::vector<std::string> lines = lines_of(printed);
  if (lines.empty()) return {};
  std::istringstream words(lines.back());
  std::string first;
  Lap lap;
  words >> first >> lap.ms_per_step >> lap.overlap >> lap.moved >> lap.speed >> lap.energy_gained;
  if (!words || first != "lap") return {};
  return lap;
}

}  // namespace pushback
