/// Contacts that ride: n, arms and C of bodies that have moved since they were detected, against detecting them again.
#include "pushback/chapters/13_joints/ball_and_socket.h"
#include "pushback/chapters/19_accuracy_and_time/motion.h"
#include "pushback/chapters/21_detected_once/detected_once.h"
#include "pushback/chapters/21_detected_once/scenes.h"
#include "pushback/common/bodies/random.h"
#include "pushback/common/collision/collide.h"
#include "pushback/common/world/measure.h"
#include "pushback/common/world/situations.h"
#include "pushback/engine/substeps/normal_source.h"
#include "pushback/engine/substeps/rebuild_rows.h"
#include "pushback/engine/substeps/wide_solver.h"
#include "tests/support/catch.h"
#include "tests/support/yardstick.h"

using namespace pushback;

namespace {

constexpr Real exactly = in_double ? Real(1e-13) : Real(2e-6);

using One = LanesOf<Real, 1>;

Vec<One> lanes_of(const Vec3& v) {
  return {One(v.x()), One(v.y()), One(v.z())};
}
Vec3 vector_of(const Vec<One>& v) {
  return {v.x[0], v.y[0], v.z[0]};
}
/// q' = (1, theta/2) q, normalised: the turn that Riding takes it for.
void turn(Body& body, const Vec3& theta) {
  const Vec3 half = theta / 2;
  body.orientation = (Quat(1, half.x(), half.y(), half.z()).normalized() * body.orientation).normalized();
}
WidePoint<Real> point_of(const Contact& contact, const Body& a, const Body& b) {
  WidePoint<Real> point{};
  store(lanes_of(contact.point - a.position), point.arm_a, 0);
  store(lanes_of(contact.point - b.position), point.arm_b, 0);
  point.gap.values[0] = -contact.depth;
  return point;
}

/// The same pair after both have moved: by Riding, and detected anew.
struct Ridden {
  Vec3 n, found_n, point, found_point;  // m: midway between both surfaces
  Real C = 0, found_C = 0;              // m
};
Ridden ride(Body a, Body b, const Contact& contact, NormalSource source, Random& random) {
  const Vec3 way_a = a.movable() ? random.vector(Real(0.02)) : Vec3::Zero(), way_b = random.vector(Real(0.02));
  const Vec3 theta_a = a.movable() ? random.vector(Real(0.1)) : Vec3::Zero(), theta_b = random.vector(Real(0.1));
  const Riding<One> riding{.face_a = One(source == NormalSource::face_a ? 1 : 0) > 0,
                           .face_b = One(source == NormalSource::face_b ? 1 : 0) > 0,
                           .turn_a = turn_by(lanes_of(theta_a)),
                           .turn_b = turn_by(lanes_of(theta_b)),
                           .way = lanes_of(way_b - way_a),
                           .found_n = lanes_of(contact.normal),
                           .radius_a = One(radius_of(a) + a.skin),
                           .radius_b = One(radius_of(b) + b.skin)};
  const WidePoint<Real> as_found = point_of(contact, a, b);
  const auto found = riding.found(as_found, 0);
  const Vec<One> n = rotated(riding.turn_of_normal(found), riding.found_n);
  const auto point = riding.point(found, n);
  a.position += way_a, b.position += way_b;
  turn(a, theta_a), turn(b, theta_b);
  Contacts anew;
  collide(a, b, anew, {.least = Real(0.2)});
  const auto same = std::find_if(anew.begin(), anew.end(), [&](const Contact& c) { return c.id == contact.id; });
  REQUIRE(same != anew.end());
  CHECK((a.position + vector_of(point.arm_a) - b.position - vector_of(point.arm_b)).norm() <
        exactly);  // one point for both
  return {vector_of(n), same->normal, a.position + vector_of(point.arm_a), same->point, point.C[0], -same->depth};
}

/// A pair 1 cm apart, and the contact that it is detected with.
struct Apart {
  Body a, b;
  Contact contact;
  Apart(const Body& first, const Body& second) : a(first), b(second) {
    a.index = 0, b.index = 1;
    a.refresh_inertia(), b.refresh_inertia();
    Contacts found;
    collide(a, b, found, {.least = Real(0.1)});
    REQUIRE(!found.empty());
    contact = *std::max_element(found.begin(), found.end(), [](auto& p, auto& q) { return p.depth < q.depth; });
  }
};

/// As it is detected again to rounding, however the pair has moved.
void check_rides(const Body& first, const Body& second, NormalSource expected) {
  const Apart pair(first, second);
  const NormalSource source = normal_source_of(pair.a, pair.b, pair.contact.normal, 1, 1);
  REQUIRE(source == expected);
  Random random(3);
  for (int i = 0; i < 100; ++i) {
    const Ridden both = ride(pair.a, pair.b, pair.contact, source, random);
    CHECK((both.n - both.found_n).norm() < exactly);
    CHECK(std::abs(both.C - both.found_C) < exactly);
    CHECK((both.point - both.found_point).norm() < exactly);
  }
}

}  // namespace

