/// Chapter 19: motions whose every position is known, what is known of them, and the programs that play them. One test
/// looks at a clock: where nothing is done, hardly any time passes.
#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <numeric>
#include <random>
#include <set>

#include "pushback/chapters/08_friction_cone/friction_cone.h"
#include "pushback/chapters/09_impacts/simultaneous.h"
#include "pushback/chapters/13_joints/scenes.h"
#include "pushback/chapters/16_whole_problem/matrix.h"
#include "pushback/chapters/17_direct_contacts/warm_direct_contacts.h"
#include "pushback/chapters/19_accuracy_and_time/seat.h"
#include "pushback/chapters/19_accuracy_and_time/truth.h"
#include "pushback/common/world/measure.h"
#include "pushback/tools/study/every_motion.h"
#include "pushback/tools/study/play.h"
#include "tests/support/call.h"
#include "tests/support/catch.h"
#include "tests/support/complaint.h"

using namespace pushback;
using namespace pushback::joints_scenes;

namespace {

constexpr double g = truth::g;
const std::string nowhere = "nothing";  // no motion, no method

double farthest_apart(const std::vector<Places>& one, const std::vector<Places>& other) {
  REQUIRE(one.size() == other.size());
  double farthest = 0;
  for (std::size_t frame = 0; frame < one.size(); ++frame) {
    REQUIRE(one[frame].size() == other[frame].size());
    for (std::size_t body = 0; body < one[frame].size(); ++body)
      farthest = std::max(farthest, (one[frame][body] - other[frame][body]).norm());
  }
  return farthest;
}

/// The angle of a pendulum whose L is I / (m d), let go at `angle`, after t: an elliptic function, by Newton's method on its
/// inverse.   theta = 2 asin(k sin phi),   F(phi, k) = K(k) - sqrt(g / L) t,   k = sin(angle / 2)
double angle_of_pendulum(double length, double angle, double t) {
  const double k = std::sin(angle / 2), wanted = std::comp_ellint_1(k) - std::sqrt(g / length) * t;
  double phi = wanted;
  for (int i = 0; i < 50; ++i)
    phi -= (std::ellint_1(k, phi) - wanted) * std::sqrt(1 - k * k * std::sin(phi) * std::sin(phi));
  return 2 * std::asin(k * std::sin(phi));
}

/// Bodies on pins as truth::places_of_hanging has them, but with three coordinates a body and the pins' forces between them:
///   M a = f + J^T l,   J a = -J' v       Stepped by Runge and Kutta's rule, in steps of half the size.
class PinnedBodies {
 public:
  PinnedBodies(const std::vector<truth::Hanging>& bodies, double angle)
      : bodies_(bodies), x_(3 * count()), v_(Eigen::VectorXd::Zero(3 * count())) {
    Eigen::Vector2d pin(0, 0);
    for (Eigen::Index i = 0; i < count(); ++i) {
      const Eigen::Vector2d down(std::sin(angle), -std::cos(angle));
      x_.segment<2>(3 * i) = pin + at(i).to_centre * down;
      x_[3 * i + 2] = angle;
      pin += at(i).to_next * down;
    }
  }
  Eigen::Index count() const { return std::ssize(bodies_); }

  void step(double h) {
    const Eigen::VectorXd k1 = acceleration(x_, v_), v2 = v_ + h / 2 * k1;
    const Eigen::VectorXd k2 = acceleration(x_ + h / 2 * v_, v2), v3 = v_ + h / 2 * k2;
    const Eigen::VectorXd k3 = acceleration(x_ + h / 2 * v2, v3), v4 = v_ + h * k3;
    const Eigen::VectorXd k4 = acceleration(x_ + h * v3, v4);
    x_ += h / 6 * (v_ + 2 * v2 + 2 * v3 + v4);
    v_ += h / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
  }
  Places places() const {
    Places found;
    for (Eigen::Index i = 0; i < count(); ++i) found.emplace_back(x_[3 * i], x_[3 * i + 1], 0);
    return found;
  }
  double energy() const {
    double sum = 0;
    for (Eigen::Index i = 0; i < count(); ++i)
      sum += at(i).mass * (v_.segment<2>(3 * i).squaredNorm() / 2 + g * x_[3 * i + 1]) +
             at(i).inertia * v_[3 * i + 2] * v_[3 * i + 2] / 2;
    return sum;
  }

 private:
  const truth::Hanging& at(Eigen::Index i) const { return bodies_[static_cast<std::size_t>(i)]; }

  Eigen::VectorXd acceleration(const Eigen::VectorXd& x, const Eigen::VectorXd& v) const {
    const Eigen::Index n = count();
    Eigen::MatrixXd j = Eigen::MatrixXd::Zero(2 * n, 3 * n);
    Eigen::VectorXd wanted = Eigen::VectorXd::Zero(2 * n), weights(3 * n), free = Eigen::VectorXd::Zero(3 * n);
    for (Eigen::Index i = 0; i < n; ++i) {
      weights.segment<3>(3 * i) << 1 / at(i).mass, 1 / at(i).mass, 1 / at(i).inertia;
      free[3 * i + 1] = -g;
      // Pin i is where body i has its upper end and body i - 1 its lower one: x - s (sin, -cos), s along the body.
      const auto end_of = [&](Eigen::Index body, double s, double sign) {
        const double angle = x[3 * body + 2], speed = v[3 * body + 2];
        const Eigen::Vector2d way(std::sin(angle), -std::cos(angle)), across(std::cos(angle), std::sin(angle));
        j.block<2, 2>(2 * i, 3 * body) = sign * Eigen::Matrix2d::Identity();
        j.block<2, 1>(2 * i, 3 * body + 2) = sign * s * across;
        wanted.segment<2>(2 * i) += sign * s * speed * speed * way;
      };
      end_of(i, -at(i).to_centre, 1);
      if (i > 0) end_of(i - 1, at(i - 1).to_next - at(i - 1).to_centre, -1);
    }
    const Eigen::MatrixXd w = weights.asDiagonal() * j.transpose();
    const Eigen::VectorXd pulls = (j * w).llt().solve(wanted - j * free);
    return free + w * pulls;
  }

