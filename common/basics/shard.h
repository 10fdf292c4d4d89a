/// One part of a long computation, so that several machines can share the work.
#pragma once

#include <charconv>
#include <sstream>
#include <string>
#include <vector>

#include "pushback/common/basics/input.h"

namespace pushback {

struct Shard {
  std::size_t part = 1, of = 1;
  /// Whether this part includes the item with this index. Parts take items in turn, so they take about equally long.
  bool has(std::size_t index) const { return index % of == part - 1; }
  bool whole() const { return of == 1; }
  std::string folder() const { return fmt::format("shard_{}_of_{}", part, of); }
};

/// Reads "2/5": part 2 of 5. Throws InvalidInput unless the text has this form with 1 <= part <= of.
inline Shard shard_of(const std::string& text) {
  Shard shard;
  const char* const end = text.data() + text.size();
  const auto part = std::from_chars(text.data(), end, shard.part);
  const bool slash = part.ec == std::errc{} && part.ptr != end && *part.ptr == '/';
  const auto of = slash ? std::from_chars(part.ptr + 1, end, shard.of) : part;
  if (!slash || of.ec != std::errc{} || of.ptr != end || shard.part < 1 || shard.part > shard.of)
    throw InvalidInput(fmt::format("--shard is '{}': a part and how many there are, 1/4 to 4/4, is needed", text));
  return shard;
}

/// Merges the CSV of all parts into the text that a single run would have written: the heading, then the lines of each item.
/// Successive lines with the same first `fields` fields belong to one item. The parts had the items in turn.
inline std::string joined(const std::vector<std::string>& parts, int fields = 1) {
  std::string heading;
  std::vector<std::vector<std::string>> things(parts.size());  // of each part
  for (std::size_t part = 0; part < parts.size(); ++part) {
    std::istringstream in(parts[part]);
    std::string line, before;
    std::getline(in, heading);
    while (std::getline(in, line)) {
      std::size_t end = line.find(',');
      for (int field = 1; field < fields; ++field) end = line.find(',', end + 1);
      const std::string name = line.substr(0, end);
      if (things[part].empty() || name != before) things[part].emplace_back();
      before = name;
      things[part].back() += line + "\n";
    }
  }
  std::string text = heading + "\n";
  for (std::size_t i = 0; i < things[0].size(); ++i)
    for (const auto& of_part : things)
      if (i < of_part.size()) text += of_part[i];
  return text;
}

}  // namespace pushback
