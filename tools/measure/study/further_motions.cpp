#include "pushback/tools/measure/study/further_motions.h"

#include <fmt/format.h>

#include <cmath>

#include "pushback/chapters/19_accuracy_and_time/truth.h"
#include "pushback/common/basics/input.h"

namespace pushback::further {

std::vector<Places> places_of_kicked(const World& begin, const std::vector<Kick>& kicks, int frames) {
  std::vector<Places> found;
  for (int frame = 1; frame <= frames; ++frame) {
    const double t = static_cast<double>(frame) / frames_per_second;
    Places places;
    for (const Body& body : begin.bodies) {
      places.emplace_back(body.position.cast<double>());
      if (!body.movable()) continue;
      places.back() += t * body.velocity.cast<double>();
      if (!begin.gravity.isZero(0)) places.back().y() -= truth::g * t * t / 2;  // g in double, also where Real is float
    }
    for (const Kick& kick : kicks)
      if (kick.time < t) places[kick.body] += (t - kick.time) * kick.velocity;
    found.push_back(places);
  }
  return found;
}

namespace {

void check_number(std::size_t impacts, double now) {
  constexpr std::size_t most = 1000;
  if (impacts >= most)
    throw InvalidInput(fmt::format("{} impacts in {} s: at most {} are followed", impacts, now, most));
}

}  // namespace

std::vector<Meeting> RowOfBalls::meetings(double until) const {
  std::vector<double> x = places, v = velocities;
  std::vector<Meeting> found;
  double now = 0;
  while (true) {
    double wait = until - now;
    std::size_t first = x.size();
    for (std::size_t i = 0; i + 1 < x.size(); ++i) {
      if (v[i] <= v[i + 1]) continue;  // also the two that have just met
      const double meets = (x[i + 1] - x[i] - 2 * radius) / (v[i] - v[i + 1]);
      if (meets >= wait) continue;
      wait = meets;
      first = i;
    }
    if (first == x.size()) return found;
    check_number(found.size(), now);
    for (std::size_t i = 0; i < x.size(); ++i) x[i] += wait * v[i];
    now += wait;
    const double m1 = masses[first], m2 = masses[first + 1], closing = v[first] - v[first + 1];
    const double impulse = (1 + e) * m1 * m2 / (m1 + m2) * closing;
    v[first] -= impulse / m1;
    v[first + 1] += impulse / m2;
    found.push_back({now, first, closing, impulse});
  }
}

void Gaps::operator()(World& world) const {
  world.gravity.setZero();
  const RowOfBalls balls = row();
  for (std::size_t i = 0; i < masses.size(); ++i)
    world.add(sphere(radius, masses[i])
                  .at({static_cast<Real>(balls.places[i]), 0, 0})
                  .moving({static_cast<Real>(balls.velocities[i]), 0, 0})
                  .rough(0)
                  .bouncy(e));
}

RowOfBalls Gaps::row() {
  RowOfBalls row{{masses.begin(), masses.end()},
                 {0},
                 {static_cast<double>(speed)},
                 static_cast<double>(radius),
                 static_cast<double>(e)};
  for (const Real gap : gaps) {
    row.places.push_back(row.places.back() + 2 * row.radius + static_cast<double>(gap));
    row.velocities.push_back(0);
  }
  return row;
}

std::vector<Places> Gaps::truth(int frames) const {
  World world;
  (*this)(world);
  const RowOfBalls balls = row();
  std::vector<Kick> kicks;
  for (const Meeting& met : balls.meetings(static_cast<double>(frames) / frames_per_second)) {
    kicks.push_back({met.time, met.first, -met.impulse / balls.masses[met.first] * Eigen::Vector3d::UnitX()});
    kicks.push_back({met.time, met.first + 1, met.impulse / balls.masses[met.first + 1] * Eigen::Vector3d::UnitX()});
  }
  return places_of_kicked(world, kicks, frames);
}

namespace {

/// s until a ball that is this high above the floor (m) and rises with `speed` (m/s) is there, or is `room` (m) higher.
struct Flight {
  double seconds;
  bool ceiling;

