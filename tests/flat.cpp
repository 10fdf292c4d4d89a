/// The whole solver of each chapter as a plain loop, and the one composed of effects: the same bits; in chapter 21, which
/// adds in another order, the same to rounding where nothing bounces.
#include <algorithm>
#include <cstring>

#include "pushback/chapters/01_velocity_constraint/flat.h"
#include "pushback/chapters/02_clamping/flat.h"
#include "pushback/chapters/03_baumgarte/flat.h"
#include "pushback/chapters/04_slop/flat.h"
#include "pushback/chapters/05_restitution/flat.h"
#include "pushback/chapters/06_friction/flat.h"
#include "pushback/chapters/07_warm_start/flat.h"
#include "pushback/chapters/07_warm_start/full_solver.h"
#include "pushback/chapters/08_friction_cone/flat.h"
#include "pushback/chapters/08_friction_cone/friction_cone.h"
#include "pushback/chapters/09_impacts/flat.h"
#include "pushback/chapters/09_impacts/simultaneous.h"
#include "pushback/chapters/10_position_correction/flat.h"
#include "pushback/chapters/10_position_correction/split_impulse.h"
#include "pushback/chapters/11_substeps/flat.h"
#include "pushback/chapters/11_substeps/substeps.h"
#include "pushback/chapters/12_soft_contacts/flat.h"
#include "pushback/chapters/12_soft_contacts/flat_a.h"
#include "pushback/chapters/12_soft_contacts/soft_contacts.h"
#include "pushback/chapters/13_joints/distance.h"
#include "pushback/chapters/13_joints/flat.h"
#include "pushback/chapters/13_joints/hinge.h"
#include "pushback/chapters/14_joints_under_load/flat.h"
#include "pushback/chapters/14_joints_under_load/steady_joints.h"
#include "pushback/chapters/21_detected_once/detected_once.h"
#include "pushback/chapters/21_detected_once/flat.h"
#include "pushback/common/bodies/random.h"
#include "pushback/common/world/measure.h"
#include "pushback/tools/catalogue/catalogue.h"
#include "tests/support/catch.h"

using namespace pushback;