  std::vector<truth::Hanging> bodies_;
  Eigen::VectorXd x_, v_;
};

/// Four different bodies, the last one heavy.
const std::vector<truth::Hanging> four{
    {1, 0.02, 0.25, 0.5}, {2, 0.05, 0.1, 0.4}, {0.5, 0.01, 0.3, 0.3}, {50, 1.8, 0.3, 0.3}};

/// Balls that do not overlap, thrown about a square.
struct Thrown {
  Places at, velocities;
  double radius;
};
Thrown thrown(unsigned seed, int balls) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> number(-1, 1);
  Thrown found{{}, {}, 0.12};
  while (std::ssize(found.at) < balls) {
    const Eigen::Vector3d at(number(random), number(random), 0.3 * number(random));
    bool is_free = true;
    for (const Eigen::Vector3d& other : found.at) is_free = is_free && (at - other).norm() > 0.25;
    if (!is_free) continue;
    found.at.push_back(at);
    found.velocities.emplace_back(-3 * at + 2 * Eigen::Vector3d(number(random), number(random), number(random)));
  }
  return found;
}

Eigen::Vector3d mean(const Places& places) {
  return std::accumulate(places.begin(), places.end(), Eigen::Vector3d(0, 0, 0)) / std::ssize(places);
}

/// What all have between two frames; of straight flight, if nothing met between them.
Places speeds_between(const Places& before, const Places& after) {
  Places found;
  for (std::size_t i = 0; i < before.size(); ++i) found.emplace_back((after[i] - before[i]) * frames_per_second);
  return found;
}
double squares(const Places& velocities) {
  double sum = 0;
  for (const Eigen::Vector3d& v : velocities) sum += v.squaredNorm();
  return sum;
}
Eigen::Vector3d turning(const Places& at, const Places& velocities) {
  Eigen::Vector3d sum(0, 0, 0);
  for (std::size_t i = 0; i < at.size(); ++i) sum += at[i].cross(velocities[i]);
  return sum;
}

}  // namespace

// ---- truth -----------------------------------------------------------------------------------------------------------

TEST_CASE("one body on a pin swings as the elliptic function says") {
  for (const double angle : {0.1, 1.0, 2.5}) {
    const truth::Hanging body{3, 0.4, 0.7, 99};
    const double length = (body.inertia / body.mass + body.to_centre * body.to_centre) / body.to_centre;
    std::vector<Places> wanted;
    for (int frame = 1; frame <= 240; ++frame) {
      const double now = angle_of_pendulum(length, angle, static_cast<double>(frame) / frames_per_second);
      wanted.push_back({{body.to_centre * std::sin(now), -body.to_centre * std::cos(now), 0}});
    }
    INFO(angle);
    CHECK(farthest_apart(truth::places_of_hanging({body}, angle, 240), wanted) < 1e-9);
  }
}

TEST_CASE("the pendulum that is played is a ball about its uppermost point") {
  const Motion& pendulum = motion_named("pendulum");
  const double radius = 0.3, length = 1.4 * radius;  // 2/5 r^2 + r^2 over r
  const std::vector<Places> places = pendulum.truth(pendulum.frames());
  for (std::size_t frame = 0; frame < places.size(); ++frame) {
    const double now =
        angle_of_pendulum(length, static_cast<double>(pi) / 3, (static_cast<double>(frame) + 1) / frames_per_second);
    CHECK((places[frame][0] - radius * Eigen::Vector3d(std::sin(now), -std::cos(now), 0)).norm() <
          (std::is_same_v<Real, float> ? 1e-5 : 1e-9));
  }
}

TEST_CASE("bodies on pins move as they do with three coordinates each and forces in the pins, and keep their energy") {
  const double angle = 0.9;
  const int frames = 45;
  PinnedBodies other(four, angle);
  const double energy = other.energy();
  std::vector<Places> wanted;
  for (int frame = 0; frame < frames; ++frame) {
    for (int step = 0; step < 512; ++step) other.step(1.0 / (frames_per_second * 512));
    wanted.push_back(other.places());
    CHECK(other.energy() == Approx(energy).epsilon(0).margin(1e-7));  // of some 500 J that change their form
  }
  const std::vector<Places> found = truth::places_of_hanging(four, angle, frames);
  CHECK(farthest_apart(found, wanted) < 1e-9);
  CHECK((found.back()[3] - found.front()[3]).norm() > 0.5);
}

TEST_CASE("the pins of the chain hold in its truth: centres stay as far from each other's ends as they were") {
  const Motion& chain = motion_named("chain");
  const double half = 0.25, margin = std::is_same_v<Real, float> ? 1e-6 : 1e-12;
  for (const Places& places : chain.truth(30)) {
    Eigen::Vector3d pin(0, 0, 0);
    for (std::size_t i = 0; i < 10; ++i) {
      CHECK((places[i] - pin).norm() == Approx(half).margin(margin));
      pin += 2 * (places[i] - pin);
    }
    CHECK((places[10] - pin).norm() == Approx(0.3).margin(margin));
  }
}

