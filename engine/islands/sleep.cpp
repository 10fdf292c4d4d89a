#include "pushback/engine/islands/sleep.h"

#include <algorithm>

#include "pushback/common/basics/input.h"
#include "pushback/common/collision/collide.h"

namespace pushback {

namespace {

void insert_ascending(std::vector<int>& into, const std::vector<int>& bodies) {
  const auto middle = into.insert(into.end(), bodies.begin(), bodies.end());
  std::inplace_merge(into.begin(), middle, into.end());
}

bool moves(const Body& body) {
  return !body.velocity.isZero(0) || !body.angular_velocity.isZero(0);
}

/// m, from the centre of mass. No point of the shape is farther away.
Real reach_of(Body body) {
  body.orientation.setIdentity();
  const Bounds bounds = bounds_of(body);
  return (bounds.high - body.position).cwiseMax(body.position - bounds.low).norm();
}

/// Whether a body held by it cannot rest, because it sets a motion, or is fixed to a moving body.
bool moves(const Joint& joint, const World& world) {
  const auto carried_by = [&world](int i) { return !body_of(world, i).movable() && moves(body_of(world, i)); };
  return joint.driven || carried_by(joint.a) || carried_by(joint.b);
}

bool acts_on_all(const Force& force) {
  return force.bodies.empty();
}

}  // namespace

// ---- who is awake ------------------------------------------------------------------------------------------------------

void Sleep::check(World& world) {
  require_not_negative("time to fall asleep", time_to_sleep);
  require_not_negative("place of a sleeper", rest_distance);
  if (world.bodies.size() < rest_.size())
    throw InvalidInput("a world with sleepers has lost a body: World::remove takes bodies out");
  check_places(world);
  for (std::size_t i = rest_.size(); i < world.bodies.size(); ++i) {
    const Body& body = world.bodies[i];
    const bool plane = std::holds_alternative<HalfSpace>(body.shape);
    (body.movable() ? awake_ : plane ? planes_ : fixed_).push_back(int(i));
    Rest& its = rest_.emplace_back();
    its.reach = plane ? 0 : reach_of(body);
    if (!body.movable()) its.position = body.position, its.orientation = body.orientation;
    tree_is_current_ = tree_is_current_ && (body.movable() || plane);
  }
  const auto driven = [&world](int i) { return moves(world.bodies[std::size_t(i)]); };
  driven_before_.swap(driven_);
  driven_.clear();
  std::copy_if(fixed_.begin(), fixed_.end(), std::back_inserter(driven_), driven);
  if (driven_ != driven_before_) tree_is_current_ = false;
  for (const auto* which : {&awake_, &driven_, &planes_}) {
    for (const int i : *which) check_state(world.bodies[std::size_t(i)]);
  }
  wake_changed_by_hand(world);
  for (const int i : awake_)
    world.bodies[std::size_t(i)].refresh_inertia();  // its orientation may have been set by hand

  const bool plane_moves = std::any_of(planes_.begin(), planes_.end(), driven);
  all_stay_awake_ = plane_moves || std::any_of(world.forces.begin(), world.forces.end(), acts_on_all);
  const bool other_pulls = world.gravity != gravity_ || world.forces.size() != forces_;
  if (all_stay_awake_ || other_pulls || world.joints.size() != joints_) wake_all(world);
  gravity_ = world.gravity;
  forces_ = world.forces.size();
  joints_ = world.joints.size();
}

/// Finds changes by the caller, since the latest step, of bodies that do not take part.
void Sleep::wake_changed_by_hand(World& world) {
  for (std::size_t i = 0; i < rest_.size(); ++i) {
    const Body& body = world.bodies[i];
    Rest& its = rest_[i];
    if (body.removed) {
      if (!its.removed) forget_removed(world, int(i));
      continue;
    }
    if (!body.asleep && body.movable()) continue;
    const bool elsewhere = body.position != its.position || body.orientation.coeffs() != its.orientation.coeffs();
    if (body.asleep) {
      const bool pushed = moves(body) || !body.force.isZero(0) || !body.torque.isZero(0);
      if (elsewhere || pushed) wake_island(world, its.island);
    } else if (elsewhere) {
      const bool by_its_velocity = std::binary_search(driven_before_.begin(), driven_before_.end(), int(i));
      if (!by_its_velocity) wake(world, int(i));
      its.position = body.position, its.orientation = body.orientation;
    }
  }
}

/// A body that has been removed. What touched it wakes.
void Sleep::forget_removed(World& world, int body) {
  wake(world, body);
  for (std::vector<int>* some : {&awake_, &planes_, &fixed_, &driven_, &driven_before_}) std::erase(*some, body);
  std::erase_if(woken_, [id = std::uint32_t(body)](const Contact& contact) {
    return contact.id.body_a == id || contact.id.body_b == id;
  });
  rest(body).removed = true;
}

void Sleep::wake_by_forces(World& world) {
  for (const Force& force : world.forces) {
    for (const int i : force.bodies) {
      const Body& body = world.bodies[std::size_t(i)];
      if (!body.asleep) continue;
      Rest& its = rest(i);
      const std::pair pull(body.force, body.torque);
      if (!its.pull) its.pull = pull;
      if (*its.pull != pull) wake_island(world, its.island);
    }
  }
}

void Sleep::wake_by_joints(World& world) {
  for (const Joint& joint : world.joints) {
    if (!moves(joint, world)) continue;
    for (const int i : {joint.a, joint.b}) {
      if (body_of(world, i).asleep) wake_island(world, rest(i).island);
    }
  }
}

void Sleep::find_contacts(World& world, const Margin& margin) {
  wake_by_forces(world);
  wake_by_joints(world);
  while (wake_touched(world, margin)) continue;  // who wakes may touch others
  for (const Force& force : world.forces) {
    for (const int i : force.bodies) {
      Body& body = world.bodies[std::size_t(i)];
      if (body.asleep) body.force.setZero(), body.torque.setZero();  // it held the body, and will do so again
    }
  }
  if (woken_.empty()) return;
  Contacts& before = world.contacts_before;
  before.insert(before.end(), woken_.begin(), woken_.end());
  std::sort(before.begin(), before.end(), [](const Contact& p, const Contact& q) { return p.id < q.id; });
  woken_.clear();
}

/// Finds the contacts. Returns whether it woke a body, so that some contacts are still missing.
bool Sleep::wake_touched(World& world, const Margin& margin) {
  if (!tree_is_current_) build_tree(world);
  std::sort(awake_.begin(), awake_.end());  // those that have just woken are last
  simulated_ = awake_;
  insert_ascending(simulated_, driven_);
  std::vector<int> swept = simulated_;
  insert_ascending(swept, planes_);
  std::vector<BodyPair> pairs = near_pairs(world.bodies, swept, margin);
  std::vector<int> near;
  for (const int i : simulated_) {
    near.clear();
    still_.near(bounds_of(world.bodies[std::size_t(i)], margin), near);
    for (const int j : near) pairs.push_back(std::minmax(i, j));
  }
  std::sort(pairs.begin(), pairs.end());
  world.contacts.clear();
  const JoinedPairs joined(world.joints);
  for (const auto& [first, second] : pairs) {
    const Body &a = world.bodies[std::size_t(first)], &b = world.bodies[std::size_t(second)];
    if (may_touch(a, b) && !joined.contain(first, second)) collide(a, b, world.contacts, margin);
  }
  for (const int i : planes_) {  // moved like the driven ones; bodies that they touch are awake already
    if (moves(world.bodies[std::size_t(i)])) insert_ascending(simulated_, {i});
  }
  bool somebody = false;
  for (const Contact& contact : world.contacts) {
    const auto [a, b] = world.bodies_of(contact);
    for (const Body* body : {&a, &b}) {
      if (!body->asleep) continue;
      wake_island(world, rest(body->index).island);
      somebody = true;
    }
  }
  return somebody;
}

/// The tree of still bodies is rebuilt only after a body has fallen asleep or woken.
void Sleep::build_tree(const World& world) {
  std::vector<int> still;
  for (const Island& island : islands_) still.insert(still.end(), island.bodies.begin(), island.bodies.end());
  std::set_difference(fixed_.begin(), fixed_.end(), driven_.begin(), driven_.end(), std::back_inserter(still));
  still_ = StillBodies(world.bodies, still);
  tree_is_current_ = true;
}

// ---- waking ------------------------------------------------------------------------------------------------------------

void Sleep::wake_island(World& world, int island) {
  Island& woken = islands_[std::size_t(island)];
  for (const int i : woken.bodies) check_state(world.bodies[std::size_t(i)]);
  for (const int i : woken.bodies) {
    world.bodies[std::size_t(i)].asleep = false;
    rest(i) = {.reach = rest(i).reach};
  }
  awake_.insert(awake_.end(), woken.bodies.begin(), woken.bodies.end());
  woken_.insert(woken_.end(), woken.contacts.begin(), woken.contacts.end());
  woken = {};
  tree_is_current_ = false;
}

void Sleep::wake(World& world, int body) {
  if (body < 0 || std::size_t(body) >= world.bodies.size()) {
    throw InvalidInput(
        fmt::format("body to wake is {}: a whole number from 0 to {} is needed", body, world.bodies.size() - 1));
  }
  if (std::size_t(body) >= rest_.size()) return;  // new since the latest step: awake
  const auto id = static_cast<std::uint32_t>(body);
  for (const Joint& joint : world.joints) {
    check_bodies_of(joint, world);
    for (const auto& [one, other] : {std::pair(joint.a, joint.b), std::pair(joint.b, joint.a)}) {
      if (one == body && body_of(world, other).asleep) wake_island(world, rest(other).island);
    }
  }
  for (std::size_t i = 0; i < islands_.size(); ++i) {
    const Island& island = islands_[i];
    const bool touched = std::any_of(island.contacts.begin(), island.contacts.end(), [id](const Contact& contact) {
      return contact.id.body_a == id || contact.id.body_b == id;
    });
    if (touched || std::binary_search(island.bodies.begin(), island.bodies.end(), body)) wake_island(world, int(i));
  }
  rest(body).seconds = 0;
  tree_is_current_ = false;  // it may lie somewhere else now
}

void Sleep::wake_all(World& world) {
  for (std::size_t i = 0; i < islands_.size(); ++i) wake_island(world, int(i));
}

// ---- falling asleep ----------------------------------------------------------------------------------------------------

void Sleep::end(World& world, Real dt) {
  // Over a time in which nothing gets farther than `rest_distance`.   |x - x_0| + reach |angle between q_0 and q| <= rest_distance
  for (const int i : awake_) {
    const Body& body = world.bodies[std::size_t(i)];
    Rest& its = rest(i);
    const Real turned = 2 * (its.orientation.conjugate() * body.orientation).vec().norm();
    const bool kept = (body.position - its.position).norm() + its.reach * turned <= rest_distance;
    if (!kept) its.position = body.position, its.orientation = body.orientation;
    its.seconds = kept ? its.seconds + dt : 0;
  }
  if (all_stay_awake_) return;

  touching_.separate(awake_, world.bodies.size());
  touching_.join(world.contacts, world);
  touching_.join(world.joints, world);
  for (const Force& force : world.forces) {
    int other = -1;
    for (const int i : force.bodies) {
      if (!world.bodies[std::size_t(i)].movable()) continue;
      if (other >= 0) touching_.join(other, i);
      other = i;
    }
  }
  for (const Contact& contact : world.contacts) {  // its support may carry it away
    const auto [a, b] = world.bodies_of(contact);
    if (!a.movable() && moves(a)) rest(b.index).seconds = 0;
    if (!b.movable() && moves(b)) rest(a.index).seconds = 0;
  }
  for (const Joint& joint : world.joints) {
    if (!moves(joint, world)) continue;
    for (const int i : {joint.a, joint.b}) {
      if (body_of(world, i).movable()) rest(i).seconds = 0;
    }
  }
  std::map<int, std::vector<int>> islands;
  std::vector<int> restless;
  for (const int i : awake_) {
    const int island = touching_.island_of(i);
    islands[island].push_back(i);
    if (rest(i).seconds < time_to_sleep) restless.push_back(island);
  }
  for (const int island : restless) islands.erase(island);
  if (!islands.empty()) put_to_sleep(world, islands);
}

/// All at once. With a pass over bodies and contacts for each island, n islands that fall asleep in one step would take n^2 time.
void Sleep::put_to_sleep(World& world, const std::map<int, std::vector<int>>& islands) {
  std::size_t empty = 0;
  for (const auto& [lowest, bodies] : islands) {
    while (empty < islands_.size() && !islands_[empty].bodies.empty()) ++empty;
    if (empty == islands_.size()) islands_.emplace_back();
    islands_[empty].bodies = bodies;
    for (const int i : bodies) {
      Body& body = world.bodies[std::size_t(i)];
      body.velocity.setZero();
      body.angular_velocity.setZero();
      body.asleep = true;
      rest(i).island = int(empty);
      rest(i).position = body.position, rest(i).orientation = body.orientation;
    }
  }
  for (const Contact& contact : world.contacts) {  // a body that slept before touches nothing: else it would be awake
    const int island = std::max(rest(int(contact.id.body_a)).island, rest(int(contact.id.body_b)).island);
    if (island < 0) continue;
    Contacts& contacts = islands_[std::size_t(island)].contacts;
    contacts.push_back(contact);
    contacts.back().impulse = contact.last_impulse;  // their initial impulses when they wake
  }
  std::erase_if(awake_, [this](int i) { return rest(i).island >= 0; });
  tree_is_current_ = false;
}

std::vector<std::vector<int>> Sleep::asleep() const {
  std::vector<std::vector<int>> all;
  for (const Island& island : islands_) {
    if (!island.bodies.empty()) all.push_back(island.bodies);
  }
  return all;
}

}  // namespace pushback
