/// Each page of a chapter: its parts in one order, and no more words than are read in some minutes.
#include <algorithm>

#include "tests/support/call.h"

/// The root of the sources, as seen from the working directory of the tests.
#ifndef SOURCE_DIR
#define SOURCE_DIR "."
#endif

namespace {

bool in_section(const std::string& line, std::initializer_list<const char*> names) {
  return std::any_of(names.begin(), names.end(), [&](const char* name) { return line == std::string("## ") + name; });
}

/// Words of prose that a reader meets who unfolds nothing: without tables, code, display formulas, pictures, comments, and
/// the sections that one works through: what to build, to run, to solve. A formula in a line is one word.
std::size_t words_of_main_path(const std::string& page) {
  std::size_t words = 0, folded = 0;
  bool code = false, formula = false, later = false, inside_picture = false;
  for (std::string line : lines_of(page)) {
    if (line.starts_with("```")) code = !code;
    if (code || line.starts_with("```")) continue;
    if (line.starts_with("## ")) later = in_section(line, {"Build it", "Run it", "Exercises", "Sources"});
    if (contains(line, "<details>")) ++folded;
    const bool was_folded = folded > 0;
    if (contains(line, "</details>")) --folded;
    if (was_folded || later) continue;
    if (line.starts_with("$$") || formula) {
      const auto last = line.find_last_of('$');
      const bool closes = last != std::string::npos && last > 1 && (formula || line.find("$$", 2) != std::string::npos);
      formula = !closes;
      continue;
    }
    if (line.starts_with("![")) inside_picture = true;
    if (inside_picture) {
      inside_picture = !line.ends_with(")");
      continue;
    }
    if (line.starts_with("|") || line.starts_with("<!--")) continue;
    bool word = false, in_formula = false;
    for (const char c : line + " ") {
      if (c == '$') in_formula = !in_formula;
      if (c == ' ' && !in_formula) {
        words += word;
        word = false;
      } else {
        word = word || std::isalnum(static_cast<unsigned char>(c)) || c == '$';
      }
    }
  }
  return words;
}

}  // namespace

TEST_CASE("words of the main path: prose that nobody has to unfold, and no more") {
  CHECK(words_of_main_path("# A title\n\ntwo words\n") == 4);
  CHECK(words_of_main_path("one $a + b$ two, - three\n") == 4);
  CHECK(words_of_main_path("one\n```cpp\nint i;\n```\ntwo\n| a | b |\n<!-- no.md -->\n") == 2);
  CHECK(words_of_main_path("one\n$$a = b$$\ntwo\n$$a\n= b$$\nthree\n") == 3);
  CHECK(words_of_main_path("$$a =\n b ,$$\n\nwhere b\n") == 2);
  CHECK(words_of_main_path("one\n<details><summary>S</summary>\nno no\n</details>\ntwo\n") == 2);
  CHECK(words_of_main_path("![a b\nc d](e.png)\none\n") == 1);
  CHECK(words_of_main_path("one\n## Exercises\nno no\n## What it costs\nthree\n") == 5);
}

namespace {

std::vector<std::string> all_chapters() {
  std::vector<std::string> all;
  for (const auto& entry : fs::directory_iterator(fs::path(SOURCE_DIR) / "chapters"))
    if (entry.is_directory()) all.push_back(entry.path().filename().string());
  std::sort(all.begin(), all.end());
  REQUIRE(all.size() > 1);
  return all;
}

}  // namespace

TEST_CASE("the main path of a chapter's page has at most 1,200 words") {
  for (const std::string& chapter : all_chapters()) {
    INFO(chapter);
    const std::size_t words = words_of_main_path(text_of(fs::path(SOURCE_DIR) / "chapters" / chapter / "README.md"));
    CHECK(words <= 1200);
    CHECK(words > 300);  // or the page is not what this reads it as
  }
}

TEST_CASE(
    "a chapter's page has its headings in the order of all, and says what to build where it has a loop to compare "
    "with") {
  const std::vector<std::string> all{
      "## Your guess", "## The idea",    "## The equation", "## Build it",      "## The difference in code",
      "## The sheet",  "## The numbers", "## Why it works", "## What it costs", "## What can go wrong",
      "## Run it",     "## Exercises",   "## Sources"};
  for (const std::string& chapter : all_chapters()) {
    INFO(chapter);
    std::vector<std::string> headings;
    bool code = false;
    for (const std::string& line : lines_of(text_of(fs::path(SOURCE_DIR) / "chapters" / chapter / "README.md"))) {
      if (line.starts_with("```")) code = !code;
      if (!code && line.starts_with("## ")) headings.push_back(line);
    }
    std::vector<std::string> order = all;
    const bool begins = chapter.starts_with("00");  // a solver of one's own, before there is a row
    if (!begins && !fs::exists(fs::path(SOURCE_DIR) / "chapters" / chapter / "flat.cpp"))
      std::erase(order, "## Build it");
    CHECK(headings == order);
  }
}