TEST_CASE("balls that collide keep momentum and turning momentum, and with e = 1 their energy") {
  for (unsigned seed = 1; seed <= 20; ++seed) {
    const Thrown balls = thrown(seed, 9);
    for (const double e : {1.0, 0.6, 0.0}) {
      const int frames = 300;  // long after the last have met
      const std::vector<Places> places =
          truth::places_of_colliding(balls.at, balls.velocities, balls.radius, e, frames);
      REQUIRE(std::ssize(places) == frames);
      INFO(seed << ", e = " << e);
      double off = 0, overlap = 0;
      for (std::size_t frame = 0; frame < places.size(); ++frame) {
        const double t = (static_cast<double>(frame) + 1) / frames_per_second;
        off = std::max(off, (mean(places[frame]) - mean(balls.at) - t * mean(balls.velocities)).norm());
        for (std::size_t i = 0; i < places[frame].size(); ++i)
          for (std::size_t j = 0; j < i; ++j)
            overlap = std::max(overlap, 2 * balls.radius - (places[frame][i] - places[frame][j]).norm());
      }
      CHECK(off < 1e-12);
      CHECK(overlap < 1e-10);
      const Places last = speeds_between(places[frames - 2], places[frames - 1]);
      CHECK((turning(places[frames - 1], last) - turning(balls.at, balls.velocities)).norm() < 1e-9);
      if (e == 1) CHECK(squares(last) == Approx(squares(balls.velocities)).epsilon(1e-11));
      else CHECK(squares(last) < 0.999 * squares(balls.velocities));
      CHECK(farthest_apart({last}, {balls.velocities}) > 0.01);
    }
  }
}

TEST_CASE("a head-on collision takes its part of the energy, at its time and place") {
  const double radius = 0.1, v = 3, gap = 0.5;
  for (const double e : {0.0, 0.3, 0.95, 1.0}) {
    // The one that comes goes on with (1 - e) / 2 of its speed, the other with (1 + e) / 2.
    const auto places =
        truth::places_of_colliding({{0, 0, 0}, {2 * radius + gap, 0, 0}}, {{v, 0, 0}, {0, 0, 0}}, radius, e, 60);
    for (std::size_t frame = 0; frame < places.size(); ++frame) {
      const double t = (static_cast<double>(frame) + 1) / frames_per_second, since = std::max(0.0, t - gap / v);
      INFO(e << ", " << t);
      CHECK(places[frame][0].x() == Approx(v * std::min(t, gap / v) + (1 - e) / 2 * v * since).margin(1e-12));
      CHECK(places[frame][1].x() == Approx(2 * radius + gap + (1 + e) / 2 * v * since).margin(1e-12));
    }
    const double before = v * v, after = squares(speeds_between(places[58], places[59]));
    CHECK(before - after == Approx((1 - e * e) / 2 * v * v).margin(1e-10));
  }
}

TEST_CASE("a ball comes up to e^2 of the height that it fell from, each time, and lies at last") {
  for (const double e : {0.0, 0.5, 0.8, 1.0}) {
    for (const double height : {0.5, 2.0}) {
      const double fall = std::sqrt(2 * height / g);
      double hit = fall;  // s
      INFO(e << ", " << height);
      CHECK(truth::height_of_bouncing(height, e, 0) == height);
      for (int k = 1; k <= 6; ++k) {
        const double up = std::pow(e, k) * fall;
        const double apex = truth::height_of_bouncing(height, e, hit + up);
        CHECK(apex == Approx(std::pow(e, 2 * k) * height).margin(1e-12));
        CHECK(truth::height_of_bouncing(height, e, hit + up * 0.9) <= apex);
        CHECK(truth::height_of_bouncing(height, e, hit + up * 1.1) <= apex);
        CHECK(truth::height_of_bouncing(height, e, hit) == Approx(0).margin(1e-12));
        hit += 2 * up;
      }
      if (e < 1) CHECK(truth::height_of_bouncing(height, e, 100) == Approx(0).margin(1e-12));
    }
  }
}

TEST_CASE("what slides has stopped after v^2 / 2a, and what rolls goes on with 5/7 of its speed") {
  const double v = 6, a = 4.9, mu = 0.3;
  CHECK(truth::way_of_sliding(v, a, v / a) == Approx(v * v / (2 * a)));
  CHECK(truth::way_of_sliding(v, a, 100) == Approx(v * v / (2 * a)));
  CHECK(truth::way_of_sliding(v, a, v / a / 2) == Approx(0.75 * v * v / (2 * a)));
  const auto rolling = [&](double t) { return truth::way_of_rolling(v, mu, t); };
  const double changes = 2 * v / (7 * mu * g), d = 1e-6;
  const auto speed = [&](double t) { return (rolling(t + d) - rolling(t - d)) / (2 * d); };
  CHECK(rolling(0) == 0);
  CHECK(speed(d) == Approx(v).epsilon(1e-5));
  CHECK(rolling(changes + 1e-9) - rolling(changes - 1e-9) < 1e-7);
  CHECK(speed(changes - 2 * d) == Approx(5 * v / 7).epsilon(1e-5));
  CHECK(speed(changes + 2 * d) == Approx(5 * v / 7).epsilon(1e-5));
  CHECK(speed(changes / 2) == Approx(v - mu * g * changes / 2).epsilon(1e-5));
  CHECK(speed(50) == Approx(5 * v / 7).epsilon(1e-5));
  // The momentum about a point of the ground is kept: m v r = (m r^2 + 2/5 m r^2) v' / r
  CHECK(rolling(changes) == Approx(v * changes - mu * g * changes * changes / 2));
}

