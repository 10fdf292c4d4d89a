/// What the pages say of the hard cases is what the committed table says, and times of the study are those of its table.
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
///   38.3<!-- study; chain; by-island/1/1 -->  µs for 1/60 s of a motion, in the study's table, renders/19_accuracy_and_time/study.csv:
///                                             the median of its plays by that setting; mm with "; error" behind it
///   7,801<!-- study; settings; ours -->       so many settings of ours, or of others, are in that table
///   0.27<!-- cell; next; 1 mm; 1,015 -->      a number in a table that a program has written: its file in renders/, without a folder of
///                                             chapter 19; a column; words that only that row, with its table's first head, has; #2 at the end: the cell's second
/// PUSHBACK_WRITE_FIGURES=1 in the environment writes the figures anew.
#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <map>
#include <regex>

#include "pushback/common/basics/named.h"
#include "pushback/common/experiment/parameter.h"
#include "pushback/tools/measure/hard_cases/peers.h"
#include "pushback/tools/measure/results/markdown.h"
#include "pushback/tools/measure/study/every_motion.h"
#include "pushback/tools/measure/study/rounds.h"
#include "tests/support/call.h"

using namespace pushback;

namespace {

const Table& ours() {
  static const Table table = read_table_csv(text_of("renders/hard_cases/table.csv"));
  return table;
}

const Table& beside_engines() {
  static const Table table =
      beside_peers(ours(), read_table_csv(text_of("renders/hard_cases/peers.csv"), peer_stages()));
  return table;
}

/// Without the spaces around them.
std::vector<std::string> parts_of(const std::string& mark, char between = ';') {
  std::vector<std::string> parts;
  std::istringstream in(mark);
  for (std::string part; std::getline(in, part, between);) {
    const std::size_t begin = part.find_first_not_of(" \n"), end = part.find_last_not_of(" \n");
    parts.push_back(begin == std::string::npos ? "" : part.substr(begin, end + 1 - begin));
  }
  return parts;
}

/// Where the name is that is `word`, or the only one that has it in it; behind the last where there is not exactly one.
std::size_t place_of(const std::string& word, const std::vector<std::string>& names) {
  std::vector<std::size_t> places;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (names[i] == word) return i;
    if (contains(names[i], word)) places.push_back(i);
  }
  return places.size() == 1 ? places[0] : names.size();
}

std::string in_words(std::size_t count) {
  std::string words = spelled(static_cast<double>(count));
  words[0] = static_cast<char>(std::toupper(words[0]));
  return words;
}

/// Of a mark without "peers": a case, a stage, a criterion, and sometimes "as it is"; or a count, and a stage. Empty where it names
/// nothing.
std::string figure_in(const Table& table, const std::vector<std::string>& mark) {
  const std::size_t column = mark.size() < 2 ? table.stages.size() : place_of(mark[1], names_of(table.stages));
  if (column == table.stages.size()) return {};
  const auto count = [&](const auto& of) {
    std::size_t sum = 0;
    for (std::size_t row = 0; row < table.cases.size(); ++row) sum += of(row) ? 1 : 0;
    return std::to_string(sum);
  };
  if (mark[0] == "passes") return std::to_string(table.passes(column));
  if (mark[0] == "fails") return std::to_string(table.cases.size() - table.passes(column));
  if (mark[0] == "lacks") return count([&](std::size_t row) { return !table.at(row, column).possible(); });
  const std::vector<std::string> cases = names_of(table.cases);
  const auto row = static_cast<std::size_t>(std::ranges::find(cases, mark[0]) - cases.begin());
  if (row == cases.size() || mark.size() < 3) return {};
  const Outcome& outcome = table.at(row, column);
  if (mark[2] == "starts") return fmt::format("{}/{}", outcome.starts_passed, outcome.starts);
  std::vector<std::string> criteria;
  for (const Criterion& criterion : table.cases[row].criteria) criteria.push_back(criterion.what);
  const std::size_t i = place_of(mark[2], criteria);
  if (i == criteria.size() || (mark.size() == 4 && mark[3] != "as it is")) return {};
  const Criterion& criterion = table.cases[row].criteria[i];
  return in_short((mark.size() == 4 ? outcome.numbers : outcome.largest)[i], criterion.limit, criterion.unit);
}

/// Of "study", a motion and a setting, and sometimes "error"; or "settings" and whose.
std::string figure_of_study(const std::vector<std::string>& mark) {
  static const study::AllMeasured all = study::read_csv(text_of("renders/19_accuracy_and_time/study.csv"));
  if (mark.size() < 3) return {};
  std::size_t settings = 0;
  for (const auto& [motion, measured] : all)
    for (const study::Measured& one : measured) {
      settings += (study::engines_named({one.engine})[0].maker == study::ours) == (mark[2] == "ours") ? 1 : 0;
      if (motion != mark[1] || one.engine == "motion_float" || one.setting() != mark[2]) continue;
      if (mark.size() == 4) return mark[3] == "error" ? two_digits(1000 * one.error) : "";
      const double microseconds = 1e6 * one.median() / any_motion_named(motion).frames();
      return microseconds < 999.5 ? fmt::format("{:.3g}", microseconds) : fmt::format("{:.0f}", microseconds);
    }
  return mark[1] == "settings" ? fmt::format("{},{:03}", settings / 1000, settings % 1000) : "";
}

