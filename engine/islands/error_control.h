/// As many substeps as a position error allows.
#pragma once

#include "pushback/engine/islands/energy_control.h"
#include "pushback/engine/islands/estimate.h"
#include "pushback/engine/islands/remaining_bodies.h"

namespace pushback {

/// The estimated error of a body's step.
struct BodyError {
  StepType how = StepType::none;
  int order = 0;     ///< of the steps: 0 if they are exact
  int substeps = 0;  ///< of this order
  Real step = 0;     ///< m: the position error of this step, with what its velocity error makes of it in half a second
  Real place =
      0;  ///< m: the position error of all steps since the first, or since `forget`, without forces that amplify or reduce it
  bool kept = true;  ///< whether `error` allows it
};

/// Takes the step of each island in as many substeps as keep positions within `error` for a second. A step is taken twice from the same
/// start, in n / 2 substeps and in n. The second is the result, and the difference estimates its error:
///
///   half steps           (x_n/2 - x_n) / 3        of order 2
///   fourth order         (x_n/2 - x_n) / 15       joints without contacts near, if half steps would need more than eight
///   substeps             h / 2 dv                 of order 1: x += h v has this error, and dv is known afterwards. Add the depth
///                                                 by which contacts have sunk, which is the error of the contact law: see sunken
///
/// A velocity error becomes a position error later: dv T / 2 on average, T = 1 s. A step of h is allowed
///
///   |dx| + |dv| T / 2 <= error h / T
///
/// Otherwise the step is repeated with twice as many substeps. If the error was far below for a while, the next step takes half. If
/// nothing changes, only every fourth step is taken twice. A chain that whips is checked sooner, see off_when. If more substeps
/// do not reduce the error, the step size is not its cause: the two steps differ in which bodies touch first, or stick. Then
/// the error remains, and the step is reported as not kept.
///
/// Two steps do not reveal the error of a bounce, because both find the same impact, and a later impact amplifies its error. If joined
/// bodies meet others in substeps, the impact is found first and its effect on joints afterwards, with an error that does not depend on the
/// number of substeps. In both cases the step is reported as not kept.
///
/// In a pile that moves such decisions occur all the time, and the next contact removes the velocity error. So the velocity error of
/// substeps is not counted.
class ErrorControl {
 public:
  static constexpr int least_substeps = 4;

  /// Before a step.
  void begin(const World& world);
  /// Finds the half steps of an island. Sets `island.held` if the island has been moved.
  void control(IslandWorld& island, IslandMemory& memory, const IslandStep& step);
  /// RemainingBodies::step, again with more substeps if the error needs them.
  SolveStats step_remaining(RemainingBodies& remaining, World& world, StepClassifier& classifier, Contacts& found,
                            const SubstepPass& pass);
  /// The parts in which a free body turns. Its position is exact in one.
  static int parts_of_flight(const Body& body, const IslandSettings& settings, Real dt);
  /// After a step.
  void end(const StepClassifier& classifier, Real dt);

  /// `substeps`: the half steps of its island, or the substeps. Empty for a body that the step did not contain.
  BodyError error_of(int body, StepClassifier& classifier, const IslandSettings& settings, int substeps) const;
  void forget() { bodies_.clear(); }

 private:
  struct LastErrorCheck {  // of an island, when its step was last taken twice
    int steps_since = 0;
    int contacts = -1;  // that could act
    Real off = 0;       // the error of the result, as a fraction of what is allowed
    Real spin = 0;      // rad/s, after it: of the fastest body
    int fourth = 0;     // steps of fourth order that are left
    bool kept = true;
    int order() const { return fourth > 0 ? 4 : 2; }
  };
  struct Errors {                                       // of a body
    Vec3 step_x = Vec3::Zero(), step_v = Vec3::Zero();  // of a step, m and m/s, when it was last known
    Vec3 x = Vec3::Zero(), v = Vec3::Zero();            // of all steps
  };
  struct Search {  // for the half steps of one island
    IslandWorld& island;
    IslandMemory& memory;
    const IslandStep& step;
    LastErrorCheck& check;
    Real allowed;                   // m
    std::ptrdiff_t sliding;         // contacts, as the step begins
    int begun = 1, most = 1;        // half steps
    std::vector<Body> coarse = {};  // the bodies after half of `begun`; empty if not known
    bool joints() const { return !island.world.joints.empty(); }
  };
  void forget_step(const IslandWorld& island, const World& whole);
  static void set_order(Search& search);
  static bool repeat_last(Search& search);
  Real find_enough(Search& search);
  Real difference(const Search& search);
  StepOutcome try_twice(Search& search);
  Real step_stiffly(RemainingBodies& remaining, World& world, const World& before, const StepClassifier& classifier,
                    Contacts& found, const SubstepPass& pass, SolveStats& solved);
  void find_meetings(const Contacts& found, const World& before, const World& after, StepClassifier& classifier,
                     const SubstepPass& pass);
  /// The error of substeps after this step, as a fraction of `error`. Errors are forgotten in a second, during which as much may be added.
  Real substep_error(Real step, Real error) const { return (2 * (in_a_second_ + step) + sunken_) / error; }

  std::vector<LastErrorCheck> checks_;  // of each body that is the lowest of its island
  std::vector<Errors> bodies_;
  Real in_a_second_ = 0;   // m: the position error of substeps
  Real sunken_ = 0;        // m, of bodies that substeps move
  std::vector<bool> met_;  // of each body that is the lowest of its island: see find_meetings
};

}  // namespace pushback
