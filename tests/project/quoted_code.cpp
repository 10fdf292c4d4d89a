/// Code that a page quotes stands in a source file: of the project, or of its tests, which compile the answers to exercises.
#include <algorithm>
#include <regex>

#include "tests/project/links.h"

namespace {

std::string without_space(std::string text) {
  std::erase_if(text, [](unsigned char c) { return std::isspace(c) != 0; });
  return text;
}

/// What stands in the page's fences that begin with ```cpp, up to each empty line, without blanks and ends of lines.
std::vector<std::string> quoted_in(const std::string& page) {
  std::vector<std::string> quoted;
  bool inside = false;
  for (const std::string& line : lines_of(page)) {
    const std::string plain = without_space(line);
    if (inside && plain != "```" && !plain.empty()) quoted.back() += plain;
    inside = plain == "```cpp" || (inside && plain != "```");
    if (inside && (plain == "```cpp" || plain.empty())) quoted.emplace_back();
  }
  return quoted;
}

}  // namespace

TEST_CASE("what a page quotes as code stands in a source file") {
  std::vector<std::string> sources;
  for (const std::string folder : {"chapters", "common", "docs", "engine", "tests", "tools"}) {
    for (const auto& entry : fs::recursive_directory_iterator(fs::path(SOURCE_DIR) / folder)) {
      if (entry.path().extension() == ".h" || entry.path().extension() == ".cpp")
        sources.push_back(without_space(text_of(entry.path())));
    }
  }
  std::size_t parts = 0;
  for (const fs::path& page : pages_in(SOURCE_DIR)) {
    for (const std::string& code : quoted_in(text_of(page))) {
      INFO(page << ": " << code);
      CHECK(std::any_of(sources.begin(), sources.end(),
                        [&](const std::string& source) { return contains(source, code); }));
      ++parts;
    }
  }
  CHECK(parts > 50);
}

TEST_CASE("a line of a source file that a page names has the function that the page says") {
  const std::regex link(R"(\[`(?:\w+::)?(\w+)`\]\(([^)]+)\), line (\d+))");
  int links = 0;
  for (const fs::path& page : pages_in(SOURCE_DIR)) {
    const std::string text = text_of(page);
    for (std::sregex_iterator at(text.begin(), text.end(), link), none; at != none; ++at, ++links) {
      const std::vector<std::string> lines = lines_of(text_of(page.parent_path() / (*at)[2].str()));
      const std::size_t line = std::stoul((*at)[3]);
      INFO(page << ": " << at->str());
      REQUIRE((line > 0 && line <= lines.size()));
      CHECK(contains(lines[line - 1], (*at)[1].str() + "("));
    }
  }
  CHECK(links >= 9);
}
