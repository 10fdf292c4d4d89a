/// Which bracket, string, comment or #if of a file is never closed, whatever a compiler makes of it.
#pragma once

#include <cstddef>
#include <optional>
#include <string>

namespace pushback {

struct Unclosed {
  std::size_t line;   ///< from 1 on: of what opens, or of a closing bracket that nothing has opened
  std::string words;  ///< "this ( is never closed", to go on from "Line 3: "
};

/// The first in the file. Of braces, the indentation of the closing ones tells which was forgotten.
std::optional<Unclosed> unclosed(const std::string& text);

/// As long as `text` and with its lines, but comments and what stands in quotes are spaces.
std::string without_comments(const std::string& text);

}  // namespace pushback
