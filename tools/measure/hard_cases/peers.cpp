#include "pushback/tools/measure/hard_cases/peers.h"

#include <fmt/ranges.h>

#include <algorithm>

#include "pushback/common/basics/named.h"

namespace pushback {

namespace {

/// Of a stage that plays by its program alone.
struct Elsewhere : StepSolver {
  void solve(World&, Real, int) override { throw InvalidInput("an engine plays by a program of its own"); }
};

}  // namespace

std::vector<Stage> peer_stages(const std::filesystem::path& folder, const std::vector<PeerSetting>& settings) {
  std::vector<Stage> list, best;
  for (const PeerSetting& setting : settings) {
    Stage stage{{setting.name, setting.what, Elsewhere{}, {}}};
    if (!folder.empty()) stage.apart = {folder / ("motion_" + setting.engine), "--setting", setting.name};
    stage.epsilon = setting.epsilon;
    stage.most_starts = peer_starts;
    const std::string title = setting.name.substr(0, setting.name.find(' ')) + best_of_ten;
    if (setting.further && (best.empty() || best.back().name != title)) {
      best.push_back({{title, "on each case the best of the two, and of these", Elsewhere{}, {}}});
      best.back().tries = {list.end()[-1], list.end()[-2]};
      best.back().apart = stage.apart;
      best.back().most_starts = peer_starts;
    }
    if (!setting.further) {
      list.push_back(std::move(stage));
      continue;
    }
    best.back().what += fmt::format("; {}: {}", setting.name, setting.what);
    best.back().tries.push_back(std::move(stage));
  }
  list.insert(list.end(), best.begin(), best.end());
  return list;
}

std::vector<Stage> stages_beside_peers() {
  std::vector<Stage> list{stage_named("07 warm start"),
                          stage_named("22 wide"),
                          stage_named("26 by island"),
                          {{std::string("ours") + best_of_ten, "on each case the best of", Elsewhere{}, {}}}};
  for (const char* name :
       {"26 by island", "22 wide", "21 detected once", "all together", "18 direct joint solve", "19 direct contacts",
        "12 soft contacts", "11 substeps", "09 sequential", "08 friction cone"}) {
    list.back().tries.push_back(stage_named(name));
    list.back().what += fmt::format("{} {}", list.back().tries.size() > 1 ? "," : "", name);
  }
  return list;
}

Table beside_peers(const Table& ours, const Table& peers) {
  std::vector<Stage> columns = stages_beside_peers();
  const std::size_t own = columns.size();
  columns.insert(columns.end(), peers.stages.begin(), peers.stages.end());
  std::vector<HardCase> cases = peers.cases;
  const std::vector<std::string> names = names_of(ours.cases);
  std::erase_if(cases, [&](const HardCase& one) { return std::ranges::find(names, one.name) == names.end(); });
  Table best = empty_table(cases, {columns[own - 1]});
  for (std::size_t row = 0; row < cases.size(); ++row)
    best.outcomes[row] = best_of(cases[row], best.stages[0], [&](const Stage& one) {
      const Outcome* outcome = ours.find(cases[row].name, one.name);
      if (!outcome) throw InvalidInput(fmt::format("{} was never played under {}", cases[row].name, one.name));
      return *outcome;
    });
  Table table = assembled(std::move(cases), std::move(columns), {&best, &ours, &peers});
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
