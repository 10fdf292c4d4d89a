/// One part of a long computation, so that several machines can share the work.
#pragma once

#include <charconv>
#include <string>

#include "pushback/common/basics/input.h"

namespace pushback {

struct Shard {
  std::size_t part = 1, of = 1;
  /// Whether this part includes the item with this index. Parts take items in turn, so they take about equally long.
  bool has(std::size_t index) const { return index % of == part - 1; }
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

}  // namespace pushback
