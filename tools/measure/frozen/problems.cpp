#include "pushback/tools/measure/frozen/problems.h"

#include <algorithm>
#include <functional>

#include "pushback/chapters/04_slop/scenes.h"
#include "pushback/chapters/06_friction/scenes.h"
#include "pushback/chapters/08_friction_cone/scenes.h"
#include "pushback/chapters/10_position_correction/scenes.h"
#include "pushback/chapters/11_substeps/substeps.h"
#include "pushback/chapters/12_soft_contacts/steady_solver.h"
#include "pushback/chapters/16_whole_problem/problem_file.h"
#include "pushback/common/basics/input.h"
#include "pushback/engine/direct/newton_system.h"
#include "pushback/engine/direct/row_matrix.h"
#include "pushback/tools/measure/frozen/scenes.h"

namespace pushback::frozen {

namespace {

constexpr Real h = Real(1) / 60;

/// The scene's contacts after `seconds`.
FrozenProblem frozen(const std::string& name, const std::function<void(World&)>& fill, Real seconds, int parts = 32) {
  World world;
  fill(world);
  Substeps<SteadySolver> solver({}, parts);
  for (int step = 0; static_cast<Real>(step) * h < seconds; ++step) world.step(solver, h);
  world.begin_step(h);
  return {name, problem_of(world), factor_of(world)};
}

}  // namespace

std::vector<FrozenProblem> own_problems() {
  const auto boxes = [](int count) { return [count](World& world) { stack(world, count); }; };
  const auto pyramid_of = [](int base) { return [base](World& world) { pyramid(world, base); }; };
  const auto heavy_on = [](int below, Real ratio) {
    return [below, ratio](World& world) { heavy_on_boxes(world, below, ratio); };
  };
  return {
      frozen("stack of 5", boxes(5), 0),
      frozen("stack of 10", boxes(10), 0),
      frozen("stack of 20", boxes(20), 0),
      frozen("stack of 20 after 1 s", boxes(20), 1),
      frozen("pyramid of 5", pyramid_of(5), 0),
      frozen("pyramid of 10", pyramid_of(10), 0),
      frozen("pyramid of 10 after 1 s", pyramid_of(10), 1),
      frozen("heavy on light 1:100", heavy_on(1, 100), 0),
      frozen("heavy on light 1:1000", heavy_on(1, 1000), 0),
      frozen("heavy on four 1:1000", heavy_on(4, 1000), 0),
      frozen("small pile after 1 s", slop_scenes::SmallPile{}, 1),
      frozen("twelve boxes in each other", position_correction_scenes::boxes_in_each_other, 0),
      frozen("three boxes on a slope", friction_scenes::BoxesOnSlope{}, Real(0.3)),
      frozen(
          "twelve planks sliding",
          [](World& world) { friction_cone_scenes::wheel(world, friction_cone_scenes::longest_half, h); }, Real(0.2)),
      frozen("stack sliding", sliding_stack, 0),
      frozen("impact on a stack", impact_on_stack, 0),
      frozen("card house", card_house, 0),
      frozen("arch of 11 stones", arch, 0),
      frozen("tower of 36 planks", tower_of_planks, 0),
      frozen("wall of 36 bricks after 1 s", brick_wall, 1),
      frozen("pile of 48 shapes after 2 s", shapes_over_tray, 2),
  };
}

std::vector<FrozenProblem> large_problems() {
  std::vector<FrozenProblem> problems;
  for (const int base : {10, 20})
    problems.push_back(frozen(
        fmt::format("pyramid of {} boxes", base * (base + 1) / 2), [base](World& world) { pyramid(world, base); }, 0));
  for (const int side : {4, 6, 10})
    problems.push_back(frozen(
        fmt::format("heap of {} boxes at rest", side * side * side),
        [side](World& world) { heap(world, side, side, Real(-4.5)); }, 12, 8));
  return problems;
}

std::vector<FrozenProblem> foreign_problems(const std::filesystem::path& folder) {
  std::error_code error;
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder, error))
    if (entry.path().extension() == ".dat") files.push_back(entry.path());
  if (error) throw InvalidInput(fmt::format("folder of problems is '{}': {}", folder.string(), error.message()));
  if (files.empty())
    throw InvalidInput(fmt::format("folder of problems is '{}': there is no .dat file in it", folder.string()));
  std::sort(files.begin(), files.end());
  std::vector<FrozenProblem> problems;
  for (const std::filesystem::path& file : files)
    problems.push_back({file.stem().string(), read_problem_file(file), {}, true});
  return problems;
}

}  // namespace pushback::frozen
