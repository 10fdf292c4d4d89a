/// Puts resting bodies to sleep, so that they are not simulated.
#pragma once

#include <map>
#include <optional>

#include "pushback/common/world/islands.h"
#include "pushback/engine/islands/still_bodies.h"

namespace pushback {

/// Keeps track of sleeping bodies. An island falls asleep if none of its bodies has moved for a while. Its velocities become 0,
/// and its contacts are stored until it wakes. It wakes as a whole if
///
///   - a body that is awake, or an immovable one that has a velocity, starts to touch it;
///   - a spring or another Force on it differs from its value when the island fell asleep;
///   - it is joined to an immovable body that moves, or by a driven joint;
///   - the caller gives one of its bodies a velocity, a force or another position;
///   - the caller moves or removes a body that it touches;
///   - gravity changes, or forces or joints are added or removed, and then all islands wake;
///   - the caller calls `wake`, which is required after any other change of a sleeping body, such as its mass or its groups.
///
/// If a Force acts on all bodies together, none sleeps, because its next values are unknown.
class Sleep {
 public:
  Real time_to_sleep = Real(0.5);  ///< s, for how long a body has to stay in place
  Real rest_distance = Real(
      0.25e-3);  ///< m, the most by which its surface moves at rest; slower than rest_distance / time_to_sleep is rest

  // ---- the bodies that take part in a step, see World::step --------------------------------------------------------

  /// Finds changes in the world since the latest step. Throws as World::step does, before anything has moved.
  void check(World& world);
  /// Called when forces have been applied to the bodies. Wakes the bodies on which forces, joints or other bodies act, and finds the
  /// contacts of awake bodies. Impulses from before a body fell asleep count as impulses of the previous step.
  void find_contacts(World& world, const Margin& margin = {});
  /// The bodies simulated in this step, in ascending order: movable and awake, or immovable but moving.
  template <class Act>
  void each(World& world, const Act& act) const {
    for (const int i : simulated_) act(world.bodies[std::size_t(i)]);
  }
  /// Puts resting bodies to sleep.
  void end(World& world, Real dt);

  /// Wakes the island of this body. If the body is immovable, wakes all islands that touch it or are joined to it.
  void wake(World& world, int body);
  void wake_all(World& world);
  /// The bodies of each sleeping island, ascending.
  std::vector<std::vector<int>> asleep() const;

 private:
  struct Island {
    std::vector<int> bodies;
    Contacts contacts;  // with their impulses
  };
  struct Rest {  // the pose of a body that sleeps or does not move
    Vec3 position = Vec3::Constant(std::numeric_limits<Real>::quiet_NaN());  // differs from any position
    Quat orientation = Quat::Identity();
    Real reach = 0;    // m, from the centre of mass to the farthest point of the shape
    Real seconds = 0;  // s, since the body has been there
    int island = -1;   // index in islands_ if the body sleeps
    bool removed = false;
    std::optional<std::pair<Vec3, Vec3>> pull = {};  // force and torque in its first step asleep
  };

  void wake_changed_by_hand(World& world);
  void forget_removed(World& world, int body);
  void wake_by_forces(World& world);
  void wake_by_joints(World& world);
  bool wake_touched(World& world, const Margin& margin);
  void wake_island(World& world, int island);
  void put_to_sleep(World& world, const std::map<int, std::vector<int>>& islands);
  void build_tree(const World& world);
  Rest& rest(int body) { return rest_[std::size_t(body)]; }

  std::vector<int> awake_, planes_, fixed_;  // movable bodies, half-spaces, other immovable bodies
  std::vector<int> driven_, driven_before_;  // immovable bodies with a velocity
  std::vector<int> simulated_;               // awake or driven
  std::vector<Rest> rest_;                   // of all bodies
  std::vector<Island> islands_;              // a woken island leaves an empty element
  Islands touching_;
  StillBodies still_;
  bool tree_is_current_ = false;
  bool all_stay_awake_ = false;
  Contacts woken_;  // contacts of the islands woken since the latest step
  Vec3 gravity_ = Vec3::Zero();
  std::size_t forces_ = 0, joints_ = 0;
};

}  // namespace pushback
