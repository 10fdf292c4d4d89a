/// What is found by its name: a scene, a stage, a method.
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

/// The one of that name. Throws InvalidInput, naming all there are, where none has it. `kind`: "scene".
template <class List>
const auto& named(const std::string& kind, const List& all, std::string_view name) {
  for (const auto& one : all)
    if (one.name == name) return one;
  throw InvalidInput(fmt::format("{} is '{}': one of these is needed: {}", kind, name, fmt::join(names_of(all), ", ")));
}

}  // namespace pushback
