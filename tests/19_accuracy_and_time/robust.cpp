/// Robust errors: each property holds for settings of few methods, knobs, times and errors, so that many are alike. rapidcheck
/// draws them, and shrinks what fails.
#include <rapidcheck.h>

#include <algorithm>
#include <cmath>

#include "pushback/chapters/19_accuracy_and_time/front.h"
#include "tests/support/catch.h"

using namespace pushback::study;

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

Measured drawn() {
  Measured one{.engine = *rc::gen::element<std::string>("motion", "motion_ode"),
               .method = *rc::gen::element<std::string>("slim", "soft"),
               .substeps = 1 << *rc::gen::inRange(0, 5),
               .sweeps = *rc::gen::element(0, 1, 4, 16),
               .error = *rc::gen::inRange(0, 8) / 1.0,
               .seconds = {*rc::gen::inRange(1, 9) / 8.0}};
  const int end = *rc::gen::inRange(0, 12);  // one of six is lost, another given up
  one.late = end < 2;
  if (end < 4) one.error = infinite;
  return one;
}
Measurements some() {
  return *rc::gen::container<Measurements>(rc::gen::exec(drawn));
}
std::vector<double> errors_of(const Measurements& all) {
  std::vector<double> errors;
  for (const Measured& one : all) errors.push_back(one.error);
  return errors;
}

}  // namespace

TEST_CASE("a robust front is never below the plain one, and its settings are those that were measured") {
  CHECK(rc::check([] {
    const Measurements all = some(), counted = robust(all);
    RC_ASSERT(counted.size() == all.size());
    for (std::size_t i = 0; i < all.size(); ++i) {
      RC_ASSERT(counted[i].error >= all[i].error);
      RC_ASSERT(counted[i].setting() == all[i].setting());
      RC_ASSERT(counted[i].seconds == all[i].seconds);
    }
    for (double error = 0; error < 8; ++error) {
      const auto plain = cheapest(all, error), sure = cheapest(counted, error);
      RC_ASSERT((!sure || plain->median() <= sure->median()));
    }
  }));
}

TEST_CASE("what is finer has no larger robust error, and some setting that is as fine has just this error") {
  CHECK(rc::check([] {
    const Measurements all = some(), counted = robust(all);
    for (std::size_t i = 0; i < all.size(); ++i) {
      bool somebodys = all[i].error == counted[i].error;
      for (std::size_t j = 0; j < all.size(); ++j) {
        if (all[j].late || !is_as_fine(all[j], all[i])) continue;
        RC_ASSERT(counted[j].error <= counted[i].error);
        somebodys = somebodys || all[j].error == counted[i].error;
      }
      RC_ASSERT(somebodys);
    }
  }));
}

TEST_CASE("a second time changes nothing, nor does the order, nor what another method does") {
  CHECK(rc::check([] {
    const Measurements all = some(), counted = robust(all);
    RC_ASSERT(errors_of(robust(counted)) == errors_of(counted));
    Measurements turned = robust({all.rbegin(), all.rend()});
    std::reverse(turned.begin(), turned.end());
    RC_ASSERT(errors_of(turned) == errors_of(counted));
    for (const char* const method : {"slim", "soft"}) {
      const auto other = [&](const Measured& one) { return one.method != method; };
      Measurements alone = all, of_all = counted;
      std::erase_if(alone, other);
      std::erase_if(of_all, other);
      RC_ASSERT(errors_of(robust(alone)) == errors_of(of_all));
    }
  }));
}

TEST_CASE(
    "a setting that is good by chance is not chosen for it: errors cancel in it, and not in those that are finer") {
  CHECK(rc::check([] {
    // Errors fall with the step. One, not the finest, is a hundredth of what it should be, and fast enough to be chosen.
    Measurements all;
    const int lucky = *rc::gen::inRange(0, 5);
    const double times = *rc::gen::inRange(1, 100) / 10.0;
    for (int i = 0; i < 6; ++i)
      all.push_back({.engine = "motion",
                     .method = "slim",
                     .substeps = 1 << i,
                     .sweeps = 1,
                     .error = times * std::ldexp(1, -i) * (i == lucky ? 0.01 : 1),
                     .seconds = {std::ldexp(1, i)}});
    const double wanted = all[std::size_t(lucky)].error;
    RC_ASSERT(cheapest(all, wanted)->substeps == 1 << lucky);
    const auto found = cheapest(robust(all), wanted);
    RC_ASSERT((!found || found->substeps > 1 << lucky));
    for (const Measured& one : front(robust(all))) RC_ASSERT(one.error > wanted);
  }));
}

TEST_CASE("finer is no knob coarser, of the same method and engine, and given up is no error where lost is one") {
  const Measured one{.engine = "motion", .method = "slim", .substeps = 4, .sweeps = 4, .error = 1, .seconds = {1}};
  const auto changed = [&](auto change) {
    Measured other = one;
    change(other);
    return other;
  };
  CHECK(is_as_fine(one, one));
  CHECK(is_as_fine(changed([](Measured& m) { m.substeps = 8; }), one));
  CHECK(is_as_fine(changed([](Measured& m) { m.sweeps = 16; }), one));
  CHECK_FALSE(is_as_fine(changed([](Measured& m) { m.substeps = 2; }), one));
  CHECK_FALSE(is_as_fine(changed([](Measured& m) { m.substeps = 8, m.sweeps = 1; }), one));
  CHECK_FALSE(is_as_fine(changed([](Measured& m) { m.substeps = 8, m.method = "soft"; }), one));
  CHECK_FALSE(is_as_fine(changed([](Measured& m) { m.substeps = 8, m.engine = "motion_float"; }), one));
  const Measured late = changed([](Measured& m) { m.substeps = 8, m.late = true, m.error = infinite; });
  CHECK(robust({one, late})[0].error == 1);
  CHECK(robust({one, late})[1].error == infinite);
  CHECK(robust({one, changed([](Measured& m) { m.substeps = 8, m.error = infinite; })})[0].error == infinite);
  CHECK(robust({}).empty());
}
