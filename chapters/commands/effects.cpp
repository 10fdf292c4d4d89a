/// ./course effects: what each scene calls for, and why.
#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "pushback/chapters/15_only_what_is_needed/questions.h"
#include "pushback/chapters/catalogue.h"
#include "pushback/common/basics/input.h"

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
  CLI::App app{"What a scene calls for, and why."};
  std::vector<std::string> wanted{"all"};
  app.add_option("scene", wanted, "Scenes by name, or all")->capture_default_str();
  app.footer("The scenes: " + names_of(scenes));
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& problem) {
    return app.exit(problem) == 0 ? 0 : 2;
  }
  std::vector<NamedScene> chosen;
  try {
    for (const std::string& name : wanted) {
      if (name != "all") chosen.push_back(scene_of(scenes, name));
    }
  } catch (const InvalidInput& problem) {
    fmt::print(stderr, "{}, or all\n", problem.what());
    return 2;
  }
  if (std::find(wanted.begin(), wanted.end(), "all") != wanted.end()) chosen = scenes;
  for (const NamedScene& scene : chosen) print(scene);
  if (chosen.size() > 1) {
    fmt::print("\n");
    print_table(chosen);
  }
  return 0;
}
