#include "pushback/engine/islands/within_error.h"

#include <utility>

#include "pushback/common/basics/input.h"
#include "pushback/engine/half_step/gap.h"

namespace pushback {

namespace {

constexpr Real horizon = 1;                        // s: T
constexpr Real stiffest = Real(1e9);               // Hz: as stiff as substeps hold, 1 / (8 h)
constexpr int least = 2;                           // half steps of a step that is looked at: half of them is one
constexpr int most_of_few = 16, most_of_more = 2;  // half steps of contacts that are few, and that are many
constexpr int most_of_second_order = 8;            // half steps of joints; then they are composed
constexpr int fourth_for = 60;                     // steps; then half steps are tried again
constexpr int most_of_flight = 64;
constexpr int least_of_many = 4;

std::ptrdiff_t sliding(const World& world) {
  return std::count_if(world.contacts.begin(), world.contacts.end(),
                       [](const Contact& contact) { return contact.state == ContactState::sliding; });
}

Real roughest(const World& world) {
  Real mu = 0;
  for (const Contact& contact : world.contacts) mu = std::max(mu, contact.friction);
  return mu;
}

/// Whether something has bounced: how far off that is, two steps from the same start do not tell, as both find the same impact.
bool bounced(const World& world) {
  return std::any_of(world.contacts.begin(), world.contacts.end(),
                     [](const Contact& contact) { return contact.restitution > 0 && !contact.impulse.isZero(0); });
}

/// rad/s.
Real fastest_spin(const World& world) {
  Real fastest = 0;
  for (const Body& body : world.bodies) fastest = std::max(fastest, body.angular_velocity.norm());
  return fastest;
}

}  // namespace

void WithinError::whole_step(World& world, Real dt, int sweeps) {
  if (!(error > 0)) throw InvalidInput(fmt::format("error is {}: a length above 0 is needed", error));
  if (looks_every < 1)
    throw InvalidInput(fmt::format("looks_every is {}: a whole number, 1 or more, is needed", looks_every));
  if (most_of_many < least_of_many)
    throw InvalidInput(fmt::format("most_of_many is {}: {} or more is needed", most_of_many, least_of_many));
  looks_.resize(world.bodies.size());
  of_body_.resize(world.bodies.size());
  ByIsland::whole_step(world, dt, sweeps);
  for (std::size_t i = 0; i < of_body_.size(); ++i) {
    OfBody& of = of_body_[i];
    if (const MovedBy how = calls_.of(static_cast<int>(i)); how == MovedBy::flight || how == MovedBy::nothing)
      of.step_x = of.step_v = Vec3::Zero();
    if (calls_.of(static_cast<int>(i)) == MovedBy::substeps) of.step_v.setZero(), of.v.setZero();
    of.x += dt * of.v + of.step_x;
    of.v += of.step_v;
  }
}

Known WithinError::known(int body) {
  const auto i = static_cast<std::size_t>(body);
  if (i >= of_body_.size()) return {};
  const OfBody& of = of_body_[i];
  Known known{.how = moved_by(body), .place = of.x.norm()};
  known.step = of.step_x.norm() + horizon / 2 * of.step_v.norm();
  if (known.how == MovedBy::half_steps) {
    const Look& look = looks_[std::size_t(calls_.island_of(body))];
    known.order = look.order();
    known.substeps = substeps_of(body);
    known.kept = look.kept;
  } else if (known.how == MovedBy::substeps) {
    known.order = 1;
    known.substeps = many.substeps;
    known.place += sunken_;
    known.kept = off_of_others(0) <= 1 && !met_[std::size_t(calls_.island_of(body))];
  }
  return known;
}

/// m: of the island, which has been moved in twice as many substeps as `coarse` were.
Real WithinError::difference(const IslandWorld& island, const std::vector<Body>& coarse, int order) {
  const Real parts = parts_of_difference(order);
  Real largest = 0;
  for (std::size_t i = 0; i < coarse.size(); ++i) {
    const Body& fine = island.world.bodies[i];
    if (!fine.movable()) continue;
    OfBody& of = of_body_[std::size_t(island.bodies()[i])];
    of.step_x = (coarse[i].position - fine.position) / parts;
    of.step_v = (coarse[i].velocity - fine.velocity) / parts;
    largest = std::max(largest, of.step_x.norm() + horizon / 2 * of.step_v.norm());
  }
  return largest;
}

void WithinError::find_substeps(IslandWorld& island, Memory& memory, const World& whole, Real dt, int sweeps) {
  Look& look = looks_[std::size_t(island.lowest())];
  if (std::isinf(error) || (island.impact && calls_.many(island.lowest()))) {
    look = {.kept = std::isinf(error)};  // who meets whom first: nobody knows
    for (const int body : island.bodies())
      if (whole.bodies[std::size_t(body)].movable())
        of_body_[std::size_t(body)].step_x = of_body_[std::size_t(body)].step_v = Vec3::Zero();
    return ByIsland::find_substeps(island, memory, whole, dt, sweeps);
  }
  const bool joints = !island.world.joints.empty();
  const int contacts = calls_.contacts(island.lowest());
  const Allowed allowed{error * dt / horizon, dt, sweeps, sliding(island.world)};
  const bool meets = calls_.impact(island.lowest()), alone = joints && !island.impact;
  const bool again_of_second_order = look.fourth == 1 || (look.fourth > 0 && !alone);
  look.fourth = alone ? std::max(0, look.fourth - 1) : 0;
  if (again_of_second_order) {
    memory.next = most_of_second_order;
    look.ago = looks_every;
  }
  int begun = std::max(memory.next, joints ? least : 1);
  int most = alone                          ? most_of_second_order
             : joints                       ? most_substeps
             : calls_.many(island.lowest()) ? most_of_more
                                            : most_of_few;
  if (look.fourth > 0) most = most_substeps;
  std::vector<Body> coarse;
  if (!meets && contacts == look.contacts && ++look.ago < looks_every) {
    begin_order(island, allowed);
    memory.substeps = begun;
    island.held = take(island, whole, begun, dt, sweeps) <= 1;
    const Real quicker = fastest_spin(island.world) / look.spin;
    const bool whips = joints && off_when(quicker, look.off, look.order()) > 1;
    const bool met = island.impact && island.cut_step.events() > 0;
    if (island.held && !whips && !met && sliding(island.world) == allowed.sliding) return;
    if (island.held && whips && 2 * begun <= most && island.solver().halvings() == 0) {
      coarse = island.world.bodies;
      begun *= 2;
    }
  }
  look.ago = 0;
  look.contacts = contacts;
  begun = std::max(begun, least);
  Real off = find_enough(island, memory, whole, allowed, begun, most, std::move(coarse));
  if (alone && look.fourth == 0 && !look.kept) {
    look.fourth = fourth_for;
    off = find_enough(island, memory, whole, allowed, least, most_substeps);
  }
  if (look.fourth > 0 && !island.held) {
    look.fourth = 0;
    off = find_enough(island, memory, whole, allowed, 2 * most_of_second_order, most_substeps);
  }
  if (!island.held) return;
  const bool is_kept = look.kept;
  if (meets && bounced(island.world)) look.kept = false;
  look.spin = fastest_spin(island.world);
  look.off = off;
  const int needed = is_kept || joints ? memory.substeps : begun;
  memory.next = fewer_will_do(off, look.order()) ? needed / 2 : needed;
}

void WithinError::begin_order(IslandWorld& island, const Allowed& allowed) {
  island.fourth = looks_[std::size_t(island.lowest())].fourth > 0;
  if (island.fourth) island.fourth_order.set_as(joined);
  island.solver().tolerance = std::min(island.solver().tolerance, allowed.off / 100);
}

/// In substeps twice as many, until they are enough. `coarse`: as half of `begun` leave the bodies; empty: they are still to be taken.
/// Returns by what the last are off, in parts of what is allowed.
Real WithinError::find_enough(IslandWorld& island, Memory& memory, const World& whole, const Allowed& allowed,
                              int begun, int most, std::vector<Body> coarse) {
  Look& look = looks_[std::size_t(island.lowest())];
  const bool joints = !island.world.joints.empty();
  begin_order(island, allowed);
  // A step that had to be divided is as two are, and tells nothing about these.
  const auto undivided = [&] { return island.solver().halvings() == 0; };
  if (coarse.empty() && std::isfinite(take(island, whole, begun / 2, allowed.dt, allowed.sweeps)) && undivided())
    coarse = island.world.bodies;
  Real off = std::numeric_limits<Real>::infinity();
  int kept = 0, no_better = 0;
  for (memory.substeps = begun;; memory.substeps *= 2) {
    const Real energy_off = take(island, whole, memory.substeps, allowed.dt, allowed.sweeps), before = off;
    island.held = island.joined_and_near() ? energy_off <= 1 : std::isfinite(energy_off);
    Worth now = Worth::more;
    if (island.held && !coarse.empty()) {
      off = std::max(energy_off, difference(island, coarse, look.order()) / allowed.off);
      const Real slows = roughest(island.world) * whole.gravity.norm();
      // Once, not in each step: half of the error may be spent on it.
      if (sliding(island.world) != allowed.sliding)
        off = std::max(off, sticks_early(slows, allowed.dt / static_cast<Real>(memory.substeps)) / (error / 2));
      now = worth(off, before);
    }
    look.kept = now == Worth::kept;
    // Where something comes to rest or begins to slide, two steps can be off by the same.
    if (look.kept && ++kept < (sliding(island.world) == allowed.sliding ? 1 : 2)) now = Worth::more;
    // Nothing is decided in a chain: where it whips, so few substeps are far from what they tend to.
    if (joints && now == Worth::no_better && ++no_better < 2) now = Worth::more;
    if (now != Worth::more || 2 * memory.substeps > most || !can_go_on(island)) break;
    coarse.clear();
    if (island.held && undivided()) coarse = island.world.bodies;
  }
  return off;
}

/// Its place is exact in one. The turn of a body that tumbles is of second order, and its corners are to be where they belong.
int WithinError::parts_of_flight(const Body& body, Real dt) const {
  if (std::isinf(error) || !tumbles(body)) return 1;
  const Real reach = reach_of_core(body);
  const auto turned = [&](int parts) {
    Body copy = body;
    for (int i = 0; i < parts; ++i) spin_freely(copy, dt / static_cast<Real>(parts));
    return copy.orientation;
  };
  Quat coarse = turned(1);
  for (int parts = 2;; parts *= 2) {
    const Quat fine = turned(parts);
    const Real off = reach * fine.angularDistance(coarse) / parts_of_difference(2);
    if (off <= error * dt / horizon || parts == most_of_flight) return parts;
    coarse = fine;
  }
}

/// x += h v is wrong by h / 2 times what v changes by (chapter 24). That, and what contacts have sunk by, is known after a step.
/// Where it is too much, the step is taken again in more substeps: the first error falls with them, the second with their square.
void WithinError::move_others(World& world, Real dt, int sweeps) {
  const auto moves = [this](const Body& body) { return calls_.of(body.index) == MovedBy::substeps; };
  if (std::isinf(error)) return ByIsland::move_others(world, dt, sweeps);
  in_a_second_ *= 1 - std::min(Real(1), dt / horizon);
  sunken_ = 0;
  met_.assign(world.bodies.size(), false);
  if (std::none_of(world.bodies.begin(), world.bodies.end(), moves)) return ByIsland::move_others(world, dt, sweeps);
  const World before = world;
  const Contacts found = found_;
  const Solved solved = solved_;
  Real largest = move_stiffly(world, before, dt, sweeps);
  const Real off = off_of_others(largest);
  if (off > 1 && many.substeps < most_of_many) {
    for (Real left = off; left > 1 && many.substeps < most_of_many; left /= 2) many.substeps *= 2;
    many.substeps = std::min(many.substeps, most_of_many);
    world = before;
    found_ = found;
    solved_ = solved;
    largest = move_stiffly(world, before, dt, sweeps);
  } else if (fewer_will_do(off, 2)) {
    many.substeps = std::max(least_of_many, many.substeps / 2);
  }
  in_a_second_ += largest;
  find_meetings(found, before, world, dt);
}

/// What came faster than a step of fall makes it, and comes no more, where joints have a part in it; and what has bounced.
void WithinError::find_meetings(const Contacts& found, const World& before, const World& after, Real dt) {
  const auto meet = [this, &after](const Contact& contact) {
    for (const std::size_t body : {contact.id.body_a, contact.id.body_b})
      if (after.bodies[body].movable()) met_[std::size_t(calls_.island_of(static_cast<int>(body)))] = true;
  };
  for (const Contact& contact : after.contacts)
    if (contact.restitution > 0 && !contact.impulse.isZero(0) && separating_speed(before, contact) < -many.threshold)
      meet(contact);
  std::vector<bool> is_joined(after.bodies.size());
  for (const Joint& joint : after.joints)
    for (const int body : {joint.a, joint.b})
      if (body != the_world) is_joined[std::size_t(body)] = true;
  for (const Contact& contact : found) {
    const Real came = separating_speed(before, contact);
    if ((is_joined[contact.id.body_a] || is_joined[contact.id.body_b]) && came <= -dt * after.gravity.norm() &&
        separating_speed(after, contact) >= came / 2)
      meet(contact);
  }
}

/// By springs as stiff as the substeps hold. Returns the largest error of the step, m, and sets those of the bodies.
Real WithinError::move_stiffly(World& world, const World& before, Real dt, int sweeps) {
  const Real hertz = std::exchange(many.spring.hertz, stiffest);
  try {
    ByIsland::move_others(world, dt, sweeps);
  } catch (const InvalidInput&) {
    many.spring.hertz = hertz;
    throw;
  }
  many.spring.hertz = hertz;
  const Real half = dt / static_cast<Real>(2 * many.plan(dt).all_substeps());
  const auto moves = [this](int body) { return calls_.of(body) == MovedBy::substeps; };
  Real largest = 0;
  for (std::size_t i = 0; i < world.bodies.size(); ++i) {
    if (!moves(static_cast<int>(i))) continue;
    of_body_[i].step_x = half * (world.bodies[i].velocity - before.bodies[i].velocity);
    largest = std::max(largest, of_body_[i].step_x.norm());
  }
  sunken_ = sunken(world, moves);
  return largest;
}

}  // namespace pushback
