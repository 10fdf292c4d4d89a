/// For the tests of every solver that only what a scene calls for is run of.
#pragma once

#include "pushback/chapters/20_only_what_is_needed/dispatch.h"
#include "pushback/common/world/measure.h"
#include "pushback/common/world/situations.h"
#include "tests/support/catch.h"
#include "tests/support/yardstick.h"

namespace pushback {

/// A stack of three moves in the same bits with what is called for, then rests asleep, until a ball hits it.
template <class AnySolver>
void check_called_for_and_asleep(AnySolver solver) {
  World world, needed;
  for (World* each : {&world, &needed}) stack(*each, 3);
  OnlyWhatIsNeeded chosen(needed, solver);
  for (int i = 0; i < 60; ++i) {
    world.step(solver, h);
    chosen.step(needed, h, 1);
    REQUIRE(hash_of(world) == hash_of(needed));
  }
  OnlyWhatIsNeeded resting(world, solver, Sleep{});
  for (int i = 0; i < 120; ++i) resting.step(world, h, 1);
  for (int i = 1; i <= 3; ++i) CHECK(world.bodies[static_cast<std::size_t>(i)].asleep);
  world.add(sphere(Real(0.3), 50).at({-3, Real(0.5), 0}).moving({6, 0, 0}));
  for (int i = 0; i < 30; ++i) resting.step(world, h, 1);
  CHECK_FALSE(world.bodies[1].asleep);
  CHECK(world.bodies[1].position.x() > Real(0.01));
}

}  // namespace pushback
