/// What a scene calls for is all that is needed: the same bits as with everything, no row without an effect.
#include <fmt/format.h>

#include <cstring>
#include <map>

#include "pushback/chapters/00_naive_impulses/naive.h"
#include "pushback/chapters/20_only_what_is_needed/dispatch.h"
#include "pushback/chapters/20_only_what_is_needed/everything.h"
#include "pushback/common/bodies/random.h"
#include "pushback/common/world/forces.h"
#include "pushback/common/world/measure.h"
#include "pushback/tools/measure/hard_cases/random_scene.h"
#include "tests/support/catch.h"
#include "tests/support/complaint.h"
#include "tests/support/with_joints.h"
#include "tests/support/yardstick.h"

using namespace pushback;

namespace {

bool same_bits(const Vec3& p, const Vec3& q) {
  return std::memcmp(p.data(), q.data(), sizeof(Vec3)) == 0;
}

/// Bodies, and what the solver says of the contacts.
bool same_bits(const World& p, const World& q) {
  if (hash_of(p) != hash_of(q) || p.time != q.time || p.contacts.size() != q.contacts.size()) return false;
  for (std::size_t i = 0; i < p.contacts.size(); ++i) {
    const Contact &a = p.contacts[i], &b = q.contacts[i];
    if (a.id != b.id || a.state != b.state || !same_bits(a.impulse, b.impulse)) return false;
  }
  return true;
}

struct Sweeping {
  Real dt = h;
  int steps = 300, sweeps = 10;
};

/// The first step after which the world with everything and the one with what is called for differ; -1: none.
template <class Full, class Whole>
int first_difference(const World& start, const Full& full, const Sweeping& how, Whole everything) {
  World whole = start, fitted = start;
  OnlyWhatIsNeeded only_needed(fitted, full);
  for (int i = 0; i < how.steps; ++i) {
    const std::string one = complaint([&] { whole.step(everything, how.dt, how.sweeps); });
    const std::string other = complaint([&] { only_needed.step(fitted, how.dt, how.sweeps); });
    if (one != other || !same_bits(whole, fitted)) return i;
    if (!one.empty()) break;  // both are no longer finite
  }
  return -1;
}

template <class Full>
int first_difference(const World& start, const Full& full, const Sweeping& how) {
  return first_difference(start, full, how, full);
}

/// Which of the questions are answered with yes, as letters.
template <class... Questions>
std::string yes_to(const World& world, CalledFor<Questions...>) {
  std::string letters;
  ((letters += Questions::in(world).yes ? "TBRGFJ"[letters.size()] : '-'), ...);
  return letters;
}

/// Random scenes nearly always call for everything. By the bits of the seed: no e, no mu, even inertia, something that pulls, a joint.
RandomScene varied_scene(std::uint64_t seed) {
  RandomScene scene = random_scene(seed);
  for (Body& body : scene.world.bodies) {
    if (seed & 1) body.restitution = 0;
    if (seed & 2) body.friction = 0;
    if (seed & 4) body.principal_inverse_inertia.setConstant(body.principal_inverse_inertia.x());
    body.refresh_inertia();
  }
  Body& first = scene.world.bodies.front();
  if (seed & 8 && first.movable()) {
    const Real mass = 1 / first.inverse_mass;
    scene.world.forces.push_back(spring(0, first.position + Vec3(1, 2, 3), mass));
    scene.world.forces.push_back(drag(0, mass / 8));
  } else if (seed & 8) {
    scene.world.bodies.back().force = {1, 2, 3};
  }
  if (seed & 16 && first.movable()) {
    const int other = scene.world.bodies.size() == 1 ? the_world : int(scene.world.bodies.size()) - 1;
    scene.world.joints = {ball_and_socket(scene.world, 0, other, first.position + Vec3(0, 1, 0))};
  }
  return scene;
}

/// Plays the seeds, and counts how often each combination of answers came up.
template <class Full>
std::map<std::string, int> play_seeds(std::uint64_t first, std::uint64_t last, int steps, int substeps, int sweeps) {
  std::map<std::string, int> occurred;
  for (std::uint64_t seed = first; seed <= last; ++seed) {
    const RandomScene scene = varied_scene(seed);
    ++occurred[yes_to(scene.world, EveryQuestion{})];
    INFO("seed " << seed);
    REQUIRE(first_difference(scene.world, Full{}, {scene.dt / static_cast<Real>(substeps), steps, sweeps}) == -1);
  }
  return occurred;
}

/// Those that there can be, with joints or without: without contacts, e and mu matter to nobody.
const std::vector<std::string> combinations{"T----", "T---F", "T--G-", "T--GF", "T-R--", "T-R-F", "T-RG-",
                                            "T-RGF", "TB---", "TB--F", "TB-G-", "TB-GF", "TBR--", "TBR-F",
                                            "TBRG-", "TBRGF", "-----", "----F", "---G-", "---GF"};

Body unit_cube() {
  return box(Vec3::Constant(Real(0.5)), 10);
}

}  // namespace

