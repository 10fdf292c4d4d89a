/// One row: its Jacobian, its mass, its impulse, its limits.
#include "pushback/chapters/01_velocity_constraint/row.h"

#include <array>

#include "pushback/common/world/measure.h"
#include "tests/support/catch.h"
#include "tests/support/touching.h"
#include "tests/support/yardstick.h"

using namespace pushback;

namespace {

constexpr int many = 500;

using RowOf12 = Eigen::Matrix<Real, 1, 12>;
using Vec12 = Eigen::Matrix<Real, 12, 1>;
using Mat12 = Eigen::Matrix<Real, 12, 12>;

struct Pair : RandomPair {
  using RandomPair::RandomPair;
  /// n, t1 and t2: every direction in which there is a row.
  std::array<Vec3, 3> directions() const {
    const auto [tangent1, tangent2] = tangents_of(contact.normal);
    return {contact.normal, tangent1, tangent2};
  }
};

/// Where a point that rides on the body will be in t seconds: x + t v + R(t w) r. Exact, unlike a simulated step.
Vec3 carried(const Body& body, const Vec3& point, Real t) {
  const Real speed = body.angular_velocity.norm();
  const Vec3 arm = point - body.position;
  const Vec3 turned = speed == 0 ? arm : Vec3(Eigen::AngleAxis<Real>(t * speed, body.angular_velocity / speed) * arm);
  return body.position + t * body.velocity + turned;
}

/// (f(t) - f(-t)) / 2t and what it may be off by: t^2/6 times the largest third derivative, and the rounding of f.
struct Difference {
  Real value, tolerance;
};
template <class Function>
Difference central_difference(const Function& f, Real largest_third_derivative, Real size) {
  const Real t = std::cbrt(eps);  // about where the two errors are equal
  return {(f(t) - f(-t)) / (2 * t), t * t / 6 * largest_third_derivative + 16 * eps * size / t};
}

/// |d^3/dt^3 of R(t) r| = |w|^3 |r| at most.
Real third_derivative(const Body& body, const Vec3& point) {
  return std::pow(body.angular_velocity.norm(), Real(3)) * (point - body.position).norm();
}

Vec12 velocities(const Pair& pair) {
  Vec12 V;
  V << pair.world.bodies[0].velocity, pair.world.bodies[0].angular_velocity, pair.world.bodies[1].velocity,
      pair.world.bodies[1].angular_velocity;
  return V;
}

/// J = [-n  -(r_A x n)  n  (r_B x n)], written down from the formula and not from the code.
RowOf12 jacobian(const Pair& pair, const Vec3& n) {
  const auto [a, b] = pair.world.bodies_of(pair.contact);
  const Vec3& point = pair.contact.point;
  RowOf12 J;
  J << -n.transpose(), -(point - a.position).cross(n).transpose(), n.transpose(),
      (point - b.position).cross(n).transpose();
  return J;
}

/// M^-1, 12 x 12, from the principal moments: R I^-1 R^T is not taken from the body.
Mat12 inverse_masses(const World& world) {
  Mat12 M = Mat12::Zero();
  int at = 0;
  for (const Body& body : world.bodies) {
    const Mat3 R = body.orientation.toRotationMatrix();
    M.block<3, 3>(at, at) = body.inverse_mass * Mat3::Identity();
    M.block<3, 3>(at + 3, at + 3) = R * Mat3(body.principal_inverse_inertia.asDiagonal()) * R.transpose();
    at += 6;
  }
  return M;
}

/// What a sum like J V is made of, all signs positive: rounding is a few eps of it.
Real size_of(const RowOf12& J, const Vec12& V) {
  return J.cwiseAbs() * V.cwiseAbs();
}

}  // namespace

