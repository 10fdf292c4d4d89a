/// Chapter 18: the plain form of the block elimination, compared with the engine and with the page's closed form.
#include "pushback/chapters/18_direct_joints/plain.h"

#include "pushback/chapters/13_joints/ball_and_socket.h"
#include "pushback/chapters/18_direct_joints/scenes.h"
#include "pushback/common/bodies/random.h"
#include "pushback/engine/direct/direct_joints.h"
#include "tests/support/catch.h"
#include "tests/support/yardstick.h"

using namespace pushback;

namespace {

/// A chain of bodies, and the places of its joints from the hook down, m.
struct HungChain {
  World world;
  std::vector<Vec3> joints;

  plain_18::Chain plain() const {
    plain_18::Chain chain;
    for (std::size_t i = 0; i < joints.size(); ++i) {
      const Body& body = world.bodies[i];
      const bool last = i + 1 == joints.size();
      chain.push_back({1 / body.inverse_mass, body.inverse_inertia, joints[i] - body.position,
                       last ? Vec3::Zero() : Vec3(joints[i + 1] - body.position), body.velocity,
                       body.angular_velocity});
    }
    return chain;
  }
};

/// The page's chain: `links` of 1 kg, and a load.
HungChain straight_chain(int links, Real load) {
  HungChain chain;
  direct_joints_scenes::LoadedChain{links, load}(chain.world);
  const Real length = direct_joints_scenes::LoadedChain::length / static_cast<Real>(links);
  for (int i = 0; i <= links; ++i) chain.joints.emplace_back(0, -length * static_cast<Real>(i), 0);
  return chain;
}

/// Centres of mass are not half-way between joints, as A_i,i+1 would then be symmetric.
HungChain tangled_chain(Random& random, int links) {
  HungChain chain;
  Vec3 end = Vec3::Zero();
  for (int i = 0; i < links; ++i) {
    const Vec3 next = end + random.direction(), centre = (end + next) / 2 + random.direction() / 4;
    const Real y = random.between(Real(0.1), Real(0.3)), x = random.between(Real(0.1), Real(0.3));
    chain.world.add(
        box({x, y, Real(0.2)}, random.over_decades(Real(0.3), 30)).oriented(random.orientation()).at(centre));
    chain.world.joints.push_back(ball_and_socket(chain.world, i == 0 ? the_world : i - 1, i, end));
    chain.joints.push_back(end);
    end = next;
  }
  return chain;
}

/// The largest difference from the engine's impulses after one solve, relative to the largest impulse.
Real difference_from_engine(HungChain& chain, Random& random) {
  World& world = chain.world;
  for (Body& body : world.bodies)
    if (body.movable()) body.moving(random.direction()).spinning(random.direction());
  world.begin_step(h);
  world.contacts.clear();  // of links that lie across each other
  const std::vector<Vec3> impulses = plain_18::impulses_of(chain.plain());
  Solver<DirectJoints> engine;
  engine.solve(world, h, 1);
  REQUIRE(engine.joint_rows().size() == 3 * impulses.size());
  CHECK(engine.matrix().off_diagonal_blocks() == plain_18::factor(plain_18::matrix_of(chain.plain())).l.size());
  Real largest = 0, off = 0;
  for (std::size_t i = 0; i < impulses.size(); ++i) {
    const auto row = [&](std::size_t axis) { return engine.joint_rows()[3 * i + axis].impulse; };
    const Vec3 of_engine(row(0), row(1), row(2));
    largest = std::max(largest, of_engine.norm());
    off = std::max(off, (impulses[i] - of_engine).norm());
  }
  return off / largest;
}

}  // namespace

TEST_CASE("plain chain: its impulses are those of the engine's direct joint solve") {
  Random random(18);
  for (const Real load : {Real(1), Real(30), Real(1000)}) {
    HungChain chain = straight_chain(20, load);
    CAPTURE(load);
    CHECK(difference_from_engine(chain, random) < (in_double ? Real(5e-12) : Real(1e-2)));
  }
  for (int links = 1; links <= 40; ++links) {
    HungChain chain = tangled_chain(random, links);
    CAPTURE(links);
    CHECK(difference_from_engine(chain, random) < (in_double ? Real(1e-12) : Real(1e-3)));
  }
}

TEST_CASE("plain chain: the impulses stop each joint from separating, in a chain of ten thousand links, too") {
  plain_18::Chain chain;
  Random random(19);
  for (int i = 0; i < 10000; ++i) {
    chain.push_back({random.over_decades(Real(0.3), 30), Mat3::Identity() * random.between(10, 100), random.direction(),
                     random.direction(), random.direction(), random.direction()});
  }
  const auto largest = [&chain] {
    Real speed = 0;
    for (const Vec3& one : plain_18::separation(chain)) speed = std::max(speed, one.norm());
    return speed;
  };
  const Real before = largest();
  const std::vector<Vec3> impulses = plain_18::impulses_of(chain);
  const auto push = [](plain_18::Link& link, const Vec3& at, const Vec3& impulse) {
    link.v += impulse / link.mass;
    link.w += link.inverse_inertia * at.cross(impulse);
  };
  for (std::size_t i = 0; i < chain.size(); ++i) {
    push(chain[i], chain[i].upper, impulses[i]);
    if (i > 0) push(chain[i - 1], chain[i - 1].lower, -impulses[i]);
  }
  CHECK(largest() < (in_double ? Real(1e-11) : Real(1e-2)) * before);
}

TEST_CASE("plain chain: along a straight chain a joint feels i / (i + 1) m, and the hook all of the mass") {
  for (const int weights : {2, 5, 21}) {
    const HungChain chain = straight_chain(weights - 1, 1);
    const std::vector<Mat3> mass = plain_18::factor(plain_18::matrix_of(chain.plain())).mass;
    REQUIRE(mass.size() == static_cast<std::size_t>(weights));
    for (int i = 1; i < weights; ++i) {
      const Real felt = mass[static_cast<std::size_t>(weights - i)](1, 1);
      CHECK(felt == Approx(static_cast<Real>(i) / static_cast<Real>(i + 1)).epsilon(100 * eps));
    }
    CHECK(mass[0](1, 1) == Approx(weights).epsilon(100 * eps));
  }
}
