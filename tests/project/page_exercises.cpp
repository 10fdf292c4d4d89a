/// The code that the pages give as answers to their exercises, and what the pages say of it.
#include <fmt/format.h>

#include "pushback/chapters/00_naive_impulses/naive.h"
#include "pushback/chapters/02_clamping/clamping.h"
#include "pushback/chapters/03_baumgarte/tuning.h"
#include "pushback/chapters/06_friction/scenes.h"
#include "pushback/chapters/08_friction_cone/friction_cone.h"
#include "pushback/chapters/09_impacts/scenes.h"
#include "pushback/chapters/09_impacts/sequential.h"
#include "pushback/chapters/13_joints/scenes.h"
#include "pushback/chapters/13_joints/study.h"
#include "pushback/chapters/14_joints_under_load/scenes.h"
#include "pushback/chapters/14_joints_under_load/warm_joints.h"
#include "pushback/chapters/15_limits_motors_springs/limits.h"
#include "pushback/engine/direct/direct_joints.h"
#include "pushback/engine/islands/scene_questions.h"
#include "pushback/tools/measure/hard_cases/hard_case.h"
#include "tests/support/catch.h"
#include "tests/support/joint_jacobian.h"
#include "tests/support/yardstick.h"

using namespace pushback;

namespace {

// ---- 00: what pushes bodies apart acts once per pair -------------------------------------------------------------------

inline void push_pairs_apart(World& world) {
  const Contacts& contacts = world.contacts;
  const auto same_pair = [](const Contact& c, const Contact& d) {
    return c.id.body_a == d.id.body_a && c.id.body_b == d.id.body_b;
  };
  for (std::size_t first = 0, end = 0; first < contacts.size(); first = end) {
    std::size_t deepest = first;
    while (end < contacts.size() && same_pair(contacts[end], contacts[first])) {
      if (contacts[end].depth > contacts[deepest].depth) deepest = end;
      ++end;
    }
    push_apart(world, contacts[deepest]);
  }
}

TEST_CASE("exercise 00.3: pushed apart once, a box that lies on four points ends on the ground, not above it") {
  World world;
  world.add(ground());
  world.add(box(Vec3::Constant(Real(0.5)), 100).at({0, Real(0.49), 0}));
  world.find_contacts();
  REQUIRE(world.contacts.size() == 4);
  push_pairs_apart(world);
  CHECK(world.bodies[1].position.y() == Approx(0.5).epsilon(1e-6));
}

// ---- 01: old velocities within a sweep ---------------------------------------------------------------------------------

void sweep_with_old_velocities(Rows& rows) {
  std::vector<Real> wanted;
  for (const Row& row : rows) wanted.push_back(row.wanted());
  for (std::size_t i = 0; i < rows.size(); ++i) rows[i].reach(wanted[i]);
}

TEST_CASE("exercise 01.3: with old velocities, each sweep multiplies the column's speed by -1.6") {
  World world;
  world.add(ground());
  world.add(box({Real(0.25), Real(0.8), Real(0.25)}, 100).at({0, Real(0.79), 0}).moving({0, -4, 0}));
  world.begin_step(h);
  Rows rows;
  for (std::size_t i = 0; i < world.contacts.size(); ++i)
    rows.emplace_back(world, world.contacts[i], world.contacts[i].normal, i);
  std::vector<Real> speeds;
  for (int sweep = 0; sweep < 10; ++sweep) {
    sweep_with_old_velocities(rows);
    speeds.push_back(world.bodies[1].velocity.y());
  }
  CHECK(speeds[0] == Approx(6.7).margin(0.05));
  CHECK(speeds[1] == Approx(-10.8).margin(0.05));
  CHECK(speeds[9] == Approx(-481).margin(0.5));
}

// ---- 02: the column that turns -----------------------------------------------------------------------------------------

TEST_CASE("exercise 02.3: only two of the column's corners push, and the other two leave") {
  World world;
  world.add(ground());
  Body column = box({Real(0.25), Real(0.8), Real(0.25)}, 100).at({0, Real(0.799), 0});
  column.velocity = {0, -1, 0};
  column.angular_velocity = {0, 0, 6};
  world.add(column);
  world.find_contacts();
  Solver<Clamping> solver;
  solver.solve(world, Real(1) / 60, 50);
  for (const Row& row : solver.rows()) fmt::print("{:9.3f} {:9.3f} {}\n", row.impulse, row.speed(), row.error());

  REQUIRE(solver.rows().size() == 4);
  for (const Row& row : solver.rows()) {
    const bool pushes = row.impulse > 0;
    CHECK(row.impulse == Approx(pushes ? 98.7 : 0).margin(0.05));
    CHECK(row.speed() == Approx(pushes ? 0 : 1.947).margin(0.0005));
  }
}

// ---- 03: how a stack trembles, by the number of sweeps -----------------------------------------------------------------

namespace exercise_03 {

using baumgarte_scenes::with_beta;

Real jitter(Real beta, Real dt, int sweeps) {
  World world;
  stack(world, 3);
  auto solver = with_beta<Solver<Clamping, Baumgarte>>(beta);
  Real sum = 0;
  const int steps = static_cast<int>(std::lround(5 / dt)), last = static_cast<int>(std::lround(1 / dt));
  for (int step = 0; step < steps; ++step) {
    world.step(solver, dt, sweeps);
    if (step >= steps - last) sum += 2 * kinetic_energy(world) / (3 * 100);
  }
  return std::sqrt(sum / static_cast<Real>(last));
}

}  // namespace exercise_03

TEST_CASE("exercise 03.3: it is the jitter that the tuning asks for") {
  using baumgarte_scenes::jitter_of_stack, baumgarte_scenes::with_beta;
  const auto solver = with_beta<Solver<Clamping, Baumgarte>>(Real(0.4));
  for (const int sweeps : {5, 30})
    CHECK(exercise_03::jitter(Real(0.4), h, sweeps) == jitter_of_stack(3, solver, 5, h, sweeps));
}

// ---- 04: a dead zone ---------------------------------------------------------------------------------------------------

struct DeadZone : Effect {
  Real slop = Real(0.005);
  void adjust_separation(StepContext& step) {
    for (std::size_t i = 0; i < step.contacts.size(); ++i) {
      if (step.rows[i].separation > -slop) step.rows[i].separation = 0;
    }
  }
};

TEST_CASE("exercise 04.3: behind a dead zone the depth stops at the first d0 0.8^k below the slop") {
  for (const auto& [start, end] : {std::pair(Real(0.010), Real(0.004096)), std::pair(Real(0.012), Real(0.00491520))}) {
    World world;
    world.add(ground());
    world.add(sphere(Real(0.5), 100).at({0, Real(0.5) - start, 0}));
    Solver<Clamping, Baumgarte, DeadZone> solver;
    for (int step = 0; step < 60; ++step) world.step(solver, h);
    CHECK(Real(0.5) - world.bodies[1].position.y() == Approx(end).margin(1e-6));
  }
}

// ---- 06: the cone, by one step for both tangents -----------------------------------------------------------------------

namespace exercise_06 {

struct FrictionCone : Friction {
  void sweep(StepContext& step) {
    for (std::size_t i = 0; i < mu_.size(); ++i) {
      Row &t1 = step.rows[first_ + 2 * i], &t2 = step.rows[first_ + 2 * i + 1];
      const Real bound = mu_[i] * step.rows[t1.owner].impulse;
      const Real mass = std::min(t1.effective_mass, t2.effective_mass);  // first try: each its own
      const Real wanted1 = t1.impulse - mass * t1.speed(), wanted2 = t2.impulse - mass * t2.speed();
      const Real size = std::hypot(wanted1, wanted2), scale = size > bound ? bound / size : 1;
      t1.lo = t2.lo = -bound;
      t1.hi = t2.hi = bound;
      t1.reach(scale * wanted1);
      t2.reach(scale * wanted2);
    }
  }
};

}  // namespace exercise_06

// ---- 08: a cheaper step ------------------------------------------------------------------------------------------------

struct SimpleStep : FrictionCone {
  std::vector<Real> sizes;
  void build(StepContext& step) {
    Friction::build(step);
    const Rows& rows = step.rows;
    sizes.clear();
    for (std::size_t i = 0; i < mu_.size(); ++i)
      sizes.push_back(std::min(rows[first_ + 2 * i].effective_mass, rows[first_ + 2 * i + 1].effective_mass));
  }
  void sweep(StepContext& step) {
    Rows& rows = step.rows;
    for (std::size_t i = 0; i < mu_.size(); ++i) {
      Row &one = rows[first_ + 2 * i], &two = rows[first_ + 2 * i + 1];
      const Real total1 = one.impulse - sizes[i] * one.speed(), total2 = two.impulse - sizes[i] * two.speed();
      reach_in_disc(one, two, total1, total2, mu_[i] * rows[one.owner].impulse);
    }
  }
};

TEMPLATE_TEST_CASE("exercises 06.3 and 08.3: with one step for both tangents a box comes as far in every direction", "",
                   exercise_06::FrictionCone, SimpleStep) {
  for (const Real heading : friction_scenes::three_headings) {
    World world;
    friction_scenes::slide(world, {heading});
    Solver<Clamping, Baumgarte, Slop, TestType> solver;
    for (int step = 0; step < 90; ++step) world.step(solver, h);
    const Vec3 way = world.bodies[1].position - friction_scenes::start_of(heading);
    CHECK(std::hypot(way.x(), way.z()) == Approx(2.507).margin(0.0005));
  }
}

// ---- 07: only the normals are remembered -------------------------------------------------------------------------------

struct NormalsOnly : WarmStart {
  void start(StepContext& step) {
    for (std::size_t i = 0; i < first_guess_.size(); ++i) {
      Row& normal = step.rows[i];
      normal.reach(first_guess_[i].dot(normal.n));
    }
  }
};

TEST_CASE("exercise 07.3: before the first sweep the normals carry the box, and the tangents nothing") {
  World world;
  incline(world, Real(0.3), 1);
  world.add(box(Vec3::Constant(Real(0.5)), 100)
                .turned(Real(0.3), Vec3::UnitZ())
                .at(Real(0.499) * Vec3(-std::sin(Real(0.3)), std::cos(Real(0.3)), 0))
                .rough(1));
  Solver<Clamping, Baumgarte, Slop, Friction, NormalsOnly> solver;
  for (int step = 0; step < 60; ++step) world.step(solver, h);
  world.step(solver, h, 0);
  Real normals = 0;
  for (const Row& row : solver.rows()) {
    if (&row - solver.rows().data() < std::ssize(world.contacts)) normals += row.impulse;
    else CHECK(row.impulse == 0);
  }
  CHECK(normals == Approx(100 * g * h * std::cos(Real(0.3))).epsilon(0.01));
}

// ---- 09: the fastest first ---------------------------------------------------------------------------------------------

struct FastestFirst : SequentialImpacts {
  void start(StepContext& step) {
    for (int impact = 0; impact < most_rounds; ++impact) {
      const Bouncing* fastest = nullptr;
      Real speed = -threshold;
      for (const Bouncing& at : bouncing_) {
        const Real approach = step.rows[at.row].speed() - at.by_forces;
        if (approach < speed) {
          fastest = &at;
          speed = approach;
        }
      }
      if (fastest == nullptr) return;
      Row& row = step.rows[fastest->row];
      row.reach(row.impulse - row.effective_mass * (1 + fastest->restitution) * speed);
      row.lo = row.impulse;
    }
  }
};

TEST_CASE("exercise 09.1: the fastest first, four impacts send off the last of five balls") {
  World world;
  impacts_scenes::five_in_a_row(0)(world);
  Solver<Clamping, FastestFirst> three, four;
  three.most_rounds = 3;
  while (world.contacts.size() < 4 || world.bodies[0].velocity.x() > 3) {
    const World before = world;
    world.step(four, h, 0);
    REQUIRE(world.time < 1);
    if (world.bodies[4].velocity.x() == 0) continue;
    World stopped_early = before;
    stopped_early.step(three, h, 0);
    CHECK(stopped_early.bodies[4].velocity.x() == 0);
  }
  for (std::size_t ball = 0; ball < 5; ++ball)
    CHECK(world.bodies[ball].velocity.x() == Approx(ball == 4 ? 4 : 0).margin(1e-6));
}

// ---- 13: a slider ------------------------------------------------------------------------------------------------------

Joint slider(const World& world, int a, int b, const Vec3& point, const Vec3& line) {
  check_joined(world, "a slider", a, b);
  const Body& carrier = body_of(world, a);
  const Vec3 on_a = point_on(carrier, point), on_b = point_on(body_of(world, b), point);
  const Tangents across = tangents_of(line.normalized());
  const Quat to_a = carrier.orientation.conjugate();
  const Vec3 t1 = to_a * across.tangent1, t2 = to_a * across.tangent2;
  const auto ask = [=](const Body& first, const Body& second, const TimeStep&, Equations& equations) {
    const Vec3 p_a = point_of(first, on_a), p_b = point_of(second, on_b);
    for (const Vec3& t : {t1, t2}) {
      const Vec3 n = first.orientation * t;
      equations.push_back({.jacobian = Jacobian::along(n, first, second, p_b), .error = n.dot(p_b - p_a)});
    }
  };
  return {"a slider", a, b, ask};
}

TEST_CASE("exercise 13.3: the slider's Jacobian is the derivative of its error, also off the line") {
  World world;
  world.add(box({1, Real(0.1), Real(0.2)}, 10).at({1, 2, 3}).moving({1, -2, Real(0.5)}).spinning({Real(0.3), -1, 2}));
  world.add(box({Real(0.3), Real(0.4), Real(0.2)}, 5).at({2, 2, 3}).moving({-1, 3, 1}).spinning({2, 1, Real(-0.7)}));
  const Joint joint = slider(world, 0, 1, {Real(1.5), Real(2.1), 3}, {1, 1, Real(0.2)});
  world.bodies[1].position += Vec3(Real(0.2), Real(-0.1), Real(0.3));
  const Body &a = world.bodies[0], &b = world.bodies[1];
  const Real t = in_double ? Real(1e-5) : Real(1e-2);
  const Equations now = asked_by(joint, a, b), before = asked_by(joint, drifted(a, -t), drifted(b, -t)),
                  after = asked_by(joint, drifted(a, t), drifted(b, t));
  REQUIRE(now.size() == 2);
  for (std::size_t i = 0; i < 2; ++i)
    CHECK((after[i].error - before[i].error) / (2 * t) ==
          Approx(rate_of(now[i], a, b)).epsilon(in_double ? 1e-6 : 1e-2));
}

// ---- 14: one more joint ------------------------------------------------------------------------------------------------

TEST_CASE("exercise 14.3: held from the hook, the chain with its weight does not stretch") {
  using joints_under_load_scenes::ChainWithWeight;
  World world;
  ChainWithWeight chain;
  chain(world);
  world.joints.push_back(distance(world, the_world, Vec3::Zero(), chain.links, {0, -3, 0}));

  auto solver = joints_scenes::with_joint_beta<Solver<WarmJoints>>(Real(0.2));
  for (int step = 0; step < 600; ++step) world.step(solver, h);
  CHECK(std::abs(chain.stretch(world)) < (in_double ? Real(1e-12) : Real(1e-4)));
}

// ---- 15: a rope --------------------------------------------------------------------------------------------------------

Joint rope(const World& world, int a, const Vec3& point_a, int b, const Vec3& point_b, Real length) {
  Joint joint = distance(world, a, point_a, b, point_b, length);
  joint.name = "a rope";
  joint.ask = [ask = joint.ask](const Body& first, const Body& second, const TimeStep& now, Equations& equations) {
    ask(first, second, now, equations);
    Equation row = equations.back();
    const Real left = -row.error;  // C = L - |P_B - P_A|
    const auto [n, ra_n, rb_n] = row.jacobian;
    row.jacobian = {-n, -ra_n, -rb_n};
    row.error = 0;
    equations.back() = at_least_zero(row, left, now.dt);
  };
  return joint;
}

TEST_CASE("exercise 15.3: the rope pulls from step 24 on, and is never longer than 1.0062 m") {
  World world;
  const Vec3 at(Real(0.6), 0, 0);
  const int ball = world.add(sphere(Real(0.1), 2).at(at));
  world.joints = {rope(world, the_world, Vec3::Zero(), ball, at, 1)};
  Solver<Joints> solver;
  int first = 0;
  Real longest = 0;
  for (int step = 1; step <= 600; ++step) {
    world.step(solver, h);
    CHECK(solver.joint_rows().back().impulse >= 0);
    if (first == 0 && solver.joint_rows().back().impulse > 0) first = step;
    longest = std::max(longest, world.bodies[0].position.norm());
  }
  CHECK(first == 24);
  CHECK(longest == Approx(1.0062).margin(0.00005));
}

// ---- 18: where DirectJoints stands -------------------------------------------------------------------------------------

using Hanging = Solver<DirectJoints>;                                                   // one sweep is all
using Touching = Solver<Clamping, Baumgarte, Slop, Friction, WarmStart, DirectJoints>;  // last: the last word

static_assert(std::derived_from<Hanging, SupportsJoints> && std::derived_from<Touching, SupportsJoints>);

// ---- 20: a question more -----------------------------------------------------------------------------------------------

/// Is there gravity?
struct NeedsGravity {
  static constexpr const char* name = "gravity";
  static Answer in(const World& world) {
    if (world.gravity.isZero(0)) return {false, "gravity is 0"};
    return {true, fmt::format("{:.3g} m/s^2", world.gravity.norm())};
  }
};

TEST_CASE("exercise 20.3: a scene says whether it has gravity") {
  World world;
  CHECK(NeedsGravity::in(world).yes);
  CHECK(std::string(NeedsGravity::name) == "gravity");
  world.gravity.setZero();
  CHECK_FALSE(NeedsGravity::in(world).yes);
}

// ---- docs/hard_cases.md: a case more -----------------------------------------------------------------------------------

const friction_scenes::Push push{.v0 = 3, .mu = Real(0.5)};
const Real expected = friction_scenes::start + push.stopping_distance(h);  // m, from the origin

HardCase box_slides() {
  const auto fill = [](World& world) { friction_scenes::slide(world, {0}, push); };
  HardCase c;
  c.name = "box-slides";
  c.title = "a sliding box stops";
  c.stresses = "friction opposes the motion, and then holds";
  c.criteria = {{"error of the stopping distance", "%", Real(0.1)}};
  c.scene = {.name = c.title, .fill = fill, .camera = {{6, 4, 8}, {2, 0, 0}}, .seconds = 3};
  c.run = [fill](Trial& trial) -> std::vector<Real> {
    Play play = trial.play(fill, Allowance{.overlap = Real(0.01)});
    play.run(3);
    return {100 * std::abs(play.world.bodies[1].position.x() / expected - 1)};
  };
  return c;
}

TEST_CASE("docs/hard_cases.md: the case that it adds passes with friction, and fails without") {
  const HardCase c = box_slides();
  Trial rubbed(stage_named("06 friction")), smooth(stage_named("05 restitution"));
  CHECK(c.run(rubbed)[0] <= c.criteria[0].limit);
  CHECK(c.run(smooth)[0] > c.criteria[0].limit);
}

}  // namespace
