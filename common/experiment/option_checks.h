/// What CLI11 lets through and no program can use: "-1" as 2^64 - 1, "nan" within any range, an empty word.
#pragma once

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <charconv>
#include <cstdlib>
#include <limits>
#include <string>
#include <type_traits>

namespace pushback {

template <class Number>
std::string range_text(Number least, Number most) {
  if constexpr (std::is_floating_point_v<Number>)
    if (least == std::numeric_limits<Number>::lowest() && most == std::numeric_limits<Number>::max())
      return "a finite number is needed";
  return fmt::format("a {}number from {} to {} is needed", std::is_integral_v<Number> ? "whole " : "", least, most);
}

/// A finite number between the ends; both ends are allowed.
template <class Number>
CLI::Validator number_check(Number least, Number most) {
  const auto check = [least, most](std::string& word) -> std::string {
    Number number{};
    const char *const begin = word.data(), *const end = begin + word.size();
    bool read = false;
    if constexpr (std::is_integral_v<Number>) {
      const auto [stopped, error] = std::from_chars(begin, end, number);
      read = error == std::errc() && stopped == end;
    } else {
      char* stopped = nullptr;
      number = static_cast<Number>(std::strtod(begin, &stopped));
      read = !word.empty() && stopped == end;
    }
    if (!read || !(number >= least && number <= most))
      return fmt::format("'{}' is not allowed: {}", word, range_text(least, most));
    if constexpr (std::is_integral_v<Number>) word = fmt::format("{}", number);  // CLI11 reads 010 as eight
    return {};
  };
  const bool any = least == std::numeric_limits<Number>::lowest() && most == std::numeric_limits<Number>::max();
  return CLI::Validator(check, any ? "" : fmt::format("{}..{}", least, most), "number");
}

template <class Number>
CLI::Validator number_check() {
  return number_check(std::numeric_limits<Number>::lowest(), std::numeric_limits<Number>::max());
}

/// Throws CLI::ValidationError at an empty word, and at an empty place in a list: CLI11 would skip both.
inline void refuse_empty_words(const CLI::App& app, int argc, const char* const* argv) {
  const CLI::Option* option = nullptr;  // that takes the next word
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    std::string value = word;
    if (word.starts_with('-')) {
      const std::size_t equals = word.find('=');
      if (const CLI::Option* const named = app.get_option_no_throw(word.substr(0, equals))) {
        option = named->get_items_expected_max() > 0 ? named : nullptr;
        if (equals == std::string::npos) continue;
        value = word.substr(equals + 1);
      }
    }
    const std::string name = option == nullptr ? "an argument" : option->get_name();
    if (value.empty()) throw CLI::ValidationError(name, "'' is not allowed: a value is needed");
    if (option == nullptr) continue;
    if (option->get_delimiter() == ',' &&
        (value.starts_with(',') || value.ends_with(',') || value.find(",,") != std::string::npos))
      throw CLI::ValidationError(name,
                                 fmt::format("'{}' is not allowed: a value between any two commas is needed", value));
    if (option->get_items_expected_max() == 1) option = nullptr;
  }
}

}  // namespace pushback
