#include "pushback/tools/catalogue/catalogue.h"

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
#include "pushback/chapters/17_direct_contacts/scenes.h"
#include "pushback/chapters/18_direct_joints/scenes.h"
#include "pushback/chapters/20_only_what_is_needed/scenes.h"
#include "pushback/chapters/21_detected_once/scenes.h"
#include "pushback/chapters/22_wide/scenes.h"

namespace pushback {

std::vector<NamedScene> all_scenes() {
  constexpr Real h = Real(1) / 60;
  const auto stack_of = [](int count) { return [count](World& world) { stack(world, count); }; };
  return {
      {"00-one-hit", naive_impulses_scenes::SparseHit{}},
      {"00-one-box", stack_of(1)},
      {"00-five-boxes", stack_of(5)},
      {"01-dropped", velocity_constraint_scenes::DroppedBox{}},
      {"01-leaving", velocity_constraint_scenes::LeavingBox{}},
      {"01-slope", velocity_constraint_scenes::CubeOnSlope{}},
      {"02-landing", clamping_scenes::LandingColumn{}},
      {"02-three-columns", clamping_scenes::StackedColumns{}},
      {"03-sunken", baumgarte_scenes::SunkenBox{}},
      {"03-weightless", baumgarte_scenes::SunkenBox{.weightless = true}},
      {"03-three-boxes", stack_of(3)},
      {"04-small-pile", slop_scenes::SmallPile{}},
      {"05-four-balls", restitution_scenes::FallingBalls{}},
      {"05-at-rest", restitution_scenes::at_rest},
      {"06-slope", friction_scenes::BoxesOnSlope{}},
      {"06-slide", [](World& world) { friction_scenes::slide_to_posts(world, friction_scenes::three_headings, h); }},
      {"06-thrown-ball", [](World& world) { friction_scenes::thrown_ball(world); }},
      {"07-ten-boxes", stack_of(10)},
      {"07-pyramid", [](World& world) { pyramid(world, 10); }},
      {"08-wheel", [](World& world) { friction_cone_scenes::wheel(world, friction_cone_scenes::longest_half, h); }},
      {"09-with-gaps", impacts_scenes::five_in_a_row(Real(0.08))},
      {"09-touching", impacts_scenes::five_in_a_row(0)},
      {"10-deep", [](World& world) { position_correction_scenes::very_deep_box(world); }},
      {"10-twelve-boxes", position_correction_scenes::boxes_in_each_other},
      {"10-stack", [](World& world) { stack_before_posts(world, 10); }},
      {"10-weightless", position_correction_scenes::WeightlessBall{}},
      {"10-bounce", position_correction_scenes::dropped_ball(1)},
      {"11-twenty-boxes", [](World& world) { stack_before_posts(world, 20); }},
      {"11-heavy", substeps_scenes::HeavyOnLight{}},
      {"12-forty-boxes", stack_of(40)},
      {"12-sunken-ball", soft_contacts_scenes::SunkenBall{}},
      {"13-beads", joints_scenes::beads_on_wires},
      {"13-pendulums", joints_scenes::Pendulums{}},
      {"13-door", joints_scenes::door_and_weld},
      {"14-chain", joints_under_load_scenes::ChainWithWeight{}},
      {"14-bridge", joints_under_load_scenes::suspension_bridge},
      {"14-ropes", joints_under_load_scenes::ropes},
      {"14-cloth", joints_under_load_scenes::cloth_over_ball},
      {"15-stop",
       [](World& world) {
         using namespace limits_motors_springs_scenes;
         bar_and_stop(world);
         world.joints.push_back(stop_of_bar(world));
       }},
      {"15-pointers",
       [](World& world) {
         using namespace limits_motors_springs_scenes;
         pointers(world, follow_torque);
         weigh_pointer(world, light_pointer);
       }},
      {"15-winches", limits_motors_springs_scenes::TwoWinches{}},
      {"15-pulleys", limits_motors_springs_scenes::TwoPulleys{}},
      {"15-springs", limits_motors_springs_scenes::SpringsLetGo{}},
      {"15-swing", [](World& world) { limits_motors_springs_scenes::pumped_swing(world, Real(0.05)); }},
      {"15-cart",
       [](World& world) {
         using namespace limits_motors_springs_scenes;
         const Real slope = cart_slope * pi / 180;
         incline(world, slope, 1);
         drive(world, add_cart(world, slope, 0), cart_speed, 7);
       }},
      {"15-stairs", [](World& world) { limits_motors_springs_scenes::down_the_stairs(world); }},
      {"16-gate", whole_problem_scenes::StackInGate{}},
      {"17-heavy", direct_contacts_scenes::HeavyOnFour{}},
      {"18-chain", direct_joints_scenes::LoadedChain{}},
      {"20-piles", only_what_is_needed_scenes::FivePiles{}},
      {"20-ice", only_what_is_needed_scenes::cubes_on_ice},
      {"21-cube", detected_once_scenes::RollingCube{}},
      {"21-ball", detected_once_scenes::FallingBall{.speed = 8}},
      {"22-slab", wide_scenes::LoadedSlab{.boxes = 4}},
  };
}

}  // namespace pushback