// ---- motions ---------------------------------------------------------------------------------------------------------

TEST_CASE("every motion has a name of its own, its bodies, its joints, and a place for each body in each frame") {
  std::set<std::string> names;
  for (const Motion& motion : all_motions()) {
    INFO(motion.name);
    CHECK(names.insert(motion.name).second);
    CHECK(&motion_named(motion.name) == &motion);
    CHECK(motion.name.find_first_of(" /,") == std::string::npos);
    CHECK(!motion.title.empty());
    World world, bodies;
    motion.begin(world);
    motion.fill(bodies);
    CHECK(world.joints.size() == motion.pins.size());
    CHECK(bodies.joints.empty());
    CHECK(std::abs(motion.frames() - motion.seconds * frames_per_second) < 1e-9);
    const auto places = motion.truth(motion.frames());
    CHECK(std::ssize(places) == motion.frames());
    for (const Places& frame : places) REQUIRE(frame.size() == world.bodies.size());
    for (const Places& frame : places)
      for (const Eigen::Vector3d& place : frame) REQUIRE(place.allFinite());
    CHECK(motion.most_substeps >= 1);
    CHECK(motion.most_sweeps >= 1);
    CHECK(motion.most_passes >= motion.most_substeps);
  }
  CHECK(names.size() == 10);
  const std::string said = complaint([] { motion_named(nowhere); });
  CHECK(contains(said, "'nothing'"));
  for (const std::string& name : names) CHECK(contains(said, name));
}

TEST_CASE("nobody overlaps as a motion begins, and each joint holds") {
  for (const Motion& motion : all_motions()) {
    INFO(motion.name);
    World world;
    motion.begin(world);
    world.find_contacts();
    CHECK(deepest_overlap(world) < (std::is_same_v<Real, float> ? 1e-6 : 1e-12));
    CHECK(largest_joint_error(world) < (std::is_same_v<Real, float> ? 1e-6 : 1e-12));
  }
}

TEST_CASE("after a frame the truth is as near to the start as speed and gravity allow") {
  for (const Motion& motion : all_motions()) {
    World world;
    motion.fill(world);
    const Places first = motion.truth(1)[0];
    REQUIRE(first.size() == world.bodies.size());
    for (const Body& body : world.bodies) {
      const Eigen::Vector3d moved = first[static_cast<std::size_t>(body.index)] - body.position.cast<double>();
      const double v = static_cast<double>(body.velocity.norm()), dt = 1.0 / frames_per_second;
      INFO(motion.name << ", body " << body.index << " moved by " << moved.transpose());
      CHECK(moved.norm() <= v * dt + g * dt * dt / 2 + 1e-9);
      CHECK((moved - dt * body.velocity.cast<double>()).norm() <= g * dt * dt / 2 + 1e-9);
    }
  }
}

TEST_CASE("a truth of fewer frames is the beginning of that of more") {
  for (const Motion& motion : all_motions()) {
    auto more = motion.truth(7);
    more.resize(3);
    INFO(motion.name);
    CHECK(farthest_apart(motion.truth(3), more) == 0);
  }
}

TEST_CASE("the truth of each motion moves as far as a law says") {
  const auto last = [](const char* name) {
    const Motion& motion = motion_named(name);
    World world;
    motion.fill(world);
    return Eigen::Vector3d(motion.truth(motion.frames()).back().back() - world.bodies.back().position.cast<double>());
  };
  const double margin = std::is_same_v<Real, float> ? 1e-5 : 1e-12;
  const Eigen::Vector3d ahead(std::sqrt(0.75), 0, 0.5);
  CHECK((last("sliding") - 36 / (2 * 0.5 * g) * ahead).norm() < margin);
  const double slides = 2 * 6 / (7 * 0.3 * g);
  CHECK((last("rolling") - (slides * 6 * 6 / 7 + 30.0 / 7 * (2 - slides)) * ahead).norm() < margin);
  const double a = g * (0.5 - 0.4 * std::sqrt(0.75));
  CHECK((last("incline") - a * 1.5 * 1.5 / 2 * Eigen::Vector3d(std::sqrt(0.75), -0.5, 0)).norm() < margin);
  for (const char* name : {"stack-10", "pyramid-10", "heavy-on-light"}) CHECK(last(name).norm() == 0);
}

// ---- playing ---------------------------------------------------------------------------------------------------------

namespace {

/// One body that stays where it is: the truth of `still` below is a place a frame, 1 m, 2 m ... off.
struct Stands : PlayerInSubsteps {
  std::function<Eigen::Vector3d(int)> place_after;
  int steps = 0;
  void substep() override { ++steps; }
  Eigen::Vector3d place(std::size_t) const override { return place_after(steps); }
  std::optional<double> row_solves() const override { return 7 * steps; }
};
Motion ten_frames() {
  const auto fill = [](World& world) { world.add(sphere(1, 1)); };
  const auto truth = [](int frames) { return std::vector<Places>(static_cast<std::size_t>(frames), {{0, 0, 0}}); };
  return {.name = "ten", .title = "ten frames", .fill = fill, .seconds = 10.0 / frames_per_second, .truth = truth};
}
Played played_by(const std::function<Eigen::Vector3d(int)>& place_after, int substeps, const Patience& patience) {
  const Method method{.name = "stands",
                      .title = "stands",
                      .plays = [](const Motion&) { return true; },
                      .begin = [&](const Motion&, const Setting&) -> std::unique_ptr<Player> {
                        auto player = std::make_unique<Stands>();
                        player->place_after = place_after;
                        return player;
                      }};
  const Motion motion = ten_frames();
  return play(motion, motion.truth(motion.frames()), method, {.substeps = substeps, .sweeps = 1}, patience);
}
constexpr Patience once{.at_least = 0, .at_most = 600};

}  // namespace