// ---- at compile time -----------------------------------------------------------------------------------------------------

static_assert(std::same_as<Only<FullSolver, EveryQuestion>, FullSolver>);
static_assert(std::same_as<Only<FullSolver, CalledFor<Touching>>, Solver<Clamping, Baumgarte, Slop, WarmStart>>);
static_assert(std::same_as<Only<FullSolver, CalledFor<Touching, Bouncing>>,
                           Solver<Clamping, Baumgarte, Slop, Restitution, WarmStart>>);
static_assert(std::same_as<Only<FullSolver, CalledFor<Touching, Rubbing, Tumbling>>,
                           Solver<Clamping, Baumgarte, Slop, Friction, WarmStart>>);
static_assert(std::same_as<Only<FullSolver, CalledFor<Tumbling, Pulling>>, Solver<>>);
static_assert(
    std::same_as<Only<SteadySolver, CalledFor<Touching>>, RelaxingSolver<Clamping, SoftContacts, ScaledWarmStart>>);
static_assert(std::same_as<Only<SteadySolver, CalledFor<Touching, Bouncing>>,
                           RelaxingSolver<Clamping, SoftContacts, SimultaneousImpacts, ScaledWarmStart>>);
static_assert(std::same_as<Only<SteadySolver, CalledFor<Touching, Rubbing>>,
                           RelaxingSolver<Clamping, SoftContacts, FrictionCone, ScaledWarmStart>>);
static_assert(std::same_as<Only<Solver<Clamping, SequentialImpacts>, CalledFor<Touching>>, Solver<Clamping>>);
static_assert(std::same_as<Only<JointedSolver, EveryQuestion>, JointedSolver>);
static_assert(std::same_as<Only<JointedSolver, CalledFor<Touching, Bouncing, Rubbing>>, FullSolver>);
static_assert(std::same_as<Only<JointedSolver, CalledFor<Holding>>, Solver<SplitJoints>>);
static_assert(std::same_as<Only<Solver<Joints, Clamping>, CalledFor<Touching, Holding>>, Solver<Joints, Clamping>>);
static_assert(std::same_as<Only<SteadyJointedSolver, CalledFor<Holding>>, RelaxingSolver<SteadyJoints, SoftContacts>>);
static_assert(std::same_as<Only<NaiveAveraged, CalledFor<>>, NaiveAveraged>);

// ---- the same bits -------------------------------------------------------------------------------------------------------

TEST_CASE("every scene moves in the same bits as with the full solver") {
  for (const NamedScene& scene : all_scenes_and_joints()) {
    INFO(scene.name);
    World world;
    scene.fill(world);
    CHECK(first_difference(world, JointedSolver{}, {}) == -1);
  }
}

TEST_CASE("the same bits as with tangent rows everywhere, rubbing or not") {
  for (const NamedScene& scene : all_scenes_and_joints()) {
    INFO(scene.name);
    World world;
    scene.fill(world);
    CHECK(first_difference(world, JointedSolver{}, {}, Everything{}) == -1);
  }
  for (std::uint64_t seed = 1; seed <= 500; ++seed) {
    const RandomScene scene = varied_scene(seed);
    INFO("seed " << seed);
    CHECK(first_difference(scene.world, JointedSolver{}, {scene.dt, 60, 10}, Everything{}) == -1);
  }
}

