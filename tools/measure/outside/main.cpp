/// ./course run outside: scenes that others made, and large ones, by our presets and by the engines that were built.
#include <algorithm>
#include <filesystem>

#include "pushback/common/basics/files.h"
#include "pushback/common/basics/process.h"
#include "pushback/common/experiment/program.h"
#include "pushback/engine/presets.h"
#include "pushback/tools/measure/hard_cases/peers.h"
#include "pushback/tools/measure/outside/report.h"
#include "pushback/tools/measure/results/csv.h"
#include "pushback/tools/measure/results/machine.h"

using namespace pushback;
using namespace pushback::outside;
namespace fs = std::filesystem;

namespace {

struct WithinAMillimetre : Recommended {
  WithinAMillimetre() { error = Real(1e-3); }
};

std::vector<Stage> our_stages() {
  return {{{"Fast", "8 substeps in float", Fast{}, {}}},
          {{"Recommended", "each island its own step", Recommended{}, {}}},
          {{"Recommended, 1 mm", "with an error asked of 1 mm", WithinAMillimetre{}, {}}}};
}

/// By a program of its own, which may crash or never end.
Played played_apart(const fs::path& program, const OutsideScene& scene, const PeerSetting& setting, double at_most) {
  const Ended ended = run_program({program.string(), scene.name, setting.name, fmt::format("{}", at_most)},
                                  10 * at_most);  // it looks at the scene as well
  Played played{.scene = scene.name, .solver = setting.name};
  if (ended.status == 0) return read_lines(fmt::format("{}\n{}", heading, ended.out)).at(0);
  played.broken = ended.out_of_time ? fmt::format("took more than {} s", at_most) : "crashed";
  return played;
}

std::vector<const OutsideScene*> scenes_named(const std::vector<std::string>& names) {
  std::vector<const OutsideScene*> list;
  for (const OutsideScene& scene : outside_scenes())
    if (names.empty() || std::find(names.begin(), names.end(), scene.name) != names.end()) list.push_back(&scene);
  for (const std::string& name : names) scene_named(name);  // throws
  return list;
}

std::vector<Played> played(const std::vector<const OutsideScene*>& scenes, const std::vector<Stage>& stages,
                           double at_most) {
  const fs::path programs = fs::canonical("/proc/self/exe").parent_path();
  std::vector<Played> all;
  const auto keep = [&all](const Played& one) {
    fmt::print(stderr, "{}", line_of(one));
    all.push_back(one);
  };
  for (const OutsideScene* scene : scenes) {
    for (const Stage& stage : stages) keep(play(*scene, stage, at_most));
    for (const PeerSetting& setting : peer_settings())
      if (const fs::path program = programs / ("outside_" + setting.engine); !setting.further && fs::exists(program))
        keep(played_apart(program, *scene, setting, at_most));
  }
  return all;
}

}  // namespace

int main(int argc, char** argv) {
  CommandLine line("Scenes that others made, and large ones, by our presets and by the engines that were built.");
  std::vector<std::string> names;
  std::string out = "renders/here", from;
  double at_most = 60;
  line.option("SCENE", names, "Only these scenes");
  line.option("--out", out, "The folder to write to").shows_default();
  line.option("--from", from, "Play nothing, and make the tables from this scenes_from_outside.csv");
  line.option("--at-most", at_most, "Time after which a solver gives up a scene, s")
      .between(1.0, 3600.0)
      .shows_default();
  return line.run(argc, argv, [&] {
    const fs::path folder = fs::path(out) / "outside";
    make_writable_folder(folder);
    const std::string load = load_now();
    const std::vector<Stage> stages = our_stages();
    const std::vector<Played> all =
        from.empty() ? played(scenes_named(names), stages, at_most) : read_lines(read_text_file(from));
    std::vector<std::string> ours;
    for (const Stage& stage : stages) ours.push_back(stage.name);
    std::string text = fmt::format("{}{}", list_of_scenes(), tables(all, ours));
    if (from.empty()) text += fmt::format("\nLoad of the machine before and after: {} and {}.\n", load, load_now());
    write_text_file(folder / "scenes_from_outside.csv", text_of(all));
    write_text_file(folder / "scenes_from_outside.md", text);
    fmt::print("{}", text);
  });
}
