/// The ragdoll of chapter 15: how many ways it can move, and what it keeps as it falls.
#include <Eigen/QR>

#include "pushback/chapters/15_limits_motors_springs/ragdoll.h"
#include "pushback/common/world/measure.h"
#include "pushback/tools/catalogue/solvers.h"
#include "tests/support/catch.h"
#include "tests/support/complaint.h"
#include "tests/support/joint_jacobian.h"
#include "tests/support/substeps.h"
#include "tests/support/yardstick.h"

using namespace pushback;
using namespace pushback::limits_motors_springs_scenes;

namespace {

/// Rank of the rows that hold with equality.
long rank_of_joints(const World& world) {
  Eigen::Matrix<Real, Eigen::Dynamic, Eigen::Dynamic> J(0, 6 * static_cast<Eigen::Index>(world.bodies.size()));
  for (const Joint& joint : world.joints) {
    for (const Equation& row : asked_by(joint, body_of(world, joint.a), body_of(world, joint.b))) {
      if (row.lo == 0) continue;
      J.conservativeResize(J.rows() + 1, J.cols());
      J.row(J.rows() - 1).setZero();
      J.block(J.rows() - 1, 6 * joint.a, 1, 6) << -row.jacobian.n.transpose(), -row.jacobian.ra_n.transpose();
      J.block(J.rows() - 1, 6 * joint.b, 1, 6) << row.jacobian.n.transpose(), row.jacobian.rb_n.transpose();
    }
  }
  return Eigen::ColPivHouseholderQR<decltype(J)>(J).rank();
}

}  // namespace

TEST_CASE("a ragdoll has 28 ways to move: 6 as a whole, 3 in each of 6 sockets, 1 in each of 4 hinges") {
  World world;
  add_ragdoll(world, Vec3::Zero());
  CHECK(world.bodies.size() == 11);
  CHECK(66 - rank_of_joints(world) == 28);
}

TEST_CASE("however a ragdoll is turned, it is whole, within its limits, and does not touch itself") {
  Random random(1);
  for (int i = 0; i < 50; ++i) {
    World world;
    const Real angle = i == 0 ? 0 : random.between(-3, 3);
    const Vec3 axis = random.direction();
    const Ragdoll man = add_ragdoll(world, random.vector(3), Quat(Eigen::AngleAxis<Real>(angle, axis)));
    CHECK(stretch(world, man) < Real(1e-15));
    CHECK(bent_backwards(world, man) < Real(1e-15));
    for (const Joint& joint : world.joints) {
      for (const Equation& row : asked_by(joint, body_of(world, joint.a), body_of(world, joint.b)))
        if (row.lo == 0) CHECK(row.error > Real(-1e-15));
    }
    world.find_contacts();
    CHECK(world.contacts.empty());
  }
  World world;
  const Ragdoll man = add_ragdoll(world, {0, ragdoll_hips_over, 0});
  CHECK(std::abs(body_of(world, man.head).position.y() + Real(0.11) - ragdoll_height) < Real(0.02));
  world.add(ground());
  world.find_contacts();
  for (const Contact& contact : world.contacts) CHECK(contact.depth < Real(1e-12));
}

TEST_CASE("a ragdoll falls down the stairs: it holds together, bends no knee backwards, and comes to rest") {
  for (const bool soft : {false, true}) {  // in substeps with soft contacts and a relaxing pass it holds far better
    World world;
    const Ragdoll man = down_the_stairs(world);
    AnySolver solver = solver_named(soft ? "12 soft contacts" : "07 warm start").solver;
    Real stretched = 0, backwards = 0;
    for (int step = 0; step < 600; ++step) {
      if (soft) world.step(solver, h);
      else substeps(world, solver, h, 2, 15);
      stretched = std::max(stretched, stretch(world, man));
      backwards = std::max(backwards, bent_backwards(world, man));
    }
    CAPTURE(soft, stretched, backwards, largest_speed(world));
    CHECK(body_of(world, man.pelvis).position.y() < 1);
    CHECK(stretched < (soft ? Real(0.005) : Real(0.03)));
    CHECK(backwards < (soft ? 1 : 3) * pi / 180);
    CHECK(largest_speed(world) < Real(0.1));
  }
}

TEST_CASE("face down on a bench his shins stay up, and hang where nothing limits the knees") {
  for (const bool limited : {true, false}) {
    World world;
    const Ragdoll man = face_down_on_a_bench(world);
    if (!limited) std::erase_if(world.joints, [](const Joint& joint) { return joint.name == "angle limits"; });
    AnySolver solver = solver_named("07 warm start").solver;
    for (int step = 0; step < 120; ++step) world.step(solver, h);
    CAPTURE(limited, bent_backwards(world, man) * 180 / pi);
    for (const int shin : man.shins) {
      const Real rises = (body_of(world, shin).orientation * Vec3::UnitY()).y();  // 1: it hangs, its foot down
      CHECK((limited ? std::abs(rises) < Real(0.2) : rises > Real(0.9)));
    }
  }
}

TEST_CASE("stairs and ragdolls that cannot be are refused, by name") {
  World world;
  CHECK(complaint([&] { add_stairs(world, 0); }) == "stairs have 0 steps: 1 or more are needed");
  CHECK(complaint([&] { add_stairs(world, 3, -1); }) == "rise of stairs is -1: a finite number above 0 is needed");
  CHECK(complaint([&] { add_stairs(world, 3, 1, 0); }) == "run of stairs is 0: a finite number above 0 is needed");
  const Real nan = std::numeric_limits<Real>::quiet_NaN();
  CHECK(complaint([&] { add_ragdoll(world, {nan, 0, 0}); }) ==
        "hips of a ragdoll is (nan, 0, 0): three finite numbers are needed");
  CHECK(world.bodies.empty());
}
