/// Chapter 24: contacts in both stages.
#include "pushback/chapters/24_half_step/study.h"
#include "pushback/common/world/forces.h"
#include "pushback/common/world/situations.h"
#include "tests/24_half_step/order.h"
#include "tests/support/catch.h"
#include "tests/support/complaint.h"

using namespace pushback;
using namespace pushback::half_step_scenes;

namespace {

/// The largest error of a motion of chapter 19, m.
Real error_of_contacts(const std::string& name, int substeps) {
  const Motion& motion = motion_named(name);
  return largest_error(motion, motion.truth(motion.frames()), in_substeps(substeps));
}

}  // namespace

TEST_CASE("half step: slides down a slope exactly, rolls to micrometres, and stops, off by at most mu g h^2 / 8") {
  CHECK(error_of_contacts("incline", 1) < (in_double ? 1e-10 : 1e-3));
  CHECK(error_of_contacts("rolling", 1) < (in_double ? 1.1e-6 : 1e-3));
  CHECK(error_of_contacts("sliding", 1) < 1.7e-4);
  if (!in_double) return;
  for (const int substeps : {1, 2, 4, 8, 16}) {
    const double step = 1.0 / (60 * substeps);
    CHECK(error_of_contacts("sliding", substeps) < 0.5 * 9.81 * step * step / 8);
  }
}

TEST_CASE("half step: the page's three lines") {
  World world;
  world.add(sphere(1, 1).at({0, 5, 0}));
  HalfStep solver;
  solver.substeps = 4;
  world.step(solver, 1.0 / 60);
  CHECK(world.bodies[0].position.y() == Approx(5 - g * h * h / 2).epsilon(1e-6));
}

TEST_CASE("half step: a ball slides down from a smooth ball, keeps its energy, and leaves it at 2/3 of the height") {
  // It leaves where gravity no longer turns it: m v^2 / R = m g cos,  v^2 = 2 g R (cos_0 - cos)
  constexpr Real apart = Real(1.5), start = Real(0.3);
  World world;
  world.add(sphere(1, 1).fixed().rough(0));
  world.add(sphere(Real(0.5), 1).at({apart * std::sin(start), apart * std::cos(start), 0}).rough(0));
  HalfStep step;
  const Real begin = energy(world);
  const Real leaves = apart * std::cos(start) * 2 / 3;
  Real left = 0;
  while (left == 0 && world.time < 2) {
    world.step(step, h / 16);
    const Vec3& place = world.bodies[1].position;
    CHECK(std::abs(energy(world) - begin) < Real(2e-3));
    if (world.contacts.empty() || world.contacts[0].impulse.isZero(0)) left = place.y();
    if (place.y() > leaves + Real(0.1))
      CHECK(std::abs(world.bodies[1].velocity.dot(place.normalized())) < 100 * rounding);
  }
  CHECK(left == Approx(leaves).epsilon(0.03));
}

// Where a contact ends, no force jumps. Cut at impacts, the ball comes off its support by h^2 v^2 / (2 R), and meets it again.
TEST_CASE("half step: of second order where a body leaves its support, of first if it is cut at impacts") {
  if (!in_double) return;
  const auto places = [](const HalfStep& kind, int substeps) {
    std::vector<Vec3> all;
    for (Real start = Real(0.3); start < Real(0.319); start += Real(0.0025)) {  // rad
      World world;
      world.add(sphere(1, 1).fixed().rough(0));
      world.add(sphere(Real(0.5), 1).at(Real(1.5) * Vec3(std::sin(start), std::cos(start), 0)).rough(0));
      HalfStep step = exact(substeps, kind);
      for (int i = 0; i < 57; ++i) world.step(step, h);
      all.push_back(world.bodies[1].position);
    }
    return all;
  };
  const std::vector<Vec3> fine = places({}, 256);
  const auto error = [&](const HalfStep& kind, int substeps) { return largest_distance(places(kind, substeps), fine); };
  CHECK(error({}, 1) == Approx(0.0022).epsilon(0.05));            // the page says so
  CHECK(error(at_impacts(), 1) == Approx(0.0112).epsilon(0.05));  // chapter 25's page says so
  CHECK(order({1, 2, 4, 8, 16}, [&](int n) { return error({}, n); }) == Approx(2).margin(0.1));
  CHECK(order({1, 4, 16, 64}, [&](int n) { return error(at_impacts(), n); }) == Approx(1).margin(0.25));
}

