/// Chapter 16: the cone of friction, the laws of contact one by one, and residuals in whatever units.
#include <random>

#include "pushback/chapters/16_whole_problem/laws.h"
#include "pushback/chapters/17_direct_contacts/methods.h"
#include "pushback/common/world/situations.h"
#include "pushback/engine/direct/row_matrix.h"
#include "tests/support/catch.h"

using namespace pushback;

namespace {

using Eigen::Index;
using Eigen::Vector3d;

constexpr double ulp = std::numeric_limits<double>::epsilon();
constexpr std::array coefficients{0.0, 1e-6, 0.1, 0.5, 1.0, 3.0, 1e6};

/// Points that the projection has to tell apart, of the length 1 or so: anywhere, on the axis, and at both edges.
std::vector<Vector3d> points(double mu, int anywhere) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> number(-2, 2);
  std::vector<Vector3d> all{{1, 0, 0}, {-1, 0, 0}, {0, 0, 0}, {-0.0, -0.0, 0}, {0, 1, 0}, {-0.0, 0, -1}};
  for (int i = 0; i < anywhere; ++i) {
    const double z = number(random), y = number(random), x = number(random);
    all.emplace_back(x, y, z);
  }
  for (const double angle : {0.0, 0.7, 2.0, 3.5, 5.9}) {
    const Vector3d at_edge = Vector3d(1, mu * std::cos(angle), mu * std::sin(angle)) / std::hypot(1, mu);
    const Vector3d of_polar = Vector3d(-mu, std::cos(angle), std::sin(angle)) / std::hypot(1, mu);
    for (const double off : {0.0, ulp, -ulp, 1e-3, -1e-3}) {
      all.push_back(at_edge + off * of_polar);
      all.push_back(of_polar + off * at_edge);
    }
  }
  return all;
}

double outside(const Vector3d& r, double mu) {  // of the cone, as the crow flies
  return std::max({0.0, -r[0], (std::hypot(r[1], r[2]) - mu * r[0]) / std::hypot(1, mu)});
}

ContactProblem problem_with(const Eigen::MatrixXd& w, const Vector& q, double mu) {
  return {SparseMatrix(w.sparseView(0, 0)), q, Vector::Constant(q.size() / 3, mu)};
}

ContactProblem sliding_stack_problem() {
  World world;
  stack(world, 3);
  for (std::size_t i = 1; i < world.bodies.size(); ++i) world.bodies[i].velocity += Vec3(Real(0.4), 0, Real(0.1));
  world.begin_step(Real(1) / 60);
  return problem_of(world);
}

}  // namespace

TEST_CASE("the projection lies in the cone, and is left where it is by a second one") {
  for (const double mu : coefficients)
    for (const double size : {1.0, 1e-150, 1e150, 1e-290, 1e290})
      for (const Vector3d& point : points(mu, 300)) {
        const Vector3d r = size * point, p = projected_to_cone(r, mu);
        INFO(mu << ": " << r.transpose() << " to " << p.transpose());
        CHECK(p[0] >= 0);
        CHECK(outside(p, mu) <= 4 * ulp * p.stableNorm());
        CHECK((projected_to_cone(p, mu) - p).stableNorm() <= 4 * ulp * p.stableNorm());
        if (outside(r, mu) == 0) CHECK(p == r);
      }
}

TEST_CASE("Moreau: what a projection takes away is the projection to the polar cone, at a right angle to it") {
  for (const double mu : coefficients)
    for (const Vector3d& r : points(mu, 300)) {
      const Vector3d p = projected_to_cone(r, mu), away = r - p;
      INFO(mu << ": " << r.transpose() << " to " << p.transpose());
      CHECK(std::abs(away.dot(p)) <= 8 * ulp * r.squaredNorm());
      // The polar cone {away_n + mu |away_t| <= 0} is -K*; K* is a cone of friction itself, of 1 / mu.
      CHECK(away[0] + mu * std::hypot(away[1], away[2]) <= 8 * ulp * std::hypot(1, mu) * r.norm());
      if (mu > 0) CHECK((away + projected_to_cone(-r, 1 / mu)).norm() <= 8 * ulp * r.norm());
    }
}

