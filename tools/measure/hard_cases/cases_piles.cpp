/// What is built: it stands by friction and balance, and falls where either is not quite right.
#include <cmath>

#include "pushback/tools/measure/hard_cases/cases.h"
#include "pushback/tools/measure/hard_cases/standing.h"

namespace pushback {

namespace {

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

}  // namespace

std::vector<HardCase> pile_cases() {
  return {must_stand({.name = "card-house",
                      .title = "card house",
                      .stresses = "leaning plates held by friction alone, 1 : 50 thin",
                      .fill = card_house,
                      .camera = view({0, 1, 0}, Real(2.3)),
                      .moved_limit = 20}),  // the thickness of a card
          must_stand({.name = "jenga-30",
                      .title = "Jenga, 30 levels",
                      .stresses = "nine pairs a level carry one load: many ways to share it, one tower",
                      .fill = jenga,
                      .camera = view({0, Real(4.5), 0}, Real(9.6)),
                      .drift_limit = 5}),
          must_stand({.name = "brick-wall",
                      .title = "brick wall",
                      .stresses = "running bond: each brick on two, many columns that must agree",
                      .fill = brick_wall,
                      .camera = view({0, Real(2.5), 0}, Real(5.4)),
                      .drift_limit = 5}),
          must_stand({.name = "plank-tower",
                      .title = "tower of planks",
                      .stresses = "slender uprights between thin plates: what tilts a little falls",
                      .fill = plank_tower,
                      .camera = view({0, Real(4.25), 0}, Real(8.5)),
                      .drift_limit = 5})};
}

}  // namespace pushback
