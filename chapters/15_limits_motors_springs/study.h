/// Studies for the diagrams and remarks: a motor's work, how it reaches its speed, springs, the pumped swing, the ragdoll.
#pragma once

#include "pushback/chapters/15_limits_motors_springs/ragdoll.h"
#include "pushback/chapters/15_limits_motors_springs/scenes.h"
#include "pushback/common/experiment/plot.h"
#include "pushback/common/world/measure.h"
#include "pushback/common/world/steps_in.h"

namespace pushback::limits_motors_springs_scenes {

/// Steps a world with JointedSolver for `seconds` s in steps of `h` s. Calls `see(t, solver)` after each step.
template <class See>
void watch(World& world, Real seconds, Real h, const See& see) {
  JointedSolver solver;
  for (int i = 0; i < steps_in(seconds, h); ++i) {
    world.step(solver, h);
    see(world.time, solver);
  }
}

/// The work of the last joint, a motor that turns body 0 about z, and the energy that the world has gained.
///
/// The work of an impulse is lambda times the mean of the speeds before and after it.
struct WorkAndEnergy {
  Real work = 0, energy = 0;  ///< J
};
inline WorkAndEnergy work_of_winch(Real h) {
  World world;
  winch(world, 0, light_load);
  const auto energy = [&world] { return kinetic_energy(world) + potential_energy(world); };
  const Real start = energy();
  WorkAndEnergy found;
  watch(world, 2, h, [&](Real, const JointedSolver& solver) {
    const Body& wheel = world.bodies[0];
    found.work +=
        solver.joint_rows().back().impulse * (wheel.angular_velocity_before.z() + wheel.angular_velocity.z()) / 2;
  });
  found.energy = energy() - start;
  return found;
}

/// Catto's wheel with 2 rad/s and 5 N m: omega over time, for two moments of inertia.
inline std::vector<Curve> reaching_a_speed(Real h) {
  std::vector<Curve> curves;
  for (const Real inertia : {Real(1), Real(5)}) {
    World world;
    const int wheel = world.add(sphere(1, inertia / Real(0.4)));
    world.joints = {hinge(world, the_world, wheel, Vec3::Zero(), Vec3::UnitZ()),
                    motor_at_speed(world, the_world, wheel, Vec3::UnitZ(), winch_speed, winch_torque)};
    Curve omega{fmt::format("I = {} kg m²", inertia), {}, {}, line_colour(curves.size() / 2), Curve::Style::line};
    Curve law{"min(5 t / I, 2)", {}, {}, "#222222", Curve::Style::dashed};
    if (!curves.empty()) law.label = "";
    watch(world, 3, h, [&](Real t, const JointedSolver&) {
      omega.x.push_back(t);
      omega.y.push_back(world.bodies[0].angular_velocity.z());
      law.x.push_back(t);
      law.y.push_back(std::min(winch_torque * t / inertia, winch_speed));
    });
    curves.push_back(omega);
    curves.push_back(law);
  }
  return curves;
}

/// The distance of each ball below its rest position over time, and its closed form.
inline std::vector<Curve> springs_in_time(const SpringsLetGo& springs, Real h) {
  World world;
  springs(world);
  const std::vector<Real>& ratios = springs.damping_ratios;
  std::vector<Curve> curves;
  for (std::size_t i = 0; i < ratios.size(); ++i) {
    curves.push_back({fmt::format("ζ = {}", ratios[i]), {}, {}, line_colour(i), Curve::Style::line});
    curves.push_back({i == 0 ? "closed form" : "", {}, {}, "#222222", Curve::Style::dashed});
  }
  watch(world, 3, h, [&](Real t, const JointedSolver&) {
    for (Curve& curve : curves) curve.x.push_back(t);
    for (std::size_t i = 0; i < ratios.size(); ++i) {
      curves[2 * i].y.push_back(springs.below(world, i));
      curves[2 * i + 1].y.push_back(springs.closed_form(i, t));
    }
  });
  return curves;
}
/// The error of each spring against its closed form after 1 s, by the length of the step.
inline std::vector<Curve> springs_by_step(const SpringsLetGo& springs) {
  const std::vector<Real>& ratios = springs.damping_ratios;
  std::vector<Curve> curves;
  for (std::size_t i = 0; i < ratios.size(); ++i) {
    curves.push_back({fmt::format("ζ = {}", ratios[i]), {}, {}, line_colour(i), Curve::Style::line_and_points});
  }
  for (int steps = 30; steps <= 3840; steps *= 2) {
    const Real h = 1 / static_cast<Real>(steps);
    World world;
    springs(world);
    watch(world, 1, h, [](Real, const JointedSolver&) {});
    for (std::size_t i = 0; i < ratios.size(); ++i) {
      curves[i].x.push_back(h);
      curves[i].y.push_back(std::abs(springs.below(world, i) - springs.closed_form(i, 1)));
    }
  }
  return curves;
}

/// The swing with and without pumping, and the expected growth of its amplitude:   theta_0 exp(3/4 pump w t)
inline std::vector<Curve> swings(Real h, Real pump) {
  std::vector<Curve> curves;
  for (const Real part : {pump, Real(0)}) {
    World world;
    pumped_swing(world, part);
    Curve curve{part > 0 ? "L(t)" : "L", {}, {}, line_colour(curves.size()), Curve::Style::line};
    watch(world, 15, h, [&](Real t, const JointedSolver&) {
      curve.x.push_back(t);
      curve.y.push_back(angle_of_swing(world) * 180 / pi);
    });
    curves.push_back(curve);
  }
  Curve law{"θ₀ exp(¾ ε ω t)", curves[0].x, {}, "#222222", Curve::Style::dashed};
  for (const Real t : law.x)
    law.y.push_back(swing_start * std::exp(Real(0.75) * pump * swing_frequency * t) * 180 / pi);
  curves.push_back(law);
  return curves;
}

/// The largest gap at a joint of the ragdoll in ten seconds from the top of the stairs, as a fraction of its height.
inline Real stretch_on_stairs(Real h, int substeps, int sweeps) {
  World world;
  const Ragdoll man = down_the_stairs(world);
  JointedSolver solver;
  Real worst = 0;
  for (int i = 0; i < steps_in(10, h); ++i) {
    for (int small = 0; small < substeps; ++small) world.step(solver, h / static_cast<Real>(substeps), sweeps);
    worst = std::max(worst, stretch(world, man));
  }
  return worst;
}

}  // namespace pushback::limits_motors_springs_scenes
