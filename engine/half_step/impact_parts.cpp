// The parts of a substep between impacts.
#include <algorithm>

#include "pushback/common/collision/collide.h"
#include "pushback/common/world/measure.h"
#include "pushback/engine/half_step/impact_cuts.h"

namespace pushback {

namespace {

constexpr int most_tries = 50;  // to end a part of a step where something touches
constexpr int most_aimed_tries =
    3;  // of these, the first: aimed higher, by how far the drift has turned the contact in
constexpr Real by_aiming = Real(1e-3);      // of T: a drift that is aimed higher may gain this much
constexpr Real shortest_part = Real(1e-7);  // s

}  // namespace

/// A half step of `within`, or of less if that has to be divided. It leaves the world at its end, and finds the accelerations that joints
/// are part of.
ImpactCuts::Length ImpactCuts::try_half_step(KickDrift& motion, World& world, const KickDrift::Snapshot& begin,
                                             Real within) {
  for (;; within /= 2) {
    const int before = motion.halvings();
    motion.contact_free = motion.contacts.held_pairs->empty();  // joints without contacts are a linear system
    const bool done = motion.advance(world, within);
    motion.contact_free = false;
    if (!done) return {};
    if (motion.halvings() == before) break;
    motion.restore(world, begin);
  }
  accelerations_.clear();
  turning_.clear();
  for (std::size_t i = 0; i < world.bodies.size(); ++i) {
    accelerations_.push_back(2 / within * (motion.before_drift[i].velocity - begin.bodies[i].velocity));
    turning_.push_back(2 / within * (motion.before_drift[i].angular_velocity - begin.bodies[i].angular_velocity));
  }
  return within;
}

/// The held contacts that a drift of h s has let in by more than `most_sinking` and deeper than their pair was in `begun`, World::contacts before
/// the drift. A turn moves a point off its straight path by at most h^2/2 w^2 r.
std::vector<ImpactCuts::Sunk> ImpactCuts::sunk_since(const KickDrift& motion, const World& world, const Contacts& begun,
                                                     Real h) const {
  std::vector<Sunk> sunk;
  auto old = begun.begin();  // both lists ascend, so go through them in parallel
  for (const Contact& at : world.contacts) {
    if (at.depth <= most_sinking || !motion.contacts.holds(at.id)) continue;
    while (old != begun.end() && pair_of(*old) < pair_of(at)) ++old;
    Real depth = 0;  // of the pair before
    auto same = begun.end();
    for (auto i = old; i != begun.end() && pair_of(*i) == pair_of(at); ++i) {
      depth = std::max(depth, i->depth);
      if (i->id == at.id) same = i;
    }
    if (at.depth <= depth + most_sinking / 100) continue;
    Vec3 speed = Vec3::Zero();
    Real bend = 0;
    for (const auto& [body, sign] : {std::pair(at.id.body_a, 1), std::pair(at.id.body_b, -1)}) {
      const BodyState& before = motion.before_drift[body];
      const Vec3 arm = at.point - world.bodies[body].position;
      speed += sign * (before.velocity + before.angular_velocity.cross(arm));
      bend += h * h / 2 * before.angular_velocity.squaredNorm() * arm.norm();
    }
    const Real approach = at.normal.dot(speed);
    sunk.push_back({.since = approach > 0 ? at.depth / approach : std::numeric_limits<Real>::infinity()});
    if (same != begun.end() && same->depth > -touch_distance) {
      sunk.back().by = at.depth - std::max(same->depth, Real(0));
      if (sunk.back().by <= 8 * bend) sunk.back().known = same - begun.begin();
    }
  }
  return sunk;
}

/// s: in how long the first pair touches. Negative: how long ago contacts have touched that overlap now and are not held. 0: now, or
/// unknown.
Real ImpactCuts::touch_in(const KickDrift& motion, const World& world, const Contacts& begun, Real h) const {
  Real longest = 0;
  for (const Sunk& sunk : sunk_since(motion, world, begun, h)) longest = std::max(longest, sunk.since);
  for (const Contact& at : world.contacts) {
    if (at.depth <= touch_distance) continue;
    if (motion.contacts.holds(at.id)) continue;
    const Real approach = -separating_speed(world, at);
    longest = std::max(longest, approach > 0 ? at.depth / approach : std::numeric_limits<Real>::infinity());
  }
  if (longest > 0 || !first_) return -longest;
  Contacts near;
  collide(world.body(first_->first), world.body(first_->second), near, {.least = Real(1e-3)});
  if (near.empty()) return 0;
  const Contact& nearest =
      *std::max_element(near.begin(), near.end(), [](const Contact& p, const Contact& q) { return p.depth < q.depth; });
  const Real approach = -separating_speed(world, nearest);
  return nearest.depth < -touch_distance && approach > resting_speed ? -nearest.depth / approach : 0;
}

/// Whether the pair that touches first touches already. As bodies turn, one corner comes as another one leaves.
bool ImpactCuts::touch_already(const Contacts& contacts) const {
  return std::any_of(contacts.begin(), contacts.end(),
                     [this](const Contact& at) { return pair_of(at) == *first_ && at.depth > -touch_distance; });
}

/// Drifts for at most `within` s, in which no other pair touches. Ends earlier if a held contact sinks in.
ImpactCuts::Length ImpactCuts::move_free(KickDrift& motion, World& world, Real within) {
  if (motion.contacts.held_pairs && motion.contacts.held_pairs->empty()) {
    if (!motion.advance(world, within)) return {};
    return within;
  }
  const KickDrift::Snapshot begin = motion.snapshot(world);
  HeldContacts held = begin.held;  // with what is known of the drift
  Real part = within, plain = 0;   // J: after a drift that is not aimed higher
  bool higher = false;
  for (int tries = 0;; ++tries) {
    if (!motion.advance(world, part)) return {};
    const Real kinetic = kinetic_energy(world), energy = kinetic + potential_energy(world);
    if (!higher) plain = energy;
    const bool gains = higher && energy > plain + by_aiming * kinetic;
    const std::vector<Sunk> sunk = sunk_since(motion, world, begin.contacts, part);
    if (!gains && (sunk.empty() || part <= shortest_part || tries >= most_tries)) return part;
    const double work = begin.held.work_left() - motion.contacts.work_left();
    motion.restore(world, begin);
    if (!motion.spend(work)) return {};
    if (gains) tries = most_aimed_tries;
    higher =
        tries < most_aimed_tries && std::all_of(sunk.begin(), sunk.end(), [](const Sunk& at) { return at.known >= 0; });
    Real since = 0;
    for (const Sunk& at : sunk) since = std::max(since, at.since);
    if (higher) {
      for (const Sunk& at : sunk) held.expect_deepening(static_cast<std::size_t>(at.known), at.by);
    } else {
      held = begin.held;
      part = since > 0 && since < part ? part - since : part / 2;
    }
    motion.contacts = held;
  }
}

/// Moves joined bodies until a pair touches, or for `within` s.
ImpactCuts::Length ImpactCuts::move_joined(KickDrift& motion, World& world, Real within) {
  const KickDrift::Snapshot begin = motion.snapshot(world);
  const Length most = try_half_step(motion, world, begin, within);
  std::optional<Real> touch;
  if (!most || !next_touch(motion, world, begin.bodies, *most, touch)) return {};
  Real part = *most;
  if (touch && *touch <= shortest_part && touch_already(begin.contacts)) {
    motion.restore(world, begin);
    std::vector<BodyPair>& held = *motion.contacts.held_pairs;
    held.insert(std::lower_bound(held.begin(), held.end(), *first_), *first_);
    contacts_held_ = true;
    if (!motion.detected_ahead) motion.detect_ahead(world, *most);
    return move_joined(motion, world, within);
  }
  const auto find = [&] {
    if (motion.contacts.held_pairs->empty()) motion.detect_contacts(world, part);
  };
  const auto again = [&](Real t) {
    motion.restore(world, begin);
    part = t;
    motion.contact_free = motion.contacts.held_pairs->empty();
    const bool done = t <= 0 || motion.advance(world, t);
    motion.contact_free = false;
    if (done) find();
    return done;
  };
  if (touch) {
    if (!again(*touch)) return {};
  } else {
    find();
  }
  for (int tries = 0; tries < most_tries; ++tries) {
    const Real off = touch_in(motion, world, begin.contacts, part);
    if (off == 0 || part + off > *most) break;
    if (!again(part + off > 0 ? part + off : part / 2)) return {};
  }
  return part;
}

}  // namespace pushback
