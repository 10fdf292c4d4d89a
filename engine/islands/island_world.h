/// An island as a separate world.
#pragma once

#include <algorithm>

#include "pushback/engine/half_step/half_step.h"
#include "pushback/engine/islands/step_contacts.h"

namespace pushback {

/// Copies of an island's bodies, and of the immovable ones that it touches or hangs from, in the order of the whole world, so that its
/// contacts stay in the order of their ids. The island's joints are moved here until they are given back.
class IslandWorld {
 public:
  World world;
  HalfStep half_step;
  bool impact = false;  ///< whether bodies may meet in this step, which is then cut at impacts
  bool fourth = false;  ///< whether the island gets fourth-order steps, because it has joints but no contacts
  bool moved = false;   ///< whether the island has been moved
  Contacts found;       ///< the contacts of this step, if Fast moves the island
  int substeps = 1;     ///< number of substeps in a step; impulses of contacts are for one of them

  /// Sets what `half_step` does, after a change of the above.
  void set_order() {
    half_step.impacts = impact && !fourth ? std::optional(Impacts::sequential) : std::nullopt;
    half_step.composition = one_step;
    if (fourth) half_step.composition = suzuki;
  }
  void set(const HalfStepSettings& settings) { static_cast<HalfStepSettings&>(half_step) = settings; }
  /// Whether joints and contacts have to be solved together.
  bool has_joints_and_may_touch() const { return impact && !world.joints.empty(); }

  /// Empties the island. `lowest`: the lowest index of its movable bodies.
  void begin(const World& whole, int lowest) {
    lowest_ = lowest;
    moved = fourth = false;
    bodies_.clear();
    joints_.clear();
    found.clear();
    substeps = 1;
    world.contacts.clear();
    world.joints.clear();
    world.gravity = whole.gravity;
    world.dt_before = whole.dt_before;
    world.last_impulses_known = false;
  }
  /// Adds a body, which may be added more than once. Add all bodies before contacts and joints.
  void add(int body) { bodies_.push_back(body); }
  void sort() {
    std::sort(bodies_.begin(), bodies_.end());
    bodies_.erase(std::unique(bodies_.begin(), bodies_.end()), bodies_.end());
  }
  /// Adds a pair's contacts of the previous step if the island contains both bodies.
  void add(PairContacts between) { add(between, world.contacts); }
  void add_found(PairContacts between) { add(between, found); }
  void take_joint(Joint& joint, std::size_t index) {
    Joint& taken = world.joints.emplace_back(std::move(joint));
    for (int* body : {&taken.a, &taken.b})
      if (*body != the_world) *body = local_index(*body);
    joints_.push_back(index);
  }
  /// Copies the bodies as they are in the whole world now. Returns whether anything other than gravity, joints and contacts does work on
  /// them.
  bool copy_bodies(const World& whole) {
    world.bodies.clear();
    world.time = whole.time;
    bool worked_on = false;
    for (const int body : bodies_) {
      Body& copy = world.bodies.emplace_back(whole.bodies[std::size_t(body)]);
      copy.index = static_cast<int>(world.bodies.size()) - 1;
      const bool moves = copy.velocity != Vec3::Zero() || copy.angular_velocity != Vec3::Zero();
      worked_on |= copy.force != Vec3::Zero() || copy.torque != Vec3::Zero() || (moves && !copy.movable());
    }
    return worked_on;
  }

  void give_joints(std::vector<Joint>& all) {
    for (std::size_t i = 0; i < joints_.size(); ++i) {
      Joint& joint = world.joints[i];
      for (int* body : {&joint.a, &joint.b})
        if (*body != the_world) *body = bodies_[std::size_t(*body)];
      all[joints_[i]] = std::move(joint);
    }
  }
  /// Writes bodies and contacts into the whole world. `fraction`: the length of the whole world's last substep, as a fraction of the step.
  void write_to(World& whole, Real fraction) const {
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
      if (!world.bodies[i].movable()) continue;
      whole.bodies[std::size_t(bodies_[i])] = world.bodies[i];
      whole.bodies[std::size_t(bodies_[i])].index = bodies_[i];
    }
    for (const Contact& contact : world.contacts) {
      if (contact.depth < 0 && contact.impulse.isZero(0)) continue;
      Contact& copy = whole.contacts.emplace_back(contact);
      copy.id.body_a = static_cast<std::uint32_t>(bodies_[contact.id.body_a]);
      copy.id.body_b = static_cast<std::uint32_t>(bodies_[contact.id.body_b]);
      copy.last_impulse = fraction * static_cast<Real>(substeps) * contact.last_impulse;
    }
    for (const std::size_t joint : joints_)
      for (Real& impulse : whole.joints[joint].last_impulses) impulse *= fraction;
  }
  const std::vector<int>& bodies() const { return bodies_; }
  int lowest() const { return lowest_; }

 private:
  static constexpr int not_contained = -2;  // and -1 is the_world

  void add(PairContacts between, Contacts& contacts) const {
    const ContactId& id = between.front().id;
    const int a = local_index(static_cast<int>(id.body_a)), b = local_index(static_cast<int>(id.body_b));
    if (a == not_contained || b == not_contained) return;
    for (const Contact& contact : between) {
      contacts.push_back(contact);
      contacts.back().id.body_a = static_cast<std::uint32_t>(a);
      contacts.back().id.body_b = static_cast<std::uint32_t>(b);
    }
  }
  int local_index(int body) const {
    const auto at = std::lower_bound(bodies_.begin(), bodies_.end(), body);
    return at != bodies_.end() && *at == body ? static_cast<int>(at - bodies_.begin()) : not_contained;
  }

  int lowest_ = 0;
  std::vector<int> bodies_;          // the index of each body in the whole world, ascending
  std::vector<std::size_t> joints_;  // the index of each joint in the whole world
};

}  // namespace pushback
