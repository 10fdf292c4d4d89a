/// Chapters 20 and 26: which step each island of a scene gets, and why.
#include "pushback/engine/islands/scene_questions.h"

#include <fmt/format.h>

#include <algorithm>

#include "pushback/chapters/13_joints/ball_and_socket.h"
#include "pushback/chapters/15_limits_motors_springs/motor.h"
#include "pushback/chapters/26_to_each_its_own/scenes.h"
#include "pushback/common/world/forces.h"
#include "pushback/common/world/measure.h"
#include "pushback/common/world/situations.h"
#include "pushback/engine/presets.h"
#include "tests/support/call.h"
#include "tests/support/catch.h"
#include "tests/support/with_joints.h"
#include "tests/support/yardstick.h"

using namespace pushback;

namespace {

Body cube() {
  return box(Vec3::Constant(Real(0.5)), 10);
}
Body small_ball() {
  return sphere(Real(0.1), 1);
}

World stack_of(int boxes) {
  World world;
  world.add(ground());
  for (int i = 0; i < boxes; ++i) world.add(cube().at({0, Real(0.5) + static_cast<Real>(i), 0}));
  return world;
}
/// The ground, and two balls high above it, on a rod each, one below the other.
World double_pendulum() {
  World world;
  world.add(ground());
  for (const int y : {9, 8}) world.add(small_ball().at({0, static_cast<Real>(y), 0}));
  world.joints = {ball_and_socket(world, the_world, 1, {0, 10, 0}), ball_and_socket(world, 1, 2, {0, 9, 0})};
  return world;
}
/// Balls in a row that touch, the first of them moving towards the others.
World billiards(int balls) {
  World world;
  world.gravity.setZero();
  for (int i = 0; i < balls; ++i) world.add(sphere(Real(0.25), 1).at({static_cast<Real>(i) / 2, 0, 0}));
  world.bodies[0].moving({5, 0, 0});
  return world;
}
World with(World world, const std::function<void(World&)>& change) {
  change(world);
  return world;
}

/// A world with one island, or several alike.
struct Reason {
  StepReason reason;
  StepType step;
  std::string because;
  World world;
  Recommended solver = {};
};
std::vector<Reason> every_reason() {
  using enum StepReason;
  constexpr StepType half_steps = StepType::half_steps, substeps = StepType::substeps;
  Recommended without_savings;
  without_savings.budget.at_first = without_savings.budget.fraction = 0;
  const auto last = [](World& world) -> Body& { return world.bodies.back(); };
  const World driven = with({}, cranked);  // a motion that is prescribed adds energy
  const std::string failure = "half steps did not converge within the work limit, or did not keep the energy";
  return {
      {no_contact, StepType::flight, "nothing touches or holds it",
       with(stack_of(1), [&](World& world) { last(world).position.y() = 9; })},
      {rigid_joints, half_steps, "rigid joints that form a tree, and no contact", double_pendulum()},
      {few_contacts, half_steps, "4 contacts, no more than 8", stack_of(1)},
      {few_contacts, half_steps, "1 contact, no more than 8",
       with(double_pendulum(), [&](World& world) { world.add(small_ball().at({Real(0.2), 8, 0})); })},
      {few_contacts, half_steps, "bodies nearby, but no contact in this step",
       with(stack_of(1), [&](World& world) { last(world).position.y() += Real(0.005); })},
      {resting_contacts, half_steps, "12 contacts, more than 8, but no impact and no fast turn", stack_of(3)},
      {single_contacts, half_steps, "19 contacts, no more than 40, of bodies that meet in one point each",
       billiards(20)},
      {applied_force, substeps, "a spring on box 2",
       with(stack_of(2), [](World& world) { world.forces = {spring(2, {0, 3, 0}, 1)}; })},
      {applied_force, substeps, "wind",
       with(stack_of(1), [](World& world) { world.forces = {{[](World&) {}, "wind"}}; })},
      {joint_loop, substeps, "joints that form a loop",
       with(double_pendulum(),
            [](World& world) {
              world.add(small_ball().at({1, 9, 0}));
              world.joints.push_back(ball_and_socket(world, 2, 3, {1, 8, 0}));
              world.joints.push_back(ball_and_socket(world, 1, 3, {0, 9, 0}));
            })},
      {joint_not_rigid, substeps, "a joint that is not rigid, a motor between ball 1 and ball 2",
       with(double_pendulum(),
            [](World& world) { world.joints.push_back(motor_at_speed(world, 1, 2, Vec3::UnitZ(), 1, 1)); })},
      {asleep, substeps, "box 1 sleeps", with(stack_of(1), [&](World& world) { last(world).asleep = true; })},
      {moving_surface, substeps, "plane 0 turns, or its surface does not move along its face",
       with(stack_of(1), [](World& world) { world.bodies[0].spinning({0, 1, 0}); })},
      {unequal_grounds, substeps, "box 2 moves otherwise than other ground nearby",
       with(stack_of(2), [&](World& world) { last(world).fixed().moving({1, 0, 0}); })},
      {deep_overlap, substeps, "an overlap of 10 mm, more than 5 mm",
       with(stack_of(1), [&](World& world) { last(world).position.y() -= Real(0.01); })},
      {contacts_and_joints, substeps, "12 contacts, more than 8, and joints",
       with(stack_of(3),
            [](World& world) { world.joints = {ball_and_socket(world, the_world, 3, {0, Real(2.5), 0})}; })},
      {impact, substeps, "16 contacts, more than 8, and an impact",
       with(stack_of(4),
            [&](World& world) {
              last(world).moving({0, -2, 0});
              last(world).position.y() += Real(0.01);
            })},
      {fast_turn, substeps, "12 contacts, more than 8, and box 3 turns fast",
       with(stack_of(3), [&](World& world) { last(world).spinning({0, 3, 0}); })},
      {large_pile, substeps, "400 contacts, at least 256, in a pile that moves: as by Fast",
       [] {
         World moving;
         pyramid(moving, 10);
         for (Body& body : moving.bodies)
           if (body.movable()) body.moving({1, 0, 0});
         return moving;
       }()},
      {no_savings, substeps, "12 contacts, more than 8, and half steps cost more than was saved", stack_of(3),
       without_savings},
      {failed, substeps, failure, driven},
      {failed_before, substeps, failure + ", in an earlier step", driven,
       [&] {
         Recommended solver;
         World before = driven;
         before.step(solver, h);
         return solver;
       }()},
  };
}

}  // namespace

