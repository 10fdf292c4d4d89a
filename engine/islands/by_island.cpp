#include "pushback/engine/islands/by_island.h"

#include <limits>

#include "pushback/common/basics/input.h"
#include "pushback/common/collision/collide.h"
#include "pushback/common/world/measure.h"
#include "pushback/common/world/step.h"
#include "pushback/engine/half_step/gap.h"

namespace pushback {

namespace {

constexpr int waits_after_failing = 10;  // steps; twice as many after each failure more, but for
constexpr int most_failures = 4;
constexpr Real by_contacts = Real(0.01);  // of T + m (h g)^2 / 2: a step in which contacts gave more was not solved
constexpr Real of_their_own =
    Real(1) / 120;                // s: in shorter steps many contacts have one half step; substeps are fewer, too
constexpr int most_meetings = 8;  // in a step that is taken again for them; then what meets has substeps
constexpr double of_look = 750;   // multiplications, where a contact bears in a half step what it bore before

bool lower(const Contact& first, const Contact& second) {
  return first.id < second.id;
}

}  // namespace

void ByIsland::check_settings(World& world, Real dt) {
  if (limits.most < 0) throw InvalidInput(fmt::format("most is {}: a whole number, 0 or more, is needed", limits.most));
  for (const auto& [name, limit] : {std::pair("most_kept", limits.most_kept), {"most_meeting", limits.most_meeting}})
    if (limit < limits.most)
      throw InvalidInput(fmt::format("{} is {}: no less than most is needed, which is {}", name, limit, limits.most));
  if (limits.most_detections < 1 || limits.most_detections > 64)
    throw InvalidInput(
        fmt::format("most_detections is {}: a whole number from 1 to 64 is needed", limits.most_detections));
  require_positive("energy", energy);
  require_positive("turn", limits.turn);
  const auto require = [](const char* name, double number, bool allowed, const char* what) {
    if (!allowed || !std::isfinite(number))
      throw InvalidInput(fmt::format("savings.{} is {}: a finite number{} is needed", name, number, what));
  };
  require("of_contact", savings.of_contact, savings.of_contact > 0, " above 0");
  require("part", savings.part, savings.part >= 0, ", 0 or more,");
  require("at_first", savings.at_first, savings.at_first >= 0, ", 0 or more,");
  require("most", savings.most, savings.most >= 1, ", 1 or more,");
  require("at_once", savings.at_once, savings.at_once >= 1, ", 1 or more,");
  many.SubsteppingSolver::check(world, dt);
  few.check_settings();
  joined.check_settings();
  if (most_substeps < joined.substeps)
    throw InvalidInput(fmt::format("most_substeps is {}: no less than joined's substeps is needed, which are {}",
                                   most_substeps, joined.substeps));
}

void ByIsland::whole_step(World& world, Real dt, int sweeps) {
  check_step(dt, sweeps, world.gravity);
  Everybody::check(world);
  check_settings(world, dt);
  const Plan plan = many.plan(dt);
  find_contacts(world, plan, dt);
  memory_.resize(world.bodies.size());
  shares_.resize(world.bodies.size(), Purse(savings.at_first * savings.of_contact));
  for (Memory& memory : memory_) memory.waits = std::max(0, memory.waits - 1);
  by_calls_ = false;
  solved_ = {};
  Limits now = limits;
  for (int meetings = 0;; ++meetings) {
    if (meetings == most_meetings) now.most = now.most_kept = now.most_meeting = 0;
    calls_.find(world, found_, dt, many.threshold, now);
    collect(world);
    divide(world);
    plan.workers->each(count_, 4, [&](Part part) {
      for (std::size_t i = part.begin; i < part.end; ++i) move_island(islands_[i], world, dt, sweeps);
    });
    for (std::size_t i = 0; i < count_; ++i) islands_[i].give_joints(world.joints);
    if (meetings == most_meetings || !others_were_met(world, dt)) break;
  }
  for (std::size_t i = 0; i < count_; ++i) {
    IslandWorld& island = islands_[i];
    if (island.held) add_up(island.solver().solved());
    else
      for (const int body : island.bodies())
        if (world.body(body).movable()) calls_.leave_to_substeps(body);
  }
  share_out(world);
  move_others(world, dt, sweeps);
  put_back(world, dt);
}

void ByIsland::collect(const World& world) {
  purses_.assign(world.bodies.size(), Purse());
  for (const Body& body : world.bodies)
    if (body.movable()) purses_[std::size_t(calls_.island_of(body.index))].add(shares_[std::size_t(body.index)]);
}

/// Where many contacts had substeps, something is saved.
void ByIsland::share_out(const World& world) {
  for (const Body& body : world.bodies)
    if (body.movable() && calls_.island_of(body.index) == body.index && calls_.many(body.index) &&
        calls_.of(body.index) == MovedBy::substeps) {
      const double price = savings.of_contact * calls_.contacts(body.index);
      purses_[std::size_t(body.index)].save(savings.part * price, savings.most * price);
    }
  for (const Body& body : world.bodies)
    if (body.movable()) shares_[std::size_t(body.index)] = purses_[std::size_t(calls_.island_of(body.index))].share();
}

/// World::contacts stay those of the step before, with the impulses of its last substep.
void ByIsland::find_contacts(World& world, const Plan& plan, Real dt) {
  start_from_last_substep(world);
  before_.swap(world.contacts);
  world.find_contacts(plan.margin, plan.workers->of_bodies(world.bodies.size()));
  found_.swap(world.contacts);
  world.contacts.swap(before_);
  std::vector<Real> ways;  // where the ends of what turns may come: the margin follows centres
  std::vector<bool> turns;
  for (const Body& body : world.bodies) {
    const Real tips = way_of_tips(body, dt);
    ways.push_back(dt * body.velocity.norm() + tips);
    turns.push_back(tips > many.margin / 2);
  }
  for (const Joint& joint : world.joints)  // cutting a step is for what is free
    for (const int body : {joint.a, joint.b})
      if (body != the_world) turns[std::size_t(body)] = false;
  if (std::find(turns.begin(), turns.end(), true) != turns.end())
    find_more(world, ways, [&turns](std::size_t p, std::size_t q) { return turns[p] || turns[q]; });
}

/// Contacts of pairs that are as near as the ways of both, and have none yet. Returns whether there are any.
template <class Wanted>
bool ByIsland::find_more(const World& world, const std::vector<Real>& ways, const Wanted& wanted) {
  if (std::none_of(ways.begin(), ways.end(), [](Real way) { return way > 0; })) return false;
  const std::size_t known = found_.size();
  const auto are_known = [&](std::size_t a, std::size_t b) {
    const Contact least{.id = {std::uint32_t(a), std::uint32_t(b), 0}};
    const auto end = found_.begin() + std::ptrdiff_t(known), at = std::lower_bound(found_.begin(), end, least, lower);
    return at != end && at->id.body_a == least.id.body_a && at->id.body_b == least.id.body_b;
  };
  const JoinedPairs not_to_touch(world.joints);
  for (const auto& [first, second] : near_pairs(world.bodies, ways)) {
    const auto p = std::size_t(first), q = std::size_t(second);
    const Body &a = world.bodies[p], &b = world.bodies[q];
    if (!wanted(p, q) || !may_touch(a, b) || not_to_touch.contain(first, second) || are_known(p, q)) continue;
    const std::size_t count = found_.size();
    collide(a, b, found_, {.least = ways[p] + ways[q]});
    if (found_.size() > count) continue;
    // Collision detection finds no contact where two corners are nearest to each other.
    const Gap gap = gap_between(a, b);
    if (gap.distance > ways[p] + ways[q]) continue;
    found_.push_back({.id = {std::uint32_t(p), std::uint32_t(q), beside}});
    found_.back().point = a.position;
    found_.back().normal = gap.normal;
    found_.back().depth = -gap.distance;
  }
  if (found_.size() == known) return false;
  std::inplace_merge(found_.begin(), found_.begin() + std::ptrdiff_t(known), found_.end(), lower);
  return true;
}

/// Makes a world of each island that calls for half steps.
void ByIsland::divide(World& world) {
  count_ = 0;
  place_.assign(world.bodies.size(), -1);
  for (const Body& body : world.bodies) {
    if (calls_.of(body.index) != MovedBy::half_steps) continue;
    const int lowest = calls_.island_of(body.index);
    if (memory_[std::size_t(lowest)].waits > 0 || !can_pay(lowest)) {
      calls_.leave_to_substeps(body.index);
      continue;
    }
    int& place = place_[std::size_t(lowest)];
    if (place < 0) {
      place = static_cast<int>(count_);
      if (count_ == islands_.size()) islands_.emplace_back();
      islands_[count_++].begin(world, lowest);
    }
    islands_[std::size_t(place)].add(body.index);
  }
  if (count_ == 0) return;
  const auto island_of = [this](const Body& a, const Body& b) -> IslandWorld* {
    const int moving = (a.movable() ? a : b).index;
    if (calls_.of(moving) != MovedBy::half_steps) return nullptr;
    if (a.movable() && b.movable() && calls_.island_of(a.index) != calls_.island_of(b.index)) return nullptr;
    return &islands_[std::size_t(place_[std::size_t(calls_.island_of(moving))])];
  };
  for (const Contact& contact : found_) {
    const auto [a, b] = world.bodies_of(contact);
    if (IslandWorld* island = island_of(a, b))
      if (!a.movable() || !b.movable()) island->add((a.movable() ? b : a).index);
  }
  for (const Joint& joint : world.joints)
    if (IslandWorld* island = island_of(world.body(joint.a), world.body(joint.b)))
      for (const int body : {joint.a, joint.b})
        if (body != the_world) island->add(body);
  for (std::size_t i = 0; i < count_; ++i) islands_[i].sort();
  for (const Contact& contact : world.contacts) {
    const auto [a, b] = world.bodies_of(contact);
    if (IslandWorld* island = island_of(a, b)) island->add(contact);
  }
  for (std::size_t i = 0; i < world.joints.size(); ++i) {
    Joint& joint = world.joints[i];
    if (IslandWorld* island = island_of(world.body(joint.a), world.body(joint.b))) island->take(joint, i);
  }
}

void ByIsland::move_island(IslandWorld& island, const World& whole, Real dt, int sweeps) {
  const bool joints = !island.world.joints.empty();
  island.impact = calls_.impact(island.lowest()) || (joints && calls_.near(island.lowest()));
  HalfStep& solver = island.solver();
  solver.set_as(joints ? joined : few);
  if (island.joined_and_near()) {
    solver.threshold = few.threshold;
    solver.tolerance = std::min(solver.tolerance, AtImpacts().tolerance);
  }
  Memory& memory = memory_[std::size_t(island.lowest())];
  Purse* const purse = calls_.many(island.lowest()) ? &purses_[std::size_t(island.lowest())] : nullptr;
  const double price = savings.of_contact * calls_.contacts(island.lowest());
  if (purse) {
    solver.most_work = std::min(purse->saved(), savings.at_once * price);
    solver.from_afar = false;
  }
  find_substeps(island, memory, whole, dt, sweeps);
  if (island.held && !island.impact && !purse && lets_in(island)) {
    island.impact = true;
    calls_.have_met(island.lowest());
    island.solver().set_as(few);
    find_substeps(island, memory, whole, dt, sweeps);
  }
  if (purse) {
    const double took = solver.work() + of_look * calls_.contacts(island.lowest()) * memory.substeps;
    if (island.held) purse->succeed(price - took, savings.most * price);
    else purse->fail(took, savings.at_once);
  }
  if (!island.held && (!purse || solver.too_large())) {  // too large: it stays so while the same bodies touch
    const int failures = purse || island.joined_and_near() ? memory.failures : 0;
    memory = {.waits = waits_after_failing << failures, .failures = std::min(failures + 1, most_failures)};
  }
  if (island.held) memory.failures = 0;
}

/// Whether half steps have let a contact in that they had not detected. Islands that were deep before are left out: in a press there is no
/// room.
bool ByIsland::lets_in(const IslandWorld& island) {
  const Real before = calls_.deepest(island.lowest()),
             most = std::max(AtImpacts::sinks, before + AtImpacts::sinks / 10);
  return before <= 10 * AtImpacts::sinks &&
         std::any_of(island.world.contacts.begin(), island.world.contacts.end(),
                     [most](const Contact& at) { return !at.parted && at.depth > most; });
}

int ByIsland::most_half_steps(const IslandWorld& island, Real dt) const {
  if (!island.world.joints.empty()) return most_substeps;
  if (!calls_.many(island.lowest())) return few.substeps;
  return std::min(few.substeps, static_cast<int>(std::ceil(dt / of_their_own)));
}

void ByIsland::find_substeps(IslandWorld& island, Memory& memory, const World& whole, Real dt, int sweeps) {
  const bool few_meet = island.impact && island.world.joints.empty() && !calls_.many(island.lowest());
  const int least = most_half_steps(island, dt), most = few_meet ? 4 * least : least;
  memory.substeps = island.world.joints.empty() ? least : std::max(memory.next, joined.substeps);
  Real off = 0;
  for (;; memory.substeps *= 2) {
    off = take(island, whole, memory.substeps, dt, sweeps);
    if (off <= 1 || 2 * memory.substeps > most || !can_go_on(island)) break;
  }
  island.held = off <= 1;
  memory.next = off < Real(0.125) ? memory.substeps / 2 : memory.substeps;
}

Real ByIsland::take(IslandWorld& island, const World& whole, int substeps, Real dt, int sweeps) const {
  const bool worked_on = island.copy_bodies(whole);
  World& world = island.world;
  HalfStep& solver = island.solver();
  solver.substeps = substeps;
  const Real motion_before = kinetic_energy(world), before = motion_before + potential_energy(world);
  bool solved = true;
  try {
    solver.whole_step(world, dt, sweeps);
  } catch (const InvalidInput&) {
    solved = false;
  }
  island.took = solver.work();
  if (island.joined_and_near()) solver.most_work = std::max(1.0, solver.most_work - island.took);
  if (!solved) return std::numeric_limits<Real>::infinity();
  if (worked_on) return 0;
  const Real motion = kinetic_energy(world), gained = motion + potential_energy(world) - before;
  Real mass = 0;
  for (const Body& body : world.bodies)
    if (body.movable()) mass += 1 / body.inverse_mass;
  const Real freed = mass * world.gravity.norm() * calls_.overlap(island.lowest()),
             all = std::max(motion, motion_before) + mass * (dt * world.gravity).squaredNorm() / 2;
  // Contacts take energy, and give none beyond what overlap frees. How much they take nobody knows; what tumbles errs by less.
  if (world.joints.empty()) return gained - freed > by_contacts * all ? std::numeric_limits<Real>::infinity() : 0;
  Real off = std::abs(gained);
  if (island.impact) {
    const Real left = gained + island.cut_step.taken();
    off = std::max(gained, island.cut_step.held() ? left : std::abs(left)) - freed;
  }
  return off / (energy * all);
}

/// Whether bodies may have come upon others, which are not of their island: those that have bounced, and those that joints have made
/// faster than detection expected. As near as the speeds of both, before and after, can bring them in dt. Then they are one, and
/// contacts are added to those that were found.
bool ByIsland::others_were_met(const World& world, Real dt) {
  std::vector<bool> may_meet(world.bodies.size(), false);
  std::vector<Real> ways;
  for (const Body& body : world.bodies) ways.push_back(dt * body.velocity.norm());
  bool any = false;
  for (std::size_t i = 0; i < count_; ++i) {
    const IslandWorld& island = islands_[i];
    if (!island.held) continue;
    const bool bounced = island.impact && island.cut_step.events() > 0, joints = !island.world.joints.empty();
    for (const Body& after : island.world.bodies) {
      const auto at = std::size_t(island.bodies()[std::size_t(after.index)]);
      if (!after.movable()) continue;
      const Real expected = ways[at] + many.margin / 2;
      const auto reaches = [joints, dt](const Body& body) {
        return dt * body.velocity.norm() + (joints ? way_of_tips(body, dt) : 0);
      };
      ways[at] = std::max(reaches(world.bodies[at]), reaches(after));
      may_meet[at] = bounced || (joints && ways[at] > expected);
      any |= may_meet[at];
    }
  }
  return any && find_more(world, ways, [&](std::size_t p, std::size_t q) {
           if (!may_meet[p] && !may_meet[q]) return false;
           const int first = static_cast<int>(p), second = static_cast<int>(q);
           const bool both = world.bodies[p].movable() && world.bodies[q].movable();
           return !both || calls_.island_of(first) != calls_.island_of(second);
         });
}

/// Half of the kick, the drift, and the other half.
void ByIsland::fly(World& world, Real dt) const {
  for (Body& body : world.bodies) {
    if (calls_.of(body.index) != MovedBy::flight) continue;
    const Vec3 force = body.force, torque = body.torque;
    keep_velocity(body);
    integrate_velocity(body, world.gravity, dt / 2);
    const int parts = parts_of_flight(body, dt);
    for (int i = 0; i < parts; ++i) move(body, dt / static_cast<Real>(parts));
    body.force = force, body.torque = torque;
    integrate_velocity(body, world.gravity, dt / 2);
  }
}

void ByIsland::put_back(World& world, Real dt) {
  fly(world, dt);
  const auto of_many = static_cast<std::ptrdiff_t>(world.contacts.size());
  for (std::size_t i = 0; i < count_; ++i)
    if (islands_[i].held) islands_[i].give(world, world.dt_before / dt);
  std::sort(world.contacts.begin() + of_many, world.contacts.end(), lower);
  std::inplace_merge(world.contacts.begin(), world.contacts.begin() + of_many, world.contacts.end(), lower);
  world.last_impulses_known = true;
}

void ByIsland::add_up(const Solved& solved) {
  solved_ = {solved_.rows + solved.rows, std::max(solved_.residual, solved.residual)};
}

}  // namespace pushback
