/// Another engine with a world of ours in it. Each engine's source defines one, and a program is linked with one of them.
#pragma once

#include <memory>

#include "pushback/common/world/world.h"
#include "pushback/tools/measure/hard_cases/peers.h"

namespace pushback {

class Engine {
 public:
  virtual ~Engine() = default;
  /// The body's position, orientation and velocities become the engine's.
  virtual void put(const Body& body) = 0;
  /// The position, orientation and velocities of a movable body, from the engine.
  virtual void get(Body& body) const = 0;
  /// An immovable body that moves: in the next step it goes from `now` to `then`.
  virtual void drive(const Body& now, const Body& then) = 0;
  /// Moves on by h, s, with the force and torque of each body. Throws InvalidInput where the engine gives up.
  virtual void step(const std::vector<Body>& bodies, Real h) = 0;
};

/// With the world in it. Sleeping and damping are off; a pair rubs and bounces as a pair of ours does. Throws not_had where
/// the engine lacks something that is in the world.
using BeginEngine = std::unique_ptr<Engine>(const World& world, const PeerSetting& setting);
BeginEngine begin_engine;

/// "not possible: ODE has no cone limit"
InvalidInput not_had(const std::string& what);

/// Throws not_had where the body has what no engine here is told of: a skin, groups, a surface that conveys.
void check_plain(const Body& body);

/// An immovable body whose velocity moves it; that of a conveyor moves its surface alone.
inline bool is_driven(const Body& body) {
  return !body.movable() && !body.conveys && (!body.velocity.isZero(0) || !body.angular_velocity.isZero(0));
}

}  // namespace pushback
