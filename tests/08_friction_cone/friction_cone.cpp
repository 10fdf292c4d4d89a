/// The cone of chapter 08: what holds where it has come to rest, for any contact, and what it does to things that slide.
#include <Eigen/LU>

#include "pushback/chapters/07_warm_start/full_solver.h"
#include "pushback/chapters/08_friction_cone/scaled_back.h"
#include "pushback/chapters/08_friction_cone/scenes.h"
#include "pushback/common/bodies/random.h"
#include "pushback/common/world/measure.h"
#include "tests/support/catch.h"
#include "tests/support/yardstick.h"

using namespace pushback;
using namespace pushback::friction_cone_scenes;
using namespace pushback::friction_scenes;

namespace {

/// What thousands of sweeps leave, relatively, or in m/s: rounding.
constexpr Real tiny = std::numeric_limits<Real>::digits > 24 ? Real(1e-9) : Real(2e-4);

template <class AnyFriction>
using With = Solver<Clamping, Baumgarte, Slop, Restitution, AnyFriction, WarmStart>;

/// Two bodies that move and spin, or one and a wall, and a point of both at which they approach.
struct Meeting {
  World world;

  explicit Meeting(Random& random) {
    for (int i = 0; i < 2; ++i) {
      const Real mass = random.over_decades(Real(0.1), 1000);
      world.add(random.moving_body(mass));
    }
    if (random.below(2) == 0) world.bodies[0].fixed().moving(Vec3::Zero()).spinning(Vec3::Zero());
    Contact contact;
    contact.id = {0, 1, 0};
    contact.point = (world.bodies[0].position + world.bodies[1].position) / 2 + random.vector(Real(0.5));
    contact.normal = random.direction();
    if (separating_speed(world, contact) > 0) contact.normal = -contact.normal;
    contact.friction = random.between(Real(0.1), Real(1.5));
    world.contacts = {contact};
  }
  const Contact& contact() const { return world.contacts[0]; }
  /// Of B's point against A's.
  Vec3 velocity() const {
    const auto [a, b] = world.bodies_of(contact());
    return b.velocity_at(contact().point) - a.velocity_at(contact().point);
  }
  Vec3 in_plane(const Vec3& v) const { return v - v.dot(contact().normal) * contact().normal; }
  Vec3 slip() const { return in_plane(velocity()); }
  Vec3 friction() const { return in_plane(contact().impulse); }
  /// What an impulse does to the velocity of B's point relative to A's: the sum of 1/m - [r] I^-1 [r], 1/kg.
  Mat3 k() const {
    Mat3 sum = Mat3::Zero();
    for (const Body& body : world.bodies) {
      const Mat3 r = skew(contact().point - body.position);
      sum += body.inverse_mass * Mat3::Identity() - r * body.inverse_inertia * r;
    }
    return sum;
  }
  /// Whether the impulse that would stop the point altogether pushes: it may have to pull, and then no mu is enough.
  bool can_be_held() const { return (k().inverse() * velocity()).dot(contact().normal) < 0; }
  /// Whether friction at its bound may take as much from the normal speed as the normal impulse that bounds it gives:
  /// Painleve's paradox. There may be no solution then, or several.
  bool paradox() const {
    const Vec3 by_normal = k() * contact().normal;
    return contact().friction * in_plane(by_normal).norm() >= by_normal.dot(contact().normal);
  }
  Real bound() const { return contact().friction * contact().impulse.dot(contact().normal); }
  bool at_the_bound() const { return friction().norm() > (1 - tiny) * bound(); }
};

/// Put last in a solver's list: how far beyond its disc any friction is after any sweep, relatively.
struct DiscSpy : Effect {
  std::vector<Real> mu;
  Real worst = 0;
  int at_edge = 0;
  void build(StepContext& step) {
    mu.clear();
    for (const Contact& contact : step.contacts) mu.push_back(contact.friction);
  }
  void sweep(StepContext& step) {
    const Rows& rows = step.rows;
    for (std::size_t tangent = mu.size(); tangent < rows.size(); tangent += 2) {
      const std::size_t contact = rows[tangent].owner;
      const Real radius = mu[contact] * rows[contact].impulse;
      const Real length = std::hypot(rows[tangent].impulse, rows[tangent + 1].impulse);
      if (length > radius) worst = std::max(worst, radius > 0 ? length / radius - 1 : std::numeric_limits<Real>::max());
      if (radius > 0 && length > (1 - 4 * eps) * radius) ++at_edge;
    }
  }
};

/// How a plank comes to rest on the ground, everything turned about the vertical by `turn`, and then back.
template <class ContactSolver>
std::vector<Vec3> turned_slide(Real turn) {
  World world;
  world.add(ground().rough(1));
  world.add(plank(Real(0.3), Vec3::Zero(), turn, Push{}).turned(turn + Real(0.4), Vec3::UnitY()).spinning({0, 3, 0}));
  ContactSolver solver;
  std::vector<Vec3> path;
  const Eigen::AngleAxis<Real> back(-turn, Vec3::UnitY());
  for (int step = 0; step < 90; ++step) {
    world.step(solver, h, 10);
    path.push_back(back * world.bodies[1].position);
    path.push_back(back * world.bodies[1].velocity);
  }
  return path;
}
template <class ContactSolver>
Real largest_change_by_turning() {
  const std::vector<Vec3> straight = turned_slide<ContactSolver>(0);
  Real largest = 0;
  for (const Real turn : {Real(0.3), Real(0.8), Real(1.7), Real(3), Real(-2.2)}) {
    const std::vector<Vec3> turned = turned_slide<ContactSolver>(turn);
    for (std::size_t i = 0; i < turned.size(); ++i) largest = std::max(largest, (turned[i] - straight[i]).norm());
  }
  return largest;
}

}  // namespace

