/// Tables of results in Markdown.
#pragma once

#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace pushback {

/// A row of Markdown.
inline std::string markdown_row(const std::vector<std::string>& cells) {
  return fmt::format("| {} |\n", fmt::join(cells, " | "));
}

/// The headings of a table's columns, and the line below them.
inline std::string markdown_heads(const std::vector<std::string>& heads) {
  return markdown_row(heads) + markdown_row(std::vector<std::string>(heads.size(), "---"));
}

/// A number above 0 with two digits, or with all digits before the point, without an exponent.
inline std::string two_digits(double value) {
  return fmt::format("{:.{}f}", value, std::max(0, 1 - static_cast<int>(std::floor(std::log10(value)))));
}

}  // namespace pushback
