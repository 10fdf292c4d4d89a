/// Other engines on the hard cases: in which settings each plays, and how their table is made of what they played.
#pragma once

#include <array>

#include "pushback/tools/measure/hard_cases/table.h"

namespace pushback {

/// One way in which an engine plays.
struct PeerSetting {
  std::string name = {};                                ///< the column: "Bullet tuned"
  std::string what = {};                                ///< in a line: what is set
  std::string engine = {};                              ///< the program motion_ENGINE plays it
  bool tuned = false;                                   ///< else as it comes
  int substeps = 1;                                     ///< of each step
  int own_substeps = 1;                                 ///< of each of these, by the engine: it detects once
  int sweeps = 10;                                      ///< or iterations, in each substep
  Real epsilon = std::numeric_limits<Real>::epsilon();  ///< the rounding unit of its numbers
  /// What the engine's source makes of them: words, or for MuJoCo attributes of MJCF's <option>.
  std::string options = {};
  bool further = false;  ///< has no column of its own, and is one of the ten of which the best counts
  bool has(const std::string& word) const { return options.find(word) != std::string::npos; }
};

/// From so many starts at most each case is played: some engines take minutes for one.
inline constexpr int peer_starts = 5;

/// Ten of each engine: "Bullet", as it comes; "Bullet for accuracy", as its makers' documentation recommends; and eight further ones.
/// Not every machine has all of them.
const std::vector<PeerSetting>& peer_settings();

/// Columns of these settings, by default all of peer_settings, and for each engine with further ones the best of its ten. Each plays by its program in the folder, or by none where the folder is empty.
std::vector<Stage> peer_stages(const std::filesystem::path& folder = {},
                               const std::vector<PeerSetting>& settings = peer_settings());

/// Those of `table` that stand beside the engines.
std::vector<Stage> stages_beside_peers();

/// The columns of ours beside the engines', each case that both have. One of them is the best of ten of ours, too, named before any
/// engine was played in ten.
Table beside_peers(const Table& ours, const Table& peers);

/// The names of the cases of such a table that nobody passes; ours alone; an engine alone; both; and those that ask for what no
/// engine has.
std::array<std::vector<std::string>, 5> passed_by(const Table& table);

/// The page of such a table: the same as table_md, and which cases nobody passes, or ours alone, or engines alone.
std::string peers_md(const Table& table, const std::filesystem::path& folder);

}  // namespace pushback