// x'' = -w^2 x - mu g sgn(x'): half a swing about each of +-mu g / w^2 in turn. The phase within a step is what decides, so of eight.
TEST_CASE("half step: of first order where the slip of a box on a spring reverses") {
  if (!in_double) return;
  const auto error = [](int substeps) {
    constexpr Real w = 5, mu = Real(0.1);
    Real largest = 0;
    for (int start = 0; start < 8; ++start) {
      World world;
      Real from = 1 + Real(0.004) * static_cast<Real>(start), since = 0;
      world.add(ground().rough(mu));
      world.add(box(Vec3::Constant(Real(0.25)), 1).at({from, Real(0.25), 0}).rough(mu));
      world.forces.push_back(spring(1, {0, Real(0.25), 0}, w * w));
      HalfStep step = exact(substeps);
      for (int i = 0; i < 150; ++i) {
        world.step(step, h);
        since += h;
        const Real centre = std::copysign(mu * g / (w * w), from);
        if (since > pi / w) from = 2 * centre - from, since -= pi / w;
        const Real about = std::copysign(centre, from);
        largest =
            std::max(largest, std::abs(world.bodies[1].position.x() - about - (from - about) * std::cos(w * since)));
      }
    }
    return largest;
  };
  CHECK(error(1) == Approx(0.0019).epsilon(0.1));  // the page says so
  CHECK(order({1, 4, 16, 64}, error) == Approx(1).margin(0.25));
}

TEST_CASE("half step: solved exactly, stacks rest where they began") {
  for (const int boxes : {1, 2, 5, 10}) {
    CAPTURE(boxes);
    World world;
    stack(world, boxes);
    const World begin = world;
    HalfStep step;
    for (int i = 0; i < 300; ++i) world.step(step, h);
    for (std::size_t i = 0; i < world.bodies.size(); ++i)
      CHECK((world.bodies[i].position - begin.bodies[i].position).norm() < (in_double ? Real(1e-11) : Real(1e-3)));
  }
  CHECK(error_of_contacts("heavy-on-light", 1) < (in_double ? 1e-11 : 1e-3));
}

TEST_CASE("half step: what rests is seen to rest, and nothing is solved") {
  for (const std::string name : {"stack-10", "pyramid-10"}) {
    CAPTURE(name);
    World world;
    motion_named(name).begin(world);
    HalfStep step;
    world.step(step, h);
    CHECK(step.rounds() > 0);
    int solved = 0;
    for (int i = 0; i < 300; ++i) {
      world.step(step, h);
      solved += step.rounds() > 0 ? 1 : 0;
    }
    if (in_double) CHECK(solved <= (name == "stack-10" ? 0 : 45));  // of a pyramid's steps, what rounding leaves grows
    world.bodies[2].velocity = {0, 1, 0};
    world.step(step, h);
    CHECK(step.rounds() > 0);
  }
}

TEST_CASE("half step: a resting contact bears half of the weight in each stage, and says so") {
  World world;
  world.add(ground());
  world.add(box(Vec3::Constant(Real(0.5)), 10).at({0, Real(0.5), 0}));
  HalfStep step;
  for (const int substeps : {1, 4}) {
    step.substeps = substeps;
    for (int i = 0; i < 10; ++i) world.step(step, h);
    Real sum = 0;
    for (const Contact& contact : world.contacts) sum += contact.impulse.y();
    CHECK(world.contacts.size() == 4);
    CHECK(sum == Approx(10 * g * h).epsilon(in_double ? 1e-9 : 1e-3));
    for (const Contact& contact : world.contacts) CHECK(contact.state == ContactState::sticking);
    CHECK(step.stats().rows == 12);
  }
}

TEST_CASE("half step: friction stays in the cone, whichever way the box slides") {
  for (const Real heading : {Real(0), Real(0.3), pi / 4, Real(2)}) {
    World world;
    world.add(ground().rough(Real(0.5)));
    const Vec3 ahead(std::cos(heading), 0, std::sin(heading));
    world.add(box({Real(0.5), Real(0.2), Real(0.5)}, 3).at({0, Real(0.2), 0}).moving(4 * ahead).rough(Real(0.5)));
    HalfStep step;
    for (int i = 0; i < 30; ++i) {
      world.step(step, h);
      Vec3 sum = Vec3::Zero();
      for (const Contact& contact : world.contacts) {
        const Vec3 aside = contact.impulse - contact.impulse.y() * Vec3::UnitY();
        CHECK(aside.norm() <= (Real(0.5) + 1000 * rounding) * contact.impulse.y() + rounding);
        CHECK(contact.state == ContactState::sliding);
        sum += contact.impulse;
      }
      CHECK((sum / (3 * h) - g * (Vec3::UnitY() - Real(0.5) * ahead)).norm() < 1000 * rounding);
    }
    CHECK((world.bodies[1].velocity - (4 - Real(0.5) * g / 2) * ahead).norm() < 1000 * rounding);
  }
}

