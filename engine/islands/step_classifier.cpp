#include "pushback/engine/islands/step_classifier.h"

#include <algorithm>
#include <cmath>

#include "pushback/engine/direct/joint_graph.h"
#include "pushback/engine/half_step/gap.h"
#include "pushback/engine/islands/step_contacts.h"

namespace pushback {

namespace {

constexpr Real along = Real(1e-6);            // of a belt's speed, at right angles to the face: rounding
constexpr Real apart = Real(1e-6);            // m: a nearer pair touches already
constexpr Real nearly_touching = Real(1e-3);  // m: such a pair stands on each other, if the pile shakes

/// Each equation of the joint holds, rigidly and in both directions.
bool rigid(const World& world, const Joint& joint, Equations& equations) {
  equations.clear();
  joint.ask(world.body(joint.a), world.body(joint.b), {world.time, 0}, equations);
  return std::all_of(equations.begin(), equations.end(), [](const Equation& equation) {
    return equation.softness == 0 && std::isinf(equation.lo) && std::isinf(equation.hi);
  });
}

/// Whether the ground turns, or its surface moves other than straight along its face. Half steps can move bodies on a belt that only rubs
/// and on a lift that does not turn.
bool turns_or_pushes(const Body& ground, const Contact& at) {
  if (ground.velocity == Vec3::Zero() && ground.angular_velocity == Vec3::Zero()) return false;
  if (ground.angular_velocity != Vec3::Zero()) return true;
  return ground.conveys && std::abs(ground.velocity.dot(at.normal)) > along * ground.velocity.norm();
}

/// The corner of a body that may get farthest along a direction n within dt. A turn moves a corner at r from the body's position by at
/// most  dt n . (w x r) + dt^2/2 w^2 |r|  along n, and it gets no faster than  n . (w x r) + dt w^2 |r|.
struct Corner {
  Real at;     // m, along it, from the world's origin
  Real speed;  // m/s, as the body turns: at the end of dt, at most
  Real way;    // m, in dt
};
Corner first_to_get(const Body& body, const Vec3& direction, Real dt) {
  const Quat to_body = body.orientation.conjugate();
  const Vec3& w = body.angular_velocity;
  const Vec3 n = to_body * direction, turning = body.movable() ? to_body * direction.cross(w) : Vec3::Zero();
  const Real centre = direction.dot(body.position);
  Corner first{.at = -std::numeric_limits<Real>::infinity(), .speed = 0, .way = 0};
  for (const Vec3& r : corners_of_core(body)) {
    const Real speed = turning.dot(r), bends = dt * w.squaredNorm() * r.norm();
    const Corner corner{centre + n.dot(r), speed + bends, dt * (speed + bends / 2)};
    if (corner.at + corner.way > first.at + first.way) first = corner;
  }
  return first;
}

/// How many bodies each body stands above the ground, itself included, on the shortest way through contacts. 0: on none.
std::vector<int> layers_of(const World& world, const Contacts& contacts) {
  std::vector<std::pair<int, int>> above;  // of each pair that touches, both ways
  std::vector<int> layers(world.bodies.size(), 0), next;
  each_pair(contacts, [&](PairContacts between) {
    const auto touches = [](const Contact& at) { return -at.depth <= nearly_touching; };
    if (std::none_of(between.begin(), between.end(), touches)) return;
    const auto [a, b] = world.bodies_of(between.front());
    if (a.movable() && b.movable()) above.insert(above.end(), {{a.index, b.index}, {b.index, a.index}});
    else if (int& layer = layers[std::size_t((a.movable() ? a : b).index)]; layer == 0)
      layer = 1, next.push_back((a.movable() ? a : b).index);
  });
  std::sort(above.begin(), above.end());
  for (std::size_t i = 0; i < next.size(); ++i) {
    const int body = next[i];
    for (auto at = std::lower_bound(above.begin(), above.end(), std::pair(body, 0));
         at != above.end() && at->first == body; ++at)
      if (int& layer = layers[std::size_t(at->second)]; layer == 0)
        layer = layers[std::size_t(body)] + 1, next.push_back(at->second);
  }
  return layers;
}

/// No corner gets faster than this in dt, whatever the direction, m/s.
Real fastest_corner(const Body& body, Real dt) {
  const Real spin = body.movable() ? body.angular_velocity.norm() : 0;
  return spin * (1 + dt * spin) * reach_of_core(body);
}

/// Along a direction in which bodies are apart: whether a corner of one that turns may arrive within dt, faster than `threshold`, m/s.
bool corners_arrive(const Body& a, const Body& b, const Vec3& normal, Real dt, Real threshold, Real falls) {
  const auto turns = [](const Body& body) { return body.movable() && !body.angular_velocity.isZero(0); };
  if (!turns(a) && !turns(b)) return false;
  const Real comes = normal.dot(a.velocity - b.velocity);
  if (comes + fastest_corner(a, dt) + fastest_corner(b, dt) <= threshold) return false;
  const Corner of_a = first_to_get(a, normal, dt), of_b = first_to_get(b, -normal, dt);
  const Real gap = -of_a.at - of_b.at - roundness(a) - roundness(b);
  const Real approach = comes + of_a.speed + of_b.speed;
  return approach > threshold && gap <= dt * (comes + falls) + of_a.way + of_b.way && (gap > apart || approach > falls);
}

}  // namespace

Real way_of_tips(const Body& body, Real dt) {
  const Real spin = body.angular_velocity.norm();
  return !body.movable() || spin == 0 ? 0 : reach_of_core(body) * std::min(dt * spin, Real(2));
}

void StepClassifier::classify(const World& world, const Contacts& contacts, Real dt, Real threshold,
                              const ClassifierLimits& limits) {
  all_.resize(world.bodies.size());
  std::iota(all_.begin(), all_.end(), 0);
  islands_.separate(all_, all_.size());
  islands_.join(contacts, world);
  islands_.join(world.joints, world);
  by_island_.assign(all_.size(), {});
  reasons_.resize(all_.size(), StepReason::none);
  by_fast_.resize(all_.size(), false);
  read_contacts(world, contacts, dt, threshold);
  read_joints(world);
  read_bodies(world, limits.fast_turn / dt);
  find_large(world, contacts, limits);
  for (const Body& body : world.bodies) {
    Island& island = at(island_of(body.index));
    const StepReason reason = body.movable() ? reason_for(island, limits) : StepReason::none;
    reasons_[std::size_t(body.index)] = reason;
    by_fast_[std::size_t(body.index)] = island.large && type_of(reason) == StepType::substeps;
  }
}

void StepClassifier::read_contacts(const World& world, const Contacts& contacts, Real dt, Real threshold) {
  const Real falls = dt * world.gravity.norm();
  each_pair(contacts, [&](PairContacts between) {
    const auto [a, b] = world.bodies_of(between.front());
    Island& island = of_movable(a, b);
    ++island.near;
    const Body& ground = a.movable() ? b : a;
    if (ground.movable()) return;
    if (std::any_of(between.begin(), between.end(),
                    [&ground](const Contact& at) { return turns_or_pushes(ground, at); }))
      island.refuse(StepReason::moving_surface, ground.index);
    const Vec3 goes = ground.conveys ? Vec3::Zero() : ground.velocity;
    if (island.ground_velocity.value_or(goes) != goes) island.refuse(StepReason::unequal_grounds, ground.index);
    island.ground_velocity = goes;
  });
  each_pair(contacts, [&](PairContacts between) {
    const Contact& nearest = *std::max_element(between.begin(), between.end(),
                                               [](const Contact& p, const Contact& q) { return p.depth < q.depth; });
    const auto [a, b] = world.bodies_of(nearest);
    Island& island = of_movable(a, b);
    int acting = 0;
    for (const Contact& at : between) {
      const Real gap = -at.depth, approach = -separating_speed(world, at);
      if (-gap > too_deep) island.refuse(StepReason::deep_overlap);
      island.impact |= at.ahead;  // they meet elsewhere than where they are nearest
      island.overlap += std::max(Real(0), -gap);
      island.deepest = std::max(island.deepest, -gap);
      if (gap > dt * (std::max(Real(0), approach) + falls)) continue;
      ++acting;
      // A resting contact does not arrive, because its speed is rounding.
      island.impact |= approach > threshold && (gap > apart || approach > falls);
    }
    const bool counted = acting > 0 && island.impact;
    if (!counted && corners_arrive(a, b, nearest.normal, dt, threshold, falls)) {  // where no contact is yet
      acting = std::max(acting, 1);
      island.impact = true;
    }
    island.contacts += acting;
    island.pairs += acting > 0;
  });
}

void StepClassifier::read_joints(const World& world) {
  if (world.joints.empty()) return;
  std::vector<JoinedBodies> joined;
  for (const Joint& joint : world.joints) {
    const auto moving = [&world](int body) { return world.body(body).movable() ? body : not_moving; };
    joined.push_back(std::minmax({moving(joint.a), moving(joint.b)}));
  }
  const std::vector<bool> loops = in_loops(joined);
  Equations equations;
  for (std::size_t i = 0; i < world.joints.size(); ++i) {
    const Joint& joint = world.joints[i];
    const Body &a = world.body(joint.a), &b = world.body(joint.b);
    if (!a.movable() && !b.movable()) continue;
    Island& island = of_movable(a, b);
    ++island.joints;
    if (island.refused != StepReason::none) continue;
    if (loops[i]) island.refuse(StepReason::joint_loop, static_cast<int>(i));
    else if (!rigid(world, joint, equations)) island.refuse(StepReason::joint_not_rigid, static_cast<int>(i));
  }
}

void StepClassifier::read_bodies(const World& world, Real turn) {
  for (std::size_t i = 0; i < world.forces.size(); ++i) {
    const std::vector<int>& bodies = world.forces[i].bodies;
    for (const int body : bodies.empty() ? all_ : bodies)
      at(island_of(body)).refuse(StepReason::applied_force, static_cast<int>(i));
  }
  for (const Body& body : world.bodies) {
    if (!body.movable()) continue;
    Island& island = at(island_of(body.index));
    if (body.asleep) island.refuse(StepReason::asleep, body.index);
    if (island.turning < 0 && body.angular_velocity.norm() > turn) island.turning = body.index;
    island.fastest = std::max(island.fastest, (body.velocity - island.ground_velocity.value_or(Vec3::Zero())).norm());
    island.kept &= step_of(body.index) == StepType::half_steps;
    ++island.bodies;
    island.by_fast += by_fast_[std::size_t(body.index)];
  }
}

/// Islands with so many contacts that Fast moves them. Layers and masses are looked at only if there are any.
void StepClassifier::find_large(const World& world, const Contacts& contacts, const ClassifierLimits& limits) {
  bool any = false;
  for (Island& island : by_island_) {
    island.large = island.may_be_large && island.joints == 0 &&
                   island.contacts >= (island.was_large() ? limits.large_pile / 2 : limits.large_pile);
    any |= island.large;
  }
  if (!any) return;
  const std::vector<int> layers = layers_of(world, contacts);
  for (const Body& body : world.bodies) {
    if (!body.movable()) continue;
    Island& island = at(island_of(body.index));
    const int most = limits.most_layers * (island.was_large() ? 2 : 1);
    island.large &= layers[std::size_t(body.index)] <= most;
  }
  each_pair(contacts, [&](PairContacts between) {
    const auto [a, b] = world.bodies_of(between.front());
    if (!a.movable() || !b.movable()) return;
    const auto [lighter, heavier] = std::minmax(a.inverse_mass, b.inverse_mass, std::greater<>());
    at(island_of(a.index)).large &= lighter <= limits.most_mass_ratio * heavier;
  });
}

StepReason StepClassifier::reason_for(Island& island, const ClassifierLimits& limits) {
  const bool moves =
      island.refused != StepReason::none || island.impact || island.turning >= 0 || island.fastest > limits.calm_speed;
  if (island.large && moves) {
    island.many = true;
    island.limit = limits.large_pile;
    return StepReason::large_pile;
  }
  if (island.refused != StepReason::none) return island.refused;
  if (island.near == 0) return island.joints == 0 ? StepReason::no_contact : StepReason::rigid_joints;
  island.limit = island.kept ? limits.most_kept : limits.most;
  const bool many = island.contacts > island.limit;
  if (!many) return StepReason::few_contacts;
  if (island.joints > 0) return StepReason::contacts_and_joints;
  island.many = true;
  if (island.impact && island.contacts == island.pairs && island.contacts <= limits.most_single_contacts) {
    island.limit = limits.most_single_contacts;
    return StepReason::single_contacts;
  }
  if (island.impact) return StepReason::impact;
  island.cause = island.turning;
  return island.turning < 0 ? StepReason::resting_contacts : StepReason::fast_turn;
}

}  // namespace pushback
