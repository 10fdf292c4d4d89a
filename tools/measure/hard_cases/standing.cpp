#include "pushback/tools/measure/hard_cases/standing.h"

#include <cmath>

#include "pushback/common/world/measure.h"

namespace pushback {

Camera view(const Vec3& centre, Real size) {
  const Real far = size * Real(1.15) / (2 * std::tan(Camera{}.field_of_view / 2));
  return {centre + far * Vec3(Real(0.4), Real(0.25), 1).normalized(), centre};
}

Scene seen(std::function<void(World&)> fill, const Camera& camera, Real seconds) {
  return {.name = "", .fill = std::move(fill), .camera = camera, .seconds = seconds};
}

Allowance standing(const World& world) {
  Real weight = 0;
  for (const Body& body : world.bodies) weight += body.movable() ? world.gravity.norm() / body.inverse_mass : 0;
  return {.energy = weight * Real(0.001)};
}

AllowanceOf lifting(Real height) {
  return [height](const World& world) {
    Allowance allowance = standing(world);
    allowance.energy *= height / Real(0.001);
    return allowance;
  };
}

AllowanceOf striking(Real overlap) {
  return [overlap](const World& world) {
    Allowance allowance = standing(world);
    allowance.overlap = overlap;
    return allowance;
  };
}

AllowanceOf bouncing(const Allowance& other) {
  return [other](const World& world) {
    Allowance allowance = other;
    allowance.energy = kinetic_energy(world) / 1000;
    return allowance;
  };
}

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
  stood.gained = play.watcher().energy_gained();
  return stood;
}

HardCase must_stand(HardCase what, const std::vector<Asked>& asked, const std::function<Stood(Trial&)>& how) {
  for (const Asked& one : asked) what.criteria.push_back(one.criterion);
  what.run = [asked, how](Trial& trial) {
    const Stood stood = how(trial);
    std::vector<Real> numbers;
    for (const Asked& one : asked)
      numbers.push_back(one.criterion.unit == "J" ? stood.*one.number : 1000 * stood.*one.number);
    return numbers;
  };
  return what;
}

HardCase must_stand(HardCase what, const std::vector<Asked>& asked, Real seconds, Real dt) {
  const auto how = [fill = what.scene.fill, seconds, dt](Trial& trial) {
    Play play = trial.play(fill, standing);
    return stand(play, seconds, dt);
  };
  return must_stand(std::move(what), asked, how);
}

HardCase must_settle(HardCase what, Real overlap) {
  what.criteria = {{"speed in the last second", "mm/s", 1}, {"overlap after 10 s", "mm", 6}};  // the slop and 1 mm
  what.run = [fill = what.scene.fill, overlap](Trial& trial) -> std::vector<Real> {
    Play play = trial.play(fill, striking(overlap));
    const Stood s = stand(play, 10);
    return {1000 * s.jitter, 1000 * deepest_overlap(play.world)};
  };
  return what;
}

void falling_and_sliding(World& world, Real height) {
  stack(world, 3, Real(0.01));
  world.add(box({Real(0.3), Real(0.2), Real(0.3)}, 50).at({-2, height, 2}).moving({3, 0, 0}));
}

Real farthest_apart(Play& one, Play& other, const Vec3& shift) {
  return 1000 * one.largest(5, [&](const World& world) {
    other.step();
    Real apart = 0;
    for (std::size_t i = 0; i < world.bodies.size(); ++i)
      apart = std::max(apart, (other.world.bodies[i].position - shift - world.bodies[i].position).norm());
    return apart;
  });
}

Real gap_of(const World& world, const Joint& joint) {
  Equations equations;
  joint.ask(body_of(world, joint.a), body_of(world, joint.b), {world.time, frame}, equations);
  Real squared = 0;
  for (const Equation& equation : equations)
    squared += equation.jacobian.n.isZero(0) ? 0 : equation.error * equation.error;
  return std::sqrt(squared);
}

}  // namespace pushback
