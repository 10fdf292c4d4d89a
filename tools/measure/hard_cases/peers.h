/// The settings in which other engines play the hard cases, and the table of their results.
#pragma once

#include <array>

#include "pushback/tools/measure/hard_cases/table.h"

namespace pushback {

/// One way in which an engine plays.
struct PeerSetting {
  std::string name = {};    ///< the column: "Bullet tuned"
  std::string what = {};    ///< a line on the settings
  std::string engine = {};  ///< the program motion_ENGINE plays it
  bool tuned = false;       ///< whether its settings differ from the defaults
  int substeps = 1;         ///< of each step
  int own_substeps = 1;     ///< by which the engine divides each of these, with one detection
  int sweeps = 10;          ///< or iterations, in each substep
  Real epsilon = std::numeric_limits<Real>::epsilon();  ///< the rounding unit of its numbers
  /// Further settings, which the engine's source file interprets as words, or for MuJoCo as attributes of MJCF's <option>.
  std::string options = {};
  bool further = false;  ///< whether it has no column, but is one of the ten settings of which the best counts
  bool has(const std::string& word) const { return options.find(word) != std::string::npos; }
};

/// The most starts from which each case is played, because some engines take minutes for one.
inline constexpr int peer_starts = 5;

/// Ten settings of each engine, such as "Bullet" with its defaults, "Bullet for accuracy" as its makers' documentation recommends, and
/// eight further ones. Not every machine has all engines.
const std::vector<PeerSetting>& peer_settings();

/// The columns of these settings, by default of all peer_settings, and for each engine with further settings the best of its ten. Each
/// is played by the engine's program in `folder`, or by no program if `folder` is empty.
std::vector<Stage> peer_stages(const std::filesystem::path& folder = {},
                               const std::vector<PeerSetting>& settings = peer_settings());

/// The columns of the main table that are shown next to the engines.
std::vector<Stage> stages_beside_peers();

/// Our columns next to the engines' columns, with the cases that both tables have. One column is the best of ten of ours, too. These
/// ten were named before any engine was played in ten settings.
Table beside_peers(const Table& ours, const Table& peers);

/// The names of the cases in such a table that no solver passes, only ours, only an engine, both, and of the cases that need a feature
/// that no engine has.
std::array<std::vector<std::string>, 5> passed_by(const Table& table);

/// The page of such a table. It has the text of table_md and the lists of passed_by.
std::string peers_md(const Table& table, const std::filesystem::path& folder);

}  // namespace pushback
