#include "pushback/tools/classroom/compiler_words.h"

#include <fmt/format.h>

#include <functional>
#include <optional>
#include <regex>

#include "pushback/common/basics/files.h"
#include "pushback/common/basics/process.h"
#include "pushback/tools/classroom/brackets.h"
#include "pushback/tools/classroom/compiler_meanings.h"

namespace pushback {

namespace {

struct Error {
  bool in_students_file = false;
  std::size_t line = 0;  // of the student's file, from which it comes; 0: that is not said
  std::size_t column = 1;
  bool in_included = false;  // `line` has an #include, and the error shows in that header
  std::string said;
};

/// "/tmp/x/03.h:12:30: note: ..." or "In file included from /tmp/x/03.h:3:": the line, where it is one of this file.
std::size_t line_in(const std::string& message, const std::string& file) {
  const std::size_t at = message.find(file + ":");
  if (at == std::string::npos || (at > 0 && message[at - 1] != '/')) return 0;
  return std::strtoul(message.c_str() + at + file.size() + 1, nullptr, 10);
}

std::optional<Error> first_of(const std::vector<std::string>& messages, const std::string& file) {
  static const std::regex place("(.*?):([0-9]+)(?::([0-9]+))?: (?:fatal )?error: (.*)");
  std::smatch found;
  std::size_t included = 0, required = 0;  // lines of the student's file
  for (std::size_t i = 0; i < messages.size(); ++i) {
    const std::string& message = messages[i];
    if (message.find("In file included from ") != std::string::npos || message.find("                 from ") == 0)
      included = std::max(included, line_in(message, file));
    if (message.find("required from") != std::string::npos) required = std::max(required, line_in(message, file));
    if (message.find(": warning: ") != std::string::npos) included = required = 0;
    if (!std::regex_match(message, found, place)) continue;
    Error error{line_in(message, file) > 0, line_in(message, file), std::strtoul(found[3].str().c_str(), nullptr, 10),
                false, found[4]};
    if (error.in_students_file) return error;
    error.line = required > 0 ? required : included;
    error.in_included = required == 0 && included > 0;
    for (std::size_t j = i + 1; required == 0 && j < messages.size(); ++j) {  // clang++ says it afterwards
      if (std::regex_match(messages[j], place)) break;
      const bool from_here = messages[j].find("requested here") != std::string::npos ||
                             messages[j].find("required from") != std::string::npos;
      const std::size_t line = from_here ? line_in(messages[j], file) : 0;
      if (line == 0) continue;
      error.line = line;
      error.in_included = false;
    }
    return error;
  }
  return std::nullopt;
}

/// The last line before `before` that has code; 0: none has.
std::size_t last_code(const std::vector<std::string>& code, std::size_t before) {
  for (std::size_t line = std::min(before - 1, code.size()); line > 0; --line)
    if (code[line - 1].find_first_not_of(" \t\r") != std::string::npos) return line;
  return 0;
}

/// The first line that has this name.
std::size_t line_with(const std::vector<std::string>& code, const std::string& name) {
  const auto part_of_name = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_'; };
  for (std::size_t i = 0; i < code.size(); ++i)
    for (std::size_t at = code[i].find(name); at != std::string::npos; at = code[i].find(name, at + 1))
      if ((at == 0 || !part_of_name(code[i][at - 1])) &&
          (at + name.size() == code[i].size() || !part_of_name(code[i][at + name.size()])))
        return i + 1;
  return 0;
}

std::string undefined(const std::string& message, const std::vector<std::string>& code,
                      const std::function<std::string(std::size_t)>& at) {
  const std::string name = message.substr(message.find("undefined reference"));
  static const std::regex of_function(
      "undefined reference to [`']?(?:.*[ :])?([A-Za-z_~][A-Za-z0-9_]*)(?:\\[.*\\])?(?:\\(.*)?'?");
  std::smatch found;
  const std::size_t line = std::regex_match(name, found, of_function) ? line_with(code, found[1]) : 0;
  return at(line) +
         "something is declared but never defined: its { body } is missing, or the value of a variable. (The linker: " +
         name + ".)";
}

}  // namespace

std::string first_error(const std::string& messages, const std::filesystem::path& students_file) {
  const std::string text = read_text_file(students_file);
  const std::vector<std::string> lines = lines_of(text), code = lines_of(without_comments(text));
  const std::function at = [&](std::size_t line) {
    std::string words = "it does not compile. ";
    if (line >= 1) words += fmt::format("Line {}: ", line);
    if (line >= 1 && line <= lines.size()) words += fmt::format("\n\n    {}\n\n  ", lines[line - 1]);
    return words;
  };
  const std::vector<std::string> said = lines_of(messages);
  const std::optional<Error> error = first_of(said, students_file.filename());
  if (!error) {
    for (const std::string& message : said)
      if (message.find("undefined reference to") != std::string::npos) return undefined(message, code, at);
    return at(0) + "The compiler does not say where.";
  }

  static const std::regex of_syntax(
      "expected.*|unterminated.*|missing terminating.*|.*end of input.*|stray.*|invalid use of "
      "'::'.*|extraneous.*|.*not allowed here.*|.*unqualified-id.*|.*conditional.*");
  const std::string by_the_compiler = fmt::format(" (The compiler: {}.)", error->said);
  const std::optional<Unclosed> hole = unclosed(text);
  if (hole && (!error->in_students_file || hole->line <= error->line || std::regex_match(error->said, of_syntax)))
    return at(hole->line) + hole->words + by_the_compiler;
  static const std::regex of_line_before("expected (',' or ';'|';'|initializer) before.*");
  if (error->in_students_file && error->line <= code.size() && error->column > 0 &&
      code[error->line - 1].find_first_not_of(" \t") + 1 >= error->column &&
      std::regex_match(error->said, of_line_before))  // g++ names what comes next
    return at(last_code(code, error->line)) + "a semicolon is missing at the end of this line." + by_the_compiler;
  const std::string means = meaning_of(error->said);
  const std::string words =
      means.empty() ? fmt::format("the compiler says: {}.", error->said) : means + by_the_compiler;
  if (error->in_students_file) return at(error->line) + words;
  // What is not ended makes nonsense of what comes next: of a header that is included, or of our own lines behind the file.
  const bool not_ended = std::regex_match(error->said, of_syntax);
  if (not_ended && (error->in_included || error->line == 0))
    return at(last_code(code, error->line > 0 ? error->line : code.size() + 1)) +
           "a semicolon or a } is missing at the end of this line." + by_the_compiler;
  if (error->line > 0) return at(error->line) + words;
  const std::size_t answer = line_with(code, "answer");
  return at(answer > 0 ? answer : last_code(code, code.size() + 1)) + words;
}

}  // namespace pushback
