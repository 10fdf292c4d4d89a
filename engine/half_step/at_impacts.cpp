#include "pushback/engine/half_step/at_impacts.h"

#include <algorithm>

#include "pushback/common/basics/input.h"
#include "pushback/common/collision/collide.h"
#include "pushback/common/world/measure.h"
#include "pushback/engine/half_step/first_touch.h"
#include "pushback/engine/half_step/gap.h"

namespace pushback {

namespace {

constexpr Real touches = HeldContacts::touches;
constexpr Real stands = std::numeric_limits<Real>::digits > 24 ? Real(1e-6) : Real(1e-3);  // m/s: slower is no impact
constexpr int most_tries = 50;          // to end a part of a step where something touches
constexpr int most_bends = 3;           // of these, the first: with what the drift has turned in
constexpr Real by_aiming = Real(1e-3);  // of T: so much more may a drift leave that is aimed higher
constexpr Real brief = Real(1e-7);      // s
constexpr double of_look = 500;         // multiplications for each pair of corners: some ten rounds of first_touch
constexpr int most_pairs = 1000;        // solved in sequence, before all are at the same time

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
  taken_ = 0;
  bound_reached_ = held_ = false;
  HalfStep::solve(world, h, sweeps);
}

/// By forces, and by what is borne where bodies touch.
void AtImpacts::accelerate_bodies(const World& world) {
  accelerations_.clear();
  turning_.clear();
  for (std::size_t i = 0; i < world.bodies.size(); ++i) {
    const Acceleration by = acceleration(world, i);
    accelerations_.push_back(by.linear);
    turning_.push_back(by.angular);
  }
  contacts_.add_borne(world, accelerations_);
}

/// Where joints hold, by a half step, of which the world is left at the end. It is of `within`, or shorter where that has to be divided.
Real AtImpacts::try_step(World& world, const Moment& begin, Real within) {
  for (;; within /= 2) {
    const int before = halvings();
    alone_ = contacts_.only->empty();  // joints by themselves are a linear system
    HalfStep::advance(world, within);
    alone_ = false;
    if (halvings() == before) break;
    back_to(world, begin);
  }
  accelerations_.clear();
  turning_.clear();
  for (std::size_t i = 0; i < world.bodies.size(); ++i) {
    accelerations_.push_back(2 / within * (before_[i].velocity - begin.bodies[i].velocity));
    turning_.push_back(2 / within * (before_[i].angular_velocity - begin.bodies[i].angular_velocity));
  }
  return within;
}

/// a: how the two are pressed together. By joints, nobody has said: as gravity would.
Real AtImpacts::pressing(const World& world, const Contact& at) const {
  if (!world.joints.empty()) return world.gravity.norm();
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
    const bool last = 2 * leaves <= h * (1 - e) * pressing(world, contacts[k]);  // T <= h
    if (!last) rows[k].bias = -leaves;
  }
  direct_.work = exact_direct_contacts().work;
  StepContext step{world, contacts, rows, h};
  bool solved = true;
  if (!world.joints.empty()) solved = strike(world, contacts, rows, h);
  else strike_free(step);
  for (std::size_t k = 0; k < contacts.size(); ++k)
    if (!solved || !(step.speed_error(k) >= -rounding))
      throw InvalidInput(fmt::format("where bodies {} and {} meet, {} m/s are left: impacts need solved contacts",
                                     contacts[k].id.body_a, contacts[k].id.body_b, -step.speed_error(k)));
  const std::size_t count = which.size();
  for (std::size_t k = 0; k < count; ++k)
    contacts_.add(world, which[k], {rows[k].impulse, rows[count + 2 * k].impulse, rows[count + 2 * k + 1].impulse});
}

/// Newton's rule and friction together may add energy (Kane 1984). Then every target speed is halved, up to three times, and set to 0 at
/// last: without restitution the kinetic energy cannot grow.
void AtImpacts::strike_free(StepContext& step) {
  constexpr Real rounding = std::numeric_limits<Real>::digits > 24 ? Real(1e-9) : Real(1e-4);
  const bool rubs =
      std::any_of(step.contacts.begin(), step.contacts.end(), [](const Contact& at) { return at.friction > 0; });
  const Real before = kinetic_energy(step.world);
  const Contacts contacts = step.contacts;
  const std::vector<State> states(step.world.bodies.begin(), step.world.bodies.end());
  Rows& rows = step.rows;
  for (int tries = 1;; ++tries) {
    direct_.start(step);
    const bool leaves = std::any_of(rows.begin(), rows.end(), [](const Row& row) { return row.bias != 0; });
    if (!rubs || !leaves || kinetic_energy(step.world) <= (1 + rounding) * before) return;
    for (std::size_t i = 0; i < states.size(); ++i) states[i].give(step.world.bodies[i]);
    step.contacts = contacts;
    for (Row& row : rows) {
      row.impulse = 0;
      row.bias = tries < 4 ? row.bias / 2 : 0;
    }
  }
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
  if (world.joints.empty()) accelerate_bodies(world);
  taken_ += kinetic_energy(world);
  for (int round = 0; impacts == Impacts::sequential && round < most_pairs && approaches(first); ++round) {
    const BodyPair pair = pair_of(world.contacts[*first]);
    of_pair_.clear();
    for (const std::size_t i : touching_)
      if (pair_of(world.contacts[i]) == pair) of_pair_.push_back(i);
    bounce(world, h, of_pair_);
    first = fastest();
  }
  if (approaches(first)) bounce(world, h, touching_);
  taken_ -= kinetic_energy(world);
  contacts_.look(world);
  return true;
}