TEST_CASE("rides: a corner or a round body on a face, and two round bodies, are where they would be detected again") {
  const Body plane = ground(), slab = box({2, Real(0.3), 2}, 50).at({0, -Real(0.3), 0});
  const Body ball = sphere(Real(0.2), 1).at({Real(0.1), Real(0.21), Real(0.3)});
  const Body rod = capsule(Real(0.1), Real(0.3), 1).turned(Real(0.8), {1, 0, 0}).at({0, Real(0.4), 0});
  const Body stone = box({Real(0.2), Real(0.3), Real(0.4)}, 5).turned(Real(0.7), Vec3(1, 2, 3).normalized());
  const auto standing_on = [](Body body, Real gap) {  // on its lowest corner, so far above y = 0
    Contacts found;
    body.at({0, 2, 0}).index = 1;
    Body below = ground();
    below.index = 0;
    collide(below, body, found, {.least = 3});
    Real lowest = 3;
    for (const Contact& contact : found) lowest = std::min(lowest, -contact.depth);
    return body.at({0, 2 - lowest + gap, 0});
  };
  check_rides(plane, ball, NormalSource::face_a);
  check_rides(plane, standing_on(rod, Real(0.05)), NormalSource::face_a);
  check_rides(plane, standing_on(stone, Real(0.05)), NormalSource::face_a);
  check_rides(slab, ball, NormalSource::face_a);
  check_rides(slab, standing_on(stone, Real(0.05)), NormalSource::face_a);
  check_rides(standing_on(stone, Real(0.05)), slab, NormalSource::face_b);
  check_rides(ball, sphere(Real(0.3), 1).at({Real(0.1), Real(0.6), Real(0.6)}), NormalSource::cores);
  for (const auto& [first, second, rides] :
       {std::tuple(plane, ball, NormalSource::face_a),
        {slab, standing_on(stone, Real(0.05)), NormalSource::face_a},
        {ball, sphere(Real(0.3), 1).at({Real(0.1), Real(0.6), Real(0.6)}), NormalSource::cores}})
    check_rides(Body(first).with_skin(Real(0.02)), Body(second).with_skin(Real(0.03)), rides);
}

TEST_CASE("rides: a cube that rolls on its edge, detected once in 32 substeps, goes as one that is detected in each") {
  for (const Real spin : {2, 3}) {
    const auto after = [spin](StepSolver& solver, int detections) {
      World world;
      detected_once_scenes::RollingCube cube;
      cube.spin = spin;
      cube(world);
      for (int i = 0; i < 6 * detections; ++i) world.step(solver, h / static_cast<Real>(detections));
      return world.bodies.back().position;
    };
    WideSolver<Real> exact, once;
    exact.rebuild_fraction = once.rebuild_fraction = 0;
    DetectedOnce carried;
    const Vec3 truth = after(exact, 32);
    const Real riding = (after(once, 1) - truth).norm(), not_riding = (after(carried, 1) - truth).norm();
    INFO("spin " << spin << ": " << 1000 * riding << " mm, carried " << 1000 * not_riding << " mm");
    CHECK(riding < (in_double ? Real(5e-6) : Real(5e-5)));
    CHECK(not_riding > Real(0.5e-3));
    WideSolver<Real> as_it_comes;
    const Real near = (after(as_it_comes, 1) - truth).norm();
    INFO("as it comes " << 1000 * near << " mm");
    CHECK(near < Real(0.01e-3) + (in_double ? 0 : Real(5e-5)));
  }
}

