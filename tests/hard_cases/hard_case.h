/// A situation known to break contact solvers, and the numbers by which it counts as survived.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "common/scene.h"
#include "tests/hard_cases/stages.h"
#include "tests/hard_cases/watcher.h"

namespace pushback {

class Trial;

/// One world under one stage's solver, watched.
class Play {
 public:
  World world;

  /// Moves on by one step of dt. Does nothing any more once a number is not finite, or the solver has refused the world.
  void step(Real dt = Real(1) / 60);
  /// As many steps as make up `seconds`; `after_each` may look at the world, or poke it.
  void run(Real seconds, Real dt = Real(1) / 60, const std::function<void(World&)>& after_each = {});
  /// False once a number was not finite, or the solver has refused the world: what is measured then says nothing.
  bool sound() const { return sound_; }
  const Watcher& watcher() const { return watcher_; }

 private:
  friend class Trial;
  Play(Trial& trial, World start, const Allowance& allowance, bool doubled);

  Trial* trial_;
  Stepper stepper_;
  Watcher watcher_;
  bool sound_ = true;
};

/// One case under one stage. A case may play several worlds; the first thing that breaks in any of them is kept.
class Trial {
 public:
  explicit Trial(const Stage& stage) : stage_(&stage) {}

  /// A world of its own, filled, with a solver of its own.
  Play play(const std::function<void(World&)>& fill, const Allowance& allowance = {});
  /// Where what is allowed depends on what the world was filled with.
  Play play(const std::function<void(World&)>& fill, const std::function<Allowance(const World&)>& allowance_of);

  /// The same with every contact given to the solver twice.
  Play play_doubled(const std::function<void(World&)>& fill,
                    const std::function<Allowance(const World&)>& allowance_of);

  /// The step by which the stage moves bodies: dt, or what it divides dt into.
  Real small_step(Real dt = Real(1) / 60) const { return dt / static_cast<Real>(stage_->small_steps); }
  /// False once a number in any of its worlds was not finite, or one of them was refused.
  bool sound() const { return sound_; }
  const std::string& broken() const { return broken_; }
  double ms_per_step() const { return steps_ > 0 ? 1000 * seconds_ / steps_ : 0; }

 private:
  friend class Play;
  const Stage* stage_;
  std::string broken_;
  bool sound_ = true;
  double seconds_ = 0;  // of wall time, in steps
  int steps_ = 0;
};

/// A number that must not exceed its limit.
struct Criterion {
  std::string what;  ///< "drift of the top after 10 s"
  std::string unit;  ///< "mm"
  Real limit;        ///< in that unit
};

struct HardCase {
  std::string name;      ///< as typed: "stack-20"
  std::string title;     ///< as read: "stack of 20"
  std::string stresses;  ///< what it is hard for, in a line
  std::vector<Criterion> criteria;
  Scene scene;  ///< what its picture shows; `seconds`: at which time, under the last stage
  /// Plays it and returns the numbers, one a criterion, in the criteria's units.
  std::function<std::vector<Real>(Trial&)> run;
};

struct Outcome {
  std::vector<Real> numbers;  ///< one a criterion; NaN where a world was not sound
  std::string broken;         ///< the invariant that broke first; empty: none did
  double ms_per_step = 0;     ///< wall time; the only entry that differs from run to run
  /// Every number within its limit, and no invariant broken.
  bool passed(const HardCase& of) const;
  /// The criterion that is nearest to its limit, or furthest beyond.
  std::size_t worst(const HardCase& of) const;
};

Outcome outcome_of(const HardCase& hard_case, const Stage& stage);

/// Every case, in the order of the table.
const std::vector<HardCase>& hard_cases();

/// Throws InvalidInput, naming those that there are.
const HardCase& hard_case_named(const std::string& name);

}  // namespace pushback
