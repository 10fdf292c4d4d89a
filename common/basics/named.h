/// Finds scenes, stages and methods by name.
#pragma once

#include <fmt/ranges.h>

#include <string>
#include <string_view>
#include <vector>

#include "pushback/common/basics/input.h"

namespace pushback {

template <class List>
std::vector<std::string> names_of(const List& all) {
  std::vector<std::string> names;
  for (const auto& one : all) names.emplace_back(one.name);
  return names;
}

/// The item with this name. Throws InvalidInput, listing all names, if there is none. `kind`: the word for an item, such as "scene".
template <class List>
const auto& named(const std::string& kind, const List& all, std::string_view name) {
  for (const auto& one : all)
    if (one.name == name) return one;
  throw InvalidInput(fmt::format("{} is '{}': one of these is needed: {}", kind, name, fmt::join(names_of(all), ", ")));
}

}  // namespace pushback
