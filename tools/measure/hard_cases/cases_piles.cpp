/// What stands by friction and balance: stacks, what is built, an arch and a heap of stones; and two at the edge of what holds.
#include <fmt/format.h>

#include <cmath>

#include "pushback/common/bodies/random.h"
#include "pushback/tools/measure/hard_cases/standing.h"
#include "pushback/tools/measure/hard_cases/thinnest_arch.h"

namespace pushback {

namespace {

// ---- one on the other ------------------------------------------------------------------------------------------------

HardCase stack_of(int count, Real drift_limit) {
  const Real height = static_cast<Real>(count);
  return must_stand(
      {.name = fmt::format("stack-{}", count),
       .title = fmt::format("stack of {}", count),
       .stresses = "every contact carries what is above it: convergence, warm starting, ids",
       .scene = seen([count](World& world) { stack(world, count); }, view({0, height / 2, 0}, height + 1), 10),
       .starts = many_starts},
      {drift_up_to(drift_limit), beyond_the_slop(), at_rest()});
}

/// Boxes of 1 m, one on the other, from below.
void stack_weighing(World& world, const std::vector<Real>& masses) {
  world.add(ground());
  for (const Real mass : masses) {
    world.add(box(Vec3::Constant(Real(0.5)), mass).at({0, static_cast<Real>(world.bodies.size()) - Real(0.5), 0}));
  }
}

HardCase heavy_on_light(int ratio) {
  const auto fill = [ratio](World& world) { stack_weighing(world, {100, static_cast<Real>(100 * ratio)}); };
  return must_stand({.name = fmt::format("heavy-{}", ratio),
                     .title = fmt::format("1 : {}, heavy on light", ratio),
                     .stresses = "a sweep passes on 1 / (1 + ratio) of what the lower contact has to learn",
                     .scene = seen(fill, view({0, 1, 0}, Real(2.6)), 10)},
                    {drift_up_to(1), beyond_the_slop(ratio > 100 ? 5 : Real(1)), at_rest()});
}

// ---- what is built ---------------------------------------------------------------------------------------------------

/// A card's length and thickness, m, and how it leans, rad from upright.
constexpr Real card = 1, thickness = Real(0.02), lean = pi / 9;

/// Two cards that lean against each other over x, on feet at height y. Their upper inner edges touch in the plane of x.
///
/// It must stand. With the weight W of a card and a load V on its top, the moments about its foot, the lower inner edge, are
/// balanced by a push N at the top, and friction at the foot balances N:
///
///   N = (W / 2 + V) (tan(lean) - thickness / card) <= mu (W + V)       holds for mu >= tan(lean) = 0.36
///
/// At the top the push is level and the normal is that of a card's face, lean away from it: again mu >= tan(lean).
/// Cards and ground have mu = 0.7.
void tent(World& world, Real x, Real y) {
  for (const Real side : {Real(-1), Real(1)}) {
    const Vec3 foot{x + side * card * std::sin(lean), y, 0};
    const Vec3 up{-side * std::sin(lean), std::cos(lean), 0}, out{side * std::cos(lean), std::sin(lean), 0};
    world.add(box({thickness / 2, card / 2, Real(0.35)}, 5)
                  .turned(side * lean, Vec3::UnitZ())
                  .at(foot + card / 2 * up + thickness / 2 * out)
                  .rough(Real(0.7)));
  }
}

/// Two tents, a card across their tops, a third tent on that.
void card_house(World& world) {
  world.add(ground().rough(Real(0.7)));
  const Real apart = card * std::sin(lean) + Real(0.03);  // half the distance of the two
  const Real top = card * std::cos(lean) + thickness * std::sin(lean);
  tent(world, -apart, 0);
  tent(world, apart, 0);
  world.add(box({card / 2, thickness / 2, Real(0.35)}, 5).at({0, top + thickness / 2, 0}).rough(Real(0.7)));
  tent(world, 0, top + thickness);
}

/// Three blocks a level, across the three below.
void jenga(World& world) {
  world.add(ground());
  for (int level = 0; level < 30; ++level) {
    for (int i = -1; i <= 1; ++i) {
      const Real aside = static_cast<Real>(i) / 2, y = Real(0.15) + Real(0.3) * static_cast<Real>(level);
      if (level % 2 == 0) world.add(box({Real(0.75), Real(0.15), Real(0.24)}, 50).at({0, y, aside}));
      else world.add(box({Real(0.24), Real(0.15), Real(0.75)}, 50).at({aside, y, 0}));
    }
  }
}

/// Ten courses of bricks in running bond, a gap of 2 cm between neighbours, halves at the ends of every other course.
void brick_wall(World& world) {
  world.add(ground());
  for (int course = 0; course < 10; ++course) {
    const Real y = Real(0.25) + Real(0.5) * static_cast<Real>(course);
    const int whole = course % 2 == 0 ? 6 : 5;
    for (int i = 0; i < whole; ++i) {
      const Real x = Real(1.02) * (static_cast<Real>(i) - static_cast<Real>(whole - 1) / 2);
      world.add(box({Real(0.5), Real(0.25), Real(0.25)}, 50).at({x, y, 0}));
    }
    if (course % 2 == 0) continue;
    for (const Real side : {Real(-1), Real(1)}) {
      world.add(box({Real(0.245), Real(0.25), Real(0.25)}, 25).at({side * Real(2.805), y, 0}));
    }
  }
}

/// Five storeys of planks: four on end, two flat across them, two flat across those.
void plank_tower(World& world) {
  world.add(ground());
  constexpr Real x = Real(0.65), z = Real(0.55);
  for (int storey = 0; storey < 5; ++storey) {
    const Real y = Real(1.7) * static_cast<Real>(storey);
    for (const Real side_x : {-x, x}) {
      for (const Real side_z : {-z, z}) {
        world.add(box({Real(0.05), Real(0.75), Real(0.12)}, 10).at({side_x, y + Real(0.75), side_z}));
      }
    }
    for (const Real side : {-x, x})
      world.add(box({Real(0.15), Real(0.05), Real(0.75)}, 10).at({side, y + Real(1.55), 0}));
    for (const Real side : {-z, z})
      world.add(box({Real(0.75), Real(0.05), Real(0.15)}, 10).at({0, y + Real(1.65), side}));
  }
}

// ---- stones ----------------------------------------------------------------------------------------------------------

/// A semicircle of wedges on two fixed springers: the radius of its middle line and its arch_thickness, m.
constexpr Real arch_radius = 2, arch_thickness = Real(0.5);
constexpr int voussoirs = 13;

/// A wedge between two angles, rad from the right springing, and two radii.
std::vector<Vec3> wedge(Real from, Real to, Real inner, Real outer, Real half_depth, Real springing = 0) {
  std::vector<Vec3> points;
  for (const Real angle : {from, to}) {
    for (const Real r : {inner, outer}) {
      for (const Real z : {-half_depth, half_depth})
        points.push_back({r * std::cos(angle), springing + r * std::sin(angle), z});
    }
  }
  return points;
}

/// It must stand: there is a thrust that balances the weights, presses on every joint within its face, and rubs by less
/// than mu. With w the weight of a radian, and as of a ring cut anywhere, let a level push H go through the middle of the
/// crown and the middle of both springings. Moments about a springing give it, with the weight of a half at its centroid:
///
///   H R = w (R pi / 2 - R'),   R' = R (1 + (t / R)^2 / 12)                       H = 0.566 w
///
/// At the angle a from the crown the joint's force is H level and w a upright. Its lever arm about the joint's middle is at
/// most 0.105 R, at a = 58 degrees: within t / 2 = 0.125 R. (Thinner than t = 0.107 R no line fits: Milankovitch 1907.)
/// What rubs is at most H / (w pi / 2) = 0.36 of what presses, at the springing: below mu = 0.7.
void arch(World& world) {
  constexpr Real springing = 1;
  world.add(ground());
  for (const Real side : {Real(-1), Real(1)}) {
    const Vec3 half{arch_thickness / 2 + Real(0.15), springing / 2, Real(0.4)};
    world.add(box(half, 1).fixed().at({side * arch_radius, springing / 2, 0}).rough(Real(0.7)));
  }
  for (int i = 0; i < voussoirs; ++i) {
    const Real part = pi / voussoirs, from = part * static_cast<Real>(i);
    const std::vector<Vec3> points = wedge(from, from + part, arch_radius - arch_thickness / 2,
                                           arch_radius + arch_thickness / 2, Real(0.25), springing);
    world.add(hull(points, 100).rough(Real(0.7)));
  }
}

/// Twenty stones of 12 random points on a sphere of 0.4 m each, four a layer, let fall on one another.
void rubble(World& world) {
  world.add(ground());
  Random random(20);
  for (int i = 0; i < 20; ++i) {
    std::vector<Vec3> points;
    for (int k = 0; k < 12; ++k) points.push_back(Real(0.4) * random.direction());
    const int layer = i / 4;
    const Vec3 place{i % 2 == 0 ? -Real(0.4) : Real(0.4), Real(0.5) + Real(0.85) * static_cast<Real>(layer),
                     i % 4 < 2 ? -Real(0.4) : Real(0.4)};
    world.add(hull(points, 100).at(place));
  }
}

// ---- tan(theta) ------------------------------------------------------------------------------------------------------------

constexpr Real slope_angle = 30 * pi / 180;                                           // rad
constexpr Real half_wide = Real(0.5), half_high = Real(0.1), box_depth = Real(1e-5);  // m
constexpr int boxes_high = 3;

/// Flat boxes of 1 m x 0.2 m on each other, mu = 1.001 tan(theta), each 0.01 mm deep, so that all corners touch from the start. They
/// stick, as mu > tan(theta). They do not topple: the weight's line leaves the base by 0.3 m tan(theta) = 0.17 m from its middle, and
/// it reaches to 0.5 m. The slope falls along x, as one of the two tangents of each contact does, so a pyramid of friction is as
/// strong there as the cone.
void stack_on_slope(World& world) {
  const Real mu = Real(1.001) * std::tan(slope_angle);
  const Vec3 up{-std::sin(slope_angle), std::cos(slope_angle), 0};
  world.add(half_space(up).rough(mu));
  for (int i = 0; i < boxes_high; ++i) {
    const auto level = static_cast<Real>(i);
    world.add(box({half_wide, half_high, half_wide}, 100)
                  .turned(slope_angle, Vec3::UnitZ())
                  .at((half_high * (2 * level + 1) - box_depth * (level + 1)) * up)
                  .rough(mu));
  }
}

/// mm, that the lowest and the highest box have moved after ten minutes, 36,000 steps. What has slid by a metre has failed, and is
/// not followed further.
std::vector<Real> ten_minutes_on_the_slope(Trial& trial) {
  Play play = trial.play(stack_on_slope, standing);
  const Vec3 lowest = play.world.bodies[1].position, highest = play.world.bodies[boxes_high].position;
  const auto moved = [&](int body, const Vec3& from) {
    return (play.world.bodies[static_cast<std::size_t>(body)].position - from).norm();
  };
  for (int second = 0; second < 600 && moved(boxes_high, highest) < 1; ++second) play.run(1);
  return {1000 * moved(1, lowest), 1000 * moved(boxes_high, highest)};
}

// ---- an arch -----------------------------------------------------------------------------------------------------------------

constexpr int wedges = 13;
constexpr Real mean_radius = 10;  // m: a slop of 5 mm is a tenth of what 5 % of the thickness are

/// A semicircle that stands with both ends on the ground: `part` of the thickness that is the least with which it can. mu = 1, and no
/// joint asks for more than 0.4.
void thin_arch(World& world, Real part) {
  const Real half = part * thinnest_arch(wedges).thickness * mean_radius / 2;
  world.add(ground().rough(1));
  const auto joint = [](int i) { return pi / wedges * static_cast<Real>(i); };
  for (int i = 0; i < wedges; ++i)
    world.add(hull(wedge(joint(i), joint(i + 1), mean_radius - half, mean_radius + half, 1), 1000).rough(1));
}

/// The thick one may move by half of what it is thicker than the least. The crown of the thin one must come down by half the
/// radius in 10 s; it is followed until then, so that nothing strikes the ground.
std::vector<Real> thick_and_thin(Trial& trial) {
  constexpr Real above = Real(1.05), below = Real(0.95);
  Play stands = trial.play([](World& world) { thin_arch(world, above); }, standing);
  const Stood stood = stand(stands, 10);
  Play falls = trial.play([](World& world) { thin_arch(world, below); }, striking(Real(0.5)));  // stones, on each other
  const auto left = [&] { return falls.world.bodies[1 + wedges / 2].position.y() - mean_radius / 2; };
  for (int i = 0; i < 100 && left() > 0; ++i) falls.run(Real(0.1));
  return {1000 * stood.moved, 1000 * stood.jitter, std::max(Real(0), left())};
}

}  // namespace

std::vector<HardCase> stack_cases() {
  return {stack_of(10, 1),
          stack_of(20, 1),
          stack_of(40, 5),
          must_stand({.name = "pyramid-20",
                      .title = "pyramid of base 20",
                      .stresses = "210 boxes, each on two and under two: loads that spread and go back",
                      .scene = seen([](World& world) { pyramid(world, 20); }, view({0, Real(9.5), 0}, 21), 10)},
                     {drift_up_to(5),
                      beyond_the_slop(),
                      at_rest(),
                      {{"kinetic energy in the last second", "mJ", 10}, &Stood::kinetic}}),  // all boxes at 1 mm/s
          heavy_on_light(1),
          heavy_on_light(10),
          heavy_on_light(100),
          heavy_on_light(1000),
          must_stand({.name = "densities-1-1-100",
                      .title = "densities 1, 1, 100",
                      .stresses = "warm starting under a large ratio: it must not pump energy in",
                      .scene = seen([](World& world) { stack_weighing(world, {100, 100, 10000}); },
                                    view({0, Real(1.5), 0}, Real(3.6)), 10)},
                     {drift_up_to(1),
                      beyond_the_slop(),
                      at_rest(),
                      {{"energy gained", "J", 1}, &Stood::gained}})};  // lifts the three by 0.01 mm
}

std::vector<HardCase> pile_cases() {
  return {must_stand({.name = "card-house",
                      .title = "card house",
                      .stresses = "leaning plates held by friction alone, 1 : 50 thin",
                      .scene = seen(card_house, view({0, 1, 0}, Real(2.3)), 10)},
                     {displaced_up_to(20), beyond_the_slop(), at_rest()}),  // the thickness of a card
          must_stand({.name = "jenga-30",
                      .title = "Jenga, 30 levels",
                      .stresses = "nine pairs a level carry one load: many ways to share it, one tower",
                      .scene = seen(jenga, view({0, Real(4.5), 0}, Real(9.6)), 10)},
                     {drift_up_to(5), beyond_the_slop(), at_rest()}),
          must_stand({.name = "brick-wall",
                      .title = "brick wall",
                      .stresses = "running bond: each brick on two, many columns that must agree",
                      .scene = seen(brick_wall, view({0, Real(2.5), 0}, Real(5.4)), 10)},
                     {drift_up_to(5), beyond_the_slop(), at_rest()}),
          must_stand({.name = "plank-tower",
                      .title = "tower of planks",
                      .stresses = "slender uprights between thin plates: what tilts a little falls",
                      .scene = seen(plank_tower, view({0, Real(4.25), 0}, Real(8.5)), 10)},
                     {drift_up_to(5), beyond_the_slop(), at_rest()})};
}

std::vector<HardCase> stone_cases() {
  return {
      must_stand(
          {.name = "arch",
           .title = "arch of 13 wedges",
           .stresses = "stands as long as the thrust stays in the stones: a joint that gives lets all the others turn",
           .scene = seen(arch, view({0, Real(1.65), 0}, Real(3.6)), 10)},
          {displaced_up_to(20), beyond_the_slop(), at_rest()}),  // a hundredth of the radius
      must_settle({.name = "rubble",
                   .title = "a heap of rubble",
                   .stresses = "hulls with no two faces alike, on edges and corners: the heap must come to rest",
                   .scene = seen(rubble, view({0, Real(0.4), 0}, Real(2.6)), 10),
                   .starts = many_starts},
                  Real(0.2))};  // from 3.5 m they come down with 8 m/s: 0.14 m in a step
}

std::vector<HardCase> edge_cases() {
  return {{.name = "tan-theta",
           .title = "ten minutes at tan(theta)",
           .stresses = "friction a thousandth above what three boxes on a slope need: the least creep adds up",
           .criteria = {{"lowest box after 10 minutes", "mm", Real(1.7)},  // 10 mm an hour
                        {"highest box after 10 minutes", "mm", Real(1.7)}},
           .scene = seen(stack_on_slope, view({0, Real(0.3), 0}, Real(1.8)), 0),
           .run = ten_minutes_on_the_slope},
          {.name = "milankovitch",
           .title = "as thin as an arch may be",
           .stresses = "stands with 1.05 of the least thickness that has a line of thrust, and falls with 0.95 of it",
           .criteria = {{"1.05: largest displacement after 10 s", "mm", 25},
                        {"1.05: speed in the last second", "mm/s", 1},
                        {"0.95: crown above half the radius after 10 s", "m", 0}},
           .scene = seen([](World& world) { thin_arch(world, Real(0.95)); }, view({0, 5, 0}, 21), 5),
           .run = thick_and_thin}};
}

}  // namespace pushback
