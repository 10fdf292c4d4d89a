// What acts on a body in a step is what the step says, under every solver: forces put on by hand, contacts, joints.
#include "pushback/chapters/13_joints/ball_and_socket.h"
#include "pushback/chapters/13_joints/hinge.h"
#include "pushback/chapters/15_limits_motors_springs/limits.h"
#include "pushback/chapters/15_limits_motors_springs/motor.h"
#include "pushback/common/bodies/random.h"
#include "pushback/common/world/measure.h"
#include "pushback/engine/presets.h"
#include "pushback/tools/catalogue/solvers.h"
#include "pushback/tools/measure/hard_cases/momentum_account.h"
#include "tests/support/catch.h"
#include "tests/support/yardstick.h"

using namespace pushback;

namespace {

struct Accounted {
  std::string name;
  AnySolver solver;
  Real epsilon;  // of the numbers that impulses are in
};

std::vector<Accounted> all_tried() {
  std::vector<Accounted> all;
  for (const NamedSolver& one : all_solvers()) all.push_back({one.name, one.solver, eps});
  all.push_back({"Recommended", Recommended{}, eps});
  Recommended within;
  within.error = Real(1e-3);
  all.push_back({"Recommended, 1 mm", within, eps});
  all.push_back({"Exact", Exact{}, eps});
  all.push_back({"Fast", Fast{}, std::numeric_limits<float>::epsilon()});
  return all;
}

}  // namespace

TEST_CASE("momentum: what is put on a body by hand acts for the whole step, however the step is divided") {
  for (const Accounted& tried : all_tried()) {
    for (const Real spin : {Real(0), Real(3), Real(40)}) {  // of a wheel with which the others have nothing to do
      INFO(tried.name << ", " << spin << " rad/s");
      AnySolver solver = tried.solver;
      Random random(7);
      World world;
      world.gravity.setZero();
      for (int i = 0; i < 4; ++i) world.add(random.moving_body(random.between(1, 10)).at({10 * Real(i), 0, 0}));
      if (solver.supports_joints()) {  // motors: substeps move what they turn
        const int wheel = world.add(sphere(Real(0.5), 1).at({100, 0, 0}).spinning({0, spin, 0}));
        world.joints.push_back(hinge(world, the_world, wheel, {100, 0, 0}, Vec3::UnitY()));
        world.joints.push_back(motor_at_speed(world, the_world, wheel, Vec3::UnitY(), spin, 10));
        world.joints.push_back(motor_at_speed(world, the_world, 0, Vec3::UnitY(), 1, Real(0)));
      }
      for (int step = 0; step < 5; ++step) {
        std::vector<std::pair<Vec3, Vec3>> before, by_hand;
        for (std::size_t i = 0; i < 4; ++i) {
          Body& body = world.bodies[i];
          body.force = random.vector(100);
          body.torque = random.vector(10);
          by_hand.emplace_back(body.force, body.torque);
          before.emplace_back(body.velocity / body.inverse_mass, spin_momentum(body));
        }
        world.step(solver, h);
        for (std::size_t i = 0; i < 4; ++i) {
          INFO("body " << i << ", step " << step);
          const Body& body = world.bodies[i];
          const auto& [force, torque] = by_hand[i];
          const auto& [p, L] = before[i];
          CHECK((body.velocity / body.inverse_mass - p - h * force).norm() <= 1e3 * eps * (p.norm() + 1));
          CHECK((spin_momentum(body) - L - h * torque).norm() <= 1e5 * eps * (L.norm() + 1));
          CHECK(body.force.isZero(0));
          CHECK(body.torque.isZero(0));
        }
      }
    }
  }
}

