#include "pushback/tools/classroom/brackets.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <string_view>
#include <vector>

namespace pushback {

namespace {

std::size_t line_of(std::string_view text, std::size_t at) {
  return 1 + static_cast<std::size_t>(std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(at), '\n'));
}

struct Scanned {
  std::string code;  // with spaces in the place of comments and of what stands in quotes
  std::optional<Unclosed> problem;
};

Scanned scan(const std::string& text) {
  Scanned scanned{text, {}};
  const auto blank = [&](std::size_t from, std::size_t to) {
    for (std::size_t i = from; i < std::min(to, text.size()); ++i)
      if (text[i] != '\n') scanned.code[i] = ' ';
  };
  const auto problem = [&](std::size_t at, const char* words) {
    if (!scanned.problem) scanned.problem = Unclosed{line_of(text, at), words};
  };
  for (std::size_t i = 0; i < text.size(); ++i) {
    const std::string_view rest = std::string_view(text).substr(i);
    std::size_t end = 0;
    if (rest.starts_with("//")) {
      end = std::min(text.find('\n', i), text.size());
    } else if (rest.starts_with("/*")) {
      end = text.find("*/", i + 2);
      if (end == std::string::npos) problem(i, "this comment is never closed: each /* needs a */.");
      end = end == std::string::npos ? text.size() : end + 2;
    } else if (rest.starts_with("R\"(")) {
      end = text.find(")\"", i);
      end = end == std::string::npos ? text.size() : end + 2;
    } else if (text[i] == '"' ||
               (text[i] == '\'' && (i == 0 || !std::isalnum(static_cast<unsigned char>(text[i - 1]))))) {
      end = i + 1;
      while (end < text.size() && text[end] != text[i] && text[end] != '\n') end += text[end] == '\\' ? 2 : 1;
      if (end >= text.size() || text[end] == '\n')
        problem(i, text[i] == '"' ? "this text is never closed: each \" needs another one, in the same line."
                                  : "this letter is never closed: each ' needs another one, in the same line.");
      else ++end;
    } else {
      continue;
    }
    blank(i, end);
    i = end - 1;
  }
  return scanned;
}

/// #if and #endif.
std::optional<Unclosed> unclosed_if(const std::string& code) {
  std::vector<std::size_t> open;
  std::size_t number = 0;
  for (std::size_t at = 0; at < code.size(); at = std::min(code.find('\n', at), code.size()) + 1) {
    ++number;
    std::string_view line = std::string_view(code).substr(at, code.find('\n', at) - at);
    line.remove_prefix(std::min(line.find_first_not_of(" \t"), line.size()));
    if (!line.starts_with('#')) continue;
    line.remove_prefix(1);
    line.remove_prefix(std::min(line.find_first_not_of(" \t"), line.size()));
    if (line.starts_with("if")) open.push_back(number);
    if (!line.starts_with("endif")) continue;
    if (open.empty()) return Unclosed{number, "this #endif has no #if above."};
    open.pop_back();
  }
  if (open.empty()) return std::nullopt;
  return Unclosed{open.back(), "this #if is never closed: each #if needs an #endif."};
}

char opening(char closing) {
  return closing == ')' ? '(' : closing == ']' ? '[' : '{';
}

struct Bracket {
  char what;
  std::size_t line, indentation;  // of its line
  int semicolons;                 // that may stand in it
};

/// A `for` has two, an `if` may have one.
int semicolons_in(std::string_view before, char bracket) {
  if (bracket == '{') return std::numeric_limits<int>::max();
  before = before.substr(0, before.find_last_not_of(" \t\n") + 1);
  if (bracket == '(' && before.ends_with("for")) return 2;
  return bracket == '(' && (before.ends_with("if") || before.ends_with("switch")) ? 1 : 0;
}

std::optional<Unclosed> unclosed_bracket(const std::string& code) {
  const auto never_closed = [](const Bracket& open) {
    const char closes = open.what == '(' ? ')' : open.what == '[' ? ']' : '}';
    return Unclosed{open.line,
                    fmt::format("this {} is never closed: each {} needs a {}.", open.what, open.what, closes)};
  };
  std::vector<Bracket> open;
  std::optional<Unclosed> suspicious;  // a brace whose } stands where that of an outer one belongs
  std::optional<Unclosed> too_many;    // a } that stands further in than the line of its {
  std::size_t line = 1, indentation = 0;
  bool first_of_line = true;
  const auto closes_nothing = [&](char c) {
    return Unclosed{line, fmt::format("this {} closes nothing: there is no {} for it.", c, opening(c))};
  };
  for (std::size_t i = 0; i < code.size(); ++i) {
    const char c = code[i];
    if (c == '\n') {
      ++line;
      indentation = 0;
      first_of_line = true;
      continue;
    }
    if (first_of_line && (c == ' ' || c == '\t')) {
      ++indentation;
      continue;
    }
    const bool first = first_of_line;
    first_of_line = false;
    if (c == '(' || c == '[' || c == '{')
      open.push_back({c, line, indentation, semicolons_in(std::string_view(code).substr(0, i), c)});
    if (c == ';' && !open.empty() && open.back().semicolons-- == 0) return never_closed(open.back());
    if (c != ')' && c != ']' && c != '}') continue;
    if (open.empty()) return too_many ? too_many : closes_nothing(c);
    if (open.back().what != opening(c)) {
      const bool one_further_out =
          std::any_of(open.begin(), open.end(), [&](const Bracket& one) { return one.what == opening(c); });
      return one_further_out ? never_closed(open.back()) : closes_nothing(c);
    }
    if (c == '}' && first && indentation < open.back().indentation && !suspicious)
      suspicious = never_closed(open.back());
    if (c == '}' && first && indentation > open.back().indentation && !too_many) too_many = closes_nothing(c);
    open.pop_back();
  }
  if (open.empty()) return std::nullopt;
  return suspicious ? suspicious : never_closed(open.back());
}

}  // namespace

std::optional<Unclosed> unclosed(const std::string& text) {
  const Scanned scanned = scan(text);
  if (scanned.problem) return scanned.problem;
  if (const auto found = unclosed_if(scanned.code)) return found;
  return unclosed_bracket(scanned.code);
}

std::string without_comments(const std::string& text) {
  return scan(text).code;
}

}  // namespace pushback
