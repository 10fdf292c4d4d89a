/// The joints of a scene's first step, for a page that solves them iteration by iteration.
#pragma once

#include <memory>

#include "pushback/common/experiment/iterated_problem.h"
#include "pushback/engine/direct/direct_joints.h"
#include "pushback/engine/direct/row_matrix.h"

namespace pushback::direct_joints_scenes {

/// A step that has begun, and an effect that sweeps its joints: Joints or DirectJoints.
template <class JointEffect>
struct BegunStep {
  World world;
  Solver<JointEffect> solver;
  Real h;

  template <class Fill>
  BegunStep(const Fill& fill, Real dt) : h(dt) {
    fill(world);
    world.begin_step(h);
    solver.solve(world, h, 0);
  }
  BegunStep(const BegunStep&) = delete;
  BegunStep& operator=(const BegunStep&) = delete;

  Rows rows() const { return {solver.joint_rows().begin(), solver.joint_rows().end()}; }
  void sweep() {
    Rows no_contacts;
    StepContext step{world, world.contacts, no_contacts, h};
    solver.JointEffect::sweep(step);
  }
  Vector impulses() const {
    Vector all(std::ssize(solver.joint_rows()));
    for (Eigen::Index i = 0; const JointRow& row : solver.joint_rows()) all[i++] = static_cast<double>(row.impulse);
    return all;
  }
};

/// `most`: the number of iterations after which the method has finished.
template <class JointEffect, class Fill>
IteratedProblem::Method iterated(const std::string& name, const Fill& fill, Real dt, int most) {
  return {name, [begun = std::make_shared<BegunStep<JointEffect>>(fill, dt), left = most](Vector& impulses) mutable {
            if (left-- <= 0) return false;
            begun->sweep();
            impulses = begun->impulses();
            return true;
          }};
}

/// A lambda + q = 0, q = JV + b, by sweeps and by the direct solve, which takes one iteration.
template <class Fill>
IteratedProblem iterated(const Fill& fill, Real dt) {
  const BegunStep<Joints> begun(fill, dt);
  const Vector q = speeds_of(begun.rows());
  const double largest = q.cwiseAbs().maxCoeff();
  IteratedProblem problem{.matrix = matrix_of(begun.rows()),
                          .block = 3,
                          .block_name = "joint",
                          .iteration = "a sweep over all joints, or the one direct solve",
                          .measure = "largest speed left, relative to the largest before"};
  problem.residual = [a = problem.matrix, q, largest](const Vector& impulses) {
    return Vector(a * impulses + q).cwiseAbs().maxCoeff() / largest;
  };
  problem.methods = {iterated<Joints>("sweeps", fill, dt, problem.most),
                     iterated<DirectJoints>("direct joint solve", fill, dt, 1)};
  return problem;
}

}  // namespace pushback::direct_joints_scenes