TEST_CASE("a problem that breaks one law is charged with that law alone") {
  // Two contacts that feel each other; u is chosen, r follows, q is what makes both agree.
  Eigen::MatrixXd w = Eigen::MatrixXd::Identity(6, 6);
  w(0, 3) = w(3, 0) = w(1, 5) = w(5, 1) = 0.3;
  const double mu = 0.5;
  const auto broken = [&](const Vector3d& r, const Vector3d& u) {
    Vector all_r(6), all_u(6);
    all_r << r, 2, 0.1, -0.2;  // the second sticks, and breaks nothing
    all_u << u, 0, 0, 0;
    return broken_laws(problem_with(w, all_u - w * all_r, mu), all_r);
  };
  const auto list = [](const BrokenLaws& b) {
    return std::array{b.overlap, b.pull, b.complementarity, b.cone, b.dissipation};
  };
  struct Case {
    Vector3d r, u;
    int law;  // -1: none
  };
  const Case cases[] = {
      {{1, 0.1, 0.2}, {0, 0, 0}, -1},  // sticks
      {{1, -0.5, 0}, {0, 3, 0}, -1},   // slides
      {{0, 0, 0}, {2, 1, -1}, -1},     // parts
      {{0, 0, 0}, {-1, 0, 0}, 0},      // goes in
      {{1, -0.5, 0}, {-1, 3, 0}, 0},   // slides, and goes in
      {{-1, 0, 0}, {0, 0, 0}, 1},      // is held back
      {{-1, 0, 0}, {2, 3, 0}, 1},      // the same while it leaves
      {{1, 0.2, 0}, {1, 0, 0}, 2},     // is pushed though it leaves
      {{1, 0, 0.8}, {0, 0, 0}, 3},     // sticks by more friction than there is
      {{1, 0, -0.8}, {0, 0, 2}, 3},    // slides, straight against it, with more than there is
      {{1, -0.2, 0}, {0, 3, 0}, 4},    // slides, with less
      {{1, 0, -0.5}, {0, 3, 0}, 4},    // slides, with friction aside
      {{1, 0.3, -0.4}, {0, 3, 4}, 4},  // slides, with friction askew
      {{0.5, 0.25, 0}, {0, 3, 0}, 4},  // slides, and friction drives it
  };
  for (const Case& c : cases) {
    const auto by = list(broken(c.r, c.u));
    INFO(c.r.transpose() << " with " << c.u.transpose());
    for (int law = 0; law < 5; ++law) {
      if (law == c.law) CHECK(by[static_cast<std::size_t>(law)] > 0.01);
      else CHECK(by[static_cast<std::size_t>(law)] < 1e-15);
    }
  }
}

TEST_CASE("by how much a law is broken, in closed form") {
  const Eigen::Matrix3d w = Vector3d(2, 4, 6).asDiagonal();  // d = 4 /kg
  const double length = std::sqrt(3.0 * 3 + 4 * 4);
  const ContactProblem problem = problem_with(w, Vector3d(-3, 4, 0), 0.5);
  CHECK(broken_laws(problem, Vector3d::Zero()).overlap == Approx(3 / length));
  CHECK(broken_laws(problem, Vector3d(-1, 0, 0)).pull == Approx(1 * 4 / length));
  const BrokenLaws pushed = broken_laws(problem, Vector3d(2, -1, 0));  // u = (1, 0, 0)
  CHECK(pushed.complementarity == Approx(2 * 1 * 4 / (length * length)));
  CHECK(pushed.dissipation == 0);
  CHECK(broken_laws(problem, Vector3d(1.5, -1, 0)).cone == Approx((1 - 0.75) * 4 / length));
  // u_t = 4 - 4 * 0.5 = 2 with half of the friction: mu r_n u_t - |u_t| 0.5 = 1.5 - 1
  CHECK(broken_laws(problem, Vector3d(1.5, -0.5, 0)).dissipation == Approx(0.5 * 4 / (length * length)));
}

