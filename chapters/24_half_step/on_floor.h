/// A scene with a joint and a contact whose motion is known.
#pragma once

#include "pushback/chapters/13_joints/distance.h"
#include "pushback/common/world/situations.h"

namespace pushback::half_step_scenes {

/// A bob on a rod from a point above a floor slides on the floor in a circle of radius rho. The rod pulls it by m v^2 / rho along
/// the floor and by m v^2 d / rho^2 upwards. So the floor bears m (g - v^2 d / rho^2), and friction brakes a fast bob less:
///
///   v' = -mu (g - v^2 d / rho^2),    v = V tanh(atanh(v_0 / V) - mu g t / V),    V^2 = g rho^2 / d
struct OnFloor {
  Real mu;

  static constexpr Real height = Real(0.8), around = Real(1.2), speed = 2;  ///< d, rho, m; v_0, m/s
  static constexpr Real radius = Real(0.1);                                 ///< m, of the bob

  /// The position of the bob after t s, m, while it slides.
  Vec3 place(Real t) const {
    const Real top = std::sqrt(World::g / height) * around, from = std::atanh(speed / top);
    const Real way =
        mu == 0 ? speed * t
                : top * top / (mu * World::g) * std::log(std::cosh(from) / std::cosh(from - mu * World::g * t / top));
    return {around * std::cos(way / around), radius, around * std::sin(way / around)};
  }
  void operator()(World& world) const {
    world.add(ground().rough(mu));
    Body bob = sphere(radius, 2).at(place(0)).moving({0, 0, speed}).rough(mu);
    bob.principal_inverse_inertia.setZero();  // otherwise it would begin to roll
    const int index = world.add(bob);
    world.joints.push_back(distance(world, the_world, {0, radius + height, 0}, index, place(0)));
  }
};

}  // namespace pushback::half_step_scenes