TEST_CASE(
    "the error is the farthest in any frame, looked at after all its substeps, and row solves are of all of them") {
  const auto away = [](int steps) { return Eigen::Vector3d(0, steps == 15 ? -3 : 0, steps == 17 ? 99 : 0); };
  for (const double at_least : {0.0, 1e-4}) {
    const Played played = played_by(away, 5, {.at_least = at_least, .at_most = 600});  // 17 is between two frames
    CHECK(played.error == 3);
    CHECK(played.row_solves == 10 * 5 * 7);
    CHECK(!played.late);
  }
}

TEST_CASE("who is no number, or beyond 10 km, is lost, and who is given up is late, and neither has an error") {
  const auto nan_at_last = [](int steps) {
    return Eigen::Vector3d(0, steps == 10 ? std::numeric_limits<double>::quiet_NaN() : 0, 0);
  };
  const auto far = [](int steps) { return Eigen::Vector3d(steps == 3 ? 10001 : 0, 0, 0); };
  const auto not_yet = [](int steps) { return Eigen::Vector3d(steps == 3 ? 9999 : 0, 0, 0); };
  const auto refuses = [](int) -> Eigen::Vector3d { throw InvalidInput("no number"); };
  CHECK(played_by(nan_at_last, 1, once).error == no_error_known);
  CHECK(played_by(far, 1, once).error == no_error_known);
  CHECK(!played_by(far, 1, once).late);
  CHECK(played_by(not_yet, 1, once).error == 9999);
  CHECK(played_by(refuses, 1, once).error == no_error_known);
  CHECK(!played_by(refuses, 1, once).late);
  const Played late = played_by(not_yet, 1, {.at_least = 0, .at_most = 0});
  CHECK(late.late);
  CHECK(late.error == no_error_known);
  CHECK(late.row_solves == 7);
}

namespace {

struct Line {
  std::string setting, error, row_solves;
  double error_m() const { return std::stod(error); }
};
std::vector<Line> played_in(const fs::path& program, const std::string& arguments) {
  const Ended ended = call_program(program, arguments, 120);
  INFO(arguments << ": " << ended.err);
  REQUIRE(ended.status == 0);
  std::vector<Line> found;
  for (const std::string& text : lines_of(ended.out)) {
    std::istringstream in(text);
    Line line;
    std::string error, seconds, time, row_solves;
    in >> line.setting >> error >> line.error >> seconds >> time >> row_solves >> line.row_solves;
    CHECK((error == "error" && seconds == "seconds" && row_solves == "row-solves"));
    found.push_back(line);
  }
  return found;
}
std::vector<std::string> methods_of(const std::string& motion) {
  const Ended ended = call_program(MOTION_PROGRAM, motion);
  REQUIRE(ended.status == 0);
  std::vector<std::string> names;
  for (const std::string& line : lines_of(ended.out)) names.push_back(line.substr(0, line.find('/')));
  return names;
}
/// Of a method in one setting after the other.
std::vector<double> errors_in(const std::string& motion, const std::vector<std::string>& settings) {
  std::string arguments = motion + " --at-least 0 --at-most 600";
  for (const std::string& setting : settings) arguments += " " + setting;
  std::vector<double> found;
  for (const Line& line : played_in(MOTION_PROGRAM, arguments)) found.push_back(line.error_m());
  REQUIRE(found.size() == settings.size());
  return found;
}

}  // namespace

TEST_CASE("the program lists its motions, and the methods of each") {
  const Ended all = call_program(MOTION_PROGRAM, "");
  CHECK(all.status == 0);
  const auto lines = lines_of(all.out);
  REQUIRE(lines.size() == every_motion().size());
  for (std::size_t i = 0; i < all_motions().size(); ++i)
    CHECK(lines[i] == all_motions()[i].name + ": " + all_motions()[i].title);
  for (const Motion& motion : all_motions()) {
    const Ended ended = call_program(MOTION_PROGRAM, motion.name);
    CHECK(ended.status == 0);
    CHECK(contains(ended.out, "joints/SMALL-STEPS/SWEEPS: ") == !motion.pins.empty());
    CHECK(contains(ended.out, "slim/SMALL-STEPS/SWEEPS: ") == motion.pins.empty());
  }
  CHECK(methods_of("bounce").size() == 11);
  CHECK(methods_of("chain").size() == 5);
}

