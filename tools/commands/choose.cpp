/// ./course choose: a scene of a chapter, or of a file, within an error.
#include "pushback/chapters/27_which_error/choose.h"

#include <algorithm>

#include "pushback/chapters/26_to_each_its_own/scenes.h"
#include "pushback/common/basics/input.h"
#include "pushback/tools/catalogue/catalogue.h"
#include "pushback/tools/measure/adapters/scene_json.h"

using namespace pushback;

namespace {

World moving_scene_in(const std::filesystem::path& file) {
  World world = scene_in(file);
  if (std::none_of(world.bodies.begin(), world.bodies.end(), [](const Body& body) { return body.movable(); }))
    throw InvalidInput(
        fmt::format("{}: no body can move, and one is needed that can: its mass is not null", file.string()));
  return world;
}

}  // namespace

int main(int argc, char** argv) {
  std::vector<Scene> scenes;
  for (const NamedScene& scene : all_scenes()) scenes.push_back({.name = scene.name, .fill = scene.fill});
  scenes.push_back({.name = "26-yard", .fill = to_each_its_own_scenes::Yard{}});
  scenes.push_back({.name = "26-chain", .fill = to_each_its_own_scenes::Chain{}});
  return choose_or_read(scenes, moving_scene_in, argc, argv);
}