TEST_CASE("J V is the rate of C = (P_B - P_A) . n, for the normal and both tangents") {
  Random random(1);
  for (int i = 0; i < many; ++i) {
    Pair pair(random);
    const Vec3 point = pair.contact.point;
    for (const Vec3& n : pair.directions()) {
      const auto C = [&](Real t) { return (carried(pair.b(), point, t) - carried(pair.a(), point, t)).dot(n); };
      const auto rate =
          central_difference(C, third_derivative(pair.a(), point) + third_derivative(pair.b(), point), 20);
      REQUIRE(std::abs(pair.row(n).speed() - rate.value) <= rate.tolerance);
    }
  }
}

TEST_CASE("J is the one of the formula, entry by entry") {
  Random random(2);
  for (int i = 0; i < many; ++i) {
    Pair pair(random);
    for (const Vec3& n : pair.directions()) {
      const Row row = pair.row(n);
      const RowOf12 J = jacobian(pair, n);
      REQUIRE(std::abs(row.speed() - J * velocities(pair)) <= 16 * eps * size_of(J, velocities(pair)));
      // The code's own J: J V for each unit vector V.
      for (int entry = 0; entry < 12; ++entry) {
        const Vec12 V = Vec12::Unit(entry);
        pair.a().moving(V.segment<3>(0)).spinning(V.segment<3>(3));
        pair.b().moving(V.segment<3>(6)).spinning(V.segment<3>(9));
        REQUIRE(std::abs(row.speed() - J(entry)) <= 4 * eps);
      }
    }
  }
}

// The answer to the question that the first source leaves open.
TEST_CASE("a normal that turns changes nothing while the two deepest points lie along it") {
  Random random(3);
  for (int i = 0; i < many; ++i) {
    Pair pair(random);
    const Contact& c = pair.contact;
    const Vec3 spin = random.vector(5);  // of n: any
    const Vec3 on_a = c.point + c.depth / 2 * c.normal;
    const Vec3 on_b = c.point - c.depth / 2 * c.normal;
    REQUIRE(std::abs((on_b - on_a).dot(c.normal) + c.depth) <= 16 * eps);  // P_B - P_A = -d n

    const auto n = [&](Real t) -> Vec3 {
      return Eigen::AngleAxis<Real>(t * spin.norm(), spin.normalized()) * c.normal;
    };
    const auto C = [&](Real t) { return (carried(pair.b(), on_b, t) - carried(pair.a(), on_a, t)).dot(n(t)); };
    // The third derivative of the product: every turn brings a factor w, and arms and ways are less than 40 m or m/s.
    const Real w = std::max({pair.a().angular_velocity.norm(), pair.b().angular_velocity.norm(), spin.norm(), Real(1)});
    const Real far = 40;
    const auto rate = central_difference(C, 8 * w * w * w * far, 20);
    REQUIRE(std::abs(pair.row(c.normal).speed() - rate.value) <= rate.tolerance);
  }
}

TEST_CASE("where the points do not lie along the normal, (P_B - P_A) . n' is missing from J V") {
  Random random(4);
  Real largest_missing = 0;
  for (int i = 0; i < many; ++i) {
    Pair pair(random);
    const Contact& c = pair.contact;
    const auto [tangent1, tangent2] = tangents_of(c.normal);
    // As where a manifold is clipped, or an anchor is kept over several steps.
    const Real slant1 = random.between(Real(-0.3), Real(0.3)), slant2 = random.between(Real(-0.3), Real(0.3));
    const Vec3 apart = -c.depth * c.normal + slant1 * tangent1 + slant2 * tangent2;
    const Vec3 on_a = c.point - apart / 2, on_b = c.point + apart / 2;
    const auto rate_with = [&](const Vec3& spin) {
      const auto n = [&](Real t) -> Vec3 {
        return Eigen::AngleAxis<Real>(t * spin.norm(), spin.normalized()) * c.normal;
      };
      const auto C = [&](Real t) { return (carried(pair.b(), on_b, t) - carried(pair.a(), on_a, t)).dot(n(t)); };
      const Real w =
          std::max({pair.a().angular_velocity.norm(), pair.b().angular_velocity.norm(), spin.norm(), Real(1)});
      return central_difference(C, 8 * w * w * w * 40, 20);
    };

    // J V with each arm to its own point is short of the rate by exactly the dropped term.
    const Vec3 spin = random.vector(5);
    const auto rate = rate_with(spin);
    const Real own_points = (pair.b().velocity_at(on_b) - pair.a().velocity_at(on_a)).dot(c.normal);
    const Real missing = apart.dot(spin.cross(c.normal));
    REQUIRE(std::abs(rate.value - own_points - missing) <= rate.tolerance);
    largest_missing = std::max(largest_missing, std::abs(missing));

    // The row's arms lead to the point midway. That happens to make up for it where n turns with the mean of the spins.
    const Vec3 mean_spin = (pair.a().angular_velocity + pair.b().angular_velocity) / 2;
    const auto mean_rate = rate_with(mean_spin);
    REQUIRE(std::abs(mean_rate.value - pair.row(c.normal).speed()) <= mean_rate.tolerance);
  }
  CHECK(largest_missing > Real(0.5));  // m/s: not something to be dropped in silence
}

