#include "pushback/tools/measure/hard_cases/standing.h"

#include <cmath>

#include "pushback/common/world/measure.h"

namespace pushback {

Stood stand(Play& play, Real seconds, Real dt) {
  const std::vector<Body> start = play.world.bodies;
  Stood stood;
  play.run(seconds - 1, dt);
  play.run(1, dt, [&](const World& world) {
    stood.jitter = std::max(stood.jitter, largest_speed(world));
    stood.kinetic = std::max(stood.kinetic, kinetic_energy(world));
  });
  for (std::size_t i = 0; i < start.size(); ++i) {
    const Vec3 moved = play.world.bodies[i].position - start[i].position;
    stood.drift = std::max(stood.drift, std::hypot(moved.x(), moved.z()));
    stood.moved = std::max(stood.moved, moved.norm());
  }
  stood.beyond = std::max(Real(0), play.watcher().deepest() - slop);
  return stood;
}

Allowance standing(const World& world) {
  Real weight = 0;
  for (const Body& body : world.bodies) weight += body.movable() ? world.gravity.norm() / body.inverse_mass : 0;
  return {.energy = weight * Real(0.001)};
}

HardCase must_stand(const StandingCase& what) {
  HardCase c;
  c.name = what.name;
  c.title = what.title;
  c.stresses = what.stresses;
  const bool anywhere = what.moved_limit > 0;
  c.criteria = {anywhere ? Criterion{"largest displacement after 10 s", "mm", what.moved_limit}
                         : Criterion{"drift after 10 s", "mm", what.drift_limit},
                {"deeper than the slop", "mm", what.beyond_limit},
                {"speed in the last second", "mm/s", 1}};
  c.scene = {.name = what.title, .fill = what.fill, .camera = what.camera, .seconds = 10};
  c.run = [fill = what.fill, anywhere](Trial& trial) -> std::vector<Real> {
    Play play = trial.play(fill, standing);
    const Stood s = stand(play, 10);
    return {1000 * (anywhere ? s.moved : s.drift), 1000 * s.beyond, 1000 * s.jitter};
  };
  return c;
}

HardCase must_settle(const SettlingCase& what) {
  HardCase c;
  c.name = what.name;
  c.title = what.title;
  c.stresses = what.stresses;
  c.criteria = {{"speed in the last second", "mm/s", 1}, {"overlap after 10 s", "mm", 6}};  // the slop and 1 mm
  c.scene = {.name = what.title, .fill = what.fill, .camera = what.camera, .seconds = what.seconds};
  c.run = [fill = what.fill, overlap = what.overlap](Trial& trial) -> std::vector<Real> {
    Play play = trial.play(fill, [overlap](const World& world) {
      Allowance allowance = standing(world);
      allowance.overlap = overlap;
      return allowance;
    });
    const Stood s = stand(play, 10);
    return {1000 * s.jitter, 1000 * deepest_overlap(play.world)};
  };
  return c;
}

void falling_and_sliding(World& world, Real height) {
  stack(world, 3, Real(0.01));
  world.add(box({Real(0.3), Real(0.2), Real(0.3)}, 50).at({-2, height, 2}).moving({3, 0, 0}));
}

Camera view(const Vec3& centre, Real size) {
  const Real far = size * Real(1.15) / (2 * std::tan(Camera{}.field_of_view / 2));
  return {centre + far * Vec3(Real(0.4), Real(0.25), 1).normalized(), centre};
}

}  // namespace pushback
