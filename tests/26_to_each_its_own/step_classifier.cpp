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
