/// A hard case is a situation that is known to break contact solvers, with the criteria that a solver must meet.
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

/// One world that is played by one stage's solver, with checks of invariants.
class Play {
 public:
  World world;

  /// Advances by one step of dt, s. Does nothing once a number is not finite or the solver has refused the world.
  void step(Real dt = Real(1) / 60);
  /// Advances by `seconds` s in steps of dt. `after_each` may read or change the world.
  void run(Real seconds, Real dt = Real(1) / 60, const std::function<void(World&)>& after_each = {});
  /// The largest value of `of` after a step of 1/60 s within `seconds` s, but at least 0.
  Real largest(Real seconds, const std::function<Real(const World&)>& of);
  /// False once a number was not finite or the solver has refused the world. Later measurements are then meaningless.
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

/// The first start of a case is its scene as it is. In further starts every movable body is displaced by up to this along each axis, so
/// that a solver does not pass by chance.
inline constexpr Real nudge = Real(1e-6);  ///< m
/// The number of starts of cases near a limit.
inline constexpr int many_starts = 30;

/// One case, played by one stage from one start. A case may play several worlds. The first invariant that breaks in any is stored.
class Trial {
 public:
  explicit Trial(const Stage& stage, int start = 0) : stage_(&stage), start_(start) {}

  /// A new world that `fill` fills, with its own solver.
  Play play(const std::function<void(World&)>& fill, const Allowance& allowance = {});
  /// The same if the allowance depends on the filled world.
  Play play(const std::function<void(World&)>& fill, const AllowanceOf& allowance_of,
            GivenContacts given = GivenContacts::none);

  /// The substep by which the stage moves bodies that fly or slide without others, s. It is 0 if the stage moves them by half steps.
  Real substep(Real dt = Real(1) / 60) const {
    return stage_->half_steps ? 0 : dt / static_cast<Real>(stage_->substeps(dt));
  }
  /// False once a number in any of its worlds was not finite, or the solver has refused one of them.
  bool sound() const { return sound_; }
  const std::string& broken() const { return broken_; }
  double seconds() const { return seconds_; }  ///< wall time of all steps
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
  std::string name;      ///< on the command line: "stack-20"
  std::string title;     ///< in tables: "stack of 20"
  std::string stresses;  ///< a line on the difficulty
  std::vector<Criterion> criteria = {};
  Scene scene = {};  ///< its initial state, the camera and the duration of its pictures
  /// Plays the case and returns one number per criterion, in the units of the criteria.
  std::function<std::vector<Real>(Trial&)> run = {};
  int starts = 1;  ///< a solver passes if it does so from each of them
};

/// "drift after 10 s ≤ 1 mm; speed in the last second ≤ 1 mm/s"
std::string criteria_of(const HardCase& hard_case);

/// The beginning of Outcome::broken if the player lacks a feature that the case needs, so that it has neither passed nor failed.
inline constexpr const char* not_possible = "not possible";

struct Outcome {
  std::vector<Real> numbers;            ///< one per criterion, from the scene as it is; NaN if a world was not sound
  std::string broken;                   ///< the invariant that broke first, with the start, or empty
  double ms_per_step = 0;               ///< wall time; the only member that differs from run to run
  std::vector<Real> largest = numbers;  ///< one per criterion, from all starts
  int starts = 1, starts_passed = 0;
  std::string by = {};  ///< the name of the best stage, if this is the best outcome of several stages
  bool ended = true;    ///< false if the process that played the case failed, with the reason in `broken`
  /// Whether the player has all features that the case needs.
  bool possible() const { return !broken.starts_with(not_possible); }
  /// Whether every number from every start is within its limit, and no invariant broke.
  bool passed(const HardCase& of) const;
  /// The criterion whose largest number is nearest to its limit, or farthest beyond it.
  std::size_t worst(const HardCase& of) const;
};

/// Plays the case with the stage from all of its starts.
Outcome outcome_of(const HardCase& hard_case, const Stage& stage);

/// All cases, in the order of the table.
const std::vector<HardCase>& hard_cases();

/// Throws InvalidInput, listing all names, if there is no such case.
const HardCase& hard_case_named(const std::string& name);

// The same in groups.
std::vector<HardCase> stack_cases();        ///< stacks, a pyramid, heavy on light
std::vector<HardCase> pile_cases();         ///< card house, Jenga, wall, tower of planks
std::vector<HardCase> stone_cases();        ///< hulls: an arch, a heap of rubble
std::vector<HardCase> friction_cases();     ///< bodies that must stick, or slide a given distance
std::vector<HardCase> guided_cases();       ///< over tiles, on a turntable, in a groove, into a hole, a ball on a ball
std::vector<HardCase> bounce_cases();       ///< heights, speeds and energies of bounces
std::vector<HardCase> impact_cases();       ///< dominoes, bodies created inside each other, hits at 500 m/s, thin walls
std::vector<HardCase> no_solution_cases();  ///< without a solution by forces only: Painleve's rod, a squeezed body
std::vector<HardCase> scale_cases();        ///< far, thin, tiny or spinning bodies
std::vector<HardCase> joint_cases();        ///< chains and a bridge with heavy loads
std::vector<HardCase> ball_cases();         ///< a tennis ball on a basketball
std::vector<HardCase> edge_cases();         ///< just within and just beyond the limits of friction and thickness
std::vector<HardCase> mechanism_cases();    ///< a linkage through its dead points, a motor against a limit
std::vector<HardCase> step_cases();         ///< other time steps, contacts given twice, bodies in another order

}  // namespace pushback
