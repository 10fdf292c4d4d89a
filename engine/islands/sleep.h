/// Resting bodies are not simulated.
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
///   - a spring or another Force differs from the one when it fell asleep;
///   - it is joined to an immovable body that moves, or by a driven joint;
///   - the caller gives one of its bodies a velocity, a force or another position;
///   - the caller moves or removes a body that it touches;
///   - gravity changes, or forces or joints are added or removed, and then all islands wake;
///   - the caller calls `wake`, which is required after any other change of a sleeping body, such as its mass or its groups.
///
/// If a Force acts on all bodies together, none sleeps, because its next values are unknown.
class Sleep {
 public:
  Real time_to_sleep = Real(0.5);  ///< for how long a body has to keep its place
  Real rest_distance = Real(
      0.25e-3);  ///< m: the most that its surface may move at rest; slower than rest_distance / time_to_sleep is rest

  // ---- the bodies that take part in a step: see World::step --------------------------------------------------------

  /// Finds changes in the world since the latest step. Throws as World::step does, before anything has moved.
  void check(World& world);
  /// With applied forces on the bodies: wakes bodies that these, joints or others touch, and finds contacts of awake bodies.
  /// Impulses from before a body fell asleep count as impulses of the previous step.
  void find_contacts(World& world, const Margin& margin = {});
  /// The bodies simulated in this step, in ascending order: movable and awake, or immovable but moving.
  template <class Act>
  void each(World& world, const Act& act) const {
    for (const int i : simulated_) act(world.bodies[std::size_t(i)]);
  }
  /// Puts resting bodies to sleep.
  void end(World& world, Real dt);

  /// The island of this body, with all others that touch the body, or are joined to it, if it is immovable.
  void wake(World& world, int body);
  void wake_all(World& world);
  /// Each sleeping island's bodies, ascending.
  std::vector<std::vector<int>> asleep() const;

 private:
  struct Island {
    std::vector<int> bodies;
    Contacts contacts;  // with what they carried
  };
  struct Rest {  // of one that sleeps, or that nothing moves: where it is
    Vec3 position = Vec3::Constant(std::numeric_limits<Real>::quiet_NaN());  // far from everywhere
    Quat orientation = Quat::Identity();
    Real reach = 0;    // m, from the centre of mass to the farthest point of the shape
    Real seconds = 0;  // since the body is there
    int island = -1;   // in islands_, of a body that sleeps
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

  std::vector<int> awake_, planes_, fixed_;  // movable; half-spaces; immovable otherwise
  std::vector<int> driven_, driven_before_;  // immovable, and moving all the same
  std::vector<int> simulated_;               // awake or driven
  std::vector<Rest> rest_;                   // of all bodies
  std::vector<Island> islands_;              // a woken one leaves an empty place
  Islands touching_;
  StillBodies still_;
  bool tree_is_current_ = false;
  bool all_stay_awake_ = false;
  Contacts woken_;  // of the islands woken since the latest step
  Vec3 gravity_ = Vec3::Zero();
  std::size_t forces_ = 0, joints_ = 0;
};

}  // namespace pushback