TEST_CASE("half step: a ball bounces with e times its speed, and when it does is of first order") {
  const auto apex = [](int substeps) {
    World world;
    world.add(ground());
    world.add(sphere(Real(0.5), 2).at({0, Real(1.5), 0}).bouncy(Real(0.8)));
    HalfStep step;
    step.substeps = substeps;
    Real before = -1, highest = 0;
    for (int i = 0; i < 55; ++i) {
      world.step(step, h);
      const Real v = world.bodies[1].velocity.y();
      if (before < 0 && v > 0) CHECK(v <= Real(0.8) * std::sqrt(2 * g * (1 + Real(0.3) / static_cast<Real>(substeps))));
      before = v;
      if (i > 30) highest = std::max(highest, world.bodies[1].position.y() - Real(0.5));
    }
    return highest;
  };
  for (const int substeps : {1, 4, 16, 64})
    CHECK(std::abs(apex(substeps) - Real(0.64)) < Real(0.13) / static_cast<Real>(substeps));
  World slow;  // below the threshold nothing bounces
  slow.add(ground());
  slow.add(sphere(Real(0.5), 2).at({0, Real(0.5), 0}).bouncy(1).moving({0, Real(-0.05), 0}));
  HalfStep step;
  slow.step(step, h);
  CHECK(slow.bodies[1].velocity.norm() < rounding);
}

TEST_CASE("half step: what meets as a substep ends, to rounding, bounces as well") {
  for (const Real gap : {Real(0.2), Real(0.25), Real(0.3)}) {  // 4, 5 and 6 steps of 1/60 s
    for (const int substeps : {1, 2, 3, 5, 8, 16, 32, 128}) {
      World world;
      world.gravity.setZero();
      world.add(sphere(Real(0.1), 1).bouncy(Real(0.9)).moving({3, 0, 0}));
      world.add(sphere(Real(0.1), 4).bouncy(Real(0.9)).at({Real(0.2) + gap, 0, 0}));
      HalfStep solver;
      solver.substeps = substeps;
      for (int i = 0; i < 20; ++i) world.step(solver, Real(1) / 60);
      INFO(gap << " m, " << substeps << " substeps");
      CHECK(world.bodies[0].velocity.x() == Approx(-1.56));  // (m1 - e m2) / (m1 + m2) of 3 m/s
      CHECK(world.bodies[1].velocity.x() == Approx(1.14));   // (1 + e) m1 / (m1 + m2)
    }
  }
}

TEST_CASE("half step: what overlaps comes out by a tenth in a hundredth of a second, and gains no speed by it") {
  World world;
  world.add(ground());
  world.add(sphere(Real(0.5), 2).at({0, Real(0.49), 0}));
  HalfStep step;
  Real half_way = 0;
  const auto depth = [&world] { return Real(0.5) - world.bodies[1].position.y(); };
  for (int i = 0; i < 60; ++i) {
    world.step(step, h);
    CHECK(world.bodies[1].velocity.norm() < rounding);
    CHECK(depth() > -10 * rounding);
    if (i == 29) half_way = depth();
  }
  CHECK(depth() == Approx(half_way * std::pow(1 - 10 * h, 30)).margin(10 * rounding));
}

TEST_CASE("half step: what takes more than most_work is refused, at once or soon after, and nothing has changed") {
  World begin;
  pyramid(begin, 6);
  World world = begin;
  HalfStep step;
  world.step(step, h);  // nobody bears anything yet
  const double needed = step.work();
  CHECK(needed > 1e5);
  for (const double part : {0.01, 0.1, 0.5}) {
    for (const bool from_afar : {false, true}) {
      CAPTURE(part, from_afar);
      HalfStep bounded;
      bounded.most_work = part * needed;
      bounded.fall_back_to_full_solve = from_afar;
      world = begin;
      const std::string said = complaint([&] { world.step(bounded, h); });
      // A matrix takes more than an eighth of it. With less, the sweeps before it take all.
      const bool refused_at_once = part == 0.1;
      CHECK(said == (refused_at_once || from_afar
                         ? "144 contacts are too large a problem for the multiplications that are left"
                         : "144 contacts are not solved from the loads of the previous step"));
      CHECK(hash_of(world) == hash_of(begin));
      CHECK(world.time == 0);
      CHECK(bounded.too_large() == refused_at_once);
      if (refused_at_once) {
        CHECK(bounded.work() < needed / 20);
      } else {
        CHECK(bounded.work() > bounded.most_work);
        CHECK(bounded.work() < bounded.most_work + needed / 2);  // what had been begun
      }
    }
  }
  HalfStep enough;
  enough.most_work = needed * 1.001;
  world = begin;
  World other = begin;
  for (int i = 0; i < 3; ++i) world.step(enough, h), other.step(step, h);
  CHECK(hash_of(world) == hash_of(other));
  CHECK(enough.work() == 0);  // each bears what it bore
}
