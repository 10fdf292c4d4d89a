/// Eight pairs at a time: the bits of one at a time, and the same physics as chapter 21's.
#include "pushback/chapters/22_wide/study.h"

#include "pushback/chapters/07_warm_start/full_solver.h"
#include "pushback/chapters/11_substeps/scenes.h"
#include "pushback/chapters/13_joints/study.h"
#include "pushback/chapters/19_accuracy_and_time/motion.h"
#include "pushback/chapters/21_detected_once/study.h"
#include "pushback/common/bodies/random.h"
#include "pushback/common/world/measure.h"
#include "pushback/engine/substeps/wide_solver.h"
#include "pushback/tools/measure/hard_cases/sliding.h"
#include "tests/support/catch.h"
#include "tests/support/yardstick.h"

using namespace pushback;

namespace {

/// Boxes, balls and capsules that fall into a heap, some of them bouncy, one without friction.
void heap(World& world) {
  Random random(5);
  world.add(ground());
  for (int i = 0; i < 60; ++i) {
    const Vec3 place{static_cast<Real>(i % 4) * Real(0.9), Real(0.5) + static_cast<Real>(i / 4) * Real(0.5),
                     static_cast<Real>(i / 2 % 2)};
    Body body = i % 3 == 0   ? box({Real(0.4), Real(0.3), Real(0.45)}, 100)
                : i % 3 == 1 ? sphere(Real(0.3), 20)
                             : capsule(Real(0.2), Real(0.3), 10);
    if (i % 5 == 0) body.bouncy(Real(0.5));
    if (i % 7 == 0) body.rough(0);
    const Vec3 axis = random.direction();
    world.add(body.turned(random.between(0, 3), axis).at(place + random.vector(Real(0.1))));
  }
}

template <class Scalar>
std::uint64_t hash_after(const Passes<Scalar>& passes, const std::function<void(World&)>& fill, int steps) {
  World world;
  fill(world);
  WideSolver<Scalar> solver;
  solver.passes = passes;
  solver.substeps = 8;
  for (int i = 0; i < steps; ++i) world.step(solver, h);
  return hash_of(world);
}

template <class Scalar>
void check_same_bits() {
  const std::function<void(World&)> scenes[] = {heap, [](World& world) { pyramid(world, 5); }};
  for (const auto& fill : scenes) {
    const std::uint64_t one = hash_after(plain_passes<Scalar>(1), fill, 90);
    for (const int lanes : {4, 8}) CHECK(hash_after(plain_passes<Scalar>(lanes), fill, 90) == one);
    for (const int lanes : {1, 4, 8}) CHECK(hash_after(passes_of_this_processor<Scalar>(lanes), fill, 90) == one);
  }
}

}  // namespace

TEST_CASE("wide: one, four and eight lanes give the same bits, on any processor, in float") {
  check_same_bits<float>();
}
TEST_CASE("wide: one, four and eight lanes give the same bits, on any processor, in double") {
  check_same_bits<double>();
}

TEST_CASE("wide: a body under more than 64 others: those beyond are solved one after the other") {
  World movable, fixed;
  for (World* world : {&movable, &fixed})
    for (int i = 0; i < 71; ++i) world->add(i == 0 && world == &fixed ? sphere(1, 1).fixed() : sphere(1, 1));
  std::vector<TouchingPair> pairs;
  for (std::size_t i = 0; i < 70; ++i) pairs.push_back({0, i + 1, i, 1});
  CHECK(colour_pairs(pairs, movable).size() == 70);
  CHECK(colour_pairs(pairs, fixed).size() == 1);
}

TEST_CASE("wide: what rests ends as it does one contact after the other") {
  const auto compare = [](const auto& fill, Real seconds, Real allowed) {
    World once, doubles, floats;
    for (World* world : {&once, &doubles, &floats}) fill(*world);
    DetectedOnce of_once;
    WideSolver<double> of_doubles;
    WideSolver<float> of_floats;
    for (int i = 0; i < static_cast<int>(std::lround(seconds / h)); ++i) {
      once.step(of_once, h);
      doubles.step(of_doubles, h);
      floats.step(of_floats, h);
    }
    for (const World* world : {&doubles, &floats}) {
      for (std::size_t i = 0; i < once.bodies.size(); ++i) {
        INFO((world == &floats ? "float" : "double") << ", body " << i);
        CHECK((once.bodies[i].position - world->bodies[i].position).norm() < allowed);
      }
      CHECK(deepest_overlap(*world) == Approx(deepest_overlap(once)).epsilon(0.02).margin(1e-6));
    }
  };
  compare([](World& world) { stack(world, 10); }, 5, Real(0.2e-3));
  compare([](World& world) { pyramid(world, 8); }, 3, Real(1e-3));
  compare(substeps_scenes::HeavyOnLight{100}, 3, Real(0.2e-3));
  compare([](World& world) { box_on_slope(world, Real(0.35), Real(0.3)); }, 1, Real(0.2e-3));
  compare([](World& world) { box_on_slope(world, Real(0.35), Real(0.5)); }, 1, Real(0.2e-3));
}

TEST_CASE("wide: in float, a stack stands 100 km from the origin as it does there") {
  World near, far;
  stack(near, 10);
  stack(far, 10);
  const Vec3 away(Real(1e5), 0, Real(-1e5));
  for (Body& body : far.bodies)
    if (body.movable()) body.position += away;
  WideSolver<float> of_near, of_far;
  for (int i = 0; i < 300; ++i) {
    near.step(of_near, h);
    far.step(of_far, h);
  }
  for (std::size_t i = 1; i < near.bodies.size(); ++i)
    CHECK((far.bodies[i].position - away - near.bodies[i].position).norm() < (in_double ? Real(1e-5) : Real(0.1)));
}

TEST_CASE("wide: what bounces goes, to rounding, as if it were detected in each substep") {
  World in_each, once;
  for (World* world : {&in_each, &once}) {
    world->add(ground().bouncy(Real(0.7)));
    world->add(sphere(Real(0.5), 10).at({0, 3, 0}).bouncy(Real(0.7)));
    const Body spinning = sphere(Real(0.3), 2).moving({1, 0, 0}).spinning({0, 0, 5}).bouncy(Real(0.9));
    world->add(Body(spinning).at({3, 2, 0}));
    world->add(Body(spinning).at({3, 2, 4}).with_skin(Real(0.05)));
  }
  WideSolver<double> of_each, of_once;
  for (int i = 0; i < 60; ++i) {
    for (int k = 0; k < 32; ++k) in_each.step(of_each, h / 32);
    once.step(of_once, h);
    for (std::size_t k = 0; k < once.bodies.size(); ++k)
      REQUIRE((once.bodies[k].position - in_each.bodies[k].position).norm() < (in_double ? Real(1e-12) : Real(1e-2)));
  }
}

TEST_CASE(
    "wide: ten links that swing a hundredfold mass stretch by less than 0.1 mm in two substeps, and by h^2 in more") {
  const auto stretch = [](int substeps) {
    World world;
    motion_named("chain").begin(world);
    WideSolver<double> solver;
    solver.substeps = substeps;
    Real most = 0;
    for (int step = 0; step < 120; ++step) {
      world.step(solver, h);
      most = std::max(most, joints_scenes::largest_joint_error(world));
    }
    return most;
  };
  Real before = 0;
  for (const int substeps : {2, 4, 8, 16}) {
    const Real now = stretch(substeps);
    INFO(substeps << " substeps: " << 1000 * now << " mm");
    CHECK(now < Real(1e-4));
    if (in_double && before > 0) CHECK(before / now == Approx(4).epsilon(0.1));
    before = now;
  }
}
