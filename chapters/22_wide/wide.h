/// Chapter 21's solver, eight pairs of bodies at a time.
///
///   Wide<float> solver;
///   world.step(solver, 1.0 / 60);
#pragma once

#include "pushback/chapters/21_detected_once/detected_once.h"
#include "pushback/chapters/22_wide/bundle.h"
#include "pushback/chapters/22_wide/colours.h"

namespace pushback {

/// The fastest passes that this processor can do; or for 1, 4 or 8 `lanes`, the same bits in another time.
template <class Scalar>
Passes<Scalar> passes_of_this_processor(int lanes = 0);

/// Rows and impulses are of the type Scalar, whatever Real is; positions are Real. Defined for float and double.
template <class Scalar>
class Wide : public OnceInAStep {
 public:
  Passes<Scalar> passes = passes_of_this_processor<Scalar>();
  /// Another order of the pairs converges at another rate.
  Sets (*sets_of)(const std::vector<PairOfBodies>& pairs, const World& world) = coloured;

  void detected(World& world, Real h);
  void solve(World& world, Real h, int sweeps);
  void after_move(World& world, Real h);
  void done(World& world);

 private:
  struct Place {  // of a contact of the world
    std::size_t bundle, contact, lane;
  };
  std::size_t place_of(World& world, std::size_t body);
  void start_from_last_step(const World& world, Real h);
  void pack(const World& world, const std::vector<PairOfBodies>& set);
  Bundles<Scalar> bundles();
  void sweep(Step& step);

  std::vector<Body*> bodies_;        // those that touch; the last one stands in empty lanes
  std::vector<std::size_t> places_;  // of each body of the world, in bodies_
  std::vector<Twist<Scalar>> now_, before_, moved_, given_, start_;
  std::vector<Bundle<Scalar>> bundles_;
  std::vector<WidePoint<Scalar>> points_;
  std::vector<WideContact<Scalar>> contacts_;
  std::vector<Place> where_;   // of each contact of the world
  std::vector<bool> known_;    // whether the step before had it,
  std::vector<Vec3> guesses_;  // and what it starts from, N s
};

}  // namespace pushback
