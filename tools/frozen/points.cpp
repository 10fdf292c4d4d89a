#include "pushback/tools/frozen/points.h"

#include <fmt/format.h>

#include <sstream>

#include "pushback/common/basics/input.h"

namespace pushback::frozen {

namespace {

/// Where it is in the list; at its end, if it is new.
template <class List, class Is>
std::size_t place_in(List& list, const Is& is, typename List::value_type fresh) {
  const auto found = std::find_if(list.begin(), list.end(), is);
  const auto place = static_cast<std::size_t>(found - list.begin());
  if (found == list.end()) list.push_back(std::move(fresh));
  return place;
}

}  // namespace

FrozenPoints read_frozen_csv(const std::string& text) {
  FrozenPoints all;
  std::istringstream in(text);
  std::string line;
  if (!std::getline(in, line) || line != csv_heading)
    throw InvalidInput(fmt::format("the first line is '{}': '{}' is needed", line, csv_heading));
  while (std::getline(in, line)) {
    std::istringstream fields(line);
    std::string name, contacts, method, row_solves;
    std::getline(fields, name, ',');
    std::getline(fields, contacts, ',');
    std::getline(fields, method, ',');
    FrozenPoint point;
    char comma = 0;
    fields >> point.sweeps >> comma;
    std::getline(fields, row_solves, ',');
    fields >> point.systems >> comma >> point.residual >> comma >> point.seconds >> comma >> point.lower_quartile >>
        comma >> point.upper_quartile;
    const auto is_count = [](const std::string& word) {
      return !word.empty() && word.find_first_not_of("0123456789") == std::string::npos;
    };
    if (!fields || method.empty() || !is_count(contacts) || contacts.size() > 9 ||
        !(row_solves == "-" || is_count(row_solves)))
      throw InvalidInput(fmt::format("'{}' is not a line of frozen.csv", line));
    if (row_solves != "-") point.row_solves = std::stod(row_solves);
    const std::size_t m = place_in(all.methods, [&](const std::string& other) { return other == method; }, method);
    const std::size_t p = place_in(all.problems, [&](const FrozenPoints::Problem& other) { return other.name == name; },
                                   {name, std::stoi(contacts), {}});
    std::vector<std::vector<FrozenPoint>>& of_method = all.problems[p].of_method;
    of_method.resize(std::max(of_method.size(), m + 1));
    of_method[m].push_back(point);
  }
  for (FrozenPoints::Problem& of : all.problems) of.of_method.resize(all.methods.size());
  return all;
}

}  // namespace pushback::frozen
