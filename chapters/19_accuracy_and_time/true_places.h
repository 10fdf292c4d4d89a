/// The comparison of a world with the true places of its motion.
#pragma once

#include <algorithm>
#include <cmath>
#include <map>

#include "pushback/chapters/19_accuracy_and_time/motion.h"

namespace pushback {

/// The true places of all bodies of a motion after each frame.
struct TruePlaces {
  std::vector<Places> places;

  explicit TruePlaces(std::vector<Places> after_each_frame) : places(std::move(after_each_frame)) {}
  explicit TruePlaces(const Motion& motion) : places(motion.truth(motion.frames())) {}
  /// The places after the latest complete frame, or nullptr before the first.
  const Places* at(Real time) const {
    const auto frames = static_cast<std::ptrdiff_t>(std::floor(time * frames_per_second + Real(1e-3)));
    return frames == 0 ? nullptr : &places[static_cast<std::size_t>(std::min(frames, std::ssize(places)) - 1)];
  }
  /// The largest distance of a body from its true place, mm.
  Real error(const World& world) const {
    double largest = 0;
    if (const Places* found = at(world.time))
      for (std::size_t i = 0; i < found->size(); ++i)
        largest = std::max(largest, (world.bodies[i].position.cast<double>() - (*found)[i]).norm());
    return static_cast<Real>(1000 * largest);
  }
};

/// The true places of a motion, computed once because that is slow.
inline const TruePlaces& true_places_of(const Motion& motion) {
  static std::map<std::string, TruePlaces> known;
  return known.try_emplace(motion.name, motion).first->second;
}

}  // namespace pushback