TEST_CASE("steps: for each reason there is a scene whose islands get that step, and its answer says why") {
  std::vector<StepReason> seen;
  for (Reason& each : every_reason()) {
    INFO(each.because);
    const std::vector<StepAnswer> answers = steps_of(each.world, each.solver, h);
    REQUIRE(answers.size() == 1);
    CHECK(answers[0].because == each.because);
    CHECK(answers[0].step == each.step);
    each.world.step(each.solver, h);
    for (const int body : answers[0].bodies) {
      CHECK(each.solver.classifier().reason_of(body) == each.reason);
      CHECK(each.solver.step_of(body) == each.step);
    }
    seen.push_back(each.reason);
  }
  seen.erase(std::unique(seen.begin(), seen.end()), seen.end());
  CHECK(seen.size() == static_cast<std::size_t>(StepReason::failed_before));  // all but none
}

TEST_CASE("steps: the answers are the steps that Recommended then takes, and asking changes nothing") {
  int answered[4] = {};
  for (const NamedScene& scene : all_scenes_and_joints()) {
    INFO(scene.name);
    World world;
    scene.fill(world);
    Recommended solver;
    for (int i = 0; i < 4; ++i) {
      const std::uint64_t before = hash_of(world);
      const std::vector<StepAnswer> answers = steps_of(world, solver, h);
      REQUIRE(hash_of(world) == before);
      world.step(solver, h);
      std::vector<StepType> steps(world.bodies.size(), StepType::none);
      StepClassifier classifier = solver.classifier();
      for (const StepAnswer& answer : answers) {
        CHECK(std::is_sorted(answer.bodies.begin(), answer.bodies.end()));
        CHECK(answer.islands == std::count_if(answer.bodies.begin(), answer.bodies.end(),
                                              [&](int body) { return classifier.island_of(body) == body; }));
        for (const int body : answer.bodies) {
          REQUIRE(steps[std::size_t(body)] == StepType::none);  // each body is in one answer
          steps[std::size_t(body)] = answer.step;
        }
      }
      for (const Body& body : world.bodies) {
        REQUIRE(steps[std::size_t(body.index)] == solver.step_of(body.index));
        ++answered[static_cast<int>(solver.step_of(body.index))];
      }
    }
  }
  for (const StepType step : {StepType::flight, StepType::half_steps, StepType::substeps})
    CHECK(answered[static_cast<int>(step)] > 50);
}

TEST_CASE("steps: islands with the same answer are one line, others are not") {
  World world = stack_of(3);
  for (int i = 1; i < 4; ++i) world.add(cube().at({3 * static_cast<Real>(i), Real(0.5), 0}));
  for (int i = 0; i < 2; ++i) world.add(small_ball().at({static_cast<Real>(i), 9, 0}));
  const std::vector<StepAnswer> answers = steps_of(world);
  REQUIRE(answers.size() == 3);
  const auto is = [](const StepAnswer& answer, const std::string& step, int islands, const std::vector<int>& bodies) {
    return name_of(answer.step) == step && answer.islands == islands && answer.bodies == bodies;
  };
  CHECK(is(answers[0], "half steps", 1, {1, 2, 3}));
  CHECK(is(answers[1], "half steps", 3, {4, 5, 6}));
  CHECK(is(answers[2], "flight", 2, {7, 8}));
  CHECK(steps_of(World{}).empty());
}

TEST_CASE("steps: chapter 26's page shows those of the yard after 0.6 s") {
  World yard;
  to_each_its_own_scenes::Yard{}(yard);
  Recommended solver;
  for (int i = 0; i < 36; ++i) yard.step(solver, h);
  std::string table = "| bodies | islands | step | because |\n| --- | --- | --- | --- |\n";
  for (const StepAnswer& answer : steps_of(yard, solver, h))
    table += fmt::format("| {} | {} | {} | {} |\n", answer.bodies.size(), answer.islands, name_of(answer.step),
                         answer.because);
  INFO(table);
  CHECK(contains(text_of("chapters/26_to_each_its_own/README.md"), "\n\n" + table + "\n"));
}
