#include "pushback/chapters/25_moment_of_impact/at_impacts.h"

#include <algorithm>

#include "pushback/chapters/25_moment_of_impact/first_touch.h"
#include "pushback/chapters/25_moment_of_impact/gap.h"
#include "pushback/common/basics/input.h"
#include "pushback/common/collision/collide.h"

namespace pushback {

namespace {

constexpr Real touches = HeldContacts::touches;
constexpr Real stands = std::numeric_limits<Real>::digits > 24 ? Real(1e-6) : Real(1e-3);  // m/s: slower is no impact
constexpr int most_pairs = 1000;  // solved in sequence, before all are at the same time

BodyPair pair_of(const Contact& at) {
  return {static_cast<int>(at.id.body_a), static_cast<int>(at.id.body_b)};
}

}  // namespace

/// What is apart is no contact.
Plan AtImpacts::plan(Real dt) const {
  Plan plan = HalfStep::plan(dt);
  plan.margin = {.least = touches};
  return plan;
}

void AtImpacts::check(World& world, Real h) {
  HalfStep::check(world, h);
  if (most_events < 0)
    throw InvalidInput(fmt::format("most_events is {}: a whole number, 0 or more, is needed", most_events));
}

void AtImpacts::solve(World& world, Real h, int sweeps) {
  events_ = 0;
  bound_reached_ = false;
  HalfStep::solve(world, h, sweeps);
}

/// By forces, and by what is borne where bodies touch.
void AtImpacts::accelerate_bodies(const World& world) {
  accelerations_.clear();
  for (std::size_t i = 0; i < world.bodies.size(); ++i) accelerations_.push_back(acceleration(world, i).linear);
  contacts_.add_borne(world, accelerations_);
}

/// a: how the two are pressed together.
Real AtImpacts::pressing(const Contact& at) const {
  return at.normal.dot(accelerations_[at.id.body_a] - accelerations_[at.id.body_b]);
}

void AtImpacts::bounce(World& world, Real h, const std::vector<std::size_t>& which) {
  Contacts contacts;
  Rows rows;
  for (const std::size_t i : which) contacts.push_back(world.contacts[i]);
  for (std::size_t k = 0; k < contacts.size(); ++k) rows.emplace_back(world, contacts[k], contacts[k].normal, k);
  for (std::size_t k = 0; k < contacts.size(); ++k) {
    const auto [tangent1, tangent2] = tangents_of(contacts[k].normal);
    rows.emplace_back(world, contacts[k], tangent1, k);
    rows.emplace_back(world, contacts[k], tangent2, k);
  }
  Real rounding = stands;
  for (std::size_t k = 0; k < contacts.size(); ++k) {
    const Real approach = rows[k].speed(), e = contacts[k].restitution;
    rounding = std::max(rounding, -100 * std::numeric_limits<Real>::epsilon() * approach);
    if (approach >= -threshold) continue;
    const Real leaves = -e * approach;
    const bool last = 2 * leaves <= h * (1 - e) * pressing(contacts[k]);  // T <= h
    if (!last) rows[k].bias = -leaves;
  }
  direct_.work = exact_direct_contacts().work;
  StepContext step{world, contacts, rows, h};
  direct_.start(step);
  for (std::size_t k = 0; k < contacts.size(); ++k)
    if (!(step.speed_error(k) >= -rounding))
      throw InvalidInput(fmt::format("where bodies {} and {} meet, {} m/s are left: impacts need solved contacts",
                                     contacts[k].id.body_a, contacts[k].id.body_b, -step.speed_error(k)));
  const std::size_t count = which.size();
  for (std::size_t k = 0; k < count; ++k)
    contacts_.add(which[k], {rows[k].impulse, rows[count + 2 * k].impulse, rows[count + 2 * k + 1].impulse});
}

/// False where none approach.
bool AtImpacts::impact(World& world, Real h) {
  touching_.clear();
  for (std::size_t i = 0; i < world.contacts.size(); ++i)
    if (world.contacts[i].depth > -touches) touching_.push_back(i);
  const auto fastest = [&] {
    return std::min_element(touching_.begin(), touching_.end(), [&](std::size_t p, std::size_t q) {
      return separating_speed(world, world.contacts[p]) < separating_speed(world, world.contacts[q]);
    });
  };
  const auto approaches = [&](const auto& at) {
    return at != touching_.end() && separating_speed(world, world.contacts[*at]) < -stands;
  };
  auto first = fastest();
  if (!approaches(first)) return false;
  accelerate_bodies(world);
  for (int round = 0; impacts == Impacts::sequential && round < most_pairs && approaches(first); ++round) {
    const BodyPair pair = pair_of(world.contacts[*first]);
    of_pair_.clear();
    for (const std::size_t i : touching_)
      if (pair_of(world.contacts[i]) == pair) of_pair_.push_back(i);
    bounce(world, h, of_pair_);
    first = fastest();
  }
  if (approaches(first)) bounce(world, h, touching_);
  contacts_.look(world);
  return true;
}

/// Pairs that touch and do not leave; and those that overlap.
void AtImpacts::hold_touching(World& world, Real h) {
  if (!contacts_.only) contacts_.only.emplace();
  contacts_.only->clear();
  for (const Contact& at : world.contacts) {
    const BodyPair pair = pair_of(at);
    if (!contacts_.only->empty() && contacts_.only->back() == pair) continue;
    if (at.depth > touches || (at.depth > -touches && separating_speed(world, at) <= stands))
      contacts_.only->push_back(pair);
  }
  if (!contacts_.only->empty() && !ahead_) look_ahead(world, h);
}

void AtImpacts::begin_contacts(World& world, Real h) {
  if (!world.joints.empty()) {  // as chapter 24
    contacts_.only.reset();
    world.find_contacts(HalfStep::plan(h).margin);
    return HalfStep::begin_contacts(world, h);
  }
  alone_ = false;
  ahead_ = false;
  contacts_.begin(world);
}

/// Of pairs that are held, each point that may touch next has to be known. Where none is, all have flown, and who may have met is known.
void AtImpacts::detect_contacts(World& world, Real h) {
  ahead_ = !world.joints.empty() || !contacts_.only || !contacts_.only->empty();
  if (ahead_) return HalfStep::detect_contacts(world, h);
  world.contacts.clear();
  for (const auto& [first, second] : near_) {
    const Body &a = world.body(first), &b = world.body(second);
    if (may_touch(a, b)) collide(a, b, world.contacts, {.least = touches});
  }
  contacts_.detected(world);
}

void AtImpacts::look_ahead(World& world, Real h) {
  ahead_ = true;
  HalfStep::detect_contacts(world, h);
  contacts_.look(world);
}

std::optional<Real> AtImpacts::next_touch(const World& world, Real within) {
  Real turns = 0, strongest = 0;
  for (std::size_t i = 0; i < world.bodies.size(); ++i) {
    const Body& body = world.bodies[i];
    strongest = std::max(strongest, accelerations_[i].squaredNorm());
    if (body.angular_velocity.isZero(0) && acceleration(world, i).angular.isZero(0)) continue;
    for (const Vec3& corner : corners_of_core(body)) turns = std::max(turns, 2 * corner.norm());
  }
  const Margin margin{.least = touches + turns + within * within / 2 * std::sqrt(strongest), .ahead = within};
  std::optional<Real> first;
  near_ = near_pairs(world.bodies, margin);
  for (const BodyPair& pair : near_) {
    const auto p = static_cast<std::size_t>(pair.first), q = static_cast<std::size_t>(pair.second);
    const Body &a = world.bodies[p], &b = world.bodies[q];
    if (!may_touch(a, b)) continue;
    if (std::binary_search(contacts_.only->begin(), contacts_.only->end(), pair)) continue;
    const Real before = first.value_or(within);
    Flight of_a(a, accelerations_[p], acceleration(world, p).angular, before);
    Flight of_b(b, accelerations_[q], acceleration(world, q).angular, before);
    if (const std::optional<Real> touch = first_touch(of_a, of_b, before, touches / 2)) first = touch;
  }
  return first;
}

void AtImpacts::advance(World& world, Real h) {
  if (!world.joints.empty()) return HalfStep::advance(world, h);
  Real left = h;
  for (int cuts = 0; left > 0; ++cuts) {
    if (impact(world, h)) ++events_;
    if (cuts == most_events) {
      bound_reached_ = true;
      contacts_.only.reset();
      look_ahead(world, h);
      return HalfStep::advance(world, left);
    }
    hold_touching(world, h);
    accelerate_bodies(world);
    const Real part = next_touch(world, left).value_or(left);
    if (part > 0) HalfStep::advance(world, part);
    left -= part;
  }
}

}  // namespace pushback