TEST_CASE("what cannot be played is refused, with the value and what is allowed, before anything is played") {
  const auto refused = [](const std::string& arguments, const std::vector<std::string>& said) {
    for (const char* program : {MOTION_PROGRAM, MOTION_FLOAT_PROGRAM}) {
      const Ended ended = call_program(program, arguments);
      INFO(arguments << ": " << ended.out << ended.err);
      CHECK(ended.status == 2);
      CHECK(ended.out.empty());
      for (const std::string& part : said) CHECK(contains(ended.err, part));
    }
  };
  refused(nowhere, {"'nothing'", "bounce", "break"});
  refused(nowhere + " full/1/1", {"'nothing'", "bounce", "break"});
  refused("bounce nothing/1/1", {"'nothing'", "full", "direct-contacts", "plays bounce"});
  refused("bounce full/1/1 nothing/1/1", {"'nothing'"});
  refused("bounce joints/1/1", {"'joints'", "full", "plays bounce"});
  refused("chain full/1/1", {"'full'", "split-joints", "plays chain"});
  refused("bounce ''", {"'' is not allowed"});
  refused("bounce full/0/1", {"'0' in 'full/0/1'", "from 1 to 65536"});
  refused("bounce full/65537/1", {"'65537'", "from 1 to 65536"});
  refused("bounce full/-4/1", {"'-4'", "from 1 to 65536"});
  refused("bounce full/99999999999/1", {"'99999999999'", "from 1 to 65536"});
  refused("bounce full/1/0", {"'0' in 'full/1/0'", "from 1 to 1048576"});
  refused("bounce full/4", {"'full/4'", "full/SMALL-STEPS/SWEEPS"});
  refused("bounce full", {"'full'", "full/SMALL-STEPS/SWEEPS"});
  refused("bounce full/4/1/1", {"'full/4/1/1'", "full/SMALL-STEPS/SWEEPS"});
  refused("bounce full/4x/1", {"'4x'", "a whole number"});
  refused("bounce full/4/1.5", {"'1.5'", "a whole number"});
  refused("bounce full/4/", {"'full/4/'", "full/SMALL-STEPS/SWEEPS"});
  refused("bounce full//4", {"''", "a whole number"});
  for (const std::string option : {"--at-most", "--at-least"})
    for (const std::string value : {"nan", "-1", "1e9", "inf", "soon"})
      refused("bounce full/1/1 " + option + " " + value,
              {option, value == "1e9" ? "1" : value, "0", option == "--at-most" ? "3600" : "60"});
  refused("bounce --nothing", {"--nothing"});
}

TEST_CASE("row solves of a motion: three rows a pin and sweep, twice where the push is apart, in each of its passes") {
  const auto counts = played_in(MOTION_PROGRAM,
                                "pendulum --at-least 0 joints/1/1 joints/2/3 split-joints/2/3 steady-joints/1/1 "
                                "direct-joints/1/1");
  REQUIRE(counts.size() == 5);
  const int frames = motion_named("pendulum").frames();
  CHECK(std::stod(counts[0].row_solves) == frames * 3);
  CHECK(std::stod(counts[1].row_solves) == frames * 2 * 3 * 3);
  CHECK(std::stod(counts[2].row_solves) == 2 * frames * 2 * 3 * 3);
  CHECK(std::stod(counts[3].row_solves) == 2 * frames * 20 * 3);
  CHECK(counts[4].row_solves == "–");  // a linear system
}

TEST_CASE("only substeps are timed: who is asked for places takes no time, and again for the times is asked for none") {
  int asked = 0;
  const auto place = [&](int) {
    ++asked;
    for (const auto end = std::chrono::steady_clock::now() + std::chrono::milliseconds(2);
         std::chrono::steady_clock::now() < end;) {
    }
    return Eigen::Vector3d(0, 0, 0);
  };
  CHECK(played_by(place, 1, once).seconds < 10 * 2e-3 / 2);
  CHECK(asked == 10);
  played_by(place, 1, {.at_least = 1e-4, .at_most = 600});
  CHECK(asked == 20);
}

TEST_CASE("the same setting errs by the same again, and in as many row solves, and lines come in the order asked for") {
  for (const auto& [motion, settings] : {std::pair("bounce", "slim/4/1 full/2/3 direct-contacts/1/1 slim/4/1"),
                                         {"chain", "joints/2/4 joints/2/4"},
                                         {"heavy-on-light", "soft/2/2 steady/1/4 soft/2/2"}}) {
    const std::string arguments = fmt::format("{} {} --at-least 0", motion, settings);
    const auto one = played_in(MOTION_PROGRAM, arguments), two = played_in(MOTION_PROGRAM, arguments);
    std::string order;
    REQUIRE(one.size() == two.size());
    for (std::size_t i = 0; i < one.size(); ++i) {
      order += (i == 0 ? "" : " ") + one[i].setting;
      CHECK(one[i].error == two[i].error);
      CHECK(one[i].row_solves == two[i].row_solves);
    }
    CHECK(order == settings);
    CHECK(one.front().error == one.back().error);
  }
}

TEST_CASE("who is given up is late, who flies off is lost") {
  for (const Line& line : played_in(MOTION_PROGRAM, "bounce full/1/1 direct-contacts/4/1 --at-most 0"))
    CHECK(line.error == "late");
  for (const Line& line : played_in(MOTION_PROGRAM, "chain --at-most 0 joints/1/1")) CHECK(line.error == "late");
  for (const Line& line : played_in(MOTION_PROGRAM, "bounce full/1/1")) CHECK(line.error_m() < 0.1);
}

// ---- our methods -----------------------------------------------------------------------------------------------------

TEST_CASE("each of our methods comes closer to the truth with smaller steps, but for a pyramid's friction") {
  const std::string motion = GENERATE("bounce", "incline", "sliding", "rolling");
  for (const std::string& method : methods_of(motion)) {
    const auto errors = errors_in(motion, {method + "/8/4", method + "/64/4"});
    INFO(motion << ", " << method << ": " << errors[0] << ", then " << errors[1] << " m");
    CHECK(errors[1] > 0);
    if (method.starts_with("full") && motion == "sliding") CHECK((errors[1] > 1 && errors[1] < 1.1));
    else if (method.starts_with("full") && motion == "rolling") CHECK((errors[1] > 0.1 && errors[1] < 0.2));
    else CHECK(errors[1] < errors[0] / 4);
  }
}

