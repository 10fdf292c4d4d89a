/// What differs from chapter 08's solver by one effect: exact contacts, manifolds, conjugate sweeps, shock propagation.
#include <Eigen/LU>

#include "pushback/chapters/16_whole_problem/matrix.h"
#include "pushback/chapters/17_direct_contacts/pivoting.h"
#include "pushback/common/bodies/random.h"
#include "pushback/common/world/measure.h"
#include "tests/methods/played.h"
#include "tests/support/catch.h"
#include "tests/support/complaint.h"
#include "tests/support/on_ground.h"

using namespace pushback;

namespace {

using Cone = Solver<Clamping, Baumgarte, Slop, Restitution, FrictionCone, WarmStart>;

/// The relative residual of the problem that a solver's rows are, with the impulses that it has left.
template <class ContactSolver>
double residual_after(World world, int sweeps) {
  world.begin_step(h);
  ContactSolver solver;
  solver.solve(world, h, 0);
  const ContactProblem problem = problem_of(world.contacts, solver.rows());
  solver.solve(world, h, sweeps);
  Vector r = Vector::Zero(problem.q.size());
  const std::vector<Eigen::Index> places = places_in_problem(world.contacts, solver.rows());
  for (std::size_t i = 0; i < places.size(); ++i) r[places[i]] = static_cast<double>(solver.rows()[i].impulse);
  return relative_residual(problem, r);
}

Mat3 random_w(Random& random) {
  Mat3 w = Mat3::Zero();
  for (int i = 0; i < 3; ++i) {
    const Vec3 of = random.vector(1);
    w += of * of.transpose();
  }
  return w + Real(0.05) * Mat3::Identity();
}

}  // namespace

TEST_CASE("exact: one contact obeys Signorini and Coulomb to rounding, whether it parts, sticks or slides") {
  constexpr double rounding = in_double ? 1 : 1e7;  // of floats, in roundings of doubles
  Random random(7);
  int parted = 0, stuck = 0, slid = 0;
  for (int i = 0; i < 2000; ++i) {
    const Mat3 w = random_w(random);
    const Vec3 q = random.vector(1);
    const Real mu = random.over_decades(Real(0.05), Real(1));
    const Vec3 r = ExactContact(w, mu).solve(q), u = w * r + q;
    const double size = static_cast<double>(q.norm());
    REQUIRE(static_cast<double>(r.tail<2>().norm() - mu * r.x()) <= 1e-12 * rounding * size);
    if (r.isZero(0)) {
      REQUIRE(u.x() >= 0);
      ++parted;
      continue;
    }
    REQUIRE(std::abs(static_cast<double>(u.x())) <= 1e-11 * rounding * size);
    if (static_cast<double>(u.norm()) <= 1e-11 * rounding * size) {
      ++stuck;
      continue;
    }
    const Vec3 law = mu * r.x() * u + u.tail<2>().norm() * r;  // friction is against the slip
    REQUIRE(static_cast<double>(law.tail<2>().norm()) <=
            1e-10 * rounding * size * std::max(1.0, static_cast<double>(r.norm())));
    ++slid;
  }
  CHECK(parted > 500);
  CHECK(stuck > 30);
  CHECK(slid > 300);
}

TEST_CASE("exact: a single contact is solved in one visit, where steps on the cone take many") {
  World world;
  world.add(ground().rough(Real(0.5)));
  world.add(box({Real(0.7), Real(0.2), Real(0.3)}, 10)
                .turned(Real(0.9), Vec3(1, 0, 2).normalized())
                .at({0, Real(0.55), 0})
                .moving({1, -2, Real(0.5)}));
  world.find_contacts();
  REQUIRE(world.contacts.size() == 1);
  CHECK(residual_after<ExactSolver>(world, 1) < (in_double ? 1e-12 : 1e-6));
  CHECK(residual_after<Cone>(world, 1) > 1e-3);
}

TEST_CASE("exact: a pyramid, in the same steps and sweeps nearer to where it was") {
  CHECK(error_of<ExactSolver>("pyramid-10", 4, 4) < error_of<Cone>("pyramid-10", 4, 4) / 10);
}

TEST_CASE("block: the normals of two bodies agree with pivoting after one visit") {
  Random random(5);
  for (int i = 0; i < 50; ++i) {
    World world;
    world.add(ground().rough(0));
    world.add(box({Real(0.5), Real(0.2), Real(0.3)}, 10)
                  .at({0, Real(0.195), 0})
                  .moving(random.vector(2))
                  .spinning(random.vector(3))
                  .rough(0));
    world.begin_step(h);
    REQUIRE(world.contacts.size() == 4);
    BlockSolver solver;
    solver.solve(world, h, 0);
    const SparseRows a = matrix_of(solver.rows());
    const Vector b = speeds_of(solver.rows());
    const auto exact = solve_by_pivoting(a, b);
    REQUIRE(exact);
    solver.solve(world, h, 1);
    Vector found(4);
    for (int row = 0; row < 4; ++row)
      found[row] = static_cast<double>(solver.rows()[static_cast<std::size_t>(row)].impulse);
    // r is not unique where all four press; the speeds are
    REQUIRE((a * found - a * exact->impulses).norm() < 1e-4 * b.norm());
    REQUIRE(complementarity_error(a, b, found) < 1e-4 * b.norm());
  }
}

