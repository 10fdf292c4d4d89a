/// Chooses cases and stages by name.
#pragma once

#include "pushback/common/basics/named.h"

namespace pushback {

/// The items of `all` whose names match one of the words, in the order of `all`. A word matches a whole name, or otherwise a part of
/// names. Without words, all items match. Throws InvalidInput, listing all names, if a word matches none.
template <class Named>
std::vector<Named> chosen(const std::string& kind, const std::vector<Named>& all,
                          const std::vector<std::string>& words) {
  std::vector<bool> wanted(all.size(), words.empty());
  for (const std::string& word : words) {
    const auto mark = [&](auto&& fits) {
      bool any = false;
      for (std::size_t i = 0; i < all.size(); ++i) {
        if (fits(all[i].name)) wanted[i] = any = true;
      }
      return any;
    };
    if (mark([&](const std::string& name) { return name == word; })) continue;
    if (!word.empty() && mark([&](const std::string& name) { return name.find(word) != std::string::npos; })) continue;
    named(kind, all, word);  // throws
  }
  std::vector<Named> list;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (wanted[i]) list.push_back(all[i]);
  }
  return list;
}

}  // namespace pushback
