/// What exercise 11 asks for.
#pragma once

#include "pushback/common/exercise/exercise.h"
#include "pushback/common/world/world.h"

namespace pushback::exercise_11 {

/// What World::step does, part by part, with one sweep of the solver of chapter 07.
class Parts {
 public:
  explicit Parts(World& world) : world_(world) {}
  /// v += seconds g, of every body.
  void add_gravity(Real seconds);
  /// The contacts, with points, normals and depths of now. The impulses that they had until now are kept.
  void detect();
  /// One sweep over the rows of these contacts. They want b = beta / seconds (C + slop). They start from the impulses that
  /// were kept, times `scale`.
  void solve(Real seconds, Real scale);
  /// x += seconds v, and the turn, of every body.
  void move(Real seconds);

  World& world() { return world_; }

 private:
  World& world_;
};

struct Answer {
  void (*frame)(Parts& parts, Real dt, int count, Real before);  ///< a step of dt, as `count` substeps
};

Numbers play(std::size_t check, Random& random, const Answer& answer);

}  // namespace pushback::exercise_11
