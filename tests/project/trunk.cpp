/// The trunk of the course, and the branches that leave it: README.md lists them, and every other page agrees with this list.
#include <fmt/format.h>

#include <algorithm>

#include "tests/project/links.h"

namespace {

constexpr const char* overview = "../../README.md#the-trunk";
constexpr int minutes_before = 30;  // docs/before_you_start.md
constexpr int session = 90;         // minutes, as in docs/teaching.md
/// Words of a page outside folds, code, tables and equations.
constexpr std::size_t most_words = 1100;
constexpr int most_changed_lines = 70;  // against the loop of the trunk page before

std::string text_of_page(const std::string& file) {
  return text_of(fs::path(SOURCE_DIR) / file);
}

struct TrunkPage {
  std::string title, file;
  int minutes;
  std::vector<std::string> branches;  ///< files
  std::string name() const { return title.substr(0, title.find(' ')); }
};

/// The table of README.md.
std::vector<TrunkPage> trunk() {
  static const std::regex row(R"(\| (\d+) \| \[([^\]]+)\]\(([^)]+)\) \| (\d+) \| (.*)\|)");
  std::vector<TrunkPage> pages;
  for (const std::string& line : lines_of(text_of_page("README.md"))) {
    std::smatch found;
    if (!std::regex_match(line, found, row)) continue;
    pages.push_back({found[2], found[3], std::stoi(found[4]), targets_in(found[5])});
    REQUIRE(std::stoul(found[1]) == pages.size());
  }
  return pages;
}

/// Files of all pages of the chapters, in the order in which they are read.
std::vector<std::string> pages_of_chapters() {
  std::vector<std::string> files;
  for (const fs::path& page : pages_in(fs::path(SOURCE_DIR) / "chapters")) {
    const fs::path file = fs::relative(page, SOURCE_DIR);
    if (std::distance(file.begin(), file.end()) == 3) files.push_back(file.generic_string());
  }
  std::ranges::sort(files, {}, [](const std::string& file) {
    const fs::path path(file);
    return std::tuple(path.parent_path(), path.filename() != "README.md", path.filename());
  });
  return files;
}

std::string from(const std::string& page, const std::string& target) {
  return fs::relative(target, fs::path(page).parent_path()).generic_string();
}

/// Without each part from `begin` to `end`, both included.
std::string without(const std::string& text, const std::string& begin, const std::string& end) {
  std::string rest;
  std::size_t at = 0;
  for (std::size_t open = text.find(begin); open != std::string::npos; open = text.find(begin, at)) {
    rest += text.substr(at, open - at);
    const std::size_t to = text.find(end, open + begin.size());
    at = to == std::string::npos ? text.size() : to + end.size();
  }
  return rest + text.substr(at);
}

/// Of what one reads without opening a fold: no code, no table, no equation, no description of a picture, no address.
std::size_t words_of(std::string text) {
  for (const auto& [begin, end] :
       {std::pair("<details>", "</details>"), std::pair("```", "```"), std::pair("<!--", "-->"), std::pair("$$", "$$"),
        std::pair("![", "]"), std::pair("](", ")")})
    text = without(text, begin, end);
  std::size_t words = 0;
  for (const std::string& line : lines_of(text)) {
    if (line.starts_with("|") || line.starts_with("    ")) continue;
    std::istringstream in(line);
    for (std::string word; in >> word;)
      words += std::ranges::any_of(word, [](unsigned char c) { return std::isalnum(c) != 0; });
  }
  return words;
}

std::string in_one_line(const std::string& text) {
  std::istringstream in(text);
  std::string line;
  for (std::string word; in >> word;) line += (line.empty() ? "" : " ") + word;
  return line;
}

}  // namespace

TEST_CASE("the trunk and its branches are all pages of the chapters, once each, in their order") {
  const std::vector<TrunkPage> pages = trunk();
  REQUIRE(pages.size() == 13);
  std::vector<std::string> files, all;
  for (const TrunkPage& page : pages) {
    INFO(page.file);
    CHECK(lines_of(text_of_page(page.file)).front() == "# " + page.title);
    files.push_back(page.file);
    all.push_back(page.file);
    all.insert(all.end(), page.branches.begin(), page.branches.end());
  }
  const std::vector<std::string> chapters = pages_of_chapters();
  const auto place = [&](const std::string& file) { return std::ranges::find(chapters, file); };
  CHECK(std::ranges::is_sorted(files, {}, place));
  std::ranges::sort(all, {}, place);
  CHECK(all == chapters);
}