TEST_CASE("block: four corners bounce as one, with e times the speed") {
  World world;
  Body& flat = box_on_ground(world, Real(0.001)).bouncy(Real(0.5)).moving({0, -2, 0});
  auto solver = made<BlockSolver>();
  world.step(solver, h, 1);
  REQUIRE(world.contacts.size() == 4);
  CHECK(flat.velocity.y() == Approx(1).epsilon(1e-5));
  CHECK(flat.angular_velocity.norm() < Real(1e-5));
}

TEST_CASE("block: a stack of ten trembles less in the same steps and sweeps") {
  CHECK(error_of<BlockSolver>("stack-10", 16, 1) < error_of<Cone>("stack-10", 16, 1) / 4);
}

TEST_CASE("nncg: one sweep is a sweep, many reach farther, and the end is within the cones") {
  World one, other;
  for (World* world : {&one, &other}) pyramid(*world, 4);
  Cone plain;
  ConjugateSolver conjugate;
  for (int i = 0; i < 30; ++i) {
    one.step(plain, h, 1);
    other.step(conjugate, h, 1);
    REQUIRE(hash_of(one) == hash_of(other));
  }
  World heavy;
  motion_named("heavy-on-light").begin(heavy);
  for (Body& body : heavy.bodies)
    if (body.movable()) body.position.y() -= Real(1e-3);
  CHECK(residual_after<ConjugateSolver>(heavy, 64) < residual_after<Cone>(heavy, 64) / 10);
}

// r + B p need not be within the cones: the step ends with F(r).
TEST_CASE("nncg: whatever the number of sweeps, nothing pulls, and friction is within its cone") {
  World world;
  world.add(ground());
  for (int i = 0; i < 6; ++i) {
    const Real where = static_cast<Real>(i);
    world.add(box(Vec3::Constant(Real(0.5)), 100)
                  .turned(where, Vec3(1, where, 2).normalized())
                  .at({Real(0.2) * std::cos(2 * where), 1 + Real(1.4) * where, Real(0.2) * std::sin(2 * where)}));
  }
  ConjugateSolver conjugate;
  for (int i = 0; i < 240; ++i) {
    world.step(conjugate, h, 2 + i % 9);
    for (const Contact& at : world.contacts) {
      const Real normal = at.impulse.dot(at.normal), largest = at.friction * normal;
      REQUIRE(normal >= -tiny);
      REQUIRE((at.impulse - normal * at.normal).norm() <= largest + tiny * (1 + largest));
    }
  }
}

TEST_CASE("shock: heavy on light and a stack of ten, in the same steps and sweeps") {
  CHECK(error_of<ShockSolver>("heavy-on-light", 4, 4) < error_of<Cone>("heavy-on-light", 4, 4) / 100);
  CHECK(error_of<ShockSolver>("stack-10", 16, 1) < error_of<Cone>("stack-10", 16, 1) / 100);
}

// What is below does not feel the last pass. A plank on ice should take all that the box on it loses.
TEST_CASE("shock: momentum is not conserved") {
  const auto kept = [](auto solver, int sweeps) {
    World world;
    world.add(ground().rough(0));
    world.add(box({3, Real(0.1), 1}, 100).at({0, Real(0.1), 0}).rough(Real(0.5)));
    world.add(box(Vec3::Constant(Real(0.5)), 100).at({-2, Real(0.7), 0}).rough(Real(0.5)).moving({4, 0, 0}));
    for (int i = 0; i < 60; ++i) world.step(solver, h, sweeps);
    return momentum(world).x() / 400;
  };
  CHECK(kept(Cone{}, 4) == Approx(1).epsilon(tiny));
  CHECK(kept(ShockSolver{}, 1) == Approx(0.981).margin(0.001));  // docs/methods.md says so
  CHECK(kept(ShockSolver{}, 4) == Approx(0.998).margin(0.001));
}

TEST_CASE("shock: what meets in the air does not keep the pass from what stands elsewhere") {
  const auto top = [](Real apart) {
    World world;
    world.add(ground());
    for (const int side : {-1, 1})
      world.add(sphere(Real(0.5), 10).at({5 + static_cast<Real>(side) * apart, 40, 0}).moving({0, 0, 0}));
    for (int i = 0; i < 4; ++i)
      world.add(box(Vec3::Constant(Real(0.5)), 100).at({0, Real(0.5) + static_cast<Real>(i), 0}));
    ShockSolver solver;
    for (int i = 0; i < 60; ++i) world.step(solver, h, 2);
    return Vec3(world.bodies.back().position);
  };
  CHECK(top(Real(0.49)) == top(3));
}

TEST_CASE("shock: what hangs in the air has no height, and a number of rounds below 0 is refused") {
  World one, other;
  for (World* world : {&one, &other}) motion_named("break").begin(*world);
  auto plain = made<Cone>();
  auto shock = made<ShockSolver>();
  for (int i = 0; i < 36; ++i) {
    one.step(plain, h, 4);
    other.step(shock, h, 4);
  }
  CHECK(hash_of(one) == hash_of(other));
  shock.rounds = -1;
  CHECK(complaint([&] { other.step(shock, h, 4); }).find("rounds is -1") != std::string::npos);
}
