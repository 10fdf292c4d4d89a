/// What holds for any contacts between any bodies, in any order, after any number of sweeps.
#include "pushback/chapters/07_warm_start/full_solver.h"
#include "pushback/common/bodies/random.h"
#include "pushback/common/world/measure.h"
#include "pushback/common/world/situations.h"
#include "tests/support/catch.h"
#include "tests/support/on_ground.h"
#include "tests/support/yardstick.h"

using namespace pushback;

namespace {

/// Bodies strewn about, masses over four decades, and contacts between any two of them, whether they touch or not: a
/// solver does not look. No more points than would leave the bodies some way to satisfy them all.
struct Tangle {
  World world;

  Tangle(Random& random, int bodies, int points, bool with_immovable = false) {
    for (int i = 0; i < bodies; ++i) {
      const Real mass = random.over_decades(Real(0.1), 1000);
      Body body = random.moving_body(mass);
      if (with_immovable && i == 0) body.fixed().moving(Vec3::Zero()).spinning(Vec3::Zero());
      world.add(body);
    }
    for (Body& body : world.bodies) {
      body.velocity_before = body.velocity;
      body.angular_velocity_before = body.angular_velocity;
    }
    for (int i = 0; i < points; ++i) {
      std::size_t a = random.below(world.bodies.size()), b = random.below(world.bodies.size() - 1);
      if (b >= a) ++b;
      if (a > b) std::swap(a, b);
      Contact contact;
      // Near both: far from a body an impulse would mostly spin it, as no contact does.
      const Vec3 midway = (world.bodies[a].position + world.bodies[b].position) / 2;
      contact.point = midway + random.vector(Real(0.5));
      contact.normal = random.direction();
      contact.depth = random.between(0, Real(0.03));
      contact.friction = random.between(0, 1);
      contact.restitution = random.between(0, 1);
      contact.id = {static_cast<std::uint32_t>(a), static_cast<std::uint32_t>(b), static_cast<std::uint32_t>(i)};
      world.contacts.push_back(contact);
    }
    std::sort(world.contacts.begin(), world.contacts.end(),
              [](const Contact& p, const Contact& q) { return p.id < q.id; });
  }

  /// What is there now will have been one step before.
  void remember() {
    world.contacts_before = world.contacts;
    world.dt_before = h;
  }
};

/// Put last in a solver's list, it sees the rows after every sweep.
struct Spy : Effect {
  std::vector<Real> mu;
  int looks = 0, bad_normals = 0, bad_tangents = 0, at_bound = 0;
  void build(StepContext& step) {
    mu.clear();
    for (const Contact& contact : step.contacts) mu.push_back(contact.friction);
  }
  void sweep(StepContext& step) {
    const Rows& rows = step.rows;
    ++looks;
    for (std::size_t i = 0; i < mu.size(); ++i) {
      if (!(rows[i].impulse >= 0)) ++bad_normals;
    }
    for (std::size_t i = mu.size(); i < rows.size(); ++i) {
      const std::size_t contact = rows[i].owner;
      const Real bound = mu[contact] * rows[contact].impulse;
      if (!(std::abs(rows[i].impulse) <= bound)) ++bad_tangents;
      if (bound > 0 && std::abs(rows[i].impulse) == bound) ++at_bound;
    }
  }
};

/// Likewise: the kinetic energy after every sweep.
struct EnergySpy : Effect {
  std::vector<Real> energies;
  void sweep(StepContext& step) { energies.push_back(kinetic_energy(step.world)); }
};

/// A solver's biases, as they are when everyone has built.
struct BiasSpy : Effect {
  std::vector<std::pair<ContactId, Real>> biases;
  std::vector<ContactId> ids;
  void build(StepContext& step) {
    ids.clear();
    for (const Contact& contact : step.contacts) ids.push_back(contact.id);
  }
  void start(StepContext& step) {
    const Rows& rows = step.rows;
    biases.clear();
    for (std::size_t i = 0; i < ids.size(); ++i) biases.emplace_back(ids[i], rows[i].bias);
    std::sort(biases.begin(), biases.end());
  }
};

/// Largest difference of a velocity or an angular velocity.
Real difference(const World& p, const World& q) {
  Real largest = 0;
  for (std::size_t i = 0; i < p.bodies.size(); ++i) {
    largest = std::max(largest, (p.bodies[i].velocity - q.bodies[i].velocity).cwiseAbs().maxCoeff());
    largest = std::max(largest, (p.bodies[i].angular_velocity - q.bodies[i].angular_velocity).cwiseAbs().maxCoeff());
  }
  return largest;
}

/// A heap of everything, falling and rubbing and bouncing between four walls.
void heap(World& world, std::uint64_t seed, int bodies, Real mu, Real e) {
  Random random(seed);
  world.add(ground().rough(mu).bouncy(e));
  for (const Vec3& inwards : {Vec3(1, 0, 0), Vec3(-1, 0, 0), Vec3(0, 0, 1), Vec3(0, 0, -1)}) {
    world.add(half_space(inwards).at(Real(-1.5) * inwards).rough(mu).bouncy(e));
  }
  for (int i = 0; i < bodies; ++i) {
    const Real mass = random.over_decades(1, 100);
    Body body = random.body(mass);
    Vec3 place = random.vector(1);
    place.y() = 1 + static_cast<Real>(i) * Real(0.5);
    world.add(body.at(place).moving(random.vector(2)).spinning(random.vector(3)).rough(mu).bouncy(e));
  }
}

/// Whether two solvers do the same to a heap, to the last bit, for two seconds.
template <class P, class Q>
bool alike(Real mu, Real e, P p = {}, Q q = {}) {
  World one, other;
  heap(one, 7, 12, mu, e);
  heap(other, 7, 12, mu, e);
  int touching = 0;
  for (int step = 0; step < 120; ++step) {
    one.step(p, h, 8);
    other.step(q, h, 8);
    touching += static_cast<int>(one.contacts.size());
    if (hash_of(one) != hash_of(other)) return false;
  }
  return touching > 1000;  // or nothing has been compared
}

}  // namespace

