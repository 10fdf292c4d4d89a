/// Detects contacts once per step and solves them in many substeps.
///
///   world.step(solver, 1.0 / 60);
#pragma once

#include <optional>

#include "pushback/chapters/14_joints_under_load/steady_joints.h"
#include "pushback/chapters/21_detected_once/kept_contact.h"
#include "pushback/common/world/solver_from.h"

namespace pushback {

/// Soft contacts, a friction cone, restitution, warm start and relaxing as in chapters 05 to 12, and joints as in chapter 14.
///
/// Between steps it stores no impulses, because its initial guess comes from the world's contacts and joints.
class DetectedOnceSubsteps : public Substepping {
 public:
  Real carried_from = Real(1e-3);  ///< m/s; bodies with a lower relative velocity keep their rows as detected
  SteadyJoints joints;

  void check(World& world, Real h) {
    check_settings(world, h);
    require_not_negative("carried_from", carried_from);
    StepContext step = joints_step(world, h);
    joints.check(step);
  }
  /// Builds the rows and sets their initial impulses, once per step.
  void after_detection(World& world, Real h) {
    measured_.reset();
    bodies_.clear();
    contacts_.clear();
    places_.assign(world.bodies.size(), none);
    for (std::size_t i = 0; i < world.contacts.size(); ++i) {
      const auto& [body_a, body_b, feature] = world.contacts[i].id;
      const std::size_t a = place_of(world, body_a), b = place_of(world, body_b);
      contacts_.emplace_back(world, i, a, b);
    }
    start_from_last_step(world, h, [this](std::size_t i, const Vec3& impulse) {
      contacts_[i].guess(impulse);
      contacts_[i].apply_impulses(bodies_, 1);
    });
  }
  /// Sets the target velocity of each normal, applies the initial guess and sweeps, in each substep.
  void solve(World& world, Real h, int sweeps) {
    StepContext step = joints_step(world, h);
    joints.build(step);
    forget_impacts();
    for (KeptContact& contact : contacts_) {
      contact.prepare_substep(bodies_, push_out(h), h);
      fastest_ = std::max(fastest_, -contact.bounce);
    }
    if (fastest_ > 0)
      for (KeptContact& contact : contacts_) contact.save_impulses();
    joints.start(step);
    for (KeptBody& each : bodies_) {  // rows and impulses are the same, so one addition per body is enough
      each.body->velocity += each.impulse_velocity;
      each.body->angular_velocity += each.impulse_angular_velocity;
    }
    for (int i = 0; i < sweeps; ++i) sweep(step);
    joints.finish(step);
    joints.report(step);
  }
  /// Updates displacements and rows, and makes the relaxing pass, once the bodies have moved in each substep.
  void after_move(World& world, Real h) {
    for (KeptBody& each : bodies_) {
      if (each.body->conveys) continue;
      each.displacement += h * each.body->velocity;
      each.rotation += h * each.body->angular_velocity;
    }
    for (KeptContact& contact : contacts_) {
      contact.carry(bodies_, carried_from);
      contact.relax();
    }
    StepContext step = joints_step(world, h);
    joints.update_geometry(step);
    sweep(step, true);
    joints.report(step);
  }
  /// Stores the impulses in the contacts and removes the contacts that did not touch, once per step.
  void end_detection(World& world) {
    if (fastest_ > 0) measured_ = measure();  // before the impulses of an impact are discarded
    forget_impacts();
    for (std::size_t i = 0; i < contacts_.size(); ++i) {
      const KeptContact& kept = contacts_[i];
      Contact& contact = world.contacts[i];
      contact.depth = -kept.separation(bodies_);
      contact.impulse = kept.sum();
      contact.last_impulse = kept.impulse();
      contact.state =
          state_of(known_[i], kept.friction, kept.normal.impulse, kept.tangent1.impulse, kept.tangent2.impulse);
    }
    std::erase_if(world.contacts, [](const Contact& c) { return c.depth < 0 && c.impulse.isZero(0); });
  }
  SolveStats stats() const { return measured_.value_or(measure()); }

 private:
  static constexpr std::size_t none = std::numeric_limits<std::size_t>::max();

  std::size_t place_of(World& world, std::size_t body) {
    if (places_[body] == none) {
      places_[body] = bodies_.size();
      bodies_.push_back({&world.bodies[body]});
    }
    return places_[body];
  }
  /// `last`: it is the last sweep of a substep.
  void sweep(StepContext& step, bool last = false) {
    joints.sweep(step);
    for (KeptBody& each : bodies_) {
      each.impulse_velocity -= each.body->velocity;
      each.impulse_angular_velocity -= each.body->angular_velocity;
    }
    solve_normals_until_solved([this] {
      Real change = 0;
      for (KeptContact& contact : contacts_) change = std::max(change, contact.solve_normal());
      rows_solved += contacts_.size();
      return change;
    });
    for (KeptContact& contact : contacts_) {
      if (contact.friction > 0) contact.solve_friction();
      if (last) contact.add_up();
    }
    for (KeptBody& each : bodies_) {
      each.impulse_velocity += each.body->velocity;
      each.impulse_angular_velocity += each.body->angular_velocity;
    }
    rows_solved += 2 * contacts_.size();
  }

  SolveStats measure() const {
    SolveStats all = stats_of(joints.joint_rows());
    all.rows += 3 * static_cast<int>(contacts_.size());
    for (const KeptContact& contact : contacts_) all.residual = std::max(all.residual, contact.error());
    return all;
  }

  /// An impact is over in one substep, so the next one starts from the initial impulses of this one.
  void forget_impacts() {
    if (fastest_ > 0)
      for (KeptContact& contact : contacts_) contact.restore(bodies_);
    fastest_ = 0;
  }

  std::optional<SolveStats> measured_;  // before the impulses of an impact were discarded
  std::vector<KeptContact> contacts_;
  std::vector<KeptBody> bodies_;     // bodies with contacts
  std::vector<std::size_t> places_;  // index in bodies_ of each body of the world
};

using DetectedOnce = SolverFrom<DetectedOnceSubsteps>;

}  // namespace pushback
