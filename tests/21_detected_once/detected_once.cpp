/// Contacts detected once in a step: what is neglected and of which order, and that what rests ends where it does when contacts are
/// detected in each substep.
#include "pushback/chapters/21_detected_once/detected_once.h"

#include "pushback/chapters/11_substeps/scenes.h"
#include "pushback/chapters/13_joints/ball_and_socket.h"
#include "pushback/chapters/21_detected_once/scenes.h"
#include "pushback/chapters/21_detected_once/study.h"
#include "pushback/common/world/measure.h"
#include "pushback/tools/measure/hard_cases/sliding.h"
#include "tests/support/catch.h"
#include "tests/support/complaint.h"
#include "tests/support/substeps.h"
#include "tests/support/yardstick.h"

using namespace pushback;

namespace {

using detected_once_scenes::DetectedInEach, detected_once_scenes::WithoutMargin;
constexpr int many = 32;

/// The same scene moved on for so many seconds by both.
struct Both {
  World once, each;

  template <class Fill>
  Both(const Fill& fill, Real seconds, int count = many) {
    fill(once);
    fill(each);
    DetectedOnce of_once;
    of_once.substeps = count;
    DetectedInEach of_each;
    const int steps = static_cast<int>(std::lround(seconds / h));
    for (int i = 0; i < steps; ++i) {
      once.step(of_once, h);
      substeps(each, of_each, h, count);
    }
  }
  /// m, of any centre of mass.
  Real apart() const {
    Real largest = 0;
    for (std::size_t i = 0; i < once.bodies.size(); ++i)
      largest = std::max(largest, (once.bodies[i].position - each.bodies[i].position).norm());
    return largest;
  }
};

Real drift(const World& world) {
  const Vec3& top = world.bodies.back().position;
  return std::hypot(top.x(), top.z());
}

}  // namespace

TEST_CASE("detected once: C_0 + J dX is C to rounding where bodies only shift, and to second order in the turn") {
  // A corner at r from the centre of a box that turns by w t about an axis square to the normal: C - C_0 - J dX = -(w t)^2 r.n / 2
  constexpr Real rate = 2;
  const Vec3 way(Real(0.3), Real(-0.1), Real(0.2));
  std::vector<Real> errors;
  for (const Real spin : {Real(0), rate}) {
    for (const Real t : {h / 2, h / 4, h / 8}) {
      World world;
      world.gravity.setZero();
      world.add(ground());
      world.add(box(Vec3::Constant(Real(0.5)), 10).at({0, Real(0.45), 0}).moving(way).spinning({0, 0, spin}));
      DetectedOnce solver;
      solver.substeps = 1;
      world.find_contacts({.least = Real(0.1)});
      REQUIRE(world.contacts.size() == 4);
      std::vector<KeptBody> bodies{{&world.bodies[0]}, {&world.bodies[1]}};
      bodies[1].displacement = t * way;
      bodies[1].rotation = t * Vec3(0, 0, spin);
      std::vector<KeptContact> kept;
      for (std::size_t i = 0; i < 4; ++i) kept.emplace_back(world, i, 0, 1);
      const Contacts before = world.contacts;
      world.bodies[1].position += t * way;
      world.bodies[1].turned(t * spin, Vec3::UnitZ());
      world.find_contacts({.least = Real(0.1)});
      REQUIRE(world.contacts.size() == 4);
      Real largest = 0;
      for (std::size_t i = 0; i < 4; ++i) {
        REQUIRE(world.contacts[i].id == before[i].id);
        const Real error = -world.contacts[i].depth - kept[i].separation(bodies);
        const Real r_n = before[i].point.y() - before[i].depth / 2 - Real(0.45);  // of the box's corner, along n
        if (spin == 0) CHECK(std::abs(error) <= 8 * eps);
        else CHECK(error == Approx(-r_n * t * t * spin * spin / 2).epsilon(0.05));
        largest = std::max(largest, std::abs(error));
      }
      if (spin != 0) errors.push_back(largest);
    }
  }
  for (std::size_t i = 1; i < errors.size(); ++i) CHECK(std::log2(errors[i - 1] / errors[i]) == Approx(2).margin(0.05));
}

TEST_CASE(
    "detected once: what rests on a single contact rests as deep as the spring of chapter 12 says, however the step is "
    "cut") {
  for (const int count : {4, 8, 32}) {
    World ball, cube;
    ball.add(ground());
    ball.add(sphere(Real(0.3), 10).at({0, Real(0.299), 0}));
    stack(cube, 1);
    DetectedOnce solver;
    solver.substeps = count;
    for (int i = 0; i < 300; ++i) {
      ball.step(solver, h);
      cube.step(solver, h);
    }
    const Real w = solver.spring.angular_frequency(h / static_cast<Real>(count));
    CHECK(deepest_overlap(ball) == Approx(g / (w * w)).epsilon(in_double ? 1e-6 : 0.05));
    CHECK(deepest_overlap(cube) == Approx(g / (w * w)).epsilon(in_double ? 1e-6 : 0.05));
  }
}

