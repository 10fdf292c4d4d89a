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

TEST_CASE("thrown bodies: few of 4,000 throws are let in by more, and none by more than 23 mm", "[checked]") {
  if (!in_double) return;
  int deep = 0;
  Real deepest = 0;
  for (std::uint64_t seed = 0; seed < 4000; ++seed) {
    Recommended solver;
    const AfterThrow after = play(thrown(seed), solver, 2);
    deep += after.deepest > Real(1e-3);
    deepest = std::max(deepest, after.deepest);
  }
  INFO(deep << " throws, " << deepest << " m");
  CHECK(deep <= 10);
  CHECK(deepest < Real(0.023));
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
      CHECK(solver.dissipated_energy() >= -Real(1e-8) * first);
    }
  }
}
