/// Chapter 26: what an island calls for.
#include "pushback/engine/islands/step_classifier.h"

#include "pushback/chapters/13_joints/ball_and_socket.h"
#include "pushback/chapters/13_joints/hinge.h"
#include "pushback/chapters/15_limits_motors_springs/limits.h"
#include "pushback/chapters/15_limits_motors_springs/spring.h"
#include "tests/support/catch.h"
#include "tests/support/yardstick.h"

using namespace pushback;

namespace {

constexpr Real threshold = Real(0.1);  // m/s

/// The ground, and boxes of 1 m that stand on it, 2 m apart.
World standing(int boxes) {
  World world;
  world.gravity = {0, -g, 0};
  world.add(ground());
  for (int i = 0; i < boxes; ++i)
    world.add(box(Vec3::Constant(Real(0.5)), 10).at({2 * static_cast<Real>(i), Real(0.5), 0}));
  return world;
}
Contact contact_of(std::uint32_t a, std::uint32_t b, std::uint32_t feature, Real depth = 0) {
  Contact contact;
  contact.id = {a, b, feature};
  contact.normal = Vec3::UnitY();
  contact.depth = depth;
  return contact;
}
/// So many between the ground and body 1.
Contacts below_the_first(int count, Real depth = 0) {
  Contacts contacts;
  for (int i = 0; i < count; ++i) contacts.push_back(contact_of(0, 1, static_cast<std::uint32_t>(i), depth));
  return contacts;
}
void find(StepClassifier& calls, const World& world, const Contacts& contacts) {
  calls.classify(world, contacts, h, threshold, {});
}
/// What body 1 is moved by, the contacts being those that there are.
StepType called_by_first(World world) {
  world.find_contacts({.least = Real(0.02), .ahead = h});
  StepClassifier calls;
  find(calls, world, world.contacts);
  return calls.step_of(1);
}
/// Two balls on a rod each, one below the other, high above all else.
World pendulum() {
  World world;
  world.add(ground());
  world.add(sphere(Real(0.1), 1).at({0, 9, 0}));
  world.add(sphere(Real(0.1), 1).at({0, 8, 0}));
  world.joints = {ball_and_socket(world, the_world, 1, {0, 10, 0}), ball_and_socket(world, 1, 2, {0, 9, 0})};
  return world;
}

}  // namespace

TEST_CASE("calls: one that is near the limit stays what it is") {
  const World world = standing(1);
  StepClassifier calls;
  const auto many = [&](int contacts) {
    find(calls, world, below_the_first(contacts));
    CHECK(calls.step_of(1) == StepType::half_steps);  // it is calm
    CHECK(calls.contacts(1) == contacts);
    return calls.many_contacts(1);
  };
  // Many contacts that were left to substeps stay many until there are few.
  CHECK(many(9));
  calls.leave_to_substeps(1, StepReason::failed);
  CHECK(many(12));
  calls.leave_to_substeps(1, StepReason::failed);
  for (const int contacts : {8, 9, 12, 9, 12}) {
    CAPTURE(contacts);
    CHECK_FALSE(many(contacts));
  }
  CHECK(many(13));
  calls.leave_to_substeps(1, StepReason::failed);
  CHECK(many(12));
  calls.leave_to_substeps(1, StepReason::failed);
  CHECK_FALSE(many(8));
}

TEST_CASE(
    "calls: few contacts of what is joined have half steps, many have not, and near the limit it stays what it is") {
  World world = standing(1);
  world.joints = {ball_and_socket(world, the_world, 1, {0, 1, 0})};
  StepClassifier calls;
  find(calls, world, {});
  CHECK(calls.step_of(1) == StepType::half_steps);
  CHECK_FALSE(calls.near(1));
  calls.leave_to_substeps(1, StepReason::failed);
  const auto call = [&](int contacts) {
    find(calls, world, below_the_first(contacts));
    CHECK(calls.near(1));
    CHECK(calls.contacts(1) == contacts);
    return calls.step_of(1);
  };
  CHECK(call(9) == StepType::substeps);  // at rest, too: joints and many contacts are not solved from what they bore
  CHECK(call(12) == StepType::substeps);
  for (const int contacts : {8, 9, 12, 1, 12}) CHECK(call(contacts) == StepType::half_steps);
  CHECK(call(13) == StepType::substeps);
  CHECK(call(12) == StepType::substeps);
  CHECK(call(8) == StepType::half_steps);
}

TEST_CASE("calls: many contacts have half steps while nothing arrives and nothing turns fast, few in any case") {
  World world = standing(1);
  StepClassifier calls;
  const ClassifierLimits limits;
  const auto call = [&](int contacts, Real turn, Real arrives) {
    world.bodies[1].angular_velocity = {0, turn / h, 0};
    world.bodies[1].velocity = {0, -arrives, 0};
    calls.leave_to_substeps(1, StepReason::failed);
    find(calls, world, below_the_first(contacts, -Real(1e-4)));
    return calls.step_of(1);
  };
  calls.classify(world, {}, h, threshold, limits);
  for (const int contacts : {8, 9, 100}) {
    CAPTURE(contacts);
    const StepType else_by = contacts > 8 ? StepType::substeps : StepType::half_steps;
    CHECK(call(contacts, limits.turn * Real(0.99), 0) == StepType::half_steps);
    CHECK(call(contacts, limits.turn * Real(1.01), 0) == else_by);
    CHECK(call(contacts, 0, threshold * Real(0.9)) == StepType::half_steps);
    CHECK(call(contacts, 0, 2) == else_by);
    CHECK(calls.impact(1));
  }
}