TEST_CASE("momentum: a ball and a box that bounce, alone and on each other, report the impulse of the impact") {
  for (const Accounted& tried : all_tried()) {
    if (tried.name == "00 naive" || tried.name < "05") continue;  // they know no bounce
    for (const bool ball : {true, false}) {
      for (const int count : {1, 2}) {
        INFO(tried.name << (ball ? ", balls: " : ", boxes: ") << count);
        AnySolver solver = tried.solver;
        World world;
        world.add(ground());
        for (int i = 0; i < count; ++i)
          world.add((ball ? sphere(Real(0.25), 10) : box(Vec3::Constant(Real(0.25)), 10))
                        .at({Real(0.01) * Real(i), Real(1.25) + Real(0.51) * Real(i), 0})
                        .bouncy(Real(0.8)));
        MomentumAccount account(world);
        Real reported = 0;
        for (int step = 0; step < 48; ++step) {  // 0.8 s
          world.step(solver, h);
          REQUIRE(account.look(world, h, tried.epsilon) == "");
          for (const Contact& contact : world.contacts)
            if (contact.id.body_a == 0) reported += contact.impulse.y();
        }
        CHECK(reported > 10 * std::sqrt(2 * g));  // what stops the lowest of them, at least
      }
    }
  }
}

TEST_CASE("momentum: what has parted is listed with its impulse, and is no contact for the next step") {
  World world;
  world.add(ground());
  const Real e = Real(0.8), fall = 1, radius = Real(0.25), mass = 10;
  world.add(sphere(radius, mass).at({0, radius + fall, 0}).bouncy(e));
  Recommended solver;
  int listed = 0;
  for (int step = 0; step < 48; ++step) {
    world.step(solver, h);
    for (const Contact& contact : world.contacts) {
      CHECK(contact.parted);
      CHECK(contact.last_impulse.isZero(0));
      CHECK(contact.impulse.y() == Approx(mass * (1 + e) * std::sqrt(2 * g * fall)).epsilon(1e-6));
      ++listed;
    }
    CHECK(std::none_of(world.contacts_before.begin(), world.contacts_before.end(),
                       [](const Contact& contact) { return contact.parted; }));
  }
  CHECK(listed == 1);
}

TEST_CASE("momentum: a hanging weight's joint bears its weight, whatever divides the step, with a limit or without") {
  const Real mass = 10;
  for (const Accounted& tried : all_tried()) {
    if (!tried.solver.supports_joints()) continue;
    for (const bool limited : {false, true}) {
      for (const Real dt : {h, h / 4}) {
        INFO(tried.name << (limited ? ", with a limit, " : ", ") << dt << " s");
        AnySolver solver = tried.solver;
        World world;
        const int load = world.add(sphere(Real(0.2), mass));
        world.joints.push_back(ball_and_socket(world, the_world, load, {0, 1, 0}));
        if (limited) world.joints.push_back(cone_limit(world, the_world, load, Vec3::UnitY(), Vec3::UnitY(), 1));
        for (int step = 0; step < 20; ++step) world.step(solver, dt);
        REQUIRE(world.joints[0].impulses.size() == 3);
        const std::vector<Real>& p = world.joints[0].impulses;
        CHECK(Vec3(p[0], p[1], p[2]).norm() / dt == Approx(mass * g).epsilon(1e-3));
      }
    }
  }
}

TEST_CASE("momentum: joints report what they gave, in a chain that whips and meets the ground") {
  for (const Accounted& tried : all_tried()) {
    if (!tried.solver.supports_joints()) continue;
    INFO(tried.name);
    AnySolver solver = tried.solver;
    World world;
    world.add(ground());
    int above = the_world;
    for (int i = 0; i < 4; ++i) {
      const Vec3 end(Real(i), Real(2.5), 0);
      const int link = world.add(box({Real(0.4), Real(0.1), Real(0.1)}, 1 + Real(i)).at(end + Vec3(Real(0.5), 0, 0)));
      world.joints.push_back(i % 2 == 0 ? ball_and_socket(world, above, link, end)
                                        : hinge(world, above, link, end, Vec3::UnitZ()));
      above = link;
    }
    MomentumAccount account(world);
    for (int step = 0; step < 90; ++step) {
      world.step(solver, h);
      INFO("step " << step);
      REQUIRE(account.look(world, h, tried.epsilon) == "");
    }
  }
}