TEST_CASE("detected once: what rests, holds or slides is where it is on contacts detected in each of 32 substeps") {
  for (const int boxes : {10, 40}) {
    const Both both([boxes](World& world) { stack(world, boxes); }, 10);
    INFO(boxes << " boxes: drift " << drift(both.once) << " and " << drift(both.each) << " m, apart " << both.apart());
    CHECK(drift(both.once) < Real(0.5e-3));
    CHECK(both.apart() < Real(0.5e-3));
    CHECK(largest_speed(both.once) < Real(1e-3));
    CHECK(deepest_overlap(both.once) == Approx(deepest_overlap(both.each)).epsilon(0.01));
  }
  const Real w = 2 * pi * 240;
  for (const Real ratio : {Real(100), Real(1000)}) {
    const Both both(substeps_scenes::HeavyOnLight{ratio}, 5);
    INFO("1 : " << ratio);
    CHECK(deepest_overlap(both.once) == Approx((1 + ratio) * g / (w * w)).epsilon(in_double ? 1e-3 : 0.05));
    CHECK(both.apart() < Real(1e-4));
  }
  for (const Real mu : {Real(0.5), Real(0.3)})
    CHECK(Both([mu](World& world) { box_on_slope(world, Real(0.35), mu); }, 2).apart() < Real(1e-4));
  CHECK(Both([](World& world) { sliding_box(world, Real(0.5), 5, Real(0.3)); }, 2).apart() < Real(1e-4));
}

TEST_CASE("detected once: the error of a cube that rolls is proportional to the length of the step") {
  // The same substeps of 1/1920 s; contacts detected once in 32, 16, 8, 4 of them, against in each.
  const detected_once_scenes::RollingCube cube{.spin = 6};
  const int all = 192;  // substeps: a tenth of a second, until just before its next face lands
  const auto place = [&](auto solver, int in_a_step) {
    World world;
    cube(world);
    solver.substeps = in_a_step;
    for (int i = 0; i < all / in_a_step; ++i) world.step(solver, h * static_cast<Real>(in_a_step) / many);
    return world.bodies[1].position;
  };
  const Vec3 truth = place(DetectedOnce{}, 1);
  std::vector<Real> errors;
  for (const int in_a_step : {32, 16, 8, 4}) errors.push_back((place(DetectedOnce{}, in_a_step) - truth).norm());
  for (std::size_t i = 1; i < errors.size(); ++i) {
    INFO(errors[i - 1] << " m, then " << errors[i] << " m");
    CHECK(std::log2(errors[i - 1] / errors[i]) == Approx(1).margin(0.3));
  }
}

TEST_CASE("detected once: what arrives fast is met where it arrives, and without a margin a step too late") {
  // Where in a step it arrives is luck: the deepest of eight starts.
  for (const Real speed : {Real(2), Real(5), Real(20)}) {
    const auto deepest = [&](auto solver) {
      Real lowest = 1;
      for (int start = 0; start < 8; ++start) {
        World world;
        world.add(ground());
        const Real above = (2 + static_cast<Real>(start) / 8) * speed * h;
        world.add(sphere(Real(0.5), 10).at({0, Real(0.5) + above, 0}).moving({0, -speed, 0}));
        for (int i = 0; i < 6; ++i) {
          world.step(solver, h);
          lowest = std::min(lowest, world.bodies[1].position.y());
        }
      }
      return Real(0.5) - lowest;
    };
    INFO(speed << " m/s: " << deepest(DetectedOnce{}) << " m deep; without a margin " << deepest(WithoutMargin{}));
    // Of the way of a substep what the spring lets through, 1 / (1 + K / gamma); and where it comes to rest.
    const Real w = DetectedOnce{}.spring.angular_frequency(h / many), hw = h / many * w;
    const Real let_through = 1 / (1 + hw * (2 * DetectedOnce{}.spring.damping_ratio + hw));
    CHECK(deepest(DetectedOnce{}) < let_through * speed * h / many + 2 * g / (w * w));
    CHECK(deepest(WithoutMargin{}) > Real(0.3) * speed * h);
  }
}

TEST_CASE("detected once: a ball bounces to e^2 of its height, in however many substeps") {
  for (const Real e : {Real(0.5), Real(0.9), Real(1)}) {
    for (const int count : {8, 32}) {
      const detected_once_scenes::FallingBall ball{.speed = 5, .restitution = e};
      World world;
      ball(world);
      const Real height = world.bodies[1].position.y() - Real(0.5);
      DetectedOnce solver;
      solver.substeps = count;
      Real apex = 0;
      bool up = false;
      for (int i = 0; i < 120; ++i) {
        world.step(solver, h);
        const Body& it = world.bodies[1];
        up = up || it.velocity.y() > 0;
        if (up && it.velocity.y() < 0) break;
        if (up) apex = std::max(apex, it.position.y() - Real(0.5) + it.velocity.y() * it.velocity.y() / (2 * g));
      }
      INFO("e = " << e << ", " << count << " substeps: " << apex << " of " << height);
      // v += h g, x += h v  keeps v^2 / 2 + g y - h g v / 2 instead of v^2 / 2 + g y
      CHECK(std::abs(apex - e * e * height) < 5 * h / static_cast<Real>(count));
      if (in_double) CHECK(std::abs(apex - e * e * height) < Real(0.03) * height);
    }
  }
}

