#include "pushback/tools/classroom/telling_instant.h"

#include <algorithm>
#include <cmath>

#include "pushback/common/collision/broad_phase.h"
#include "pushback/common/exercise/shown.h"

namespace pushback {

namespace {

constexpr Real slowest_seen = Real(1e-3);  // m/s, rad/s, N s: below, all is 0

Real part_of(Real difference, Real largest) {
  return difference / std::max(largest, slowest_seen);
}

/// Of the first check that fails the scene and the number that its sentence is about.
std::optional<TellingInstant> where_it_fails(const Exercise& exercise, std::uint64_t seed, const Attempt& outcome,
                                             const Verdict& verdict) {
  const auto first = std::find(verdict.checks.begin(), verdict.checks.end(), Passed::no);
  if (first == verdict.checks.end()) return std::nullopt;
  const std::size_t check = static_cast<std::size_t>(first - verdict.checks.begin());
  const NumbersOfScenes right = scenes_of(exercise.right, seed, check);
  const auto& quantities = exercise.checks[check].quantities;
  for (std::size_t scene = 0; scene < right.size(); ++scene) {
    std::size_t worst = 0;
    double most = 0;
    for (std::size_t i = 0; i < quantities.size(); ++i) {
      const Real yours = outcome.numbers[check][scene][i];
      const double off = std::isfinite(yours) ? std::abs(yours - right[scene][i]) / quantities[i].tolerance
                                              : std::numeric_limits<double>::infinity();
      if (off <= most) continue;
      most = off;
      worst = i;
    }
    if (most <= 1) continue;
    const std::string& unit = quantities[worst].unit;
    return TellingInstant{check, scene, worst, {}, {}, unit == "m" || unit == "mm" || unit == "mrad"};
  }
  return std::nullopt;
}

}  // namespace

Real Apart::to_be_seen() const {
  return std::max({std::min(place, Real(2)), std::min(turn, Real(1)), speed / 2, spin / 2, Real(0.3) * impulse, sleep});
}

Real size_of(const Body& body) {
  const Bounds bounds = bounds_of(body);
  return (bounds.high - bounds.low).maxCoeff();
}

Apart apart(const World& yours, const World& right) {
  Apart apart;
  Real fastest = 0, fastest_spin = 0, strongest = 0, speed = 0, spin = 0, impulse = 0;
  for (std::size_t i = 0; i < right.bodies.size(); ++i) {
    const Body &is = yours.bodies[i], &should_be = right.bodies[i];
    if (!should_be.movable()) continue;
    apart.place = std::max(apart.place, (is.position - should_be.position).norm() / size_of(should_be));
    apart.turn = std::max(apart.turn, is.orientation.angularDistance(should_be.orientation));
    if (is.asleep != should_be.asleep) apart.sleep = 1;
    speed = std::max(speed, (is.velocity - should_be.velocity).norm());
    spin = std::max(spin, (is.angular_velocity - should_be.angular_velocity).norm());
    for (const Body* body : {&is, &should_be}) {
      fastest = std::max(fastest, body->velocity.norm());
      fastest_spin = std::max(fastest_spin, body->angular_velocity.norm());
    }
  }
  for (const World* world : {&yours, &right})
    for (const Contact& contact : world->contacts) strongest = std::max(strongest, contact.impulse.norm());
  const bool comparable = yours.contacts.size() == right.contacts.size();
  for (std::size_t i = 0; comparable && i < right.contacts.size(); ++i)
    impulse = std::max(impulse, (yours.contacts[i].impulse - right.contacts[i].impulse).norm());
  apart.speed = part_of(speed, fastest);
  apart.spin = part_of(spin, fastest_spin);
  apart.impulse = comparable ? part_of(impulse, strongest) : 1;
  return apart;
}

std::optional<TellingInstant> telling_instant(const Exercise& exercise, std::uint64_t seed, const Attempt& outcome,
                                              const Verdict& verdict) {
  std::optional<TellingInstant> telling = where_it_fails(exercise, seed, outcome, verdict);
  if (!telling) return std::nullopt;
  const auto sent = outcome.shown.find({telling->check, telling->scene});
  if (sent == outcome.shown.end()) return std::nullopt;
  Random random = random_of(seed, telling->check, telling->scene);
  const Recording recording;
  exercise.right(telling->check, random);

  Real most = 0;
  for (const Instant& instant : recording.instants()) {
    const auto& measured = instant.quantities;
    if (!measured.empty() && std::count(measured.begin(), measured.end(), telling->quantity) == 0) continue;
    for (const Numbers& numbers : sent->second) {
      if (numbers.empty() || numbers[0] != static_cast<Real>(instant.number)) continue;
      const std::optional<World> yours = with_numbers(instant.world, numbers);
      if (!yours) continue;
      const Apart differing = apart(*yours, instant.world);
      Real seen = differing.to_be_seen();
      const Real off_place = std::max(differing.place, differing.turn);
      if (telling->of_place && off_place > Real(1e-5)) seen = 10 * off_place;  // before all that only moves
      if (seen < Real(1e-5) || seen < Real(0.98) * most) continue;             // of equals the last
      most = std::max(most, seen);
      telling->yours = *yours;
      telling->right = instant.world;
    }
  }
  if (most == 0) return std::nullopt;
  return telling;
}

}  // namespace pushback