TEST_CASE("08: where nothing changes any more, friction holds, or is at its bound and opposite to the slip") {
  Random random(1);
  int held = 0, slid = 0;
  for (int i = 0; i < 1000; ++i) {
    Meeting m(random);
    if (m.paradox()) continue;
    Solver<Clamping, FrictionCone> solver;
    solver.solve(m.world, h, 5000);
    INFO("meeting " << i);
    REQUIRE(m.bound() > 0);
    if (m.at_the_bound() && m.slip().norm() > tiny) {
      ++slid;
      CHECK(direction_error(m.slip(), m.friction()) * m.slip().norm() < 60 * tiny);  // degrees times m/s
      CHECK(m.friction().norm() == Approx(m.bound()).epsilon(tiny));
    } else {
      ++held;
      CHECK(m.slip().norm() < tiny);
    }
  }
  CHECK(held > 100);
  CHECK(slid > 100);
}

TEST_CASE("08: scaled back, friction is opposite to K^-1 u instead, and the pyramid's is along its corners") {
  Random random(2);
  Real scaled_back_off = 0, pyramid_off = 0;
  int slid = 0;
  for (int i = 0; i < 1000; ++i) {
    Meeting m(random);
    Meeting other = m;
    Solver<Clamping, FrictionScaledBack> scaled_back;
    scaled_back.solve(m.world, h, 5000);
    Solver<Clamping, Friction> pyramid;
    pyramid.solve(other.world, h, 5000);
    if (!m.at_the_bound() || m.slip().norm() < Real(0.1)) continue;
    ++slid;
    const Rows& rows = scaled_back.rows();
    const TangentBlock k(rows[1], rows[2]);
    const Real u1 = rows[1].speed(), u2 = rows[2].speed();
    const Vec3 solved = (k.k22 * u1 - k.k12 * u2) * rows[1].n + (k.k11 * u2 - k.k12 * u1) * rows[2].n;
    CHECK(direction_error(solved, m.friction()) < 60 * tiny);
    scaled_back_off = std::max(scaled_back_off, direction_error(m.slip(), m.friction()));
    if (other.slip().norm() > Real(0.1))
      pyramid_off = std::max(pyramid_off, direction_error(other.slip(), other.friction()));
  }
  CHECK(slid > 100);
  CHECK(scaled_back_off > 30);
  CHECK(pyramid_off > 40);
}

