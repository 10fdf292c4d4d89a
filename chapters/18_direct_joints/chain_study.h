/// The number of sweeps that a chain takes, by its length, and the error that the direct solve leaves.
#pragma once

#include <vector>

#include "pushback/chapters/13_joints/ball_and_socket.h"
#include "pushback/common/world/situations.h"
#include "pushback/engine/direct/direct_joints.h"
#include "pushback/engine/direct/row_matrix.h"

namespace pushback::direct_joints_scenes {

/// Links of 1 kg, 3 m in all, which hang from the origin at 45 degrees and are released.
inline void slanting_chain(World& world, int count) {
  const Real length = 3 / static_cast<Real>(count), radius = std::min(Real(0.05), length / 4);
  const Vec3 way = Vec3(1, -1, 0).normalized();
  for (int i = 0; i < count; ++i) {
    const Vec3 end = static_cast<Real>(i) * length * way;
    const int here = world.add(capsule(radius, length / 2 - radius, 1)
                                   .turned(pi / 4, Vec3::UnitZ())
                                   .at(end + length / 2 * way)
                                   .coloured(i % 2));
    world.joints.push_back(ball_and_socket(world, i == 0 ? the_world : here - 1, here, end));
  }
}

struct ChainSolved {
  std::vector<double> left;  ///< the largest error of a link's velocity after each sweep, relative to the start
  double at_once = 0;        ///< the largest |JV + b| that one solve leaves, relative to the largest before
  std::size_t rows = 0;
  std::size_t numbers = 0;  ///< in L, without zeros and without the diagonal
};

/// Solves the first step of a chain from zero impulses, with sweeps until its relative error is 1e-4 or less, or `most` times.
inline ChainSolved solve_chain(int count, Real h, int most) {
  World swept;
  slanting_chain(swept, count);
  World exact = swept;
  for (World* world : {&swept, &exact}) world->begin_step(h);
  Solver<Joints> sweeps;
  Solver<DirectJoints> at_once;
  sweeps.solve(swept, h, 0);
  at_once.solve(exact, h, 0);
  const auto rows = [&at_once] { return Rows(at_once.joint_rows().begin(), at_once.joint_rows().end()); };
  const Vector before = speeds_of(rows());
  at_once.solve(exact, h, 1);

  ChainSolved chain;
  chain.rows = at_once.joint_rows().size();
  chain.numbers = at_once.matrix().nonzeros();
  chain.at_once = speeds_of(rows()).cwiseAbs().maxCoeff() / before.cwiseAbs().maxCoeff();

  const auto error = [&] {
    Real largest = 0;
    for (std::size_t i = 0; i < swept.bodies.size(); ++i)
      largest = std::max(largest, (swept.bodies[i].velocity - exact.bodies[i].velocity).norm());
    return static_cast<double>(largest);
  };
  const double at_first = error();
  Rows no_contacts;
  StepContext step{swept, swept.contacts, no_contacts, h};
  while (static_cast<int>(chain.left.size()) < most && (chain.left.empty() || chain.left.back() > 1e-4)) {
    sweeps.Joints::sweep(step);
    chain.left.push_back(error() / at_first);
  }
  return chain;
}

}  // namespace pushback::direct_joints_scenes
