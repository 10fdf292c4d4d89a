#include "pushback/chapters/catalogue.h"

#include "pushback/chapters/00_naive_impulses/scenes.h"
#include "pushback/chapters/01_velocity_constraint/scenes.h"
#include "pushback/chapters/02_clamping/scenes.h"
#include "pushback/chapters/03_baumgarte/scenes.h"
#include "pushback/chapters/04_slop/scenes.h"
#include "pushback/chapters/05_restitution/scenes.h"
#include "pushback/chapters/06_friction/scenes.h"
#include "pushback/chapters/08_friction_cone/scenes.h"
#include "pushback/chapters/09_joints/scenes.h"
#include "pushback/chapters/09_joints/structures.h"
#include "pushback/chapters/10_limits_and_motors/cart.h"
#include "pushback/chapters/10_limits_and_motors/ragdoll.h"
#include "pushback/chapters/10_limits_and_motors/scenes.h"
#include "pushback/chapters/11_position_correction/scenes.h"
#include "pushback/chapters/12_small_steps/scenes.h"
#include "pushback/chapters/13_global_solve/scenes.h"
#include "pushback/chapters/15_only_what_is_needed/scenes.h"

namespace pushback {

std::vector<NamedScene> all_scenes() {
  constexpr Real h = Real(1) / 60;
  const auto stack_of = [](int count) { return [count](World& world) { stack(world, count); }; };
  return {
      {"00-one-hit", SparseHit{}},
      {"00-one-box", stack_of(1)},
      {"00-five-boxes", stack_of(5)},
      {"01-dropped", DroppedBox{}},
      {"01-leaving", LeavingBox{}},
      {"01-slope", CubeOnSlope{}},
      {"02-landing", LandingColumn{}},
      {"02-three-columns", StackedColumns{}},
      {"03-sunken", SunkenBox{}},
      {"03-weightless", SunkenBox{.weightless = true}},
      {"03-three-boxes", stack_of(3)},
      {"04-small-pile", SmallPile{}},
      {"05-four-balls", FallingBalls{}},
      {"05-at-rest", at_rest},
      {"05-with-gaps", five_in_a_row(Real(0.08))},
      {"05-touching", five_in_a_row(0)},
      {"06-slope", BoxesOnSlope{}},
      {"06-slide", [](World& world) { slide_to_posts(world, three_headings, h); }},
      {"06-thrown-ball", [](World& world) { thrown_ball(world); }},
      {"07-ten-boxes", stack_of(10)},
      {"07-pyramid", [](World& world) { pyramid(world, 10); }},
      {"08-wheel", [](World& world) { wheel(world, longest_half, h); }},
      {"09-beads", beads_on_wires},
      {"09-pendulums", Pendulums{}},
      {"09-door", door_and_weld},
      {"09-chain", ChainWithWeight{}},
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
      {"10-winches", TwoWinches{}},
      {"10-pulleys", TwoPulleys{}},
      {"10-springs", SpringsLetGo{}},
      {"10-swing", [](World& world) { pumped_swing(world, Real(0.05)); }},
      {"10-cart",
       [](World& world) {
         const Real slope = cart_slope * pi / 180;
         incline(world, slope, 1);
         drive(world, add_cart(world, slope, 0), cart_speed, 7);
       }},
      {"10-stairs", [](World& world) { down_the_stairs(world); }},
      {"11-deep", [](World& world) { very_deep_box(world); }},
      {"11-twelve-boxes", boxes_in_each_other},
      {"11-stack", [](World& world) { stack_before_posts(world, 10); }},
      {"11-weightless", WeightlessBall{}},
      {"11-bounce", dropped_ball(1)},
      {"12-twenty-boxes", [](World& world) { stack_before_posts(world, 20); }},
      {"12-heavy", HeavyOnLight{}},
      {"12-forty-boxes", stack_of(40)},
      {"12-sunken-ball", SunkenBall{}},
      {"13-gate", StackInGate{}},
      {"13-chain", LoadedChain{}},
      {"15-piles", FivePiles{}},
      {"15-ice", cubes_on_ice},
  };
}

}  // namespace pushback
