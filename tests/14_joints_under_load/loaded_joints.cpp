/// Chapter 14: what chains and ropes do under load, against closed forms.
#include <Eigen/LU>

#include "pushback/chapters/13_joints/study.h"
#include "pushback/chapters/14_joints_under_load/jointed_solver.h"
#include "pushback/chapters/14_joints_under_load/scenes.h"
#include "pushback/chapters/14_joints_under_load/structures.h"
#include "pushback/common/world/measure.h"
#include "tests/support/catch.h"
#include "tests/support/yardstick.h"

using namespace pushback;
using namespace pushback::joints_scenes;
using namespace pushback::joints_under_load_scenes;

namespace {

using Rigid = Solver<WarmJoints>;
using RigidCold = Solver<Joints>;
using Matrix = Eigen::Matrix<Real, Eigen::Dynamic, Eigen::Dynamic>;

/// What an impulse of row j does to the speed of row i: J M^-1 J^T, as the world's joints stand.
Matrix effect_of_rows(World& world) {
  RigidCold solver;
  solver.solve(world, h, 0);
  const JointRows& rows = solver.joint_rows();
  Matrix a(rows.size(), rows.size());
  for (std::size_t j = 0; j < rows.size(); ++j) {
    for (Body& body : world.bodies) body.velocity = body.angular_velocity = Vec3::Zero();
    Row acting = rows[j];
    acting.apply(1);
    for (std::size_t i = 0; i < rows.size(); ++i) a(static_cast<int>(i), static_cast<int>(j)) = rows[i].speed();
  }
  for (Body& body : world.bodies) body.velocity = body.angular_velocity = Vec3::Zero();
  return a;
}
/// What a sweep makes of the error of the impulses: -L^-1 U, L the lower triangle with its diagonal, U the rest.
Matrix sweep_of(const Matrix& a) {
  const Matrix lower = a.triangularView<Eigen::Lower>();
  return -lower.inverse() * (a - lower);
}
/// Of the error that converges the slowest, the part that a sweep leaves: the largest eigenvalue, which any error comes to
/// show that is swept often enough. All are real and from 0 to 1, since A is symmetric.
Real left_by_sweep(World& world) {
  const Matrix sweep = sweep_of(effect_of_rows(world));
  Matrix error = Matrix::Ones(sweep.rows(), 1);
  Real left = 0;
  for (int i = 0; i < 5000; ++i) {
    error = sweep * error;
    left = error.norm();
    error /= left;
  }
  return left;
}

/// Two weights below each other, the lower `ratio` times as heavy, knocked; they have 80,000 steps.
template <class JointSolver>
bool settles(Real ratio, int sweeps, Real beta) {
  World world;
  world.gravity.setZero();  // it only moves the middle of the swings
  world.add(sphere(Real(0.1), 1).at({0, -1, 0}));
  world.add(sphere(Real(0.1), ratio).at({0, -2, 0}));
  world.joints = {distance(world, the_world, Vec3::Zero(), 0, {0, -1, 0}),
                  distance(world, 0, {0, -1, 0}, 1, {0, -2, 0})};
  REQUIRE(left_by_sweep(world) == Approx(ratio / (1 + ratio)).epsilon(64 * eps));
  world.bodies[1].moving({0, -Real(0.01), 0});
  auto solver = with_joint_beta<JointSolver>(beta);
  for (int step = 0; step < 80000; ++step) {
    world.step(solver, h, sweeps);
    if (largest_joint_error(world) > Real(0.3)) return false;
  }
  return largest_joint_error(world) < (in_double ? Real(1e-9) : Real(1e-4));
}

}  // namespace

TEST_CASE("14: joints start from the impulses of the last step: what hangs still needs no sweep") {
  World world;
  for (int link = 0; link < 5; ++link) {
    world.add(capsule(Real(0.1), Real(0.3), 2).at({0, Real(-0.5) - static_cast<Real>(link), 0}));
    world.joints.push_back(ball_and_socket(world, link - 1, link, {0, -static_cast<Real>(link), 0}));
  }
  Solver<WarmJoints> solver;
  for (int step = 0; step < 200; ++step) world.step(solver, h, 50);
  REQUIRE(largest_speed(world) < Real(1e-9));
  world.step(solver, h, 0);
  CHECK(largest_speed(world) < Real(1e-9));
  world.step(solver, 2 * h, 0);  // an impulse is a force times dt
  CHECK(largest_speed(world) < Real(1e-9));
  for (Joint& joint : world.joints) joint.last_impulses.clear();
  world.step(solver, h, 0);
  CHECK(std::abs(largest_speed(world) - (h * World::g)) < Real(1e-9));
}

