/// Chapter 27: the two estimates of plain.h, compared with closed forms and with the true error of many bars.
#include "pushback/chapters/27_which_error/plain.h"

#include "tests/support/catch.h"
#include "tests/support/yardstick.h"

using namespace pushback;
using namespace pushback::plain_27;

namespace {

Real energy(const Bar& bar) {
  return (bar.v * bar.v + inertia * bar.spin * bar.spin) / 2 + World::g * bar.y;
}

/// m: the largest true error of a bar in two seconds, and the largest that each estimate says.
struct Largest {
  Real error = 0, halves = 0, twin = 0;
};
Largest largest_of(const Bar& begin) {
  Played played{begin, begin};
  Bar truth = begin;
  Largest of;
  for (int i = 0; i < 120; ++i) {
    play_step(played, h);
    truth = step(truth, h, 4096);
    of.error = std::max(of.error, std::abs(played.bar.y - truth.y));
    of.halves = std::max(of.halves, played.halves);
    of.twin = std::max(of.twin, played.said_by_twin());
  }
  return of;
}

}  // namespace

TEST_CASE("plain estimates: while a bar falls, halves say its true error, and the twin 1.38 times that") {
  const Bar begin{20, 1, 1, 2};
  Played played{begin, begin};
  for (int i = 1; i <= 60; ++i) {
    play_step(played, h);
    const Real t = static_cast<Real>(i) * h, error = World::g * h * t / (2 * fine);
    const Real true_y = begin.y + begin.v * t - World::g * t * t / 2;
    CHECK(true_y - played.bar.y == Approx(error));
    CHECK(played.halves == Approx(error));
    CHECK(played.said_by_twin() == Approx(error * (Real(fine) / coarse - 1) / 2));
  }
}

TEST_CASE("plain estimates: a bounce keeps the energy, and leaves no end below the floor") {
  for (int degrees = 1; degrees < 90; degrees += 4)
    for (const Real spin : {Real(-6), Real(0), Real(6)}) {
      Bar bar{1, -3, static_cast<Real>(degrees) * pi / 180, spin};
      const Real before = energy(bar);
      bounce(bar, lower_arm(bar));
      CHECK(energy(bar) == Approx(before));
    }
  for (int degrees = 0; degrees <= 90; degrees += 5) {
    Bar bar{1, 0, static_cast<Real>(degrees) * pi / 180, 0};
    for (int i = 0; i < 120; ++i) {
      bar = step(bar, h, fine);
      REQUIRE(gap(bar) > Real(-1e-9));
    }
  }
}

TEST_CASE("plain estimates: of bars, halves say less than a third of the error far more often than a twin") {
  int bars = 0, past_halves = 0, past_twin = 0;
  for (Real height = Real(0.6); height < 2; height += Real(0.1))
    for (Real angle = Real(0.07); angle < Real(1.5); angle += Real(0.15)) {
      const Largest of = largest_of({height, 0, angle, 0});
      ++bars;
      past_halves += of.error > 3 * of.halves;
      past_twin += of.error > 3 * of.twin;
    }
  INFO(past_halves << " and " << past_twin << " of " << bars);
  CHECK(past_halves > bars / 8);
  CHECK(past_twin < bars / 16);
}

TEST_CASE(
    "plain estimates: the error of the page's bar exceeds what halves say nine times, and what its twin says by less "
    "than 2") {
  const Largest of = largest_of({1, 0, Real(0.7), 0});
  CHECK(of.error / of.halves == Approx(9.4).margin(0.2));
  CHECK(of.error < 2 * of.twin);
}