TEST_CASE("08: the step is 1 / the larger eigenvalue of the tangents' block") {
  Random random(3);
  for (int i = 0; i < 200; ++i) {
    Meeting m(random);
    const auto [tangent1, tangent2] = tangents_of(m.contact().normal);
    const Row one(m.world, m.contact(), tangent1, 0), two(m.world, m.contact(), tangent2, 0);
    Eigen::Matrix<Real, 3, 2> t;
    t << tangent1, tangent2;
    const Eigen::Matrix<Real, 2, 2> k = t.transpose() * m.k() * t;
    const TangentBlock block(one, two);
    const Real scale = tiny * k.norm();
    CHECK(std::abs(block.k11 - k(0, 0)) < scale);
    CHECK(std::abs(block.k12 - k(0, 1)) < scale);
    CHECK(std::abs(block.k22 - k(1, 1)) < scale);
    const Real larger = block.larger_eigenvalue();  // a root of the characteristic polynomial, above the mean of both
    CHECK(std::abs((k(0, 0) - larger) * (k(1, 1) - larger) - k(0, 1) * k(1, 0)) < scale * k.norm());
    CHECK(2 * larger >= k.trace() - scale);
  }
}

TEST_CASE("08: a sweep never adds energy, nor slip where friction may hold") {
  Random random(4);
  for (int i = 0; i < 300; ++i) {
    Meeting m(random);
    const bool may_hold = random.below(2) == 0;
    Rows rows{{m.world, m.contact(), m.contact().normal, 0}};
    StepContext step{m.world, m.world.contacts, rows, h};
    rows[0].impulse = may_hold ? Real(1e6) : random.over_decades(Real(0.01), 100);  // a bound that stays
    FrictionCone cone;
    cone.build(step);
    Real energy = kinetic_energy(m.world), slip = m.slip().norm();
    const Real rounding = 100 * eps * energy;
    for (int sweep = 0; sweep < 30; ++sweep) {
      cone.sweep(step);
      INFO("meeting " << i << ", sweep " << sweep);
      CHECK(kinetic_energy(m.world) <= energy + rounding);
      if (may_hold) CHECK(m.slip().norm() <= slip * (1 + 100 * eps) + 1000 * eps);
      energy = kinetic_energy(m.world);
      slip = m.slip().norm();
    }
  }
}

TEST_CASE("08: the slower direction of a foot that is to be held keeps 1 - k_min / k_max of its slip per sweep") {
  for (const Real direction : {Real(0), pi / 2}) {  // the block's own axes: where the stick leans, and across
    Stick stick(direction);
    Rows rows{{stick.world, stick.contact(), stick.contact().normal, 0}};
    StepContext step{stick.world, stick.world.contacts, rows, h};
    rows[0].impulse = Real(1e6);
    FrictionCone cone;
    cone.build(step);
    const TangentBlock k(rows[1], rows[2]);
    const Real own = 1 / Row(stick.world, stick.contact(), way_of_heading(direction), 0).effective_mass;
    const Real kept = 1 - own / k.larger_eigenvalue();
    Real slip = stick.slip().norm();
    for (int sweep = 0; sweep < 5; ++sweep) {
      cone.sweep(step);
      CHECK(std::abs(stick.slip().norm() - kept * slip) < 100 * eps * Push{}.v0);
      slip = stick.slip().norm();
    }
  }
}

