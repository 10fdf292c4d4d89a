/// Chapter 26: what an island calls for.
#include "pushback/engine/islands/step_classifier.h"

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

TEST_CASE("calls: a body that has become immovable has no step") {
  World world = standing(2);
  StepClassifier calls;
  find(calls, world, {});
  REQUIRE(calls.step_of(1) != StepType::none);
  world.bodies[1].fixed();
  find(calls, world, {});
  CHECK(calls.step_of(1) == StepType::none);
  CHECK(calls.step_of(2) != StepType::none);
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
    CHECK(call(contacts, limits.fast_turn * Real(0.99), 0) == StepType::half_steps);
    CHECK(call(contacts, limits.fast_turn * Real(1.01), 0) == else_by);
    CHECK(call(contacts, 0, threshold * Real(0.9)) == StepType::half_steps);
    CHECK(call(contacts, 0, 2) == else_by);
    CHECK(calls.impact(1));
  }
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

TEST_CASE("calls: a corner that turns towards the ground arrives where no contact is yet") {
  const auto impact = [](Real tip_speed) {
    constexpr Real half_length = 2, half_height = Real(0.1), gap = Real(1e-3);
    World world;
    world.gravity = {0, -g, 0};
    world.add(ground());
    world.add(box({half_length, half_height, half_height}, 10)
                  .at({0, half_height + gap, 0})
                  .spinning({0, 0, tip_speed / half_length}));
    StepClassifier calls;
    find(calls, world, below_the_first(1, -gap));  // below its centre, which does not move
    return calls.impact(1);
  };
  CHECK(impact(3 * threshold));
  CHECK(impact(-3 * threshold));
  CHECK_FALSE(impact(Real(0.9) * threshold));
  CHECK_FALSE(impact(0));
}
