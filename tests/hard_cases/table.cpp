/// The table as text: the words of a cell, and the files.
#include "tests/hard_cases/table.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <utility>

namespace pushback {

std::optional<std::size_t> rescuer(const Table& table, std::size_t row) {
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

/// A field of CSV: in quotes where it needs them.
std::string field(const std::string& text) {
  if (text.find_first_of(",\"\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + '"';
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
  // In the words of the watcher, or of World::step; "angular momentum" has to come before "momentum".
  static constexpr std::array<std::pair<const char*, const char*>, 8> words{{{"gained", "energy"},
                                                                             {"angular momentum", "spin"},
                                                                             {"momentum", "momentum"},
                                                                             {"pulls", "pulls"},
                                                                             {"friction", "friction"},
                                                                             {"overlap", "overlap"},
                                                                             {"not finite", "NaN"},
                                                                             {"holds no joints", "no joints"}}};
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

std::string criteria_of(const HardCase& hard_case) {
  std::string text;
  for (const Criterion& c : hard_case.criteria) {
    text +=
        fmt::format("{}{} ≤ {:g}{}{}", text.empty() ? "" : "; ", c.what, c.limit, c.unit.empty() ? "" : " ", c.unit);
  }
  return text;
}

// ---- files ---------------------------------------------------------------------------------------------------------

std::string table_csv(const Table& table) {
  std::string csv = "case,stage,criterion,unit,limit,number,pass,broken,largest,starts_passed,starts\n";
  const auto text_of = [](Real number) { return std::isnan(number) ? "nan" : fmt::format("{}", number); };
  for (std::size_t row = 0; row < table.cases.size(); ++row) {
    const HardCase& hard_case = table.cases[row];
    for (std::size_t column = 0; column < table.stages.size(); ++column) {
      const Outcome& outcome = table.at(row, column);
      for (std::size_t i = 0; i < outcome.numbers.size(); ++i) {
        const Criterion& criterion = hard_case.criteria[i];
        csv += fmt::format("{},{},{},{},{},{},{},{},{},{},{}\n", field(hard_case.name),
                           field(table.stages[column].name), field(criterion.what), field(criterion.unit),
                           criterion.limit, text_of(outcome.numbers[i]), outcome.largest[i] <= criterion.limit ? 1 : 0,
                           field(outcome.broken), text_of(outcome.largest[i]), outcome.starts_passed, outcome.starts);
      }
    }
  }
  return csv;
}

std::string table_md(const Table& table) {
  std::string md =
      "✓: every number is within its limit, and no invariant broke. ✗: something failed; in brackets, the invariant "
      "that "
      "broke first. The number is that of the criterion nearest to its limit, or furthest beyond. **Bold**: the stage "
      "that "
      "rescues the case. n/30: a case at a knife's edge, from 30 starts that differ by up to 0.001 mm; n of them pass, "
      "the "
      "number is the largest of all, and the case passes if all do.\n\n| case |";
  std::string rule = "| --- |";
  for (const Stage& stage : table.stages) {
    md += fmt::format(" {} |", cell(stage.name));
    rule += " --- |";
  }
  md += "\n" + rule + "\n";
  for (std::size_t row = 0; row < table.cases.size(); ++row) {
    md += fmt::format("| {} |", cell(table.cases[row].title));
    const auto rescued = rescuer(table, row);
    for (std::size_t column = 0; column < table.stages.size(); ++column) {
      const std::string word = in_a_word(table.at(row, column).broken);
      const std::string starts = passed_of_starts(table.at(row, column));
      const std::string text =
          fmt::format("{} {}{}{}{}", table.passed(row, column) ? "✓" : "✗", worst_number(table, row, column),
                      starts.empty() ? "" : ", ", starts, word.empty() ? "" : fmt::format(" ({})", word));
      md += rescued == column ? fmt::format(" **{}** |", cell(text)) : fmt::format(" {} |", cell(text));
    }
    md += "\n";
  }
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
      csv += fmt::format("{},{},{:.4f}\n", field(table.cases[row].name), field(table.stages[column].name),
                         table.at(row, column).ms_per_step);
    }
  }
  return csv;
}

}  // namespace pushback
