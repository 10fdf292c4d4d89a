/// Every scene that a chapter looks at, and those of this one.
#pragma once

#include "chapters/00_naive_impulses/scenes.h"
#include "chapters/01_velocity_constraint/scenes.h"
#include "chapters/02_clamping/scenes.h"
#include "chapters/03_baumgarte/scenes.h"
#include "chapters/04_slop/scenes.h"
#include "chapters/05_restitution/scenes.h"
#include "chapters/06_friction/scenes.h"
#include "chapters/08_friction_cone/scenes.h"
#include "chapters/09_joints/scenes.h"
#include "chapters/09_joints/structures.h"
#include "chapters/10_limits_and_motors/cart.h"
#include "chapters/10_limits_and_motors/ragdoll.h"
#include "chapters/10_limits_and_motors/scenes.h"
#include "chapters/11_position_correction/scenes.h"
#include "chapters/12_small_steps/scenes.h"
#include "chapters/13_global_solve/scenes.h"
#include "common/input.h"

namespace pushback {

// ---- what this chapter looks at ----------------------------------------------------------------------------------------

/// Five piles of six boxes, well apart. A ball rolls in from the front and hits the one in the middle, after about 1.4 s.
inline void five_piles(World& world) {
  world.add(ground());
  for (int pile = 0; pile < 5; ++pile) {
    int colour = pile;  // no two piles begin with the same
    for (int row = 0; row < 3; ++row) {
      for (int i = 0; i < 3 - row; ++i, ++colour) {
        const Real x =
            Real(3.7) * static_cast<Real>(pile - 2) + Real(1.05) * (static_cast<Real>(i) - Real(2 - row) / 2);
        world.add(box(Vec3::Constant(Real(0.5)), 100).at({x, Real(0.5) + static_cast<Real>(row), 0}).coloured(colour));
      }
    }
  }
  constexpr Real radius = Real(0.7), speed = 8;
  const Vec3 way = Vec3(-Real(0.3), 0, -1).normalized();
  world.add(sphere(radius, 500)
                .at(Vec3(0, radius, 0) - Real(12.5) * way)
                .moving(speed * way)
                .spinning(speed / radius * Vec3::UnitY().cross(way))
                .coloured(5));
}

/// Cubes that slide on ice, in a tray: nothing is rough, nothing bounces, and no inertia differs from axis to axis.
inline void cubes_on_ice(World& world) {
  constexpr Real half = Real(0.5), side = 6;
  world.add(ground().rough(0));
  for (const Vec3& inwards : {Vec3(1, 0, 0), Vec3(-1, 0, 0), Vec3(0, 0, 1), Vec3(0, 0, -1)}) {
    const Vec3 along = inwards.cwiseAbs(), reach = Real(0.2) * along + side * (Vec3(1, 0, 1) - along);
    world.add(box(reach + Vec3(0, Real(0.4), 0), 1).fixed().rough(0).at(Vec3(0, Real(0.4), 0) - side * inwards));
  }
  for (int i = 0; i < 6; ++i) {
    for (int j = 0; j < 6; ++j) {
      const Vec3 where(Real(1.7) * (static_cast<Real>(i) - Real(2.5)), half,
                       Real(1.7) * (static_cast<Real>(j) - Real(2.5)));
      const Vec3 how =
          4 * Vec3(static_cast<Real>((3 * i + 5 * j) % 7 - 3), 0, static_cast<Real>((5 * i + 2 * j) % 7 - 3)) / 3;
      world.add(box(Vec3::Constant(half), 100).rough(0).at(where).moving(how));
    }
  }
}

// ---- all of them -------------------------------------------------------------------------------------------------------

struct NamedScene {
  std::string name;                  ///< the chapter's number, a hyphen, a word or two: as typed on a command line
  std::function<void(World&)> fill;  ///< puts the bodies into an empty world
};

/// Each scene once, under the chapter that looks at it first. Parameters are those that its experiment has by default:
/// steps of 1/60 s among them.
inline std::vector<NamedScene> all_scenes() {
  constexpr Real h = Real(1) / 60;
  const auto stack_of = [](int count) { return [count](World& world) { stack(world, count); }; };
  return {
      {"00-one-hit", sparse_hit},
      {"00-one-box", stack_of(1)},
      {"00-five-boxes", stack_of(5)},
      {"01-dropped", dropped_box},
      {"01-leaving", leaving_box},
      {"01-slope", cube_on_slope},
      {"02-landing", landing_column},
      {"02-three-columns", three_columns},
      {"03-sunken", sunken_box},
      {"03-weightless", sunken_box_without_gravity},
      {"03-three-boxes", stack_of(3)},
      {"04-small-pile", small_pile},
      {"05-four-balls", four_balls},
      {"05-at-rest", at_rest},
      {"05-with-gaps", five_in_a_row(Real(0.08))},
      {"05-touching", five_in_a_row(0)},
      {"06-slope", slope},
      {"06-slide", [](World& world) { slide_to_posts(world, three_headings, h); }},
      {"06-thrown-ball", thrown_ball},
      {"07-ten-boxes", stack_of(10)},
      {"07-pyramid", [](World& world) { pyramid(world, 10); }},
      {"08-wheel", [](World& world) { wheel(world, longest_half, h); }},
      {"09-beads", beads_on_wires},
      {"09-pendulums", pendulums},
      {"09-door", door_and_weld},
      {"09-chain", chain_with_weight},
      {"09-bridge", suspension_bridge},
      {"09-ropes", ropes},
      {"09-cloth", cloth_over_ball},
      {"10-stop",
       [](World& world) {
         bar_and_stop(world);
         world.joints.push_back(stop_of_bar(world));
       }},
      {"10-pointers",
       [](World& world) {
         pointers(world, follow_torque);
         weigh_pointer(world, light_pointer);
       }},
      {"10-winches", two_winches},
      {"10-pulleys", two_pulleys},
      {"10-springs", three_springs},
      {"10-swing", [](World& world) { pumped_swing(world, Real(0.05)); }},
      {"10-cart",
       [](World& world) {
         incline(world, slope_angle, 1);
         drive(world, add_cart(world, slope_angle, 0), cart_speed, 7);
       }},
      {"10-stairs", [](World& world) { down_the_stairs(world); }},
      {"11-deep", very_deep_box},
      {"11-twelve-boxes", boxes_in_each_other},
      {"11-stack", stack_of_ten},
      {"11-weightless", weightless_ball},
      {"11-bounce", dropped_ball(1)},
      {"12-twenty-boxes", stack_of_twenty},
      {"12-heavy", heavy_on_light},
      {"12-forty-boxes", stack_of(40)},
      {"12-sunken-ball", sunken_ball},
      {"13-gate", stack_in_gate},
      {"13-chain", chain_with_heavy_load},
      {"15-piles", five_piles},
      {"15-ice", cubes_on_ice},
  };
}

/// As they are typed, for a message.
inline std::string names_of(const std::vector<NamedScene>& scenes) {
  std::string names;
  for (const NamedScene& scene : scenes) names += (names.empty() ? "" : ", ") + scene.name;
  return names;
}
/// Throws InvalidInput, naming all there are, where none has this name.
inline const NamedScene& scene_of(const std::vector<NamedScene>& scenes, const std::string& name) {
  for (const NamedScene& scene : scenes)
    if (scene.name == name) return scene;
  throw InvalidInput(fmt::format("scene is '{}': one of these is needed: {}", name, names_of(scenes)));
}

}  // namespace pushback
