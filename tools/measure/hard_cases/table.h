/// Every case under every stage: the numbers, and how they are written down.
#pragma once

#include <filesystem>
#include <optional>

#include "pushback/common/experiment/program.h"
#include "pushback/common/render/image.h"
#include "pushback/tools/measure/hard_cases/hard_case.h"

namespace pushback {

class Experiment;

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

/// Plays every case under every stage. Each pair has a world and a solver of its own, so that the order and the number of threads
/// change nothing.
Table play(std::vector<HardCase> cases, std::vector<Stage> stages, int threads, const Progress& progress,
           const GivingUp& giving_up = {});

/// With an outcome for each pair, of nothing.
Table empty_table(std::vector<HardCase> cases, std::vector<Stage> stages);
/// A table of these cases and stages. Each cell is taken from the first table that contains it. Throws InvalidInput if none does.
Table assembled(std::vector<HardCase> cases, std::vector<Stage> stages, const std::vector<const Table*>& from);

/// What follows an engine's name in the name of such a stage.
inline constexpr const char* best_of_ten = " best of ten";
/// Of stage.tries, as `outcome_of` plays or finds them: the first that passes, or else the one with the most starts that pass, of these
/// one that breaks nothing, of these the nearest to its limits.
Outcome best_of(const HardCase& hard_case, const Stage& stage,
                const std::function<Outcome(const Stage& one)>& outcome_of);

// ---- a case played by a process of its own: another engine is a program, and a reader's solver may crash, throw or never end ----

/// What `broken` begins with where the time was over.
inline constexpr const char* no_end = "no end";
/// stage.apart, the program and its arguments, plays the case, and is ended after so many seconds. See program_apart.
Outcome outcome_apart(const HardCase& hard_case, const Stage& stage, double seconds);
/// Such a program:  PROGRAM --setting SETTING --hard-case NAME --starts COUNT --out FOLDER  plays the case under the stage of this
/// setting, and writes what outcome_apart reads. Returns the exit status.
int program_apart(int argc, const char* const* argv, const std::function<Stage(const std::string& setting)>& stage_of);
/// Whether a program is called so.
bool is_called_apart(int argc, const char* const* argv);

// ---- words and files ----

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

/// case, stage, criterion, unit, limit, number, pass, broken, largest, starts_passed, starts: a line a criterion; where a stage is the best of several,
/// also which one. `number`
/// is of the scene as it is, `largest` of all starts. `pass` is 1 where the largest is within the limit; a cell of the table
/// passes where all of its lines do and `broken` is empty. A number that came to nothing is nan.
std::string table_csv(const Table& table);
/// Back from it: what is then written and drawn is the same. Throws InvalidInput where it is no such table, or of other cases,
/// stages or criteria than there are.
Table read_table_csv(const std::string& text, const std::vector<Stage>& stages = table_stages());
/// For GitHub: a row a case, a column a stage, the chapters and the others in a table each; below them what every case
/// stresses and what is asked of it. `folder`: where the page will be, for its links to the chapters.
std::string table_md(const Table& table, const std::filesystem::path& folder);
/// case, stage, ms_per_step: the only file that differs from run to run.
std::string times_csv(const Table& table);
/// A row a case, a cell for each stage: which of them pass, without numbers.
Image draw_overview(const Table& table);

/// The cases as an experiment, to be called inside `run`'s `define`: a scene each case, under the case's name, and a variant each stage.
/// Each is played as it begins, in steps of --dt; what a case does besides (other worlds, other starts) is left to its `run`.
void describe_hard_cases(Experiment& experiment);

// ---- what the programs that play a table have in common ----

/// Which columns a table has, and what is made of it.
struct TableKind {
  std::string folder = "hard_cases";  ///< within the folder of --out
  std::string file = "table";         ///< the names of its CSV file and its page
  std::string times = "times.csv";    ///< milliseconds of a step: the only file that differs from run to run
  std::string picture = "overview";   ///< the name of its picture; empty: it has none
  std::vector<Stage> stages = {};     ///< the columns to choose from
  std::vector<Stage> further = {};    ///< columns after the chosen ones
  bool whole = true;                  ///< else its files go to part/, whatever is chosen
  GivingUp giving_up = {};            ///< of a stage that is played apart
  std::function<std::string(const Table&, const std::filesystem::path& folder)> page = table_md;
  std::function<Table(const Table&)> shown = [](const Table& table) {
    return table;
  };  ///< on the page and in the picture
};

/// Adds the common options to the line, reads it, and plays or shows the table. `kind_of` is called after the options were read.
/// Returns the exit status: 1 if a stage that is played apart crashed, threw or came to no end.
int table_program(int argc, const char* const* argv, CommandLine& line, const std::function<TableKind()>& kind_of);

}  // namespace pushback
