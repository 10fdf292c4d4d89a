/// ./course effects: what each scene calls for, and why.
#include "pushback/chapters/20_only_what_is_needed/questions.h"
#include "pushback/common/basics/named.h"
#include "pushback/common/experiment/program.h"
#include "pushback/tools/catalogue/catalogue.h"

using namespace pushback;

namespace {

void print(const NamedScene& scene) {
  World world;
  scene.fill(world);
  fmt::print("{}\n", scene.name);
  for (const NamedAnswer& effect : effects_of(world))
    fmt::print("  {:<4} {:<16} {}\n", effect.answer.yes ? "yes" : "-", effect.name, effect.answer.because);
}

/// One line a scene.
void print_table(const std::vector<NamedScene>& scenes) {
  fmt::print("{:<18}", "scene");
  for (const NamedAnswer& effect : effects_of(World{})) fmt::print("  {}", effect.name);
  for (const NamedScene& scene : scenes) {
    World world;
    scene.fill(world);
    fmt::print("\n{:<18}", scene.name);
    for (const NamedAnswer& effect : effects_of(world))
      fmt::print("  {:<{}}", effect.answer.yes ? "yes" : "-", effect.name.size());
  }
  fmt::print("\n");
}

}  // namespace

int main(int argc, char** argv) {
  const std::vector<NamedScene> scenes = all_scenes();
  CommandLine line("What a scene calls for, and why.");
  std::vector<std::string> wanted{"all"};
  line.option("scene", wanted, "Scenes by name, or all").shows_default();
  line.ends_with(fmt::format("The scenes: {}", fmt::join(names_of(scenes), ", ")));
  return line.run(argc, argv, [&] {
    std::vector<NamedScene> chosen;
    for (const std::string& name : wanted)
      if (name != "all") chosen.push_back(named("scene", scenes, name));
    if (chosen.size() < wanted.size()) chosen = scenes;
    for (const NamedScene& scene : chosen) print(scene);
    if (chosen.size() > 1) {
      fmt::print("\n");
      print_table(chosen);
    }
  });
}
