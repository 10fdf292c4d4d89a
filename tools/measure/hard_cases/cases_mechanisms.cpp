/// Mechanisms: a four-bar linkage that swings through its dead points, and a motor that holds a door against a limit.
#include <cmath>

#include "pushback/chapters/13_joints/hinge.h"
#include "pushback/chapters/15_limits_motors_springs/limits.h"
#include "pushback/chapters/15_limits_motors_springs/motor.h"
#include "pushback/common/world/measure.h"
#include "pushback/tools/measure/hard_cases/cases.h"
#include "pushback/tools/measure/hard_cases/gap.h"

namespace pushback {

namespace {

// ---- four-bar ------------------------------------------------------------------------------------------------------------

constexpr Real crank_length = 2, coupler_length = 5, bar_thickness = Real(0.1);  // m
constexpr Real of_a_metre = 5;                                                   // kg
constexpr int crank_body = 0;

/// A bar from `from` to `to`, in the plane z = 0. Returns its index.
int bar(World& world, const Vec3& from, const Vec3& to) {
  const Vec3 way = to - from;
  const Vec3 half{way.norm() / 2, bar_thickness / 2, bar_thickness / 2};
  return world.add(
      box(half, of_a_metre * way.norm()).turned(std::atan2(way.y(), way.x()), Vec3::UnitZ()).at((from + to) / 2));
}

/// Two equal cranks and a coupler as long as the distance of the pins, so a parallelogram. The cranks are let go 60 degrees above
/// the horizontal. Where they are horizontal all bars lie in one line: the dead point. There the equations of the hinges depend
/// on each other, and the linkage may go on as a parallelogram or fold into an antiparallelogram.
void four_bar(World& world) {
  const Vec3 left = Vec3::Zero(), right{coupler_length, 0, 0};
  const Vec3 out = crank_length * Vec3(std::cos(pi / 3), std::sin(pi / 3), 0);
  const int first = bar(world, left, left + out), coupler = bar(world, left + out, right + out),
            rocker = bar(world, right, right + out);
  world.joints.push_back(hinge(world, the_world, first, left, Vec3::UnitZ()));
  world.joints.push_back(hinge(world, first, coupler, left + out, Vec3::UnitZ()));
  world.joints.push_back(hinge(world, the_world, rocker, right, Vec3::UnitZ()));
  world.joints.push_back(hinge(world, coupler, rocker, right + out, Vec3::UnitZ()));
}

/// The criteria are what both ways on have in common: the hinges hold, the energy stays, and the crank comes through. The energy is in
/// % of what a fall to the lowest point sets free. A step that turns the speed by w h keeps the part cos(w h) of it, so it takes w^2 h
/// of the kinetic energy a second (see `ball-and-chain`). With w^2 = 6 / s^2 in the mean, that is 3 % in 10 s of substeps of 1/1920 s.
std::vector<Real> through_dead_points(Trial& trial) {
  Play play = trial.play(four_bar, [](const World& world) {
    Allowance allowance = standing(world);
    allowance.energy *= crank_length / 100 / Real(0.001);  // of lifting all by a hundredth of a crank
    return allowance;
  });
  const auto energy = [](const World& world) { return kinetic_energy(world) + potential_energy(world); };
  const Real start = energy(play.world);
  constexpr Real lifted = of_a_metre * (crank_length + coupler_length) * crank_length;  // kg m, the cranks' by half
  const Real fall = World::g * lifted * (1 + std::sin(pi / 3));
  Real gap = 0, height = 1;
  int passed = 0;
  play.run(10, frame, [&](const World& world) {
    for (const Joint& joint : world.joints) gap = std::max(gap, gap_of(world, joint));
    const Real before = std::exchange(height, world.bodies[crank_body].position.y());
    if (before * height < 0) ++passed;
  });
  constexpr int asked = 4;
  return {1000 * gap, 100 * std::abs(energy(play.world) - start) / fall,
          static_cast<Real>(std::max(0, asked - passed))};
}

// ---- a motor at a limit ----------------------------------------------------------------------------------------------------

constexpr Real door_half_width = Real(0.5), door_half_depth = Real(0.02), door_mass = 30;  // m, m, kg
constexpr Real motor_torque = 10, motor_speed = 1, door_limit = Real(1.5);                 // N m, rad/s, rad

/// About the hinge, which is at an edge of the door, kg m^2.
constexpr Real door_inertia =
    door_mass * (4 * door_half_width * door_half_width + door_half_depth * door_half_depth) / 3;

void door(World& world) {
  world.gravity.setZero();
  const int leaf = world.add(box({door_half_width, 1, door_half_depth}, door_mass).at({door_half_width, 0, 0}));
  world.joints.push_back(hinge(world, the_world, leaf, Vec3::Zero(), Vec3::UnitY()));
  world.joints.push_back(angle_limits(world, the_world, leaf, Vec3::UnitY(), Real(-0.5), door_limit));
  world.joints.push_back(motor_at_speed(world, the_world, leaf, Vec3::UnitY(), motor_speed, motor_torque));
}

/// rad, after t s:   T t^2 / (2 I) until the speed is reached at t = I w / T, then w t - I w^2 / (2 T), up to the limit.
Real angle_of_door(Real t) {
  const Real reached = door_inertia * motor_speed / motor_torque;
  const Real angle = t < reached ? motor_torque * t * t / (2 * door_inertia) : motor_speed * (t - reached / 2);
  return std::min(angle, door_limit);
}

/// Looks at 0.8 s, while it accelerates; at 1.6 s, as it turns at the speed asked for; and from 3 s on, when it is held.
std::vector<Real> motor_at_limit(Trial& trial) {
  Play play = trial.play(door);
  const auto angle = [](const World& world) {
    const Vec3 along = world.bodies[0].orientation * Vec3::UnitX();
    return std::atan2(-along.z(), along.x());
  };
  Real off = 0, beyond = 0, away = 0, fastest = 0, time = 0;
  play.run(5, frame, [&](const World& world) {
    time += frame;
    const Real now = angle(world);
    beyond = std::max(beyond, now - door_limit);
    if (time < Real(1.7)) off = std::max(off, std::abs(now - angle_of_door(time)));
    if (time < 3) return;
    away = std::max(away, std::abs(now - door_limit));
    fastest = std::max(fastest, world.bodies[0].angular_velocity.norm());
  });
  return {1000 * off, 1000 * beyond, 1000 * away, 1000 * fastest};
}

}  // namespace

std::vector<HardCase> mechanism_cases() {
  HardCase linkage;
  linkage.name = "four-bar";
  linkage.title = "a four-bar linkage";
  linkage.stresses = "all bars come into one line, where the equations of the hinges depend on each other";
  linkage.criteria = {{"largest gap of a hinge", "mm", 5},  // a thousandth of the coupler
                      {"energy changed in 10 s", "%", 5},
                      {"dead points not passed, of four", "", 0}};
  linkage.scene = {.name = linkage.title, .fill = four_bar, .camera = view({Real(2.5), 0, 0}, 8), .seconds = Real(0.5)};
  linkage.run = through_dead_points;

  HardCase held;
  held.name = "motor-at-limit";
  held.title = "a motor against a limit";
  held.stresses =
      "a motor drives a door to the limit of its hinge and goes on pushing: two rows about one axis disagree";
  held.criteria = {{"angle on the way, off by", "mrad", 10},
                   {"beyond the limit", "mrad", 1},
                   {"from the limit, once held", "mrad", 1},
                   {"speed, once held", "mrad/s", 1}};
  held.scene = {.name = held.title, .fill = door, .camera = {{Real(1.6), 2, 3}, {Real(0.3), 0, 0}}, .seconds = 1};
  held.run = motor_at_limit;

  return {linkage, held};
}

}  // namespace pushback
