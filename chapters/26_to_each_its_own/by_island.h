/// Each island of a world by the step that it calls for.
///
///   ByIsland solver;
///   world.step(solver, 1.0 / 60);
#pragma once

#include "pushback/chapters/22_wide/wide.h"
#include "pushback/chapters/26_to_each_its_own/calls.h"
#include "pushback/chapters/26_to_each_its_own/island_world.h"
#include "pushback/common/world/forwarding_solver.h"

namespace pushback {

/// What falls apart is solved apart: each island by what is cheapest for it, and exact enough. What that is, `Calls` says.
///
///   flight       v += h/2 g,  x += h v,  v += h/2 g: the parabola itself
///   half steps   contacts in `few`'s substeps; joints in `joined`'s
///   substeps     `many`
///
/// Where gravity and rigid joints are all that acts, the energy E = T + U stays. It is seen after each step what of it is not there:
///
///   |dE| <= energy (T + m (h g)^2 / 2)      T: the larger one of before and after,  m: the island's mass
///
/// Else the step is taken once more from where it began, in twice as many substeps; where it is less than an eighth, the next one is
/// taken in half as many. An island that half steps cannot move goes to `many`, for a while.
///
/// Between steps it remembers of each body how it was moved, and in how many substeps. A program that composes its steps by itself
/// (chapter 20's sleep) has `many` alone.
class ByIsland : public ForwardingSolver {
 public:
  Wide<Real> many;
  HalfStep few;     ///< contacts; in two substeps
  HalfStep joined;  ///< rigid joints; in four, or more
  Limits limits;
  Real energy = Real(1e-5);  ///< of T + m (h g)^2 / 2: so much of E may be off after a step
  Real turn = Real(0.04);    ///< rad: where a body of `many` turns further, contacts are detected again within the step
  int most_substeps = 128;   ///< of `joined`

  ByIsland() {
    few.substeps = 2;
    joined.substeps = 4;
    // m g times what joints are off is to be well below the least that E may be off: g h^2 / 2 of `energy`, 14 nm at 1/60 s.
    if constexpr (std::numeric_limits<Real>::digits > 24) joined.tolerance /= 10;
  }
  /// Throws as World::step does; nothing has changed then.
  void whole_step(World& world, Real dt, int sweeps) override;
  /// Call by call: `many` alone.
  void solve(World& world, Real h, int sweeps) override {
    by_calls_ = true;
    inner().solve(world, h, sweeps);
  }
  /// Of all islands.
  Solved solved() const override { return by_calls_ ? inner().solved() : solved_; }
  /// In the latest step. Of a body that was not there: nothing.
  MovedBy moved_by(int body) const { return calls_.of(body); }
  /// In how many half steps; 0 for a body that was moved otherwise.
  int substeps_of(int body) {
    return moved_by(body) == MovedBy::half_steps ? memory_[std::size_t(calls_.island_of(body))].substeps : 0;
  }

 private:
  StepSolver& inner() override { return many; }
  const StepSolver& inner() const override { return many; }

  void check_settings(World& world, Real dt);
  void find_contacts(World& world, const Plan& plan);
  void divide(World& world);
  void move_island(IslandWorld& island, const World& whole, Real dt, int sweeps);
  Real energy_off(IslandWorld& island, const World& whole, Real dt, int sweeps) const;
  void move_others(World& world, Real dt, int sweeps);
  bool others_were_met(const World& world, Real dt);
  void fly(World& world, Real dt) const;
  void put_back(World& world, Real dt);
  void add_up(const Solved& solved);

  struct Memory {
    int substeps = 0;  // of the latest step
    int next = 0;      // of the next one
    int waits = 0;     // so many steps until half steps are tried again
  };
  Calls calls_;
  Contacts found_, before_;
  std::vector<Body> moved_;           // as half steps leave them
  std::vector<IslandWorld> islands_;  // those from `count_` on are kept for their memory
  std::size_t count_ = 0;
  std::vector<int> place_;                         // of each body that is the lowest of its island, in islands_
  std::vector<Memory> memory_;                     // of each body that is one
  std::vector<Joint> joints_;                      // of the world, while it has those of `many` alone
  std::vector<std::pair<Vec3, Vec3>> velocities_;  // of those that stand still while `many` is at work
  bool by_calls_ = false;
  int detections_ = 1;  // for `many`, in this step
  Solved solved_;
};

}  // namespace pushback