namespace {

struct Settings {
  Real beta = Real(0.2), slop = Real(0.005), threshold = Real(0.1);
  Real hertz = 240, damping_ratio = 5, fastest_push_out = 3;
  int substeps = 4, passes = 20;
};

using Stepper = std::function<void(World&, Real dt, int sweeps)>;

/// Steps by this solver, with those of the settings that it has.
template <class ContactSolver>
Stepper by(const Settings& settings) {
  ContactSolver solver;
  if constexpr (requires { solver.beta; }) solver.beta = settings.beta;
  if constexpr (requires { solver.joint_beta; }) solver.joint_beta = settings.beta;
  if constexpr (requires { solver.slop; }) solver.slop = settings.slop;
  if constexpr (requires { solver.threshold; }) solver.threshold = settings.threshold;
  if constexpr (requires { solver.hertz; }) {
    solver.hertz = settings.hertz;
    solver.damping_ratio = settings.damping_ratio;
    solver.fastest_push_out = settings.fastest_push_out;
  }
  if constexpr (requires { solver.passes; }) solver.passes = settings.passes;
  if constexpr (requires { solver.count; }) solver.count = settings.substeps;
  if constexpr (requires { solver.substeps; }) solver.substeps = settings.substeps;
  return [solver](World& world, Real dt, int sweeps) mutable { world.step(solver, dt, sweeps); };
}

using RelaxedSolver = RelaxingSolver<Clamping, SoftContacts, Restitution, FrictionCone, WarmStart>;
struct UnrelaxedSolver : RelaxedSolver {
  void after_move(World&, Real) override {}
};

struct Chapter {
  std::string name, before;  // and the chapter with which its page compares it
  Stepper (*composed)(const Settings&);
  Stepper (*flat)(const Settings&);
};

const Chapter chapters[] = {
    {"01", "", by<Solver<>>, by<flat_01::FlatSolver>},
    {"02", "01", by<Solver<Clamping>>, by<flat_02::FlatSolver>},
    {"03", "02", by<Solver<Clamping, Baumgarte>>, by<flat_03::FlatSolver>},
    {"04", "03", by<Solver<Clamping, Baumgarte, Slop>>, by<flat_04::FlatSolver>},
    {"05", "04", by<Solver<Clamping, Baumgarte, Slop, Restitution>>, by<flat_05::FlatSolver>},
    {"06", "05", by<Solver<Clamping, Baumgarte, Slop, Restitution, Friction>>, by<flat_06::FlatSolver>},
    {"07", "06", by<FullSolver>, by<flat_07::FlatSolver>},
    {"08", "07", by<Solver<Clamping, Baumgarte, Slop, Restitution, FrictionCone, WarmStart>>, by<flat_08::FlatSolver>},
    {"09", "08", by<Solver<Clamping, Baumgarte, Slop, SimultaneousImpacts, FrictionCone, WarmStart>>,
     by<flat_09::FlatSolver>},
    {"10", "08", by<CorrectingSolver<Clamping, SplitImpulse, Slop, Restitution, FrictionCone, WarmStart>>,
     by<flat_10::FlatSolver>},
    {"11", "08", by<Substeps<Solver<Clamping, Baumgarte, Slop, Restitution, FrictionCone, WarmStart>>>,
     by<flat_11::FlatSolver>},
    {"12a", "11", by<Substeps<UnrelaxedSolver>>, by<flat_12a::FlatSolver>},
    {"12", "12a", by<Substeps<RelaxedSolver>>, by<flat_12::FlatSolver>},
    {"13", "12", by<Substeps<RelaxingSolver<Joints, Clamping, SoftContacts, Restitution, FrictionCone, WarmStart>>>,
     by<flat_13::FlatSolver>},
    {"14", "13",
     by<Substeps<RelaxingSolver<SteadyJoints, Clamping, SoftContacts, Restitution, FrictionCone, WarmStart>>>,
     by<flat_14::FlatSolver>},
};

const Chapter& chapter_named(const std::string& name) {
  return *std::ranges::find(chapters, name, &Chapter::name);
}

using Fill = std::function<void(World&)>;

/// Spheres, boxes and capsules, rough and bouncy to various degrees, thrown together.
void pile(World& world) {
  Random random(11);
  world.add(ground().rough(Real(0.7)).bouncy(Real(0.1)));
  for (int i = 0; i < 40; ++i) {
    const Real mass = random.over_decades(1, 100);
    Body body = random.body(mass);
    Vec3 place = random.vector(Real(1.5));
    place.y() = 1 + static_cast<Real>(i) * Real(0.4);
    body.at(place).moving(random.vector(2)).spinning(random.vector(3));
    const Real mu = random.between(0, 1), e = random.between(0, Real(0.6));
    world.add(body.rough(mu).bouncy(e));
  }
}

/// A pile to whose bodies chains of two more hang, and weak rods, every other one soft.
void jointed_pile(World& world) {
  pile(world);
  Random random(12);
  for (int i = 1; i <= 12; ++i) {
    const Vec3 place = world.bodies[static_cast<std::size_t>(3 * i)].position;
    const int first = world.add(random.body(2).at(place + Vec3(0, 1, 0))),
              second = world.add(random.body(3).at(place + Vec3(1, 1, 0)));
    world.joints.push_back(distance(world, 3 * i, place, first, place + Vec3(0, 1, 0)));
    world.joints.push_back(hinge(world, first, second, place + Vec3(Real(0.5), 1, 0), random.vector(1)));
    const auto weak = [i](const Body& a, const Body& b, const TimeStep&, Equations& equations) {
      const Vec3 n = (b.position - a.position).normalized();
      equations.push_back({.jacobian = Jacobian::along(n, a, a.position, b, b.position),
                           .error = (b.position - a.position).norm() - 1,
                           .softness = i % 2 == 0 ? Real(0.01) : 0,
                           .lo = -5,
                           .hi = 8});
    };
    world.joints.push_back({"a weak rod", 3 * i, second, weak});
  }
}

/// The pile, and every scene of the chapters; of those with joints none, where the solver holds none.
std::vector<NamedScene> scenes(bool with_joints) {
  std::vector<NamedScene> all = all_scenes();
  std::erase_if(all, [&](const NamedScene& scene) {
    World world;
    scene.fill(world);
    return !with_joints && !world.joints.empty();
  });
  all.push_back({"pile", pile});
  if (with_joints) all.push_back({"jointed pile", jointed_pile});
  return all;
}

bool same_bits(const Contact& p, const Contact& q) {
  return p.id == q.id && std::memcmp(p.impulse.data(), q.impulse.data(), sizeof(Vec3)) == 0;
}

/// The number of the first step, from 1, after which a bit of a body or of an impulse differs; 0: there is none.
int first_difference(const Fill& fill, Stepper one, Stepper other, int steps, const std::function<Real(int)>& dt_of,
                     const std::function<int(int)>& sweeps_of) {
  World world, same;
  fill(world);
  fill(same);
  const auto same_impulses = [](const Joint& p, const Joint& q) { return p.last_impulses == q.last_impulses; };
  for (int step = 1; step <= steps; ++step) {
    one(world, dt_of(step), sweeps_of(step));
    other(same, dt_of(step), sweeps_of(step));
    if (hash_of(world) != hash_of(same) || !std::ranges::equal(world.contacts, same.contacts, same_bits) ||
        !std::ranges::equal(world.joints, same.joints, same_impulses))
      return step;
  }
  return 0;
}

/// By how much two worlds differ: in speeds and places relative to the fastest body, or to 1 m/s and 1 m; in impulses
/// relative to what stops the heaviest body at that speed.
Real difference(const World& world, const World& same) {
  if (world.contacts.size() != same.contacts.size()) return std::numeric_limits<Real>::infinity();
  Real fastest = 1, heaviest = 0, of_speeds = 0, of_impulses = 0;
  for (std::size_t i = 0; i < world.bodies.size(); ++i) {
    const Body &p = world.bodies[i], &q = same.bodies[i];
    if (p.movable()) heaviest = std::max(heaviest, 1 / p.inverse_mass);
    fastest = std::max({fastest, p.velocity.norm(), p.angular_velocity.norm()});
    of_speeds = std::max({of_speeds, (p.velocity - q.velocity).norm(), (p.angular_velocity - q.angular_velocity).norm(),
                          (p.position - q.position).norm()});
  }
  for (std::size_t i = 0; i < world.contacts.size(); ++i) {
    const Contact &p = world.contacts[i], &q = same.contacts[i];
    of_impulses = std::max({of_impulses, (p.impulse - q.impulse).norm(), (p.last_impulse - q.last_impulse).norm()});
  }
  return std::max(of_speeds, of_impulses / heaviest) / fastest;
}

/// Whether rounding decides where a step leads: begun from a world that differs in last bits, the same solver ends
/// elsewhere. So it is where cubes on ice meet face to face, and it depends on a last bit whose corner arrives first.
bool decided_by_rounding(const World& begun, StepSolver& solver, Real dt) {
  World stepped = begun;
  stepped.step(solver, dt);
  Random random(1);
  for (int i = 0; i < 200; ++i) {
    World shaken = begun;
    for (Body& body : shaken.bodies) {
      for (Vec3* state : {&body.position, &body.velocity, &body.angular_velocity})
        for (Real& number : *state) number *= 1 + Real(random.between(-8, 8)) * std::numeric_limits<Real>::epsilon();
    }
    shaken.step(solver, dt);
    if (difference(stepped, shaken) > Real(1e-9)) return true;
  }
  return false;
}

/// In steps of 1/60 s with 10 sweeps.
int first_difference(const Fill& fill, Stepper one, Stepper other, int steps) {
  return first_difference(
      fill, std::move(one), std::move(other), steps, [](int) { return Real(1) / 60; }, [](int) { return 10; });
}

}  // namespace

