/// The study's motions that are of no chapter: what their closed forms conserve, and solvers that come to the same.
#include <cmath>
#include <numeric>
#include <random>

#include "pushback/chapters/08_friction_cone/friction_cone.h"
#include "pushback/chapters/19_accuracy_and_time/truth.h"
#include "pushback/chapters/25_moment_of_impact/at_impacts.h"
#include "pushback/common/world/measure.h"
#include "pushback/tools/study/every_motion.h"
#include "pushback/tools/study/further_motions.h"
#include "tests/support/catch.h"
#include "tests/support/complaint.h"

using namespace pushback;
using namespace pushback::further;

namespace {

/// The motions of this page, by their names.
const std::vector<std::string> names{"gaps", "superball", "conveyor"};

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

TEST_CASE("further motions: nobody overlaps at first, and the first frame is as the velocities say") {
  for (const std::string& name : names) {
    INFO(name);
    const Motion& motion = any_motion_named(name);
    World world;
    motion.begin(world);
    world.find_contacts();
    CHECK(deepest_overlap(world) < 1e-12);
    CHECK(std::abs(motion.frames() - motion.seconds * frames_per_second) < 1e-9);
    const std::vector<Places> places = motion.truth(motion.frames());
    CHECK(std::ssize(places) == motion.frames());
    for (const Body& body : world.bodies) {
      const Eigen::Vector3d moved = places[0][static_cast<std::size_t>(body.index)] - body.position;
      if (!body.movable()) CHECK(moved.norm() == 0);
      else CHECK((moved - frame * body.velocity).norm() <= truth::g * frame * frame / 2 + 1e-12);
    }
    const std::vector<Places> fewer = motion.truth(7);
    for (std::size_t i = 0; i < fewer.size(); ++i)
      for (std::size_t body = 0; body < fewer[i].size(); ++body) CHECK((fewer[i][body] - places[i][body]).norm() == 0);
  }
}

// ---- gaps ------------------------------------------------------------------------------------------------------------

namespace {

/// Balls of random masses at random distances, each with a speed of its own.
RowOfBalls thrown(unsigned seed, double e, bool equal) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> number(0, 1);
  RowOfBalls row{{}, {}, {}, 0.1, e};
  double place = 0;
  for (int i = 0; i < 6; ++i) {
    row.masses.push_back(equal ? 2 : 0.5 + 4 * number(random));
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
    const RowOfBalls row = thrown(seed, e, false);
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

TEST_CASE("gaps: equal balls move as those of the break, and the k-th one leaves with ((1 + e) / 2)^k of the speed") {
  for (unsigned seed = 0; seed < 30; ++seed) {
    const double e = 0.3 + 0.02 * seed;
    const RowOfBalls row = thrown(seed, e, true);
    World world;
    world.gravity.setZero();
    Places at, velocities;
    std::vector<Kick> kicks;
    for (std::size_t i = 0; i < row.places.size(); ++i) {
      at.emplace_back(row.places[i], 0, 0);
      velocities.emplace_back(row.velocities[i], 0, 0);
      world.add(sphere(row.radius, row.masses[i]).at(at[i]).moving(velocities[i]));
    }
    for (const Meeting& met : row.meetings(2)) {
      kicks.push_back({met.time, met.first, {-met.impulse / 2, 0, 0}});
      kicks.push_back({met.time, met.first + 1, {met.impulse / 2, 0, 0}});
    }
    const auto one = places_of_kicked(world, kicks, 120);
    const auto other = truth::places_of_colliding(at, velocities, row.radius, e, 120);
    for (std::size_t i = 0; i < one.size(); ++i)
      for (std::size_t body = 0; body < at.size(); ++body) CHECK((one[i][body] - other[i][body]).norm() < 1e-9);
  }
  const RowOfBalls hit{{1, 1, 1, 1}, {0, 0.3, 0.7, 1.2}, {2, 0, 0, 0}, 0.1, 0.8};
  const std::vector<Meeting> meetings = hit.meetings(1);
  REQUIRE(meetings.size() >= 3);
  double time = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const double speed = 2 * std::pow(0.9, k);
    time += (hit.places[k + 1] - hit.places[k] - 0.2) / speed;
    CHECK(meetings[k].first == k);
    CHECK(meetings[k].closing == Approx(speed));
    CHECK(meetings[k].time == Approx(time));
  }
}

TEST_CASE("gaps: where balls would meet infinitely often, it is refused") {
  const RowOfBalls row{{4, 1, 4}, {0, 0.3, 0.7}, {2, 0, -1.5}, 0.1, 0.1};  // a light ball between two
  CHECK(complaint([&] { row.meetings(5); }).starts_with("1000 impacts in 0."));
}

TEST_CASE(
    "gaps: the centre of mass goes straight on, nobody passes through a neighbour, and energy is lost as each e says") {
  const RowOfBalls row = Gaps::row();
  const std::vector<Places> places = Gaps().truth(90);
  const double mass = std::accumulate(row.masses.begin(), row.masses.end(), 0.0);
  const auto centre = [&](const Places& at) {
    double sum = 0;
    for (std::size_t i = 0; i < at.size(); ++i) sum += row.masses[i] * at[i].x() / mass;
    return sum;
  };
  for (std::size_t i = 1; i < places.size(); ++i) {
    CHECK(centre(places[i]) - centre(places[i - 1]) == Approx(3.0 / mass * frame).margin(1e-13));
    for (std::size_t body = 1; body < places[i].size(); ++body)
      CHECK(places[i][body].x() - places[i][body - 1].x() > 2 * row.radius - 1e-12);
  }
  double left = 4.5;  // J, of 1 kg with 3 m/s
  for (const Meeting& met : row.meetings(1.5)) {
    const double m1 = row.masses[met.first], m2 = row.masses[met.first + 1];
    left -= (1 - 0.81) / 2 * m1 * m2 / (m1 + m2) * met.closing * met.closing;
  }
  std::vector<double> last;
  for (std::size_t body = 0; body < row.masses.size(); ++body)
    last.push_back((places[89][body].x() - places[88][body].x()) / frame);
  CHECK(energy(row, last) == Approx(left).epsilon(1e-12));
}

TEST_CASE("gaps: nine meetings, five frames apart and more, in the same order with every gap off by 3 cm") {
  const std::vector<Meeting> meetings = Gaps::row().meetings(Gaps::seconds);
  REQUIRE(meetings.size() == 9);
  double before = 0;
  for (const Meeting& met : meetings) {
    CHECK(met.time - before > 5 * frame);
    CHECK(met.closing > 0.69);
    // A step of 1, 1/2, 1/4 ... frames does not end where two balls just touch.
    const double in_frame = met.time / frame - std::floor(met.time / frame);
    CHECK((in_frame > 0.1 && in_frame < 0.97));
    before = met.time;
  }
  CHECK(Gaps::seconds - before > 5 * frame);
  CHECK(Gaps::row().meetings(Gaps::seconds + 1).size() == 9);
  std::mt19937 random(3);
  std::uniform_real_distribution<double> off(-0.03, 0.03);
  for (int trial = 0; trial < 200; ++trial) {
    RowOfBalls other = Gaps::row();
    double shift = 0;
    for (double& place : other.places) place += shift += off(random);
    const std::vector<Meeting> again = other.meetings(Gaps::seconds);
    REQUIRE(again.size() == 9);
    for (std::size_t k = 0; k < 9; ++k) CHECK(again[k].first == meetings[k].first);
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

TEST_CASE("superball: between bounces energy and spin stay, and each parabola ends at a plate") {
  for (unsigned seed = 0; seed < 200; ++seed) {
    const BallBetweenPlates ball = random_ball(seed);
    INFO(seed);
    double time = 0, height = ball.height;
    Eigen::Vector3d v = ball.velocity, w = ball.spin;
    for (const Bounce& bounce : ball.bounces(0.4)) {
      const double t = bounce.time - time, ends = bounce.ceiling ? ball.apart - ball.radius : ball.radius;
      CHECK(t > 0);
      CHECK(height + v.y() * t - truth::g * t * t / 2 == Approx(ends).margin(1e-12));
      CHECK(bounce.velocity.squaredNorm() / 2 + truth::g * ends ==
            Approx(v.squaredNorm() / 2 + truth::g * height).margin(1e-11));
      CHECK(bounce.velocity.x() == v.x());
      CHECK((bounce.spin - w).norm() == 0);
      // Nothing was passed on the way: the highest point of a flight to the floor is below the ceiling.
      if (!bounce.ceiling && v.y() > 0)
        CHECK(height + v.y() * v.y() / (2 * truth::g) <= ball.apart - ball.radius + 1e-12);
      time = bounce.time;
      height = ends;
      v = bounce.velocity + bounce.kick;
      w = bounce.spin_after;
    }
  }
}

TEST_CASE("superball: what is rough enough rolls off with 5/7 of its speed and 2/7 of that of its spin") {
  const BallBetweenPlates ball{
      .radius = 0.1, .apart = 10, .mu = 5, .e = 0.5, .height = 1, .velocity = {3, -1, 0}, .spin = {0, 0, -40}};
  const std::vector<Bounce> bounces = ball.bounces(0.6);
  REQUIRE(bounces.size() == 1);
  CHECK(bounces[0].sticks);
  CHECK(bounces[0].velocity.x() + bounces[0].kick.x() == Approx((5 * 3.0 + 2 * 4.0) / 7));
  CHECK(complaint([&] { ball.bounces(100); }).starts_with("1000 impacts in "));  // it comes to rest
}

namespace {

/// A letter a bounce: s slips, k sticks; small on the floor, capital on the ceiling.
std::string pattern(const std::vector<Bounce>& bounces) {
  std::string letters;
  for (const Bounce& bounce : bounces)
    letters += bounce.ceiling ? (bounce.sticks ? 'K' : 'S') : bounce.sticks ? 'k' : 's';
  return letters;
}

}  // namespace

TEST_CASE("superball: seven bounces, none near the border between slip and stick, nor near another, nor in one plane") {
  const BallBetweenPlates ball = Superball::ball();
  const std::vector<Bounce> bounces = ball.bounces(Superball::seconds);
  CHECK(pattern(bounces) == "sSkSkSk");
  double before = 0;
  for (const Bounce& bounce : bounces) {
    const double ratio = ball.mu * std::abs(bounce.kick.y()) / (2 * bounce.slip.norm() / 7);
    INFO(bounce.time << " s: " << ratio << ", arrives with " << bounce.velocity.y());
    CHECK((ratio < 1 / 1.6 || ratio > 1.6));
    CHECK(std::abs(bounce.velocity.y()) > 1.8);
    CHECK(bounce.time - before > 3.5 * frame);
    before = bounce.time;
  }
  CHECK(Superball::seconds - before > 3.5 * frame);
  CHECK(ball.bounces(Superball::seconds + 3.5 * frame).size() == bounces.size());
  // Its first slip is not along its flight, seen from above: 60 degrees off.
  const auto angle = [](Eigen::Vector3d a, Eigen::Vector3d b) {
    a.y() = b.y() = 0;
    return std::asin(a.cross(b).norm() / (a.norm() * b.norm()));
  };
  CHECK(angle(bounces[0].slip, bounces[0].velocity) > 1);
  std::mt19937 random(4);
  std::uniform_real_distribution<double> off(0.97, 1.03);
  for (int trial = 0; trial < 300; ++trial) {
    BallBetweenPlates other = ball;
    for (double* number : {&other.velocity.x(), &other.velocity.y(), &other.velocity.z(), &other.spin.x(),
                           &other.spin.z(), &other.mu, &other.height})
      *number *= off(random);
    CHECK(pattern(other.bounces(Superball::seconds)) == "sSkSkSk");
  }
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

TEST_CASE("conveyor: no other motion has one") {
  for (const Motion& motion : every_motion()) CHECK(has_conveyor(motion) == (motion.name == "conveyor"));
}
