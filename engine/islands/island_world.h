/// An island, as a world of its own.
#pragma once

#include <algorithm>

#include "pushback/engine/half_step/at_impacts.h"
#include "pushback/engine/half_step/composition.h"

namespace pushback {

/// Copies of an island's bodies, and of the immovable ones that it touches or hangs from, in the order of the whole world: so its
/// contacts, too, stay in the order of their ids. Its joints it has itself, until they are given back.
class IslandWorld {
 public:
  World world;
  HalfStep half_step;
  AtImpacts cut_step = [] {
    AtImpacts s;
    s.impacts = Impacts::sequential;
    return s;
  }();
  Composed<Suzuki> fourth_order;
  bool impact = false;  ///< bodies may meet in this step: it is cut where they do
  bool fourth = false;  ///< it is moved by steps of fourth order: it has joints, and no contacts
  bool held = false;    ///< half steps have moved it
  double took = 0;      ///< multiplications, roughly: of the latest try

  HalfStep& solver() {
    if (fourth) return fourth_order;
    return impact ? cut_step : half_step;
  }

  /// Joints and contacts have to be solved together.
  bool joined_and_near() const { return impact && !world.joints.empty(); }

  /// `lowest`: of its bodies that move.
  void begin(const World& whole, int lowest) {
    lowest_ = lowest;
    held = fourth = false;
    bodies_.clear();
    joints_.clear();
    world.contacts.clear();
    world.joints.clear();
    world.gravity = whole.gravity;
    world.dt_before = whole.dt_before;
    world.last_impulses_known = false;
  }
  /// A body, as often as one likes; all of them before what follows.
  void add(int body) { bodies_.push_back(body); }
  void sort() {
    std::sort(bodies_.begin(), bodies_.end());
    bodies_.erase(std::unique(bodies_.begin(), bodies_.end()), bodies_.end());
  }
  /// A contact of the step before, if both bodies are here.
  void add(const Contact& contact) {
    const int a = here(static_cast<int>(contact.id.body_a)), b = here(static_cast<int>(contact.id.body_b));
    if (a == nowhere || b == nowhere) return;
    world.contacts.push_back(contact);
    world.contacts.back().id.body_a = static_cast<std::uint32_t>(a);
    world.contacts.back().id.body_b = static_cast<std::uint32_t>(b);
  }
  void take(Joint& joint, std::size_t index) {
    Joint& taken = world.joints.emplace_back(std::move(joint));
    for (int* body : {&taken.a, &taken.b})
      if (*body != the_world) *body = here(*body);
    joints_.push_back(index);
  }
  /// Bodies as they are in the whole world now. Returns whether something beside gravity, joints and contacts does work on them.
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
  /// Where its bodies are now, and what touches there. Of the impulses of the step the last substep of the whole world has `part`.
  void give(World& whole, Real part) const {
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
      copy.last_impulse = part * contact.last_impulse;
    }
    for (const std::size_t joint : joints_)
      for (Real& impulse : whole.joints[joint].last_impulses) impulse *= part;
  }
  const std::vector<int>& bodies() const { return bodies_; }
  int lowest() const { return lowest_; }

 private:
  static constexpr int nowhere = -2;  // and -1 is the_world

  int here(int body) const {
    const auto at = std::lower_bound(bodies_.begin(), bodies_.end(), body);
    return at != bodies_.end() && *at == body ? static_cast<int>(at - bodies_.begin()) : nowhere;
  }

  int lowest_ = 0;
  std::vector<int> bodies_;          // of each of its bodies the index in the whole world, ascending
  std::vector<std::size_t> joints_;  // of each of its joints
};

}  // namespace pushback
