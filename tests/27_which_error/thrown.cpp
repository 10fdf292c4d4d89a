/// Bodies thrown freely: no end of them is let in, whichever comes first, and elastic ones keep their energy.
#include "tests/support/thrown.h"

#include "pushback/common/world/any_solver.h"
#include "pushback/engine/half_step/half_step.h"
#include "pushback/engine/presets.h"
#include "tests/support/catch.h"
#include "tests/support/yardstick.h"

using namespace pushback;

TEST_CASE("thrown bodies: no end is let in by more than a millimetre, elastic ones keep their energy") {
  HalfStep cut = at_impacts();
  cut.impacts = Impacts::sequential;
  cut.substeps = 2;
  for (const auto& [name, solver] :
       {std::pair<std::string, AnySolver>{"recommended", Recommended{}}, {"exact", Exact{}}, {"cut at impacts", cut}})
    for (std::uint64_t seed = 0; seed < 120; ++seed) {
      INFO(name << ", seed " << seed);
      AnySolver its = solver;
      const Thrown made = thrown(seed);
      const AfterThrow after = play(made, its, 2);
      CHECK(after.deepest <= Real(1e-3));
      if (in_double && made.elastic) CHECK(after.energy <= Real(1e-6));
    }
}

TEST_CASE("thrown bodies: no impact gives energy, however rough and elastic") {
  if (!in_double) return;
  for (std::uint64_t seed = 0; seed < 120; ++seed) {
    INFO("seed " << seed);
    World world = thrown(seed).world;
    HalfStep solver = at_impacts();
    solver.impacts = Impacts::sequential;
    const Real first = kinetic_energy(world);
    for (Body& body : world.bodies) body.bouncy(1).rough(Real(0.5));
    for (int i = 0; i < 120; ++i) {
      world.step(solver, h);
      CHECK(solver.taken() >= -Real(1e-8) * first);
    }
  }
}

TEST_CASE("a capsule whose far end lands while the other leaves keeps its 128.9 J") {
  if (!in_double) return;
  World world;
  world.gravity.setZero();
  world.add(box({10, Real(0.5), 10}, 1).fixed().at({0, -Real(0.5), 0}).rough(0));
  Body bar = capsule(Real(0.1), Real(0.8), 10).turned(pi / 2 + Real(0.047), Vec3::UnitZ()).at({0, Real(0.18), 0});
  world.add(bar.bouncy(1).rough(0).moving({0, -Real(1.2), 0}).spinning({0, 0, -Real(9.8)}));
  const Real first = kinetic_energy(world);
  Recommended solver;
  world.step(solver, h);
  CHECK(kinetic_energy(world) == Approx(first).epsilon(1e-6));
  CHECK(world.bodies[1].velocity.y() > 0);
  world.find_contacts();
  CHECK(deepest_overlap(world) < Real(1e-6));
}
