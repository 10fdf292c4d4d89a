/// Conjugate sweeps, which differ from chapter 08's solver by one effect.
#include "pushback/common/world/measure.h"
#include "pushback/engine/direct/row_matrix.h"
#include "tests/methods/played.h"
#include "tests/support/catch.h"
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

}  // namespace

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
