/// Bodies that rest are not simulated.
#pragma once

#include <map>
#include <optional>

#include "pushback/common/world/islands.h"
#include "pushback/engine/islands/still_bodies.h"

namespace pushback {

/// Who is awake. An island in which no body has left its place for a while falls asleep: its velocities become 0, and its
/// contacts are kept for the day on which it wakes. It wakes as a whole when
///
///   - a body that is awake, or an immovable one that has a velocity, comes to touch it;
///   - a spring or another Force pulls at it otherwise than when it fell asleep;
///   - it is joined to something that moves all the same, or by a joint that is driven;
///   - one of its bodies is given a velocity, a force or another place by hand;
///   - what it touches is moved by hand, or removed;
///   - gravity changes, or forces or joints are added or taken away: then all wake;
///   - it is told to: whoever changes anything else of a sleeping body, its mass or its groups, has to call `wake`.
///
/// Where a Force acts on all bodies alike, none sleeps: nobody knows what it will do next.
class Sleep {
 public:
  Real time_to_sleep = Real(0.5);  ///< for how long a body has to keep its place
  Real rest_distance = Real(
      0.25e-3);  ///< m: so far may its surface get from where it was; slower thanrest_distance / time_to_sleep is rest

  // ---- who takes part in a step: see World::step ---------------------------------------------------------------------

  /// What is new in the world since the latest step. Throws as World::step does; nothing has moved then.
  void check(World& world);
  /// With the applied forces on the bodies: wakes whom they, joints or others touch, and finds the contacts of those awake.
  /// What the woken carried when they fell asleep counts as of the step before.
  void find_contacts(World& world, const Margin& margin = {});
  /// Who is simulated in this step, in ascending order: movable and awake, or moving all the same.
  template <class Act>
  void each(World& world, const Act& act) const {
    for (const int i : simulated_) act(world.bodies[std::size_t(i)]);
  }
  /// Who rests falls asleep.
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
