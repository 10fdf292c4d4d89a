#include "pushback/tools/measure/outside/report.h"

#include <algorithm>

#include "pushback/tools/measure/hard_cases/hard_case.h"
#include "pushback/tools/measure/results/markdown.h"

namespace pushback::outside {

namespace {

class Results {
 public:
  explicit Results(const std::vector<Played>& all) : all_(all) {
    for (const Played& one : all)
      if (std::find(solvers.begin(), solvers.end(), one.solver) == solvers.end()) solvers.push_back(one.solver);
    for (const OutsideScene& scene : outside_scenes())
      if (std::any_of(all.begin(), all.end(), [&](const Played& one) { return one.scene == scene.name; }))
        scenes.push_back(&scene);
  }
  const Played* of(const OutsideScene& scene, const std::string& solver) const {
    const auto found = std::find_if(all_.begin(), all_.end(),
                                    [&](const Played& one) { return one.scene == scene.name && one.solver == solver; });
    return found == all_.end() ? nullptr : &*found;
  }
  /// How many of these fail.
  long failed(const OutsideScene& scene, const std::vector<std::string>& among) const {
    return std::count_if(among.begin(), among.end(), [&](const std::string& solver) {
      const Played* one = of(scene, solver);
      return !one || !one->passed(scene);
    });
  }

  std::vector<std::string> solvers;
  std::vector<const OutsideScene*> scenes;

 private:
  const std::vector<Played>& all_;
};

bool lacks(const Played& one) {
  return one.broken.starts_with(not_possible);
}

std::string number(double value) {
  return value > 0 && value < 1e-6 ? "< 1e-6"
         : value < 100             ? fmt::format("{:.2g}", value)
                                   : fmt::format("{:.0f}", value);
}

std::string outcome(const OutsideScene& scene, const Played& one) {
  if (lacks(one)) return "–";
  const std::string mark = one.passed(scene) ? "✓" : "✗";
  if (!one.broken.empty()) return fmt::format("{} {}", mark, one.broken);
  std::string said = fmt::format("{} {}{}{}", mark, number(one.number), scene.unit.empty() ? "" : " ", scene.unit);
  if (one.gained > 100 * scene.gain) said += ", energy";
  if (one.overlap_median > 100 * scene.half_thickness) said += ", overlap";
  if (one.slope != 0) said += fmt::format(", {:.0f}°", one.slope);
  return said;
}

std::string overlap_and_energy(const OutsideScene&, const Played& one) {
  if (lacks(one) || !one.broken.empty()) return "–";
  return fmt::format("{}, {}; {}", number(one.overlap_median), number(one.overlap_worst), number(one.gained));
}

std::string time_of(const OutsideScene&, const Played& one) {
  return lacks(one) || one.ms_worst == 0 ? "–" : fmt::format("{}, {}", number(one.ms_median), number(one.ms_worst));
}

template <class Cell>
std::string table(const Results& results, const std::string& corner, const Cell& cell) {
  std::vector<std::string> heads{corner};
  heads.insert(heads.end(), results.solvers.begin(), results.solvers.end());
  std::string text = markdown_heads(heads);
  for (const OutsideScene* scene : results.scenes) {
    std::vector<std::string> row{scene->title};
    for (const std::string& solver : results.solvers) {
      const Played* one = results.of(*scene, solver);
      row.push_back(one ? cell(*scene, *one) : "");
    }
    text += markdown_row(row);
  }
  return text;
}

}  // namespace

std::string tables(const std::vector<Played>& all, const std::vector<std::string>& ours) {
  Results results(all);
  std::vector<std::string> others = results.solvers;
  std::erase_if(others, [&](const std::string& one) { return std::find(ours.begin(), ours.end(), one) != ours.end(); });
  const auto lost = [&](const OutsideScene* scene) {  // half a place behind where all others fail, too
    const bool won = results.failed(*scene, others) < static_cast<long>(others.size());
    return 2 * results.failed(*scene, ours) - (won ? 0 : 1);
  };
  std::stable_sort(results.scenes.begin(), results.scenes.end(),
                   [&](const OutsideScene* a, const OutsideScene* b) { return lost(a) > lost(b); });
  return fmt::format("\n{}\n{}\n{}", table(results, "scene, and the number by which it is judged", outcome),
                     table(results, "overlap in mm, median and worst; energy gained in %", overlap_and_energy),
                     table(results, "ms a step, median and worst", time_of));
}

std::string list_of_scenes() {
  std::string text = markdown_heads({"scene", "source", "judged by", "at most"});
  for (const OutsideScene& scene : outside_scenes())
    text += markdown_row({fmt::format("{} (`{}`, {:g} s)", scene.title, scene.name, scene.seconds), scene.source,
                          scene.must, fmt::format("{:g}{}{}", scene.limit, scene.unit.empty() ? "" : " ", scene.unit)});
  return text;
}

}  // namespace pushback::outside
