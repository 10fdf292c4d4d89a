/// The table as text: the words of a cell, and the files.
#include "pushback/tools/measure/hard_cases/table.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <utility>

#include "pushback/common/basics/input.h"
#include "pushback/common/basics/named.h"
#include "pushback/tools/measure/results/csv.h"
#include "pushback/tools/measure/results/markdown.h"

namespace pushback {

std::optional<std::size_t> rescuer(const Table& table, std::size_t row) {
  if (!table.rescues) return {};
  std::size_t first = table.chapters;
  while (first > 0 && table.passed(row, first - 1)) --first;
  if (first == table.chapters) {
    while (first < table.stages.size() && !table.passed(row, first)) ++first;
  }
  if (first == 0 || first == table.stages.size()) return {};
  return first;
}

// ---- words ---------------------------------------------------------------------------------------------------------

namespace {

/// "3.2·10⁻⁷" for 3.2e-07.
std::string with_power(const std::string& scientific) {
  static constexpr std::array digits{"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
  const std::size_t e = scientific.find('e');
  const int power = std::atoi(scientific.c_str() + e + 1);
  std::string text = scientific.substr(0, e) + "·10" + (power < 0 ? "⁻" : "");
  for (const char c : std::to_string(std::abs(power))) text += digits[static_cast<std::size_t>(c - '0')];
  return text;
}

/// A cell of Markdown.
std::string cell(const std::string& text) {
  std::string escaped;
  for (const char c : text) escaped += c == '|' ? std::string("\\|") : std::string(1, c);
  return escaped;
}

}  // namespace

std::string in_short(Real value, Real limit, const std::string& unit) {
  if (!std::isfinite(value)) return "–";
  const bool long_way = std::abs(value) >= 1000 && (unit == "mm" || unit == "mm/s");
  const double scale = long_way ? 0.001 : 1;
  const double shown = scale * static_cast<double>(value), edge = scale * static_cast<double>(limit);
  int digits = 2;  // more, while rounding would carry it over its limit
  const auto rounded = [&] { return std::strtod(fmt::format("{:.{}e}", shown, digits - 1).c_str(), nullptr); };
  while (digits < 17 && (rounded() > edge) != (shown > edge)) ++digits;
  const double size = std::abs(shown);
  const std::string text = size > 0 && (size < 1e-3 || size >= 1e5)
                               ? with_power(fmt::format("{:.{}e}", shown, digits - 1))
                           : size >= 100 && digits == 2 ? fmt::format("{:.0f}", shown)
                                                        : fmt::format("{:g}", rounded());
  return fmt::format("{}{}{}", text, unit.empty() ? "" : " ", long_way ? unit.substr(1) : unit);
}

std::string in_a_word(const std::string& broken) {
  // In the words of outcome_apart, then of the watcher, or of World::step; "angular momentum" has to come before "momentum".
  static constexpr std::array<std::pair<const char*, const char*>, 14> words{{{not_possible, not_possible},
                                                                              {"crashed", "crash"},
                                                                              {"threw", "threw"},
                                                                              {"no end", "no end"},
                                                                              {"not played", "not played"},
                                                                              {"gained", "energy"},
                                                                              {"angular momentum", "spin"},
                                                                              {"momentum", "momentum"},
                                                                              {"pulls", "pulls"},
                                                                              {"friction", "friction"},
                                                                              {"overlap", "overlap"},
                                                                              {"not finite", "NaN"},
                                                                              {"holds no joints", "no joints"},
                                                                              {"too large", "too large"}}};
  for (const auto& [said, word] : words) {
    if (broken.find(said) != std::string::npos) return word;
  }
  return broken.empty() ? "" : "broken";
}

std::string worst_number(const Table& table, std::size_t row, std::size_t column) {
  const HardCase& hard_case = table.cases[row];
  const Outcome& outcome = table.at(row, column);
  const std::size_t worst = outcome.worst(hard_case);
  return in_short(outcome.largest[worst], hard_case.criteria[worst].limit, hard_case.criteria[worst].unit);
}

std::string passed_of_starts(const Outcome& outcome) {
  return outcome.starts > 1 ? fmt::format("{}/{}", outcome.starts_passed, outcome.starts) : "";
}

// ---- files ---------------------------------------------------------------------------------------------------------

std::string table_csv(const Table& table) {
  const bool best = std::ranges::any_of(table.stages, [](const Stage& stage) { return !stage.tries.empty(); });
  std::string csv = fmt::format("case,stage,criterion,unit,limit,number,pass,broken,largest,starts_passed,starts{}\n",
                                best ? ",by" : "");
  const auto text_of = [](Real number) { return std::isnan(number) ? "nan" : fmt::format("{}", number); };
  for (std::size_t row = 0; row < table.cases.size(); ++row) {
    const HardCase& hard_case = table.cases[row];
    for (std::size_t column = 0; column < table.stages.size(); ++column) {
      const Outcome& outcome = table.at(row, column);
      for (std::size_t i = 0; i < outcome.numbers.size(); ++i) {
        const Criterion& criterion = hard_case.criteria[i];
        csv += fmt::format("{},{},{},{},{},{},{},{},{},{},{}{}\n", csv_field(hard_case.name),
                           csv_field(table.stages[column].name), csv_field(criterion.what), csv_field(criterion.unit),
                           criterion.limit, text_of(outcome.numbers[i]), outcome.largest[i] <= criterion.limit ? 1 : 0,
                           csv_field(outcome.broken), text_of(outcome.largest[i]), outcome.starts_passed,
                           outcome.starts, best ? fmt::format(",{}", csv_field(outcome.by)) : "");
      }
    }
  }
  return csv;
}

namespace {

/// The chapter's page, from the folder; empty where the stage is of no one chapter.
std::string page_of(const Stage& stage, const std::filesystem::path& folder) {
  const std::string number = stage.name.substr(0, stage.name.find(' ')) + "_";
  for (const auto& entry : std::filesystem::directory_iterator("chapters")) {
    if (entry.path().filename().string().starts_with(number))
      return std::filesystem::relative(entry.path() / "README.md", folder).generic_string();
  }
  return {};
}

/// Of "not possible: restitution", what is missing.
std::string missing_in(const std::string& broken) {
  const std::string what = broken.substr(broken.find(": ") + 2);
  return "no " + what.substr(what.starts_with("a ") ? 2 : 0);
}

/// "✓", or "✗ 35 m", and below it how many of several starts pass, unless none does, and the invariant that broke first.
std::string cell_of(const Table& table, std::size_t row, std::size_t column) {
  const Outcome& outcome = table.at(row, column);
  if (!outcome.possible()) return "—<br>" + missing_in(outcome.broken);
  const std::string by = outcome.by.empty() ? "" : fmt::format("<br>{}", outcome.by);
  if (table.passed(row, column)) return (rescuer(table, row) == column ? "★ ✓" : "✓") + by;
  std::string below = outcome.starts_passed > 0 ? passed_of_starts(outcome) : "";
  const std::string word = in_a_word(outcome.broken);
  if (!word.empty()) below += (below.empty() ? "" : ", ") + word;
  return fmt::format("✗ {}{}{}{}", worst_number(table, row, column), below.empty() ? "" : "<br>", below, by);
}

std::string rows_of(const Table& table, std::size_t first, std::size_t end, const std::filesystem::path& folder) {
  std::vector<std::string> heads{"case"}, passes{"**pass**"};
  for (std::size_t column = first; column < end; ++column) {
    const std::string name = cell(table.stages[column].name), page = page_of(table.stages[column], folder);
    heads.push_back(page.empty() ? name : fmt::format("[{}]({})", name, page));
    passes.push_back(fmt::format("**{} of {}**", table.passes(column), table.cases.size()));
  }
  std::string md = markdown_heads(heads) + markdown_row(passes);
  for (std::size_t row = 0; row < table.cases.size(); ++row) {
    std::vector<std::string> cells{cell(table.cases[row].title)};
    for (std::size_t column = first; column < end; ++column) cells.push_back(cell(cell_of(table, row, column)));
    md += markdown_row(cells);
  }
  return md;
}

}  // namespace

Table empty_table(std::vector<HardCase> cases, std::vector<Stage> columns) {
  Table table;
  table.cases = std::move(cases);
  table.stages = std::move(columns);
  for (std::size_t i = 0; i < chapter_stages; ++i) {
    for (const Stage& stage : table.stages) table.chapters += stage.name == stages()[i].name ? 1 : 0;
  }
  table.outcomes.resize(table.cases.size() * table.stages.size());
  return table;
}

Table read_table_csv(const std::string& text, const std::vector<Stage>& stages) {
  const std::vector<std::vector<std::string>> lines = csv_fields(text);
  std::vector<HardCase> cases;
  std::vector<Stage> columns;
  for (std::size_t i = 1; i < lines.size(); ++i) {
    if (lines[i].size() != lines[0].size() || lines[i].size() < 11)
      throw InvalidInput(fmt::format("table.csv: line {} has {} fields, {} are needed", i + 1, lines[i].size(),
                                     std::max<std::size_t>(11, lines[0].size())));
    if (cases.empty() || cases.back().name != lines[i][0]) cases.push_back(hard_case_named(lines[i][0]));
    if (cases.size() == 1 && (columns.empty() || columns.back().name != lines[i][1]))
      columns.push_back(named("stage", stages, lines[i][1]));
  }
  if (cases.empty()) throw InvalidInput("table.csv has no lines of cases");
  Table table = empty_table(std::move(cases), std::move(columns));
  std::size_t i = 1;
  for (std::size_t pair = 0; pair < table.outcomes.size(); ++pair) {
    HardCase& hard_case = table.cases[pair / table.stages.size()];
    const Stage& stage = table.stages[pair % table.stages.size()];
    Outcome& outcome = table.outcomes[pair];
    for (Criterion& criterion : hard_case.criteria) {
      if (i == lines.size() || lines[i][0] != hard_case.name || lines[i][1] != stage.name ||
          lines[i][2] != criterion.what || lines[i][3] != criterion.unit)
        throw InvalidInput(fmt::format("table.csv: line {} should be of {}, {}, {}: play the cases again", i + 1,
                                       hard_case.name, stage.name, criterion.what));
      const std::vector<std::string>& f = lines[i++];
      criterion.limit = csv_number<Real>(f[4]);
      outcome.numbers.push_back(csv_number<Real>(f[5]));
      outcome.broken = f[7];
      outcome.largest.push_back(csv_number<Real>(f[8]));
      outcome.starts_passed = csv_number<int>(f[9]);
      outcome.starts = csv_number<int>(f[10]);
      if (f.size() > 11) outcome.by = f[11];
    }
  }
  if (i != lines.size())
    throw InvalidInput(fmt::format("table.csv: {} lines were expected, there are {}", i, lines.size()));
  return table;
}

std::string table_md(const Table& table, const std::filesystem::path& folder) {
  std::string md =
      "A row is a case, a column a stage of the solver: [what they are](#what-the-stages-are). ✓: every number is "
      "within "
      "its limit, and no invariant broke. ✗: something failed, and the number is that of the criterion furthest beyond "
      "its "
      "limit, or nearest to it; below it, the invariant that broke first. ★: the stage that rescues the case. A count "
      "such "
      "as 29/30: so many of 30 starts pass, and all would have to; without a count, none does.\n";
  if (!table.rescues)
    md = "A row is a case, a column a solver of ours or [another engine](#what-the-stages-are). ✓: every number is "
         "within its limit, and no invariant broke. ✗: something failed, and the number is that of the criterion "
         "furthest beyond its limit, or nearest to it; below it, the invariant that broke first. —: the engine does "
         "not have what the case asks for. A count such as 4/5: so many of 5 starts pass, of 30 under ours, and all "
         "would have to; without a count, none does.\n";
  const auto part = [&](std::string heading, std::size_t first, std::size_t end) {
    if (first == end) return;
    heading[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(heading[0])));
    md += "\n## " + heading + "\n\n" + rows_of(table, first, end, folder);
  };
  part(table.first, 0, table.chapters);
  part(table.others, table.chapters, table.stages.size());
  md += "\n## What is asked of each\n\n";
  for (const HardCase& hard_case : table.cases) {
    md += fmt::format("- **{}** (`{}`): {}. {}.\n", hard_case.title, hard_case.name, hard_case.stresses,
                      criteria_of(hard_case));
  }
  md += "\n## What the stages are\n\n";
  for (const Stage& stage : table.stages) md += fmt::format("- **{}**: {}.\n", stage.name, stage.what);
  return md;
}

std::string times_csv(const Table& table) {
  std::string csv = "case,stage,ms_per_step\n";
  for (std::size_t row = 0; row < table.cases.size(); ++row) {
    for (std::size_t column = 0; column < table.stages.size(); ++column) {
      if (!table.played(row, column)) continue;
      csv += fmt::format("{},{},{:.4f}\n", csv_field(table.cases[row].name), csv_field(table.stages[column].name),
                         table.at(row, column).ms_per_step);
    }
  }
  return csv;
}

}  // namespace pushback
