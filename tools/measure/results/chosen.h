/// Of cases, stages, motions and problems, those that are asked for.
#pragma once

#include "pushback/common/basics/named.h"
#include "pushback/common/basics/shard.h"

namespace pushback {

/// Those that the words ask for, in their own order: by the whole name, or else by a part of it. All, without words. Throws InvalidInput,
/// naming all there are, where a word fits none.
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
    named(kind, all, word);  // refuses it
  }
  std::vector<Named> list;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (wanted[i]) list.push_back(all[i]);
  }
  return list;
}

/// Those of a part, in turn. Throws InvalidInput where a part would have none. `kinds`: "motions".
template <class Any>
std::vector<Any> of_part(const std::string& kinds, std::vector<Any> all, const Shard& shard) {
  if (shard.of > all.size())
    throw InvalidInput(fmt::format("--shard is '{}/{}': there are {} {}, and each part needs one", shard.part, shard.of,
                                   all.size(), kinds));
  std::size_t index = 0;
  std::erase_if(all, [&](const Any&) { return !shard.has(index++); });
  return all;
}

}  // namespace pushback
