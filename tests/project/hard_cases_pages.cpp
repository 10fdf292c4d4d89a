/// What the pages say of the hard cases is what the committed table says.
///
/// A figure on a page is followed by a comment that names where it is from, and nobody sees:
///
///   449 mm<!-- stack-10; 07; drift -->        case; stage; criterion: words that one name alone contains, or the whole name
///   449 mm<!-- stack-10; 07; drift; as it is -->   not the largest of all starts, but of the scene as it is
///   30/30<!-- rubble; together; starts -->    how many of its starts pass
///   14 mm<!-- peers; slop; ODE; 10 mm -->     by another engine, of renders/hard_cases/peers.csv; the name of a setting is whole
///   17<!-- peers; passes; ODE tuned -->, or lacks: so many cases it passes, or has not all that they ask for
///   3<!-- peers; nobody -->, or ours, engine, both, nothing: the groups of passed_by
///   42<!-- passes; together -->, 3<!-- fails; together -->, 49<!-- cases -->, Forty-nine<!-- cases in words -->,
///   Six<!-- cases with joints in words -->, Eighteen<!-- motions in words -->: of the study
/// PUSHBACK_WRITE_FIGURES=1 in the environment writes the figures anew.
#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <limits>
#include <map>
#include <regex>

#include "pushback/common/experiment/parameter.h"
#include "pushback/tools/measure/hard_cases/peers.h"
#include "pushback/tools/measure/study/every_motion.h"
#include "tests/support/call.h"

using namespace pushback;

