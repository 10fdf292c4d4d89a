#include "pushback/chapters/20_only_what_is_needed/questions.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "pushback/common/basics/input.h"

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

}  // namespace

Answer Touching::in(const World& world) {
  const bool movable = std::any_of(world.bodies.begin(), world.bodies.end(), [](const Body& b) { return b.movable(); });
  if (!movable) return {false, "nothing can move"};
  if (world.bodies.size() == 1) return {false, "there is one body only"};
  return {true, fmt::format("{} bodies, of which {} can move", world.bodies.size(),
                            std::count_if(world.bodies.begin(), world.bodies.end(),
                                          [](const Body& body) { return body.movable(); }))};
}

Answer Holding::in(const World& world) {
  for (const Joint& joint : world.joints) check_bodies_of(joint, world);
  if (world.joints.empty()) return {false, "nothing is joined"};
  const Joint& first = world.joints.front();
  const auto end = [&world](int i) { return i == the_world ? "the world" : name_of(world.bodies[std::size_t(i)]); };
  const std::string it = fmt::format("{} between {} and {}", first.name, end(first.a), end(first.b));
  const std::size_t more = world.joints.size() - 1;
  return {true, more == 0 ? it : fmt::format("{}, and {} more", it, more)};
}

Answer Bouncing::in(const World& world) {
  return strongest_pair(
      world, &Body::restitution, "e", [](Real p, Real q) { return std::max(p, q); },
      "e = 0 in every pair that can touch");
}

Answer Rubbing::in(const World& world) {
  return strongest_pair(
      world, &Body::friction, "μ", [](Real p, Real q) { return std::sqrt(p * q); },
      "μ = 0 in every pair that can touch");
}

Answer Tumbling::in(const World& world) {
  const auto body = std::find_if(world.bodies.begin(), world.bodies.end(), tumbles);
  if (body == world.bodies.end()) return {false, "every body's inertia is the same about all its axes"};
  return {true, fmt::format("the inertia of {} differs from axis to axis", name_of(*body))};
}

Answer Pulling::in(const World& world) {
  for (const Force& force : world.forces) check_bodies_of(force, world);
  if (!world.forces.empty()) {
    const Force& force = world.forces.front();
    if (force.bodies.empty()) return {true, force.name};
    return {true, fmt::format("{} on {}", force.name, name_of(world.bodies[std::size_t(force.bodies.front())]))};
  }
  const auto pulled = [](const Body& body) { return !body.force.isZero(0) || !body.torque.isZero(0); };
  const auto body = std::find_if(world.bodies.begin(), world.bodies.end(), pulled);
  if (body == world.bodies.end()) return {false, "nothing pulls but gravity"};
  return {true, fmt::format("a force on {}", name_of(*body))};
}

}  // namespace pushback