TEST_CASE("joints come closer to the truth with smaller steps") {
  for (const std::string& method : methods_of("pendulum")) {
    const auto errors = errors_in("pendulum", {method + "/8/1", method + "/64/1"});
    INFO(method << ": " << errors[0] << ", then " << errors[1] << " m");
    CHECK(errors[1] < errors[0] / 4);
  }
  for (const std::string method : {"joints", "split-joints", "direct-joints"}) {
    const auto errors = errors_in("chain", {method + "/8/16", method + "/64/16"});
    INFO(method << ": " << errors[0] << ", then " << errors[1] << " m");
    CHECK(errors[1] < errors[0] / 4);
    CHECK(errors[1] < 1e-3);
  }
}

TEST_CASE("half the step is half the error: of what slides, and of what swings") {
  const auto halves = [](const std::string& motion, const std::string& method, const std::string& sweeps) {
    std::vector<std::string> settings;
    for (const char* substeps : {"8", "16", "32", "64"}) settings.push_back(method + "/" + substeps + "/" + sweeps);
    const auto errors = errors_in(motion, settings);
    for (std::size_t i = 1; i < errors.size(); ++i) {
      INFO(motion << ", " << settings[i] << ": " << errors[i - 1] << ", then " << errors[i] << " m");
      CHECK(errors[i] / errors[i - 1] > 0.4);
      CHECK(errors[i] / errors[i - 1] < 0.6);
    }
  };
  for (const std::string& method : methods_of("sliding"))
    if (!method.starts_with("full")) halves("sliding", method, "4");
  for (const std::string& method : methods_of("pendulum")) halves("pendulum", method, "1");
}

TEST_CASE("in float a bounce errs as in double, and what lies still only by what float rounds") {
  const auto settings = std::string("full/8/4 slim/16/1 direct-contacts/8/1 soft/8/1");
  const auto in_double = played_in(MOTION_PROGRAM, "bounce " + settings),
             in_float = played_in(MOTION_FLOAT_PROGRAM, "bounce " + settings);
  REQUIRE(in_double.size() == in_float.size());
  for (std::size_t i = 0; i < in_double.size(); ++i) {
    INFO(in_double[i].setting);
    CHECK(in_float[i].error_m() == Approx(in_double[i].error_m()).epsilon(0.01));
  }
  // A box whose centre is at 1.5 m is known to 6e-8 of that; and a seat of 1 um is then not one to a per cent any more.
  const double seat = played_in(MOTION_PROGRAM, "heavy-on-light direct-contacts/8/1")[0].error_m();
  const double of_float = played_in(MOTION_FLOAT_PROGRAM, "heavy-on-light direct-contacts/8/1")[0].error_m();
  CHECK(seat == Approx(2e-6).epsilon(1e-3));
  INFO(of_float);
  CHECK(of_float > 1e-7 * 1.5);
  CHECK(std::abs(of_float - seat) > 1e-3 * seat);  // double it is not
}

// ---- a seat, and direct contacts --------------------------------------------------------------------------------------

namespace {

using Swept = Solver<Clamping, Baumgarte, Seat, Restitution, FrictionCone, WarmStart>;

/// How far the solver's impulses were from solving the step, after its last sweep.
struct Watch : Effect {
  double residual = 0, pushes = 0;  ///< the largest of all steps; N s, along the normals of the latest

  void start(StepContext& step) { problem_ = problem_of(step.contacts, step.rows); }  // before the guess
  void finish(StepContext& step) {
    std::vector<Eigen::Index> next;
    for (std::size_t i = 0; i < step.contacts.size(); ++i) next.push_back(3 * std::ssize(next));
    Vector r = Vector::Zero(problem_.q.size());
    pushes = 0;
    for (const Row& row : step.rows) {
      const Eigen::Index at = next[row.owner]++;
      r[at] = static_cast<double>(row.impulse);
      if (at % 3 == 0) pushes += r[at];
    }
    if (problem_.contacts() > 0) residual = std::max(residual, relative_residual(problem_, r));
  }

 private:
  ContactProblem problem_;
};
using Direct = Solver<Clamping, Baumgarte, Seat, Restitution, FrictionCone, Watch, WarmStart, WarmDirectContacts>;

constexpr Real h = Real(1) / 60;

void four_high(World& world) {
  pyramid(world, 4);
}
/// A box that slides down a slope of 30 degrees, mu = 0.4.
void slope(World& world) {
  motion_named("incline").fill(world);
}

}  // namespace

TEST_CASE("one box comes to rest as deep as its seat, by the same part each step: from above, and from below") {
  const Real seat = Real(1e-3);
  for (const Real beta : {Real(0.1), Real(0.2), Real(0.5)}) {
    for (const Real start : {Real(0.0001) * seat, 4 * seat}) {
      World world;
      world.add(ground());
      world.add(box(Vec3::Constant(Real(0.5)), 100).at({0, Real(0.5) - start, 0}));
      Swept solver;
      solver.seat = seat;
      solver.Seat::beta = beta;
      solver.Baumgarte::beta = beta;
      double missing = static_cast<double>(seat - start);
      for (int step = 0; step < 100; ++step) {
        world.step(solver, h, 50);
        missing *= 1 - static_cast<double>(beta);
        const double depth = 0.5 - static_cast<double>(world.bodies[1].position.y());
        INFO(beta << " from " << start << ", step " << step);
        REQUIRE(static_cast<double>(seat) - depth == Approx(missing).margin(1e-2 * static_cast<double>(seat)));
        if (std::is_same_v<Real, double>)
          REQUIRE(static_cast<double>(seat) - depth == Approx(missing).epsilon(1e-6).margin(1e-9));
      }
    }
  }
}

