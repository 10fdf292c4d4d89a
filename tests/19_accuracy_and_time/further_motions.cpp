/// The study's motions that are of no chapter: what their closed forms conserve, and solvers that come to the same.
#include <cmath>
#include <numeric>
#include <random>

#include "pushback/chapters/08_friction_cone/friction_cone.h"
#include "pushback/chapters/19_accuracy_and_time/truth.h"
#include "pushback/chapters/25_moment_of_impact/at_impacts.h"
#include "pushback/tools/measure/study/every_motion.h"
#include "pushback/tools/measure/study/further_motions.h"
#include "tests/support/catch.h"

using namespace pushback;
using namespace pushback::further;

namespace {

constexpr double frame = 1.0 / frames_per_second;

/// m, the farthest that any body was from its true place in any frame.
template <class ContactSolver>
double error_of(const std::string& name, ContactSolver solver, int substeps, int sweeps = 4) {
  solver.threshold = 0;  // bounces are compared at every speed
  const Motion& motion = any_motion_named(name);
  World world;
  motion.begin(world);
  double farthest = 0;
  for (const Places& places : motion.truth(motion.frames())) {
    for (int i = 0; i < substeps; ++i) world.step(solver, frame / substeps, sweeps);
    for (std::size_t body = 0; body < places.size(); ++body)
      farthest = std::max(farthest, (world.bodies[body].position - places[body]).norm());
  }
  return farthest;
}

/// One step a substep, its impact at the end of it.
using Stepped = Solver<Clamping, Baumgarte, Restitution, FrictionCone>;

}  // namespace

// ---- gaps ------------------------------------------------------------------------------------------------------------

namespace {

/// Balls of random masses at random distances, each with a speed of its own.
RowOfBalls thrown(unsigned seed, double e) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> number(0, 1);
  RowOfBalls row{{}, {}, {}, 0.1, e};
  double place = 0;
  for (int i = 0; i < 6; ++i) {
    row.masses.push_back(0.5 + 4 * number(random));
    row.places.push_back(place += 0.2 + 0.5 * number(random));
    row.velocities.push_back(4 * number(random) - 0.8 * i);
  }
  return row;
}

/// Speeds after the meetings, m/s.
std::vector<double> speeds_after(const RowOfBalls& row, const std::vector<Meeting>& meetings) {
  std::vector<double> v = row.velocities;
  for (const Meeting& met : meetings) {
    v[met.first] -= met.impulse / row.masses[met.first];
    v[met.first + 1] += met.impulse / row.masses[met.first + 1];
  }
  return v;
}
double momentum(const RowOfBalls& row, const std::vector<double>& v) {
  return std::inner_product(v.begin(), v.end(), row.masses.begin(), 0.0);
}
double energy(const RowOfBalls& row, const std::vector<double>& v) {
  double sum = 0;
  for (std::size_t i = 0; i < v.size(); ++i) sum += row.masses[i] * v[i] * v[i] / 2;
  return sum;
}

}  // namespace

TEST_CASE(
    "gaps: each meeting leaves e of the speed of approach, keeps the momentum, and takes (1 - e^2) m/2 of its square") {
  for (unsigned seed = 0; seed < 100; ++seed) {
    const double e = 0.6 + 0.004 * seed;
    const RowOfBalls row = thrown(seed, e);
    const std::vector<Meeting> meetings = row.meetings(5);
    INFO(seed << ": " << meetings.size());
    for (std::size_t k = 0; k < meetings.size(); ++k) {
      const Meeting& met = meetings[k];
      const auto before = speeds_after(row, {meetings.begin(), meetings.begin() + static_cast<std::ptrdiff_t>(k)});
      const auto after = speeds_after(row, {meetings.begin(), meetings.begin() + static_cast<std::ptrdiff_t>(k) + 1});
      CHECK(met.closing > 0);
      CHECK(before[met.first] - before[met.first + 1] == Approx(met.closing).margin(1e-12));
      CHECK(after[met.first + 1] - after[met.first] == Approx(e * met.closing).margin(1e-12));
      CHECK(momentum(row, after) == Approx(momentum(row, row.velocities)).margin(1e-11));
      const double m1 = row.masses[met.first], m2 = row.masses[met.first + 1];
      CHECK(energy(row, before) - energy(row, after) ==
            Approx((1 - e * e) / 2 * m1 * m2 / (m1 + m2) * met.closing * met.closing).margin(1e-11));
      if (k > 0) CHECK(met.time >= meetings[k - 1].time);
    }
    CHECK(meetings.size() >= 2);
  }
}