TEST_CASE("08: after every sweep friction is within its disc, in a heap and with contacts that are lost") {
  Random random(5);
  World world;
  world.add(ground().rough(1));
  for (int i = 0; i < 40; ++i) {
    const Real mass = random.over_decades(1, 100);
    Body body = random.body(mass);
    Vec3 place = random.vector(1);
    place.y() = 1 + static_cast<Real>(i) * Real(0.4);
    world.add(body.at(place).moving(random.vector(3)).spinning(random.vector(3)).rough(random.between(0, 1)));
  }
  Solver<Clamping, Baumgarte, Slop, Restitution, FrictionCone, WarmStart, DiscSpy> solver;
  for (int step = 0; step < 240; ++step) world.step(solver, h, 10);
  CHECK(solver.worst <= 4 * eps);
  CHECK(solver.at_edge > 1000);
}

TEST_CASE("08: under any heading a box stops where it should, however it lies") {
  Random random(6);
  for (int i = 0; i < 60; ++i) {
    const Real heading = random.between(0, 2 * pi), turn = random.between(0, 2 * pi);
    const Real x = random.between(Real(0.1), Real(0.5)), z = random.between(Real(0.1), Real(0.5));
    const Real y = std::min(x, z) * random.between(Real(0.2), Real(0.9));  // low enough not to topple
    World world;
    world.add(ground().rough(1));
    world.add(box({x, y, z}, 20)
                  .turned(turn, Vec3::UnitY())
                  .at({0, y - Real(1e-5), 0})
                  .moving(Push{}.v0 * way_of_heading(heading))
                  .rough(own_friction(Push{}.mu)));
    With<FrictionCone> solver;
    for (int step = 0; step < 90; ++step) world.step(solver, h, 10);
    const Vec3 way = way_of_heading(heading), moved = world.bodies[1].position;
    INFO("heading " << heading << ", turned by " << turn << ", half extents " << x << " " << y << " " << z);
    CHECK(moved.dot(way) == Approx(Push{}.stopping_distance(h)).epsilon(0.001));
    CHECK(std::abs(moved.dot(Vec3::UnitY().cross(way))) < Real(0.001));
    CHECK(world.bodies[1].velocity.norm() < Real(1e-3));
  }
}

TEST_CASE("08: turning everything about the normal turns what happens, and the pyramid's tangents do not turn along") {
  CHECK(largest_change_by_turning<With<FrictionCone>>() < tiny);
  CHECK(largest_change_by_turning<With<FrictionScaledBack>>() < tiny);
  CHECK(largest_change_by_turning<FullSolver>() > Real(0.3));
}

TEST_CASE("08: with mu = 0 nothing is rubbed, to the bit, and with a huge mu nothing slips") {
  Random random(7);
  for (int i = 0; i < 100; ++i) {
    for (const Real mu_of_pair : {Real(0), Real(1e9)}) {
      Meeting m(random);
      if (!m.can_be_held()) continue;
      m.world.contacts[0].friction = mu_of_pair;
      Meeting bare = m;
      Solver<Clamping, FrictionCone> solver;
      solver.solve(m.world, h, mu_of_pair > 0 ? 50000 : 10);
      Solver<Clamping> without;
      without.solve(bare.world, h, 10);
      INFO("meeting " << i << ", mu " << mu_of_pair);
      if (mu_of_pair > 0) CHECK(m.slip().norm() < tiny);
      else CHECK(hash_of(m.world) == hash_of(bare.world));
    }
  }
}

TEST_CASE("08: a ball thrown under any heading rolls on straight at 5/7 of its speed") {
  for (int i = 0; i < 16; ++i) {
    const Vec3 way = way_of_heading(pi / 8 * static_cast<Real>(i) + Real(0.1));
    World world;
    world.add(ground().rough(1));
    world.add(sphere(Real(0.3), 10).at({0, Real(0.3), 0}).moving(Push{}.v0 * way).rough(own_friction(Push{}.mu)));
    With<FrictionCone> solver;
    for (int step = 0; step < 90; ++step) world.step(solver, h, 1);
    CHECK(world.bodies[1].velocity.dot(way) == Approx(Push{}.v0 * 5 / 7).epsilon(1e-5));
    CHECK(std::abs(world.bodies[1].position.dot(Vec3::UnitY().cross(way))) < 100 * tiny);
  }
}
