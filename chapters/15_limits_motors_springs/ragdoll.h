/// A ragdoll of capsules, boxes and a ball, a bench that it lies on, and stairs that it falls down.
#pragma once

#include <algorithm>
#include <array>

#include "pushback/chapters/13_joints/hinge.h"
#include "pushback/chapters/15_limits_motors_springs/limits.h"

namespace pushback::limits_motors_springs_scenes {

/// Indices in World::bodies and World::joints. In each pair, the first is at -z if the ragdoll faces +x.
struct Ragdoll {
  int pelvis, chest, head;
  std::array<int, 2> upper_arms, forearms, thighs, shins;
  std::size_t first_joint, end_of_joints;
};

inline constexpr Real ragdoll_height = Real(1.76);     ///< m, from the soles to the top of the head
inline constexpr Real ragdoll_hips_over = Real(0.96);  ///< m, from the soles to the middle of the pelvis

/// Adds a ragdoll that stands upright and faces +x, turned by `turn` about the middle of its pelvis, `hips` (m). 76 kg in 11
/// bodies.
///
/// Knees and elbows are hinges with limits. The other joints are balls and sockets, each with a cone limit and twist limits.
inline Ragdoll add_ragdoll(World& world, const Vec3& hips, const Quat& turn = Quat::Identity()) {
  require_finite("hips of a ragdoll", hips);
  const auto degrees = [](Real angle) { return angle * pi / 180; };
  const auto place = [&](const Vec3& where) { return Vec3(hips + turn * where); };
  const auto add = [&](Body body, Real x, Real y, Real z, int colour) {
    return world.add(body.oriented(turn).at(place({x, y, z})).coloured(colour));
  };
  const auto socket = [&](int a, int b, const Vec3& anchor, const Vec3& cone, const Vec3& limb, Real swing,
                          Real twist) {
    world.joints.push_back(ball_and_socket(world, a, b, place(anchor)));
    world.joints.push_back(cone_limit(world, a, b, turn * cone, turn * limb, degrees(swing)));
    world.joints.push_back(twist_limits(world, a, b, turn * limb, -degrees(twist), degrees(twist)));
  };
  const auto bend = [&](int a, int b, const Vec3& anchor, Real low, Real high) {
    const Vec3 axis = turn * Vec3::UnitZ();
    world.joints.push_back(hinge(world, a, b, place(anchor), axis));
    world.joints.push_back(angle_limits(world, a, b, axis, degrees(low), degrees(high)));
  };
  const Vec3 up = Vec3::UnitY(), down = -up;

  Ragdoll man{};
  man.first_joint = world.joints.size();
  man.pelvis = add(box({Real(0.10), Real(0.10), Real(0.16)}, 12), 0, 0, 0, 1);
  man.chest = add(box({Real(0.11), Real(0.20), Real(0.18)}, 26), 0, Real(0.33), 0, 0);
  man.head = add(sphere(Real(0.11), 5), 0, Real(0.69), 0, 4);
  socket(man.pelvis, man.chest, {0, Real(0.115), 0}, up, up, 35, 30);
  socket(man.chest, man.head, {0, Real(0.555), 0}, up, up, 40, 45);
  for (const std::size_t i : {0U, 1U}) {
    const Real side = i == 0 ? -1 : 1, arm = side * Real(0.25), leg = side * Real(0.09);
    man.upper_arms[i] = add(capsule(Real(0.05), Real(0.10), Real(2.5)), 0, Real(0.33), arm, 2);
    man.forearms[i] = add(capsule(Real(0.045), Real(0.10), 2), 0, 0, arm, 4);
    man.thighs[i] = add(capsule(Real(0.07), Real(0.14), 8), 0, Real(-0.31), leg, 1);
    man.shins[i] = add(capsule(Real(0.055), Real(0.15), 4), 0, Real(-0.755), leg, 3);
    // An arm swings forwards and outwards but hardly backwards. A leg swings forwards.
    socket(man.chest, man.upper_arms[i], {0, Real(0.47), arm}, {Real(0.4), Real(-0.5), side * Real(0.75)}, down, 95,
           60);
    socket(man.pelvis, man.thighs[i], {0, Real(-0.10), leg}, {Real(0.5), Real(-0.85), side * Real(0.15)}, down, 60, 30);
    bend(man.upper_arms[i], man.forearms[i], {0, Real(0.165), arm}, 0, 140);
    bend(man.thighs[i], man.shins[i], {0, Real(-0.535), leg}, -140, 0);
  }
  man.end_of_joints = world.joints.size();
  return man;
}

/// The largest gap at a joint of a ragdoll, as a fraction of its height.
inline Real stretch(const World& world, const Ragdoll& man) {
  Real largest = 0;
  Equations equations;
  for (std::size_t i = man.first_joint; i < man.end_of_joints; ++i) {
    const Joint& joint = world.joints[i];
    equations.clear();
    joint.ask(body_of(world, joint.a), body_of(world, joint.b), {world.time, 1}, equations);
    Real squared = 0;
    for (const Equation& row : equations) squared += row.jacobian.n.isZero(0) ? 0 : row.error * row.error;
    largest = std::max(largest, std::sqrt(squared));
  }
  return largest / ragdoll_height;
}

/// The largest angle by which a knee or an elbow is bent the wrong way, rad.
inline Real bent_backwards(const World& world, const Ragdoll& man) {
  const auto bend = [&world](int upper, int lower) {  // about z of both; 0: straight, as at the start
    const Quat turn = body_of(world, upper).orientation.conjugate() * body_of(world, lower).orientation;
    return std::remainder(2 * std::atan2(turn.z(), turn.w()), 2 * pi);
  };
  Real farthest = 0;
  for (const std::size_t i : {0U, 1U}) {
    farthest = std::max({farthest, -bend(man.upper_arms[i], man.forearms[i]), bend(man.thighs[i], man.shins[i])});
  }
  return farthest;
}

/// Adds `count` fixed steps of `rise` and `run` m, `width` m wide, which descend along +x from a landing at x <= 0 to the plane
/// y = 0 at x = count * run. The landing is 2 m long and `count + 1` rises high. Throws InvalidInput if count < 1 or if a length
/// is not above 0.
inline void add_stairs(World& world, int count, Real rise = Real(0.18), Real run = Real(0.28), Real width = 2) {
  if (count < 1) throw InvalidInput(fmt::format("stairs have {} steps: 1 or more are needed", count));
  require_positive("rise of stairs", rise);
  require_positive("run of stairs", run);
  require_positive("width of stairs", width);
  const auto block = [&](Real from, Real to, Real height) {
    world.add(box({(to - from) / 2, height / 2, width / 2}, 1).fixed().at({(from + to) / 2, height / 2, 0}));
  };
  block(-2, 0, static_cast<Real>(count + 1) * rise);
  for (int i = 0; i < count; ++i) {
    block(static_cast<Real>(i) * run, static_cast<Real>(i + 1) * run, static_cast<Real>(count - i) * rise);
  }
}

/// A ragdoll moves at 1.5 m/s off the landing of five steps, above the ground. Returns the ragdoll.
inline Ragdoll down_the_stairs(World& world) {
  constexpr int steps = 5;
  world.add(ground());
  add_stairs(world, steps);
  const Vec3 hips(Real(-0.3), (steps + 1) * Real(0.18) + ragdoll_hips_over, 0);
  const Ragdoll man = add_ragdoll(world, hips);
  for (int body = man.pelvis; body <= man.shins[1]; ++body)
    world.bodies[static_cast<std::size_t>(body)].moving({Real(1.5), 0, 0});
  return man;
}

/// A ragdoll lies face down, its head at +x, on a bench from its chest to its knees. Returns the ragdoll.
inline Ragdoll face_down_on_a_bench(World& world) {
  const Real top = Real(0.7), chest_half = Real(0.11);  // m
  world.add(ground());
  world.add(box({Real(0.5), top / 2, Real(0.19)}, 1).fixed().at({0, top / 2, 0}));
  return add_ragdoll(world, {0, top + chest_half, 0}, Quat(Eigen::AngleAxis<Real>(-pi / 2, Vec3::UnitZ())));
}

}  // namespace pushback::limits_motors_springs_scenes
