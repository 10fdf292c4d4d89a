/// Chapter 26: what is saved for half steps where contacts are many, and what it is spent on.
#include "pushback/engine/islands/work_budget.h"

#include "pushback/common/bodies/random.h"
#include "pushback/common/world/situations.h"
#include "pushback/engine/islands/island_solver.h"
#include "tests/26_to_each_its_own/falling_heap.h"
#include "tests/support/catch.h"
#include "tests/support/yardstick.h"

using namespace pushback;
using to_each_its_own_tests::falling_heap;

namespace {

/// A try of half steps in an island with many contacts.
struct Try {
  double allowed, work, price;  // multiplications; of the substeps that it replaces
  bool falls_back, held;
};
std::vector<Try> tries_of(const IslandSolver& solver) {
  std::vector<Try> tries;
  for (std::size_t i = 0; i < solver.islands().size(); ++i) {
    const IslandWorld& island = solver.islands()[i];
    if (!solver.classifier().many_contacts(island.lowest())) continue;
    const StepReason reason = solver.classifier().reason_of(island.lowest());
    if (type_of(reason) == StepType::substeps && reason != StepReason::failed) continue;
    const HalfStep& half_step = island.half_step;
    tries.push_back({half_step.most_work, half_step.work(),
                     WorkBudgets::price(island.lowest(), solver.classifier(), solver.budget),
                     half_step.fall_back_to_full_solve, type_of(reason) == StepType::half_steps});
  }
  return tries;
}
/// Multiplications in this step, of all islands with many contacts that had substeps.
double price_of_substeps(const World& world, const IslandSolver& solver) {
  StepClassifier islands = solver.classifier();
  double price = 0;
  for (const Body& body : world.bodies)
    if (body.movable() && islands.island_of(body.index) == body.index && islands.many_contacts(body.index) &&
        solver.step_of(body.index) == StepType::substeps)
      price += WorkBudgets::price(body.index, islands, solver.budget);
  return price;
}

/// For ten seconds, from a start that is a little off.
void rests(int boxes, int start) {
  CAPTURE(boxes, start);
  World world;
  stack(world, boxes);
  Random random(static_cast<std::uint64_t>(start));
  for (Body& body : world.bodies)
    if (body.movable()) body.position += random.vector(Real(1e-6));
  IslandSolver solver;
  int by_half_steps = 0;
  for (int i = 0; i < 600; ++i) {
    world.step(solver, h);
    for (const Body& body : world.bodies) by_half_steps += solver.step_of(body.index) == StepType::half_steps;
  }
  CHECK(by_half_steps == 600 * boxes);
  Real fastest = 0;
  for (const Body& body : world.bodies)
    fastest = std::max({fastest, body.velocity.norm(), body.angular_velocity.norm()});
  CHECK(fastest < (in_double ? Real(1e-9) : Real(1e-3)));  // m/s, rad/s
}

}  // namespace

TEST_CASE("savings: they are shared out equally, and bounded; nobody has debts; who fails is to need more next time") {
  WorkBudget island;
  for (const double saved : {100.0, 20.0, 0.0}) island.add(WorkBudget(saved));
  for (int i = 0; i < 3; ++i) CHECK(island.share().saved() == 40);
  WorkBudget failed(1000);
  CHECK(failed.can_pay(1000));
  failed.fail(10, 20);
  CHECK_FALSE(failed.can_pay(900));
  failed.succeed(0, 1e9);
  CHECK(failed.can_pay(900));

  WorkBudget purse(50);
  purse.save(30, 100);
  CHECK(purse.saved() == 80);
  purse.save(30, 100);
  CHECK(purse.saved() == 100);
  purse.save(30, 60);  // fewer contacts than before
  CHECK(purse.saved() == 100);
  purse.succeed(-150, 100);
  CHECK(purse.saved() == 0);
  purse.save(5, 100);
  purse.fail(7, 20);
  CHECK(purse.saved() == 0);
  CHECK_FALSE(purse.can_pay(1));
}

TEST_CASE("by island: stacks have half steps all the time, and rest") {
  for (const int boxes : {10, 40})
    for (int start = 1; start <= 10; ++start) rests(boxes, start);
}

TEST_CASE("by island: what half steps take of a heap that falls and comes to rest is bounded by what substeps take") {
  double overrun = 0;
  int failed = 0, held = 0;
  for (const int start : {1, 2, 3}) {
    CAPTURE(start);
    World world = falling_heap(static_cast<std::uint64_t>(start));
    IslandSolver solver;
    double all = 0, alone = 0;
    const double at_first = 64 * solver.budget.at_first * solver.budget.per_contact;
    for (int i = 0; i < 600; ++i) {
      world.step(solver, h);
      const double price = price_of_substeps(world, solver);
      alone += price;
      all += price;
      for (const Try& tried : tries_of(solver)) {
        CHECK(tried.allowed <= solver.budget.at_once * tried.price);
        CHECK_FALSE(tried.falls_back);
        overrun = std::max(overrun, tried.work / tried.allowed);
        all += std::min(tried.work, tried.allowed);
        if (tried.held) alone += tried.price;
        ++(tried.held ? held : failed);
      }
      CHECK(all <= (1 + solver.budget.fraction) * alone + at_first);
    }
  }
  CHECK(failed > 0);
  CHECK(held > 0);
  CHECK(overrun < 1.1);  // what had been begun
}

TEST_CASE("by island: an island that meets others within a step has the work that is left for its next try") {
  World world;
  world.add(ground());
  Random random(1);
  for (int i = 0; i < 10; ++i) {
    const Real x = random.between(Real(-0.05), Real(0.05)), z = random.between(Real(-0.05), Real(0.05));
    world.add(box({Real(0.25), Real(0.25), Real(0.25)}, 1).at({x, 1 + Real(0.6) * static_cast<Real>(i), z}));
  }
  IslandSolver solver;
  const double most = solver.contact_half_step.most_work;
  double least = most;
  for (int i = 0; i < 60; ++i) {
    world.step(solver, h);
    for (std::size_t k = 0; k < solver.islands().size(); ++k) {
      const IslandWorld& island = solver.islands()[k];
      if (solver.classifier().many_contacts(island.lowest())) continue;
      CHECK(island.half_step.most_work <= most);
      least = std::min(least, island.half_step.most_work);
    }
  }
  CHECK(least < most);
}

TEST_CASE("by island: the first step of touching balls stays within its bound, however many there are") {
  for (const int across : {4, 8, 12}) {
    CAPTURE(across);
    World world;
    world.add(ground());
    for (int i = 0; i < across * across * across; ++i)
      world.add(sphere(Real(0.5), 1)
                    .at({static_cast<Real>(i % across), static_cast<Real>(i / across / across) + Real(0.5),
                         static_cast<Real>(i / across % across)}));
    IslandSolver solver;
    world.step(solver, h);
    REQUIRE(tries_of(solver).size() == 1);
    const Try first = tries_of(solver).front();
    CHECK(first.held == (across == 4));
    CHECK(first.work < 2 * first.allowed);  // the last matrix may exceed the bound, but is not larger than it
    if (across < 12) continue;
    CHECK(first.work < 2 * first.price);  // a single matrix is too large, and is not made
    for (int i = 0; i < 9; ++i) {         // nor tried again soon
      world.step(solver, h);
      CHECK(tries_of(solver).empty());
    }
  }
}
