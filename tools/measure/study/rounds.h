/// Measures every motion in every setting of every engine, in rounds.
#pragma once

#include <filesystem>
#include <functional>
#include <map>

#include "pushback/chapters/19_accuracy_and_time/front.h"
#include "pushback/chapters/19_accuracy_and_time/motion.h"

namespace pushback::study {

/// A program that plays motions, and its names in diagrams and tables.
struct Engine {
  std::string name, title, maker;  ///< `name` is the program's
  std::size_t colour = 0;          ///< index for line_colour
  bool dashed = false;             ///< dashed and with another marker than the engine of the same colour
};
inline const std::string ours = "Pushback";  ///< the maker of our engines

/// All possible engines, in the order of tables: ours, other engines, methods of docs/methods.md, a reader's solver, an adapter.
const std::vector<Engine>& known_engines();
/// The engines of these programs. Throws InvalidInput if one is not known.
std::vector<Engine> engines_named(const std::vector<std::string>& programs);
/// Our engines, and with `others` also the other makers' engines whose programs exist. Throws std::runtime_error if none of these does.
std::vector<Engine> engines_in(const std::filesystem::path& programs, bool others);

struct RoundOptions {
  std::vector<Engine> engines;            ///< see engines_in
  std::filesystem::path programs;         ///< the folder of `motion` and the others
  std::vector<std::string> methods = {};  ///< the methods to measure; empty: all
  bool quick = false;                     ///< whether to use fewer settings, fewer rounds and shorter time limits
  std::function<void(const std::string&)> say = [](const std::string&) {};  ///< reports progress
};

/// The version and the build settings that the engine's program reports.
std::string version_of(const Engine& engine, const std::filesystem::path& programs);

/// First plays every setting once, with powers of 2 for substeps and powers of 4 for sweeps, up to the motion's limits. In float it plays
/// only settings that are near the front in double. Then it times the settings near the robust front of their engines again, in rounds
/// that each play all of these settings. There are three rounds, and for settings that may be the cheapest for an error of the tables
/// ten to twenty, until the quartiles of their times are within a tenth of each other. Throws std::runtime_error if a program fails.
Measurements measure(const Motion& motion, const RoundOptions& options);

/// Measures all settings of this method or engine again, and keeps all other measurements. Returns the number of settings.
std::size_t measure_again(const std::string& method_or_engine, const Motion& motion, const RoundOptions& options,
                          Measurements& all);

/// The measurements of each motion, by its name.
using AllMeasured = std::map<std::string, Measurements>;

/// The known engines that have measurements.
std::vector<Engine> engines_of(const AllMeasured& all);

/// Converts measurements to CSV, with a heading and a line per measurement with all times, and back, so that diagrams and tables are the
/// same. Throws InvalidInput if a line has another format.
std::string csv_of(const AllMeasured& all);
AllMeasured read_csv(const std::string& text);

}  // namespace pushback::study
