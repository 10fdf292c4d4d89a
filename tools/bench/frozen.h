/// One step's contacts, to be solved again and again.
#pragma once

#include "pushback/chapters/07_warm_start/full_solver.h"
#include "pushback/common/world/situations.h"
#include "pushback/tools/bench/in_turn.h"

namespace pushback {

/// A pyramid that has come to rest, its contacts found: `base` 20 has 210 boxes and about 1,600 points. Every solve is of
/// the same step, because velocities are restored before it. (A solved one would have nothing to do, and rows at the limit
/// 0 do not wait for their speed.) The same solver has run just before, so that its rows are in the cache.
class FrozenPyramid {
 public:
  World world;

  explicit FrozenPyramid(int base, Real dt = Real(1) / 60) : dt_(dt) {
    pyramid(world, base);
    FullSolver solver;
    for (int step = 0; step < 60; ++step) world.step(solver, dt, 10);
    world.begin_step(dt);
    before_ = world.bodies;
  }
  /// The same pyramid with this mu everywhere from now on.
  FrozenPyramid& rubbing(Real mu) {
    for (Body& body : world.bodies) body.rough(mu);
    world.find_contacts();
    before_ = world.bodies;
    return *this;
  }
  FrozenPyramid(const FrozenPyramid&) = delete;
  FrozenPyramid& operator=(const FrozenPyramid&) = delete;

  /// s, of one solve, and of what comes after the bodies have moved where there is something.
  template <class ContactSolver>
  [[gnu::noinline]] double seconds(ContactSolver& solver, int sweeps = 10) {
    const auto solve = [&] {
      solver.solve(world, dt_, sweeps);
      solver.after_move(world, dt_);
    };
    put_back();
    solve();
    world.contacts_before =
        world.contacts;  // the next solve starts from what it has found itself, whoever has settled the pyramid
    put_back();
    return seconds_of(solve);
  }
  /// A round in which each of these solvers has its turn.
  template <class... Solvers>
  void round(InTurn& turns, int sweeps, Solvers&... solvers) {
    turns.round({[this, sweeps, &solvers] { return seconds(solvers, sweeps); }...});
  }
  double contacts() const { return static_cast<double>(world.contacts.size()); }

 private:
  void put_back() { std::copy(before_.begin(), before_.end(), world.bodies.begin()); }
  Real dt_;
  std::vector<Body> before_;
};

}  // namespace pushback
