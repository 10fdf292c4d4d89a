/// Tables of results in Markdown.
#pragma once

#include <fmt/ranges.h>

#include <string>
#include <vector>

namespace pushback {

/// A row of Markdown.
inline std::string markdown_row(const std::vector<std::string>& cells) {
  return fmt::format("| {} |\n", fmt::join(cells, " | "));
}

/// The heads of a table's columns, and the rule below them.
inline std::string markdown_heads(const std::vector<std::string>& heads) {
  return markdown_row(heads) + markdown_row(std::vector<std::string>(heads.size(), "---"));
}

}  // namespace pushback
