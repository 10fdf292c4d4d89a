#include "pushback/common/experiment/parameter.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>
#include <cmath>

#include "pushback/common/basics/files.h"

namespace pushback {

std::string in_json(const std::vector<ParameterWithDefault>& parameters) {
  std::vector<std::string> objects;
  for (const auto& [parameter, defaults, whole, variable] : parameters) {
    objects.push_back(fmt::format(
        R"({{"flag": {}, "symbol": {}, "unit": {}, "what": {}, "default": [{}], "least": {}, "most": {}, "whole": {}}})",
        quoted(parameter.flag), quoted(parameter.symbol), quoted(parameter.unit), quoted(parameter.what),
        fmt::join(defaults, ", "), parameter.least, parameter.most, whole));
  }
  return fmt::format("[{}]", fmt::join(objects, ",\n "));
}

std::string spelled(double number) {
  static constexpr std::array below_twenty{
      "zero", "one",    "two",    "three",    "four",     "five",    "six",     "seven",     "eight",    "nine",
      "ten",  "eleven", "twelve", "thirteen", "fourteen", "fifteen", "sixteen", "seventeen", "eighteen", "nineteen"};
  static constexpr std::array tens{"twenty", "thirty", "forty", "fifty", "sixty", "seventy", "eighty", "ninety"};
  if (number == 100) return "a hundred";
  if (number == 1000) return "a thousand";
  if (number != std::floor(number) || number < 0 || number > 99) return fmt::format("{:g}", number);
  const auto whole = static_cast<std::size_t>(number);
  if (whole < 20) return below_twenty.at(whole);
  const std::string ten = tens.at(whole / 10 - 2);
  return whole % 10 == 0 ? ten : ten + "-" + below_twenty.at(whole % 10);
}

}  // namespace pushback