TEST_CASE("calls: no contact is flight, however many islands there are, and what is not there is moved by nothing") {
  const World world = standing(3);
  StepClassifier calls;
  find(calls, world, below_the_first(4));
  CHECK(calls.step_of(0) == StepType::none);
  CHECK(calls.step_of(1) == StepType::half_steps);
  CHECK(calls.step_of(2) == StepType::flight);
  CHECK(calls.step_of(3) == StepType::flight);
  CHECK(calls.step_of(4) == StepType::none);
  CHECK(calls.step_of(1000) == StepType::none);
}

TEST_CASE("calls: the ground joins nobody, a contact between two that move does, and both have its many contacts") {
  const World world = standing(3);
  Contacts contacts;
  for (std::uint32_t body = 1; body <= 3; ++body)
    for (std::uint32_t i = 0; i < 4; ++i) contacts.push_back(contact_of(0, body, i));
  StepClassifier calls;
  find(calls, world, contacts);
  for (int body = 1; body <= 3; ++body) {
    CHECK(calls.island_of(body) == body);
    CHECK(calls.step_of(body) == StepType::half_steps);
  }
  StepClassifier anew;
  contacts.push_back(contact_of(1, 2, 0));
  find(anew, world, contacts);
  CHECK(anew.island_of(2) == 1);
  CHECK(anew.contacts(1) == 9);
  CHECK(anew.contacts(3) == 4);
  CHECK(anew.many_contacts(1));  // nobody had half steps
  CHECK_FALSE(anew.many_contacts(3));
  find(calls, world, contacts);  // both had half steps
  CHECK_FALSE(calls.many_contacts(1));
}

TEST_CASE("calls: many balls have half steps when they meet, many boxes do not") {
  World world = standing(1);
  world.gravity.setZero();
  for (int i = 0; i < 20; ++i) world.add(sphere(Real(0.5), 1).at({static_cast<Real>(i), 9, 0}));
  Contacts row;
  for (std::uint32_t i = 2; i < 21; ++i) row.push_back(contact_of(i, i + 1, 0));
  for (Contact& contact : row) contact.normal = Vec3::UnitX();
  const auto call = [&] {
    StepClassifier calls;
    find(calls, world, row);
    CHECK(calls.many_contacts(2));
    return std::pair{calls.step_of(2), calls.impact(2)};
  };
  CHECK(call() == std::pair{StepType::half_steps, false});  // it is calm
  world.bodies[2].velocity.x() = 5;
  CHECK(call() == std::pair{StepType::half_steps, true});
  row.push_back(row.back());  // a second point of the same pair: no balls
  row.back().id.feature = 1;
  CHECK(call() == std::pair{StepType::substeps, true});
}

TEST_CASE("calls: what arrives slower than the threshold, or rests, is no impact") {
  World world = standing(1);
  StepClassifier calls;
  const auto impact = [&](Real speed, Real gap) {
    world.bodies[1].velocity.y() = -speed;
    find(calls, world, below_the_first(1, -gap));
    return calls.impact(1);
  };
  CHECK(impact(1, Real(0.01)));
  CHECK_FALSE(impact(Real(0.09), Real(0.001)));
  CHECK_FALSE(impact(0, 0));
  CHECK_FALSE(impact(Real(0.15), 0));  // less than a step's fall, and it touches already
  CHECK(impact(Real(0.15), Real(1e-4)));
  CHECK_FALSE(impact(1, Real(0.5)));  // not in this step
}

TEST_CASE("calls: half steps have what they can hold, the others go to substeps") {
  CHECK(called_by_first(standing(1)) == StepType::half_steps);
  CHECK(called_by_first(pendulum()) == StepType::half_steps);

  World asleep = standing(1);
  asleep.bodies[1].asleep = true;
  CHECK(called_by_first(asleep) == StepType::substeps);

  for (const std::vector<int>& on : {std::vector<int>{}, {1}}) {
    World forced = standing(2);
    forced.forces.push_back({[](World&) {}, "a breeze", on});
    CHECK(called_by_first(forced) == StepType::substeps);
  }
  World beside = standing(2);
  beside.forces.push_back({[](World&) {}, "a breeze", {2}});
  CHECK(called_by_first(beside) == StepType::half_steps);

  World deep = standing(1);
  deep.bodies[1].position.y() -= Real(0.004);
  CHECK(called_by_first(deep) == StepType::half_steps);
  deep.bodies[1].position.y() -= Real(0.006);
  CHECK(called_by_first(deep) == StepType::substeps);

  World loop = pendulum();
  loop.add(sphere(Real(0.1), 1).at({1, 9, 0}));
  loop.joints.push_back(ball_and_socket(loop, 2, 3, {1, 8, 0}));
  CHECK(called_by_first(loop) == StepType::half_steps);
  loop.joints.push_back(ball_and_socket(loop, 1, 3, {0, 9, 0}));
  CHECK(called_by_first(loop) == StepType::substeps);

  World limited = pendulum();
  limited.joints[0] = hinge(limited, the_world, 1, {0, 10, 0}, Vec3::UnitZ());
  CHECK(called_by_first(limited) == StepType::half_steps);
  limited.joints[1] = angle_limits(limited, 1, 2, Vec3::UnitZ(), -1, 1);
  CHECK(called_by_first(limited) == StepType::substeps);
}
