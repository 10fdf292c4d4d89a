/// Contacts detected once in a step, and solved in many substeps.
///
///   world.step(solver, 1.0 / 60);
#pragma once

#include "pushback/chapters/12_soft_contacts/soft_contacts.h"
#include "pushback/chapters/14_joints_under_load/steady_joints.h"
#include "pushback/chapters/21_detected_once/kept_contact.h"

namespace pushback {

/// What may be set, and how a step is divided. World::step does it; detection looks ahead by a margin, so that what comes to
/// touch within the step has its rows.
struct OnceInAStep : StepSolver, HoldsJoints {
  static constexpr int usual_sweeps = 1;  // in a substep

  int substeps = 32;
  Real margin = Real(0.02);    ///< m: beside what a pair may come nearer in a step
  Real reach = Real(1e-6);     ///< m: by so much bodies may have moved past each other until their rows are made anew
  Real threshold = Real(0.1);  ///< m/s; what arrives slower does not bounce
  Real precision =
      Real(1e-6);  ///< of the fastest bounce: what normals are solved to in a substep in which something bounces,
  int most_rounds = 100;  ///< or until they have been solved so often
  SoftContacts spring;    ///< chapter 12's: hertz, damping ratio, fastest push-out
  SteadyJoints joints;

  void check(World& world, Real dt) {
    if (substeps < 1) throw InvalidInput(fmt::format("substeps is {}: a whole number, 1 or more, is needed", substeps));
    require_not_negative("margin", margin);
    require_not_negative("reach", reach);
    require_not_negative("threshold", threshold);
    require_not_negative("precision", precision);
    if (most_rounds < 1)
      throw InvalidInput(fmt::format("most_rounds is {}: a whole number, 1 or more, is needed", most_rounds));
    Step step = joints_step(world, dt / static_cast<Real>(substeps));
    spring.check(step);
    joints.check(step);
  }
  Division division(Real dt) const { return {substeps, {.least = margin, .ahead = dt}}; }

 protected:
  /// Joints have rows of their own, made anew in each substep; of the contacts they know nothing.
  Step joints_step(World& world, Real h) { return {world, world.contacts, no_rows_, h}; }
  PushOut push_out(Real h) const {
    const Real w = spring.angular_frequency(h), damping = 2 * spring.damping_ratio + h * w;
    return {w / damping, 1 / (h * w * damping), spring.fastest_push_out, threshold};
  }

 private:
  Rows no_rows_;
};

/// Soft contacts, a friction cone, restitution, warm start and relaxing as in chapters 05 to 12; joints as in chapter 14.
///
/// Between steps it remembers nothing: what it starts from stands in the world's contacts and joints.
class DetectedOnce : public OnceInAStep {
 public:
  /// Once in a step: the rows, and the impulses that they start from.
  void detected(World& world, Real h) {
    bodies_.clear();
    contacts_.clear();
    places_.assign(world.bodies.size(), none);
    for (std::size_t i = 0; i < world.contacts.size(); ++i) {
      const auto& [body_a, body_b, feature] = world.contacts[i].id;
      const std::size_t a = place_of(world, body_a), b = place_of(world, body_b);
      contacts_.emplace_back(world, i, a, b);
    }
    start_from_last_step(world, h);
  }
  /// In each substep: what each normal is to do, the initial guess, and the sweeps.
  void solve(World& world, Real h, int sweeps) {
    Step step = joints_step(world, h);
    joints.build(step);
    forget_impacts();
    for (KeptContact& contact : contacts_) {
      contact.aim(bodies_, push_out(h), h);
      fastest_ = std::max(fastest_, -contact.bounce);
    }
    if (fastest_ > 0)
      for (KeptContact& contact : contacts_) contact.keep();
    joints.start(step);
    for (KeptBody& each : bodies_) {  // the same rows with the same impulses: one addition a body
      each.body->velocity += each.given;
      each.body->angular_velocity += each.given_turning;
    }
    for (int i = 0; i < sweeps; ++i) sweep(step);
    joints.finish(step);
    joints.report(step);
  }
  /// In each substep, once the bodies have moved: where they are now, and the relaxing pass.
  void after_move(World& world, Real h) {
    for (KeptBody& each : bodies_) {
      each.way += h * each.body->velocity;
      each.turn += h * each.body->angular_velocity;
    }
    for (KeptContact& contact : contacts_) {
      contact.carry(bodies_, reach);
      contact.relax();
    }
    Step step = joints_step(world, h);
    joints.moved(step);
    sweep(step);
    joints.report(step);
  }
  /// Once in a step: contacts know their impulses, and what did not touch is no contact.
  void done(World& world) {
    forget_impacts();
    for (std::size_t i = 0; i < contacts_.size(); ++i) {
      const KeptContact& kept = contacts_[i];
      Contact& contact = world.contacts[i];
      contact.depth = -kept.separation(bodies_);
      contact.impulse = kept.impulse();
      contact.state =
          state_of(known_[i], kept.friction, kept.normal.impulse, kept.tangent1.impulse, kept.tangent2.impulse);
    }
    std::erase_if(world.contacts, [](const Contact& c) { return c.depth < 0 && c.impulse.isZero(0); });
  }

 private:
  static constexpr std::size_t none = std::numeric_limits<std::size_t>::max();

  std::size_t place_of(World& world, std::size_t body) {
    if (places_[body] == none) {
      places_[body] = bodies_.size();
      bodies_.push_back({&world.bodies[body]});
    }
    return places_[body];
  }
  void start_from_last_step(const World& world, Real h) {
    const Real scale = world.impulse_scale(h);
    known_.assign(contacts_.size(), false);
    auto old = world.contacts_before.begin();  // both lists ascend: walk them side by side
    for (std::size_t i = 0; i < contacts_.size(); ++i) {
      const ContactId id = world.contacts[i].id;
      while (old != world.contacts_before.end() && old->id < id) ++old;
      if (old == world.contacts_before.end() || old->id != id) continue;
      known_[i] = true;
      KeptContact& kept = contacts_[i];
      kept.guess(scale * old->impulse);
      kept.give(bodies_, 1);
    }
  }
  void sweep(Step& step) {
    joints.sweep(step);
    for (KeptBody& each : bodies_) {
      each.given -= each.body->velocity;
      each.given_turning -= each.body->angular_velocity;
    }
    push();
    for (KeptContact& contact : contacts_)
      if (contact.friction > 0) contact.rub();
    for (KeptBody& each : bodies_) {
      each.given += each.body->velocity;
      each.given_turning += each.body->angular_velocity;
    }
    rows_solved += 3 * contacts_.size();
  }

  /// An impact is over in one substep: the next one starts from the impulses that it started from.
  void forget_impacts() {
    if (fastest_ > 0)
      for (KeptContact& contact : contacts_) contact.restore(bodies_);
    fastest_ = 0;
  }
  /// Once; in a substep in which something bounces as often as it takes, as in chapter 09.
  void push() {
    Real change = fastest_;
    int round = 0;
    do {
      change = 0;
      for (KeptContact& contact : contacts_) change = std::max(change, contact.push());
    } while (change > precision * fastest_ && fastest_ > 0 && ++round < most_rounds);
  }

  Real fastest_ = 0;  // of what bounces in this substep, m/s; 0: nothing
  std::vector<KeptContact> contacts_;
  std::vector<KeptBody> bodies_;     // those that touch
  std::vector<std::size_t> places_;  // of each body of the world, in bodies_
  std::vector<bool> known_;          // of each contact: whether the step before had it
};

}  // namespace pushback
