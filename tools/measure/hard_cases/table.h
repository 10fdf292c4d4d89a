/// The table of all cases and stages, with its numbers, texts and files.
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
  std::size_t chapters = 0;     ///< the number of columns that are a chapter each, which come first
  std::string asks = "Which feature keeps which hard case stable?";
  std::string first = "one more feature in each chapter";  ///< heading of the columns of chapters
  std::string others = "what came after";                  ///< heading of the other columns
  bool rescues = true;            ///< whether columns build on each other, so that one of them can rescue a case
  std::vector<Outcome> outcomes;  ///< row by row

  const Outcome& at(std::size_t row, std::size_t column) const { return outcomes[row * stages.size() + column]; }
  bool passed(std::size_t row, std::size_t column) const { return at(row, column).passed(cases[row]); }
  /// The outcome of a case and a stage by their names, or nullptr if it has not been played.
  const Outcome* find(const std::string& name, const std::string& stage) const;
  bool played(std::size_t row, std::size_t column) const { return !at(row, column).numbers.empty(); }
  /// The number of cases that pass in a column.
  std::size_t passes(std::size_t column) const {
    std::size_t count = 0;
    for (std::size_t row = 0; row < cases.size(); ++row) count += passed(row, column) ? 1 : 0;
    return count;
  }
};

/// Called after each pair of case and stage. The first `rows` rows and `done` pairs are complete.
using Progress = std::function<void(const Table&, std::size_t rows, std::size_t done)>;

/// The limits of stages that are played in separate processes: the time after which a case is given up, and the number of times after
/// which the stage plays no more cases.
struct GivingUp {
  double seconds = 30;
  int times = 3;
};

/// Plays every case with every stage. Each pair has its own world and solver, so the result does not depend on the order or the number
/// of threads.
Table play(std::vector<HardCase> cases, std::vector<Stage> stages, int threads, const Progress& progress,
           const GivingUp& giving_up = {});

/// A table with an empty outcome for each pair.
Table empty_table(std::vector<HardCase> cases, std::vector<Stage> stages);
/// A table of these cases and stages. Each cell is taken from the first table that contains it. Throws InvalidInput if none does.
Table assembled(std::vector<HardCase> cases, std::vector<Stage> stages, const std::vector<const Table*>& from);

/// Follows an engine's name in the name of the stage that is its best of ten.
inline constexpr const char* best_of_ten = " best of ten";
/// The best outcome of stage.tries, which `outcome_of` plays or finds. It is the first that passes. If none does, it is the one with the
/// most passed starts, among these one that breaks no invariant, and among these the one nearest to its limits.
Outcome best_of(const HardCase& hard_case, const Stage& stage,
                const std::function<Outcome(const Stage& one)>& outcome_of);

// ---- a case played in a separate process, for other engines, and for a reader's solver, which may crash, throw or not return ----

/// The beginning of Outcome::broken if the time was over.
inline constexpr const char* no_end = "no end";
/// Runs stage.apart, the program with its arguments, to play the case, and ends it after `seconds`. See program_apart.
Outcome outcome_apart(const HardCase& hard_case, const Stage& stage, double seconds);
/// The `main` of such a program.  PROGRAM --setting SETTING --hard-case NAME --starts COUNT --out FOLDER  plays the case with the stage
/// of this setting, and writes the outcome for outcome_apart. Returns the exit status.
int program_apart(int argc, const char* const* argv, const std::function<Stage(const std::string& setting)>& stage_of);
/// Whether a program has been called with these arguments.
bool is_called_apart(int argc, const char* const* argv);

// ---- texts and files ----

/// The column whose feature rescues the case. Among the chapters, it is the first from which on all pass, unless this is the very
/// first chapter. If the last chapter fails, it is the first later column that passes. None if no column passes, if the first chapter
/// passes, or if Table::rescues is false.
std::optional<std::size_t> rescuer(const Table& table, std::size_t row);

/// The shortest text that shows on which side of its limit a number is, such as "0.28 mm/s" or "12 m", or "–" if it is not finite.
std::string in_short(Real value, Real limit, const std::string& unit);
/// The invariant that broke, as a word, such as "energy", "pulls" or "NaN", or empty if none did.
std::string in_a_word(const std::string& broken);
/// The number of the cell's worst criterion, in_short.
std::string worst_number(const Table& table, std::size_t row, std::size_t column);
/// "27/30" if there are several starts, otherwise empty.
std::string passed_of_starts(const Outcome& outcome);

/// A CSV text with a line per criterion and the fields case, stage, criterion, unit, limit, number, pass, broken, largest,
/// starts_passed, starts, and the name of the best stage if a stage is the best of several. `number` is from the scene as it is,
/// `largest` from all starts. `pass` is 1 if `largest` is within the limit. A cell of the table passes if all of its lines do and
/// `broken` is empty. A number that could not be measured is nan.
std::string table_csv(const Table& table);
/// Reads a table from such a text. Its texts and pictures are the same as before. Throws InvalidInput if the text is no such table, or
/// has other cases, stages or criteria than the program.
Table read_table_csv(const std::string& text, const std::vector<Stage>& stages = table_stages());
/// The tables in Markdown, one for the chapters and one for the other stages, with a row per case and a column per stage. The
/// difficulty and the criteria of each case follow. `folder`: the folder of the page, for its links to the chapters.
std::string table_md(const Table& table, const std::filesystem::path& folder);
/// A CSV text with the fields case, stage, ms_per_step. Its file is the only one that differs from run to run.
std::string times_csv(const Table& table);
/// A picture of the cells that pass, without numbers, with a row per case and a cell per stage.
Image draw_overview(const Table& table);

/// Describes the cases as an experiment, to be called inside `run`'s `define`, with a scene per case under its name, and a variant per
/// stage. Each is played from its first start in steps of --dt, without the other worlds and starts of HardCase::run.
void describe_hard_cases(Experiment& experiment);

// ---- the common part of programs that play a table ----

/// The columns of a table, and its files.
struct TableKind {
  std::string folder = "hard_cases";  ///< within the folder of --out
  std::string file = "table";         ///< the names of its CSV file and its page
  std::string times = "times.csv";    ///< milliseconds per step, the only file that differs from run to run
  std::string picture = "overview";   ///< the name of its picture; empty: none
  std::vector<Stage> stages = {};     ///< the columns to choose from
  std::vector<Stage> further = {};    ///< columns after the chosen ones
  bool whole = true;                  ///< if false, its files go to part/, whatever is chosen
  GivingUp giving_up = {};            ///< for stages that are played in separate processes
  std::function<std::string(const Table&, const std::filesystem::path& folder)> page = table_md;
  std::function<Table(const Table&)> shown = [](const Table& table) {
    return table;
  };  ///< on the page and in the picture
};

/// Adds the common options to the command line, reads it, and plays or shows the table. `kind_of` is called after the options have been
/// read. Returns the exit status, which is 1 if a stage in a separate process crashed, threw or did not end.
int table_program(int argc, const char* const* argv, CommandLine& line, const std::function<TableKind()>& kind_of);

}  // namespace pushback
