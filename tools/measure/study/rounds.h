/// Every motion in every setting by every engine, timed in turn, round after round.
#pragma once

#include <filesystem>
#include <functional>
#include <map>

#include "pushback/chapters/19_accuracy_and_time/front.h"
#include "pushback/chapters/19_accuracy_and_time/motion.h"

namespace pushback::study {

/// A program that plays motions, and how it is called in diagrams and tables.
struct Engine {
  std::string name, title, maker;  ///< name: of the program
  std::size_t colour = 0;          ///< line_colour's
  bool dashed = false;             ///< and with another shape than its sister of the same colour
};
inline const std::string ours = "Pushback";  ///< the maker of our engines

/// All that there may be, in the order of tables: ours, others', those of docs/methods.md, a reader's solver, an adapter's engine.
const std::vector<Engine>& known_engines();
/// Of these programs. Throws InvalidInput where one is not known.
std::vector<Engine> engines_named(const std::vector<std::string>& programs);
/// Ours; and if `others` are asked for, those of other makers that are there: std::runtime_error where none is.
std::vector<Engine> engines_in(const std::filesystem::path& programs, bool others);

struct RoundOptions {
  std::vector<Engine> engines;            ///< see engines_in
  std::filesystem::path programs;         ///< the folder of `motion` and the others
  std::vector<std::string> methods = {};  ///< only these; empty: all
  bool quick = false;                     ///< fewer settings, fewer rounds, less patience
  std::function<void(const std::string&)> say = [](const std::string&) {};  ///< what is under way
};

/// What the engine's program says of its version, and of how it was built.
std::string version_of(const Engine& engine, const std::filesystem::path& programs);

/// First every setting once: powers of 2 of substeps, powers of 4 of sweeps, as far as the motion wants to have them tried.
/// In float only what is near the front in double. What is then near the robust front of its engine is timed again, all of it in every
/// round before the next begins: in three rounds, and in ten to twenty if it may be the cheapest for an error of the tables, until the
/// quartiles of its time are within a tenth of each other. Throws std::runtime_error where a program fails.
Measurements measure(const Motion& motion, const RoundOptions& options);

/// Measures all settings of this method again, or this engine's whole grid. Everything else stays. Returns the number of settings.
std::size_t measure_again(const std::string& method_or_engine, const Motion& motion, const RoundOptions& options,
                          Measurements& all);

/// By the name of the motion.
using AllMeasured = std::map<std::string, Measurements>;

/// The known engines of which something was measured.
std::vector<Engine> engines_of(const AllMeasured& all);

/// A line a measurement, and one of headings, with all times; and back: what is then drawn and said is the same. Throws
/// InvalidInput where a line is not one of these.
std::string csv_of(const AllMeasured& all);
AllMeasured read_csv(const std::string& text);

}  // namespace pushback::study
