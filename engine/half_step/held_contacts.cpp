#include "pushback/engine/half_step/held_contacts.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "pushback/common/basics/input.h"
#include "pushback/common/world/measure.h"

namespace pushback {

namespace {

constexpr bool in_doubles = std::numeric_limits<Real>::digits > 24;
constexpr Real level = in_doubles ? Real(1e-11) : Real(1e-6);  // m: a gap that is rounding of places, and stays
constexpr Real creeps = in_doubles ? Real(1e-9) : Real(1e-4);  // m/s; a slower contact sticks
constexpr double least_matrices = 8;                           // a cold start takes ten to twenty matrices
constexpr Real solved = in_doubles ? Real(1e-6) : Real(1e-3);  // m/s

/// Along the normal and both tangents.
Vec3 components(const Vec3& impulse, const Vec3& normal) {
  const auto [tangent1, tangent2] = tangents_of(normal);
  return {impulse.dot(normal), impulse.dot(tangent1), impulse.dot(tangent2)};
}

/// m/s, world axes, `arm` from the body's centre: the mean speed there in a drift of h, less that as it begins. A ball whose moments of
/// inertia differ changes w as it flies, and its arm stays.
Vec3 gained_in_drift(const Body& body, const Vec3& arm, Real h) {
  const Vec3 &w = body.angular_velocity, &inverse = body.principal_inverse_inertia;
  const bool ball = std::holds_alternative<Sphere>(body.shape);
  if (!ball || inverse.maxCoeff() == inverse.minCoeff() || w.isZero(0)) return Vec3::Zero();
  return -h / 2 * (body.inverse_inertia * w.cross(spin_momentum(body))).cross(arm);
}

}  // namespace

WarmDirectContacts exact_direct_contacts() {
  WarmDirectContacts direct;
  direct.tolerance = in_doubles ? 1e-11 : 1e-5;
  direct.fallback_tolerance = in_doubles ? 1e-8 : 1e-4;
  direct.rounds = 6;
  return direct;
}

bool HeldContacts::holds(const ContactId& id) const {
  return !held_pairs || std::binary_search(held_pairs->begin(), held_pairs->end(),
                                           BodyPair(static_cast<int>(id.body_a), static_cast<int>(id.body_b)));
}

void HeldContacts::add_loads(const World& world, std::vector<Vec3>& accelerations) const {
  for (const ContactMemory& known : known_) {
    if (known.load.isZero(0) || !holds(known.id)) continue;
    accelerations[known.id.body_a] -= world.bodies[known.id.body_a].inverse_mass * known.load;
    accelerations[known.id.body_b] += world.bodies[known.id.body_b].inverse_mass * known.load;
  }
}

void HeldContacts::store_approach(const World& world) {
  for (std::size_t i = 0; i < known_.size(); ++i) {
    const Contact& contact = world.contacts[i];
    const auto [a, b] = world.bodies_of(contact);
    const Vec3 speed = b.velocity_at(contact.point) - a.velocity_at(contact.point);
    known_[i].approach = speed.dot(contact.normal);
    known_[i].slip = speed - known_[i].approach * contact.normal;
  }
}

void HeldContacts::begin(const World& world) {
  newton_.work_left = most_work;
  newton_.most_matrix_work = most_work / least_matrices;
  newton_.small_error = 1e-3;
  newton_.discard_matrix();
  newton_.factorizations = 0;
  newton_.too_large = false;
  known_.clear();
  sums_.clear();
  auto old = world.contacts_before.begin();  // both lists ascend, so go through them in parallel
  for (const Contact& contact : world.contacts) {
    ContactMemory& known = known_.emplace_back(ContactMemory{.id = contact.id});
    while (old != world.contacts_before.end() && old->id < contact.id) ++old;
    if (old != world.contacts_before.end() && old->id == contact.id) known.load = world.impulse_scale(1) * old->impulse;
  }
}

void HeldContacts::add_impact(const World& world, std::size_t contact, const Vec3& impulses) {
  known_[contact].total += impulses;
  const Vec3& n = world.contacts[contact].normal;
  const auto [tangent1, tangent2] = tangents_of(n);
  sums_.add(world.contacts[contact], impulses[0] * n + impulses[1] * tangent1 + impulses[2] * tangent2,
            known_[contact].sum);
}

void HeldContacts::after_detection(const World& world) {
  known_before_.swap(known_);
  known_.clear();
  auto old = known_before_.begin();
  for (const Contact& contact : world.contacts) {
    while (old != known_before_.end() && old->id < contact.id) ++old;
    if (old != known_before_.end() && old->id == contact.id) {
      known_.push_back(*old);
      continue;
    }
    known_.push_back({.id = contact.id});  // new since the step began, so this is its approach speed
    known_.back().approach = separating_speed(world, contact);
  }
}

/// The impulses of the stage before are the guess. Solves from there, if the guess is not the solution.
bool HeldContacts::solve(World& world, Real h) {
  const double residual = stage_.residual(world), before = std::exchange(previous_residual_, 0);
  if (residual <= direct_.tolerance) {
    previous_residual_ = residual * stage_.unit();
    return true;
  }
  const double arose = 1 - std::min(before / (residual * stage_.unit()), direct_.tolerance / residual);
  adopted_fraction_ = std::min(1.0, 2 * arose);  // both stages of a substep give the next guess half of it
  do {
    newton_.clear();
    stage_.add_to(newton_, world);
    newton_.solve(world, direct_.tolerance * stage_.unit() / 16, direct_.fallback_tolerance * stage_.unit() / 16);
    stage_.read_rows(world);
  } while (stage_.release_reversed(world));
  if (stage_.residual(world) <= direct_.fallback_tolerance) return true;
  if (fall_back_to_full_solve && !newton_.too_large) return solve_without_guess(world, h);
  failure_ = newton_.too_large
                 ? WarmDirectContacts::too_large_message(stage_.size())
                 : fmt::format("{} contacts are not solved from the loads of the previous step", stage_.size());
  return false;
}

/// As chapter 17 does.
bool HeldContacts::solve_without_guess(World& world, Real h) {
  stage_.release_all();
  stage_.build_rows(world);
  touching_.clear();
  for (const StageContact& at : stage_) touching_.push_back(world.contacts[at.index]);
  world.contacts.swap(touching_);  // chapter 17 solves the contacts of the world
  StepContext step{world, world.contacts, stage_.rows(), h};
  direct_.work = newton_.work_left;
  failure_ = direct_.try_start(step) ? "" : WarmDirectContacts::too_large_message(stage_.size());
  for (std::size_t k = 0; k < stage_.size() && failure_.empty(); ++k) {
    const ContactId& id = world.contacts[k].id;
    if (!(step.speed_error(k) > -solved))
      failure_ = fmt::format("where bodies {} and {} touch, {} m/s are left: half steps need solved contacts",
                             id.body_a, id.body_b, -step.speed_error(k));
  }
  world.contacts.swap(touching_);
  if (!failure_.empty()) return false;
  newton_.work_left = direct_.work;
  stage_.read_rows(world);
  return true;
}

bool HeldContacts::solve_positions(World& world, Real h) {
  begin_positions(world, h);
  if (!solve(world, h)) return false;
  end_positions(world, h);
  return true;
}

bool HeldContacts::solve_velocities(World& world, Real h) {
  begin_velocities(world, h);
  if (!solve(world, h)) return false;
  end_velocities(world, h);
  return true;
}

/// What overlaps comes out by a tenth in a hundredth of a second, or no faster than the second half of the kick takes back: h g / 4.
/// Its speed is lost to friction, so slowly is better than at once.
void HeldContacts::begin_positions(World& world, Real h) {
  const Real fastest = h * world.gravity.norm() / 4;
  double left = 0;
  stage_.clear();
  for (std::size_t i = 0; i < known_.size(); ++i) {
    known_[i].pressed = false;
    if (!holds(known_[i].id)) {
      known_[i].load.setZero();
      continue;
    }
    const Real depth = world.contacts[i].depth, gap = std::abs(depth) > level ? -depth : 0;
    const Real slip = known_[i].slip.norm();
    const bool slides = slip > creeps && world.contacts[i].friction > 0;
    const Real bias = (gap < 0 ? -std::min({-gap / h, -10 * gap, fastest}) : gap / h) - known_[i].deepening / h;
    known_[i].deepening = 0;
    const Vec3& n = world.contacts[i].normal;
    StageContact at{i, bias, Vec3::Zero(), h / 2 * known_[i].load, slides ? Vec3(known_[i].slip / slip) : Vec3::Zero()};
    if (!slides && world.contacts[i].friction != 0) {
      const auto [a, b] = world.bodies_of(world.contacts[i]);
      const Vec3& point = world.contacts[i].point;
      const Vec3 gained = gained_in_drift(b, point - b.position, h) - gained_in_drift(a, point - a.position, h);
      at.tangential_bias = gained - gained.dot(n) * n;
    }
    const Vec3 speed = (known_[i].approach + bias) * n + known_[i].slip + at.tangential_bias;
    left = std::max(left, static_cast<double>(squared_error(world.contacts[i], at, speed)));
    stage_.add(at);
  }
  stage_.apply_guess(world, direct_.tolerance);
  previous_residual_ = std::sqrt(left);
  adopted_fraction_ = 1;
}

/// N s: the impulse of the stage, without what takes back the errors of earlier stages.
Vec3 HeldContacts::adopted_impulse(const StageContact& at, Real h) const {
  if (adopted_fraction_ == 1) return at.impulse;
  const Vec3 guess = h / 2 * known_[at.index].load;
  return guess + static_cast<Real>(adopted_fraction_) * (at.impulse - guess);
}

void HeldContacts::end_positions(const World& world, Real h) {
  for (const StageContact& at : stage_) {
    ContactMemory& known = known_[at.index];
    known.position_impulse = adopted_impulse(at, h);
    known.total += components(known.position_impulse, world.contacts[at.index].normal);
    sums_.add(world.contacts[at.index], at.impulse, known.sum);
    if (known.load.isZero(0)) known.load = 2 / h * at.impulse;
    known.pressed = at.impulse.dot(world.contacts[at.index].normal) > 0;
  }
}

void HeldContacts::begin_velocities(World& world, Real h) {
  stage_.clear();
  for (std::size_t i = 0; i < known_.size(); ++i) {
    ContactMemory& known = known_[i];
    known.last.setZero();
    if (!holds(known.id) || (!known.pressed && world.contacts[i].depth <= -touch_distance)) {
      known.load.setZero();
      continue;
    }
    const bool bounces = known.approach < -threshold;
    const Real bias = bounces ? world.contacts[i].restitution * known.approach : 0;
    stage_.add({i, bias, Vec3::Zero(), h / 2 * known.load, Vec3::Zero()});
  }
  stage_.apply_guess(world, direct_.tolerance);
  adopted_fraction_ = 1;
}

void HeldContacts::end_velocities(const World& world, Real h) {
  for (const StageContact& at : stage_) {
    ContactMemory& known = known_[at.index];
    const Vec3 lasting = adopted_impulse(at, h);
    known.total += components(lasting, world.contacts[at.index].normal);
    sums_.add(world.contacts[at.index], at.impulse, known.sum);
    known.last = at.impulse;
    known.load = (known.position_impulse + lasting) / h;
  }
}

void HeldContacts::report(World& world) const {
  constexpr Real rounding = in_doubles ? Real(1e-6) : Real(1e-3);  // of what was drawn back to the cone
  for (std::size_t i = 0; i < known_.size(); ++i) {
    Contact& contact = world.contacts[i];
    const Vec3& total = known_[i].total;
    contact.impulse.setZero();
    if (total[0] <= 0) continue;
    const auto [tangent1, tangent2] = tangents_of(contact.normal);
    const Real most = contact.friction * total[0], rubbed = std::hypot(total[1], total[2]);
    const Real within = rubbed > most ? most / rubbed : 1;  // to rounding, each stage was
    contact.impulse = total[0] * contact.normal + within * (total[1] * tangent1 + total[2] * tangent2);
    const Real normal = known_[i].last.dot(contact.normal);
    const Real aside = (known_[i].last - normal * contact.normal).norm();
    if (normal <= 0 || contact.friction <= 0) continue;  // nothing sticks or slides
    contact.state = aside < (1 - rounding) * contact.friction * normal ? ContactState::sticking : ContactState::sliding;
  }
}

}  // namespace pushback