TEST_CASE("after every sweep: sum(lambda_n) >= 0 and |sum(lambda_t)| <= mu sum(lambda_n)") {
  Random random(1);
  int looks = 0, at_bound = 0;
  for (int i = 0; i < 200; ++i) {
    Tangle tangle(random, 8, 12, i % 2 == 0);
    Solver<Clamping, Baumgarte, Slop, Restitution, Friction, Spy> cold;
    cold.solve(tangle.world, h, 20);
    Solver<Clamping, Baumgarte, Slop, Restitution, Friction, WarmStart, Spy> warm;
    for (int step = 0; step < 3; ++step) {  // from the second step on it starts from remembered impulses
      for (Contact& contact : tangle.world.contacts)
        contact.normal = (contact.normal + random.vector(Real(0.1))).normalized();
      for (Body& body : tangle.world.bodies) {
        if (body.movable()) body.velocity += random.vector(1);
      }
      warm.solve(tangle.world, h, 20);
      tangle.remember();
    }
    REQUIRE(cold.bad_normals + warm.bad_normals == 0);
    REQUIRE(cold.bad_tangents + warm.bad_tangents == 0);
    looks += cold.looks + warm.looks;
    at_bound += cold.at_bound + warm.at_bound;
  }
  CHECK(looks == 200 * 80);
  CHECK(at_bound > 1000);  // some slide: the bound was put to the test
}

// Each solve minimises the kinetic energy along its row, within the row's limits; only a bias could feed any in.
TEST_CASE("without bias every sweep of clamped normals takes kinetic energy out, or leaves it") {
  Random random(3);
  for (int i = 0; i < 200; ++i) {
    Tangle tangle(random, 8, 14, i % 2 == 0);
    Solver<Clamping, EnergySpy> solver;
    const Real start = kinetic_energy(tangle.world);
    solver.solve(tangle.world, h, 50);
    Real before = start;
    for (const Real energy : solver.energies) {
      REQUIRE(energy <= before + 100 * eps * start);
      before = energy;
    }
  }
}

TEST_CASE("the order of the contacts changes neither the biases nor, once converged, the velocities") {
  Random random(6);
  for (int i = 0; i < 30; ++i) {
    const Tangle tangle(random, 8, 8, i % 2 == 0);
    using Bouncing = Solver<Clamping, Baumgarte, Slop, Restitution, BiasSpy>;
    World world = tangle.world;
    std::vector<std::pair<ContactId, Real>> biases;
    World reference;
    for (int order = 0; order < 4; ++order) {
      World copy = tangle.world;
      if (order > 0) random.shuffle(copy.contacts);
      Bouncing solver;
      solver.solve(copy, h, 10000);
      if (order == 0) {
        biases = solver.biases;
        reference = copy;
      } else {
        REQUIRE(solver.biases == biases);
        INFO("difference " << difference(copy, reference));
        CHECK(difference(copy, reference) < 10 * tiny);
      }
    }
  }
}

TEST_CASE("the order of effects in a solver's list does not matter, to the last bit") {
  CHECK(alike<FullSolver, Solver<WarmStart, Friction, Restitution, Slop, Baumgarte, Clamping>>(Real(0.6), Real(0.4)));
}