TEST_CASE(
    "detected once: between two walls without gravity a ball is where its mirror images say, after many bounces") {
  World world;
  world.gravity.setZero();
  const Real inner = Real(1.5), speed = 7;  // m, from wall to wall for its centre
  world.add(half_space(Vec3::UnitX()).at({-Real(0.5), 0, 0}).bouncy(1).rough(0));
  world.add(half_space(-Vec3::UnitX()).at({inner + Real(0.5), 0, 0}).bouncy(1).rough(0));
  world.add(sphere(Real(0.5), 3).at({Real(0.3), 0, 0}).moving({speed, 0, 0}).bouncy(1).rough(0));
  DetectedOnce solver;
  for (int i = 1; i <= 300; ++i) {
    world.step(solver, h);
    const Real along = std::fmod(Real(0.3) + speed * h * static_cast<Real>(i), 2 * inner);
    const Real expected = along < inner ? along : 2 * inner - along;
    INFO("step " << i);
    REQUIRE(world.bodies[2].position.x() == Approx(expected).margin(in_double ? 1e-5 : 1e-2));
    REQUIRE(std::abs(world.bodies[2].velocity.x()) == Approx(speed).epsilon(in_double ? 1e-9 : 1e-3));
  }
}

TEST_CASE("detected once: what collides off its centre and passes fast keeps its angular momentum") {
  for (const Real e : {Real(0), Real(0.5)}) {
    World world;
    world.gravity.setZero();
    world.add(box({Real(0.5), Real(0.3), Real(0.4)}, 20).at({0, 0, 0}).spinning({1, 2, 3}).bouncy(e));
    world.add(box({Real(0.3), Real(0.6), Real(0.2)}, 7).at({-2, Real(0.5), Real(0.1)}).moving({12, 0, 0}).bouncy(e));
    const Vec3 before = angular_momentum(world), linear = momentum(world);
    DetectedOnce solver;
    for (int i = 0; i < 40; ++i) world.step(solver, h);
    CHECK(world.bodies[0].velocity.norm() > 1);  // it was hit
    CHECK((angular_momentum(world) - before).norm() < (in_double ? Real(1e-10) : Real(1e-2)) * before.norm());
    CHECK((momentum(world) - linear).norm() < (in_double ? Real(1e-12) : Real(1e-3)) * linear.norm());
  }
}

TEST_CASE("detected once: without contacts joints move in the bits of chapter 14, in as many substeps") {
  World once, each;
  for (World* world : {&once, &each}) {
    for (int i = 0; i < 5; ++i) {
      world->add(box({Real(0.1), Real(0.3), Real(0.1)}, 1)
                     .at({0, Real(5) - static_cast<Real>(i), 0})
                     .moving({1, 0, Real(0.2)}));
      world->joints.push_back(
          ball_and_socket(*world, i == 0 ? the_world : i - 1, i, {0, Real(5.5) - static_cast<Real>(i), 0}));
    }
  }
  DetectedOnce of_once;
  RelaxingSolver<SteadyJoints> of_each;
  for (int i = 0; i < 60; ++i) {
    once.step(of_once, h);
    substeps(each, of_each, h, many);
    REQUIRE(hash_of(once) == hash_of(each));
  }
}

TEST_CASE("detected once: a setting that cannot be used is refused by name, and nothing has moved") {
  const auto refused = [](const std::string& name, const std::function<void(DetectedOnce&)>& change) {
    World world;
    stack(world, 1);
    const std::uint64_t before = hash_of(world);
    DetectedOnce solver;
    change(solver);
    INFO(name);
    CHECK(complaint([&] { world.step(solver, h); }).find(name) != std::string::npos);
    CHECK(hash_of(world) == before);
  };
  refused("substeps is 0: a whole number, 1 or more", [](DetectedOnce& s) { s.substeps = 0; });
  refused("most_rounds is 0: a whole number, 1 or more", [](DetectedOnce& s) { s.most_rounds = 0; });
  refused("margin", [](DetectedOnce& s) { s.margin = -1; });
  refused("threshold", [](DetectedOnce& s) { s.threshold = -1; });
  refused("carried_from", [](DetectedOnce& s) { s.carried_from = -1; });
  refused("precision", [](DetectedOnce& s) { s.precision = -1; });
  refused("hertz", [](DetectedOnce& s) { s.spring.hertz = 0; });
  refused("beta", [](DetectedOnce& s) { s.joints.beta = -1; });
}
