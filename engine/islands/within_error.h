/// As many substeps as an error calls for.
///
///   WithinError solver;
///   solver.error = 1e-4;
///   world.step(solver, 1.0 / 60);
#pragma once

#include "pushback/engine/islands/by_island.h"
#include "pushback/engine/islands/estimate.h"

namespace pushback {

/// What is known of a body's step.
struct Known {
  MovedBy how = MovedBy::nothing;
  int order = 0;     ///< of the steps: 0 where they are exact
  int substeps = 0;  ///< of this order
  Real step = 0;   ///< m: by which this step has put its place, and what its speed makes of it in half a second, wrong
  Real place = 0;  ///< m: of all steps since it began, or since `forget`; without what pulls back or drives apart
  bool kept = true;  ///< whether `error` allows it
};

/// Each island of chapter 26 in as many substeps as keep its places within `error` for a second. A step is taken twice from where
/// it began, in n / 2 substeps and in n; the second is the result, and their difference tells how far it is off:
///
///   half steps           (x_n/2 - x_n) / 3        of order 2
///   fourth order         (x_n/2 - x_n) / 15       joints alone, near to nothing, where half steps would need more than eight
///   substeps (`many`)     h / 2 dv                of order 1: x += h v is wrong by that, and dv is known after the step; and what
///                                                 contacts have sunk, which is the law's error: see sunken
///
/// What is off in v is off in x later: by dv T / 2 on average, T = 1 s. A step of h is allowed
///
///   |dx| + |dv| T / 2 <= error h / T
///
/// Else it is taken again in twice as many. Where it was far below for a while, half as many are next; and where nothing changes, only
/// every fourth step is taken twice. A chain that whips is looked at sooner: see off_when. Where more substeps do not lessen it, it is
/// no error of the step: something is decided otherwise, who touches first, or sticks. Then it is left, and said.
///
/// Where something bounces, it may be off by more than two steps tell: both find the same impact, and a later one magnifies what they
/// are off. Where bodies that are joined meet something and `many` moves them, it finds the impact first and then what joints make of it.
/// How far off that is, no number of substeps tells. In both, it is said that the step is not kept.
///
/// In a pile that moves such decisions are made all the time, and what their speeds differ by is lost in the next contact. So of
/// `many` the speeds are not counted.
class WithinError : public ByIsland {
 public:
  Real error = std::numeric_limits<Real>::infinity();  ///< m, of a place after a second. Infinite: as chapter 26
  int most_of_many = 128;                              ///< substeps of `many` in a step
  int looks_every = 4;                                 ///< steps: where nothing changes. 1: each step is taken twice

  void whole_step(World& world, Real dt, int sweeps) override;
  /// Of a body that was not there: nothing.
  Known known(int body);
  /// What is known is of the steps from now on.
  void forget() { of_body_.clear(); }

 private:
  void find_substeps(IslandWorld& island, Memory& memory, const World& whole, Real dt, int sweeps) override;
  void move_others(World& world, Real dt, int sweeps) override;
  struct Allowed {  // of a step
    Real off;       // m
    Real dt;        // s
    int sweeps;
    std::ptrdiff_t sliding;  // contacts, as it begins
  };
  void begin_order(IslandWorld& island, const Allowed& allowed);
  Real find_enough(IslandWorld& island, Memory& memory, const World& whole, const Allowed& allowed, int begun, int most,
                   std::vector<Body> coarse = {});
  Real difference(const IslandWorld& island, const std::vector<Body>& coarse, int order);
  Real move_stiffly(World& world, const World& before, Real dt, int sweeps);
  void find_meetings(const Contacts& found, const World& before, const World& after, Real dt);
  int parts_of_flight(const Body& body, Real dt) const override;
  /// What steps have put wrong is forgotten in a second, and as much may be spent meanwhile.
  Real off_of_others(Real step) const { return (2 * (in_a_second_ + step) + sunken_) / error; }

  struct Look {         // at an island, when its step was last taken twice
    int ago = 0;        // steps
    int contacts = -1;  // that could act
    Real off = 0;       // of its result, in parts of what is allowed
    Real spin = 0;      // rad/s, after it: of the fastest body
    int fourth = 0;     // steps of fourth order that it is still to have
    bool kept = true;
    int order() const { return fourth > 0 ? 4 : 2; }
  };
  struct OfBody {
    Vec3 step_x = Vec3::Zero(), step_v = Vec3::Zero();  // of a step, m and m/s, when it was last known
    Vec3 x = Vec3::Zero(), v = Vec3::Zero();            // of all steps
  };
  std::vector<Look> looks_;  // of each body that is the lowest of its island
  std::vector<OfBody> of_body_;
  Real in_a_second_ = 0;   // m: by which steps of `many` have put places wrong
  Real sunken_ = 0;        // m, in what `many` moves
  std::vector<bool> met_;  // of each body that is the lowest of its island: see find_meetings
};

}  // namespace pushback