TEST_CASE("gaps: cut at impacts it is exact, and with the impact at the end of a substep of first order") {
  CHECK(error_of("gaps", AtImpacts(), 1) < 1e-12);
  for (const int substeps : {1, 4, 16, 64, 256}) {
    INFO(substeps);
    CHECK(error_of("gaps", Stepped(), substeps) < 0.1 / substeps);
    CHECK(error_of("gaps", Stepped(), substeps) > 0.01 / substeps);
  }
}

// ---- superball -------------------------------------------------------------------------------------------------------

namespace {

/// A ball of random size, place and motion between random plates.
BallBetweenPlates random_ball(unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> number(0, 1);
  const auto any = [&](double most) {
    return Eigen::Vector3d(most * (2 * number(random) - 1), most * (2 * number(random) - 1),
                           most * (2 * number(random) - 1));
  };
  const double radius = 0.05 + 0.2 * number(random);
  return {.radius = radius,
          .apart = 2 * radius + 0.2 + number(random),
          .mu = 0.5 * number(random),
          .e = 0.7 + 0.3 * number(random),
          .height = radius + 0.1,
          .velocity = any(6),
          .spin = any(60)};
}
Eigen::Vector3d arm_of(const BallBetweenPlates& ball, const Bounce& bounce) {
  return {0, bounce.ceiling ? ball.radius : -ball.radius, 0};
}
/// Per kg, J: with 2/5 r^2 for the inertia.
double energy(const BallBetweenPlates& ball, const Eigen::Vector3d& v, const Eigen::Vector3d& w) {
  return v.squaredNorm() / 2 + 0.2 * ball.radius * ball.radius * w.squaredNorm();
}

}  // namespace

TEST_CASE("superball: each bounce obeys Newton and Coulomb, keeps the momentum about its point, and gives no energy") {
  int slips = 0, sticks = 0;
  for (unsigned seed = 0; seed < 200; ++seed) {
    const BallBetweenPlates ball = random_ball(seed);
    const std::vector<Bounce> bounces = ball.bounces(0.4);
    INFO(seed << ": " << bounces.size());
    for (const Bounce& bounce : bounces) {
      const Eigen::Vector3d arm = arm_of(ball, bounce), after = bounce.velocity + bounce.kick;
      const double arrives = bounce.velocity.y() * (bounce.ceiling ? 1 : -1);
      CHECK(arrives > 0);
      CHECK(after.y() == Approx(-ball.e * bounce.velocity.y()).margin(1e-12));
      // About the point that touches, an impulse there has no moment.
      const double inertia = 0.4 * ball.radius * ball.radius;
      const Eigen::Vector3d before_about = inertia * bounce.spin - arm.cross(bounce.velocity);
      const Eigen::Vector3d after_about = inertia * bounce.spin_after - arm.cross(after);
      CHECK((after_about - before_about).norm() < 1e-12);
      CHECK(energy(ball, after, bounce.spin_after) <= energy(ball, bounce.velocity, bounce.spin) + 1e-12);

      Eigen::Vector3d slip = bounce.velocity + bounce.spin.cross(arm), left = after + bounce.spin_after.cross(arm);
      slip.y() = left.y() = 0;
      CHECK((bounce.slip - slip).norm() < 1e-12);
      const Eigen::Vector3d rub(bounce.kick.x(), 0, bounce.kick.z());
      const double bound = ball.mu * std::abs(bounce.kick.y());
      CHECK(rub.norm() <= bound + 1e-12);
      CHECK(rub.dot(slip) <= 0);
      CHECK(rub.cross(slip).norm() < 1e-12);  // against the slip
      if (bounce.sticks) {
        CHECK(left.norm() < 1e-11);
        ++sticks;
      } else {
        CHECK(rub.norm() == Approx(bound));
        CHECK(left.dot(slip) > 0);
        ++slips;
      }
    }
  }
  CHECK(slips > 100);
  CHECK(sticks > 100);
}

