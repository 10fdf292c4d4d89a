/// Chapter 26: what holds of savings whatever happens. rapidcheck draws what happens, and shrinks what fails.
#include <rapidcheck.h>

#include <cmath>
#include <vector>

#include "pushback/chapters/26_to_each_its_own/savings.h"
#include "tests/support/catch.h"

using namespace pushback;

namespace {

/// Sums of thousands of numbers are rounded.
bool at_most(double number, double bound) {
  return number <= bound * (1 + 1e-9) + 1e-6;
}

struct Step {
  double price;   // multiplications, of substeps
  double calls;   // of half steps, in parts of the price
  bool succeeds;  // if they are not stopped before
};
Step drawn_step() {
  return {1e3 * *rc::gen::inRange(1, 400), *rc::gen::inRange(0, 1200) / 40.0, *rc::gen::inRange(0, 3) == 0};
}
Savings drawn_savings() {
  return {.part = *rc::gen::inRange(0, 9) / 8.0,
          .at_first = *rc::gen::inRange(0, 500) * 1.0,
          .most = *rc::gen::inRange(1, 200) * 1.0,
          .at_once = *rc::gen::inRange(1, 40) * 1.0};
}

/// What an island does, as ByIsland does it: what it takes by half steps, by substeps, and would have taken by substeps alone.
struct Life {
  double failing = 0, succeeding = 0, substeps = 0, alone = 0;
  Purse purse;

  explicit Life(const Savings& savings) : purse(savings.at_first * savings.of_contact) {}
  void take(const Step& step, const Savings& savings) {
    alone += step.price;
    if (purse.can_pay(step.price)) {
      const double before = purse.saved(), most = std::min(before, savings.at_once * step.price);
      RC_ASSERT(most > 0);
      const double took = std::min(step.calls * step.price, most);
      if (step.succeeds && step.calls * step.price < most) {
        succeeding += took;
        purse.succeed(step.price - took, savings.most * step.price);
        return;
      }
      failing += took;
      purse.fail(took, savings.at_once);
      RC_ASSERT(at_most(before - purse.saved(), before));
      RC_ASSERT(purse.saved() >= 0);
    }
    substeps += step.price;
    purse.save(savings.part * step.price, savings.most * step.price);
  }
};

}  // namespace

TEST_CASE("savings, drawn: tries that fail take at most `part` of what substeps take, and what there was at first") {
  CHECK(rc::check([] {
    const Savings savings = drawn_savings();
    Life life(savings);
    for (Step step : *rc::gen::container<std::vector<Step>>(rc::gen::exec(drawn_step))) {
      step.succeeds = false;
      life.take(step, savings);
      RC_ASSERT(at_most(life.failing, savings.part * life.substeps + savings.at_first * savings.of_contact));
    }
  }));
}

TEST_CASE(
    "savings, drawn: an island takes at most 1 + `part` times as long as by substeps alone, but for what it had") {
  CHECK(rc::check([] {
    const Savings savings = drawn_savings();
    Life life(savings);
    for (const Step& step : *rc::gen::container<std::vector<Step>>(rc::gen::exec(drawn_step))) {
      life.take(step, savings);
      RC_ASSERT(at_most(life.failing + life.succeeding + life.substeps,
                        (1 + savings.part) * life.alone + savings.at_first * savings.of_contact));
    }
  }));
}

TEST_CASE(
    "savings, drawn: nothing is won or lost where islands join and fall apart, and all need what the worst needed") {
  CHECK(rc::check([] {
    std::vector<Purse> shares;
    std::vector<double> needs;
    for (const int saved : *rc::gen::container<std::vector<int>>(rc::gen::inRange(1, 1000000))) {
      shares.emplace_back(saved);
      const int failures = *rc::gen::inRange(0, 4);
      for (int i = 0; i < failures; ++i) shares.back().fail(0, 20);
      needs.push_back(std::exp2(failures));
    }
    const auto all = [&] {
      double sum = 0;
      for (const Purse& share : shares) sum += share.saved();
      return sum;
    };
    const double begin = all();
    const int steps = *rc::gen::inRange(1, 5);
    for (int step = 0; step < steps; ++step) {
      std::vector<Purse> purses(3);
      std::vector<double> worst(3, 1);
      std::vector<std::size_t> island;
      for (std::size_t i = 0; i < shares.size(); ++i) {
        island.push_back(*rc::gen::inRange<std::size_t>(0, purses.size()));
        purses[island[i]].add(shares[i]);
        worst[island[i]] = std::max(worst[island[i]], needs[i]);
      }
      for (std::size_t i = 0; i < shares.size(); ++i) {
        shares[i] = purses[island[i]].share();
        needs[i] = worst[island[i]];
        const double dearest = shares[i].saved() / needs[i];
        RC_ASSERT(shares[i].can_pay(dearest * (1 - 1e-9)));
        RC_ASSERT(!shares[i].can_pay(dearest * (1 + 1e-9)));
      }
      RC_ASSERT(std::abs(all() - begin) <= 1e-9 * begin);
    }
  }));
}
