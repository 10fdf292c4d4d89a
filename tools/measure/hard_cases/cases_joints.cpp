/// What is joined: long chains of rows with a load at the end that outweighs each of them by far; a four-bar linkage that swings through
/// its dead points, and a motor that holds a door against a limit.
#include <cmath>

#include "pushback/chapters/15_limits_motors_springs/motor.h"
#include "pushback/chapters/15_limits_motors_springs/ragdoll.h"
#include "pushback/common/basics/shortest_turn.h"
#include "pushback/common/world/forces.h"
#include "pushback/common/world/measure.h"
#include "pushback/tools/measure/hard_cases/standing.h"

namespace pushback {

namespace {

/// %, of the length of all that is joined in one line: how much longer the gaps make it.
Real stretch_of(const World& world, Real length) {
  Real gaps = 0;
  for (const Joint& joint : world.joints) gaps += gap_of(world, joint);
  return 100 * gaps / length;
}

// ---- chains --------------------------------------------------------------------------------------------------------------

constexpr int links = 10;
constexpr Real link_length = Real(0.5), chain_length = links * link_length;  // m

/// Links of 1 kg from the origin along `way`, on balls and sockets, and a load at the last.
void chain(World& world, const Vec3& way, Body load, Real from_end) {
  const Quat turned = shortest_turn(Vec3::UnitY(), way);
  for (int i = 0; i < links; ++i) {
    const Real along = link_length * static_cast<Real>(i);
    Body link = capsule(Real(0.05), Real(0.2), 1).at((along + link_length / 2) * way);
    link.orientation = turned;
    const int index = world.add(link);
    world.joints.push_back(ball_and_socket(world, i == 0 ? the_world : index - 1, index, along * way));
  }
  const int last = world.add(load.at((chain_length + from_end) * way));
  world.joints.push_back(ball_and_socket(world, last - 1, last, chain_length * way));
}
void weight_on_chain(World& world, const Vec3& way) {
  chain(world, way, sphere(Real(0.25), 100), Real(0.25));
}
void ball_on_chain(World& world) {
  chain(world, Vec3::UnitX(), sphere(Real(0.4), 1000), Real(0.4));
}

/// What a chain that is let go from the horizontal comes to in 10 s.
struct Swing {
  Real stretch = 0;  // %, the most
  Real lost = 0;     // %, of the energy that the fall to the lowest point sets free, at the end
};
Swing swing(Trial& trial, const std::function<void(World&)>& fill) {
  Play play = trial.play(fill, lifting(chain_length / 100));
  const auto energy = [](const World& world) { return kinetic_energy(world) + potential_energy(world); };
  const Body load = play.world.bodies.back();
  const Real start = energy(play.world);
  const Real fall = play.world.gravity.norm() * load.position.norm() / load.inverse_mass;
  const Real stretch = play.largest(10, [](const World& world) { return stretch_of(world, chain_length); });
  return {stretch, 100 * (start - energy(play.world)) / fall};
}

void let_go(World& world) {
  weight_on_chain(world, Vec3::UnitX());
}
std::vector<Real> hanging_and_swinging(Trial& trial) {
  Play hanging = trial.play([](World& world) { weight_on_chain(world, -Vec3::UnitY()); }, standing);
  const Stood s = stand(hanging, 10);
  return {stretch_of(hanging.world, chain_length), 1000 * s.jitter, swing(trial, let_go).stretch};
}

/// A step turns the speed v of what goes round by w h and keeps the part of it that the chain allows, v cos(w h): of the
/// kinetic energy T it takes w^2 h T a second. Let go from the horizontal, a pendulum of length L has a mean of w^2 T of
/// 2 g / (3 L) m g L: in 10 s and substeps of 1/1920 s, 0.63 %, and in steps of 1/60 s 20 %.
std::vector<Real> ball_and_chain(Trial& trial) {
  const Swing s = swing(trial, ball_on_chain);
  return {s.stretch, s.lost};
}

// ---- a bridge ------------------------------------------------------------------------------------------------------------

constexpr int planks = 20;
constexpr Real plank_length = Real(0.5), plank_mass = 20;  // m, kg

/// Planks on hinges along an arc of 60 degrees that hangs between two posts, and a load of 100 planks in the middle. The
/// air is thick, so that all comes to rest: the slowest sway by a factor e in 5 s, however well it is solved.
void bridge(World& world) {
  constexpr Real turn = pi / 180 * 3;
  const Real radius = plank_length / (2 * std::sin(turn / 2));
  const auto corner = [&](int i) {
    const Real angle = turn * (static_cast<Real>(i) - Real(planks) / 2);
    return Vec3(radius * std::sin(angle), -radius * std::cos(angle) + radius * std::cos(turn * planks / 2), 0);
  };
  const auto post = [&](const Vec3& end, Real side) {
    return world.add(box({Real(0.25), 1, Real(0.6)}, 1).fixed().at(end + Vec3(Real(0.25) * side, -1, 0)));
  };
  int before = post(corner(0), -1);
  const int right = post(corner(planks), 1);
  for (int i = 0; i < planks; ++i) {
    const Real tilt = turn * (static_cast<Real>(i) + Real(0.5) - Real(planks) / 2);
    const Vec3 middle = (corner(i) + corner(i + 1)) / 2;
    const int plank =
        world.add(box({plank_length / 2, Real(0.04), Real(0.5)}, plank_mass).turned(tilt, Vec3::UnitZ()).at(middle));
    world.joints.push_back(hinge(world, before, plank, corner(i), Vec3::UnitZ()));
    world.forces.push_back(drag(plank, 4 * plank_mass));
    before = plank;
  }
  world.joints.push_back(hinge(world, before, right, corner(planks), Vec3::UnitZ()));
  constexpr Real side = Real(0.4), mass = 100 * plank_mass;
  const int load = world.add(box(Vec3::Constant(side), mass).at(corner(planks / 2) + Vec3(0, side + Real(0.055), 0)));
  world.forces.push_back(drag(load, 4 * mass));
}

std::vector<Real> loaded_bridge(Trial& trial) {
  Play play = trial.play(bridge, standing);
  constexpr Real length = planks * plank_length;
  const Real most = play.largest(29, [](const World& world) { return stretch_of(world, length); });
  const Real fastest = play.largest(1, largest_speed);
  const Vec3& load = play.world.bodies.back().position;
  return {stretch_of(play.world, length), most, 1000 * fastest, 1000 * std::hypot(load.x(), load.z())};
}

// ---- a ragdoll -----------------------------------------------------------------------------------------------------------

std::vector<Real> ragdoll_on_stairs(Trial& trial) {
  using namespace limits_motors_springs_scenes;
  Ragdoll man{};
  Play play = trial.play([&man](World& world) { man = down_the_stairs(world); }, lifting(ragdoll_height / 100));
  Real gap = 0, backwards = 0;
  const auto look = [&](const World& world) {
    gap = std::max(gap, stretch(world, man));
    backwards = std::max(backwards, bent_backwards(world, man));
  };
  play.run(9, frame, look);
  const Real fastest = play.largest(1, [&](const World& world) {
    look(world);
    return largest_speed(world);
  });
  return {100 * gap, 180 / pi * backwards, 1000 * fastest};
}

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
  Play play = trial.play(four_bar, lifting(crank_length / 100));
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

std::vector<HardCase> joint_cases() {
  return {{.name = "heavy-chain",
           .title = "chain, 1 : 100",
           .stresses = "ten links carry a hundred times the mass of one, hanging and swinging",
           // Of 5 m: 1 mm hanging, 10 mm swinging, which is what the best engine of those measured does.
           .criteria = {{"stretch hanging", "%", Real(0.02)},
                        {"speed in the last second, hanging", "mm/s", 1},
                        {"stretch swinging", "%", Real(0.2)}},
           .scene = seen(let_go, view({0, Real(-2.7), 0}, 8), Real(1.5)),
           .run = hanging_and_swinging},
          {.name = "ball-and-chain",
           .title = "ball and chain, 1 : 1000",
           .stresses = "a ball that outweighs a link a thousand times, let go from the horizontal",
           .criteria = {{"stretch", "%", 1}, {"energy lost in 10 s", "%", 1}},
           .scene = seen(ball_on_chain, view({0, Real(-2.7), 0}, 8), Real(1.5)),
           .run = ball_and_chain},
          {.name = "bridge",
           .title = "bridge of planks, 1 : 100",
           .stresses = "twenty hinges in a row, held at both ends, and contacts with a load of a hundred planks",
           // Of 10 m, as for the chain: 2 mm at rest, 20 mm while the load goes down.
           .criteria = {{"stretch at rest", "%", Real(0.02)},
                        {"stretch while it sags", "%", Real(0.2)},
                        {"speed in the last second", "mm/s", 1},
                        {"the load, off the middle", "mm", 1000 * plank_length / 2}},
           .scene = seen(bridge, view({0, Real(-0.6), 0}, 9), 30),
           .run = loaded_bridge},
          {.name = "ragdoll",
           .title = "ragdoll on stairs",
           .stresses = "ten joints with limits, eleven bodies between them and five steps: it folds, and comes to rest",
           .criteria = {{"largest gap, of his height", "%", 1},
                        {"a knee or elbow bent backwards", "degrees", 5},
                        {"speed in the last second", "mm/s", 1}},
           .scene = seen([](World& world) { limits_motors_springs_scenes::down_the_stairs(world); },
                         view({Real(0.6), Real(0.9), 0}, Real(3.4)), Real(1.5)),
           .run = ragdoll_on_stairs,
           .starts = many_starts}};
}

std::vector<HardCase> mechanism_cases() {
  return {{.name = "four-bar",
           .title = "a four-bar linkage",
           .stresses = "all bars come into one line, where the equations of the hinges depend on each other",
           .criteria = {{"largest gap of a hinge", "mm", 5},  // a thousandth of the coupler
                        {"energy changed in 10 s", "%", 5},
                        {"dead points not passed, of four", "", 0}},
           .scene = seen(four_bar, view({Real(2.5), 0, 0}, 8), Real(0.5)),
           .run = through_dead_points},
          {.name = "motor-at-limit",
           .title = "a motor against a limit",
           .stresses =
               "a motor drives a door to the limit of its hinge and goes on pushing: two rows about one axis disagree",
           .criteria = {{"angle on the way, off by", "mrad", 10},
                        {"beyond the limit", "mrad", 1},
                        {"from the limit, once held", "mrad", 1},
                        {"speed, once held", "mrad/s", 1}},
           .scene = seen(door, {{Real(1.6), 2, 3}, {Real(0.3), 0, 0}}, 1),
           .run = motor_at_limit}};
}

}  // namespace pushback
