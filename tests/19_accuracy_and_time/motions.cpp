/// Chapter 19: motions whose every position is known, what is known of them, and the programs that play them.
#include <fmt/format.h>

#include <cmath>
#include <random>

#include "pushback/chapters/08_friction_cone/friction_cone.h"
#include "pushback/chapters/09_impacts/simultaneous.h"
#include "pushback/chapters/13_joints/scenes.h"
#include "pushback/chapters/19_accuracy_and_time/rest_depth.h"
#include "pushback/chapters/19_accuracy_and_time/truth.h"
#include "pushback/common/world/measure.h"
#include "pushback/common/world/situations.h"
#include "pushback/engine/direct/row_matrix.h"
#include "pushback/engine/direct/solve_best.h"
#include "pushback/engine/direct/warm_direct_contacts.h"
#include "pushback/tools/measure/study/every_motion.h"
#include "pushback/tools/measure/study/relaxed_law.h"
#include "tests/19_accuracy_and_time/errors_in.h"
#include "tests/support/call.h"
#include "tests/support/catch.h"
#include "tests/support/complaint.h"

using namespace pushback;
using joints_scenes::largest_joint_error;

namespace {

constexpr double g = truth::g;

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
    const double z = 0.3 * number(random), y = number(random), x = number(random);
    const Eigen::Vector3d at(x, y, z);
    bool is_free = true;
    for (const Eigen::Vector3d& other : found.at) is_free = is_free && (at - other).norm() > 0.25;
    if (!is_free) continue;
    found.at.push_back(at);
    const double v_z = number(random), v_y = number(random), v_x = number(random);
    found.velocities.emplace_back(-3 * at + 2 * Eigen::Vector3d(v_x, v_y, v_z));
  }
  return found;
}

/// What all have between two frames; of straight flight, if nothing met between them.
Places speeds_between(const Places& before, const Places& after) {
  Places found;
  for (std::size_t i = 0; i < before.size(); ++i) found.emplace_back((after[i] - before[i]) * frames_per_second);
  return found;
}

/// Sums over all balls, each of 1 kg.
struct Sums {
  Eigen::Vector3d place = Eigen::Vector3d::Zero(), momentum = place, turning = place;
  double squares = 0;

  Sums(const Places& at, const Places& velocities) {
    for (std::size_t i = 0; i < at.size(); ++i) {
      place += at[i];
      momentum += velocities[i];
      turning += at[i].cross(velocities[i]);
      squares += velocities[i].squaredNorm();
    }
  }
};

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

TEST_CASE("balls that collide keep momentum and turning momentum, and with e = 1 their energy") {
  for (unsigned seed = 1; seed <= 20; ++seed) {
    const Thrown balls = thrown(seed, 9);
    const Sums begin(balls.at, balls.velocities);
    for (const double e : {1.0, 0.6, 0.0}) {
      const int frames = 300;  // long after the last have met
      const std::vector<Places> places =
          truth::places_of_colliding(balls.at, balls.velocities, balls.radius, e, frames);
      REQUIRE(std::ssize(places) == frames);
      INFO(seed << ", e = " << e);
      double off = 0, overlap = 0;
      for (std::size_t frame = 0; frame < places.size(); ++frame) {
        const double t = (static_cast<double>(frame) + 1) / frames_per_second;
        off = std::max(off, (Sums(places[frame], balls.velocities).place - begin.place - t * begin.momentum).norm());
        for (std::size_t i = 0; i < places[frame].size(); ++i)
          for (std::size_t j = 0; j < i; ++j)
            overlap = std::max(overlap, 2 * balls.radius - (places[frame][i] - places[frame][j]).norm());
      }
      CHECK(off < 1e-11);
      CHECK(overlap < 1e-10);
      const Places last = speeds_between(places[frames - 2], places[frames - 1]);
      const Sums end(places[frames - 1], last);
      CHECK((end.turning - begin.turning).norm() < 1e-9);
      if (e == 1) CHECK(end.squares == Approx(begin.squares).epsilon(1e-11));
      else CHECK(end.squares < 0.999 * begin.squares);
      CHECK(farthest_apart({last}, {balls.velocities}) > 0.01);
    }
  }
}

