/// Compares measurements with theory, for the period of a pendulum and the drift off a wire.
#pragma once

#include "pushback/chapters/13_joints/joints.h"
#include "pushback/chapters/13_joints/scenes.h"
#include "pushback/common/world/steps_in.h"

namespace pushback::joints_scenes {

/// A solver whose joints have this beta. The beta of contacts, which has the same name, keeps its default.
template <class JointSolver>
JointSolver with_joint_beta(Real beta) {
  JointSolver solver;
  solver.Joints::beta = beta;
  return solver;
}

/// The time between the first two falls through 0, s. `angles` (rad) are dt (s) apart. 0: fewer than two falls.
inline Real period_of(const std::vector<Real>& angles, Real dt) {
  std::vector<Real> falls;
  for (std::size_t i = 1; i < angles.size() && falls.size() < 2; ++i) {
    if (angles[i - 1] > 0 && angles[i] <= 0)
      falls.push_back((static_cast<Real>(i - 1) + angles[i - 1] / (angles[i - 1] - angles[i])) * dt);
  }
  return falls.size() < 2 ? 0 : falls[1] - falls[0];
}

struct Periods {
  Real ball, plank;  ///< s
};
inline Periods measured_periods(Real dt, Real beta, const Pendulums& pendulums = {}) {
  World world;
  pendulums(world);
  auto solver = with_joint_beta<Solver<Joints>>(beta);
  std::vector<Real> ball, plank;
  for (int step = 0; step < steps_in(5, dt); ++step) {
    world.step(solver, dt);
    ball.push_back(angle_of_ball(world));
    plank.push_back(angle_of_plank(world));
  }
  return {period_of(ball, dt), period_of(plank, dt)};
}

/// The largest distance of a bead of beads_on_wires from its wire within five seconds, m.
inline Real farthest_off_the_wires(Real dt, Real beta) {
  World world;
  beads_on_wires(world);
  auto solver = with_joint_beta<Solver<Joints>>(beta);
  Real farthest = 0;
  for (int step = 0; step < steps_in(5, dt); ++step) {
    world.step(solver, dt);
    farthest = std::max(farthest, largest_joint_error(world));
  }
  return farthest;
}

}  // namespace pushback::joints_scenes