  Flight(double height, double room, double speed) : ceiling(speed > 0 && speed * speed > 2 * truth::g * room) {
    if (ceiling) seconds = 2 * room / (speed + std::sqrt(speed * speed - 2 * truth::g * room));
    else seconds = (speed + std::sqrt(speed * speed + 2 * truth::g * height)) / truth::g;
  }
};

}  // namespace

std::vector<Bounce> BallBetweenPlates::bounces(double until) const {
  Eigen::Vector3d v = velocity, w = spin;
  std::vector<Bounce> found;
  double now = 0, above_floor = height - radius;
  const double room = apart - 2 * radius;
  while (true) {
    const Flight flight(above_floor, room - above_floor, v.y());
    if (now + flight.seconds >= until) return found;
    check_number(found.size(), now);
    now += flight.seconds;
    v.y() -= truth::g * flight.seconds;
    above_floor = flight.ceiling ? room : 0;
    const Eigen::Vector3d out = (flight.ceiling ? -1 : 1) * Eigen::Vector3d::UnitY(), arm = -radius * out;
    Eigen::Vector3d slip = v + w.cross(arm);
    slip.y() = 0;
    const double normal = (1 + e) * std::abs(v.y()), ends_slip = 2 * slip.norm() / 7;
    const bool sticks = ends_slip <= mu * normal;
    const Eigen::Vector3d rub = -(sticks ? ends_slip : mu * normal) * slip.normalized(), kick = normal * out + rub;
    const Eigen::Vector3d spin_after = w + 5 / (2 * radius * radius) * arm.cross(rub);  // I / m = 2/5 r^2
    found.push_back({now, flight.ceiling, sticks, v, w, slip, kick, spin_after});
    v += kick;
    w = spin_after;
  }
}

void Superball::operator()(World& world) const {
  const BallBetweenPlates given = ball();
  world.add(ground().rough(mu).bouncy(e));
  world.add(half_space(-Vec3::UnitY()).at({0, apart, 0}).rough(mu).bouncy(e));
  world.add(sphere(radius, 1)
                .at({0, static_cast<Real>(given.height), 0})
                .moving(given.velocity.cast<Real>())
                .spinning(given.spin.cast<Real>())
                .rough(mu)
                .bouncy(e));
}

BallBetweenPlates Superball::ball() {
  return {.radius = static_cast<double>(radius),
          .apart = static_cast<double>(apart),
          .mu = static_cast<double>(mu),
          .e = static_cast<double>(e),
          .height = 0.5,
          .velocity = {1.5, -6, 1},
          .spin = {-30, 4, -80}};
}

std::vector<Places> Superball::truth(int frames) const {
  World world;
  (*this)(world);
  std::vector<Kick> kicks;
  for (const Bounce& bounce : ball().bounces(static_cast<double>(frames) / frames_per_second))
    kicks.push_back({bounce.time, 2, bounce.kick});
  return places_of_kicked(world, kicks, frames);
}

void Conveyor::operator()(World& world) const {
  world.add(ground().rough(mu).conveying(belt()));
  world.add(box({Real(0.5), Real(0.2), Real(0.5)}, 100).at({0, Real(0.2), 0}).moving(velocity()).rough(mu));
}

std::vector<Places> Conveyor::truth(int frames) const {
  World world;
  (*this)(world);
  const Eigen::Vector3d carried = belt().cast<double>(), slip = velocity().cast<double>() - carried;
  std::vector<Places> found;
  for (int frame = 1; frame <= frames; ++frame) {
    const double t = static_cast<double>(frame) / frames_per_second;
    Places places;
    for (const Body& body : world.bodies) places.emplace_back(body.position.cast<double>());
    places.back() +=
        t * carried + truth::way_of_sliding(slip.norm(), static_cast<double>(mu) * truth::g, t) * slip.normalized();
    found.push_back(places);
  }
  return found;
}

}  // namespace pushback::further