TEST_CASE("in every scene that it can solve, each chapter's plain loop has the bits of its composed solver") {
  for (const Chapter& chapter : chapters) {
    for (const NamedScene& scene : scenes(chapter.name >= "13")) {
      INFO(chapter.name << ", " << scene.name);
      CHECK(first_difference(scene.fill, chapter.composed({}), chapter.flat({}), chapter.name >= "09" ? 40 : 120) == 0);
    }
  }
}

TEST_CASE("21: in every scene without joints, a step of the plain loop has the numbers of the composed solver's") {
  if (sizeof(Real) != sizeof(double)) return;
  constexpr Real dt = Real(1) / 60;
  int by_rounding = 0;
  for (const NamedScene& scene : scenes(false)) {
    DetectedOnce composed;
    composed.carried_from = 0;
    flat_21::FlatSolver flat;
    World world;
    scene.fill(world);
    for (Body& body : world.bodies) body.restitution = 0;
    for (int step = 0; step < 60; ++step) {
      const World begun = world;
      World same = world;
      world.step(composed, dt);
      same.step(flat, dt);
      const Real apart = difference(world, same);
      if (apart < 1e-12) continue;
      INFO(scene.name << ", step " << step << ": " << apart);
      CHECK((decided_by_rounding(begun, composed, dt) || decided_by_rounding(begun, flat, dt)));
      ++by_rounding;
    }
  }
  CHECK(by_rounding < 30);
}

