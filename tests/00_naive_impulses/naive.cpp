/// Impulses pair by pair: what they keep, and how a stack falls apart.
#include "pushback/chapters/00_naive_impulses/naive.h"
#include "pushback/chapters/00_naive_impulses/scenes.h"
#include "pushback/common/world/measure.h"
#include "tests/support/catch.h"
#include "tests/support/on_ground.h"
#include "tests/support/touching.h"

using namespace pushback;

namespace {

/// Two spinning bodies, each within reach of one point, that approach there.
struct Collision : RandomPair {
  Collision(Random& random, Real e) : RandomPair(random) {
    if (speed() > 0) contact.normal = -contact.normal;
    contact.restitution = e;
  }
  Real speed() const { return separating_speed(world, contact); }
  Real K() { return 1 / row(contact.normal).effective_mass; }
};

}  // namespace

TEST_CASE("00: the pairwise impulse with e = 1 keeps energy and momenta, spinning bodies too") {
  Random random(1);
  for (int i = 0; i < 500; ++i) {
    Collision hit(random, 1);
    const Real energy = kinetic_energy(hit.world);
    const Vec3 p = momentum(hit.world), l = angular_momentum(hit.world);
    const Real approach = hit.speed();
    const Real f = pair_impulse(hit.world, hit.contact);
    apply_impulse(hit.world, hit.contact, f);
    // The energies that change hands are f v: as large as the energies themselves.
    REQUIRE(std::abs(kinetic_energy(hit.world) - energy) <= 1000 * eps * (energy + std::abs(f * approach)));
    const Real size = 40 * f + 100 * 1100;  // N s: what was exchanged, and m v of the heaviest
    REQUIRE((momentum(hit.world) - p).norm() <= 16 * eps * size);
    REQUIRE((angular_momentum(hit.world) - l).norm() <= 64 * eps * size);
    REQUIRE(hit.speed() == Approx(-approach).epsilon(tiny));
  }
}

TEST_CASE("00: it parts the bodies e times as fast as they met, and loses (1 - e^2) s^2 / 2K") {
  Random random(2);
  for (int i = 0; i < 500; ++i) {
    const Real e = random.between(0, 1);
    Collision hit(random, e);
    const Real energy = kinetic_energy(hit.world), s = hit.speed();
    apply_impulse(hit.world, hit.contact, pair_impulse(hit.world, hit.contact));
    REQUIRE(std::abs(hit.speed() + e * s) <= tiny * std::abs(s) + 1e4 * eps);
    REQUIRE(std::abs(energy - kinetic_energy(hit.world) - (1 - e * e) * s * s / (2 * hit.K())) <= 1e3 * eps * energy);
    REQUIRE(pair_impulse(hit.world, hit.contact) == 0);  // they part: no more impulse
  }
}

TEST_CASE("00: pushing apart ends the overlap and leaves the common centre of mass where it was") {
  Random random(4);
  for (int i = 0; i < 200; ++i) {
    Collision hit(random, 0);
    const Body &a = hit.world.bodies[0], &b = hit.world.bodies[1];
    const auto moment = [&]() -> Vec3 { return a.position / a.inverse_mass + b.position / b.inverse_mass; };
    const Vec3 before = moment();
    const Real gap = (b.position - a.position).dot(hit.contact.normal);
    push_apart(hit.world, hit.contact);
    REQUIRE((moment() - before).norm() <= 16 * eps * 4000);
    REQUIRE(std::abs((b.position - a.position).dot(hit.contact.normal) - gap - hit.contact.depth) <= 32 * eps);
  }
}

TEST_CASE("00: in a stack, boxes that are pushed apart by hand change places") {
  World world;
  stack(world, 5);
  NaiveAveraged solver;
  for (int step = 0; step < 60; ++step) world.step(solver, h, 10);
  CHECK(world.bodies[1].position.y() >
        world.bodies[5].position.y() + 4);  // the lowest on top, the topmost at the bottom
  for (const Body& body : world.bodies) CHECK(std::hypot(body.position.x(), body.position.z()) < Real(0.5));
}