/// Pairs that touch and do not leave; and those that overlap. With joints, those are held as well that leave as slowly as the last of
/// infinitely many bounces: no impact may have stopped them.
void AtImpacts::hold_touching(World& world, Real h) {
  if (!contacts_.only) contacts_.only.emplace();
  contacts_.only->clear();
  for (const Contact& at : world.contacts) {
    const BodyPair pair = pair_of(at);
    if (!contacts_.only->empty() && contacts_.only->back() == pair) continue;
    const Real last = world.joints.empty() ? 0 : h * (1 - at.restitution) * pressing(world, at) / 2;
    if (at.depth > touches || (at.depth > -touches && separating_speed(world, at) <= std::max(stands, last)))
      contacts_.only->push_back(pair);
  }
  held_ |= !contacts_.only->empty();
  if (!contacts_.only->empty() && !ahead_) look_ahead(world, h);
}

void AtImpacts::begin_contacts(World& world, Real /*h*/) {
  alone_ = false;
  ahead_ = false;
  contacts_.begin(world);
}

/// Of pairs that are held, each point that may touch next has to be known. Where none is, all have flown, and who may have met is known.
void AtImpacts::detect_contacts(World& world, Real h) {
  ahead_ = !contacts_.only || !contacts_.only->empty();
  if (ahead_) return HalfStep::detect_contacts(world, h);
  world.contacts.clear();
  for (const auto& [first, second] : near_) {
    collide(world.body(first), world.body(second), world.contacts, {.least = touches});
  }
  contacts_.detected(world);
}

void AtImpacts::look_ahead(World& world, Real h) {
  ahead_ = true;
  HalfStep::detect_contacts(world, h);
  contacts_.look(world);
}

/// From where these bodies are, which are the world's now or were before.
std::optional<Real> AtImpacts::next_touch(const World& world, const std::vector<Body>& bodies, Real within) {
  Real turns = 0, strongest = 0;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const Body& body = bodies[i];
    strongest = std::max(strongest, accelerations_[i].squaredNorm());
    if (body.angular_velocity.isZero(0) && turning_[i].isZero(0)) continue;
    turns = std::max(turns, 2 * reach_of_core(body));
  }
  const Margin margin{.least = touches + turns + within * within / 2 * std::sqrt(strongest), .ahead = within};
  std::optional<Real> first;
  first_.reset();
  near_ = near_pairs(bodies, margin);
  const JoinedPairs joined(world.joints);
  std::erase_if(near_, [&](const BodyPair& pair) {
    const auto [p, q] = pair;
    return !may_touch(bodies[static_cast<std::size_t>(p)], bodies[static_cast<std::size_t>(q)]) || joined.contain(p, q);
  });
  for (const BodyPair& pair : near_) {
    const auto p = static_cast<std::size_t>(pair.first), q = static_cast<std::size_t>(pair.second);
    const Body &a = bodies[p], &b = bodies[q];
    if (std::binary_search(contacts_.only->begin(), contacts_.only->end(), pair)) continue;
    const Real before = first.value_or(within);
    const auto corners = static_cast<double>(corners_of_core(a).size() * corners_of_core(b).size());
    spend(of_look * (1 + corners));
    Flight of_a(a, accelerations_[p], turning_[p], before);
    Flight of_b(b, accelerations_[q], turning_[q], before);
    if (const std::optional<Real> touch = first_touch(of_a, of_b, before, touches / 2)) first = touch, first_ = pair;
  }
  return first;
}

/// Held contacts that a drift of h s has let in by more than `sinks` and deeper than their pair was in `begun`, World::contacts before the
/// drift. A turn moves a point off its straight path by at most h^2/2 w^2 r.
std::vector<AtImpacts::Sunk> AtImpacts::sunk_since(const World& world, const Contacts& begun, Real h) const {
  std::vector<Sunk> sunk;
  auto old = begun.begin();  // both lists ascend: walk them side by side
  for (const Contact& at : world.contacts) {
    if (at.depth <= sinks || !contacts_.holds(at.id)) continue;
    while (old != begun.end() && pair_of(*old) < pair_of(at)) ++old;
    Real depth = 0;  // of the pair before
    auto same = begun.end();
    for (auto i = old; i != begun.end() && pair_of(*i) == pair_of(at); ++i) {
      depth = std::max(depth, i->depth);
      if (i->id == at.id) same = i;
    }
    if (at.depth <= depth + sinks / 100) continue;
    Vec3 speed = Vec3::Zero();
    Real bend = 0;
    for (const auto& [body, sign] : {std::pair(at.id.body_a, 1), std::pair(at.id.body_b, -1)}) {
      const Vec3 arm = at.point - world.bodies[body].position;
      speed += sign * (before_[body].velocity + before_[body].angular_velocity.cross(arm));
      bend += h * h / 2 * before_[body].angular_velocity.squaredNorm() * arm.norm();
    }
    const Real approach = at.normal.dot(speed);
    sunk.push_back({.since = approach > 0 ? at.depth / approach : std::numeric_limits<Real>::infinity()});
    if (same != begun.end() && same->depth > -touches) {
      sunk.back().by = at.depth - std::max(same->depth, Real(0));
      if (sunk.back().by <= 8 * bend) sunk.back().known = same - begun.begin();
    }
  }
  return sunk;
}

