/// ./course effects: which effects each scene needs, which step each of its islands gets, and why.
#include "pushback/common/basics/named.h"
#include "pushback/common/experiment/program.h"
#include "pushback/engine/islands/scene_questions.h"
#include "pushback/tools/catalogue/catalogue.h"

using namespace pushback;

namespace {

struct SceneAnswers {
  std::string name;
  std::vector<NamedAnswer> effects;
  std::vector<StepAnswer> steps;

  explicit SceneAnswers(const NamedScene& scene) : name(scene.name) {
    World world;
    scene.fill(world);
    effects = effects_of(world);
    steps = steps_of(world);
  }
};

void print(const SceneAnswers& scene) {
  fmt::print("{}\n", scene.name);
  for (const NamedAnswer& effect : scene.effects)
    fmt::print("  {:<4} {:<16} {}\n", effect.answer.yes ? "yes" : "-", effect.name, effect.answer.because);
  if (scene.steps.empty()) return;
  fmt::print("\n  bodies  islands  step        because\n");
  for (const StepAnswer& step : scene.steps)
    fmt::print("  {:>6}  {:>7}  {:<10}  {}\n", step.bodies.size(), step.islands, name_of(step.step), step.because);
}

/// The movable bodies of a scene that get this step.
std::size_t bodies_by(StepType step, const SceneAnswers& scene) {
  std::size_t bodies = 0;
  for (const StepAnswer& answer : scene.steps) bodies += answer.step == step ? answer.bodies.size() : 0;
  return bodies;
}

/// One line a scene.
void print_table(const std::vector<SceneAnswers>& scenes) {
  constexpr StepType steps[] = {StepType::flight, StepType::half_steps, StepType::substeps};
  fmt::print("{:<18}", "scene");
  for (const NamedAnswer& effect : effects_of(World{})) fmt::print("  {}", effect.name);
  for (const StepType step : steps) fmt::print("  {}", name_of(step));
  for (const SceneAnswers& scene : scenes) {
    fmt::print("\n{:<18}", scene.name);
    for (const NamedAnswer& effect : scene.effects)
      fmt::print("  {:<{}}", effect.answer.yes ? "yes" : "-", effect.name.size());
    for (const StepType step : steps)
      fmt::print("  {:>{}}", bodies_by(step, scene), std::string_view(name_of(step)).size());
  }
  fmt::print("\n");
}

}  // namespace

int main(int argc, char** argv) {
  const std::vector<NamedScene> scenes = all_scenes();
  CommandLine line(
      "Which effects a scene needs, which step each of its islands gets in the first step of `Recommended`, and why.");
  std::vector<std::string> wanted{"all"};
  line.option("scene", wanted, "Scenes by name, or all").shows_default();
  line.ends_with(fmt::format("The scenes: {}", fmt::join(names_of(scenes), ", ")));
  return line.run(argc, argv, [&] {
    std::vector<NamedScene> chosen;
    for (const std::string& name : wanted)
      if (name != "all") chosen.push_back(named("scene", scenes, name));
    if (chosen.size() < wanted.size()) chosen = scenes;
    std::vector<SceneAnswers> answers;
    for (const NamedScene& scene : chosen) print(answers.emplace_back(scene));
    if (answers.size() > 1) {
      fmt::print("\n");
      print_table(answers);
    }
  });
}