namespace {

const char* const table_file = "renders/hard_cases/table.csv";

struct TableLine {
  std::string of_case, stage, criterion, unit;
  Real limit;
  bool passes;
  std::string broken;
  Real number, largest;
  int starts_passed, starts;
};

const std::vector<TableLine>& written() {
  static const std::vector<TableLine> lines = [] {
    std::vector<TableLine> all;
    const std::vector<std::string> csv = lines_of(text_of(table_file));
    for (std::size_t i = 1; i < csv.size(); ++i) {
      const std::vector<std::string> f = fields_of(csv[i]);
      REQUIRE(f.size() == 11);
      all.push_back({f[0], f[1], f[2], f[3], static_cast<Real>(std::stod(f[4])), f[6] == "1", f[7],
                     static_cast<Real>(std::stod(f[5])), static_cast<Real>(std::stod(f[8])), std::stoi(f[9]),
                     std::stoi(f[10])});
    }
    return all;
  }();
  return lines;
}

int cells_of(const std::string& stage, bool that_pass) {
  std::map<std::string, bool> passed;
  for (const TableLine& line : written()) {
    if (line.stage != stage) continue;
    const bool good = line.passes && line.broken.empty();
    passed[line.of_case] = passed.contains(line.of_case) ? passed[line.of_case] && good : good;
  }
  return static_cast<int>(
      std::count_if(passed.begin(), passed.end(), [&](const auto& one) { return one.second == that_pass; }));
}

/// The name that is `word`, or the only one that has it in it; empty where there is not exactly one.
std::string name_with(const std::string& word, const std::vector<std::string>& names) {
  std::string found;
  for (const std::string& name : names) {
    if (name == word) return name;
    if (!contains(name, word)) continue;
    if (!found.empty() && found != name) return {};
    found = name;
  }
  return found;
}

std::string stage_with(const std::string& word) {
  std::vector<std::string> names;
  for (const Stage& stage : table_stages()) names.push_back(stage.name);
  return name_with(word, names);
}

std::string in_words(std::size_t count) {
  std::string words = spelled(static_cast<double>(count));
  words[0] = static_cast<char>(std::toupper(words[0]));
  return words;
}

const Table& beside_engines() {
  static const Table table = beside_peers(read_table_csv(text_of(table_file)),
                                          read_table_csv(text_of("renders/hard_cases/peers.csv"), peer_stages()));
  return table;
}

/// Of a mark that begins with "peers".
std::string figure_of_peers(const std::vector<std::string>& mark) {
  const Table& table = beside_engines();
  const auto column_of = [&](const std::string& name) {
    std::size_t column = table.chapters;
    while (column < table.stages.size() && table.stages[column].name != name) ++column;
    return column;
  };
  if (mark.size() == 2) {
    const std::vector<std::string> kinds{"nobody", "ours", "engine", "both", "nothing"};
    const auto kind = std::find(kinds.begin(), kinds.end(), mark[1]);
    return kind == kinds.end()
               ? ""
               : std::to_string(passed_by(table)[static_cast<std::size_t>(kind - kinds.begin())].size());
  }
  if (mark.size() == 3 && (mark[1] == "passes" || mark[1] == "lacks")) {
    const std::size_t column = column_of(mark[2]);
    if (column == table.stages.size()) return {};
    std::size_t count = 0;
    for (std::size_t row = 0; row < table.cases.size(); ++row)
      count += (mark[1] == "passes" ? table.passed(row, column) : !table.at(row, column).possible()) ? 1 : 0;
    return std::to_string(count);
  }
  for (std::size_t row = 0; mark.size() == 4 && row < table.cases.size(); ++row) {
    if (table.cases[row].name != mark[1]) continue;
    const std::size_t column = column_of(mark[2]);
    std::vector<std::string> criteria;
    for (const Criterion& criterion : table.cases[row].criteria) criteria.push_back(criterion.what);
    const auto i = std::find(criteria.begin(), criteria.end(), name_with(mark[3], criteria)) - criteria.begin();
    if (column == table.stages.size() || i == std::ssize(criteria)) return {};
    const Criterion& criterion = table.cases[row].criteria[static_cast<std::size_t>(i)];
    return in_short(table.at(row, column).largest[static_cast<std::size_t>(i)], criterion.limit, criterion.unit);
  }
  return {};
}

/// What should stand before the mark; empty where the mark names nothing.
std::string figure_of(const std::vector<std::string>& mark) {
  if (mark[0] == "peers") return figure_of_peers(mark);
  if (mark[0] == "cases") return std::to_string(hard_cases().size());
  if (mark[0] == "cases in words") return in_words(hard_cases().size());
  if (mark[0] == "motions in words") return in_words(every_motion().size());
  if (mark[0] == "cases with joints in words")
    return in_words(static_cast<std::size_t>(std::ranges::count_if(hard_cases(), [](const HardCase& hard_case) {
      World world;
      hard_case.scene.fill(world);
      return !world.joints.empty();
    })));
  const std::string stage = mark.size() > 1 ? stage_with(mark[1]) : "";
  if (stage.empty()) return {};
  if (mark[0] == "passes" || mark[0] == "fails") return std::to_string(cells_of(stage, mark[0] == "passes"));
  std::vector<std::string> criteria;
  for (const TableLine& line : written()) {
    if (line.of_case == mark[0] && line.stage == stage) criteria.push_back(line.criterion);
  }
  for (const TableLine& line : written()) {
    if (line.of_case != mark[0] || line.stage != stage || mark.size() < 3) continue;
    if (mark[2] == "starts") return std::to_string(line.starts_passed) + "/" + std::to_string(line.starts);
    if (line.criterion != name_with(mark[2], criteria)) continue;
    if (mark.size() == 3) return in_short(line.largest, line.limit, line.unit);
    if (mark[3] == "as it is") return in_short(line.number, line.limit, line.unit);
  }
  return {};
}

std::vector<std::string> parts_of(const std::string& mark) {
  std::vector<std::string> parts;
  std::istringstream in(mark);
  for (std::string part; std::getline(in, part, ';');) {
    const std::size_t begin = part.find_first_not_of(" \n"), end = part.find_last_not_of(" \n");
    parts.push_back(begin == std::string::npos ? "" : part.substr(begin, end + 1 - begin));
  }
  return parts;
}

bool ends_with(std::string text, std::string end) {
  const auto blank = [](std::string& s) { std::replace(s.begin(), s.end(), '\n', ' '); };
  blank(text);
  blank(end);
  if (text.size() < end.size() || text.compare(text.size() - end.size(), end.size(), end) != 0) return false;
  const char before = text.size() > end.size() ? text[text.size() - end.size() - 1] : ' ';
  return std::isdigit(static_cast<unsigned char>(before)) == 0 && before != '.' && before != '-';
}

/// Where the figure, or the word, begins that ends at `end`.
std::size_t start_of_figure(const std::string& text, std::size_t end, bool word) {
  const auto is_part = [&](unsigned char c) {
    return word ? std::isalpha(c) != 0 || c == '-'
                : std::isdigit(c) != 0 || c == '.' || c == '/' || c == '-' || c >= 0x80;
  };
  for (const std::string unit : {"mm/s", "m/s", "mm", "m", "mJ", "J", "%", "degrees"}) {
    const std::size_t size = unit.size() + 1;
    if (word || end < size || text.compare(end - unit.size(), unit.size(), unit) != 0) continue;
    if (text[end - size] != ' ' && text[end - size] != '\n') continue;
    end -= size;
    break;
  }
  while (end > 0 && is_part(static_cast<unsigned char>(text[end - 1]))) --end;
  return end;
}

std::vector<fs::path> pages() {
  std::vector<fs::path> all{"README.md"};
  for (const auto& entry : fs::directory_iterator("docs")) {
    if (entry.path().extension() == ".md") all.push_back(entry.path());
  }
  for (const auto& entry : fs::directory_iterator("chapters")) {
    if (fs::exists(entry.path() / "README.md")) all.push_back(entry.path() / "README.md");
  }
  return all;
}

}  // namespace

