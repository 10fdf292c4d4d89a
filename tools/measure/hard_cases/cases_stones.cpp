/// Cut and broken stones, as convex hulls: an arch, and a heap of rubble.
#include <cmath>

#include "pushback/common/bodies/random.h"
#include "pushback/common/world/measure.h"
#include "pushback/tools/measure/hard_cases/cases.h"
#include "pushback/tools/measure/hard_cases/standing.h"

namespace pushback {

namespace {

/// A semicircle of wedges on two fixed springers: the radius of its middle line and its arch_thickness, m.
constexpr Real arch_radius = 2, arch_thickness = Real(0.5);
constexpr int voussoirs = 13;

/// A wedge between two radii, `from` and `to` (rad from the right springing), 0.5 m deep.
std::vector<Vec3> wedge(Real from, Real to, Real springing) {
  std::vector<Vec3> points;
  for (const Real angle : {from, to}) {
    for (const Real r : {arch_radius - arch_thickness / 2, arch_radius + arch_thickness / 2}) {
      for (const Real z : {-Real(0.25), Real(0.25)})
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
    world.add(hull(wedge(from, from + part, springing), 100).rough(Real(0.7)));
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

}  // namespace

std::vector<HardCase> stone_cases() {
  HardCase heap =
      must_settle({.name = "rubble",
                   .title = "a heap of rubble",
                   .stresses = "hulls with no two faces alike, on edges and corners: the heap must come to rest",
                   .fill = rubble,
                   .camera = view({0, Real(0.4), 0}, Real(2.6)),
                   .seconds = 10,
                   .overlap = Real(0.2)});  // from 3.5 m they come down with 8 m/s: 0.14 m in a step
  heap.starts = many_starts;
  return {
      must_stand(
          {.name = "arch",
           .title = "arch of 13 wedges",
           .stresses = "stands as long as the thrust stays in the stones: a joint that gives lets all the others turn",
           .fill = arch,
           .camera = view({0, Real(1.65), 0}, Real(3.6)),
           .moved_limit = 20}),  // a hundredth of the radius
      heap};
}

}  // namespace pushback