TEST_CASE("ten boxes solved directly end ten seats deep") {
  World world;
  stack(world, 10);
  Direct solver;
  for (int step = 0; step < 100; ++step) world.step(solver, h, 1);
  for (int i = 1; i <= 10; ++i) {
    const double sunk = i - 0.5 - static_cast<double>(world.bodies[static_cast<std::size_t>(i)].position.y());
    INFO(i << ": " << sunk);
    if (std::is_same_v<Real, double>) CHECK(sunk == Approx(i * 1e-6).epsilon(0.02));
    else CHECK(std::abs(sunk) < 1e-4);
  }
}

TEST_CASE("a seat above 0 and a part of 0 to 1 are needed") {
  const auto said = [](Real seat, Real beta) {
    return complaint([=] {
      World world;
      slope(world);
      Swept solver;
      solver.seat = seat;
      solver.Seat::beta = beta;
      world.step(solver, h, 1);
    });
  };
  const Real nan = std::numeric_limits<Real>::quiet_NaN(), infinity = std::numeric_limits<Real>::infinity();
  CHECK(said(0, 0).empty());
  CHECK(said(1, 1).empty());
  CHECK(contains(said(Real(-0.5), Real(0.2)), "seat is -0.5: a finite number, 0 or more, is needed"));
  CHECK(contains(said(nan, Real(0.2)), "seat is nan"));
  CHECK(contains(said(infinity, Real(0.2)), "seat is inf"));
  CHECK(contains(said(0, Real(1.5)), "beta is 1.5: a number from 0 to 1 is needed"));
  CHECK(contains(said(0, Real(-0.5)), "beta is -0.5: a number from 0 to 1 is needed"));
  CHECK(contains(said(0, nan), "beta is nan"));
}

TEST_CASE("a seat changes nothing of a bounce") {
  const auto hash_after = [](auto solver) {
    World world;
    motion_named("bounce").fill(world);
    solver.threshold = 0;
    std::vector<std::uint64_t> hashes;
    for (int step = 0; step < 16 * 150; ++step) {
      world.step(solver, h / 16, 4);
      hashes.push_back(hash_of(world));
    }
    return hashes;
  };
  Swept wide;
  wide.seat = Real(1e-4);
  const auto without = hash_after(Solver<Clamping, Baumgarte, Restitution, FrictionCone, WarmStart>{});
  CHECK(hash_after(Swept{}) == without);
  CHECK(hash_after(wide) == without);
}

TEST_CASE("a direct contact solve leaves no step farther off than what is too far, and pushes up what falls") {
  const auto fill = GENERATE(four_high, slope);
  const bool exact = GENERATE(false, true);  // then nothing but the tolerance is near enough
  World world;
  fill(world);
  Direct solver;
  if (exact) solver.too_far = solver.tolerance;
  for (int step = 0; step < 60; ++step) {
    world.step(solver, h, 0);
    INFO("step " << step << ", residual " << solver.residual);
    REQUIRE(solver.residual <= solver.too_far);
  }
  CHECK(solver.residual > 0);
  if (fill == slope) {  // m g cos 30 deg, and in 1 s along a t^2 / 2, half a step late
    const double weight = 100 * g * static_cast<double>(h) * std::sqrt(0.75), a = g * (0.5 - 0.4 * std::sqrt(0.75));
    const double close = exact ? 1e-4 : solver.too_far;
    CHECK(solver.pushes == Approx(weight).epsilon(close));
    const Vec3 start(Real(0.125), Real(0.25) * std::sqrt(Real(0.75)), 0);
    CHECK(static_cast<double>((world.bodies[1].position - start).norm()) ==
          Approx(a / 2 * (1 + 1.0 / 60)).epsilon(1e-4));
  }
}

TEST_CASE(
    "where Newton's method may not go on from the guess, the step is solved from nothing, or left to the sweeps") {
  Direct never;
  never.rounds = 0;
  Direct content = never;
  content.too_far = std::numeric_limits<double>::infinity();
  for (Direct* solver : {&never, &content}) {
    World world;
    four_high(world);
    for (int step = 0; step < 20; ++step) world.step(*solver, h, 0);
  }
  CHECK(never.residual <= never.too_far);
  CHECK(content.residual > never.too_far);
}

TEST_CASE("a direct contact solve, twice: the same bits") {
  const auto fill = GENERATE(four_high, slope);
  std::vector<std::uint64_t> hashes;
  for (int again = 0; again < 2; ++again) {
    World world;
    fill(world);
    Direct solver;
    for (int step = 0; step < 60; ++step) world.step(solver, h, 1);
    hashes.push_back(hash_of(world));
  }
  CHECK(hashes[0] == hashes[1]);
}

TEST_CASE("nothing touches: nothing to solve directly") {
  World world;
  world.add(sphere(1, 1));
  Direct solver;
  world.step(solver, h, 1);
  CHECK(world.bodies[0].velocity.y() == Approx(-g * static_cast<double>(h)));
}
