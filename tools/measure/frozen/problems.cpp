#include "pushback/tools/measure/frozen/frozen.h"

#include <algorithm>
#include <functional>
#include <random>

#include "pushback/chapters/04_slop/scenes.h"
#include "pushback/chapters/06_friction/scenes.h"
#include "pushback/chapters/08_friction_cone/scenes.h"
#include "pushback/chapters/10_position_correction/scenes.h"
#include "pushback/chapters/11_substeps/substeps.h"
#include "pushback/chapters/12_soft_contacts/steady_solver.h"
#include "pushback/chapters/16_whole_problem/problem_file.h"
#include "pushback/common/basics/input.h"
#include "pushback/common/world/situations.h"
#include "pushback/engine/direct/newton_system.h"
#include "pushback/engine/direct/row_matrix.h"

namespace pushback::frozen {

namespace {

// ---- what is hard for sweeps: what leans, wedges, spans and lies about ----

constexpr Real into_each_other = Real(1e-4);  // m, so that neighbours touch whatever rounding says

/// `mass_ratio` times the mass of a box of 100 kg, on `boxes_below` of them.
void heavy_on_boxes(World& world, int boxes_below, Real mass_ratio) {
  stack(world, boxes_below);
  world.add(box(Vec3::Constant(Real(0.5)), 100 * mass_ratio).at({0, Real(0.5) + static_cast<Real>(boxes_below), 0}));
}

void sliding_stack(World& world) {
  stack(world, 5);
  for (Body& body : world.bodies)
    if (body.movable()) body.moving({3, 0, 1});
}

/// A stack of ten, and something heavy that has just reached its seventh box from the side.
void impact_on_stack(World& world) {
  stack(world, 10);
  constexpr Real radius = Real(0.4);
  world.add(sphere(radius, 300).at({Real(0.5) + radius - into_each_other, Real(6.6), Real(0.1)}).moving({-8, 0, 1}));
}

/// Two cards of 2 m that lean against each other, their upper edges where x is `x`, their feet at `floor`. Returns how high they are.
Real leaning_pair(World& world, Real x, Real floor) {
  constexpr Real thick = Real(0.04), high = 1, lean = Real(0.3);  // m, m: halves; rad
  const Real reach = thick * std::cos(lean) + high * std::sin(lean) - into_each_other / 2;
  const Real middle = thick * std::sin(lean) + high * std::cos(lean);
  for (const Real side : {Real(-1), Real(1)})
    world.add(box({thick, high, Real(0.7)}, 2)
                  .turned(side * lean, Vec3::UnitZ())
                  .at({x + side * reach, floor + middle - into_each_other, 0})
                  .rough(Real(0.8)));
  return 2 * (middle - into_each_other);
}

/// Two pairs, a card across them, a pair on that.
void card_house(World& world) {
  constexpr Real apart = Real(0.72), thick = Real(0.04);
  world.add(ground().rough(Real(0.8)));
  leaning_pair(world, -apart, 0);
  const Real roof = leaning_pair(world, apart, 0);
  world.add(box({Real(1.3), thick, Real(0.7)}, 2).at({0, roof + thick - into_each_other, 0}).rough(Real(0.8)));
  leaning_pair(world, 0, roof + 2 * thick - into_each_other);
}

/// Half a circle of eleven stones on the ground, 4 m wide within; each presses on its neighbours as a wedge does.
void arch(World& world) {
  constexpr int stones = 11;
  constexpr Real inner = 2, outer = Real(2.6), half_depth = Real(0.4);
  world.add(ground().rough(Real(0.7)));
  for (int i = 0; i < stones; ++i) {
    std::vector<Vec3> corners;
    const Real more = into_each_other / inner;  // rad
    for (const Real angle : {pi * static_cast<Real>(i) / stones - more, pi * static_cast<Real>(i + 1) / stones + more})
      for (const Real radius : {inner, outer})
        for (const Real z : {-half_depth, half_depth})
          corners.push_back({radius * std::cos(angle), radius * std::sin(angle), z});
    world.add(hull(corners, 100).rough(Real(0.7)));
  }
}

/// Layers of three planks, each layer across the one below.
void tower_of_planks(World& world) {
  constexpr Real half = Real(0.1);
  world.add(ground());
  for (int layer = 0; layer < 12; ++layer)
    for (int i = -1; i <= 1; ++i) {
      const bool along = layer % 2 == 0;
      const Real y = half + static_cast<Real>(layer) * (2 * half - into_each_other) - into_each_other;
      const Real aside = static_cast<Real>(i) * Real(0.6);
      world.add(box(along ? Vec3(Real(0.8), half, half) : Vec3(half, half, Real(0.8)), 20)
                    .at(along ? Vec3(0, y, aside) : Vec3(aside, y, 0)));
    }
}

/// Bricks in courses of five and four, each on two; they do not touch their neighbours.
void brick_wall(World& world) {
  const Vec3 half(Real(0.48), Real(0.25), Real(0.25));
  world.add(ground());
  for (int course = 0; course < 8; ++course)
    for (int i = 0; i < 5 - course % 2; ++i)
      world.add(box(half, 50).at({static_cast<Real>(i) + Real(course % 2) / 2 - 2,
                                  half.y() + static_cast<Real>(course) * (2 * half.y() - into_each_other), 0}));
}

/// Boxes, balls, capsules and pointed stones let go above a tray.
void shapes_over_tray(World& world) {
  constexpr Real side = Real(1.6);
  std::mt19937 random(14);
  const auto between = [&](Real low, Real high) {
    return low + (high - low) * static_cast<Real>(random() % 1024) / 1023;
  };
  world.add(ground());
  for (const Vec3& inwards : {Vec3(1, 0, 0), Vec3(-1, 0, 0), Vec3(0, 0, 1), Vec3(0, 0, -1)}) {
    const Vec3 along = Vec3(1, 0, 1) - inwards.cwiseAbs();
    world.add(box(Real(0.2) * Vec3(1, 0, 1) + side * along + Vec3(0, 1, 0), 1)
                  .fixed()
                  .at(Vec3(0, 1, 0) - (side + Real(0.2)) * inwards));
  }
  for (int i = 0; i < 48; ++i) {
    const Real size = between(Real(0.22), Real(0.36)), mass = between(20, 80), angle = between(0, 3);
    const Real x = between(-1, 1), y = between(Real(0.1), 1), z = between(-1, 1);  // in this order, whoever compiles it
    const int column = i % 4, row = i / 4 % 4, layer = i / 16;
    const auto place = [](int which) { return Real(0.75) * static_cast<Real>(which) - Real(1.125); };
    Body body = sphere(size, mass);
    if (column == 0) body = box({size, size * Real(0.7), size * Real(0.8)}, mass);
    if (column == 2) body = capsule(size / 2, size / 2, mass);
    if (column == 3)
      body = hull({{size, 0, 0}, {-size, 0, 0}, {0, size, 0}, {0, -size, 0}, {0, 0, size}, {0, 0, -size}}, mass);
    body.turned(angle, Vec3(x, y, z).normalized());
    world.add(body.at({place(column), Real(0.6) + Real(0.9) * static_cast<Real>(layer), place(row)}));
  }
}

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
    problems.push_back({file.stem().string(), read_problem_file(file), {}});
  return problems;
}

}  // namespace pushback::frozen
