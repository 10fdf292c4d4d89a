#include "pushback/engine/islands/remaining_bodies.h"

#include <tuple>

#include "pushback/common/collision/broad_phase.h"
#include "pushback/common/collision/collide.h"
#include "pushback/common/world/step.h"
#include "pushback/engine/islands/step_contacts.h"

namespace pushback {

namespace {

bool remains(const Body& body, const StepClassifier& classifier) {
  return classifier.step_of(body.index) == StepType::substeps && !classifier.is_moved_by_fast(body.index);
}

/// The remaining and the immovable bodies, as World::step knows them, in a world whose contacts have been found.
struct Remaining {
  const std::vector<int>& bodies;  // their indices, ascending
  Contacts& found;
  bool are_found = true;  // for the first detection only

  static void check(const World&) {}
  void find_contacts(World& world, const Margin& margin) {
    if (are_found) world.contacts.swap(found);
    else find_again(world, margin);
    are_found = false;
  }
  void find_again(World& world, const Margin& margin) const {
    world.contacts.clear();
    const JoinedPairs joined(world.joints);
    for (const auto& [first, second] : near_pairs(world.bodies, bodies, margin)) {
      const Body &a = world.body(first), &b = world.body(second);
      if (may_touch(a, b) && !joined.contain(first, second)) collide(a, b, world.contacts, margin);
    }
  }
  template <class Act>
  void each(World& world, const Act& act) const {
    for (const int body : bodies) act(world.bodies[std::size_t(body)]);
  }
  static void end(World&, Real /*dt*/) {}
};

/// If no body remains: the step of the immovable ones.
void step_immovable(World& world, const StepSolver& solver, Real dt) {
  world.contacts_before.swap(world.contacts);
  world.contacts.clear();
  for (Body& body : world.bodies) {
    if (body.movable()) continue;
    keep_velocity(body);
    integrate_velocity(body, world.gravity, dt);  // which clears its forces
    move(body, dt);
  }
  world.time += dt;
  world.dt_before = dt / static_cast<Real>(solver.plan(dt).all_substeps());
}

}  // namespace

int detections(Real spin, const ClassifierLimits& limits, Real dt) {
  int times = 1;
  while (2 * times <= limits.most_detections && spin * dt > limits.fast_turn * static_cast<Real>(times)) times *= 2;
  return times;
}

class RemainingBodies::Absence {
 public:
  Absence(RemainingBodies& memory, World& world, const StepClassifier& classifier)
      : memory_(memory), world_(world), classifier_(classifier) {
    memory_.joints_.swap(world.joints);
    memory_.lent_.clear();
    for (std::size_t i = 0; i < memory_.joints_.size(); ++i) {
      const Body &a = world.body(memory_.joints_[i].a), &b = world.body(memory_.joints_[i].b);
      if (!remains(a.movable() ? a : b, classifier)) continue;
      world.joints.push_back(std::move(memory_.joints_[i]));
      memory_.lent_.push_back(i);
    }
    memory_.velocities_.clear();
    for (Body& body : world.bodies) {
      memory_.velocities_.emplace_back(body.velocity, body.angular_velocity);
      if (body.movable() && !remains(body, classifier)) body.velocity = body.angular_velocity = Vec3::Zero();
    }
  }
  ~Absence() {
    for (std::size_t i = 0; i < memory_.lent_.size(); ++i)
      memory_.joints_[memory_.lent_[i]] = std::move(world_.joints[i]);
    memory_.joints_.swap(world_.joints);
    memory_.joints_.clear();
    for (Body& body : world_.bodies) {
      if (!body.movable() || remains(body, classifier_)) continue;
      std::tie(body.velocity, body.angular_velocity) = memory_.velocities_[std::size_t(body.index)];
    }
  }
  Absence(const Absence&) = delete;
  Absence& operator=(const Absence&) = delete;

 private:
  RemainingBodies& memory_;
  World& world_;
  const StepClassifier& classifier_;
};

SolveStats RemainingBodies::step(World& world, const StepClassifier& classifier, Contacts& found,
                                 const SubstepPass& pass) {
  const auto contained = [&](const Body& body) { return remains(body, classifier); };
  if (std::none_of(world.bodies.begin(), world.bodies.end(), contained)) {
    step_immovable(world, pass.runner, pass.dt);
    return {};
  }
  std::erase_if(found, [&](const Contact& contact) {
    const auto [a, b] = world.bodies_of(contact);
    return !contained(a.movable() ? a : b) || contact.id.feature == no_feature;
  });
  Real fastest = 0;
  for (const Body& body : world.bodies)
    if (contained(body)) fastest = std::max(fastest, body.angular_velocity.norm());
  const int times = detections(fastest, pass.settings.limits, pass.dt);
  Plan plan = pass.runner.plan(pass.dt / static_cast<Real>(times));
  plan.detections = times;
  {
    const Absence absence(*this, world, classifier);
    std::vector<int> bodies;
    for (const Body& body : world.bodies)
      if (!body.movable() || contained(body)) bodies.push_back(body.index);
    Remaining remaining{bodies, found};
    pushback::step(world, pass.runner, plan, pass.dt, pass.sweeps, remaining);
  }
  return pass.runner.stats();
}

}  // namespace pushback
