/// What a scene calls for is all that is needed: the same bits as with everything, no row without an effect.
#include <fmt/format.h>

#include <cstring>
#include <map>

#include "pushback/chapters/00_naive_impulses/naive.h"
#include "pushback/chapters/13_joints/distance.h"
#include "pushback/chapters/13_joints/weld.h"
#include "pushback/chapters/20_only_what_is_needed/dispatch.h"
#include "pushback/chapters/20_only_what_is_needed/everything.h"
#include "pushback/common/bodies/random.h"
#include "pushback/common/world/forces.h"
#include "pushback/common/world/measure.h"
#include "pushback/tools/catalogue/solvers.h"
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

/// The first of so many steps after which the world with everything and the one with what is called for differ; -1: none.
int first_difference(const World& start, const NamedSolver& full, AnySolver everything, Real dt, int steps) {
  World whole = start, fitted = start;
  OnlyWhatIsNeeded only_needed = full.fitting(fitted, {});
  for (int i = 0; i < steps; ++i) {
    const std::string one = complaint([&] { whole.step(everything, dt); });
    const std::string other = complaint([&] { only_needed.step(fitted, dt); });
    if (one != other || !same_bits(whole, fitted)) return i;
    if (!one.empty()) break;  // both are no longer finite
  }
  return -1;
}

const NamedSolver& full_solver() {
  return solver_named("07 warm start");
}
const NamedSolver& in_substeps() {
  return solver_named("all together");
}

