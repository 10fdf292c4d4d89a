#include "pushback/engine/half_step/half_step.h"

#include <algorithm>
#include <array>
#include <tuple>

#include "pushback/common/basics/input.h"

namespace pushback {

/// A body that spins about one of its principal axes turns evenly: `spin_freely` would find that out
/// by Newton's method, each time.
void drift(Body& body, Real h) {
  if (body.conveys) return;
  body.position += h * body.velocity;
  if (body.angular_velocity == Vec3::Zero()) return;
  if (!body.movable()) return spin_freely(body, h);
  const Vec3 spin = body.orientation.conjugate() * body.angular_velocity;
  const Vec3& inverse = body.principal_inverse_inertia;
  const Vec3 momentum = spin.cwiseQuotient(inverse);
  if (inverse.minCoeff() > 0 && momentum.cross(spin) != Vec3::Zero()) spin_freely(body, h);
  else spin_evenly(body, h);
}

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

HalfStep::Moment HalfStep::moment(const World& world) const {
  return {world.bodies, world.contacts, contacts_, joints_, accelerations_, time_};
}

/// Rows know the bodies by where they are in memory: these stay there.
void HalfStep::back_to(World& world, const Moment& moment) {
  std::copy(moment.bodies.begin(), moment.bodies.end(), world.bodies.begin());
  world.contacts = moment.contacts;
  contacts_ = moment.held;
  joints_ = moment.joints;
  accelerations_ = moment.accelerations;
  time_ = moment.time;
}

void HalfStep::set_as(const HalfStep& other) {
  substeps = other.substeps;
  tolerance = other.tolerance;
  most_rounds = other.most_rounds;
  threshold = other.threshold;
  most_halvings = other.most_halvings;
  most_work = other.most_work;
  from_afar = other.from_afar;
}

void HalfStep::check_settings() const {
  if (substeps < 1) throw InvalidInput(fmt::format("substeps is {}: a whole number, 1 or more, is needed", substeps));
  if (most_rounds < 1)
    throw InvalidInput(fmt::format("most_rounds is {}: a whole number, 1 or more, is needed", most_rounds));
  if (most_halvings < 0)
    throw InvalidInput(fmt::format("most_halvings is {}: a whole number, 0 or more, is needed", most_halvings));
  require_positive("tolerance", tolerance);
  if (!(most_work > 0)) throw InvalidInput(fmt::format("most_work is {}: a number above 0 is needed", most_work));
  require_not_negative("threshold", threshold);
}

void HalfStep::check(World& world, Real /*h*/) {
  check_settings();
  contacts_.threshold = threshold;
  contacts_.most_work = most_work;
  contacts_.from_afar = from_afar;
  for (const Body& body : world.bodies)
    if (body.asleep) throw InvalidInput("a body is asleep: half steps do not let bodies sleep");
  joints_.check(world, parts().size() > 1);
  by_hand_.clear();
  const auto feels = [](const Body& body) { return body.force != Vec3::Zero() || body.torque != Vec3::Zero(); };
  if (std::none_of(world.bodies.begin(), world.bodies.end(), feels)) return;
  for (const Body& body : world.bodies) by_hand_.emplace_back(body.force, body.torque);
}

void HalfStep::detected(World& world, Real /*h*/) {
  if (holds_contacts()) return;
  const auto touches = [](const Contact& contact) { return contact.depth >= 0; };
  const auto found = std::find_if(world.contacts.begin(), world.contacts.end(), touches);
  if (found == world.contacts.end()) return;
  throw InvalidInput(fmt::format("bodies {} and {} touch: a composed step goes back in time, and contacts do not",
                                 found->id.body_a, found->id.body_b));
}

bool HalfStep::holds_contacts() const {
  return parts().size() == 1;
}

/// Whether a stage is more than joints that hold, or contacts alone.
bool HalfStep::holds_together() const {
  return !joints_.linear() || (!joints_.empty() && !alone_);
}

/// As far as two bodies may come nearer in a drift.
Margin HalfStep::margin(Real gravity, Real h) {
  return {.least = Real(1e-3) + h * h * gravity, .ahead = 2 * h, .where_nearest = true};
}

/// Of the whole step: where nothing is as near as that, its substeps need no detection of their own. That is all where the world's
/// gravity is not larger.
Plan HalfStep::plan(Real dt) const {
  return {.sweeps = 1, .margin = holds_contacts() ? margin(World::g, dt) : Margin{}};
}

void HalfStep::begin_contacts(World& world, Real h) {
  const Real gravity = world.gravity.norm();
  if (gravity > World::g) world.find_contacts(margin(gravity, h));
  alone_ = world.contacts.empty();
  contacts_.begin(world);
}

void HalfStep::detect_contacts(World& world, Real h) {
  world.find_contacts(margin(world.gravity.norm(), h));
  contacts_.detected(world);
}

/// Whether a drift moves any body by more than rounding. Where it does not, contacts stay as they are.
bool HalfStep::moves(const World& world, Real h) {
  constexpr Real still = std::numeric_limits<Real>::digits > 24 ? Real(1e-13) : Real(1e-8);  // m or rad
  return std::any_of(world.bodies.begin(), world.bodies.end(), [h](const Body& body) {
    return !body.conveys &&
           h * (body.velocity.cwiseAbs().maxCoeff() + body.angular_velocity.cwiseAbs().maxCoeff()) > still;
  });
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

HalfStep::Acceleration HalfStep::acceleration(const World& world, std::size_t body) const {
  if (!world.bodies[body].movable()) return {Vec3::Zero(), Vec3::Zero()};
  return accelerations_.empty() ? Acceleration{world.gravity, Vec3::Zero()} : accelerations_[body];
}

void HalfStep::kick(World& world, Real h) const {
  for (std::size_t i = 0; i < world.bodies.size(); ++i) {
    Body& body = world.bodies[i];
    if (!body.movable()) continue;
    const Acceleration& by = acceleration(world, i);
    body.velocity += h * by.linear;
    if (!accelerations_.empty()) body.angular_velocity += h * by.angular;
  }
}

/// Joints, limits, motors and contacts: Newton's method, and where that does not get there, sweeps first. What is left at best comes
/// from places, which are rounded, and become speeds when they are divided by h.
bool HalfStep::solve_together(World& world, Real h) {
  constexpr bool fine = std::numeric_limits<Real>::digits > 24;
  constexpr double rounding = fine ? 1e-14 : 1e-7;                        // m
  constexpr double well = fine ? 1e-8 : 1e-4, just = fine ? 1e-6 : 1e-3;  // m/s: what is accepted at once, and at last
  Real fastest = 1;                                                       // m/s
  for (const Body& body : world.bodies) fastest = std::max(fastest, body.velocity.cwiseAbs().maxCoeff());
  const double enough = rounding * (100 * static_cast<double>(fastest) + 1 / std::abs(static_cast<double>(h)));
  together_.forget();  // limits and motors change sides from stage to stage
  for (const int sweeps : {0, 20, 100, 500}) {
    together_.sweep(sweeps);
    if (together_.solve(world, enough) || together_.off() <= well) return true;
  }
  return together_.off() <= just;
}

/// The first stage, and the drift. False where it cannot be solved.
bool HalfStep::press(World& world, Real h) {
  const bool together = holds_together();
  if (together) {
    joints_.aim(world, time_, h);
    if (!alone_) contacts_.begin_pressing(world, h);
  } else if (!alone_) contacts_.press(world, h);
  joints_.start(h);
  const auto add_all = [&] {
    together_.clear();
    joints_.add_to(together_, false);
    if (!alone_) contacts_.add_to(together_, world);
  };
  const auto let_law_find_out = [&] {
    if (alone_) return false;
    contacts_.take(world);
    contacts_.find_out();
    add_all();
    return solve_together(world, h);
  };
  if (together) add_all();
  keep(world, before_);
  Real off = std::numeric_limits<Real>::infinity();
  for (int round = 0;; ++round) {
    for (Body& body : world.bodies) drift(body, h);
    const Real off_before = off;
    off = joints_.ask(world, time_ + h);
    if (together && round == 0) {
      off = std::numeric_limits<Real>::infinity();  // contacts and limits have not been asked yet
    } else {
      if (off <= tolerance) break;
      // Each round leaves a part of what was off; where that is most of it, the step is too large.
      if (round == most_rounds || !(off < off_before / 2)) return false;
    }
    give(world, before_);
    if (together) {
      joints_.aim_rigid(h);
      if (!solve_together(world, h) && !let_law_find_out()) return false;
      if (!alone_) contacts_.take(world);
      while (!alone_ && contacts_.turns_back(world)) {
        add_all();
        if (!solve_together(world, h) && !let_law_find_out()) return false;
        contacts_.take(world);
      }
    } else {
      joints_.press(h);
    }
    keep(world, before_);
    ++rounds_;
  }
  off_ = std::max(off_, off / std::abs(h));
  joints_.pressed();
  if (together && !alone_) {
    contacts_.end_pressing(world, h);
  }
  return true;
}

/// The second stage.
void HalfStep::project(World& world, Real h) {
  if (!holds_together()) {
    if (!alone_) contacts_.project(world, h);
    joints_.project(h);
    return;
  }
  joints_.settle(h);
  joints_.start(h);
  together_.clear();
  joints_.add_to(together_, true);
  if (!alone_) {
    contacts_.begin_projecting(world, h);
    contacts_.add_to(together_, world);
  }
  if (!solve_together(world, h))
    throw InvalidInput(
        fmt::format("joints and contacts together leave {} m/s: more substeps are needed", together_.off()));
  joints_.projected(h);
  if (!alone_) {
    contacts_.take(world);
    contacts_.end_projecting(world, h);
  }
}

bool HalfStep::strike(World& world, const Contacts& contacts, Rows& rows, Real h) {
  together_.clear();
  joints_.strike(together_);
  const std::size_t count = contacts.size();
  for (std::size_t k = 0; k < count; ++k)
    together_.add_contact(rows[k], rows[count + 2 * k], rows[count + 2 * k + 1], contacts[k].friction);
  const bool solved = solve_together(world, h);
  joints_.struck();
  return solved;
}

/// False where Newton's method does not get there: then all is as it was. The rows are placed where the bodies are, before and
/// after.
bool HalfStep::step(World& world, Real h) {
  keep(world, begun_);
  if (!alone_) contacts_.look(world);
  joints_.pull(world, h);
  kick(world, h / 2);
  if (!press(world, h)) {
    give(world, begun_);
    return false;
  }
  const bool moved = moves(world, h);
  time_ += h;
  for (Body& body : world.bodies)
    if (body.angular_velocity != Vec3::Zero()) body.refresh_inertia();
  accelerate(world);
  kick(world, h / 2);
  if (!alone_ && moved) detect_contacts(world, h);
  joints_.place(world, time_, h);
  joints_.pull_on(h);
  project(world, h);
  return true;
}

void HalfStep::spend(double work) {
  together_.work -= work;
  if (!(together_.work > 0)) throw InvalidInput(fmt::format("a step takes more than {} multiplications", most_work));
}

void HalfStep::halve(World& world, Real h, int halvings) {
  if (step(world, h)) return;
  spend(0);
  if (halvings == most_halvings)
    throw InvalidInput(fmt::format("{} cannot be held in {} steps of {} s: more substeps are needed",
                                   world.joints[joints_.worst()].name, 1 << halvings, h));
  ++halvings_;
  halve(world, h / 2, halvings + 1);
  halve(world, h / 2, halvings + 1);
}

void HalfStep::advance(World& world, Real h) {
  halve(world, h, 0);
}

void HalfStep::solve(World& world, Real h, int /*sweeps*/) {
  for (Body& body : world.bodies) {
    body.velocity = body.velocity_before;
    body.angular_velocity = body.angular_velocity_before;
  }
  time_ = world.time;
  off_ = 0;
  halvings_ = rounds_ = 0;
  together_.work = most_work;
  keep(world, after_);
  accelerate(world);
  joints_.begin(world);
  const Real of_substep = h / static_cast<Real>(substeps);
  alone_ = true;
  if (holds_contacts()) begin_contacts(world, h);
  joints_.place(world, time_, of_substep);
  try {
    for (int i = 0; i < substeps; ++i)
      for (const Real part : parts()) advance(world, part * of_substep);
  } catch (const InvalidInput&) {
    give(world, after_);
    for (Body& body : world.bodies) body.refresh_inertia();
    throw;
  }
  joints_.report(world);
  if (!alone_) contacts_.report(world);
  keep(world, after_);
  for (Body& body : world.bodies) {
    body.velocity.setZero();
    body.angular_velocity.setZero();
  }
}

void HalfStep::done(World& world) {
  if (!alone_) contacts_.report_sums(world);
}

void HalfStep::moved(World& world, Real /*h*/) {
  give(world, after_);
}

}  // namespace pushback