TEST_CASE("each page of a chapter says at its head where it is, and leads on at its foot") {
  const std::vector<TrunkPage> pages = trunk();
  const std::vector<std::string> chapters = pages_of_chapters();
  for (std::size_t i = 0; i < chapters.size(); ++i) {
    const std::string& file = chapters[i];
    INFO(file);
    const auto of_trunk = [&](const TrunkPage& page) {
      return page.file == file || std::ranges::find(page.branches, file) != page.branches.end();
    };
    const auto page = std::ranges::find_if(pages, of_trunk);
    REQUIRE(page != pages.end());
    const auto next = page + 1;
    const std::string place = page->file == file ? fmt::format("Trunk, {} of {}", next - pages.begin(), pages.size())
                                                 : "Branch of " + page->name().substr(0, 2);
    std::vector<std::string> targets;
    if (i > 0) targets.push_back(from(file, chapters[i - 1]));
    targets.push_back(from(file, i + 1 < chapters.size() ? chapters[i + 1] : "README.md"));
    targets.push_back(next == pages.end() ? overview : from(file, next->file));
    const std::string on = next == pages.end() ? "The trunk and its branches" : "Next on the trunk → " + next->title;

    const std::vector<std::string> lines = lines_of(text_of_page(file));
    REQUIRE(lines.size() > 3);
    CHECK(lines[2] == fmt::format("[{}]({})", place, overview));
    CHECK(targets_in(lines.back()) == targets);
    CHECK(lines.back().ends_with(fmt::format("**[{}]({})**", on, targets.back())));
  }
}

TEST_CASE("a page of the trunk is as short as README.md says") {
  CHECK(
      contains(in_one_line(text_of_page("README.md")),
               fmt::format("A page of the trunk has at most {},{:03} words outside folds, code, tables and equations.",
                           most_words / 1000, most_words % 1000)));
  const std::vector<TrunkPage> pages = trunk();
  for (const TrunkPage& page : pages) {
    const std::size_t words = words_of(text_of_page(page.file));
    UNSCOPED_INFO(page.file << ": " << words << " words");
    CHECK(words <= most_words);
  }
}

TEST_CASE("README.md counts the lines of chapter 08's plain loop") {
  const std::string loop = "chapters/08_friction_cone/flat.cpp";
  const std::string link = fmt::format("[the whole solver in {} lines]({})", lines_of(text_of_page(loop)).size(), loop);
  INFO(link);
  CHECK(contains(in_one_line(text_of_page("README.md")), link));
}

TEST_CASE("from page to page of the trunk, few lines of the plain loop change") {
  std::string before;  // the loop of the page before
  int compared = 0;
  for (const TrunkPage& page : trunk()) {
    const std::string text = text_of_page(page.file);
    static const std::regex against(R"(\(([a-z_]+\.cpp)\), against \[[^\]]*\]\(([^)]+)\))");
    std::smatch found;
    if (std::regex_search(text, found, against)) {
      INFO(page.file);
      const fs::path folder = fs::path(page.file).parent_path();
      CHECK((folder / found[2].str()).lexically_normal().generic_string() == before);
      int changed = 0;
      bool inside = false;
      for (const std::string& line : lines_of(text)) {
        inside = line == "```diff" || (inside && line != "```");
        changed += inside && (line.starts_with("+") || line.starts_with("-"));
      }
      CHECK((changed > 0 && changed <= most_changed_lines));
      before = (folder / found[1].str()).generic_string();
      ++compared;
    } else if (fs::exists(fs::path(SOURCE_DIR) / fs::path(page.file).parent_path() / "flat.cpp")) {
      before = (fs::path(page.file).parent_path() / "flat.cpp").generic_string();  // 01: nothing comes before
    }
  }
  CHECK(compared == 11);
}

TEST_CASE("all pages that tell the trunk tell the same pages, minutes and hours") {
  const std::vector<TrunkPage> pages = trunk();
  std::vector<std::string> names;
  int minutes = minutes_before;
  std::string list;
  for (const TrunkPage& page : pages) {
    const bool last = &page == &pages.back();
    list += fmt::format("{}{} ({})", names.empty() ? "" : last ? " and " : ", ", page.name(), page.minutes);
    names.push_back(page.name());
    minutes += page.minutes;
  }
  const std::string hours = fmt::format("{:.3g} hours", minutes / 60.0);
  for (const std::string file : {"README.md", "docs/before_you_start.md", "docs/teaching.md"}) {
    INFO(file << ": " << list << ", " << hours);
    const std::string text = in_one_line(text_of_page(file));
    CHECK((file == "README.md" || contains(text, list)));
    CHECK(contains(text, fmt::format("{} pages", pages.size())));
    CHECK(contains(text, fmt::format("{} minutes", minutes_before)));
    CHECK(contains(text, hours));
  }

  // docs/teaching.md gives a row of twelve weeks one or more pages, and a week a session.
  static const std::regex row(R"(\| \S+ \| (\d+) \| ([^|]*) \|.*)"), name(R"(\b\d\d[ab]?\b)");
  std::vector<std::string> taught;
  std::map<int, int> of_week{{1, minutes_before}};
  for (const std::string& line : lines_of(text_of_page("docs/teaching.md"))) {
    std::smatch found;
    if (taught.size() == pages.size() || !std::regex_match(line, found, row)) continue;
    const std::string cell = found[2];
    for (std::sregex_iterator at(cell.begin(), cell.end(), name), end; at != end; ++at) {
      taught.push_back(at->str());
      const auto page = std::ranges::find(pages, taught.back(), &TrunkPage::name);
      if (page != pages.end()) of_week[std::stoi(found[1])] += page->minutes;
    }
  }
  CHECK(taught == names);
  for (const auto& [week, sum] : of_week) {
    INFO("week " << week << " of twelve");
    CHECK(sum == session);
  }
}