/// Which of the questions are answered with yes, as letters.
template <class... Some>
std::string yes_to(const World& world, Questions<Some...>) {
  std::string letters;
  ((letters += Some::in(world).yes ? "TBRGFJ"[letters.size()] : '-'), ...);
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
std::map<std::string, int> play_seeds(const NamedSolver& full, std::uint64_t first, std::uint64_t last, int steps) {
  std::map<std::string, int> occurred;
  for (std::uint64_t seed = first; seed <= last; ++seed) {
    const RandomScene scene = varied_scene(seed);
    ++occurred[yes_to(scene.world, AllQuestions{})];
    INFO("seed " << seed);
    REQUIRE(first_difference(scene.world, full, full.solver, scene.dt, steps) == -1);
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

static_assert(std::same_as<Only<FullSolver, AllQuestions>, FullSolver>);
static_assert(std::same_as<Only<FullSolver, Questions<NeedsContacts>>, Solver<Clamping, Baumgarte, Slop, WarmStart>>);
static_assert(std::same_as<Only<FullSolver, Questions<NeedsContacts, NeedsFriction, NeedsGyroscopicTerm>>,
                           Solver<Clamping, Baumgarte, Slop, Friction, WarmStart>>);
static_assert(std::same_as<Only<FullSolver, Questions<NeedsGyroscopicTerm, NeedsAppliedForces>>, Solver<>>);
static_assert(std::same_as<Only<SteadySolver, Questions<NeedsContacts>>,
                           RelaxingSolver<Clamping, SoftContacts, ScaledWarmStart>>);
static_assert(std::same_as<Only<Solver<Clamping, SequentialImpacts>, Questions<NeedsContacts>>, Solver<Clamping>>);
static_assert(std::same_as<Only<JointedSolver, Questions<NeedsContacts, NeedsRestitution, NeedsFriction>>, FullSolver>);
static_assert(std::same_as<Only<JointedSolver, Questions<NeedsJoints>>, Solver<SplitJoints>>);
static_assert(
    std::same_as<Only<SteadyJointedSolver, Questions<NeedsJoints>>, RelaxingSolver<SteadyJoints, SoftContacts>>);
static_assert(std::same_as<Only<NaiveAveraged, Questions<>>, NaiveAveraged>);

TEST_CASE("every scene moves in the same bits as with the full solver, with tangent rows everywhere, and in substeps") {
  for (const NamedScene& scene : all_scenes_and_joints()) {
    INFO(scene.name);
    World world;
    scene.fill(world);
    CHECK(first_difference(world, full_solver(), full_solver().solver, h, 150) == -1);
    CHECK(first_difference(world, full_solver(), Everything{}, h, 150) == -1);
    CHECK(first_difference(world, in_substeps(), in_substeps().solver, h, 10) == -1);
  }
}

TEST_CASE("random scenes move in the same bits, whatever they call for") {
  const auto occurred = play_seeds(full_solver(), 1, 2000, 60);
  CHECK(occurred.size() == 2 * combinations.size());
  for (const std::string& without : combinations) {
    for (const std::string& combination : {without + '-', without + 'J'}) {
      INFO(combination);
      REQUIRE(occurred.contains(combination));
      CHECK(occurred.at(combination) >= 4);
    }
  }
  for (std::uint64_t seed = 1; seed <= 500; ++seed) {
    const RandomScene scene = varied_scene(seed);
    INFO("seed " << seed);
    CHECK(first_difference(scene.world, full_solver(), Everything{}, scene.dt, 60) == -1);
  }
  play_seeds(in_substeps(), 1, 160, 2);
}
TEST_CASE("more random scenes", "[long]") {
  play_seeds(full_solver(), 2001, 20000, 120);
  play_seeds(in_substeps(), 161, 3200, 10);
}

TEST_CASE("a zero with a minus sign stays as it would") {
  World world;
  world.gravity = -Vec3(0, World::g, 0);
  world.add(sphere(1, 1).moving(-Vec3(1, 0, 0)).spinning(-Vec3(0, 2, 0)));
  CHECK(first_difference(world, full_solver(), full_solver().solver, h, 150) == -1);
}

TEST_CASE("each question has its answers, and says because of whom") {
  World world;
  const auto because = [&world](auto question) { return decltype(question)::in(world).because; };
  const auto called = [&world] { return yes_to(world, AllQuestions{}); };
  CHECK(called() == "------");  // an empty world
  CHECK(because(NeedsContacts{}) == "nothing can move");
  world.add(sphere(1, 1).bouncy(1).rough(1));
  CHECK(called() == "------");  // one body: with whom?
  CHECK(because(NeedsContacts{}) == "there is one body only");

  world.add(ground().rough(0));
  CHECK(called() == "TB----");
  CHECK(because(NeedsContacts{}) == "2 bodies, of which 1 can move");
  CHECK(because(NeedsRestitution{}) == "e = 1 between ball 0 and plane 1");
  world.bodies[1].rough(Real(0.36));
  CHECK(called() == "TBR---");
  CHECK(because(NeedsFriction{}) == "μ = 0.6 between ball 0 and plane 1");
  world.bodies[0].rough(0).bouncy(0);
  CHECK(called() == "T-----");

  world.add(unit_cube().fixed().bouncy(Real(0.5)).rough(1));  // it does not meet the ground
  CHECK(called() == "TB----");
  world.add(unit_cube().rough(Real(0.25)));
  CHECK(because(NeedsFriction{}) == "μ = 0.5 between box 3 and box 2");
  world.add(box({1, 2, 1}, 1).fixed());  // no inertia at all
  CHECK(called() == "TBR---");
  world.add(capsule(1, 1, 1));
  CHECK(because(NeedsGyroscopicTerm{}) == "the inertia of capsule 5 differs from axis to axis");
  CHECK(called() == "TBRG--");

  world.bodies[3].torque = {0, 1, 0};
  CHECK(because(NeedsAppliedForces{}) == "a force on box 3");
  world.forces.push_back(spring(5, Vec3::Zero(), 1));
  CHECK(because(NeedsAppliedForces{}) == "a spring on capsule 5");
  world.forces = {{[](World&) {}, "wind"}};
  CHECK(because(NeedsAppliedForces{}) == "wind");
  CHECK(called() == "TBRGF-");
  for (const std::size_t body : {0, 3, 5}) world.bodies[body].fixed();
  CHECK(called() == "----F-");
  const std::vector<NamedAnswer> lines = effects_of(world);  // as ./course effects lists them
  REQUIRE(lines.size() == 6);
  for (const NamedAnswer& line : lines) CHECK(line.answer.yes == (line.name == "applied forces"));
}

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
  const Real slop = JointedSolver{}.slop, threshold = JointedSolver{}.threshold;
  OnlyWhatIsNeeded solver = full_solver().fitting(world, {});
  std::size_t smooth = 0, rough = 0, shallow = 0, sunk = 0, bouncing = 0;
  for (int i = 0; i < 600; ++i) {
    World begun = world;
    begun.begin_step(h);
    std::vector<bool> bounces;
    for (const Contact& contact : begun.contacts)
      bounces.push_back(contact.restitution > 0 && approach_speed(begun, contact) < -threshold);
    solver.step(world, h, 10);
    REQUIRE(world.contacts.size() == begun.contacts.size());
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
  }
  CAPTURE(smooth, rough, shallow, sunk, bouncing);
  CHECK(std::min({smooth, rough, shallow, sunk, bouncing}) > 50);
}

TEST_CASE("settings and memory outlive each change of the scene, to the bit") {
  World whole;
  whole.add(ground().rough(0));
  for (int i = 0; i < 3; ++i)
    whole.add(unit_cube().at({0, Real(0.495) + Real(0.992) * static_cast<Real>(i), 0}).rough(0));
  World fitted = whole;
  JointedSolver full;
  full.Baumgarte::beta = Real(0.3);
  full.Joints::beta = Real(0.35);
  full.slop = Real(0.002);
  full.threshold = Real(0.7);
  OnlyWhatIsNeeded solver(fitted, full);
  const auto change_and_go_on = [&](const std::string& called, bool by_hand,
                                    const std::function<void(World&)>& change) {
    change(whole);
    change(fitted);
    if (by_hand) solver.fit(fitted);
    CHECK(yes_to(fitted, AllQuestions{}) == called);
    for (int i = 0; i < 60; ++i) {
      INFO(called << ", step " << i);
      whole.step(full, h);
      solver.step(fitted, h);
      REQUIRE(same_bits(whole, fitted));
    }
  };
  change_and_go_on("T-----", false, [](World&) {});
  change_and_go_on("T-R---", true, [](World& world) {
    for (const std::size_t body : {0, 1, 2}) world.bodies[body].rough(body < 2 ? 1 : Real(0.3));
  });
  change_and_go_on("TBR---", false, [](World& world) {  // bouncing below and above the threshold
    world.add(sphere(Real(0.2), 1).at({Real(0.1), Real(3.2), 0}).bouncy(Real(0.8)));
    world.add(sphere(Real(0.2), 1).at({2, Real(0.215), 0}).bouncy(1));
  });
  change_and_go_on("TBRG--", false, [](World& world) {
    world.add(box({2, Real(0.1), Real(0.3)}, 5).at({0, 5, 0}).spinning({1, 1, 1}));
  });
  change_and_go_on("TBRGF-", false, [](World& world) { world.forces.push_back(spring(2, {1, 4, 0}, 20)); });
  change_and_go_on("TBRGFJ", false, [](World& world) {
    const Vec3 above = world.bodies[6].position + Vec3(0, 2, 0);
    world.joints.push_back(distance(world, the_world, above, 6, world.bodies[6].position));
    world.joints.push_back(weld(world, 4, 5, world.bodies[4].position));
  });
  change_and_go_on("T--GFJ", true, [](World& world) {
    for (Body& body : world.bodies) body.rough(0).bouncy(0);
    world.joints.pop_back();
  });
  change_and_go_on("T--G--", false, [](World& world) {
    world.forces.clear();
    world.joints.clear();
  });
  change_and_go_on("T-RG--", true, [](World& world) {
    for (Body& body : world.bodies) body.rough(1);
  });
}

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
  AnySolver full = full_solver().solver;
  OnlyWhatIsNeeded solver = full_solver().fitting(world, {}), with_sleep = full_solver().fitting(world, Sleep{});
  const auto refused_alike = [&](Real dt, int sweeps) {
    const std::uint64_t before = hash_of(world);
    const std::string said = complaint([&] { world.step(full, dt, sweeps); });
    INFO(said);
    CHECK_FALSE(said.empty());
    for (OnlyWhatIsNeeded* each : {&solver, &with_sleep, &solver, &with_sleep})  // and once more
      CHECK(complaint([&] { each->step(world, dt, sweeps); }) == said);
    CHECK(hash_of(world) == before);
    CHECK(world.time == 0);
  };
  refused_alike(0, 10);
  refused_alike(nan, 10);
  refused_alike(h, -1);
  world.gravity.y() = nan;
  refused_alike(h, 10);
  world.gravity.y() = -1;
  world.bodies[2].velocity.x() = nan;
  refused_alike(h, 10);
  world.bodies[2].velocity.x() = 0;
  for (const int body : {-2, 3, 7}) {
    world.joints = {ball_and_socket(world, the_world, 1, {0, 0, 0})};
    world.joints.back().b = body;
    refused_alike(h, 10);
  }
  world.joints.clear();
  CHECK(complaint([&] { solver.step(world, h); }).empty());
}
