/// Chapter 13 in motion: what beads, pendulums, chains and ropes do against closed forms.
#include <Eigen/LU>

#include "pushback/chapters/14_joints_under_load/jointed_solver.h"
#include "pushback/chapters/14_joints_under_load/structures.h"
#include "pushback/chapters/14_joints_under_load/study.h"
#include "pushback/common/world/measure.h"
#include "tests/support/catch.h"
#include "tests/support/random.h"
#include "tests/support/yardstick.h"

using namespace pushback;

namespace {

using Rigid = Solver<WarmJoints>;
using RigidCold = Solver<Joints>;
using Matrix = Eigen::Matrix<Real, Eigen::Dynamic, Eigen::Dynamic>;

Real energy(const World& world) {
  return kinetic_energy(world) + potential_energy(world);
}

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

TEST_CASE("09: every scene starts with its joints in place") {
  for (const auto& fill : std::vector<std::function<void(World&)>>{
           beads_on_wires, Pendulums{}, ChainWithWeight{}, door_and_weld, ropes, cloth_over_ball, suspension_bridge}) {
    World world;
    fill(world);
    REQUIRE(!world.joints.empty());
    CHECK(largest_joint_error(world) <= 64 * eps);
  }
}

TEST_CASE("09: a bead that is not fed back leaves a ring outwards, r'^2 = r^2 + h^2 v^2, and keeps r v") {
  Random random(1);
  for (int i = 0; i < 50; ++i) {
    World world;
    world.gravity.setZero();
    const Real radius = random.between(Real(0.5), 2), speed = random.between(1, 5), angle = random.between(0, 6);
    const int bead = world.add(sphere(Real(0.1), random.between(1, 10))
                                   .at(radius * Vec3(std::cos(angle), std::sin(angle), 0))
                                   .moving(speed * Vec3(-std::sin(angle), std::cos(angle), 0)));
    world.joints.push_back(bead_on(world, ellipse(0, 0, radius, radius), bead));
    auto solver = with_joint_beta<Rigid>(0);
    const Body& body = world.bodies[0];
    for (int step = 0; step < 200; ++step) {
      const Real before = body.position.squaredNorm();
      world.step(solver, h, 1);
      REQUIRE(body.position.squaredNorm() == Approx(before + h * h * body.velocity.squaredNorm()).epsilon(16 * eps));
      // The speed belongs to the place where the row was made, one step of it back.
      const Real moment = (body.position - h * body.velocity).cross(body.velocity).norm();
      REQUIRE(moment == Approx(radius * speed).epsilon(2000 * eps));
    }
  }
}

TEST_CASE("09: beads on wires never win energy where nothing is fed back, and lose m |dV|^2 / 2 in a step") {
  World world;
  beads_on_wires(world);
  auto solver = with_joint_beta<Rigid>(0);
  for (int step = 0; step < 300; ++step) {
    const Real before = energy(world);
    world.step(solver, h, 1);
    REQUIRE(world.contacts.empty());
    Real lost = 0;
    for (const Body& bead : world.bodies) lost += (bead.velocity - bead.velocity_before).squaredNorm() / 2;  // 1 kg
    REQUIRE(std::abs(energy(world) - before + lost) <= 1000 * eps * (100 + lost));  // J: m v^2 / 2 of some m/s
    REQUIRE(energy(world) < before);
    for (const Row& row : solver.joint_rows()) REQUIRE(std::abs(row.impulse * row.speed()) <= 1000 * eps);  // no work
  }
}

TEST_CASE("09: what is fed back wins energy, and keeps beads on their wires") {
  World world;
  beads_on_wires(world);
  auto solver = with_joint_beta<Rigid>(Real(0.2));
  Real most = 0, farthest = 0;
  for (int step = 0; step < 300; ++step) {
    const Real before = energy(world);
    world.step(solver, h, 1);
    most = std::max(most, energy(world) - before);
    farthest = std::max(farthest, largest_joint_error(world));
  }
  CHECK(most > Real(0.01));
  CHECK(farthest < Real(0.05));
}

TEST_CASE("09: a distance that is off comes to its length as C_0 (1 - beta)^k") {
  for (const Real beta : {Real(0.1), Real(0.2), Real(0.5)}) {
    World world;
    world.gravity.setZero();
    world.add(sphere(Real(0.1), 1).at({0, 0, 0}));
    world.add(sphere(Real(0.1), 3).at({0, 0, 2}));
    world.joints.push_back(distance(world, 0, world.bodies[0].position, 1, world.bodies[1].position, Real(1.5)));
    auto solver = with_joint_beta<Rigid>(beta);
    for (int k = 1; k <= 60; ++k) {
      world.step(solver, h, 1);
      REQUIRE(largest_joint_error(world) == Approx(std::pow(1 - beta, k) / 2).margin(64 * eps));
    }
  }
}

TEST_CASE("09: a ball on a rod and a plank on a hinge swing in 4 sqrt(L / g) K(sin(theta / 2)), to the second order") {
  const Real ball = Pendulums{}.period(rod_length), plank = Pendulums{}.period(length_of_plank());
  const auto errors = [&](Real steps) {
    const Periods measured = measured_periods(1 / steps, Real(0.2));
    return std::pair(std::abs(measured.ball / ball - 1), std::abs(measured.plank / plank - 1));
  };
  const auto coarse = errors(480), fine = errors(960);
  if (in_double) {  // 3e-5: the rounding of float is of that size
    CHECK(fine.first < Real(2.5e-5));
    CHECK(fine.second < Real(2.5e-5));
    CHECK(coarse.first / fine.first > Real(3.5));  // 4, as the step goes to 0
    CHECK(coarse.second / fine.second > Real(3.5));
  } else {
    CHECK(fine.first < Real(1e-3));
    CHECK(fine.second < Real(1e-3));
  }
}

TEST_CASE("09: warm starting and feedback: two weights settle where beta < (1 - rho) / rho, and else do not") {
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

TEST_CASE("09: with the push apart two weights settle for every beta, and however few the sweeps") {
  for (const Real ratio : {Real(2), Real(20), Real(80)}) {
    for (const int sweeps : {1, 4}) {
      for (const Real beta : {Real(0.05), Real(0.5), Real(1)}) {
        INFO(ratio << " times as heavy, " << sweeps << " sweeps, beta " << beta);
        CHECK(settles<Solver<SplitJoints>>(ratio, sweeps, beta));
      }
    }
  }
}

TEST_CASE("09: the chain with the weight takes 189 sweeps to settle with beta = 0.2, and 188 are not enough") {
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

TEST_CASE("09: a cold chain hangs longer, by what the sweeps leave: (h / beta) (1 - H)^-1 H J g h") {
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

TEST_CASE("09: a rope at rest hangs as the catenary of its links") {
  World world;
  ropes(world);
  auto solver = with_joint_beta<JointedSolver>(Real(0.02));
  for (int step = 0; step < 20 * 600; ++step) world.step(solver, h / 10, 4);
  const HangingRope closed;
  for (std::size_t i = 0; i < closed.places.size(); ++i)
    CHECK((world.bodies[i + 1].position - closed.places[i]).norm() < (in_double ? Real(1e-6) : Real(1e-3)));
  // It is one: the pull is the same all along, and each link is steeper than the one before by a particle's weight.
  const Real weight = Real(0.1) * Real(9.81);
  for (std::size_t i = 0; i + 1 < closed.places.size(); ++i) {
    const Vec3 way = closed.places[i + 1] - closed.places[i];
    CHECK(way.norm() == Approx(rope_link).epsilon(1000 * eps));
    const Real rise = way.y() / way.x() * closed.pull * weight;
    CHECK(rise == Approx((static_cast<Real>(i) + 1 - Real(rope_links - 1) / 2) * weight).margin(1e-4 * weight));
  }
}
