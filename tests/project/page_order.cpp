/// Each page of a chapter: its parts in one order, and no more words than are read in some minutes.
#include <algorithm>
#include <cstring>
#include <regex>
#include <sstream>

#include "pushback/common/experiment/sheet.h"
#include "tests/support/call.h"

/// The root of the sources, as seen from the working directory of the tests.
#ifndef SOURCE_DIR
#define SOURCE_DIR "."
#endif

namespace {

bool in_section(const std::string& line, std::initializer_list<const char*> names) {
  return std::any_of(names.begin(), names.end(), [&](const char* name) { return line == std::string("## ") + name; });
}

/// Words of prose that a reader meets who unfolds nothing: without tables, code, display formulas, pictures and comments.
/// `all`: also of the sections that one works through, what to build, to run, to solve. A formula in a line is one word.
std::size_t words_of_main_path(const std::string& page, bool all = false) {
  static const std::regex mark("<!--[^>]*-->");
  std::size_t words = 0, folded = 0;
  bool code = false, formula = false, later = false, inside_picture = false;
  for (std::string line : lines_of(std::regex_replace(page, mark, ""))) {
    if (line.starts_with("```")) code = !code;
    if (code || line.starts_with("```")) continue;
    if (line.starts_with("## ")) later = !all && in_section(line, {"Build it", "Run it", "Exercises", "Sources"});
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
    if (line.starts_with("![") || line.find(". ![") == 1) inside_picture = true;
    if (inside_picture) {
      inside_picture = !line.ends_with(")");
      continue;
    }
    if (line.starts_with("|")) continue;
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

std::size_t tables_of_main_path(const std::string& page) {
  std::size_t tables = 0, folded = 0;
  for (const std::string& line : lines_of(page)) {
    folded += contains(line, "<details>");
    if (contains(line, "</details>")) --folded;
    tables += folded == 0 && line.starts_with("| ---");
  }
  return tables;
}

}  // namespace

TEST_CASE("words of the main path: prose that nobody has to unfold, and no more") {
  CHECK(words_of_main_path("# A title\n\ntwo words\n") == 4);
  CHECK(words_of_main_path("one $a + b$ two, - three\n") == 4);
  CHECK(words_of_main_path("one\n```cpp\nint i;\n```\ntwo\n| a | b |\n<!-- no.md -->\n") == 2);
  CHECK(words_of_main_path("it rises <!-- set: scene=\"a b\"\n at=\"1\" -->to 2 m<!-- /set -->.\n") == 5);
  CHECK(words_of_main_path("one\n$$a = b$$\ntwo\n$$a\n= b$$\nthree\n") == 3);
  CHECK(words_of_main_path("$$a =\n b ,$$\n\nwhere b\n") == 2);
  CHECK(words_of_main_path("one\n<details><summary>S</summary>\nno no\n</details>\ntwo\n") == 2);
  CHECK(words_of_main_path("![a b\nc d](e.png)\none\n") == 1);
  CHECK(words_of_main_path("1. ![a b](e.png)\n2. ![c d](f.png)\none\n") == 1);
  CHECK(words_of_main_path("one\n## Exercises\nno no\n## What it costs\nthree\n") == 5);
  CHECK(words_of_main_path("one\n## Exercises\nno no\n## What it costs\nthree\n", true) == 8);
  CHECK(tables_of_main_path("| a |\n| --- |\n\n<details>\n| a |\n| --- |\n</details>\n") == 1);
}

namespace {

const std::string first_readings = "12_z";  // up to here, a page is written for who has read no contact solver

std::vector<std::string> all_chapters() {
  std::vector<std::string> all;
  for (const auto& entry : fs::directory_iterator(fs::path(SOURCE_DIR) / "chapters"))
    if (entry.is_directory()) all.push_back(entry.path().filename().string());
  std::sort(all.begin(), all.end());
  REQUIRE(all.size() > 1);
  return all;
}

}  // namespace

TEST_CASE(
    "the main path of a chapter's page has at most 1,200 words, up to chapter 12 1,000 with all that one works "
    "through") {
  for (const std::string& chapter : all_chapters()) {
    INFO(chapter);
    const std::string page = text_of(fs::path(SOURCE_DIR) / "chapters" / chapter / "README.md");
    CHECK(words_of_main_path(page) <= 1200);
    CHECK(words_of_main_path(page) > 300);  // or the page is not what this reads it as
    if (chapter > first_readings) continue;
    CHECK(words_of_main_path(page, true) <= 1000);
    CHECK(tables_of_main_path(page) <= 2);
    CHECK(contains(page.substr(0, page.find("## Your guess")), "/start.png)"));
  }
}

namespace {

/// A table of numbers.md: its scene, and the names of its variants, with and without their sweeps.
struct Table {
  std::string scene;
  std::vector<std::string> variants;
};

std::vector<Table> tables_of(const std::string& numbers) {
  std::vector<Table> tables;
  bool heading = true;
  for (const std::string& line : lines_of(numbers)) {
    if (!line.starts_with("| ")) {
      heading = true;
    } else if (!line.starts_with("| ---")) {
      const std::string cell = line.substr(2, line.find(" |") - 2);
      if (heading) tables.push_back({cell, {}});
      else tables.back().variants.push_back(cell.substr(cell.find(' ') + 1));
      heading = false;
    }
  }
  return tables;
}

/// What the answer of a guess has to say of picture `place`, in small letters; of a variant with or without its sweeps.
std::string said_of(const Table& table, const std::vector<std::size_t>& among, std::size_t which, std::size_t place,
                    bool sweeps) {
  if (which >= among.size()) return "picture " + std::to_string(place) + " is the start";
  if (among[which] >= table.variants.size()) return "no such variant";
  std::string name = table.variants[among[which]];
  if (!sweeps) name = std::regex_replace(name, std::regex(", \\d+ sweeps?$"), "");
  return "*" + name + "* is picture " + std::to_string(place);
}

std::string in_a_line(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return std::regex_replace(text, std::regex("\\s+"), " ");
}

}  // namespace

TEST_CASE("a guess among pictures: the page shows all of them, and its answer names the variant of each") {
  std::size_t asked = 0;
  for (const std::string& chapter : all_chapters()) {
    INFO(chapter);
    const fs::path root = SOURCE_DIR;
    const std::string source = text_of(root / "chapters" / chapter / "main.cpp");
    std::smatch found;
    if (!std::regex_search(source, found, std::regex(R"(Guess\{\{([\d, ]+)\}(, true)?\})"))) continue;
    ++asked;
    std::vector<std::size_t> among;
    std::istringstream places(found[1]);
    for (std::string place; std::getline(places, place, ',');) among.push_back(std::stoul(place));
    const std::size_t count = among.size() + found[2].matched;
    const std::string page =
        std::regex_replace(text_of(root / "chapters" / chapter / "README.md"), std::regex("<!--[^>]*-->"), "");
    const std::size_t begin = page.find("## Your guess"), answer = page.find("<details>", begin);
    for (std::size_t place = 1; place <= count; ++place) {
      const std::string name = "renders/" + chapter + "/guess_" + std::to_string(place) + ".png";
      const std::size_t at = page.find(std::to_string(place) + ". ![", begin);
      CHECK(at < answer);
      CHECK(page.find("](../../" + name + ")", at) < answer);
      CHECK(fs::exists(root / name));
    }
    CHECK_FALSE(fs::exists(root / "renders" / chapter / ("guess_" + std::to_string(count + 1) + ".png")));
    const std::string said = in_a_line(page.substr(answer, page.find("</details>", answer) - answer));
    const std::vector<Table> tables = tables_of(text_of(root / "renders" / chapter / "numbers.md"));
    CHECK(std::any_of(tables.begin(), tables.end(), [&](const Table& table) {
      const std::vector<std::size_t> order = pushback::guess_order(table.scene, count);
      for (std::size_t place = 0; place < count; ++place) {
        const auto says = [&](bool sweeps) {
          return contains(said, in_a_line(said_of(table, among, order[place], place + 1, sweeps)));
        };
        if (!says(true) && !says(false)) return false;
      }
      return true;
    }));
  }
  CHECK(asked >= 12);
}

TEST_CASE("a page asks the question that stands on its sheet") {
  for (const std::string& chapter : all_chapters()) {
    INFO(chapter);
    const fs::path folder = fs::path(SOURCE_DIR) / "chapters" / chapter;
    const std::string source = text_of(folder / "main.cpp"), name = "\"" + chapter + "\", \"";
    const auto begin = source.find(name) + name.size();
    const std::string title = source.substr(begin, source.find('"', begin) - begin);
    std::string question = lines_of(text_of(folder / "README.md")).at(2);
    for (const auto& [formula, words] : {std::pair{"$JV = 0$", "J V = 0"}})
      if (const auto at = question.find(formula); at != std::string::npos)
        question.replace(at, std::strlen(formula), words);
    CHECK(question == "**" + title + "**");
  }
}

TEST_CASE(
    "a chapter's page has its headings in the order of all, and says what to build where it has a loop to compare "
    "with") {
  const std::vector<std::string> all{"## Your guess",
                                     "## The sheet",
                                     "## The numbers",
                                     "## The idea",
                                     "## The equation",
                                     "## Build it",
                                     "## The difference in code",
                                     "## Why it works",
                                     "## What it costs",
                                     "## What can go wrong",
                                     "## Run it",
                                     "## Exercises",
                                     "## Sources"};
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
