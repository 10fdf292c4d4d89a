/// An experiment that is played to and fro: the same bits whichever way an instant is reached, with a hand in it, too.
#include "pushback/common/live/live.h"

#include <cmath>

#include "pushback/chapters/07_warm_start/full_solver.h"
#include "pushback/chapters/11_substeps/substeps.h"
#include "pushback/common/render/palette.h"
#include "tests/support/call.h"
#include "tests/support/catch.h"

using namespace pushback;

namespace {

/// What a chapter's main says: a stack with a parameter, and a scene with one body in it.
struct Told {
  Experiment e{"told", "Does it stand?"};
  int boxes = 4;
  std::vector<Real> slops{Real(0.005), 0};

  Told() {
    e.parameter({"--boxes", "n", "", "Boxes of the stack", 1, 12}, &boxes);
    e.parameter({"--slop", "s", "m", "Slops to put side by side", 0, 0.05}, &slops);
  }
  void operator()() {
    e.scene({.name = "a stack",
             .fill = [n = boxes](World& world) { stack(world, n); },
             .seconds = 2,
             .colours = {{Ink{255, 0, 16}, "the top"}}});
    for (const Real slop : slops) {
      FullSolver solver;
      solver.slop = slop;
      e.variant(fmt::format("slop {}", slop), Substeps(solver, 2, 10)).expect("deepest overlap", slop);
    }
    e.series("height", "m", [](const World& world) { return world.bodies.back().position.y(); });
    e.number("deepest overlap", "m", [](const Run& run) { return run.samples.back().overlap; });
    e.number("height in step 90", "m", [](const Run& run) { return run.series.at("height").at(89); });
  }
};

struct Played {
  Told told;
  Live live;
  explicit Played(std::size_t bytes = Live::usual_bytes) : live(told.e, [this] { told(); }, bytes) {}

  std::pair<std::uint64_t, std::uint64_t> hashes() const { return {hash_of(live.world(0)), hash_of(live.world(1))}; }
};

const Camera from_the_front{{0, 2, 20}, {0, 2, 0}, Real(0.5)};

}  // namespace

TEST_CASE("an instant has the same bits however it is reached, also where few states are kept") {
  for (const std::size_t bytes : {Live::usual_bytes, std::size_t{20000}}) {
    Played played(bytes);
    std::vector<std::pair<std::uint64_t, std::uint64_t>> seen{played.hashes()};
    for (std::size_t step = 1; step <= 120; ++step) {
      played.live.go_to(step);
      seen.push_back(played.hashes());
    }
    for (const std::size_t step : {119, 118, 3, 0, 77, 64, 120, 1}) {
      played.live.go_to(step);
      CHECK(played.live.now() == step);
      CHECK(played.hashes() == seen[step]);
    }
    CHECK(played.live.known() == 120);
    World world;
    stack(world, 4);
    FullSolver solver;
    solver.slop = Real(0.005);
    for (int i = 0; i < 240; ++i) world.step(solver, Real(1) / 60 / 2, 10);
    CHECK(hash_of(world) == seen[120].first);
  }
}

TEST_CASE("what the hand does is played again where one goes back, and forgotten where it takes hold anew") {
  Played played;
  Live& live = played.live;
  live.go_to(120);
  const auto untouched = played.hashes();
  live.go_to(20);
  REQUIRE(live.grab_at(0, from_the_front, 1, 0, Real(0.3)));
  CHECK(live.known() == 20);
  CHECK(live.steps() == 20 + 300);
  for (std::size_t step = 21; step <= 60; ++step) {
    live.pull_to(from_the_front, 1, Real(0.01) * static_cast<Real>(step - 20), Real(0.3));
    live.go_to(step);
  }
  live.let_go();
  live.go_to(90);
  const auto pulled = played.hashes();
  live.go_to(35);
  live.go_to(90);
  CHECK(played.hashes() == pulled);
  CHECK(live.world(0).forces.empty());
  live.go_to(120);
  CHECK(played.hashes() != untouched);
  CHECK(played.hashes().first != played.hashes().second);
  live.go_to(20);
  REQUIRE(live.grab_at(1, from_the_front, 1, 0, Real(0.3)));
  live.let_go();
  live.go_to(120);
  CHECK(played.hashes() == untouched);
}

TEST_CASE("a guess is as far along its axis as the point of the picture under the mouse") {
  Played played;
  const Vec3 start = played.live.displaced(Vec3::Zero()).position;
  CHECK(start == Vec3(0, Real(0.5), 0));
  CHECK(played.live.displaced({0, 1, 0}).position == Vec3(0, Real(1.5), 0));
  const Vec3 askew = Vec3(1, 1, 0).normalized();
  CHECK(std::abs(played.live.way_to(Vec3::UnitY(), from_the_front, 1, 0, 0) - Real(1.5)) < 1e-12);
  CHECK(std::abs(played.live.way_to(askew, from_the_front, 1, 0, 0) - Real(1.5) / std::sqrt(2)) < 1e-12);
}

