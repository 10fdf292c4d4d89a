/// Every case under every stage: the numbers, and how they are written down.
#pragma once

#include <filesystem>
#include <optional>

#include "pushback/common/basics/shard.h"
#include "pushback/tools/measure/hard_cases/hard_case.h"

namespace pushback {

struct Table {
  std::vector<HardCase> cases;  ///< the rows
  std::vector<Stage> stages;    ///< the columns, in the order of stages()
  std::size_t chapters = 0;     ///< how many of the columns, the first ones, are a chapter each
  std::string asks = "Which feature keeps which hard case stable?";
  std::string first = "one more feature in each chapter";  ///< what the first columns are
  std::string others = "what came after";                  ///< what the columns are that are no chapter
  bool rescues = true;            ///< whether one column is made of another, so that one of them rescues a case
  std::vector<Outcome> outcomes;  ///< a row after the other

  const Outcome& at(std::size_t row, std::size_t column) const { return outcomes[row * stages.size() + column]; }
  bool passed(std::size_t row, std::size_t column) const { return at(row, column).passed(cases[row]); }
  /// By their names; none where it has not been played.
  const Outcome* find(const std::string& name, const std::string& stage) const;
  bool played(std::size_t row, std::size_t column) const { return !at(row, column).numbers.empty(); }
  /// How many cases pass in a column.
  std::size_t passes(std::size_t column) const {
    std::size_t count = 0;
    for (std::size_t row = 0; row < cases.size(); ++row) count += passed(row, column) ? 1 : 0;
    return count;
  }
};

/// Called after each pair: the first `rows` rows are complete, `done` pairs are.
using Progress = std::function<void(const Table&, std::size_t rows, std::size_t done)>;

/// Each case of a stage that is played apart is given up after so long. Who has been given up so often plays nothing more.
struct GivingUp {
  double seconds = 30;
  int times = 3;
};

/// Plays every case under every stage, or of these pairs those that are the part's. Each has a world and a solver of its own, so that
/// the order and the number of threads change nothing.
Table play(std::vector<HardCase> cases, std::vector<Stage> stages, int threads, const Progress& progress,
           const GivingUp& giving_up = {}, const Shard& shard = {});

/// With an outcome for each pair, of nothing.
Table empty_table(std::vector<HardCase> cases, std::vector<Stage> stages);

/// The column whose feature rescues the case: among the chapters, the first from which on all pass, unless that is the very
/// first; where the last chapter fails, the first column behind the chapters that passes. None, where nothing helps, nothing is
/// needed, or no column rescues.
std::optional<std::size_t> rescuer(const Table& table, std::size_t row);

/// As short as it can be told on which side of its limit it lies: "0.28 mm/s", "12 m"; "–" where it is no finite number.
std::string in_short(Real value, Real limit, const std::string& unit);
/// The invariant that broke, in a word: "energy", "pulls", "NaN"; empty where none did.
std::string in_a_word(const std::string& broken);
/// The number of the cell's worst criterion, in_short.
std::string worst_number(const Table& table, std::size_t row, std::size_t column);
/// "27/30" where there are several starts; else empty.
std::string passed_of_starts(const Outcome& outcome);

/// case, stage, criterion, unit, limit, number, pass, broken, largest, starts_passed, starts: a line a criterion. `number`
/// is of the scene as it is, `largest` of all starts. `pass` is 1 where the largest is within the limit; a cell of the table
/// passes where all of its lines do and `broken` is empty. A number that came to nothing is nan.
std::string table_csv(const Table& table);
/// Back from it: what is then written and drawn is the same. Throws InvalidInput where it is no such table, or of other cases,
/// stages or criteria than there are.
Table read_table_csv(const std::string& text, const std::vector<Stage>& stages = table_stages());
/// Of all cases under these stages: what `now` has, and where it has nothing, what `before` has. Throws InvalidInput where neither has a
/// pair.
Table renewed(const Table& before, const Table& now, std::vector<Stage> stages);
/// For GitHub: a row a case, a column a stage, the chapters and the others in a table each; below them what every case
/// stresses and what is asked of it. `folder`: where the page will be, for its links to the chapters.
std::string table_md(const Table& table, const std::filesystem::path& folder);
/// case, stage, ms_per_step: the only file that differs from run to run.
std::string times_csv(const Table& table);

}  // namespace pushback