TEST_CASE("every scene moves in the same bits as with the steady solver") {
  for (const NamedScene& scene : all_scenes_and_joints()) {
    INFO(scene.name);
    World world;
    scene.fill(world);
    CHECK(first_difference(world, SteadyJointedSolver{}, {h / 32, 320, 1}) == -1);
  }
}

TEST_CASE("random scenes move in the same bits, whatever they call for") {
  const auto occurred = play_seeds<JointedSolver>(1, 2000, 60, 1, 10);
  CHECK(occurred.size() == 2 * combinations.size());
  for (const std::string& without : combinations) {
    for (const std::string& combination : {without + '-', without + 'J'}) {
      INFO(combination);
      REQUIRE(occurred.contains(combination));
      CHECK(occurred.at(combination) >= 4);
    }
  }
}
TEST_CASE("random scenes move in the same bits in substeps") {
  play_seeds<SteadyJointedSolver>(1, 160, 64, 32, 1);
}
TEST_CASE("more random scenes", "[long]") {
  play_seeds<JointedSolver>(2001, 20000, 120, 1, 10);
  play_seeds<SteadyJointedSolver>(161, 3200, 320, 32, 1);
}

TEST_CASE("a zero with a minus sign stays as it would") {
  World world;
  world.gravity = -Vec3(0, World::g, 0);
  world.add(sphere(1, 1).moving(-Vec3(1, 0, 0)).spinning(-Vec3(0, 2, 0)));
  CHECK(first_difference(world, FullSolver{}, {}) == -1);
}

// ---- what is read off a scene ---------------------------------------------------------------------------------------------

TEST_CASE("each question has its answers, and says because of whom") {
  World world;
  const auto because = [&world](auto question) {
    const Answer answer = decltype(question)::in(world);
    return fmt::format("{}: {}", answer.yes ? "yes" : "no", answer.because);
  };
  CHECK(because(Touching{}) == "no: nothing can move");  // an empty world
  CHECK(because(Bouncing{}) == "no: e = 0 in every pair that can touch");
  CHECK(because(Rubbing{}) == "no: μ = 0 in every pair that can touch");
  CHECK(because(Tumbling{}) == "no: every body's inertia is the same about all its axes");
  CHECK(because(Pulling{}) == "no: nothing pulls but gravity");

  world.add(sphere(1, 1).bouncy(1).rough(1));
  CHECK(because(Touching{}) == "no: there is one body only");
  CHECK_FALSE(Bouncing::in(world).yes);  // with whom?
  CHECK_FALSE(Rubbing::in(world).yes);
  CHECK_FALSE(Tumbling::in(world).yes);

  world.add(ground().rough(0));
  CHECK(because(Touching{}) == "yes: 2 bodies, of which 1 can move");
  CHECK(because(Bouncing{}) == "yes: e = 1 between ball 0 and plane 1");
  CHECK_FALSE(Rubbing::in(world).yes);  // smooth ground, and nothing else
  world.bodies[1].rough(Real(0.36));
  CHECK(because(Rubbing{}) == "yes: μ = 0.6 between ball 0 and plane 1");
  world.bodies[0].rough(0);
  CHECK_FALSE(Rubbing::in(world).yes);
  world.bodies[0].bouncy(0);
  CHECK_FALSE(Bouncing::in(world).yes);

  world.add(unit_cube().fixed().bouncy(Real(0.5)).rough(
      1));  // rubs and bounces with the ball; with the ground it does not meet
  CHECK(because(Bouncing{}) == "yes: e = 0.5 between ball 0 and box 2");
  CHECK_FALSE(Rubbing::in(world).yes);
  world.add(unit_cube().rough(Real(0.25)));
  CHECK(because(Rubbing{}) == "yes: μ = 0.5 between box 3 and box 2");
  CHECK_FALSE(Tumbling::in(world).yes);
  world.add(box({1, 2, 1}, 1).fixed());  // no inertia at all
  CHECK_FALSE(Tumbling::in(world).yes);
  world.add(capsule(1, 1, 1));
  CHECK(because(Tumbling{}) == "yes: the inertia of capsule 5 differs from axis to axis");

  world.bodies[3].torque = {0, 1, 0};
  CHECK(because(Pulling{}) == "yes: a force on box 3");
  world.forces.push_back(spring(5, Vec3::Zero(), 1));
  CHECK(because(Pulling{}) == "yes: a spring on capsule 5");
  world.forces = {{[](World&) {}, "wind"}};
  CHECK(because(Pulling{}) == "yes: wind");

  world.bodies[0].fixed();
  world.bodies[3].fixed();
  world.bodies[5].fixed();
  CHECK(because(Touching{}) == "no: nothing can move");
  CHECK_FALSE(Bouncing::in(world).yes);
  CHECK_FALSE(Rubbing::in(world).yes);

  std::string names;
  for (const NamedAnswer& line : effects_of(world))
    names += fmt::format("{}: {}; ", line.name, line.answer.yes ? "yes" : "no");
  CHECK(names == "contacts: no; restitution: no; friction: no; gyroscopic term: no; applied forces: yes; joints: no; ");
}

