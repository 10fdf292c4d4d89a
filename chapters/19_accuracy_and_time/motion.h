/// Motions whose positions are known at all times, for comparison with an engine.
#pragma once

#include <Eigen/Core>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "pushback/common/world/world.h"

namespace pushback {

/// A ball and socket: two bodies, or one and the_world, share this point (m, world axes, at the start of the motion).
struct Pin {
  int a, b;
  Vec3 anchor;
};

/// The centre of mass of each body of a world, by its index, m. In double, whatever Real is.
using Places = std::vector<Eigen::Vector3d>;

/// The number of comparisons of places per second of a motion. A frame is a whole number of steps of an engine.
inline constexpr int frames_per_second = 60;

struct Motion {
  std::string name;                  ///< a word for the command line
  std::string title;                 ///< a few words for a diagram
  std::function<void(World&)> fill;  ///< adds bodies, with the same friction and restitution, and sets gravity
  double seconds;                    ///< s: the duration of the comparison
  std::function<std::vector<Places>(int)> truth;  ///< places after frames 1, 2 ... up to the given number
  std::vector<Pin> pins = {};                     ///< pinned pairs do not collide
  int most_substeps = 64;                         ///< the largest number in a frame that is worth trying
  int most_sweeps = 64;                           ///< in a substep
  int most_passes = 256;                          ///< substeps times sweeps

  int frames() const;
  /// Adds the bodies, and the pins as joints.
  void begin(World& world) const;
};

/// bounce, incline, sliding, rolling, pendulum, stack-10, pyramid-10, heavy-on-light, chain, break.
const std::vector<Motion>& all_motions();

/// Throws InvalidInput with the list of names if no motion has this name.
const Motion& motion_named(std::string_view name);

}  // namespace pushback