TEST_CASE("K = J M^-1 J^T, and apply(lambda) is V += M^-1 J^T lambda") {
  Random random(5);
  for (int i = 0; i < many; ++i) {
    Pair pair(random);
    for (const Vec3& n : pair.directions()) {
      Row row = pair.row(n);
      const RowOf12 J = jacobian(pair, n);
      const Mat12 M = inverse_masses(pair.world);
      const Real K = J * M * J.transpose();
      // Relative to sums without cancellation: R I^-1 R^T cancels where the arm lies along the slow axis.
      const Real size = J.cwiseAbs() * M.cwiseAbs() * J.transpose().cwiseAbs();
      REQUIRE(std::abs(1 / row.effective_mass - K) <= 32 * eps * size);

      const Vec12 before = velocities(pair);
      const Real lambda = random.between(-10, 10);
      row.apply(lambda);
      const Vec12 change = M * J.transpose() * lambda;
      const Vec12 entries = M.cwiseAbs() * J.transpose().cwiseAbs() * std::abs(lambda) + before.cwiseAbs();
      for (int k = 0; k < 12; ++k)
        REQUIRE(std::abs(velocities(pair)[k] - before[k] - change[k]) <= 32 * eps * entries[k]);
    }
  }
}

TEST_CASE("after one solve J V + b = 0 and nothing is left to correct") {
  Random random(7);
  for (int i = 0; i < many; ++i) {
    Pair pair(random);
    for (const Vec3& n : pair.directions()) {
      Row row = pair.row(n);
      row.bias = random.between(-3, 3);
      const RowOf12 J = jacobian(pair, n);
      const Real before = size_of(J, velocities(pair));
      row.solve();
      const Real size = before + size_of(J, velocities(pair)) + std::abs(row.bias);
      REQUIRE(std::abs(row.speed() + row.bias) <= 32 * eps * size);
      REQUIRE(row.error() <= 32 * eps * (size + std::abs(row.impulse) / row.effective_mass));
      const Real once = row.impulse;
      row.solve();
      REQUIRE(std::abs(row.impulse - once) <= 32 * eps * (size * row.effective_mass + std::abs(once)));
    }
  }
}