TEST_CASE("a ball comes up to e^2 of the height that it fell from, each time, and lies at last") {
  const double height = 2, fall = std::sqrt(2 * height / g);
  for (const double e : {0.0, 0.5, 0.8, 1.0}) {
    double hit = fall;  // s
    INFO(e);
    for (int k = 1; k <= 6; ++k) {
      const double up = std::pow(e, k) * fall, apex = truth::height_of_bouncing(height, e, hit + up);
      CHECK(truth::height_of_bouncing(height, e, hit) == Approx(0).margin(1e-12));
      CHECK(apex == Approx(std::pow(e, 2 * k) * height).margin(1e-12));
      for (const double part : {0.9, 1.1}) CHECK(truth::height_of_bouncing(height, e, hit + part * up) <= apex);
      hit += 2 * up;
    }
    if (e < 1) CHECK(truth::height_of_bouncing(height, e, 100) == Approx(0).margin(1e-12));
  }
}

TEST_CASE("what slides has stopped after v^2 / 2a, and what rolls goes on with 5/7 of its speed") {
  const double v = 6, a = 4.9, mu = 0.3;
  CHECK(truth::way_of_sliding(v, a, 100) == Approx(v * v / (2 * a)));
  CHECK(truth::way_of_sliding(v, a, v / a / 2) == Approx(0.75 * v * v / (2 * a)));
  const double changes = 2 * v / (7 * mu * g), d = 1e-6;
  const auto speed = [&](double t) {
    return (truth::way_of_rolling(v, mu, t + d) - truth::way_of_rolling(v, mu, t - d)) / (2 * d);
  };
  CHECK(speed(d) == Approx(v).epsilon(1e-5));
  CHECK(speed(changes / 2) == Approx(v - mu * g * changes / 2).epsilon(1e-5));
  // The momentum about a point of the ground is kept: m v r = (m r^2 + 2/5 m r^2) v' / r
  for (const double t : {changes - 2 * d, changes + 2 * d, 50.0}) CHECK(speed(t) == Approx(5 * v / 7).epsilon(1e-5));
  CHECK(truth::way_of_rolling(v, mu, changes) == Approx(v * changes - mu * g * changes * changes / 2));
}

// ---- motions ---------------------------------------------------------------------------------------------------------

TEST_CASE("nobody overlaps as a motion begins, and each joint holds") {
  for (const Motion& motion : all_motions()) {
    INFO(motion.name);
    World world;
    motion.begin(world);
    world.find_contacts();
    CHECK(deepest_overlap(world) < 1e-12);
    CHECK(largest_joint_error(world) < 1e-12);
  }
}

TEST_CASE("the truth of each motion moves as far as a law says") {
  const auto last = [](const char* name) {
    const Motion& motion = motion_named(name);
    World world;
    motion.fill(world);
    return Eigen::Vector3d(motion.truth(motion.frames()).back().back() - world.bodies.back().position.cast<double>());
  };
  const double margin = 1e-12;
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

std::vector<std::string> methods_of(const std::string& motion) {
  std::vector<std::string> names;
  for (const std::string& line : lines_of(call_program(MOTION_PROGRAM, motion).out))
    names.push_back(line.substr(0, line.find('/')));
  return names;
}

}  // namespace

