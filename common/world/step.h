/// The order of a step, and what it asks of a solver.
#pragma once

#include <algorithm>
#include <concepts>
#include <tuple>

#include "pushback/common/world/world.h"

namespace pushback {

/// Into how many substeps a solver divides a step, for all of which contacts are detected once, and how far ahead.
struct Division {
  int substeps = 1;
  Margin margin = {};
  bool displaces =
      false;  ///< whether the solver moves the bodies itself, where nothing reads their I^-1 between substeps
};

/// What a solver derives from. It has  void solve(World& world, Real dt, int sweeps),  which changes the velocities of bodies
/// and says in each contact what was done there; and defines of these what it needs.
struct StepSolver {
  static constexpr int usual_sweeps = 10;  ///< of who does not say how many

  /// Who does what falls into parts, of the step as of the solver.
  static Workers& workers() { return alone(); }

  /// Throws InvalidInput if it cannot solve what is in this world; nothing has changed yet. This one holds no joints.
  void check(World& world, Real /*dt*/) { check_no_joints(world.joints); }
  /// Of a step of dt.
  Division division(Real /*dt*/) const { return {}; }
  /// The contacts have been detected; substeps of dt follow, each with its `solve` and `after_move`.
  void detected(World&, Real /*dt*/) {}
  /// Where its division says so: moves all bodies on, as `displace` does each.
  void displace(World& world, Real dt) {
    for (Body& body : world.bodies) pushback::displace(body, dt);
  }
  /// The bodies have moved.
  void after_move(World&, Real /*dt*/) {}
  /// The last of the substeps is done.
  void done(World&) {}
};

/// What solves joints as well derives from this.
struct HoldsJoints {};

/// Throws InvalidInput if there is something in the world that `ContactSolver` does not know.
template <class ContactSolver>
void check_solvable(const World& world) {
  if constexpr (!std::derived_from<ContactSolver, HoldsJoints>) check_no_joints(world.joints);
}

/// Who takes part in a step, and finds what touches. This one leaves nobody out.
struct Everybody {
  Workers* workers = &alone();

  static void check(const World& world) {
    for (const Body& body : world.bodies) check_state(body);
  }
  void find_contacts(World& world, const Margin& margin = {}) const { world.find_contacts(margin, *workers); }
  /// `act` changes its body and reads no other.
  template <class Act>
  void each(World& world, const Act& act) const {
    workers->each(world.bodies.size(), 64, [&](Part part) {
      for (std::size_t i = part.begin; i < part.end; ++i) act(world.bodies[i]);
    });
  }
  static void end(World&, Real /*dt*/) {}
};

/// 1 and 2 of a step.
template <class Simulated>
void detect(World& world, Simulated& simulated, const Margin& margin) {
  world.contacts_before.swap(world.contacts);
  for (const Force& force : world.forces) force.apply(world);  // 1.  F, tau
  simulated.find_contacts(world, margin);                      // 2.  points, normals, depths, ids
}
/// 3.
template <class Simulated>
void push_all(World& world, Real dt, Simulated& simulated) {
  simulated.each(world, [&](Body& body) {  // 3.  v += h (g + F/m),  w += h I^-1 tau
    keep_velocity(body);
    push(body, world.gravity, dt);
  });
}
/// 1 to 3.
template <class Simulated>
void begin_step(World& world, Real dt, Simulated& simulated) {
  detect(world, simulated, {});
  push_all(world, dt, simulated);
}

/// 1 of the substeps after the first: what was put on bodies by hand lasts for the step, and what acts on them acts on them as they
/// are now. Who sleeps feels neither.
class ForcesOfSubsteps {
 public:
  /// Before any Force has acted.
  ForcesOfSubsteps(const World& world, const Division& division) {
    const auto feels = [](const Body& body) { return body.force != Vec3::Zero() || body.torque != Vec3::Zero(); };
    if (division.substeps == 1 || std::none_of(world.bodies.begin(), world.bodies.end(), feels)) return;
    for (const Body& body : world.bodies) by_hand_.emplace_back(body.force, body.torque);
  }
  void apply(World& world) const {
    if (by_hand_.empty() && world.forces.empty()) return;
    for (std::size_t i = 0; i < by_hand_.size(); ++i)
      std::tie(world.bodies[i].force, world.bodies[i].torque) = by_hand_[i];
    for (const Force& force : world.forces) force.apply(world);
    for (Body& body : world.bodies) {
      if (body.asleep) body.force.setZero(), body.torque.setZero();
    }
  }
  /// Whether something turns a body, or may.
  bool turn_bodies(const World& world) const {
    return !world.forces.empty() ||
           std::any_of(by_hand_.begin(), by_hand_.end(), [](const auto& of) { return of.second != Vec3::Zero(); });
  }

 private:
  std::vector<std::pair<Vec3, Vec3>> by_hand_;  // force and torque of each body; none where nobody has any
};

/// Moves those who are simulated on by dt seconds. Throws as World::step does.
template <class ContactSolver, class Simulated>
void step(World& world, ContactSolver& solver, Real dt, int sweeps, Simulated& simulated) {
  check_step(dt, sweeps, world.gravity);
  simulated.check(world);
  solver.check(world, dt);
  const Division division = solver.division(dt);
  const Real h = dt / static_cast<Real>(division.substeps);
  const ForcesOfSubsteps forces(world, division);
  const bool displaced = division.displaces && !forces.turn_bodies(world) && world.joints.empty();
  detect(world, simulated, division.margin);
  solver.detected(world, h);
  for (int i = 0; i < division.substeps; ++i) {
    if (i > 0) forces.apply(world);
    push_all(world, h, simulated);
    solver.solve(world, h, sweeps);  // 4.  start from the last step's impulses
                                     // 5.  sweep over the rows
                                     // 6.  keep the impulses
    if (displaced) solver.displace(world, h);
    else simulated.each(world, [h](Body& body) { move(body, h); });  // 7.  x += h v,  q += h/2 (0, w) q,  refresh I^-1
    world.time += h;
    solver.after_move(world, h);  // 8.  only where a solver has this
    world.dt_before = h;
  }
  if (displaced) simulated.each(world, [](Body& body) { body.refresh_inertia(); });
  solver.done(world);
  simulated.end(world, dt);
}

template <class ContactSolver>
void World::step(ContactSolver& solver, Real dt, int sweeps) {
  Everybody everybody{&solver.workers().of_bodies(bodies.size())};
  pushback::step(*this, solver, dt, sweeps, everybody);
}

}  // namespace pushback