TEST_CASE("no law is broken exactly where the residual is nothing") {
  const ContactProblem problem = sliding_stack_problem();
  for (const std::string& method : method_names()) {
    const Vector r = solve(problem, method, 3000, 1e-14).r;
    const BrokenLaws b = broken_laws(problem, r);
    const double together = b.overlap + b.pull + b.complementarity + b.cone + b.dissipation;
    const double residual = unitless_residual(problem, r);
    INFO(method << ": laws " << together << ", residual " << residual);
    CHECK((residual < 1e-9) == (together < 1e-9));
    if (method == "pgs") CHECK(b.cone + b.dissipation > 1e-3);
    if (method == "scaled-back") CHECK(b.cone < 1e-12);  // drawn back it is; the wrong way is what remains
    if (method == "best") CHECK(together < 1e-12);
  }
}

TEST_CASE("the unitless residual is the same in all units, and the other is not") {
  std::mt19937 random(6);
  std::uniform_real_distribution<double> number(-1, 1);
  const ContactProblem problem = sliding_stack_problem();
  Vector r = solve(problem, "cone", 3, 0).r;
  for (double& each : r) each += number(random);  // inside, outside, pulling
  const double unitless = unitless_residual(problem, r), relative = relative_residual(problem, r);
  const BrokenLaws laws = broken_laws(problem, r);
  REQUIRE(unitless > 1e-2);
  for (const double mass : {1.0, 1e3, 0.45359237})
    for (const double length : {1.0, 1e3, 0.3048})
      for (const double time : {1.0, 1e3, 1 / 3600.0}) {  // how many of the new unit go into the old one
        ContactProblem other = problem;
        other.w = problem.w / mass;
        other.q = problem.q * (length / time);
        const Vector other_r = r * (mass * length / time);
        CHECK(unitless_residual(other, other_r) == Approx(unitless).epsilon(1e-13));
        const BrokenLaws same = broken_laws(other, other_r);
        CHECK(same.overlap == Approx(laws.overlap).epsilon(1e-12));
        CHECK(same.pull == Approx(laws.pull).epsilon(1e-13));
        CHECK(same.complementarity == Approx(laws.complementarity).epsilon(1e-12));
        CHECK(same.cone == Approx(laws.cone).epsilon(1e-13));
        CHECK(same.dissipation == Approx(laws.dissipation).epsilon(1e-12));
        if (mass != 1) CHECK(std::abs(relative_residual(other, other_r) / relative - 1) > 0.01);
      }
}

TEST_CASE("the unitless residual does not see how tangents are chosen, and is that of the scaled problem") {
  const ContactProblem problem = sliding_stack_problem();
  const Vector r = solve(problem, "cone", 3, 0).r;
  const double unitless = unitless_residual(problem, r);
  const Index size = problem.q.size();
  Eigen::MatrixXd turn = Eigen::MatrixXd::Identity(size, size);
  for (Index c = 0; c < problem.contacts(); ++c) {
    const double angle = 0.3 + static_cast<double>(c);
    turn.block<2, 2>(3 * c + 1, 3 * c + 1) << std::cos(angle), -std::sin(angle), std::sin(angle), std::cos(angle);
  }
  const ContactProblem turned{SparseMatrix((turn * problem.w * turn.transpose()).sparseView(0, 0)), turn * problem.q,
                              problem.mu};
  CHECK(unitless_residual(turned, turn * r) == Approx(unitless).epsilon(1e-12));
  Vector scale(size);
  for (Index c = 0; c < problem.contacts(); ++c) scale.segment<3>(3 * c).setConstant(unit_scales(problem)[c]);
  const Vector inverse = scale.cwiseInverse();
  const ContactProblem scaled{SparseMatrix(inverse.asDiagonal() * problem.w * inverse.asDiagonal()),
                              inverse.cwiseProduct(problem.q), problem.mu};
  CHECK(relative_residual(scaled, scale.cwiseProduct(r)) == Approx(unitless).epsilon(1e-12));
  CHECK((unit_scales(scaled) - Vector::Ones(problem.contacts())).norm() < 1e-12);
}
