/// Comma-separated values, the format of results.
#pragma once

#include <charconv>
#include <string>
#include <vector>

#include "pushback/common/basics/input.h"

namespace pushback {

/// A field, in quotes if it needs them.
std::string csv_field(const std::string& text);

/// The fields of each line, without their quotes.
std::vector<std::vector<std::string>> csv_fields(const std::string& text);

/// Converts a whole word to a number. Throws InvalidInput if it is not a number.
template <class Number>
Number csv_number(const std::string& word) {
  Number number = 0;
  const auto [end, problem] = std::from_chars(word.data(), word.data() + word.size(), number);
  if (word.empty() || problem != std::errc() || end != word.data() + word.size())
    throw InvalidInput(fmt::format("there is '{}' where a number is needed", word));
  return number;
}

/// Calls read(fields) for each line after the heading. Throws InvalidInput, with the line, if the heading or the number of fields
/// differs, or if `read` throws it.
template <class Read>
void read_csv_lines(const std::string& text, const std::string& heading, const Read& read) {
  const std::string first = text.substr(0, text.find('\n'));
  if (first != heading) throw InvalidInput(fmt::format("the first line is '{}': '{}' is needed", first, heading));
  const std::size_t count = csv_fields(heading).front().size();
  for (std::size_t begin = first.size() + 1; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    const std::string line = text.substr(begin, end - begin);
    begin = end + 1;
    const std::vector<std::vector<std::string>> fields = csv_fields(line);
    const auto refuse = [&](const std::string& why) {
      throw InvalidInput(fmt::format("'{}' is not a line of {}: {}", line, heading, why));
    };
    if (fields.empty() || fields.front().size() != count) refuse(fmt::format("{} fields are needed", count));
    try {
      read(fields.front());
    } catch (const InvalidInput& problem) {
      refuse(problem.what());
    }
  }
}

}  // namespace pushback
