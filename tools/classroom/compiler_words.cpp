#include "pushback/tools/classroom/compiler_words.h"

#include <fmt/format.h>

#include "pushback/common/basics/files.h"
#include "pushback/common/basics/process.h"

namespace pushback {

namespace {

/// "/tmp/x/03.h:12:30: error: ..." or "In file included from /tmp/x/03.h:3:": the line, if it is one of this file.
std::size_t line_in(const std::string& message, const std::string& file) {
  const std::size_t at = message.find(file + ":");
  if (at == std::string::npos || (at > 0 && message[at - 1] != '/')) return 0;
  return std::strtoul(message.c_str() + at + file.size() + 1, nullptr, 10);
}

/// "expected ';' before '}' token"; empty: this is no error.
std::string error_in(const std::string& message) {
  constexpr std::string_view error = "error: ", undefined = "undefined reference to";
  if (const std::size_t at = message.find(error); at != std::string::npos) return message.substr(at + error.size());
  if (const std::size_t at = message.find(undefined); at != std::string::npos)
    return message.substr(at) + ", which is declared but never defined";
  return "";
}

}  // namespace

std::string first_error(const std::string& messages, const std::filesystem::path& students_file) {
  const std::vector<std::string> lines = lines_of(read_text_file(students_file));
  std::size_t line = 0;  // of the student's file
  std::string said;      // the first error, which may show in what the file includes or instantiates
  bool in_the_file = false;
  for (const std::string& message : lines_of(messages)) {
    const std::size_t here = line_in(message, students_file.filename());
    const std::string error = error_in(message);
    in_the_file = here > 0 && !error.empty();
    if (in_the_file || said.empty()) said = error;
    if (in_the_file || line == 0) line = here;
    if (in_the_file) break;
  }
  if (said.empty()) return "it does not compile. The compiler does not say why.";
  const std::string words = fmt::format("the compiler says: {}.", said);
  if (line == 0 || line > lines.size()) return "it does not compile: " + words;
  return fmt::format("it does not compile. Line {}: \n\n    {}\n\n  {}", line, lines[line - 1], words);
}

}  // namespace pushback
