/// Motions whose every position is known, so that an engine can be held against them.
#pragma once

#include <Eigen/Core>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "pushback/common/world/world.h"

namespace pushback {

/// A ball and socket: two bodies, or one and the_world, share this point (m, world axes, as the motion begins).
struct Pin {
  int a, b;
  Vec3 anchor;
};

/// The centre of mass of each body of a world, by its index, m. In double, whatever Real is.
using Places = std::vector<Eigen::Vector3d>;

/// Places are compared so often in a second of a motion, and a step of an engine is a whole part of this.
inline constexpr int frames_per_second = 60;

struct Motion {
  std::string name;                               ///< a word for the command line
  std::string title;                              ///< a few words for a diagram
  std::function<void(World&)> fill;               ///< bodies and gravity. All have the same friction and restitution
  double seconds;                                 ///< how long it is compared
  std::function<std::vector<Places>(int)> truth;  ///< where all bodies are after 1, 2 ... frames, so many of them
  std::vector<Pin> pins = {};                     ///< pinned pairs do not collide
  int most_substeps = 64;                         ///< in a frame, worth trying
  int most_sweeps = 64;                           ///< in a substep
  int most_passes = 256;                          ///< substeps times sweeps

  int frames() const;
  /// The bodies, and the pins as joints.
  void begin(World& world) const;
};

/// bounce, incline, sliding, rolling, pendulum, stack-10, pyramid-10, heavy-on-light, chain, break.
const std::vector<Motion>& all_motions();

/// Throws InvalidInput, with the names that there are, if none has this name.
const Motion& motion_named(std::string_view name);

}  // namespace pushback
