/// Bodies that turn side by side, beside one after the other.
#include "pushback/common/bodies/random.h"
#include "pushback/engine/substeps/wide_solver.h"
#include "tests/support/catch.h"
#include "tests/support/yardstick.h"

using namespace pushback;

namespace {

/// Of any proportions, however turned, each turning by `angle` in a step of h: the last of every eight about one of its own axes,
/// the one before it not at all, and two are cubes.
std::vector<Body> turning(int count, Real angle) {
  Random random(5);
  std::vector<Body> bodies;
  for (int i = 0; i < count; ++i) {
    const bool cube = i % 4 == 1;
    const Real z = random.between(Real(0.1), 1), y = cube ? z : random.between(Real(0.1), 1),
               x = cube ? z : random.between(Real(0.1), 1), mass = random.between(Real(0.1), 10);
    const Vec3 axis = random.direction();
    Body body = box({x, y, z}, mass).turned(random.between(0, 6), axis);
    body.spinning(angle / h * (i % 8 == 7 ? body.orientation * Vec3::UnitY() : random.direction()));
    if (i % 8 == 6) body.spinning(Vec3::Zero()), body.orientation.coeffs() *= 1 + 8 * eps;  // to be left as it is
    bodies.push_back(body);
  }
  return bodies;
}

EightRotations<Real> eight_of(const std::vector<Body>& bodies, std::size_t first) {
  EightRotations<Real> eight{};
  for (std::size_t i = 0; i < lanes_per_bundle; ++i) {
    const Body& body = bodies[first + i];
    const Quat& q = body.orientation;
    eight.x.values[i] = q.x(), eight.y.values[i] = q.y(), eight.z.values[i] = q.z(), eight.s.values[i] = q.w();
    EightNumbers<Real>* const w[] = {&eight.w.x, &eight.w.y, &eight.w.z};
    EightNumbers<Real>* const inverse[] = {&eight.inverse_inertia.x, &eight.inverse_inertia.y,
                                           &eight.inverse_inertia.z};
    for (int k = 0; k < 3; ++k)
      w[k]->values[i] = body.angular_velocity[k], inverse[k]->values[i] = body.principal_inverse_inertia[k];
  }
  return eight;
}
Quat orientation_in(const EightRotations<Real>& eight, std::size_t i) {
  return {eight.s.values[i], eight.x.values[i], eight.y.values[i], eight.z.values[i]};
}
Vec3 spin_in(const EightRotations<Real>& eight, std::size_t i) {
  return {eight.w.x.values[i], eight.w.y.values[i], eight.w.z.values[i]};
}
/// I w, world axes.
Vec3 spin_momentum(const Quat& q, const Vec3& w, const Body& body) {
  return q * Vec3((q.conjugate() * w).cwiseQuotient(body.principal_inverse_inertia));
}

}  // namespace

TEST_CASE("wide: what turns side by side turns as it does alone, and keeps momentum and energy to rounding") {
  for (const Real angle : {Real(1e-6), Real(0.01), Real(0.3), Real(1)}) {
    const std::vector<Body> bodies = turning(80, angle);
    for (std::size_t first = 0; first < bodies.size(); first += lanes_per_bundle) {
      EightRotations<Real> eight = eight_of(bodies, first);
      passes_of_this_processor<Real>().turn(eight, h);
      for (std::size_t i = 0; i < lanes_per_bundle; ++i) {
        INFO("body " << first + i << ", by " << angle);
        const Body& body = bodies[first + i];
        Body alone = body;
        spin_freely(alone, h);
        const Quat q = orientation_in(eight, i);
        const Vec3 w = spin_in(eight, i);
        if (body.angular_velocity.isZero(0)) {
          CHECK(q.coeffs() == body.orientation.coeffs());
          CHECK(w.isZero(0));
          continue;
        }
        const Real uneven = body.principal_inverse_inertia.maxCoeff() / body.principal_inverse_inertia.minCoeff();
        CHECK(eight.solved.values[i] == 1);
        CHECK((q.coeffs() - alone.orientation.coeffs()).norm() < 20 * uneven * eps);
        CHECK((w - alone.angular_velocity).norm() <= 20 * uneven * eps * w.norm());
        CHECK(std::abs(q.norm() - 1) < 4 * eps);
        const Vec3 before = spin_momentum(body.orientation, body.angular_velocity, body),
                   after = spin_momentum(q, w, body);
        CHECK((after - before).norm() <= 20 * uneven * eps * before.norm());
        CHECK(std::abs(w.dot(after) - body.angular_velocity.dot(before)) <= 40 * uneven * eps * w.dot(after));
        if (i % 4 == 1) CHECK(w == body.angular_velocity);
      }
    }
  }
}