// ---- rows only where they can act -------------------------------------------------------------------------------------------

TEST_CASE("no tangent rows where nothing rubs, no bias where nothing is to be changed") {
  Random random(4);
  World world;
  world.add(ground().rough(Real(0.8)));
  for (int i = 0; i < 30; ++i) {
    Body body = random.body(10);
    body.rough(i % 3 == 0 ? 0 : Real(0.6)).bouncy(i % 4 == 0 ? Real(0.7) : 0);
    const Vec3 beside = random.vector(1);
    world.add(body.at(beside + Vec3(0, Real(0.5) * static_cast<Real>(i), 0)));
  }
  const Real slop = FullSolver{}.slop, threshold = FullSolver{}.threshold;
  FittingSolver solver(world, FullSolver{});
  std::size_t smooth = 0, rough = 0, shallow = 0, sunk = 0, bouncing = 0;
  for (int i = 0; i < 600; ++i) {
    world.begin_step(h);
    std::vector<bool> bounces;
    for (const Contact& contact : world.contacts)
      bounces.push_back(contact.restitution > 0 && approach_speed(world, contact) < -threshold);
    solver.solve(world, h, 10);
    const auto rubs = [](const Contact& contact) { return contact.friction > 0; };
    const auto can_rub = std::size_t(std::count_if(world.contacts.begin(), world.contacts.end(), rubs));
    REQUIRE(solver.rows().size() == world.contacts.size() + 2 * can_rub);
    for (std::size_t k = 0; k < world.contacts.size(); ++k) {
      const bool too_deep = world.contacts[k].depth > slop;
      REQUIRE((solver.rows()[k].bias != 0) == (too_deep || bounces[k]));
      ++(bounces[k] ? bouncing : too_deep ? sunk : shallow);
    }
    for (std::size_t k = world.contacts.size(); k < solver.rows().size(); ++k) {
      REQUIRE(rubs(world.contacts[solver.rows()[k].owner]));
      REQUIRE(solver.rows()[k].bias == 0);
    }
    rough += can_rub;
    smooth += world.contacts.size() - can_rub;
    world.move(h);
  }
  CAPTURE(smooth, rough, shallow, sunk, bouncing);
  CHECK(std::min({smooth, rough, shallow, sunk, bouncing}) > 50);
}

// ---- the scene changes ------------------------------------------------------------------------------------------------------

