#include "pushback/chapters/16_whole_problem/laws.h"

#include <cmath>

#include "pushback/engine/direct/sweeps.h"

namespace pushback {

using Eigen::Index;

BrokenLaws broken_laws(const ContactProblem& problem, const Vector& r) {
  const Vector u = problem.speeds(r), scale = unit_scales(problem);
  BrokenLaws squared;
  double unit = 0;  // ||q||^2, J
  for (Index c = 0; c < problem.contacts(); ++c) {
    const Eigen::Vector3d impulse = r.segment<3>(3 * c) * scale[c], speed = u.segment<3>(3 * c) / scale[c];
    const Eigen::Vector2d friction = impulse.tail<2>(), slip = speed.tail<2>();
    const double push = std::max(0.0, impulse[0]), parting = std::max(0.0, speed[0]), bound = problem.mu[c] * push;
    const auto square = [](double value) { return value * value; };
    squared.overlap += square(std::max(0.0, -speed[0]));
    squared.pull += square(std::max(0.0, -impulse[0]));
    squared.complementarity += square(push * parting);
    squared.cone += square(std::max(0.0, friction.norm() - bound));
    squared.dissipation += (bound * slip + slip.norm() * projected_to_disc(friction, bound)).squaredNorm();
    unit += (problem.q.segment<3>(3 * c) / scale[c]).squaredNorm();
  }
  if (!(unit > 0)) unit = 1;
  return {std::sqrt(squared.overlap / unit), std::sqrt(squared.pull / unit), std::sqrt(squared.complementarity) / unit,
          std::sqrt(squared.cone / unit), std::sqrt(squared.dissipation) / unit};
}

}  // namespace pushback
