#include "pushback/tools/measure/hard_cases/peers.h"

#include <fmt/ranges.h>

#include <algorithm>

#include "pushback/common/basics/named.h"

namespace pushback {

namespace {

constexpr Real of_float = Real(std::numeric_limits<float>::epsilon());

}  // namespace

const std::vector<PeerSetting>& peer_settings() {
  static const std::vector<PeerSetting> all{
      {.name = "Bullet",
       .what = "as it comes: float, 10 iterations a step",
       .engine = "bullet",
       .sweeps = 10,
       .epsilon = of_float},
      {.name = "Bullet tuned",
       .what = "double, 8 substeps of 50 iterations, friction in two directions, split impulse at any depth, all of "
               "the warm start, ERP 0.8 for joints; what bounces touches from where it touches, and bounces at any "
               "speed; a margin of 0.1 mm around hulls",
       .engine = "bullet_double",
       .tuned = true,
       .substeps = 8,
       .sweeps = 50},
      {.name = "ODE",
       .what = "as it comes: QuickStep, 20 iterations a step, friction as a pyramid",
       .engine = "ode",
       .sweeps = 20},
      {.name = "ODE tuned",
       .what = "8 substeps; up to 16 contacts are solved directly, more by QuickStep in 200 iterations; the pyramid "
               "lies along the sliding; overlap stays up to 0.5 mm and is pushed out at 3 m/s at most",
       .engine = "ode",
       .tuned = true,
       .substeps = 8,
       .sweeps = 200},
      {.name = "MuJoCo",
       .what =
           "as it comes: steps of 2 ms, Newton's method, friction as a pyramid, contacts of a time constant of 0.02 s",
       .engine = "mujoco",
       .substeps = 8},
      {.name = "MuJoCo tuned",
       .what = "8 substeps, an elliptic cone, contacts as hard as the substep allows (solref 2 h, solimp 0.9999)",
       .engine = "mujoco",
       .tuned = true,
       .substeps = 8},
      {.name = "Box3D",
       .what = "as it comes: float, 4 substeps",
       .engine = "box3d",
       .own_substeps = 4,
       .epsilon = of_float},
      {.name = "Box3D stiff",
       .what = "8 substeps, contacts and joints as stiff as these allow; what bounces does so at any speed; bodies may "
               "have 10 km/s",
       .engine = "box3d",
       .tuned = true,
       .own_substeps = 8,
       .epsilon = of_float},
      {.name = "Box3D tuned",
       .what = "as stiff, with contacts detected 8 times a step, for 8 substeps each",
       .engine = "box3d",
       .tuned = true,
       .substeps = 8,
       .own_substeps = 8,
       .epsilon = of_float},
      {.name = "Jolt",
       .what = "as it comes: float, 10 velocity and 2 position iterations a step, corners rounded by 50 mm",
       .engine = "jolt",
       .epsilon = of_float},
      {.name = "Jolt tuned",
       .what = "8 substeps of 16 velocity and 4 position iterations, bounces at any speed, no allowed overlap, no "
               "rounding, a gyroscopic torque",
       .engine = "jolt",
       .tuned = true,
       .substeps = 8,
       .sweeps = 16,
       .epsilon = of_float}};
  return all;
}

namespace {

/// Of a stage that plays by its program alone.
struct Elsewhere : StepSolver {
  void solve(World&, Real, int) override { throw InvalidInput("an engine plays by a program of its own"); }
};

}  // namespace

std::vector<Stage> peer_stages(const std::filesystem::path& folder, const std::vector<PeerSetting>& settings) {
  std::vector<Stage> list;
  for (const PeerSetting& setting : settings) {
    Stage stage{{setting.name, setting.what, Elsewhere{}, {}}};
    if (!folder.empty()) stage.apart = {folder / ("motion_" + setting.engine), "--setting", setting.name};
    stage.epsilon = setting.epsilon;
    stage.most_starts = peer_starts;
    list.push_back(std::move(stage));
  }
  return list;
}

std::vector<Stage> stages_beside_peers() {
  return {stage_named("07 warm start"), stage_named("22 wide"), stage_named("26 by island")};
}

Table beside_peers(const Table& ours, const Table& peers) {
  std::vector<Stage> columns = stages_beside_peers();
  const std::size_t own = columns.size();
  columns.insert(columns.end(), peers.stages.begin(), peers.stages.end());
  std::vector<HardCase> cases = peers.cases;
  const std::vector<std::string> names = names_of(ours.cases);
  std::erase_if(cases, [&](const HardCase& one) { return std::ranges::find(names, one.name) == names.end(); });
  Table table = assembled(std::move(cases), std::move(columns), {&ours, &peers});
  table.chapters = own;
  table.asks = "Which hard case does which engine keep stable?";
  table.first = "ours";
  table.others = "other engines";
  table.rescues = false;
  return table;
}

std::array<std::vector<std::string>, 5> passed_by(const Table& table) {
  std::array<std::vector<std::string>, 5> names;
  for (std::size_t row = 0; row < table.cases.size(); ++row) {
    const auto any = [&](std::size_t first, std::size_t end) {
      for (std::size_t column = first; column < end; ++column)
        if (table.passed(row, column)) return true;
      return false;
    };
    bool possible = false;
    for (std::size_t column = table.chapters; column < table.stages.size(); ++column)
      possible = possible || table.at(row, column).possible();
    const bool ours = any(0, table.chapters), engines = any(table.chapters, table.stages.size());
    names[!possible ? 4 : ours && engines ? 3 : engines ? 2 : ours ? 1 : 0].push_back(table.cases[row].name);
  }
  return names;
}

std::string peers_md(const Table& table, const std::filesystem::path& folder) {
  std::string md = table_md(table, folder) + "\n## Who passes what\n\n";
  const auto names = passed_by(table);
  const std::array<const char*, 5> says{"Nobody passes", "Only ours pass", "Only an engine passes",
                                        "One of ours and an engine pass", "No engine has what it asks for"};
  for (std::size_t i = 0; i < names.size(); ++i)
    md += fmt::format("- **{}**, {}: {}.\n", says[i], names[i].size(),
                      names[i].empty() ? "none" : fmt::format("`{}`", fmt::join(names[i], "`, `")));
  return md;
}

}  // namespace pushback