/// s: how long ago those of World::contacts that are not held have touched that overlap, below 0. Where none do, when those touch that
/// were to. 0: now, or nobody knows.
Real AtImpacts::touch_in(const World& world, const Contacts& begun, Real h) const {
  Real longest = 0;
  for (const Sunk& sunk : sunk_since(world, begun, h)) longest = std::max(longest, sunk.since);
  for (const Contact& at : world.contacts) {
    if (at.depth <= touches) continue;
    if (contacts_.holds(at.id)) continue;
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
  return nearest.depth < -touches && approach > stands ? -nearest.depth / approach : 0;
}

/// Whether those that touch first touch already: as they turn, a corner comes as another one leaves.
bool AtImpacts::touch_already(const Contacts& contacts) const {
  return std::any_of(contacts.begin(), contacts.end(),
                     [this](const Contact& at) { return pair_of(at) == *first_ && at.depth > -touches; });
}

/// Drifts for at most `within` s, in which no other pair touches. Ends earlier if a held contact sinks in. Returns the time, s.
Real AtImpacts::move_free(World& world, Real within) {
  if (contacts_.only && contacts_.only->empty()) {
    HalfStep::advance(world, within);
    return within;
  }
  const Moment begin = moment(world);
  HeldContacts held = begin.held;  // with what is known of the drift
  Real part = within, plain = 0;   // J: after a drift that is not aimed higher
  bool higher = false;
  for (int tries = 0;; ++tries) {
    HalfStep::advance(world, part);
    const Real motion = kinetic_energy(world), energy = motion + potential_energy(world);
    if (!higher) plain = energy;
    const bool gains = higher && energy > plain + by_aiming * motion;
    const std::vector<Sunk> sunk = sunk_since(world, begin.contacts, part);
    if (!gains && (sunk.empty() || part <= brief || tries >= most_tries)) return part;
    const double work = begin.held.work_left() - contacts_.work_left();
    back_to(world, begin);
    spend(work);
    if (gains) tries = most_bends;
    higher = tries < most_bends && std::all_of(sunk.begin(), sunk.end(), [](const Sunk& at) { return at.known >= 0; });
    Real since = 0;
    for (const Sunk& at : sunk) since = std::max(since, at.since);
    if (higher) {
      for (const Sunk& at : sunk) held.bends(static_cast<std::size_t>(at.known), at.by);
    } else {
      held = begin.held;
      part = since > 0 && since < part ? part - since : part / 2;
    }
    contacts_ = held;
  }
}

/// Until somebody touches, or for `within` s. Returns how long it took.
Real AtImpacts::move_joined(World& world, Real within) {
  const Moment begin = moment(world);
  const Real most = try_step(world, begin, within);
  Real part = most;
  const std::optional<Real> touch = next_touch(world, begin.bodies, most);
  if (touch && *touch <= brief && touch_already(begin.contacts)) {
    back_to(world, begin);
    contacts_.only->insert(std::lower_bound(contacts_.only->begin(), contacts_.only->end(), *first_), *first_);
    held_ = true;
    if (!ahead_) look_ahead(world, most);
    return move_joined(world, within);
  }
  const auto find = [&] {
    if (contacts_.only->empty()) detect_contacts(world, part);
  };
  const auto again = [&](Real t) {
    back_to(world, begin);
    part = t;
    alone_ = contacts_.only->empty();
    if (t > 0) HalfStep::advance(world, t);
    alone_ = false;
    find();
  };
  if (touch) again(*touch);
  else find();
  for (int tries = 0; tries < most_tries; ++tries) {
    const Real off = touch_in(world, begin.contacts, part);
    if (off == 0 || part + off > most) break;
    again(part + off > 0 ? part + off : part / 2);
  }
  return part;
}

void AtImpacts::advance(World& world, Real h) {
  Real left = h;
  for (int cuts = 0; left > 0; ++cuts) {
    if (impact(world, h)) ++events_;
    if (cuts == most_events) {
      bound_reached_ = held_ = true;
      contacts_.only.reset();
      look_ahead(world, h);
      while (left > 0) left -= move_free(world, left);
      return;
    }
    hold_touching(world, h);
    if (!world.joints.empty()) {
      left -= move_joined(world, left);
      continue;
    }
    accelerate_bodies(world);
    const Real part = next_touch(world, world.bodies, left).value_or(left);
    left -= part > 0 ? move_free(world, part) : 0;
  }
}

}  // namespace pushback
