/// What rolls over tiles that lie flush, by half steps: edges that it hardly touches make systems that are nearly singular.
#include <cmath>

#include "pushback/common/bodies/random.h"
#include "pushback/common/world/measure.h"
#include "pushback/engine/islands/island_solver.h"
#include "tests/support/catch.h"
#include "tests/support/tiles.h"
#include "tests/support/yardstick.h"

using namespace pushback;

TEST_CASE("by island: a capsule that rolls over the seams of tiles gains no energy") {
  for (unsigned seed = 1; seed <= 40; ++seed) {
    Random random(seed);
    const Real heading = random.between(0, Real(6.28));
    random.between(0, Real(6.28));  // a turn that round bodies do without
    const Real speed = random.between(1, 5), radius = Real(0.2), tile = Real(0.25);
    // Drawn one after the other, because compilers differ in the order of arguments.
    const Real from_z = random.between(Real(-0.5), Real(0.5)), from_x = random.between(Real(-0.5), Real(0.5));
    const Vec3 from(from_x, 0, from_z);
    const Vec3 along(std::cos(heading), 0, std::sin(heading)), axis = Vec3::UnitY().cross(along);
    World world;
    add_tiles(world, tile, from, along, 13, Real(1.2), Real(0.2));
    Body body = capsule(radius, Real(0.3), 10);
    body.oriented(Quat::FromTwoVectors(Vec3::UnitY(), Vec3(-axis)));
    body.at(from + Vec3(0, radius - Real(1e-5), 0)).moving(speed * along).spinning(speed / radius * axis);
    const auto which = static_cast<std::size_t>(world.add(body.rough(Real(0.2))));
    IslandSolver solver;
    const auto energy = [&world] { return kinetic_energy(world) + potential_energy(world); };
    const Real begun = energy(), freed = Real(1e-4) / world.bodies[which].inverse_mass * World::g;
    for (int i = 0; i < 150; ++i) {
      world.step(solver, h);
      REQUIRE(energy() < begun + freed + Real(1e-3) * begun);
    }
  }
}