/// Of "cell", a file, a column, words of a row, and sometimes which number it is.
std::string figure_of_cell(std::vector<std::string> mark) {
  std::ptrdiff_t which = 0;
  if (mark.back().starts_with('#')) {
    which = std::stoi(mark.back().substr(1)) - 1;
    mark.pop_back();
  }
  if (mark.size() < 4) return {};
  const std::string folder = contains(mark[1], "/") ? "renders/" : "renders/19_accuracy_and_time/";
  std::string cell, before;
  std::vector<std::string> heads;
  int rows = 0;
  for (const std::string& row : lines_of(text_of(folder + mark[1] + ".md"))) {
    if (row.starts_with("| ---")) heads = parts_of(before, '|');
    before = row;
    const std::size_t column = place_of(mark[2], heads);
    if (column == heads.size() || row.find('|') != 0) continue;
    const auto is_there = [&](const std::string& word) { return contains(heads[1] + " | " + row, word); };
    if (!std::all_of(mark.begin() + 3, mark.end(), is_there)) continue;
    cell = parts_of(row, '|').at(column);
    ++rows;
  }
  if (rows != 1) return {};
  static const std::regex number("\\b[0-9]+([.,][0-9]+)*");
  std::sregex_iterator found(cell.begin(), cell.end(), number);
  for (const std::sregex_iterator end; found != end && which > 0; --which) ++found;
  return found == std::sregex_iterator() ? "" : found->str();
}

/// What should stand before the mark; empty where the mark names nothing.
std::string figure_of(const std::vector<std::string>& mark) {
  if (mark[0] == "cases") return std::to_string(hard_cases().size());
  if (mark[0] == "cases in words") return in_words(hard_cases().size());
  if (mark[0] == "motions in words") return in_words(every_motion().size());
  if (mark[0] == "cases with joints in words")
    return in_words(static_cast<std::size_t>(std::ranges::count_if(hard_cases(), [](const HardCase& hard_case) {
      World world;
      hard_case.scene.fill(world);
      return !world.joints.empty();
    })));
  if (mark[0] == "study") return figure_of_study(mark);
  if (mark[0] == "cell") return figure_of_cell(mark);
  if (mark[0] != "peers") return figure_in(ours(), mark);
  if (mark.size() > 2) return figure_in(beside_engines(), {mark.begin() + 1, mark.end()});
  const std::vector<std::string> kinds{"nobody", "ours", "engine", "both", "nothing"};
  const std::size_t kind = place_of(mark[1], kinds);
  return kind == kinds.size() ? "" : std::to_string(passed_by(beside_engines())[kind].size());
}

/// Where the figure, or the word, begins that ends at `end`.
std::size_t start_of_figure(const std::string& text, std::size_t end, bool word) {
  const auto is_part = [&](unsigned char c) {
    return word ? std::isalpha(c) != 0 || c == '-'
                : std::isdigit(c) != 0 || c == '.' || c == ',' || c == '/' || c == '-' || c >= 0x80;
  };
  for (const std::string unit : {"mrad/s", "mrad", "mm/s", "m/s", "mm", "m", "mJ", "J", "%", "degrees"}) {
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
  for (const auto& entry : fs::recursive_directory_iterator("docs")) {
    if (entry.path().extension() == ".md") all.push_back(entry.path());
  }
  for (const auto& entry : fs::directory_iterator("chapters")) {
    if (!entry.is_directory()) continue;
    for (const auto& page : fs::directory_iterator(entry.path()))
      if (page.path().extension() == ".md") all.push_back(page.path());
  }
  return all;
}

}  // namespace

TEST_CASE("the committed table has every case under every stage, with the limits and starts of today") {
  const Table& table = ours();  // whose reader refuses other names of cases, stages and criteria
  REQUIRE(table.cases.size() == hard_cases().size());
  REQUIRE(table.stages.size() == table_stages().size());
  for (std::size_t row = 0; row < table.cases.size(); ++row) {
    const HardCase& hard_case = hard_cases()[row];
    INFO(hard_case.name);
    CHECK(criteria_of(table.cases[row]) == criteria_of(hard_case));
    for (std::size_t column = 0; column < table.stages.size(); ++column)
      CHECK(table.at(row, column).starts == std::min(hard_case.starts, table_stages()[column].most_starts));
    CHECK(contains(text_of("docs/hard_cases.md"), "`" + hard_case.name + "`"));
  }
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
      const std::size_t begin = start_of_figure(text, at, parts[0].ends_with("in words"));
      std::string there = text.substr(begin, at - begin);
      std::ranges::replace(there, '\n', ' ');
      if (!write) CHECK(there == figure);
      renewed += text.substr(copied, begin - copied) + figure;
      copied = at;
      ++seen[parts[0]];
    }
    if (write && copied > 0) std::ofstream(page, std::ios::binary) << renewed << text.substr(copied);
  }
  for (const char* words : {"cases in words", "cases with joints in words", "motions in words", "passes", "fails"})
    CHECK(seen[words] >= 1);
}

TEST_CASE("the figure of the front page has a bar for each count, as high as it says, from the tables") {
  const std::string figure = text_of("docs/figures/hard_cases.svg");
  static const std::regex bar(R"re(height="(\d+)" fill="#\w+"/><text id="([^"]+)"[^>]*>(\d+)</text>)re");
  int bars = 0;
  for (std::sregex_iterator at(figure.begin(), figure.end(), bar), end; at != end; ++at, ++bars) {
    INFO((*at)[2]);
    CHECK((*at)[3] == figure_of(parts_of((*at)[2])));
    CHECK(std::stoi((*at)[1]) == 3 * std::stoi((*at)[3]));
  }
  CHECK(bars == 24);
  CHECK(contains(figure, fmt::format(">How many of {} hard cases pass<", hard_cases().size())));
}
