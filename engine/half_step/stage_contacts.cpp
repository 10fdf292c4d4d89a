#include "pushback/engine/half_step/stage_contacts.h"

#include <algorithm>
#include <cmath>

#include "pushback/engine/direct/contact_problem.h"

namespace pushback {

namespace {

/// The impulse on B, N s, for each N s along the normal of a contact that slides in the direction `slip_direction`.
Vec3 sliding_impulse(const Contact& contact, const Vec3& slip_direction) {
  return contact.normal - contact.friction * slip_direction;
}

/// J v + b, m/s, world axes.
Vec3 speed_of(const World& world, const StageContact& at) {
  const Contact& contact = world.contacts[at.index];
  const auto [a, b] = world.bodies_of(contact);
  return b.velocity_at(contact.point) - a.velocity_at(contact.point) + at.bias * contact.normal + at.tangential_bias;
}

}  // namespace

Real squared_error(const Contact& contact, const StageContact& at, const Vec3& u) {
  const Vec3 &n = contact.normal, &r = at.impulse;
  const Real mu = contact.friction, r_n = r.dot(n), u_n = u.dot(n);
  if (at.slides()) {
    const Real error = r_n - std::max(Real(0), r_n - u_n);
    return error * error;
  }
  const Vec3 r_t = r - r_n * n, u_t = u - u_n * n;
  const Real s_n = u_n + mu * u_t.norm(), wanted_n = r_n - s_n;
  const Vec3 wanted_t = r_t - u_t;
  const bool outside = wanted_n < 0 || wanted_t.squaredNorm() > mu * mu * wanted_n * wanted_n;  // of the cone
  if (!outside) return s_n * s_n + u_t.squaredNorm();
  const Vec3 wanted(wanted_n, wanted_t.norm(), 0),
      nearest = projected_to_cone(wanted.cast<double>(), static_cast<double>(mu)).cast<Real>();
  const Vec3 way = wanted[1] > 0 ? Vec3(wanted_t / wanted[1]) : Vec3::Zero();
  return (r_n - nearest[0]) * (r_n - nearest[0]) + (r_t - nearest[1] * way).squaredNorm();
}

void StageContacts::apply_guess(World& world, double tolerance) {
  double largest = 0;
  for (const StageContact& at : contacts_)
    largest = std::max(largest, static_cast<double>(speed_of(world, at).squaredNorm()));
  Real fastest = 0;
  for (const Body& body : world.bodies) fastest = std::max(fastest, body.velocity.squaredNorm());
  const double rounding = 10 * std::numeric_limits<Real>::epsilon() * std::sqrt(static_cast<double>(fastest));
  unit_ = std::max(std::sqrt(largest), rounding / tolerance);
  for (StageContact& at : contacts_) {
    const Contact& contact = world.contacts[at.index];
    const auto [a, b] = world.bodies_of(contact);
    if (static_cast<double>(at.impulse.norm()) < tolerance * unit_) at.impulse.setZero();
    if (at.slides()) at.impulse = at.impulse.dot(contact.normal) * sliding_impulse(contact, at.slip_direction);
    a.velocity -= a.inverse_mass * at.impulse;
    a.angular_velocity -= a.inverse_inertia * (contact.point - a.position).cross(at.impulse);
    b.velocity += b.inverse_mass * at.impulse;
    b.angular_velocity += b.inverse_inertia * (contact.point - b.position).cross(at.impulse);
  }
}

double StageContacts::residual(const World& world) const {
  double largest = 0;
  for (const StageContact& at : contacts_) {
    const Contact& contact = world.contacts[at.index];
    const Vec3 speed = speed_of(world, at);
    if (at.slides() && speed.dot(at.slip_direction) < 0) return std::numeric_limits<double>::infinity();
    largest = std::max(largest, static_cast<double>(squared_error(contact, at, speed)));
  }
  return std::sqrt(largest) / (unit_ > 0 ? unit_ : 1);
}

void StageContacts::build_rows(World& world) {
  rows_.clear();
  const auto add = [&](std::size_t k, const Vec3& direction) {
    rows_.emplace_back(world, world.contacts[contacts_[k].index], direction, k);
    rows_.back().impulse = contacts_[k].impulse.dot(direction);
    rows_.back().bias = contacts_[k].tangential_bias.dot(direction);
  };
  for (std::size_t k = 0; k < contacts_.size(); ++k) {
    const StageContact& at = contacts_[k];
    const Contact& contact = world.contacts[at.index];
    add(k, contact.normal);
    Row& row = rows_.back();
    row.bias = at.bias;
    if (!at.slides()) continue;
    const Row tangent(world, contact, at.slip_direction, k);  // J is along n, M^-1 J^T along n - mu slip_direction
    row.dva -= contact.friction * tangent.dva;
    row.dwa -= contact.friction * tangent.dwa;
    row.dvb -= contact.friction * tangent.dvb;
    row.dwb -= contact.friction * tangent.dwb;
  }
  for (std::size_t k = 0; k < contacts_.size(); ++k) {
    if (contacts_[k].slides()) continue;
    const auto [tangent1, tangent2] = tangents_of(world.contacts[contacts_[k].index].normal);
    add(k, tangent1);
    add(k, tangent2);
  }
}

void StageContacts::add_to(NewtonFromGuess& newton, World& world) {
  build_rows(world);
  std::size_t tangent = contacts_.size();
  for (std::size_t k = 0; k < contacts_.size(); ++k) {
    if (contacts_[k].slides()) {
      newton.add_normal(rows_[k]);
      continue;
    }
    newton.add_contact(rows_[k], rows_[tangent], rows_[tangent + 1], world.contacts[contacts_[k].index].friction);
    tangent += 2;
  }
}

void StageContacts::read_rows(const World& world) {
  for (StageContact& at : contacts_) at.impulse.setZero();
  for (const Row& row : rows_) {
    StageContact& at = contacts_[row.owner];
    at.impulse += row.impulse * (at.slides() ? sliding_impulse(world.contacts[at.index], at.slip_direction) : row.n);
  }
}

bool StageContacts::release_reversed(const World& world) {
  bool any = false;
  for (StageContact& at : contacts_) {
    if (!at.slides()) continue;
    if (speed_of(world, at).dot(at.slip_direction) >= 0) continue;
    at.slip_direction.setZero();
    any = true;
  }
  return any;
}

void StageContacts::release_all() {
  for (StageContact& at : contacts_) at.slip_direction.setZero();
}

}  // namespace pushback