TEST_CASE("a body follows the hand, a heavy one as a light one does") {
  std::vector<Vec3> places;
  for (const Real mass : {Real(1), Real(1000)}) {
    World world;
    world.gravity.setZero();
    world.add(sphere(Real(0.5), mass));
    world.forces.push_back(pull_of({0, Vec3::Zero(), {1, 2, 0}}, Real(1) / 60));
    FullSolver solver;
    for (int i = 0; i < 20; ++i) world.step(solver, Real(1) / 60);
    places.push_back(world.bodies[0].position);
    for (int i = 0; i < 100; ++i) world.step(solver, Real(1) / 60);
    CHECK((world.bodies[0].position - Vec3(1, 2, 0)).norm() < 1e-3);
  }
  CHECK((places[0] - places[1]).norm() < 1e-12);
}

TEST_CASE("what is lit is at each contact: the normal from its point, the depth from surface to surface") {
  Played played;
  Live& live = played.live;
  live.go_to(30);
  const Contact& contact = live.world(0).contacts.front();
  const Vec3& eye = from_the_front.eye;
  const auto seen_at = [&](const Vec3& place, const Vec3& point) {
    return (place - eye).normalized().isApprox((point - eye).normalized(), Real(1e-9));
  };
  const auto lit = [&](Lit what) { return live.picture(0, from_the_front, {false, false, false, what}).arrows; };
  CHECK(lit(Lit::nothing).empty());
  const std::vector<Arrow> normals = lit(Lit::normals), depths = lit(Lit::depths), impulses = lit(Lit::impulses);
  const std::size_t contacts = live.world(0).contacts.size();
  CHECK(normals.size() == contacts);
  CHECK(depths.size() == 2 * contacts);
  CHECK(!impulses.empty());
  CHECK(seen_at(normals[0].tail, contact.point));
  CHECK((normals[0].tip - normals[0].tail).normalized().isApprox(contact.normal, Real(1e-9)));
  CHECK(seen_at(depths[0].tip, contact.point + contact.depth / 2 * contact.normal));
  CHECK(seen_at(depths[1].tip, contact.point - contact.depth / 2 * contact.normal));
  for (const Arrow& arrow : impulses) CHECK(arrow.colour == lit_colour());
}

TEST_CASE("what a parameter may not be is refused by name, and nothing changes") {
  Played played;
  Live& live = played.live;
  live.set("--boxes=3");
  live.go_to(10);
  const auto [assignments, words] = GENERATE(table<std::string, std::string>({
      {"--boxes=13", "--boxes: '13' is not allowed: a whole number from 1 to 12 is needed"},
      {"--boxes=2.5", "--boxes: '2.5' is not allowed"},
      {"--boxes=2,3", "--boxes: one number is needed"},
      {"--slop=", "--slop: at least one number is needed"},
      {"--slop=0.1", "from 0 to 0.05"},
      {"--slop=nan", "--slop: 'nan'"},
      {"--slop=0,0", "two variants are called"},
      {"--slop=0.001x", "--slop: '0.001x'"},
      {"--bounce=1", "there is no parameter '--bounce'"},
  }));
  std::string refusal;
  try {
    live.set(assignments);
  } catch (const InvalidInput& problem) {
    refusal = problem.what();
  }
  INFO(assignments << ": " << refusal);
  CHECK(contains(refusal, words));
  CHECK(played.told.boxes == 3);
  CHECK(played.told.slops.size() == 2);
  CHECK(live.world(0).bodies.size() == 4);
  live.go_to(10);
  CHECK(live.world(1).bodies.back().position.allFinite());
}

TEST_CASE("a variant that can go no further stays, and the others go on") {
  Experiment e("breaks", "?");
  const auto define = [&e] {
    e.scene({.name = "a ball", .fill = [](World& world) { world.add(sphere(1, 1)); }, .seconds = 1});
    e.motion("breaks", [](World& world, Real dt, int) {
      world.time += dt;
      if (world.time > Real(0.5)) throw InvalidInput("position is nan");
      world.bodies[0].position.x() += dt;
      return std::size_t{0};
    });
    e.variant("falls", FullSolver{});
  };
  Live live(e, define);
  live.go_to(60);
  CHECK(contains(live.mishap(0), "position is nan"));
  CHECK(live.mishap(1).empty());
  CHECK(live.samples(1).size() == 60);
  const std::size_t played = live.samples(0).size();
  const Real reached = live.world(0).bodies[0].position.x();
  CHECK(reached == Approx(static_cast<Real>(played) / 60));
  live.go_to(10);
  CHECK(live.world(0).bodies[0].position.x() == Approx(Real(10) / 60));
  live.go_to(60);
  CHECK(live.world(0).bodies[0].position.x() == reached);
}

