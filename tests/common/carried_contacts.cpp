/// One detection for several substeps: the contacts between are those that detection would have found.
#include "pushback/common/world/carried_contacts.h"

#include "pushback/chapters/12_soft_contacts/steady_solver.h"
#include "pushback/common/bodies/random.h"
#include "pushback/common/world/measure.h"
#include "pushback/common/world/situations.h"
#include "tests/support/catch.h"
#include "tests/support/yardstick.h"

using namespace pushback;

namespace {

template <class ContactSolver>
void frame(World& world, ContactSolver& solver, CarriedContacts& carried, int count, int sweeps) {
  carried.find_anew();
  for (int i = 0; i < count; ++i) step(world, solver, h / static_cast<Real>(count), sweeps, carried);
}

}  // namespace

TEST_CASE("with one substep for each detection the bits are those of World::step") {
  World one, other;
  pyramid(one, 5);
  pyramid(other, 5);
  FullSolver solver, same;
  CarriedContacts carried;
  for (int i = 0; i < 120; ++i) {
    one.step(solver, h, 10);
    frame(other, same, carried, 1, 10);
    REQUIRE(hash_of(one) == hash_of(other));
  }
}

TEST_CASE("where bodies only shift, the contacts that are carried are those that detection finds") {
  Random random(1);
  for (int i = 0; i < 100; ++i) {
    World world;
    world.gravity.setZero();
    world.add(ground());
    const Vec3 velocity = random.vector(Real(0.1));
    world.add(box(Vec3::Constant(Real(0.5)), 10).at({0, Real(0.45), 0}).moving(velocity));
    CarriedContacts carried;
    carried.find_contacts(world);
    const Contacts first = world.contacts;
    REQUIRE(first.size() == 4);
    for (int step = 0; step < 8; ++step) {
      world.move(h / 8);
      carried.find_contacts(world);
      const Contacts now = world.contacts;
      world.find_contacts();
      REQUIRE(now.size() == world.contacts.size());
      for (std::size_t k = 0; k < now.size(); ++k) {
        CHECK(now[k].id == world.contacts[k].id);
        CHECK(std::abs(now[k].depth - world.contacts[k].depth) <= 16 * eps);
        // The ground's point stays where it was found, the box's rides along: midway is half the way.
        const Vec3 way = static_cast<Real>(step + 1) * h / 8 * velocity;
        CHECK((now[k].point - (first[k].point + way / 2)).norm() <= 16 * eps);
      }
    }
  }
}

TEST_CASE("what parts between two detections is left out, and is there again when it comes back") {
  World world;
  world.gravity.setZero();
  world.add(ground());
  world.add(sphere(1, 1).at({0, Real(0.99), 0}));
  CarriedContacts carried;
  carried.find_contacts(world);
  REQUIRE(world.contacts.size() == 1);
  world.bodies[1].at({0, Real(1.01), 0});
  carried.find_contacts(world);
  CHECK(world.contacts.empty());
  world.bodies[1].at({0, Real(0.995), 0});
  carried.find_contacts(world);
  REQUIRE(world.contacts.size() == 1);
  CHECK(world.contacts[0].depth == Approx(0.005));
}

TEST_CASE("a stack of ten stands on one detection for eight substeps as it does on eight") {
  World once, each;
  stack(once, 10);
  stack(each, 10);
  SteadySolver of_once, of_each;
  CarriedContacts carried;
  for (int i = 0; i < 300; ++i) {
    frame(once, of_once, carried, 8, 1);
    substeps(each, of_each, h, 8);
  }
  for (std::size_t i = 1; i < once.bodies.size(); ++i) {
    const Vec3& place = once.bodies[i].position;
    CHECK(std::hypot(place.x(), place.z()) < Real(1e-3));
    CHECK(std::abs(place.y() - each.bodies[i].position.y()) < Real(1e-4));
  }
  CHECK(largest_speed(once) < Real(1e-3));
}
