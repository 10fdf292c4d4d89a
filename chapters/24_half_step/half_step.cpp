#include "pushback/chapters/24_half_step/half_step.h"

#include <algorithm>
#include <array>
#include <tuple>

#include "pushback/common/basics/input.h"

namespace pushback {

namespace {

/// x += h v, and the turn. A body that spins about one of its principal axes turns evenly: `spin_freely` would find that out
/// by Newton's method, each time.
void drift(Body& body, Real h) {
  if (body.conveys) return;
  body.position += h * body.velocity;
  if (body.angular_velocity == Vec3::Zero()) return;
  const Vec3 spin = body.orientation.conjugate() * body.angular_velocity;
  const Vec3& inverse = body.principal_inverse_inertia;
  const Vec3 momentum = spin.cwiseQuotient(inverse);
  if (inverse.minCoeff() > 0 && momentum.cross(spin) != Vec3::Zero()) spin_freely(body, h);
  else spin_evenly(body, h);
}

}  // namespace

HalfStep::State::State(const Body& body)
    : velocity(body.velocity),
      angular_velocity(body.angular_velocity),
      position(body.position),
      orientation(body.orientation) {}

void HalfStep::State::give(Body& body) const {
  body.velocity = velocity;
  body.angular_velocity = angular_velocity;
  body.position = position;
  body.orientation = orientation;
}

std::span<const Real> HalfStep::parts() const {
  static constexpr std::array<Real, 1> whole{1};
  return whole;
}

void HalfStep::keep(const World& world, std::vector<State>& states) {
  states.clear();
  for (const Body& body : world.bodies) states.emplace_back(body);
}

void HalfStep::give(World& world, const std::vector<State>& states) {
  for (std::size_t i = 0; i < states.size(); ++i) states[i].give(world.bodies[i]);
}

void HalfStep::check(World& world, Real /*h*/) {
  if (substeps < 1) throw InvalidInput(fmt::format("substeps is {}: a whole number, 1 or more, is needed", substeps));
  if (most_rounds < 1)
    throw InvalidInput(fmt::format("most_rounds is {}: a whole number, 1 or more, is needed", most_rounds));
  if (most_halvings < 0)
    throw InvalidInput(fmt::format("most_halvings is {}: a whole number, 0 or more, is needed", most_halvings));
  require_positive("tolerance", tolerance);
  require_not_negative("threshold", threshold);
  contacts_.threshold = threshold;
  for (const Body& body : world.bodies)
    if (body.asleep) throw InvalidInput("a body is asleep: half steps do not let bodies sleep");
  joints_.check(world);
  by_hand_.clear();
  const auto feels = [](const Body& body) { return body.force != Vec3::Zero() || body.torque != Vec3::Zero(); };
  if (std::none_of(world.bodies.begin(), world.bodies.end(), feels)) return;
  for (const Body& body : world.bodies) by_hand_.emplace_back(body.force, body.torque);
}

void HalfStep::detected(World& world, Real /*h*/) {
  if (world.contacts.empty() || holds_contacts(world)) return;
  const ContactId& id = world.contacts.front().id;
  throw InvalidInput(fmt::format("bodies {} and {} touch: {}", id.body_a, id.body_b,
                                 world.joints.empty() ? "a composed step goes back in time, and contacts do not"
                                                      : "half steps hold joints or contacts, and not both"));
}

bool HalfStep::holds_contacts(const World& world) const {
  return world.joints.empty() && parts().size() == 1;
}

/// As far as two bodies may come nearer in a drift.
Margin HalfStep::margin(const World& world, Real h) {
  return {.least = Real(1e-3) + h * h * world.gravity.norm(), .ahead = 2 * h};
}

/// Where the bodies are.
void HalfStep::accelerate(World& world) {
  accelerations_.clear();
  if (by_hand_.empty() && world.forces.empty()) return;
  for (std::size_t i = 0; i < by_hand_.size(); ++i)
    std::tie(world.bodies[i].force, world.bodies[i].torque) = by_hand_[i];
  std::swap(world.time, time_);  // a force may depend on it
  for (const Force& force : world.forces) force.apply(world);
  std::swap(world.time, time_);
  for (Body& body : world.bodies) {
    accelerations_.push_back({world.gravity + body.inverse_mass * body.force, body.inverse_inertia * body.torque});
    body.force.setZero();
    body.torque.setZero();
  }
}

void HalfStep::kick(World& world, Real h) const {
  for (std::size_t i = 0; i < world.bodies.size(); ++i) {
    Body& body = world.bodies[i];
    if (!body.movable()) continue;
    if (accelerations_.empty()) {
      body.velocity += h * world.gravity;
      continue;
    }
    body.velocity += h * accelerations_[i].linear;
    body.angular_velocity += h * accelerations_[i].angular;
  }
}

/// False where Newton's method does not get there: then all is as it was. The rows are placed where the bodies are, before and
/// after.
bool HalfStep::step(World& world, Real h) {
  keep(world, begun_);
  kick(world, h / 2);
  joints_.start(h);
  const bool contacts = holds_contacts(world);
  if (contacts) contacts_.press(world, h);
  keep(world, before_);
  Real off = std::numeric_limits<Real>::infinity();
  for (int round = 0;; ++round) {
    for (Body& body : world.bodies) drift(body, h);
    const Real off_before = off;
    off = joints_.ask(world, time_ + h);
    if (off <= tolerance) break;
    // Each round leaves a part of what was off; where that is most of it, the step is too large.
    if (round == most_rounds || !(off < off_before / 2)) {
      give(world, begun_);
      joints_.take_back();
      return false;
    }
    give(world, before_);
    joints_.press(h);
    keep(world, before_);
    ++rounds_;
  }
  off_ = std::max(off_, off / std::abs(h));
  time_ += h;
  for (Body& body : world.bodies)
    if (body.angular_velocity != Vec3::Zero()) body.refresh_inertia();
  accelerate(world);
  kick(world, h / 2);
  if (contacts) {
    contacts_.detect(world, margin(world, h));
    contacts_.project(world, h);
  }
  joints_.place(world, time_, h);
  joints_.project(h);
  return true;
}

void HalfStep::advance(World& world, Real h, int halvings) {
  if (step(world, h)) return;
  if (halvings == most_halvings)
    throw InvalidInput(fmt::format("{} cannot be held in {} steps of {} s: more substeps are needed",
                                   world.joints[joints_.worst()].name, 1 << halvings, h));
  ++halvings_;
  advance(world, h / 2, halvings + 1);
  advance(world, h / 2, halvings + 1);
}

void HalfStep::solve(World& world, Real h, int /*sweeps*/) {
  for (Body& body : world.bodies) {
    body.velocity = body.velocity_before;
    body.angular_velocity = body.angular_velocity_before;
  }
  time_ = world.time;
  off_ = 0;
  halvings_ = rounds_ = 0;
  keep(world, after_);
  accelerate(world);
  joints_.begin(world);
  const Real of_substep = h / static_cast<Real>(substeps);
  if (holds_contacts(world)) contacts_.begin(world, margin(world, of_substep));
  joints_.place(world, time_, of_substep);
  try {
    for (int i = 0; i < substeps; ++i)
      for (const Real part : parts()) advance(world, part * of_substep, 0);
  } catch (const InvalidInput&) {
    give(world, after_);
    for (Body& body : world.bodies) body.refresh_inertia();
    throw;
  }
  joints_.report(world);
  if (holds_contacts(world)) contacts_.report(world);
  keep(world, after_);
  for (Body& body : world.bodies) {
    body.velocity.setZero();
    body.angular_velocity.setZero();
  }
}

void HalfStep::moved(World& world, Real /*h*/) {
  give(world, after_);
}

}  // namespace pushback
