#include "pushback/engine/islands/scene_questions.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "pushback/common/basics/input.h"
#include "pushback/engine/islands/island_solver.h"

namespace pushback {

namespace {

struct ShapeName {
  const char* operator()(const Sphere&) const { return "ball"; }
  const char* operator()(const Box&) const { return "box"; }
  const char* operator()(const Capsule&) const { return "capsule"; }
  const char* operator()(const HalfSpace&) const { return "plane"; }
  const char* operator()(const Hull&) const { return "hull"; }
};

std::string name_of(const Body& body) {
  return fmt::format("{} {}", std::visit(ShapeName{}, body.shape), body.index);
}

std::string body_in(const World& world, int body) {
  return body == the_world ? "the world" : name_of(world.bodies[std::size_t(body)]);
}
std::string joint_in(const World& world, int joint) {
  const Joint& it = world.joints[std::size_t(joint)];
  return fmt::format("{} between {} and {}", it.name, body_in(world, it.a), body_in(world, it.b));
}
std::string force_in(const World& world, int force) {
  const Force& it = world.forces[std::size_t(force)];
  return it.bodies.empty() ? it.name : fmt::format("{} on {}", it.name, body_in(world, it.bodies.front()));
}

/// Yes, with the pair that can touch and has the largest `of`, if that is above 0; otherwise no, with `why_not`. `of` grows with
/// the values of both bodies, so the pair is the movable body with the largest value and the other body with the largest value.
template <class Of>
Answer strongest_pair(const World& world, Real Body::* own, const char* symbol, const Of& of, const char* why_not) {
  const Body *a = nullptr, *b = nullptr;
  for (const Body& body : world.bodies) {
    if (body.movable() && (a == nullptr || body.*own > a->*own)) a = &body;
  }
  for (const Body& body : world.bodies) {
    if (&body != a && (b == nullptr || body.*own > b->*own)) b = &body;
  }
  if (a == nullptr || b == nullptr || !(of(a->*own, b->*own) > 0)) return {false, why_not};
  return {true, fmt::format("{} = {:.3g} between {} and {}", symbol, of(a->*own, b->*own), name_of(*a), name_of(*b))};
}

/// The reason for the step of an island, in words. `world`: with the forces and joints that it had when the step began.
std::string because(StepReason reason, const World& world, const StepClassifier& classifier, int island) {
  const int contacts = classifier.contacts(island), cause = classifier.cause(island);
  const std::string counted = fmt::format("{} contact{}", contacts, contacts == 1 ? "" : "s");
  const std::string few = fmt::format("{}, no more than {}", counted, classifier.contact_limit(island)),
                    many = fmt::format("{}, more than {}", counted, classifier.contact_limit(island));
  std::string failed = "half steps did not converge within the work limit, or did not keep the energy";
  switch (reason) {
    case StepReason::none:
      break;
    case StepReason::no_contact:
      return "nothing touches or holds it";
    case StepReason::rigid_joints:
      return "rigid joints that form a tree, and no contact";
    case StepReason::few_contacts:
      return contacts > 0 ? few : "bodies nearby, but no contact in this step";
    case StepReason::resting_contacts:
      return many + ", but no impact and no fast turn";
    case StepReason::single_contacts:
      return few + ", of bodies that meet in one point each";
    case StepReason::applied_force:
      return force_in(world, cause);
    case StepReason::joint_loop:
      return "joints that form a loop";
    case StepReason::joint_not_rigid:
      return "a joint that is not rigid, " + joint_in(world, cause);
    case StepReason::asleep:
      return fmt::format("{} sleeps", body_in(world, cause));
    case StepReason::moving_surface:
      return fmt::format("{} turns, or its surface does not move along its face", body_in(world, cause));
    case StepReason::unequal_grounds:
      return fmt::format("{} moves otherwise than other ground nearby", body_in(world, cause));
    case StepReason::deep_overlap:
      return fmt::format("an overlap of {:.3g} mm, more than {:.3g} mm", 1000 * classifier.deepest(island),
                         1000 * StepClassifier::too_deep);
    case StepReason::contacts_and_joints:
      return many + ", and joints";
    case StepReason::impact:
      return many + ", and an impact";
    case StepReason::fast_turn:
      return fmt::format("{}, and {} turns fast", many, body_in(world, cause));
    case StepReason::large_pile:
      return fmt::format("{}, at least {}, in a pile that moves: as by Fast", counted,
                         classifier.contact_limit(island));
    case StepReason::no_savings:
      return many + ", and half steps cost more than was saved";
    case StepReason::failed:
      return failed;
    case StepReason::failed_before:
      return failed + ", in an earlier step";
  }
  return {};
}

}  // namespace

Answer NeedsContacts::in(const World& world) {
  const bool movable = std::any_of(world.bodies.begin(), world.bodies.end(), [](const Body& b) { return b.movable(); });
  if (!movable) return {false, "nothing can move"};
  if (world.bodies.size() == 1) return {false, "there is one body only"};
  return {true, fmt::format("{} bodies, of which {} can move", world.bodies.size(),
                            std::count_if(world.bodies.begin(), world.bodies.end(),
                                          [](const Body& body) { return body.movable(); }))};
}

Answer NeedsJoints::in(const World& world) {
  for (const Joint& joint : world.joints) check_bodies_of(joint, world);
  if (world.joints.empty()) return {false, "nothing is joined"};
  const std::string it = joint_in(world, 0);
  const std::size_t more = world.joints.size() - 1;
  return {true, more == 0 ? it : fmt::format("{}, and {} more", it, more)};
}

Answer NeedsRestitution::in(const World& world) {
  return strongest_pair(
      world, &Body::restitution, "e", [](Real p, Real q) { return std::max(p, q); },
      "e = 0 in every pair that can touch");
}

Answer NeedsFriction::in(const World& world) {
  return strongest_pair(
      world, &Body::friction, "μ", [](Real p, Real q) { return std::sqrt(p * q); },
      "μ = 0 in every pair that can touch");
}

Answer NeedsGyroscopicTerm::in(const World& world) {
  const auto body = std::find_if(world.bodies.begin(), world.bodies.end(), tumbles);
  if (body == world.bodies.end()) return {false, "every body's inertia is the same about all its axes"};
  return {true, fmt::format("the inertia of {} differs from axis to axis", name_of(*body))};
}

Answer NeedsAppliedForces::in(const World& world) {
  for (const Force& force : world.forces) check_bodies_of(force, world);
  if (!world.forces.empty()) return {true, force_in(world, 0)};
  const auto pulled = [](const Body& body) { return !body.force.isZero(0) || !body.torque.isZero(0); };
  const auto body = std::find_if(world.bodies.begin(), world.bodies.end(), pulled);
  if (body == world.bodies.end()) return {false, "nothing pulls but gravity"};
  return {true, fmt::format("a force on {}", name_of(*body))};
}

const char* name_of(StepType step) {
  switch (step) {
    case StepType::none:
      break;
    case StepType::flight:
      return "flight";
    case StepType::half_steps:
      return "half steps";
    case StepType::substeps:
      return "substeps";
  }
  return "none";
}

std::vector<StepAnswer> steps_of(const World& world, const IslandSolver& solver, Real dt) {
  World copy = world;
  IslandSolver its_solver = solver;
  copy.step(its_solver, dt);
  StepClassifier classifier = its_solver.classifier();
  std::vector<StepAnswer> answers;
  for (const Body& body : world.bodies) {
    const StepReason reason = classifier.reason_of(body.index);
    if (reason == StepReason::none) continue;
    const int island = classifier.island_of(body.index);
    const std::string text = because(reason, world, classifier, island);
    const StepType step = type_of(reason);
    auto answer = std::find_if(answers.begin(), answers.end(),
                               [&](const StepAnswer& other) { return other.step == step && other.because == text; });
    if (answer == answers.end()) answer = answers.insert(answer, {step, text, 0, {}});
    answer->islands += island == body.index ? 1 : 0;
    answer->bodies.push_back(body.index);
  }
  return answers;
}

std::vector<StepAnswer> steps_of(const World& world) {
  return steps_of(world, IslandSolver(), Real(1) / 60);
}

}  // namespace pushback
