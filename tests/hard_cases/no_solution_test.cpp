/// Painleve's rod is where it is said to be, and a solver that has converged does what the closed form says.
#include <cmath>

#include "pushback/chapters/07_warm_start/full_solver.h"
#include "pushback/tools/measure/hard_cases/paradox.h"
#include "tests/support/catch.h"

using namespace pushback;

TEST_CASE("Painleve's rod: pressing draws the tip in, and the impulse that stops it lies within the cone") {
  World world;
  sliding_rod(world);
  const Paradox paradox = paradox_of(world, 0);
  // Of a thin rod at tan(a) = 2 with mu = 2: m k = 1 + 3 / 5 - 2 * 6 / 5. The thickness, 2 % of
  // the length, takes 2 % * tan(a) = 4 % from r_x.
  CHECK(paradox.normal_mass == Approx(Real(-0.8)).epsilon(0.05));
  CHECK(paradox.cone_share == Approx(Real(2) / 3).epsilon(0.05));
  CHECK(paradox.turning == Approx(-3 / std::sqrt(Real(5))).epsilon(0.05));  // 3 v sin(a) / (4 l)

  // By the engine's own rows: the effective mass along n - mu t is below 0.
  world.find_contacts();
  REQUIRE(world.contacts.size() == 2);
  const Row normal(world, world.contacts[0], Vec3::UnitY(), 0), tangent(world, world.contacts[0], Vec3::UnitX(), 0);
  const Real k_nt = normal.n.dot(tangent.dvb) + normal.rb_n.z() * tangent.dwb.z();  // in the plane
  const Real in_plane = 1 + normal.rb_n.z() * normal.dwb.z();
  CHECK(in_plane - 2 * k_nt ==
        Approx(paradox.normal_mass).epsilon(1e-4));  // a contact lies midway in the 0.01 mm of overlap
}

TEST_CASE("Painleve's rod: solved to the end, the tip stops in one step and the rod turns by the closed form") {
  World world;
  sliding_rod(world);
  constexpr Real dt = Real(1) / 60;
  const Paradox paradox = paradox_of(world, dt);
  world.begin_step(dt);
  Solver<Clamping, Friction> solver;
  solver.solve(world, dt, 2000);
  const Body& rod = world.bodies.back();
  CHECK(rod.velocity_at(world.contacts[0].point).norm() < Real(1e-9));
  CHECK(rod.angular_velocity.z() == Approx(paradox.turning).epsilon(1e-5));
}