TEST_CASE("what cannot be played is refused, with the value and what is allowed, before anything is played") {
  for (const auto& [arguments, said] : std::vector<std::pair<std::string, std::vector<std::string>>>{
           {"nothing", {"'nothing'", "bounce", "break"}},
           {"bounce nothing/1/1", {"'nothing'", "full", "direct-contacts", "plays bounce"}},
           {"bounce full/1/1 joints/1/1", {"'joints'", "full", "plays bounce"}},
           {"bounce full/0/1", {"'0' in 'full/0/1'", "from 1 to 65536"}},
           {"bounce full/99999999999/1", {"'99999999999'", "from 1 to 65536"}},
           {"bounce full/1/0", {"'0' in 'full/1/0'", "from 1 to 1048576"}},
           {"bounce full/4", {"'full/4'", "full/SMALL-STEPS/SWEEPS"}},
           {"bounce full/4/1.5", {"'1.5'", "a whole number"}},
           {"bounce full/1/1 --at-most nan", {"--at-most", "nan", "3600"}},
           {"bounce full/1/1 --at-least -1", {"--at-least", "-1", "60"}}}) {
    const Ended ended = call_program(MOTION_PROGRAM, arguments);
    INFO(arguments << ": " << ended.out << ended.err);
    CHECK(ended.status == 2);
    CHECK(ended.out.empty());
    for (const std::string& part : said) CHECK(contains(ended.err, part));
  }
}

// ---- our methods -----------------------------------------------------------------------------------------------------

TEST_CASE("half the step is half the error: of what slides, and of what swings") {
  const auto halves = [](const std::string& motion, const std::string& method, const std::string& sweeps) {
    std::string settings;
    for (const char* substeps : {"8", "16", "32", "64"}) settings += method + "/" + substeps + "/" + sweeps + " ";
    const auto errors = errors_in(MOTION_PROGRAM, motion, settings);
    REQUIRE(errors.size() == 4);
    for (std::size_t i = 1; i < errors.size(); ++i) {
      INFO(motion << ", " << method << ": " << errors[i - 1] << ", then " << errors[i] << " m");
      CHECK(errors[i] / errors[i - 1] == Approx(0.5).margin(0.1));
    }
  };
  for (const std::string& method : methods_of("sliding"))
    if (!method.starts_with("full")) halves("sliding", method, "4");
  for (const std::string& method : methods_of("pendulum")) halves("pendulum", method, "1");
}

// ---- a rest depth, and direct contacts --------------------------------------------------------------------------------------

namespace {

using Swept = Solver<Clamping, Baumgarte, RestDepth, Restitution, FrictionCone, WarmStart>;

using Direct = Solver<Clamping, Baumgarte, RestDepth, Restitution, FrictionCone, WarmStart, WarmDirectContacts>;

constexpr Real h = Real(1) / 60;

}  // namespace

TEST_CASE("one box comes to rest as deep as its rest depth, by the same part each step: from above, and from below") {
  const Real rest_depth = Real(1e-3);
  for (const Real beta : {Real(0.1), Real(0.2), Real(0.5)}) {
    for (const Real start : {Real(0.0001) * rest_depth, 4 * rest_depth}) {
      World world;
      world.add(ground());
      world.add(box(Vec3::Constant(Real(0.5)), 100).at({0, Real(0.5) - start, 0}));
      Swept solver;
      solver.rest_depth = rest_depth;
      solver.RestDepth::beta = beta;
      solver.Baumgarte::beta = beta;
      double missing = static_cast<double>(rest_depth - start);
      for (int step = 0; step < 100; ++step) {
        world.step(solver, h, 50);
        missing *= 1 - static_cast<double>(beta);
        const double depth = 0.5 - static_cast<double>(world.bodies[1].position.y());
        INFO(beta << " from " << start << ", step " << step);
        REQUIRE(rest_depth - depth == Approx(missing).epsilon(1e-6).margin(1e-9));
      }
    }
  }
}

TEST_CASE("ten boxes solved directly end ten rest depths deep") {
  World world;
  stack(world, 10);
  Direct solver;
  for (int step = 0; step < 100; ++step) world.step(solver, h, 1);
  for (int i = 1; i <= 10; ++i) {
    const double sunk = i - 0.5 - static_cast<double>(world.bodies[static_cast<std::size_t>(i)].position.y());
    INFO(i << ": " << sunk);
    CHECK(sunk == Approx(i * 1e-6).epsilon(0.02));
  }
}

