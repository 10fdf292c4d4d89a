/// Reads numbers with units from a command line.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "pushback/common/basics/input.h"

namespace pushback {

/// Reads "1mm", "0.5 cm" or "2 ms". `units`: the size of each unit. Throws InvalidInput, which names `option` and the units, if the
/// text is not a number above 0 with one of them.
inline Real number_with_unit(const std::string& option, const std::string& text,
                             const std::map<std::string, Real>& units) {
  std::size_t read = 0;
  double number = 0;
  try {
    number = std::stod(text, &read);
  } catch (const std::exception&) {
    read = 0;
  }
  std::string unit = text.substr(read);
  unit.erase(0, unit.find_first_not_of(' ') == std::string::npos ? unit.size() : unit.find_first_not_of(' '));
  const auto found = units.find(unit);
  if (read == 0 || found == units.end() || !(number > 0) || !std::isfinite(number)) {
    std::vector<std::string> names;
    for (const auto& [name, size] : units) names.push_back(name);
    throw InvalidInput(fmt::format("{} is '{}': a number above 0 with a unit is needed, one of {}", option, text,
                                   fmt::join(names, ", ")));
  }
  return static_cast<Real>(number) * found->second;
}

}  // namespace pushback