TEST_CASE("rides: fifteen balls that are broken lie where they should, to 4 mm, with one detection in 1/60 s") {
  const Motion& motion = motion_named("break");
  World world;
  motion.fill(world);
  WideSolver<Real> solver;
  solver.threshold = 0;
  const std::vector<Places> truth = motion.truth(motion.frames());
  Real farthest = 0;
  for (const Places& places : truth) {
    world.step(solver, h);
    for (std::size_t i = 0; i < world.bodies.size(); ++i)
      farthest = std::max(farthest, (world.bodies[i].position - places[i].cast<Real>()).norm());
  }
  INFO("off by " << 1000 * farthest << " mm");
  CHECK(farthest < Real(4e-3));  // 74 mm with the normals of detection
}

TEST_CASE(
    "floating: two boxes that meet slower than rows are otherwise placed keep their angular momentum to rounding") {
  World world;
  world.gravity.setZero();
  world.add(box({Real(0.5), Real(0.3), Real(0.2)}, 3).spinning({Real(0.01), 0, Real(0.02)}));
  world.add(box({Real(0.1), Real(0.4), Real(0.6)}, 1)
                .at({Real(0.602), Real(0.1), Real(0.3)})
                .moving({Real(-5e-4), 0, 0})
                .spinning({0, Real(0.01), Real(-0.03)}));
  const Vec3 before = angular_momentum(world);
  WideSolver<Real> solver;
  Real touched = 0;
  for (int i = 0; i < 600; ++i) {
    world.step(solver, h);
    for (const Contact& contact : world.contacts) touched += contact.impulse.norm();
  }
  REQUIRE(touched > Real(1e-4));
  const Real change = (angular_momentum(world) - before).norm();
  INFO("changed by " << change << " N m s of " << before.norm());
  CHECK(change < (in_double ? Real(1e-13) : Real(1e-6)));
}

TEST_CASE("wide: substeps are of 1/60 s, so that contacts are as stiff in a step of any length") {
  const WideSolver<Real> solver;
  CHECK(solver.plan(Real(1) / 60).substeps == 32);
  CHECK(solver.plan(Real(1) / 240).substeps == 8);
  CHECK(solver.plan(Real(1) / 30).substeps == 64);
  CHECK(solver.plan(Real(0.0101)).substeps == 20);
  CHECK(solver.plan(Real(1e-6)).substeps == 1);
  CHECK(solver.plan(std::numeric_limits<Real>::infinity()).substeps == 1000000);
  CHECK(solver.plan(std::numeric_limits<Real>::quiet_NaN()).substeps == 1000000);
  const auto depth_after = [](Real dt) {
    World world;
    stack(world, 3);
    WideSolver<Real> steps;
    while (world.time < 2) world.step(steps, dt);
    Real deepest = 0;
    for (const Contact& contact : world.contacts) deepest = std::max(deepest, contact.depth);
    return deepest;
  };
  const Real depth = depth_after(h);
  for (const Real dt : {Real(1) / 240, Real(0.0101), Real(1) / 30})
    CHECK(depth_after(dt) == Approx(depth).epsilon(in_double ? 1e-3 : 0.05));
}

TEST_CASE("wide: a box that a press lets go of does not jump") {
  World world;
  world.add(ground());
  world.add(box({Real(0.5), Real(0.5), Real(0.5)}, 100).at({0, Real(0.5), 0}));
  world.add(box({1, Real(0.1), 1}, 1).fixed().at({0, Real(1.1), 0}).moving({0, -Real(0.1), 0}));
  WideSolver<Real> solver;
  for (int i = 0; i < 12; ++i) world.step(solver, h);
  CHECK(world.bodies[1].position.y() < Real(0.491));  // 20 mm too little room, shared
  world.bodies[2].velocity = {0, 1, 0};
  Real highest = 0;
  for (int i = 0; i < 60; ++i) {
    world.step(solver, h);
    highest = std::max(highest, world.bodies[1].position.y());
  }
  CHECK(highest < Real(0.501));  // 34 mm above that, if the normals are swept once
}
