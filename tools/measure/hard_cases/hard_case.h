/// A situation known to break contact solvers, and the numbers by which it counts as survived.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "pushback/common/experiment/scene.h"
#include "pushback/common/world/situations.h"
#include "pushback/tools/measure/hard_cases/stages.h"
#include "pushback/tools/measure/hard_cases/watcher.h"

namespace pushback {

class Trial;
using AllowanceOf = std::function<Allowance(const World&)>;

/// One world under one stage's solver, watched.
class Play {
 public:
  World world;

  /// Moves on by one step of dt. Does nothing any more once a number is not finite, or the solver has refused the world.
  void step(Real dt = Real(1) / 60);
  /// As many steps as make up `seconds`; `after_each` may look at the world, or poke it.
  void run(Real seconds, Real dt = Real(1) / 60, const std::function<void(World&)>& after_each = {});
  /// The largest value, at least 0, of `of` after each step of 1/60 s.
  Real largest(Real seconds, const std::function<Real(const World&)>& of);
  /// False once a number was not finite, or the solver has refused the world: what is measured then says nothing.
  bool sound() const { return sound_; }
  const Watcher& watcher() const { return watcher_; }

 private:
  friend class Trial;
  Play(Trial& trial, World start, const Allowance& allowance, Stepper stepper);

  Trial* trial_;
  Stepper stepper_;
  Watcher watcher_;
  bool sound_ = true;
};

/// A start is the case's scene as it is, or, from the second on, with every movable body displaced by up to this along each
/// axis. What passes by luck passes from one start and not from another.
inline constexpr Real nudge = Real(1e-6);  ///< m
/// Of the cases at a knife's edge: so many starts each.
inline constexpr int many_starts = 30;

/// One case under one stage from one start. A case may play several worlds; the first thing that breaks in any is kept.
class Trial {
 public:
  explicit Trial(const Stage& stage, int start = 0) : stage_(&stage), start_(start) {}

  /// A world of its own, filled, with a solver of its own.
  Play play(const std::function<void(World&)>& fill, const Allowance& allowance = {});
  /// Where what is allowed depends on what the world was filled with.
  Play play(const std::function<void(World&)>& fill, const AllowanceOf& allowance_of,
            GivenContacts given = GivenContacts::none);

  /// The step by which the stage moves what flies or slides alone: dt, or what it divides dt into; 0: as if it had none.
  Real substep(Real dt = Real(1) / 60) const {
    return stage_->half_steps ? 0 : dt / static_cast<Real>(stage_->substeps(dt));
  }
  /// False once a number in any of its worlds was not finite, or one of them was refused.
  bool sound() const { return sound_; }
  const std::string& broken() const { return broken_; }
  double seconds() const { return seconds_; }  ///< of wall time, in steps
  int steps() const { return steps_; }

 private:
  friend class Play;
  const Stage* stage_;
  int start_;
  std::string broken_;
  bool sound_ = true;
  double seconds_ = 0;
  int steps_ = 0;
};

/// A number that must not exceed its limit.
struct Criterion {
  std::string what;  ///< "drift of the top after 10 s"
  std::string unit;  ///< "mm"
  Real limit;        ///< in that unit
  /// "1 mm"
  std::string limit_with_unit() const;
};

struct HardCase {
  std::string name;      ///< as typed: "stack-20"
  std::string title;     ///< as read: "stack of 20"
  std::string stresses;  ///< what it is hard for, in a line
  std::vector<Criterion> criteria = {};
  Scene scene = {};  ///< how it begins; from where, and until when, one would look at it
  /// Plays it and returns the numbers, one a criterion, in the criteria's units.
  std::function<std::vector<Real>(Trial&)> run = {};
  int starts = 1;  ///< it passes if it does from each of them
};

/// "drift after 10 s ≤ 1 mm; speed in the last second ≤ 1 mm/s"
std::string criteria_of(const HardCase& hard_case);

/// What `broken` begins with where who is to play a case lacks what it asks for: it has neither passed nor failed.
inline constexpr const char* not_possible = "not possible";

struct Outcome {
  std::vector<Real> numbers;            ///< one a criterion, of the scene as it is; NaN where a world was not sound
  std::string broken;                   ///< the invariant that broke first, and from which start; empty: none did
  double ms_per_step = 0;               ///< wall time; the only entry that differs from run to run
  std::vector<Real> largest = numbers;  ///< one a criterion, of all starts
  int starts = 1, starts_passed = 0;
  std::string by = {};  ///< of the best of several stages: which one it is
  bool ended = true;    ///< false: the process that played it came to no good end, and `broken` says how
  /// Whether who played it has all that the case asks for.
  bool possible() const { return !broken.starts_with(not_possible); }
  /// From every start, every number within its limit, and no invariant broken.
  bool passed(const HardCase& of) const;
  /// The criterion of which the largest number is nearest to its limit, or furthest beyond.
  std::size_t worst(const HardCase& of) const;
};

/// The case under the stage, from all of its starts.
Outcome outcome_of(const HardCase& hard_case, const Stage& stage);

/// Every case, in the order of the table.
const std::vector<HardCase>& hard_cases();

/// Throws InvalidInput, naming those that there are.
const HardCase& hard_case_named(const std::string& name);

// In groups.
std::vector<HardCase> stack_cases();     ///< one on the other: stacks, a pyramid, heavy on light
std::vector<HardCase> pile_cases();      ///< card house, Jenga, wall, tower of planks
std::vector<HardCase> stone_cases();     ///< hulls: an arch, a heap of rubble
std::vector<HardCase> friction_cases();  ///< what must stick, and how far it slides
std::vector<HardCase> guided_cases();    ///< over tiles, on a turntable, in a groove, into a hole; a ball upon a ball
std::vector<HardCase> bounce_cases();    ///< how high, how fast, how elastic
std::vector<HardCase> impact_cases();    ///< dominoes, bodies born in each other, hits at 500 m/s, thin walls
std::vector<HardCase> no_solution_cases();  ///< what forces alone cannot solve: Painleve's rod, a body squeezed
std::vector<HardCase> scale_cases();        ///< far, thin, tiny, spinning
std::vector<HardCase> joint_cases();        ///< chains and a bridge with heavy loads
std::vector<HardCase> ball_cases();         ///< a tennis ball on a basketball
std::vector<HardCase> edge_cases();         ///< just before, and just beyond, what friction and thickness hold
std::vector<HardCase> mechanism_cases();    ///< a linkage through its dead points, a motor against a limit
std::vector<HardCase> step_cases();         ///< other time steps, contacts given twice, bodies in another order

}  // namespace pushback
