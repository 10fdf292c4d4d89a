#include "pushback/chapters/24_half_step/held_contacts.h"

#include <algorithm>

#include "pushback/common/basics/input.h"

namespace pushback {

namespace {

constexpr bool in_doubles = std::numeric_limits<Real>::digits > 24;
constexpr Real touches = in_doubles ? Real(1e-9) : Real(1e-5);  // m: a gap that is rounding
constexpr double most_work = 1e10;                              // multiplications in a step: see WarmDirectContacts
constexpr Real solved = in_doubles ? Real(1e-6) : Real(1e-3);   // m/s

}  // namespace

HeldContacts::HeldContacts() {
  direct_.tolerance = in_doubles ? 1e-11 : 1e-5;
  direct_.too_far = in_doubles ? 1e-8 : 1e-4;
  direct_.rounds = 6;
}

void HeldContacts::look(const World& world) {
  for (std::size_t i = 0; i < known_.size(); ++i) known_[i].approach = separating_speed(world, world.contacts[i]);
}

void HeldContacts::begin(World& world, const Margin& margin) {
  direct_.work = most_work;
  world.find_contacts(margin);
  known_.clear();
  auto old = world.contacts_before.begin();  // both lists ascend: walk them side by side
  for (const Contact& contact : world.contacts) {
    Known& known = known_.emplace_back(Known{.id = contact.id});
    while (old != world.contacts_before.end() && old->id < contact.id) ++old;
    if (old != world.contacts_before.end() && old->id == contact.id)
      known.borne = world.impulse_scale(1) * old->impulse;
  }
  look(world);
}

void HeldContacts::detect(World& world, const Margin& margin) {
  world.find_contacts(margin);
  known_before_.swap(known_);
  known_.clear();
  auto old = known_before_.begin();
  for (const Contact& contact : world.contacts) {
    while (old != known_before_.end() && old->id < contact.id) ++old;
    known_.push_back(old != known_before_.end() && old->id == contact.id ? *old : Known{.id = contact.id});
  }
}

void HeldContacts::place(World& world) {
  touching_.clear();
  rows_.clear();
  for (const std::size_t i : which_) touching_.push_back(world.contacts[i]);
  for (std::size_t k = 0; k < touching_.size(); ++k) rows_.emplace_back(world, touching_[k], touching_[k].normal, k);
  for (std::size_t k = 0; k < touching_.size(); ++k) {
    const auto [tangent1, tangent2] = tangents_of(touching_[k].normal);
    rows_.emplace_back(world, touching_[k], tangent1, k);
    rows_.emplace_back(world, touching_[k], tangent2, k);
  }
}

void HeldContacts::solve(World& world, Real h) {
  if (touching_.empty()) return;
  StepContext step{world, touching_, rows_, h};
  for (Row& row : rows_) row.reach(h / 2 * known_[which_[row.owner]].borne.dot(row.n));
  direct_.start(step);
  for (std::size_t k = 0; k < touching_.size(); ++k) {
    const ContactId& id = touching_[k].id;
    if (!(step.speed_error(k) > -solved))
      throw InvalidInput(fmt::format("where bodies {} and {} touch, {} m/s are left: half steps need solved contacts",
                                     id.body_a, id.body_b, -step.speed_error(k)));
  }
  for (const std::size_t i : which_) known_[i].borne.setZero();
  for (const Row& row : rows_) {
    Known& known = known_[which_[row.owner]];
    known.borne += 2 / h * row.impulse * row.n;
    known.total += row.impulse * row.n;
  }
}

/// What overlaps comes out no faster than the second half of the kick takes back: h g / 4.
void HeldContacts::press(World& world, Real h) {
  which_.resize(world.contacts.size());
  for (std::size_t i = 0; i < which_.size(); ++i) which_[i] = i;
  place(world);
  const Real fastest = h * world.gravity.norm() / 4;
  for (std::size_t i = 0; i < which_.size(); ++i) rows_[i].bias = std::max(-touching_[i].depth / h, -fastest);
  solve(world, h);
  for (std::size_t i = 0; i < which_.size(); ++i) known_[i].pressed = rows_[i].impulse > 0;
}

void HeldContacts::project(World& world, Real h) {
  which_.clear();
  for (std::size_t i = 0; i < known_.size(); ++i)
    if (known_[i].pressed || world.contacts[i].depth > -touches) which_.push_back(i);
    else known_[i].borne.setZero();
  place(world);
  for (std::size_t k = 0; k < which_.size(); ++k) {
    const Known& known = known_[which_[k]];
    if (known.approach < -threshold && known.pressed) rows_[k].bias = touching_[k].restitution * known.approach;
  }
  solve(world, h);
  look(world);
}

void HeldContacts::report(World& world) const {
  constexpr Real rounding = in_doubles ? Real(1e-6) : Real(1e-3);  // of what was drawn back to the cone
  for (std::size_t i = 0; i < known_.size(); ++i) {
    Contact& contact = world.contacts[i];
    contact.impulse = known_[i].total;
    const Real normal = known_[i].borne.dot(contact.normal);
    const Real aside = (known_[i].borne - normal * contact.normal).norm();
    if (normal <= 0) continue;
    contact.state = aside < (1 - rounding) * contact.friction * normal ? ContactState::sticking : ContactState::sliding;
  }
}

}  // namespace pushback
