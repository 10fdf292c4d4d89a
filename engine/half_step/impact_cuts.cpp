#include "pushback/engine/half_step/impact_cuts.h"

#include <algorithm>
#include <map>

#include "pushback/common/basics/input.h"
#include "pushback/common/world/measure.h"
#include "pushback/engine/direct/small_contact_problem.h"
#include "pushback/engine/half_step/first_touch.h"
#include "pushback/engine/half_step/gap.h"

namespace pushback {

namespace {

constexpr double of_corners = 150;  // multiplications for each pair of corners, in each round of first_touch
constexpr double of_rows = 10;      // multiplications for the cube of their number, in a small problem
constexpr Real late = Real(0.9);    // of the speed of a pair's last impact: with more, the sequence is given up
constexpr int most_pairs = 1000;    // solved in sequence, before all are at the same time

}  // namespace

/// From forces, and from the loads of contacts where bodies touch.
void ImpactCuts::find_accelerations(const KickDrift& motion, const World& world) {
  accelerations_.clear();
  turning_.clear();
  for (std::size_t i = 0; i < world.bodies.size(); ++i) {
    const KickDrift::Acceleration by = motion.acceleration(world, i);
    accelerations_.push_back(by.linear);
    turning_.push_back(by.angular);
  }
  motion.contacts.add_loads(world, accelerations_);
}

/// m/s^2: how the two are pressed together. The share of joints is not known, so with joints it is taken to be gravity's.
Real ImpactCuts::pressing_acceleration(const World& world, const Contact& at) const {
  if (!world.joints.empty()) return world.gravity.norm();
  return at.normal.dot(accelerations_[at.id.body_a] - accelerations_[at.id.body_b]);
}

bool ImpactCuts::bounce(KickDrift& motion, World& world, Real h, const std::vector<std::size_t>& which) {
  Contacts contacts;
  Rows rows;
  for (const std::size_t i : which) contacts.push_back(world.contacts[i]);
  for (std::size_t k = 0; k < contacts.size(); ++k) rows.emplace_back(world, contacts[k], contacts[k].normal, k);
  for (std::size_t k = 0; k < contacts.size(); ++k) {
    const auto [tangent1, tangent2] = tangents_of(contacts[k].normal);
    rows.emplace_back(world, contacts[k], tangent1, k);
    rows.emplace_back(world, contacts[k], tangent2, k);
  }
  Real rounding = resting_speed;
  for (std::size_t k = 0; k < contacts.size(); ++k) {
    const Real approach = rows[k].speed(), e = contacts[k].restitution;
    rounding = std::max(rounding, -100 * std::numeric_limits<Real>::epsilon() * approach);
    if (approach >= -motion.settings.threshold) continue;
    const Real leaves = -e * approach;
    const bool last = 2 * leaves <= h * (1 - e) * pressing_acceleration(world, contacts[k]);  // T <= h
    if (!last) rows[k].bias = -leaves;
  }
  StepContext step{world, contacts, rows, h};
  const bool solved = world.joints.empty() ? strike_free(motion, step) : motion.solve_impact(world, contacts, rows, h);
  for (std::size_t k = 0; k < contacts.size(); ++k) {
    if (solved && step.speed_error(k) >= -rounding) continue;
    motion.failure = fmt::format("where bodies {} and {} meet, {} m/s are left: impacts need solved contacts",
                                 contacts[k].id.body_a, contacts[k].id.body_b, -step.speed_error(k));
    return false;
  }
  const std::size_t count = which.size();
  for (std::size_t k = 0; k < count; ++k)
    motion.contacts.add_impact(world, which[k],
                               {rows[k].impulse, rows[count + 2 * k].impulse, rows[count + 2 * k + 1].impulse});
  return true;
}

/// In blocks of bodies, or a few contacts from nothing, as chapter 17 does.
bool ImpactCuts::solve_free(KickDrift& motion, StepContext& step) {
  if (step.contacts.size() > SmallContactProblem::most_contacts)
    return motion.solve_impact(step.world, step.contacts, step.rows, step.dt);
  const double left = direct_.work = motion.work_left(), rows = static_cast<double>(step.rows.size());
  const bool solved = direct_.try_start(step);
  return motion.spend(left - direct_.work + of_rows * rows * rows * rows) && solved;
}

/// Newton's rule and friction together may add energy (Kane 1984). Then every target speed is halved, up to three times, and finally set
/// to 0, because without restitution the kinetic energy cannot grow.
bool ImpactCuts::strike_free(KickDrift& motion, StepContext& step) {
  constexpr Real rounding = std::numeric_limits<Real>::digits > 24 ? Real(1e-9) : Real(1e-4);
  const bool rubs =
      std::any_of(step.contacts.begin(), step.contacts.end(), [](const Contact& at) { return at.friction > 0; });
  const Real before = kinetic_energy(step.world);
  const Contacts contacts = step.contacts;
  const std::vector<BodyState> states(step.world.bodies.begin(), step.world.bodies.end());
  Rows& rows = step.rows;
  for (int tries = 1;; ++tries) {
    if (!solve_free(motion, step)) return false;
    const bool leaves = std::any_of(rows.begin(), rows.end(), [](const Row& row) { return row.bias != 0; });
    if (!rubs || !leaves || kinetic_energy(step.world) <= (1 + rounding) * before) return true;
    restore_states(step.world, states);
    step.contacts = contacts;
    for (Row& row : rows) {
      row.impulse = 0;
      row.bias = tries < 4 ? row.bias / 2 : 0;
    }
  }
}

/// Sets `met` if bodies touch and approach.
bool ImpactCuts::impact(KickDrift& motion, World& world, Real h, bool& met) {
  touching_.clear();
  for (std::size_t i = 0; i < world.contacts.size(); ++i)
    if (world.contacts[i].depth > -touch_distance) touching_.push_back(i);
  const auto fastest = [&] {
    return std::min_element(touching_.begin(), touching_.end(), [&](std::size_t p, std::size_t q) {
      return separating_speed(world, world.contacts[p]) < separating_speed(world, world.contacts[q]);
    });
  };
  const auto approaches = [&](const auto& at) {
    return at != touching_.end() && separating_speed(world, world.contacts[*at]) < -resting_speed;
  };
  auto first = fastest();
  met = approaches(first);
  if (!met) return true;
  if (world.joints.empty()) find_accelerations(motion, world);
  dissipated_energy_ += kinetic_energy(world);
  // Without bounces, a heavy body on a light one takes little from the speed of their next impact, and a sequence would take thousands.
  std::map<BodyPair, Real> last;  // m/s
  const auto bounces = [&](std::size_t i) {
    const Contact& at = world.contacts[i];
    return at.restitution > 0 && separating_speed(world, at) < -motion.settings.threshold;
  };
  const auto ends_late = [&](const Contact& at) {
    const Real speed = separating_speed(world, at);
    const auto [before, is_new] = last.try_emplace(pair_of(at), speed);
    const bool hardly_slower = !is_new && speed < late * before->second;
    before->second = speed;
    return hardly_slower && std::none_of(touching_.begin(), touching_.end(), bounces);
  };
  for (int round = 0; impacts == Impacts::sequential && round < most_pairs && approaches(first); ++round) {
    if (ends_late(world.contacts[*first])) break;
    const BodyPair pair = pair_of(world.contacts[*first]);
    of_pair_.clear();
    for (const std::size_t i : touching_)
      if (pair_of(world.contacts[i]) == pair) of_pair_.push_back(i);
    if (!bounce(motion, world, h, of_pair_)) return false;
    first = fastest();
  }
  if (approaches(first) && !bounce(motion, world, h, touching_)) return false;
  dissipated_energy_ -= kinetic_energy(world);
  motion.contacts.store_approach(world);
  return true;
}

/// Holds pairs that touch and do not separate, and pairs that overlap. With joints it also holds pairs that separate as slowly as the last
/// of infinitely many bounces, because no impact may have stopped them.
void ImpactCuts::hold_touching(KickDrift& motion, World& world, Real h) {
  auto& held_pairs = motion.contacts.held_pairs;
  if (!held_pairs) held_pairs.emplace();
  held_pairs->clear();
  for (const Contact& at : world.contacts) {
    const BodyPair pair = pair_of(at);
    if (!held_pairs->empty() && held_pairs->back() == pair) continue;
    const Real last = world.joints.empty() ? 0 : h * (1 - at.restitution) * pressing_acceleration(world, at) / 2;
    if (at.depth > touch_distance ||
        (at.depth > -touch_distance && separating_speed(world, at) <= std::max(resting_speed, last)))
      held_pairs->push_back(pair);
  }
  contacts_held_ |= !held_pairs->empty();
  if (!held_pairs->empty() && !motion.detected_ahead) motion.detect_ahead(world, h);
}

/// `touch`: the first time within `within` s at which a pair that is not held touches, from where `bodies` are: the world's bodies, now or
/// before. Accelerations have been found.
bool ImpactCuts::next_touch(KickDrift& motion, const World& world, const std::vector<Body>& bodies, Real within,
                            std::optional<Real>& touch) {
  Real turns = 0, strongest = 0;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const Body& body = bodies[i];
    strongest = std::max(strongest, accelerations_[i].squaredNorm());
    if (body.angular_velocity.isZero(0) && turning_[i].isZero(0)) continue;
    turns = std::max(turns, 2 * reach_of_core(body));
  }
  const Margin margin{.least = touch_distance + turns + within * within / 2 * std::sqrt(strongest), .ahead = within};
  touch.reset();
  first_.reset();
  std::vector<BodyPair>& near = motion.near_pairs;
  near = near_pairs(bodies, margin);
  const JoinedPairs joined(world.joints);
  std::erase_if(near, [&](const BodyPair& pair) {
    const auto [p, q] = pair;
    return !may_touch(bodies[static_cast<std::size_t>(p)], bodies[static_cast<std::size_t>(q)]) || joined.contain(p, q);
  });
  const std::vector<BodyPair>& held = *motion.contacts.held_pairs;
  for (const BodyPair& pair : near) {
    if (std::binary_search(held.begin(), held.end(), pair)) continue;
    const auto p = static_cast<std::size_t>(pair.first), q = static_cast<std::size_t>(pair.second);
    const Body &a = bodies[p], &b = bodies[q];
    const Real before = touch.value_or(within);
    const auto corners = static_cast<double>(corners_of_core(a).size() * corners_of_core(b).size());
    Flight of_a(a, accelerations_[p], turning_[p], before);
    Flight of_b(b, accelerations_[q], turning_[q], before);
    if (const std::optional<Real> met = first_touch(of_a, of_b, before, touch_distance / 2)) touch = met, first_ = pair;
    if (!motion.spend(of_corners * (1 + corners) * of_a.looks())) return false;
  }
  return true;
}

bool ImpactCuts::advance(KickDrift& motion, World& world, Real h) {
  Real left = h;
  for (int cuts = 0; left > 0; ++cuts) {
    bool met = false;
    if (!impact(motion, world, h, met)) return false;
    if (met) ++events_;
    if (cuts == most_events) {
      bound_reached_ = contacts_held_ = true;
      motion.contacts.held_pairs.reset();
      motion.detect_ahead(world, h);
      while (left > 0) {
        const Length part = move_free(motion, world, left);
        if (!part) return false;
        left -= *part;
      }
      return true;
    }
    hold_touching(motion, world, h);
    Length part = 0;
    if (!world.joints.empty()) {
      part = move_joined(motion, world, left);
    } else {
      find_accelerations(motion, world);
      std::optional<Real> touch;
      if (!next_touch(motion, world, world.bodies, left, touch)) return false;
      if (touch.value_or(left) > 0) part = move_free(motion, world, touch.value_or(left));
    }
    if (!part) return false;
    left -= *part;
  }
  return true;
}

}  // namespace pushback