TEST_CASE(
    "21: what arrives within a step of the plain loop leaves at its end with e times its speed, and by its impulse") {
  for (const Real e : {Real(0), Real(0.3), Real(0.8), Real(1)}) {
    for (const bool flat_landing : {false, true}) {
      if (flat_landing && e == 0) continue;  // one sweep per substep leaves a rebound
      World world;
      world.add(ground().bouncy(e));
      const Real mass = 3, v = 5, dt = Real(1) / 60, gap = Real(0.4) * v * dt;
      const Body body = flat_landing ? box({1, Real(0.6), Real(0.8)}, mass) : sphere(Real(0.3), mass);
      world.add(Body(body).at({0, Real(0.3) + gap, 0}).moving({0, -v, 0}).rough(0));
      flat_21::FlatSolver solver;
      world.step(solver, dt);
      INFO(e << ", " << flat_landing);
      REQUIRE(world.contacts.size() == (flat_landing ? 4 : 1));
      Vec3 given = Vec3::Zero();
      for (const Contact& c : world.contacts) given += c.impulse;
      const Vec3 after = world.bodies[1].velocity;
      CHECK(std::abs(after.y() - e * v) < 1e-3 * v);
      CHECK((mass * (after - Vec3(0, -v, 0) - dt * world.gravity) - given).norm() < 1e-12 * mass * v);
    }
  }
}

TEST_CASE("in steps of changing length, from no sweep to 30, with these settings and others: likewise") {
  const auto dt_of = [](int step) { return Real(1) / static_cast<Real>(60 + 30 * (step % 7)); };
  const auto sweeps_of = [](int step) { return step % 31; };
  const Settings none{
      .beta = 0, .slop = 0, .threshold = 0, .hertz = 20, .damping_ratio = 0, .substeps = 1, .passes = 1};
  const Settings more{
      .beta = Real(0.6), .slop = Real(0.01), .threshold = 1, .fastest_push_out = Real(0.1), .substeps = 3};
  const Settings most{.beta = 1, .slop = 0, .threshold = Real(0.3), .hertz = 1000, .damping_ratio = 1, .passes = 3};
  for (const Settings& settings : {Settings{}, none, more, most}) {
    for (const Chapter& chapter : chapters) {
      INFO(chapter.name << ", beta = " << settings.beta);
      const Fill fill = chapter.name >= "13" ? jointed_pile : pile;
      const int steps = chapter.name >= "09" ? 80 : 300;
      CHECK(first_difference(fill, chapter.composed(settings), chapter.flat(settings), steps, dt_of, sweeps_of) == 0);
    }
  }
}

TEST_CASE("and each chapter is told apart from the one before it") {
  for (const Chapter& chapter : chapters) {
    if (chapter.before.empty() || chapter.name == "13") continue;
    INFO(chapter.name);
    const Fill fill = chapter.name >= "13" ? jointed_pile : pile;
    CHECK(first_difference(fill, chapter_named(chapter.before).composed({}), chapter.flat({}), 300) > 0);
  }
  World jointed;
  jointed_pile(jointed);
  CHECK_THROWS_AS(chapter_named("12").flat({})(jointed, Real(0.01), 1), InvalidInput);
}
