/// The solver that is composed of seven effects and the one written out by hand: the same bits.
#include "pushback/chapters/07_warm_start/flat.h"

#include <array>

#include "pushback/chapters/07_warm_start/full_solver.h"
#include "pushback/common/world/measure.h"
#include "pushback/common/world/situations.h"
#include "tests/support/catch.h"
#include "tests/support/random.h"

using namespace pushback;

namespace {

/// How many contact points were compared, of each state.
struct Seen {
  int fresh = 0, warm = 0, sliding = 0, sticking = 0;
  void add(ContactState state) {
    ++(state == ContactState::fresh     ? fresh
       : state == ContactState::warm    ? warm
       : state == ContactState::sliding ? sliding
                                        : sticking);
  }
};

/// 300 steps with each; `dt_of` and `sweeps_of` say how long and how thorough a step is.
template <class Fill, class StepLength, class Sweeps>
Seen compare(const Fill& fill, const StepLength& dt_of, const Sweeps& sweeps_of, FullSolver full = {},
             FlatSolver flat = {}) {
  World composed, by_hand;
  fill(composed);
  fill(by_hand);
  Seen seen;
  for (int step = 0; step < 300; ++step) {
    composed.step(full, dt_of(step), sweeps_of(step));
    by_hand.step(flat, dt_of(step), sweeps_of(step));
    INFO("step " << step);
    REQUIRE(hash_of(composed) == hash_of(by_hand));
    REQUIRE(composed.contacts.size() == by_hand.contacts.size());
    for (std::size_t i = 0; i < composed.contacts.size(); ++i) {
      const Contact &p = composed.contacts[i], &q = by_hand.contacts[i];
      REQUIRE(p.id == q.id);
      REQUIRE(p.impulse == q.impulse);
      if (sweeps_of(step) == 0) continue;  // nothing has asked yet whether friction holds
      REQUIRE(p.state == q.state);
      seen.add(p.state);
    }
  }
  return seen;
}

Real sixtieth(int) {
  return Real(1) / 60;
}
int ten_sweeps(int) {
  return 10;
}

/// Spheres, boxes and capsules, rough and bouncy to various degrees, thrown together.
void pile(World& world) {
  Random random(11);
  world.add(ground().rough(Real(0.7)).bouncy(Real(0.1)));
  for (int i = 0; i < 40; ++i) {
    const Real mass = random.over_decades(1, 100);
    Body body = random.body(mass);
    Vec3 place = random.vector(Real(1.5));
    place.y() = 1 + static_cast<Real>(i) * Real(0.4);
    body.at(place).moving(random.vector(2)).spinning(random.vector(3));
    const Real mu = random.between(0, 1), e = random.between(0, Real(0.6));
    world.add(body.rough(mu).bouncy(e));
  }
}

}  // namespace

TEST_CASE("a stack of ten: FlatSolver and FullSolver agree to the last bit") {
  const Seen seen = compare([](World& world) { stack(world, 10); }, sixtieth, ten_sweeps);
  CHECK(seen.sticking > 1000);
}

TEST_CASE("a pyramid eight wide: likewise") {
  const Seen seen = compare([](World& world) { pyramid(world, 8); }, sixtieth, ten_sweeps);
  CHECK(seen.sticking > 1000);
}

TEST_CASE("a pile of everything: likewise") {
  const Seen seen = compare(pile, sixtieth, ten_sweeps);
  CHECK(seen.fresh > 100);
  CHECK(seen.sliding > 100);
  CHECK(seen.sticking > 100);
}

TEST_CASE("steps of changing length, from no sweep to 30: likewise") {
  const auto dt_of = [](int step) { return Real(1) / static_cast<Real>(60 + 30 * (step % 7)); };
  const Seen seen = compare(pile, dt_of, [](int step) { return step % 31; });
  CHECK(seen.sliding > 100);
}

TEST_CASE("other parameters: likewise") {
  for (const auto& [beta, slop, threshold] :
       {std::array<Real, 3>{0, 0, 0}, {Real(0.6), Real(0.01), 1}, {1, 0, Real(0.3)}}) {
    FullSolver full;
    FlatSolver flat;
    full.beta = flat.beta = beta;
    full.slop = flat.slop = slop;
    full.threshold = flat.threshold = threshold;
    compare(pile, sixtieth, ten_sweeps, full, flat);
  }
}

TEST_CASE("and they would be told apart: a slop that differs in its last bit is found") {
  World composed, by_hand;
  pile(composed);
  pile(by_hand);
  FullSolver full;
  FlatSolver flat;
  flat.slop = std::nextafter(flat.slop, Real(1));
  int steps = 0;
  while (steps < 300 && hash_of(composed) == hash_of(by_hand)) {
    composed.step(full, sixtieth(0), 10);
    by_hand.step(flat, sixtieth(0), 10);
    ++steps;
  }
  CHECK(steps < 300);
}
