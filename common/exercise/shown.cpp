#include "pushback/common/exercise/shown.h"

#include <algorithm>
#include <cmath>

namespace pushback {

namespace {

thread_local Recording* recording = nullptr;

constexpr std::size_t of_body = 14, of_contact = 12;
constexpr Real out_of_reach = Real(1e6);  // m, m/s, rad/s, N s

void add(Numbers& numbers, const Vec3& vector) {
  numbers.insert(numbers.end(), vector.data(), vector.data() + 3);
}

}  // namespace

Recording::Recording() : outer_(recording) {
  recording = this;
}

Recording::~Recording() {
  recording = outer_;
}

void Recording::keep(const World& world, const std::vector<std::size_t>& quantities) {
  const auto off_stride = [this](const Instant& instant) { return instant.number % stride_ != 0; };
  if (!instants_.empty() && off_stride(instants_.back()))
    instants_.pop_back();  // was there only because it was the last
  Instant instant{shown_++, quantities, {}};
  instant.world.bodies = world.bodies;
  instant.world.contacts = world.contacts;
  instant.world.joints = world.joints;
  instant.world.time = world.time;
  instants_.push_back(std::move(instant));
  if (instants_.size() <= most_instants) return;
  stride_ *= 2;
  instants_.erase(std::remove_if(instants_.begin(), instants_.end() - 1, off_stride), instants_.end() - 1);
}

void show(const World& world, const std::vector<std::size_t>& quantities) {
  if (recording) recording->keep(world, quantities);
}

Numbers numbers_of(const Instant& instant) {
  Numbers numbers{static_cast<Real>(instant.number)};
  for (const Body& body : instant.world.bodies) {
    add(numbers, body.position);
    const auto& turn = body.orientation.coeffs();
    numbers.insert(numbers.end(), turn.data(), turn.data() + 4);
    add(numbers, body.velocity);
    add(numbers, body.angular_velocity);
    numbers.push_back(body.asleep ? 1 : 0);
  }
  for (const Contact& contact : instant.world.contacts) {
    add(numbers, contact.point);
    add(numbers, contact.normal);
    add(numbers, contact.impulse);
    for (const auto name : {contact.id.body_a, contact.id.body_b, static_cast<std::uint32_t>(contact.state)})
      numbers.push_back(static_cast<Real>(name));
  }
  return numbers;
}

std::optional<World> with_numbers(World right, const Numbers& numbers) {
  const std::size_t bodies = 1 + of_body * right.bodies.size();
  if (right.bodies.empty() || numbers.size() < bodies || (numbers.size() - bodies) % of_contact != 0 ||
      (numbers.size() - bodies) / of_contact > most_contacts)
    return std::nullopt;
  const auto reachable = [](Real value) { return std::abs(value) < out_of_reach; };  // false of NaN
  if (!std::all_of(numbers.begin(), numbers.end(), reachable)) return std::nullopt;
  const Real* next = numbers.data() + 1;
  for (Body& body : right.bodies) {
    const Real* at = next;
    next += of_body;
    if (!body.movable()) continue;
    body.position = {at[0], at[1], at[2]};
    const Quat turn(at[6], at[3], at[4], at[5]);
    if (turn.norm() < Real(1e-3)) return std::nullopt;
    body.orientation = turn.normalized();
    body.velocity = {at[7], at[8], at[9]};
    body.angular_velocity = {at[10], at[11], at[12]};
    body.asleep = at[13] > 0;
  }
  right.contacts.resize((numbers.size() - bodies) / of_contact);
  for (Contact& contact : right.contacts) {
    const Real* at = next;
    next += of_contact;
    contact.point = {at[0], at[1], at[2]};
    contact.normal = {at[3], at[4], at[5]};
    contact.impulse = {at[6], at[7], at[8]};
    const auto at_most = [](Real number, std::size_t most) {
      return static_cast<std::uint32_t>(std::clamp(number, Real(0), static_cast<Real>(most)));
    };
    contact.id = {at_most(at[9], right.bodies.size() - 1), at_most(at[10], right.bodies.size() - 1), 0};
    contact.state = static_cast<ContactState>(at_most(at[11], 3));
  }
  return right;
}

}  // namespace pushback