TEST_CASE(
    "superball: cut at impacts it is exact, in substeps of first order, and a friction pyramid never gets there") {
  CHECK(error_of("superball", AtImpacts(), 1) < 1e-11);
  for (const int substeps : {16, 64, 256, 1024}) {
    INFO(substeps);
    CHECK(error_of("superball", Stepped(), substeps) < 1.0 / substeps);
    CHECK(error_of("superball", Stepped(), substeps) > 0.1 / substeps);
  }
  const auto pyramid = [](int substeps) {
    return error_of("superball", Solver<Clamping, Baumgarte, Restitution, Friction>(), substeps);
  };
  CHECK(pyramid(256) > 0.15);
  CHECK(pyramid(256) == Approx(pyramid(1024)).epsilon(0.01));
}

// ---- conveyor --------------------------------------------------------------------------------------------------------

TEST_CASE("conveyor: on the belt the box slides straight and evenly slower, stops there, and rides") {
  const Motion& motion = any_motion_named("conveyor");
  const std::vector<Places> places = motion.truth(motion.frames());
  World world;
  motion.fill(world);
  const Vec3 begin = world.bodies[1].position, belt = Conveyor::belt(), slip = Conveyor::velocity() - belt;
  const double mu = Conveyor::mu, rides = slip.norm() / (mu * truth::g);  // s
  CHECK((rides > 0.5 && rides < 1));
  // Momentum: friction mu m g ends it. Energy: what the box has lost beside the belt is friction's work on its way there.
  const auto on_belt = [&](std::size_t frames) {
    return Eigen::Vector3d(places[frames - 1][1] - begin - static_cast<double>(frames) * frame * belt);
  };
  for (std::size_t frames = 1; frames <= places.size(); ++frames) {
    INFO(frames);
    const Eigen::Vector3d way = on_belt(frames);
    CHECK(places[frames - 1][0].norm() == 0);  // the belt itself stays
    CHECK(way.cross(slip).norm() < 1e-12);
    if (frames == places.size()) continue;
    const Eigen::Vector3d velocity = (on_belt(frames + 1) - way) / frame;
    const double t = (static_cast<double>(frames) + 0.5) * frame;  // where a parabola has its mean velocity
    if (t + frame < rides) {
      CHECK(velocity.norm() == Approx(slip.norm() - mu * truth::g * t));
      CHECK(velocity.dot(slip) > 0);
    }
    if (t - frame > rides) CHECK(velocity.norm() < 1e-12);
  }
  CHECK(mu * truth::g * on_belt(120).norm() == Approx(slip.squaredNorm() / 2));
  // The box comes across: 94 degrees between the two velocities.
  CHECK(std::abs(Conveyor::velocity().normalized().dot(belt.normalized())) < 0.2);
}

TEST_CASE("conveyor: half steps have it right, substeps are of first order, and a friction pyramid never gets there") {
  CHECK(error_of("conveyor", AtImpacts(), 1) < 1e-4);
  CHECK(error_of("conveyor", AtImpacts(), 64) < 1e-8);
  for (const int substeps : {1, 4, 16, 64}) {
    INFO(substeps);
    CHECK(error_of("conveyor", Stepped(), substeps, 16) < 0.03 / substeps);
    CHECK(error_of("conveyor", Stepped(), substeps, 16) > 0.02 / substeps);
  }
  CHECK(error_of("conveyor", Solver<Clamping, Baumgarte, Restitution, Friction>(), 64, 16) > 0.2);
}
