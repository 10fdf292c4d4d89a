#include "pushback/tools/measure/frozen/points.h"

#include "pushback/tools/measure/results/csv.h"

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
  read_csv_lines(text, csv_heading, [&](const std::vector<std::string>& fields) {
    FrozenPoint point{.sweeps = csv_number<int>(fields[3]),
                      .systems = csv_number<int>(fields[5]),
                      .residual = csv_number<double>(fields[6]),
                      .seconds = csv_number<double>(fields[7]),
                      .lower_quartile = csv_number<double>(fields[8]),
                      .upper_quartile = csv_number<double>(fields[9])};
    if (fields[4] != "-") point.row_solves = csv_number<double>(fields[4]);
    const std::string &name = fields[0], &method = fields[2];
    if (method.empty()) throw InvalidInput("a method is needed");
    const std::size_t m = place_in(all.methods, [&](const std::string& other) { return other == method; }, method);
    const std::size_t p = place_in(all.problems, [&](const FrozenPoints::Problem& other) { return other.name == name; },
                                   {name, csv_number<int>(fields[1]), {}});
    std::vector<std::vector<FrozenPoint>>& of_method = all.problems[p].of_method;
    of_method.resize(std::max(of_method.size(), m + 1));
    of_method[m].push_back(point);
  });
  for (FrozenPoints::Problem& of : all.problems) of.of_method.resize(all.methods.size());
  return all;
}

}  // namespace pushback::frozen