// ---- the relaxed law: what lifts a sliding body off is the law, and no engine's way of solving it ----------------------

namespace {

Vector projected(const ContactProblem& problem, Vector r) {
  for (Eigen::Index i = 0; i < problem.contacts(); ++i)
    r.segment<3>(3 * i) = projected_to_cone(r.segment<3>(3 * i), problem.mu[i]);
  return r;
}

/// The minimum of  r^T W r / 2 + q^T r  over the cones, by projected gradients with Nesterov's momentum, until a step changes
/// speeds by nothing that counts.
Vector relaxed(const ContactProblem& problem) {
  const double step = 1 / Eigen::MatrixXd(problem.w).norm();  // the norm is no less than the largest eigenvalue
  Vector r = Vector::Zero(problem.q.size()), ahead = r;
  double weight = 1;
  for (int i = 0; i < 20000; ++i) {
    const Vector next = projected(problem, ahead - step * problem.speeds(ahead));
    const double next_weight = (1 + std::sqrt(1 + 4 * weight * weight)) / 2;
    const bool turned_back = (ahead - next).dot(next - r) > 0;  // then momentum begins anew
    ahead = turned_back ? next : next + (weight - 1) / next_weight * (next - r);
    weight = turned_back ? 1 : next_weight;
    r = next;
  }
  return r;
}

}  // namespace

TEST_CASE("by the relaxed law alone each contact of a body that slides parts with mu times its slip") {
  for (const char* name : {"sliding", "rolling"}) {
    INFO(name);
    const Motion& motion = motion_named(name);
    constexpr double dt = 1.0 / 960;
    World world;  // about to take its first step
    motion.fill(world);
    world.begin_step(dt);
    const ContactProblem problem = problem_of(world);
    const double mu = problem.mu[0];
    const Vector r = relaxed(problem), u = problem.speeds(r);
    REQUIRE((projected(problem, r) - r).norm() == 0);
    CHECK(std::abs(r.dot(u)) < 1e-9 * r.norm());
    // As predicted, less gravity's part of the step:   mu (v - k mu g h) / (1 + k mu^2)
    const Hop hop = *hop_of(motion);
    const Vec3& v = world.bodies.back().velocity;
    const double slip = std::hypot(static_cast<double>(v.x()), static_cast<double>(v.z()));
    const double k = (mu * slip / hop.speed - 1) / (mu * mu);
    const double wanted = mu * (slip - k * mu * truth::g * dt) / (1 + k * mu * mu);
    for (Eigen::Index i = 0; i < problem.contacts(); ++i) {
      CHECK(u[3 * i] == Approx(wanted).epsilon(1e-9));
      CHECK(u[3 * i] == Approx(mu * u.segment<2>(3 * i + 1).norm()).epsilon(1e-9));
    }
    // Coulomb's law, solved on the same problem: no contact parts.
    const Vector exact = problem.speeds(solve_best(problem).r);
    for (Eigen::Index i = 0; i < problem.contacts(); ++i) {
      CHECK(std::abs(exact[3 * i]) < 1e-9);
      CHECK(exact.segment<2>(3 * i + 1).norm() == Approx(slip - k * mu * truth::g * dt).epsilon(1e-9));
    }
  }
}

TEST_CASE("only what is sent along the ground hops") {
  CHECK(hop_of(motion_named("sliding"))->speed == Approx(2.4));
  CHECK(hop_of(motion_named("sliding"))->error == Approx(9 / (2 * truth::g * std::pow(1.25, 1.5))));
  CHECK(hop_of(motion_named("rolling"))->speed == Approx(1.8 / 1.315));
  for (const Motion& motion : every_motion())
    CHECK(hop_of(motion).has_value() == (motion.name == "sliding" || motion.name == "rolling"));
}
