#include "pushback/tools/classroom/compiler_words.h"

#include <fmt/format.h>

#include <array>
#include <regex>

#include "pushback/common/basics/files.h"
#include "pushback/common/basics/process.h"

namespace pushback {

namespace {

struct Meaning {
  std::regex said;
  const char* means;  // $1, $2: what stands in the groups
};

const std::array meanings{
    Meaning{std::regex("expected '?;'?.*"), "a semicolon is missing, there or at the end of the line before."},
    Meaning{std::regex("expected '?\\}'?.*"), "a closing brace } is missing: each { needs one."},
    Meaning{std::regex("expected '?\\)'?.*"), "a closing bracket ) is missing."},
    Meaning{std::regex("expected unqualified-id.*|expected declaration.*|.*at block scope.*|a function-definition is "
                       "not allowed.*|function definition is not allowed.*"),
            "something stands where none can: often a brace { or } too many or too few above."},
    Meaning{std::regex("'answer' is not a member of 'student'.*|.*no member named 'answer' in namespace "
                       "'student'.*|.*'?student'? has not been declared.*|use of undeclared identifier 'student'"),
            "the last line of the file is missing, the one that says what your answer is. --reset shows it, in a new "
            "copy."},
    Meaning{std::regex("'([^']*)' was not declared in this scope.*|use of undeclared identifier '([^']*)'.*"),
            "nothing here has the name '$1$2'. Is it misspelt, or declared further below?"},
    Meaning{std::regex(".*'([^']*)' has no member named '([^']*)'.*"), "a $1 has nothing called '$2'. Is it misspelt?"},
    Meaning{std::regex("no member named '([^']*)' in '([^']*)'.*"), "a $2 has nothing called '$1'. Is it misspelt?"},
    Meaning{std::regex("([^: ]*): No such file or directory|'([^']*)' file not found"),
            "there is no file $1$2 here. A solution includes headers of Pushback and of the standard library, and "
            "nothing else."},
    Meaning{std::regex("no return statement.*|.*non-void function does not return.*"),
            "a function that should give a value back does not."},
    Meaning{std::regex("(no match for 'operator.*|invalid operands.*)"),
            "the two sides of this operator do not go together: a vector and a number, maybe?"},
    Meaning{std::regex("(cannot convert|could not convert|no viable conversion|no known conversion).*"),
            "a value of one kind stands where another kind is needed: a vector for a number, maybe?"},
    Meaning{std::regex("assignment of.*read-only.*|cannot assign to .*const.*"), "what is const cannot be changed."},
    Meaning{std::regex("redefinition of.*|redeclaration of.*"), "the same name is declared twice."},
};

}  // namespace

std::string first_error(const std::string& messages, const std::filesystem::path& students_file) {
  static const std::regex place("(.*?):([0-9]+):([0-9]+): (?:fatal )?error: (.*)");
  std::smatch found;
  for (const std::string& line : lines_of(messages)) {
    if (line.find("undefined reference to") != std::string::npos)
      return fmt::format("something is declared but never defined: {}", line.substr(line.find("undefined reference")));
    if (!std::regex_match(line, found, place)) continue;
    const std::string said = found[4];
    std::string text = "it does not compile. ";
    if (std::filesystem::path(found[1].str()).filename() == students_file.filename()) {
      const std::vector<std::string> lines = lines_of(read_text_file(students_file));
      const std::size_t number = std::stoul(found[2]);
      text += fmt::format("Line {}: ", number);
      if (number >= 1 && number <= lines.size()) text += fmt::format("\n\n    {}\n\n  ", lines[number - 1]);
    }
    for (const Meaning& meaning : meanings) {
      std::smatch parts;
      if (std::regex_match(said, parts, meaning.said))
        return text + parts.format(meaning.means) + fmt::format(" (The compiler: {}.)", said);
    }
    return text + fmt::format("the compiler says: {}.", said);
  }
  return "it does not compile, and the compiler does not say where.";
}

}  // namespace pushback
