#include "pushback/tools/measure/study/held_motions.h"

#include <cmath>

namespace pushback::further {

namespace {

/// m, c: from a jaw's edge to its centre, half a diagonal of its square.
const Real to_edge = std::sqrt(Real(2)) * Grasp::half_side;

/// Where the bodies are after each of so many frames if they stay where `fill` puts them.
std::vector<Places> staying(const std::function<void(World&)>& fill, int frames) {
  World world;
  fill(world);
  Places places;
  for (const Body& body : world.bodies) places.emplace_back(body.position.cast<double>());
  return std::vector<Places>(static_cast<std::size_t>(frames), places);
}

}  // namespace

Real Grasp::friction_needed() const {
  return load * height / (2 * jaw * (out + to_edge) + load * out);
}

void Grasp::operator()(World& world) const {
  world.add(ground().at({0, -to_floor, 0}).rough(mu));
  for (const Real side : {Real(-1), Real(1)})
    world.add(box({half_side, half_side, Real(0.1)}, jaw)
                  .turned(pi / 4, Vec3::UnitZ())
                  .at({side * (half + to_edge), -height, 0})
                  .rough(mu));
  world.add(box({half, half, Real(0.15)}, load).at({0, -height - contact_at, 0}).rough(mu));
}

std::vector<Pin> Grasp::pins() const {
  return {{the_world, 1, {out - half, 0, 0}}, {the_world, 2, {half - out, 0, 0}}};
}

std::vector<Places> Grasp::truth(int frames) const {
  return staying(*this, frames);
}

void PileOfHulls::operator()(World& world) const {
  constexpr Real uncut = half_width - cut;
  std::vector<Vec3> corners;
  for (const Real y : {-high / 2, high / 2})
    for (const Real x : {Real(-1), Real(1)})
      for (const Real z : {Real(-1), Real(1)}) {
        corners.push_back({x * half_width, y, z * uncut});
        corners.push_back({x * uncut, y, z * half_width});
      }
  const Body block = hull(corners, mass);  // all share its solid
  world.add(ground());
  for (int layer = 0; layer < base; ++layer) {
    const int across = base - layer;
    const Real first = -static_cast<Real>(across - 1) / 2;
    for (int i = 0; i < across * across; ++i) {
      const Vec3 place{(first + static_cast<Real>(i % across)) * apart, (static_cast<Real>(layer) + Real(0.5)) * high,
                       (first + static_cast<Real>(i / across)) * apart};
      world.add(Body(block).at(place));
    }
  }
}

std::vector<Places> PileOfHulls::truth(int frames) const {
  return staying(*this, frames);
}

}  // namespace pushback::further