TEST_CASE("the committed table has every case under every stage, with the criteria, limits and starts of today") {
  std::size_t line = 0;
  for (const HardCase& hard_case : hard_cases()) {
    for (const Stage& stage : table_stages()) {
      for (const Criterion& criterion : hard_case.criteria) {
        REQUIRE(line < written().size());
        const TableLine& there = written()[line++];
        INFO(hard_case.name << " " << stage.name);
        REQUIRE(there.of_case == hard_case.name);
        REQUIRE(there.stage == stage.name);
        CHECK(there.criterion == criterion.what);
        CHECK(there.limit == criterion.limit);
        CHECK(there.unit == criterion.unit);
        CHECK(there.starts == std::min(hard_case.starts, stage.most_starts));
        CHECK(there.passes == (there.largest <= there.limit));
      }
    }
  }
  CHECK(line == written().size());
}

TEST_CASE("every figure on a page that names its cell of the table is that cell's") {
  static const std::regex comment("<!--([^>]*)-->");
  const bool write = std::getenv("PUSHBACK_WRITE_FIGURES") != nullptr;
  std::map<std::string, int> seen;
  for (const fs::path& page : pages()) {
    const std::string text = text_of(page);
    std::string renewed;
    std::size_t copied = 0;
    for (std::sregex_iterator mark(text.begin(), text.end(), comment), end; mark != end; ++mark) {
      if ((*mark)[1].str().rfind(" live: ", 0) == 0) continue;  // a picture of the book
      const std::vector<std::string> parts = parts_of((*mark)[1]);
      if (parts.size() == 1 && parts[0] != "cases" && !parts[0].ends_with("in words"))
        continue;  // of a generated table
      const std::string figure = figure_of(parts);
      const auto at = static_cast<std::size_t>(mark->position());
      INFO(page << ": " << text.substr(at > 60 ? at - 60 : 0, std::min<std::size_t>(at, 60)) << (*mark)[0] << " is "
                << figure);
      CHECK_FALSE(figure.empty());
      if (!write) CHECK(ends_with(text.substr(0, at), figure));
      const std::size_t begin = start_of_figure(text, at, parts[0].ends_with("in words"));
      renewed += text.substr(copied, begin - copied) + figure;
      copied = at;
      ++seen[parts[0]];
    }
    if (write && copied > 0) std::ofstream(page, std::ios::binary) << renewed << text.substr(copied);
  }
  for (const char* words : {"cases in words", "cases with joints in words", "motions in words"})
    CHECK(seen[words] >= 1);
  CHECK(seen["passes"] >= 1);
  CHECK(seen["fails"] >= 1);
  for (const HardCase& hard_case : hard_cases()) {
    INFO(hard_case.name);
    CHECK(contains(text_of("docs/hard_cases.md"), "`" + hard_case.name + "`"));
  }
}
