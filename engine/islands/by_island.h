/// Each island of a world by the step that it calls for.
///
///   ByIsland solver;
///   world.step(solver, 1.0 / 60);
#pragma once

#include <limits>

#include "pushback/common/world/forwarding_solver.h"
#include "pushback/engine/islands/calls.h"
#include "pushback/engine/islands/island_world.h"
#include "pushback/engine/islands/savings.h"
#include "pushback/engine/substeps/wide.h"

namespace pushback {

/// What falls apart is solved apart: each island by what is cheapest for it, and exact enough. What that is, `Calls` says.
///
///   flight       v += h/2 g,  x += h v,  v += h/2 g: the parabola itself
///   half steps   contacts in `few`'s substeps; joints in `joined`'s, with contacts or without
///   substeps     `many`
///
/// What rests costs half steps next to nothing, however many contacts it has; what tumbles can cost them a hundred times what
/// substeps cost. So where contacts are many, half steps have to be paid for from savings: see savings.h.
///
/// Where gravity and rigid joints are all that acts, the energy E = T + U stays. It is seen after each step what of it is not there:
///
///   |dE| <= energy (T + m (h g)^2 / 2)      T: the larger one of before and after,  m: the island's mass
///
/// Else the step is taken once more from where it began, in twice as many substeps; where it is less than an eighth, the next one is
/// taken in half as many. What impacts take is known and is no error. Friction takes something as well, so where contacts are held, only
/// what E gains counts; and what overlaps comes out, which lifts the island by no more than that. An island that half steps cannot
/// move goes to `many`, for a while.
///
/// Between steps it remembers of each body how it was moved, and in how many substeps. A program that composes its steps by itself
/// (chapter 20's sleep) has `many` alone.
class ByIsland : public ForwardingSolver {
 public:
  Wide<Real> many;
  HalfStep few;     ///< contacts; in two substeps. Its threshold is that of joined bodies, too
  HalfStep joined;  ///< rigid joints; in four, or more
  Limits limits;
  Real energy = Real(1e-5);  ///< of T + m (h g)^2 / 2: so much of E may be off after a step
  int most_substeps = 128;   ///< of `joined`
  Savings savings;           ///< for half steps where contacts are many

  ByIsland() {
    few.substeps = 2;
    few.most_work = joined.most_work = 1e6;  // one or two ms
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

 protected:
  struct Memory {
    int substeps = 0;  // of the latest step
    int next = 0;      // of the next one
    int waits = 0;     // so many steps until half steps are tried again
    int failures = 0;  // in a row, where joined bodies are near to something
  };
  /// An island is moved by half steps: `held`, in how many `substeps`, and how many the next step is to begin with.
  virtual void find_substeps(IslandWorld& island, Memory& memory, const World& whole, Real dt, int sweeps);
  /// From where its bodies are in the whole world. Returns |dE| in parts of what is allowed: 0 where E need not stay, infinity where
  /// half steps do not get there.
  Real take(IslandWorld& island, const World& whole, int substeps, Real dt, int sweeps) const;
  /// Whether what is left of `most_work` is enough for twice as many substeps. All tries of joined bodies with contacts share it.
  static bool can_go_on(IslandWorld& island) {
    return !island.joined_and_near() || island.solver().most_work > 2 * island.took;
  }
  /// More than these an island does not get.
  int most_half_steps(const IslandWorld& island, Real dt) const;
  /// In how many parts a free body turns.
  virtual int parts_of_flight(const Body& /*body*/, Real /*dt*/) const { return 1; }
  /// All that `many` moves. What is moved otherwise stands still meanwhile, and its joints are not there.
  virtual void move_others(World& world, Real dt, int sweeps);

  /// The feature id of a pair that is near but has no contact.
  static constexpr std::uint32_t beside = std::numeric_limits<std::uint32_t>::max();

  Calls calls_;
  Contacts found_;  // in this step, by detection
  Solved solved_;   // of all islands so far

 private:
  StepSolver& inner() override { return many; }
  const StepSolver& inner() const override { return many; }

  void check_settings(World& world, Real dt);
  void find_contacts(World& world, const Plan& plan, Real dt);
  void collect(const World& world);
  void share_out(const World& world);
  void divide(World& world);
  bool can_pay(int island) const {
    return !calls_.many(island) || purses_[std::size_t(island)].can_pay(savings.of_contact * calls_.contacts(island));
  }
  void move_island(IslandWorld& island, const World& whole, Real dt, int sweeps);
  bool lets_in(const IslandWorld& island);
  bool others_were_met(const World& world, Real dt);
  template <class Wanted>
  bool find_more(const World& world, const std::vector<Real>& ways, const Wanted& wanted);
  void fly(World& world, Real dt) const;
  void put_back(World& world, Real dt);
  void add_up(const Solved& solved);

  std::vector<Purse> shares_;  // of each body
  std::vector<Purse> purses_;  // of each body that is the lowest of its island: of them all
  Contacts before_;
  std::vector<IslandWorld> islands_;  // those from `count_` on are kept for their memory
  std::size_t count_ = 0;
  std::vector<int> place_;                         // of each body that is the lowest of its island, in islands_
  std::vector<Memory> memory_;                     // of each body that is one
  std::vector<Joint> joints_;                      // of the world, while it has those of `many` alone
  std::vector<std::pair<Vec3, Vec3>> velocities_;  // of those that stand still while `many` is at work
  bool by_calls_ = false;
  int detections_ = 1;  // for `many`, in this step
};

}  // namespace pushback
