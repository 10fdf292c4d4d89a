#include "pushback/tools/measure/results/machine.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <thread>

namespace pushback {

std::string processor() {
  std::ifstream file("/proc/cpuinfo");
  std::string name = "unknown";
  for (std::string line; std::getline(file, line);) {
    if (!line.starts_with("model name")) continue;
    name = line.substr(std::min(line.size(), line.find(": ") + 2));
    break;
  }
  return fmt::format("{}, {} cores", name, std::thread::hardware_concurrency());
}

std::string load_now() {
  std::ifstream file("/proc/loadavg");
  std::string one, five, fifteen;
  return file >> one >> five >> fifteen ? fmt::format("{}, {}, {}", one, five, fifteen) : "unknown";
}

}  // namespace pushback