TEST_CASE("settings and memory outlive each change of the scene, to the bit") {
  World whole;
  whole.add(ground().rough(0));
  for (int i = 0; i < 3; ++i)
    whole.add(unit_cube().at({0, Real(0.495) + Real(0.992) * static_cast<Real>(i), 0}).rough(0));
  World fitted = whole;
  FullSolver full;
  full.beta = Real(0.3);
  full.slop = Real(0.002);
  full.threshold = Real(0.7);
  OnlyWhatIsNeeded solver(fitted, full);
  std::string letters;
  const auto change_and_go_on = [&](const char* what, const auto& change, bool by_hand) {
    change(whole);
    change(fitted);
    if (by_hand) solver.fit(fitted);
    const std::string now = yes_to(fitted, EveryQuestion{});
    REQUIRE((now != letters));
    letters = now;
    for (int i = 0; i < 60; ++i) {
      INFO(what << ", step " << i);
      whole.step(full, h);
      solver.step(fitted, h);
      REQUIRE(same_bits(whole, fitted));
    }
  };
  change_and_go_on("as it is", [](World&) {}, false);
  CHECK(letters == "T-----");
  change_and_go_on(
      "the ground becomes rough, and two boxes",
      [](World& world) { world.bodies[0].rough(1), world.bodies[1].rough(1), world.bodies[2].rough(Real(0.3)); }, true);
  change_and_go_on(
      "a ball falls on them, bouncing below and above the threshold",
      [](World& world) {
        world.add(sphere(Real(0.2), 1).at({Real(0.1), Real(3.2), 0}).bouncy(Real(0.8)));
        world.add(sphere(Real(0.2), 1).at({2, Real(0.215), 0}).bouncy(1));
      },
      false);
  change_and_go_on(
      "a plank", [](World& world) { world.add(box({2, Real(0.1), Real(0.3)}, 5).at({0, 5, 0}).spinning({1, 1, 1})); },
      false);
  change_and_go_on("a spring", [](World& world) { world.forces.push_back(spring(2, {1, 4, 0}, 20)); }, false);
  CHECK(letters == "TBRGF-");
  change_and_go_on(
      "all smooth",
      [](World& world) {
        for (Body& body : world.bodies) body.rough(0);
      },
      true);
  change_and_go_on(
      "nothing bounces",
      [](World& world) {
        for (Body& body : world.bodies) body.bouncy(0);
        world.forces.clear();
      },
      true);
  CHECK(letters == "T--G--");
  change_and_go_on(
      "and rough again",
      [](World& world) {
        for (Body& body : world.bodies) body.rough(1);
      },
      true);
  CHECK(letters == "T-RG--");
}

TEST_CASE("who comes back is not taken for who was there") {
  World whole;
  whole.add(unit_cube().at({0, Real(0.495), 0}));
  whole.add(ground());
  World fitted = whole;
  FullSolver full;
  OnlyWhatIsNeeded solver(fitted, full);
  const auto both_go_on = [&](int steps) {
    for (int i = 0; i < steps; ++i) {
      whole.step(full, h);
      solver.step(fitted, h);
      REQUIRE(same_bits(whole, fitted));
    }
  };
  both_go_on(30);
  whole.bodies.pop_back();
  fitted.bodies.pop_back();
  both_go_on(1);  // one body: nothing can touch
  whole.add(ground());
  fitted.add(ground());
  both_go_on(30);
}

// ---- bad input ----------------------------------------------------------------------------------------------------------------

TEST_CASE("the two lines of the page: a stack stands for ten seconds") {
  World world;
  stack(world, 3);
  OnlyWhatIsNeeded needed(world, FullSolver{});  // or with Sleep{} as a third argument
  for (int step = 0; step < 600; ++step) needed.step(world, Real(1) / 60);
  CHECK(world.bodies.back().position.y() == Approx(2.5).margin(0.02));
}

TEST_CASE("what cannot be simulated is refused as World does, and nothing has moved") {
  constexpr Real nan = std::numeric_limits<Real>::quiet_NaN();
  World world;
  stack(world, 2);
  FullSolver full;
  OnlyWhatIsNeeded solver(world, full);
  solver.step(world, h);
  const std::uint64_t before = hash_of(world);
  const auto refused_alike = [&](Real dt, int sweeps) {
    const std::string said = complaint([&] { solver.step(world, dt, sweeps); });
    return !said.empty() && said == complaint([&] { world.step(full, dt, sweeps); });
  };
  CHECK(refused_alike(0, 10));
  CHECK(refused_alike(-h, 10));
  CHECK(refused_alike(nan, 10));
  CHECK(refused_alike(h, -1));
  world.gravity.y() = nan;
  CHECK(refused_alike(h, 10));
  world.gravity.y() = -1;
  CHECK(hash_of(world) == before);
  world.bodies[2].velocity.x() = nan;
  const std::uint64_t with_nan = hash_of(world);
  CHECK(refused_alike(h, 10));
  CHECK(hash_of(world) == with_nan);
  world.bodies[2].velocity.x() = 0;
  CHECK(complaint([&] { solver.step(world, h); }).empty());

  full.beta = -1;
  CHECK(complaint([&] { OnlyWhatIsNeeded(world, full).step(world, h); }).find("beta") != std::string::npos);
}
