#include "pushback/tools/measure/hard_cases/watcher.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "pushback/common/world/measure.h"

namespace pushback {

namespace {

/// N s: of the latest substep, within a step or after it. Sums over substeps are within no cone, as normals turn.
const Vec3& impulse_of_substep(const World& world, const Contact& contact) {
  return world.last_impulses_known ? contact.last_impulse : contact.impulse;
}

constexpr Real units = 1e5;  // of rounding that are allowed: 2e-11 in double

/// The largest moment of inertia over the smallest. R I^-1 R^T is one matrix: what rounds its largest entries off is to the
/// smallest so many times as much, and an impulse turns a needle by that much less exactly. Its w, which is mostly about the
/// axis that is easy to turn, knows the momentum about the others no better. In numbers, of the impulse's arm x p:
///
///   an entry of R is known to some 4 epsilon, one of R I^-1 R^T to 12 / I_min, and all nine together to 36 / I_min;
///   times I_max for L, and the three impulses of a contact are together up to sqrt(3) |p|: 62 epsilon I_max / I_min
///
/// and `feel` allows 100. An error of one step is there in the next, and the same orientation makes the same error again:
/// they add up. This knows nothing of the matrix in the body, so a wrong one, of before a turn, is still found out.
Real unevenness(const Body& body) {
  const Vec3& inverse = body.principal_inverse_inertia;
  return inverse.minCoeff() > 0 ? inverse.maxCoeff() / inverse.minCoeff() : 1;
}

/// kg m/s; 0 for a body that nothing moves.
Vec3 momentum_of(const Body& body) {
  return body.movable() ? Vec3(body.velocity / body.inverse_mass) : Vec3::Zero();
}

}  // namespace

void Watcher::feel(const World& world) {
  Sizes sizes;
  for (const Body& body : world.bodies) {
    if (!body.movable()) continue;
    const Real momentum = body.velocity.norm() / body.inverse_mass;
    sizes.momentum += momentum;
    sizes.angular_momentum += body.position.norm() * momentum + spin_momentum(body).norm();
    const Real least = body.principal_inverse_inertia.minCoeff();
    if (least > 0) sizes_.turning += body.angular_velocity.norm() / least / 1000;
    sizes.energy += std::abs(world.gravity.dot(body.position)) / body.inverse_mass;
  }
  sizes.energy += kinetic_energy(world);
  for (const Contact& contact : world.contacts) {
    const auto [a, b] = world.bodies_of(contact);
    for (const Body* body : {&a, &b}) {
      const Real arm = (contact.point - body->position).norm();
      sizes_.turning += arm * impulse_of_substep(world, contact).norm() * unevenness(*body) / 1000;
    }
  }
  sizes_.energy = std::max(sizes_.energy, sizes.energy);
  sizes_.momentum = std::max(sizes_.momentum, sizes.momentum);
  sizes_.angular_momentum = std::max(sizes_.angular_momentum, sizes.angular_momentum);
}

Watcher::Watcher(const World& start, const Allowance& allowance)
    : allowance_(allowance),
      momentum_(momentum(start)),
      angular_momentum_(angular_momentum(start)),
      energy_(kinetic_energy(start) + potential_energy(start)) {
  for (const Body& body : start.bodies) momenta_.push_back(momentum_of(body));
}

void Watcher::breaks(const std::string& how) {
  if (broken_.empty()) broken_ = fmt::format("{} after {:.3g} s", how, time_);
}

void Watcher::look(const World& world, Real dt, int substeps, const std::function<bool(int body)>& half_steps) {
  time_ += dt;
  if (!finite(world)) return breaks("not finite");

  feel(world);
  const Real rounding = units * allowance_.epsilon;
  const Real energy = kinetic_energy(world) + potential_energy(world);
  // The change of T + U + h/2 g . P, which v += h g, x += h v keeps.
  Real along_gravity = 0;
  momenta_.resize(world.bodies.size(), Vec3::Zero());
  for (std::size_t i = 0; i < momenta_.size(); ++i) {
    const Vec3 before = std::exchange(momenta_[i], momentum_of(world.bodies[i]));
    if (!half_steps || !half_steps(static_cast<int>(i))) along_gravity += world.gravity.dot(momenta_[i] - before);
  }
  gained_ += energy - energy_ + dt / static_cast<Real>(2 * substeps) * along_gravity;
  energy_ = energy;
  energy_gained_ = std::max(energy_gained_, gained_);
  const auto driven = [](const Joint& joint) { return joint.driven; };
  const bool worked_on = std::any_of(world.joints.begin(), world.joints.end(), driven);
  if (!worked_on && energy_gained_ > allowance_.energy + rounding * sizes_.energy) {
    breaks(fmt::format("{:.3g} J gained", energy_gained_));
  }
  const auto held = [&world](const Joint& joint) {
    return !body_of(world, joint.a).movable() || !body_of(world, joint.b).movable();
  };
  if (allowance_.isolated && std::none_of(world.joints.begin(), world.joints.end(), held)) {
    const Real change = (momentum(world) - momentum_).norm();
    if (change > rounding * sizes_.momentum) breaks(fmt::format("momentum changed by {:.3g} N s", change));
    const Real turn = (angular_momentum(world) - angular_momentum_).norm();
    if (turn > rounding * (sizes_.angular_momentum + sizes_.turning)) {
      breaks(fmt::format("angular momentum changed by {:.3g} N m s", turn));
    }
  }
  for (const Contact& contact : world.contacts) {
    if (!contact.parted) deepest_ = std::max(deepest_, contact.depth);
    const Vec3& impulse = impulse_of_substep(world, contact);
    const Real pressed = impulse.dot(contact.normal);
    const Real slack = rounding * impulse.norm();
    if (pressed < -slack) breaks(fmt::format("a contact pulls with {:.3g} N s", -pressed));
    const auto [t1, t2] = tangents_of(contact.normal);
    const Real rubbed = std::max(std::abs(impulse.dot(t1)), std::abs(impulse.dot(t2)));
    if (rubbed > contact.friction * pressed + slack) {
      breaks(fmt::format("friction is {:.3g} of what presses", rubbed / pressed));
    }
  }
  if (deepest_ > allowance_.overlap) breaks(fmt::format("{:.3g} m of overlap", deepest_));
}

}  // namespace pushback
