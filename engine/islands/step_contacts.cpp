#include "pushback/engine/islands/step_contacts.h"

#include <algorithm>

#include "pushback/common/collision/broad_phase.h"
#include "pushback/common/collision/collide.h"
#include "pushback/common/world/step_parts.h"
#include "pushback/engine/half_step/gap.h"
#include "pushback/engine/islands/step_classifier.h"

namespace pushback {

namespace {

bool lower(const Contact& first, const Contact& second) {
  return first.id < second.id;
}

}  // namespace

void StepContacts::find(World& world, const StepClassifier& before, const Plan& plan, Real dt) {
  start_from_last_substep(world);
  before_.swap(world.contacts);
  world.find_contacts(plan.margin, plan.workers->of_bodies(world.bodies.size()));
  found.swap(world.contacts);
  world.contacts.swap(before_);
  std::vector<Real> ways;
  std::vector<bool> turns;
  for (const Body& body : world.bodies) {
    const Real tips = way_of_tips(body, dt);
    ways.push_back(dt * body.velocity.norm() + tips);
    turns.push_back(tips > plan.margin.least / 2 && !before.is_moved_by_fast(body.index));
  }
  for (const Joint& joint : world.joints)  // only steps of free bodies are cut
    for (const int body : {joint.a, joint.b})
      if (body != the_world) turns[std::size_t(body)] = false;
  if (std::find(turns.begin(), turns.end(), true) != turns.end())
    add_near(world, ways, [&turns](std::size_t p, std::size_t q) { return turns[p] || turns[q]; });
}

bool StepContacts::add_near(const World& world, const std::vector<Real>& ways,
                            const std::function<bool(std::size_t, std::size_t)>& wanted) {
  if (std::none_of(ways.begin(), ways.end(), [](Real way) { return way > 0; })) return false;
  const std::size_t known = found.size();
  const auto are_known = [&](std::size_t a, std::size_t b) {
    const Contact least{.id = {std::uint32_t(a), std::uint32_t(b), 0}};
    const auto end = found.begin() + std::ptrdiff_t(known), at = std::lower_bound(found.begin(), end, least, lower);
    return at != end && at->id.body_a == least.id.body_a && at->id.body_b == least.id.body_b;
  };
  const JoinedPairs not_to_touch(world.joints);
  for (const auto& [first, second] : near_pairs(world.bodies, ways)) {
    const auto p = std::size_t(first), q = std::size_t(second);
    const Body &a = world.bodies[p], &b = world.bodies[q];
    if (!wanted(p, q) || !may_touch(a, b) || not_to_touch.contain(first, second) || are_known(p, q)) continue;
    const std::size_t count = found.size();
    collide(a, b, found, {.least = ways[p] + ways[q]});
    if (found.size() > count) continue;
    // Collision detection finds no contact if two corners are the closest features.
    const Gap gap = gap_between(a, b);
    if (gap.distance > ways[p] + ways[q]) continue;
    found.push_back({.id = {std::uint32_t(p), std::uint32_t(q), no_feature}});
    found.back().point = a.position;
    found.back().normal = gap.normal;
    found.back().depth = -gap.distance;
  }
  if (found.size() == known) return false;
  std::inplace_merge(found.begin(), found.begin() + std::ptrdiff_t(known), found.end(), lower);
  return true;
}

}  // namespace pushback
