/// A bounce from the surface, and sequential impacts. Simultaneous ones are in simultaneous.cpp.
#include "pushback/chapters/09_impacts/from_surface.h"
#include "pushback/chapters/09_impacts/sequential.h"
#include "pushback/chapters/12_soft_contacts/soft_contacts.h"
#include "pushback/common/world/measure.h"
#include "tests/support/catch.h"
#include "tests/support/on_ground.h"

using namespace pushback;

namespace {

using FromSurface = Solver<Clamping, Baumgarte, Slop, RestitutionFromSurface>;
using Sequential = Solver<Clamping, Baumgarte, Slop, SequentialImpacts, Friction, WarmStart>;

constexpr Real radius = Real(0.3);

/// What free flight by v += h a, x += h v keeps, over g: the height of the apex above the surface, m.
Real apex_ahead(const Body& ball, Real dt) {
  const Real v = ball.velocity.y(), x = ball.position.y() - radius;
  return (v * v / 2 + g * x - g * dt * v / 2) / g;
}

/// Equal balls in a row along x that overlap by `overlap`; the first `arriving` of them come with v m/s.
void row_of_balls(World& world, int count, int arriving, Real v, Real e, Real overlap = 0) {
  world.gravity.setZero();
  for (int i = 0; i < count; ++i) {
    const Real x = static_cast<Real>(i) * (2 * radius - overlap);
    world.add(sphere(radius, 10).at({x, 0, 0}).moving({i < arriving ? v : 0, 0, 0}).bouncy(e));
  }
}

/// Newton's cradle: as many leave as arrive.
void check_cradle(const World& world, int arriving, Real v) {
  const int count = static_cast<int>(world.bodies.size());
  for (int i = 0; i < count; ++i) {
    INFO("ball " << i << ": " << world.bodies[static_cast<std::size_t>(i)].velocity.x() << " m/s");
    const Real should = i >= count - arriving ? v : 0;
    CHECK(std::abs(world.bodies[static_cast<std::size_t>(i)].velocity.x() - should) <= tiny * v);
  }
}

}  // namespace

TEST_CASE("09: from the surface, a bounce leaves e^2 of the height, wherever the ball was detected") {
  for (const Real e : {Real(0.2), Real(0.5), Real(0.9), Real(1)}) {
    for (const Real dt : {h, h / 4}) {
      for (int i = 0; i < 40; ++i) {
        World world;
        Body& ball = ball_on_ground(world, -2 - static_cast<Real>(i) * Real(0.0037)).bouncy(e);
        FromSurface solver;
        const Real before = apex_ahead(ball, dt);
        for (int step = 0; step < 600 && ball.velocity.y() <= 0; ++step) world.step(solver, dt, 1);
        INFO("e " << e << ", dt " << dt << ", detected " << world.contacts.at(0).depth << " m deep");
        REQUIRE(apex_ahead(ball, dt) == Approx(e * e * before).epsilon(tiny));
      }
    }
  }
}

TEST_CASE("09: from the surface, a bouncing ball gets no push-out on top, nor instead") {
  const auto leaves_with = [](auto solver, Real dt) {
    World world;
    Body& ball = ball_on_ground(world, Real(0.1))
                     .bouncy(Real(0.1))
                     .moving({0, -2, 0});  // the push-out asks for 1.14 m/s at 1/60 s
    world.gravity.setZero();
    world.step(solver, dt, 10);
    return ball.velocity.y();
  };
  for (const Real dt : {h, h / 32}) {
    CHECK(leaves_with(FromSurface{}, dt) == Approx(0.2).epsilon(tiny));
    CHECK(leaves_with(RelaxingSolver<Clamping, SoftContacts, RestitutionFromSurface>{}, dt) ==
          Approx(0.2).epsilon(tiny));
    CHECK(leaves_with(RelaxingSolver<Clamping, SoftContacts, Restitution, WarmStart>{}, dt) ==
          Approx(0.2).epsilon(tiny));
    CHECK(leaves_with(Solver<Clamping, Baumgarte, Slop, Restitution>{}, dt) > 1);  // the larger of the two
  }
}

TEST_CASE("09: sequential, of a row of balls that touch as many leave as arrive") {
  for (const int arriving : {1, 2, 3}) {
    for (const Real overlap : {Real(0), Real(0.001)}) {  // within the slop: nothing pushes out
      World world;
      row_of_balls(world, 5, arriving, 5, 1, overlap);
      const Real energy = kinetic_energy(world);
      const Vec3 p = momentum(world);
      Sequential solver;
      world.step(solver, h, 10);
      check_cradle(world, arriving, 5);
      CHECK(kinetic_energy(world) == Approx(energy).epsilon(tiny));
      CHECK((momentum(world) - p).norm() <= 1000 * eps * p.norm());
    }
  }
}

TEST_CASE("09: sequential, with e < 1 energy falls and momentum is conserved, and no pair is left that approaches") {
  for (const Real e : {Real(0.01), Real(0.3), Real(0.8), Real(0.99)}) {
    World world;
    row_of_balls(world, 6, 2, 5, e);
    const Real energy = kinetic_energy(world);
    const Vec3 p = momentum(world);
    Sequential solver;
    world.step(solver, h, 10);
    INFO("e " << e << ": energy " << kinetic_energy(world) / energy);
    CHECK(kinetic_energy(world) < energy);
    CHECK((momentum(world) - p).norm() <= 1000 * eps * p.norm());
    for (std::size_t i = 1; i < world.bodies.size(); ++i)
      CHECK(world.bodies[i].velocity.x() - world.bodies[i - 1].velocity.x() > -solver.threshold);
  }
}

TEST_CASE("09: sequential impacts end after their most rounds, and the sweeps stop what still approaches") {
  World world;
  row_of_balls(world, 5, 1, 5, 1);
  std::reverse(world.bodies.begin(), world.bodies.end());  // so that a round passes the impact on by one pair only
  for (std::size_t i = 0; i < world.bodies.size(); ++i) world.bodies[i].index = static_cast<int>(i);
  World enough = world;
  Sequential one, four;
  one.most_rounds = 1;
  four.most_rounds = 4;
  world.step(one, h, 200);
  enough.step(four, h, 200);
  for (std::size_t i = 1; i < 5; ++i)
    CHECK(world.bodies[i - 1].velocity.x() - world.bodies[i].velocity.x() > Real(-1e-3));
  CHECK(world.bodies[0].velocity.x() < 2);
  CHECK(enough.bodies[0].velocity.x() == Approx(5).epsilon(tiny));
}