TEST_CASE("no row changes the momentum or the angular momentum of its two bodies") {
  Random random(8);
  for (int i = 0; i < many; ++i) {
    Pair pair(random);
    const Vec3 p = momentum(pair.world), l = angular_momentum(pair.world);
    Real exchanged = 0;
    for (const Vec3& n : pair.directions()) {
      Row row = pair.row(n);
      row.bias = random.between(-3, 3);
      row.apply(random.between(-10, 10));
      row.reach(random.between(-10, 10));
      row.solve();
      exchanged += 30 + std::abs(row.impulse);
    }
    // Every body's share, and what the rows handed to and fro; 4 m is farther than any arm is long.
    Real size = exchanged;
    for (const Body& body : pair.world.bodies) {
      size += (body.velocity.norm() + 5) / body.inverse_mass + spin_momentum(body).norm();
    }
    // Angular velocities near the slow axis are recovered through I^-1 and I: the ratio of the moments comes in.
    Real ratio = 1;
    for (const Body& body : pair.world.bodies) {
      ratio = std::max(ratio, body.principal_inverse_inertia.maxCoeff() / body.principal_inverse_inertia.minCoeff());
    }
    REQUIRE((momentum(pair.world) - p).norm() <= 32 * eps * size);
    REQUIRE((angular_momentum(pair.world) - l).norm() <= 32 * 4 * eps * size * ratio);
  }
}

TEST_CASE("the sum of the impulses stops at its limits, and the bodies feel the difference only") {
  Random random(9);
  for (int i = 0; i < many; ++i) {
    Pair pair(random);
    Row row = pair.row(pair.contact.normal);
    row.lo = random.between(-5, 0);
    row.hi = random.between(0, 5);
    for (int k = 0; k < 8; ++k) {
      const Real wanted = random.between(-10, 10), before = row.impulse, speed = row.speed();
      row.reach(wanted);
      REQUIRE(row.impulse == std::clamp(wanted, row.lo, row.hi));
      // J V changed by K times the difference.
      const Real K = 1 / row.effective_mass;
      const Real size = size_of(jacobian(pair, row.n), velocities(pair)) + K * 10;
      REQUIRE(std::abs(row.speed() - speed - K * (row.impulse - before)) <= 32 * eps * size);
    }
    // At the limit a row is as solved as it can be: exactly, or to rounding where the limit is just reached.
    row.bias = -1e6;  // out of reach for either sum
    row.solve();
    REQUIRE(row.impulse == row.hi);
    REQUIRE(row.error() == 0);
    row.bias = 1e6;
    REQUIRE(row.error() > 0);
    row.solve();
    REQUIRE(row.impulse == row.lo);
    REQUIRE(row.error() == 0);
  }
}

TEST_CASE("error() is the change of J V that another solve makes") {
  Random random(10);
  for (int i = 0; i < many; ++i) {
    Pair pair(random);
    Row row = pair.row(pair.contact.normal);
    row.lo = random.between(-5, 0);
    row.hi = random.between(0, 5);
    row.bias = random.between(-3, 3);
    const Real promised = row.error(), before = row.speed();
    row.solve();
    const Real size = size_of(jacobian(pair, row.n), velocities(pair)) + std::abs(before) + promised;
    REQUIRE(std::abs(std::abs(row.speed() - before) - promised) <= 64 * eps * size);
  }
}

TEST_CASE("a body that nothing moves stays as it is, and the other one alone is moved") {
  Random random(11);
  for (int i = 0; i < many; ++i) {
    Pair pair(random);
    pair.a().fixed();
    const Vec3 v = pair.a().velocity, w = pair.a().angular_velocity;
    Row row = pair.row(pair.contact.normal);
    row.solve();
    REQUIRE(pair.a().velocity == v);
    REQUIRE(pair.a().angular_velocity == w);
    const Real size = size_of(jacobian(pair, row.n), velocities(pair)) + std::abs(row.impulse) / row.effective_mass;
    REQUIRE(std::abs(row.speed()) <= 32 * eps * size);
  }
}

TEST_CASE("n, t1, t2 are a right-handed orthonormal basis") {
  Random random(12);
  for (int i = 0; i < many; ++i) {
    const Vec3 n = i < 3 ? Vec3(Vec3::Unit(i)) : random.direction();
    const auto [tangent1, tangent2] = tangents_of(n);
    Mat3 basis;
    basis << n, tangent1, tangent2;
    REQUIRE((basis.transpose() * basis - Mat3::Identity()).norm() <= 16 * eps);
    REQUIRE((n.cross(tangent1) - tangent2).norm() <= 16 * eps);
  }
}
