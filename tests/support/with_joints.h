/// Any solver that is composed of effects, with joints before them; and scenes in which something is joined.
#pragma once

#include "pushback/chapters/13_joints/hinge.h"
#include "pushback/chapters/14_joints_under_load/jointed_solver.h"
#include "pushback/chapters/14_joints_under_load/steady_jointed_solver.h"
#include "pushback/common/world/situations.h"
#include "pushback/tools/catalogue/catalogue.h"

namespace pushback {

template <class HowTheyHold, class ContactSolver>
struct WithJointsOf;
template <class HowTheyHold, template <class...> class SolverOf, class... Effects>
struct WithJointsOf<HowTheyHold, SolverOf<Effects...>> {
  using type = SolverOf<HowTheyHold, Effects...>;
};
/// `HowTheyHold`: Joints, WarmJoints or SplitJoints.
template <class HowTheyHold, class ContactSolver>
using WithJoints = typename WithJointsOf<HowTheyHold, ContactSolver>::type;

static_assert(std::same_as<JointedSolver, WithJoints<SplitJoints, FullSolver>>);
static_assert(std::same_as<SteadyJointedSolver, WithJoints<SteadyJoints, SteadySolver>>);

/// A ball on the world, let go sideways: nothing can touch.
inline void lone_pendulum(World& world) {
  world.add(sphere(Real(0.2), 10).at({1, 0, 0}));
  world.joints = {ball_and_socket(world, the_world, 0, {0, 0, 0})};
}

/// Capsules one below the other from a point of the world, and the lowest above the ground.
inline void hanging_chain(World& world, int count = 8) {
  constexpr Real length = Real(0.4);
  const Real top = Real(0.1) + length * static_cast<Real>(count);
  world.add(ground());
  for (int i = 0; i < count; ++i) {
    const Real y = top - length * static_cast<Real>(i);
    const int link = world.add(capsule(Real(0.06), Real(0.14), 2).at({0, y - length / 2, 0}));
    world.joints.push_back(ball_and_socket(world, i == 0 ? the_world : link - 1, link, {0, y, 0}));
  }
}

/// The same, and a ball that hits it.
inline void struck_chain(World& world) {
  hanging_chain(world);
  world.add(sphere(Real(0.15), 5).at({-3, Real(1.2), Real(0.05)}).moving({6, 3, 0}).bouncy(Real(0.4)));
}

/// Planks on hinges between two posts, slack enough to sag, and a box that falls on them.
inline void plank_bridge(World& world) {
  constexpr int count = 8;
  constexpr Real half = Real(0.25);
  const int left = world.add(box(Vec3::Constant(Real(0.25)), 1).fixed().at({-half, 2, 0}));
  int before = left;
  for (int i = 0; i < count; ++i) {
    const Real x = 2 * half * static_cast<Real>(i);
    const int plank = world.add(box({half, Real(0.04), Real(0.5)}, 10).at({x + half, 2, 0}));
    world.joints.push_back(hinge(world, before, plank, {x, 2, 0}, Vec3::UnitZ()));
    before = plank;
  }
  const Real end = 2 * half * count;
  const int right = world.add(box(Vec3::Constant(Real(0.25)), 1).fixed().at({end + half, 2, 0}));
  world.joints.push_back(hinge(world, before, right, {end, 2, 0}, Vec3::UnitZ()));
  world.add(box(Vec3::Constant(Real(0.2)), 20).at({end / 2, 3, 0}).bouncy(Real(0.3)));
}

/// Holds a body's centre to a point that goes round `centre` in the plane z = 0, `radius` m away, by `rate` rad/s.
inline Joint crank(const World& world, int body, const Vec3& centre, Real radius, Real rate) {
  check_joined(world, "a crank", the_world, body);
  const auto ask = [=](const Body&, const Body& its, const TimeStep& now, Equations& equations) {
    const Real angle = rate * now.time;
    const Vec3 out(std::cos(angle), std::sin(angle), 0), along(-out.y(), out.x(), 0);
    for (int axis = 0; axis < 3; ++axis) {
      equations.push_back({.jacobian = {.n = Vec3::Unit(axis)},
                           .error = (its.position - centre - radius * out)[axis],
                           .bias = -radius * rate * along[axis]});
    }
  };
  return {.name = "a crank", .a = the_world, .b = body, .ask = ask, .driven = true};
}

/// A ball goes round and takes another along.
inline void cranked(World& world) {
  world.add(ground());
  world.add(sphere(Real(0.2), 1).at({1, 3, 0}));
  world.add(sphere(Real(0.2), 1).at({1, 2, 0}));
  world.joints = {crank(world, 1, {0, 3, 0}, 1, 2), ball_and_socket(world, 1, 2, {1, Real(2.5), 0})};
}

inline std::vector<NamedScene> joint_scenes() {
  return {{"a lone pendulum", lone_pendulum},
          {"a hanging chain", [](World& world) { hanging_chain(world); }},
          {"a struck chain", struck_chain},
          {"a bridge of planks", plank_bridge},
          {"a crank", cranked}};
}
inline std::vector<NamedScene> all_scenes_and_joints() {
  std::vector<NamedScene> all = all_scenes(), joined = joint_scenes();
  all.insert(all.end(), joined.begin(), joined.end());
  return all;
}

}  // namespace pushback