namespace {

/// Two rows of which each feels half of the other, and half of what is wrong taken away by every iteration, nine times.
IteratedProblem halving(int& made) {
  ++made;
  IteratedProblem problem{.block_name = "pair", .iteration = "a half", .measure = "left"};
  problem.matrix.resize(2, 2);
  for (const int row : {0, 1})
    for (const int column : {0, 1}) problem.matrix.insert(row, column) = row == column ? 1 : Real(0.5);
  const Eigen::VectorXd solution = Eigen::VectorXd::Constant(2, 1 / 3.0);
  problem.residual = [solution](const Eigen::VectorXd& r) { return (r - solution).norm(); };
  problem.methods = {{"halves",
                      [solution](Eigen::VectorXd& r) {
                        r = (r + solution) / 2;
                        return true;
                      }},
                     {"nine", [solution, left = 9](Eigen::VectorXd& r) mutable {
                        if (left-- == 0) return false;
                        r = (r + solution) / 2;
                        return true;
                      }}};
  problem.most = 20;
  return problem;
}

}  // namespace

TEST_CASE("a problem is solved to and fro in the same bits, and a method that has ended stays there") {
  int made = 0;
  Iterated iterated(halving(made));
  CHECK(iterated.residuals(0).size() == 1);
  CHECK(iterated.impulses(0).isZero(0));
  std::vector<Eigen::VectorXd> seen{iterated.impulses(0)};
  for (int k = 1; k <= 20; ++k) {
    iterated.go_to(k);
    CHECK(iterated.residuals(0)[static_cast<std::size_t>(k)] == Approx(std::sqrt(2) / 3 / std::pow(2, k)));
    seen.push_back(iterated.impulses(0));
  }
  for (const int k : {19, 3, 0, 20, 7}) {
    iterated.go_to(k);
    CHECK(iterated.now() == k);
    CHECK(iterated.impulses(0) == seen[static_cast<std::size_t>(k)]);
    CHECK(iterated.impulses(1) == seen[static_cast<std::size_t>(std::min(k, 9))]);
  }
  CHECK(iterated.residuals(1).size() == 10);
  iterated.go_to(21);
  CHECK(iterated.now() == 20);
  iterated.go_to(-1);
  CHECK(iterated.now() == 0);
}

namespace {

/// What the solver does with a step, and what is left of it row by row after each sweep.
template <class ContactSolver>
void check_row_by_row(const World& world, const ContactSolver& solver) {
  constexpr int sweeps = 4;
  const RowByRow all = row_by_row(world, solver, Real(1) / 60, sweeps);
  REQUIRE((all.states.size() - 1) % sweeps == 0);
  const std::size_t a_sweep = (all.states.size() - 1) / sweeps;
  for (std::size_t count = 0; count <= sweeps; ++count) {
    World solved = world;
    ContactSolver(solver).solve(solved, Real(1) / 60, static_cast<int>(count));
    const RowByRow::State& state = all.states[count * a_sweep];
    CHECK(hash_of(state.world) == hash_of(solved));
    for (std::size_t i = 0; i < solved.contacts.size(); ++i)
      CHECK(state.world.contacts[i].impulse == solved.contacts[i].impulse);
  }
}

}  // namespace

TEST_CASE("a step that is solved row by row has the solver's own bits after each sweep") {
  World landing;
  stack(landing, 3, Real(-0.001));
  for (Body& body : landing.bodies)
    if (body.movable()) body.moving({1, -1, Real(0.5)});
  FullSolver full;
  landing.step(full, Real(1) / 60);
  landing.begin_step(Real(1) / 60);
  REQUIRE(landing.contacts.size() > 8);
  REQUIRE(landing.contacts[0].friction > 0);
  REQUIRE(landing.contacts_before.size() == 12);
  check_row_by_row(landing, full);
  check_row_by_row(landing, Solver<>{});
  check_row_by_row(landing, Solver<ClampingEachCorrection>{});
  check_row_by_row(on_two_corners(3, {1, 1, 1}, 1, {0, -1, 0}), Solver<Clamping>{});
}

TEST_CASE("solved row by row, a column that lands on two corners has the sums of chapter 02's table") {
  const auto sums = [](const auto& solver, std::size_t state) {
    const World world = on_two_corners(1, {Real(0.25), Real(0.75), Real(0.25)}, 1, {0, -1, 0});
    const RowByRow::State at = row_by_row(world, solver, Real(1) / 60, 2).states.at(state);
    return std::array{at.rows[0].impulse, at.rows[1].impulse, at.rows[0].speed, at.rows[1].speed};
  };
  const auto near = [](const std::array<Real, 4>& is, const std::array<Real, 4>& should) {
    for (std::size_t i = 0; i < 4; ++i) CHECK(std::abs(is[i] - should[i]) < 0.0006);
  };
  near(sums(Solver<Clamping>{}, 1), {0.769, 0, 0, -0.462});
  near(sums(Solver<Clamping>{}, 2), {0.769, 0.355, 0.249, 0});
  near(sums(Solver<Clamping>{}, 3), {0.578, 0.355, 0, -0.134});
  near(sums(Solver<Clamping>{}, 4), {0.578, 0.458, 0.072, 0});
  near(sums(Solver<ClampingEachCorrection>{}, 4), {0.769, 0.355, 0.249, 0});
}
