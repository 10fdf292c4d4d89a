#include "pushback/chapters/catalogue.h"

#include "pushback/chapters/00_naive_impulses/scenes.h"
#include "pushback/chapters/01_velocity_constraint/scenes.h"
#include "pushback/chapters/02_clamping/scenes.h"
#include "pushback/chapters/03_baumgarte/scenes.h"
#include "pushback/chapters/04_slop/scenes.h"
#include "pushback/chapters/05_restitution/scenes.h"
#include "pushback/chapters/06_friction/scenes.h"
#include "pushback/chapters/08_friction_cone/scenes.h"
#include "pushback/chapters/09_impacts/scenes.h"
#include "pushback/chapters/10_position_correction/scenes.h"
#include "pushback/chapters/11_substeps/scenes.h"
#include "pushback/chapters/12_soft_contacts/scenes.h"
#include "pushback/chapters/13_joints/scenes.h"
#include "pushback/chapters/14_joints_under_load/scenes.h"
#include "pushback/chapters/14_joints_under_load/structures.h"
#include "pushback/chapters/15_limits_motors_springs/cart.h"
#include "pushback/chapters/15_limits_motors_springs/ragdoll.h"
#include "pushback/chapters/15_limits_motors_springs/scenes.h"
#include "pushback/chapters/16_whole_problem/scenes.h"
#include "pushback/chapters/18_direct_joints/scenes.h"
#include "pushback/chapters/20_only_what_is_needed/scenes.h"

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
      {"06-slope", BoxesOnSlope{}},
      {"06-slide", [](World& world) { slide_to_posts(world, three_headings, h); }},
      {"06-thrown-ball", [](World& world) { thrown_ball(world); }},
      {"07-ten-boxes", stack_of(10)},
      {"07-pyramid", [](World& world) { pyramid(world, 10); }},
      {"08-wheel", [](World& world) { wheel(world, longest_half, h); }},
      {"09-with-gaps", five_in_a_row(Real(0.08))},
      {"09-touching", five_in_a_row(0)},
      {"10-deep", [](World& world) { very_deep_box(world); }},
      {"10-twelve-boxes", boxes_in_each_other},
      {"10-stack", [](World& world) { stack_before_posts(world, 10); }},
      {"10-weightless", WeightlessBall{}},
      {"10-bounce", dropped_ball(1)},
      {"11-twenty-boxes", [](World& world) { stack_before_posts(world, 20); }},
      {"11-heavy", HeavyOnLight{}},
      {"12-forty-boxes", stack_of(40)},
      {"12-sunken-ball", SunkenBall{}},
      {"13-beads", beads_on_wires},
      {"13-pendulums", Pendulums{}},
      {"13-door", door_and_weld},
      {"14-chain", ChainWithWeight{}},
      {"14-bridge", suspension_bridge},
      {"14-ropes", ropes},
      {"14-cloth", cloth_over_ball},
      {"15-stop",
       [](World& world) {
         bar_and_stop(world);
         world.joints.push_back(stop_of_bar(world));
       }},
      {"15-pointers",
       [](World& world) {
         pointers(world, follow_torque);
         weigh_pointer(world, light_pointer);
       }},
      {"15-winches", TwoWinches{}},
      {"15-pulleys", TwoPulleys{}},
      {"15-springs", SpringsLetGo{}},
      {"15-swing", [](World& world) { pumped_swing(world, Real(0.05)); }},
      {"15-cart",
       [](World& world) {
         const Real slope = cart_slope * pi / 180;
         incline(world, slope, 1);
         drive(world, add_cart(world, slope, 0), cart_speed, 7);
       }},
      {"15-stairs", [](World& world) { down_the_stairs(world); }},
      {"17-gate", StackInGate{}},
      {"18-chain", LoadedChain{}},
      {"20-piles", FivePiles{}},
      {"20-ice", cubes_on_ice},
  };
}

}  // namespace pushback