TEST_CASE("14: warm starting and feedback: two weights settle where beta < (1 - rho) / rho, and else do not") {
  for (const Real ratio : {Real(2), Real(5), Real(20), Real(80)}) {
    for (const int sweeps : {1, 2, 4}) {
      const Real left = std::pow(ratio / (1 + ratio), sweeps), bound = (1 - left) / left;
      if (bound > Real(0.9)) continue;
      INFO(ratio << " times as heavy, " << sweeps << " sweeps, bound " << bound);
      CHECK(settles<Rigid>(ratio, sweeps, Real(0.95) * bound));
      CHECK_FALSE(settles<Rigid>(ratio, sweeps, Real(1.05) * bound));
    }
  }
}

TEST_CASE("14: with a split impulse two weights settle for every beta, and however few the sweeps") {
  for (const Real ratio : {Real(2), Real(20), Real(80)}) {
    for (const int sweeps : {1, 4}) {
      for (const Real beta : {Real(0.05), Real(0.5), Real(1)}) {
        INFO(ratio << " times as heavy, " << sweeps << " sweeps, beta " << beta);
        CHECK(settles<Solver<SplitJoints>>(ratio, sweeps, beta));
      }
    }
  }
}

TEST_CASE("14: the chain with the weight takes 189 sweeps to settle with beta = 0.2, and 188 are not enough") {
  World start;
  const ChainWithWeight chain;
  chain(start);
  const Real beta = Real(0.2);
  const int enough = static_cast<int>(std::ceil(-std::log(1 + beta) / std::log(left_by_sweep(start))));
  CHECK(enough == 189);
  if (!in_double) return;  // how slowly it grows or decays there is below the rounding of float
  const auto growth = [&](int sweeps) {
    World world = start;
    auto solver = with_joint_beta<Rigid>(beta);
    Real early = 0, late = 0;
    for (int step = 0; step < 4000; ++step) {
      world.step(solver, h, sweeps);
      Real& largest = step < 2000 ? early : late;
      if (step >= 1000 && (step < 2000 || step >= 3000)) largest = std::max(largest, std::abs(chain.stretch(world)));
    }
    return late / early;
  };
  CHECK(growth(enough) < Real(0.9));
  CHECK(growth(enough - 1) > Real(1.1));
}

TEST_CASE("14: a cold chain hangs longer, by what the sweeps leave: (h / beta) (1 - H)^-1 H J g h") {
  World world;
  const ChainWithWeight chain;
  chain(world);
  const Real beta = Real(0.2);
  const int sweeps = 10;
  const Matrix a = effect_of_rows(world);
  Matrix power = Matrix::Identity(a.rows(), a.cols());
  for (int i = 0; i < sweeps; ++i) power = sweep_of(a) * power;
  const Matrix left = a * power * a.inverse();  // H: of the error of the speeds
  Matrix falling = Matrix::Zero(a.rows(), 1);   // J g h: only the first ball and socket holds on to what does not fall
  falling(1) = world.gravity.y() * h;
  const Matrix one = Matrix::Identity(a.rows(), a.cols());
  const Matrix c = h / beta * (one - left).inverse() * left * falling;
  Real longer = 0;
  for (int row = 1; row < c.rows(); row += 3) longer -= c(row, 0);

  auto solver = with_joint_beta<RigidCold>(beta);
  for (int step = 0; step < 6000; ++step) world.step(solver, h, sweeps);
  CHECK(chain.stretch(world) ==
        Approx(longer / (static_cast<Real>(chain.links) * link_length)).epsilon(in_double ? Real(1e-6) : Real(1e-2)));
}

TEST_CASE("14: a rope at rest hangs as the catenary of its links") {
  World world;
  ropes(world);
  auto solver = with_joint_beta<JointedSolver>(Real(0.02));
  for (int step = 0; step < 20 * 600; ++step) world.step(solver, h / 10, 4);
  const HangingRope closed;
  for (std::size_t i = 0; i < closed.places.size(); ++i)
    CHECK((world.bodies[i + 1].position - closed.places[i]).norm() < (in_double ? Real(1e-6) : Real(1e-3)));
  // It is one: the pull is the same all along, and each link is steeper than the one before by a particle's weight.
  const Real weight = Real(0.1) * World::g;
  for (std::size_t i = 0; i + 1 < closed.places.size(); ++i) {
    const Vec3 way = closed.places[i + 1] - closed.places[i];
    CHECK(way.norm() == Approx(rope_link).epsilon(1000 * eps));
    const Real rise = way.y() / way.x() * closed.pull * weight;
    CHECK(rise == Approx((static_cast<Real>(i) + 1 - Real(rope_links - 1) / 2) * weight).margin(1e-4 * weight));
  }
}
