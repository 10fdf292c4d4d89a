/// Chapter 19: the convex relaxation of Coulomb's law, solved here by itself. What lifts a sliding body off is the law, and no
/// engine's way of solving it.
#include "pushback/tools/measure/study/relaxed_law.h"
#include "pushback/chapters/16_whole_problem/matrix.h"
#include "pushback/chapters/17_direct_contacts/best.h"
#include "pushback/tools/measure/study/every_motion.h"
#include "tests/support/catch.h"

using namespace pushback;

namespace {

constexpr double dt = 1.0 / 960;

/// The first step of a motion.
struct First {
  World world;
  ContactProblem problem;

  explicit First(const Motion& motion) {
    motion.fill(world);
    world.begin_step(static_cast<Real>(dt));
    problem = problem_of(world);
  }
};

Vector projected(const ContactProblem& problem, Vector r) {
  for (Eigen::Index i = 0; i < problem.contacts(); ++i)
    r.segment<3>(3 * i) = projected_to_cone(r.segment<3>(3 * i), problem.mu[i]);
  return r;
}

/// The minimum of  r^T W r / 2 + q^T r  over the cones, by projected gradients with Nesterov's momentum, until a step changes
/// speeds by nothing that counts.
Vector relaxed(const ContactProblem& problem) {
  const double step = 1 / Eigen::MatrixXd(problem.w).norm();  // the norm is no less than the largest eigenvalue
  Vector r = Vector::Zero(problem.q.size()), ahead = r;
  double weight = 1;
  for (int i = 0; i < 20000; ++i) {
    const Vector next = projected(problem, ahead - step * problem.speeds(ahead));
    const double next_weight = (1 + std::sqrt(1 + 4 * weight * weight)) / 2;
    const bool turned_back = (ahead - next).dot(next - r) > 0;  // then momentum begins anew
    ahead = turned_back ? next : next + (weight - 1) / next_weight * (next - r);
    weight = turned_back ? 1 : next_weight;
    r = next;
  }
  return r;
}

}  // namespace

TEST_CASE("by the relaxed law alone each contact of a body that slides parts with mu times its slip") {
  for (const char* name : {"sliding", "rolling"}) {
    INFO(name);
    const Motion& motion = motion_named(name);
    const First first(motion);
    const double mu = first.problem.mu[0];
    const Vector r = relaxed(first.problem), u = first.problem.speeds(r);
    REQUIRE((projected(first.problem, r) - r).norm() == 0);
    CHECK(std::abs(r.dot(u)) < 1e-9 * r.norm());
    // As predicted, less gravity's part of the step:   mu (v - k mu g h) / (1 + k mu^2)
    const Hop hop = *hop_of(motion);
    const Vec3& v = first.world.bodies.back().velocity;
    const double slip = std::hypot(static_cast<double>(v.x()), static_cast<double>(v.z()));
    const double k = (mu * slip / hop.speed - 1) / (mu * mu);
    const double wanted = mu * (slip - k * mu * truth::g * dt) / (1 + k * mu * mu);
    for (Eigen::Index i = 0; i < first.problem.contacts(); ++i) {
      CHECK(u[3 * i] == Approx(wanted).epsilon(1e-9));
      CHECK(u[3 * i] == Approx(mu * u.segment<2>(3 * i + 1).norm()).epsilon(1e-9));
    }
    // Coulomb's law, solved on the same problem: no contact parts.
    const Vector exact = first.problem.speeds(solve_best(first.problem).r);
    for (Eigen::Index i = 0; i < first.problem.contacts(); ++i) {
      CHECK(std::abs(exact[3 * i]) < 1e-9);
      CHECK(exact.segment<2>(3 * i + 1).norm() == Approx(slip - k * mu * truth::g * dt).epsilon(1e-9));
    }
  }
}

TEST_CASE("only what is sent along the ground hops") {
  CHECK(hop_of(motion_named("sliding"))->speed == Approx(2.4));
  CHECK(hop_of(motion_named("sliding"))->error == Approx(9 / (2 * truth::g * std::pow(1.25, 1.5))));
  CHECK(hop_of(motion_named("rolling"))->speed == Approx(1.8 / 1.315));
  for (const Motion& motion : every_motion())
    CHECK(hop_of(motion).has_value() == (motion.name == "sliding" || motion.name == "rolling"));
}
