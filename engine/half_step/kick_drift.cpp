#include "pushback/engine/half_step/kick_drift.h"

#include <algorithm>
#include <tuple>

#include "pushback/common/basics/input.h"
#include "pushback/common/collision/collide.h"

namespace pushback {

namespace {

constexpr bool in_double = std::numeric_limits<Real>::digits > 24;

/// Whether a drift moves any body by more than rounding. If not, contacts stay as they are.
bool moves(const World& world, Real h) {
  constexpr Real still = in_double ? Real(1e-13) : Real(1e-8);  // m or rad
  return std::any_of(world.bodies.begin(), world.bodies.end(), [h](const Body& body) {
    return !body.conveys &&
           h * (body.velocity.cwiseAbs().maxCoeff() + body.angular_velocity.cwiseAbs().maxCoeff()) > still;
  });
}

}  // namespace

/// A body that spins about one of its principal axes turns evenly. `spin_freely` would find the same by Newton's method each time.
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

KickDrift::Snapshot KickDrift::snapshot(const World& world) const {
  return {world.bodies, world.contacts, contacts, joints_, accelerations_, time_};
}

/// Rows point to bodies, so the bodies stay where they are in memory.
void KickDrift::restore(World& world, const Snapshot& snapshot) {
  std::copy(snapshot.bodies.begin(), snapshot.bodies.end(), world.bodies.begin());
  world.contacts = snapshot.contacts;
  contacts = snapshot.held;
  joints_ = snapshot.joints;
  accelerations_ = snapshot.accelerations;
  time_ = snapshot.time;
}

void KickDrift::check(const World& world, bool backwards) {
  contacts.threshold = settings.threshold;
  contacts.most_work = settings.most_work;
  contacts.fall_back_to_full_solve = settings.fall_back_to_full_solve;
  for (const Body& body : world.bodies)
    if (body.asleep) throw InvalidInput("a body is asleep: half steps do not let bodies sleep");
  joints_.check(world, backwards);
  by_hand_.clear();
  const auto feels = [](const Body& body) { return body.force != Vec3::Zero() || body.torque != Vec3::Zero(); };
  if (std::none_of(world.bodies.begin(), world.bodies.end(), feels)) return;
  for (const Body& body : world.bodies) by_hand_.emplace_back(body.force, body.torque);
}

void KickDrift::begin(World& world, Real h, bool with_contacts) {
  failure.clear();
  time_ = world.time;
  speed_error_ = 0;
  halvings_ = rounds_ = 0;
  together_.work_left = settings.most_work;
  accelerate(world);
  joints_.begin(world);
  contact_free = true;
  detected_ahead = false;
  if (!cuts) contacts.held_pairs.reset();
  if (with_contacts) {
    // The plan's margin, with which contacts were detected, is for the Earth's gravity.
    const Real gravity = world.gravity.norm();
    if (!cuts && gravity > World::g) world.find_contacts(margin(gravity, h));
    contact_free = !cuts && world.contacts.empty();
    contacts.begin(world);
  }
  joints_.build_rows(world, time_, h / static_cast<Real>(settings.substeps));
}

void KickDrift::report(World& world) {
  joints_.report(world);
  if (!contact_free) contacts.report(world);
}

Margin KickDrift::margin(Real gravity, Real h) {
  return {.least = Real(1e-3) + h * h * gravity, .ahead = 2 * h, .where_nearest = true};
}

/// If a pair is held, each of its points that may touch next has to be known. If none is, all bodies have flown, and ImpactCuts knows
/// which pairs may have met.
void KickDrift::detect_contacts(World& world, Real h) {
  detected_ahead = !cuts || !contacts.held_pairs || !contacts.held_pairs->empty();
  if (detected_ahead) {
    world.find_contacts(margin(world.gravity.norm(), h));
  } else {
    world.contacts.clear();
    for (const auto& [first, second] : near_pairs)
      collide(world.body(first), world.body(second), world.contacts, {.least = HeldContacts::touch_distance});
  }
  contacts.after_detection(world);
}

void KickDrift::detect_ahead(World& world, Real h) {
  detected_ahead = true;
  world.find_contacts(margin(world.gravity.norm(), h));
  contacts.after_detection(world);
  contacts.store_approach(world);
}

/// Where the bodies are.
void KickDrift::accelerate(World& world) {
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

KickDrift::Acceleration KickDrift::acceleration(const World& world, std::size_t body) const {
  if (!world.bodies[body].movable()) return {Vec3::Zero(), Vec3::Zero()};
  return accelerations_.empty() ? Acceleration{world.gravity, Vec3::Zero()} : accelerations_[body];
}

void KickDrift::kick(World& world, Real h) const {
  for (std::size_t i = 0; i < world.bodies.size(); ++i) {
    Body& body = world.bodies[i];
    if (!body.movable()) continue;
    const Acceleration& by = acceleration(world, i);
    body.velocity += h * by.linear;
    if (!accelerations_.empty()) body.angular_velocity += h * by.angular;
  }
}

/// Whether a stage is more than one linear system of joints, or contacts without joints.
bool KickDrift::solved_together() const {
  return !joints_.linear() || (!joints_.empty() && !contact_free);
}

void KickDrift::collect_rows(World& world) {
  together_.clear();
  joints_.add_to(together_, false);
  if (!contact_free) contacts.add_to(together_, world);
}

/// Joints, limits, motors and contacts: Newton's method, and sweeps first where that fails. The error that is left at best comes from
/// positions, which are rounded, and become speeds when they are divided by h.
bool KickDrift::solve_together(World& world, Real h) {
  constexpr double rounding = in_double ? 1e-14 : 1e-7;  // m
  constexpr double well = in_double ? 1e-8 : 1e-4,
                   acceptable = in_double ? 1e-6 : 1e-3;  // m/s: accepted at once, and at last
  Real fastest = 1;                                       // m/s
  for (const Body& body : world.bodies) fastest = std::max(fastest, body.velocity.cwiseAbs().maxCoeff());
  const double enough = rounding * (100 * static_cast<double>(fastest) + 1 / std::abs(static_cast<double>(h)));
  together_.discard_matrix();  // limits and motors change sides from stage to stage
  for (const int sweeps : {0, 20, 100, 500}) {
    together_.sweep(sweeps);
    if (together_.solve(world, enough) || together_.largest_error() <= well) return true;
  }
  return together_.largest_error() <= acceptable;
}

/// Solves again without a given direction of slip.
bool KickDrift::solve_without_slip_directions(World& world, Real h) {
  if (contact_free) return false;
  contacts.read_rows(world);
  contacts.release_all();
  collect_rows(world);
  return solve_together(world, h);
}

bool KickDrift::solve_positions_together(World& world, Real h) {
  joints_.prepare_rigid(h);
  if (!solve_together(world, h) && !solve_without_slip_directions(world, h)) return false;
  if (!contact_free) contacts.read_rows(world);
  while (!contact_free && contacts.release_reversed(world)) {
    collect_rows(world);
    if (!solve_together(world, h) && !solve_without_slip_directions(world, h)) return false;
    contacts.read_rows(world);
  }
  return true;
}

/// The first stage, and the drift.
bool KickDrift::solve_positions(World& world, Real h) {
  const bool together = solved_together();
  if (together) {
    joints_.prepare_positions(world, time_, h);
    if (!contact_free) contacts.begin_positions(world, h);
  } else if (!contact_free && !contacts.solve_positions(world, h)) {
    failure = contacts.failure();
    return false;
  }
  joints_.warm_start(h);
  if (together) collect_rows(world);
  save_states(world, before_drift);
  Real off = std::numeric_limits<Real>::infinity();
  for (int round = 0;; ++round) {
    for (Body& body : world.bodies) drift(body, h);
    const Real off_before = off;
    off = joints_.evaluate(world, time_ + h);
    if (together && round == 0) {
      off = std::numeric_limits<Real>::infinity();  // contacts and limits have not been solved yet
    } else {
      if (off <= settings.tolerance) break;
      // Each round leaves a fraction of the error. If it leaves most of it, the step is too large.
      if (round == settings.most_rounds || !(off < off_before / 2)) return false;
    }
    restore_states(world, before_drift);
    if (!together) joints_.solve_positions(h);
    else if (!solve_positions_together(world, h)) return false;
    save_states(world, before_drift);
    ++rounds_;
  }
  speed_error_ = std::max(speed_error_, off / std::abs(h));
  joints_.end_positions();
  if (together && !contact_free) contacts.end_positions(world, h);
  return true;
}

/// The second stage.
bool KickDrift::solve_velocities(World& world, Real h) {
  if (!solved_together()) {
    if (!contact_free && !contacts.solve_velocities(world, h)) {
      failure = contacts.failure();
      return false;
    }
    joints_.solve_velocities(h);
    return true;
  }
  joints_.prepare_velocities(h);
  joints_.warm_start(h);
  together_.clear();
  joints_.add_to(together_, true);
  if (!contact_free) {
    contacts.begin_velocities(world, h);
    contacts.add_to(together_, world);
  }
  if (!solve_together(world, h)) {
    failure =
        fmt::format("joints and contacts together leave {} m/s: more substeps are needed", together_.largest_error());
    return false;
  }
  joints_.end_velocities(h);
  if (!contact_free) {
    contacts.read_rows(world);
    contacts.end_velocities(world, h);
  }
  return true;
}

bool KickDrift::solve_impact(World& world, const Contacts& at, Rows& rows, Real h) {
  together_.clear();
  joints_.add_impact_to(together_);
  const std::size_t count = at.size();
  for (std::size_t k = 0; k < count; ++k)
    together_.add_contact(rows[k], rows[count + 2 * k], rows[count + 2 * k + 1], at[k].friction);
  const bool solved = solve_together(world, h);
  joints_.end_impact();
  return solved;
}

/// Without a `failure`, false means that h is too long, and that everything is as it was. Rows are placed where the bodies are, before
/// and after.
bool KickDrift::step(World& world, Real h) {
  save_states(world, begun_);
  if (!contact_free) contacts.store_approach(world);
  failure = joints_.apply_springs_before_drift(world, h);
  if (!failure.empty()) return false;
  kick(world, h / 2);
  if (!solve_positions(world, h)) {
    if (failure.empty()) restore_states(world, begun_);
    return false;
  }
  const bool moved = moves(world, h);
  time_ += h;
  for (Body& body : world.bodies)
    if (body.angular_velocity != Vec3::Zero()) body.refresh_inertia();
  accelerate(world);
  kick(world, h / 2);
  if (!contact_free && moved) detect_contacts(world, h);
  joints_.build_rows(world, time_, h);
  joints_.apply_springs_after_drift(h);
  return solve_velocities(world, h);
}

bool KickDrift::spend(double work) {
  together_.work_left -= work;
  if (work_left() > 0) return true;
  failure = fmt::format("a step takes more than {} multiplications", settings.most_work);
  return false;
}

bool KickDrift::step_or_halve(World& world, Real h, int halvings) {
  if (step(world, h)) return true;
  if (!failure.empty() || !spend(0)) return false;
  if (halvings == settings.most_halvings) {
    failure = fmt::format("{} cannot be held in {} steps of {} s: more substeps are needed",
                          world.joints[joints_.worst()].name, 1 << halvings, h);
    return false;
  }
  ++halvings_;
  return step_or_halve(world, h / 2, halvings + 1) && step_or_halve(world, h / 2, halvings + 1);
}

}  // namespace pushback
