/// The whole solver of each chapter as a plain loop, and the one composed of effects: the same bits.
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
#include "pushback/common/bodies/random.h"
#include "pushback/common/world/measure.h"
#include "pushback/tools/catalogue/catalogue.h"
#include "tests/support/catch.h"

using namespace pushback;

namespace {

struct Settings {
  Real beta = Real(0.2), slop = Real(0.005), threshold = Real(0.1);
};

using Stepper = std::function<void(World&, Real dt, int sweeps)>;

/// Steps by this solver, with those of the settings that it has.
template <class ContactSolver>
Stepper by(const Settings& settings) {
  ContactSolver solver;
  if constexpr (requires { solver.beta; }) solver.beta = settings.beta;
  if constexpr (requires { solver.slop; }) solver.slop = settings.slop;
  if constexpr (requires { solver.threshold; }) solver.threshold = settings.threshold;
  return [solver](World& world, Real dt, int sweeps) mutable { world.step(solver, dt, sweeps); };
}

struct Chapter {
  const char* name;
  Stepper (*composed)(const Settings&);
  Stepper (*flat)(const Settings&);
};

const Chapter chapters[] = {
    {"01", by<Solver<>>, by<flat_01::FlatSolver>},
    {"02", by<Solver<Clamping>>, by<flat_02::FlatSolver>},
    {"03", by<Solver<Clamping, Baumgarte>>, by<flat_03::FlatSolver>},
    {"04", by<Solver<Clamping, Baumgarte, Slop>>, by<flat_04::FlatSolver>},
    {"05", by<Solver<Clamping, Baumgarte, Slop, Restitution>>, by<flat_05::FlatSolver>},
    {"06", by<Solver<Clamping, Baumgarte, Slop, Restitution, Friction>>, by<flat_06::FlatSolver>},
    {"07", by<FullSolver>, by<flat_07::FlatSolver>},
    {"08", by<Solver<Clamping, Baumgarte, Slop, Restitution, FrictionCone, WarmStart>>, by<flat_08::FlatSolver>},
};

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

/// The pile, and every scene of the chapters without joints.
std::vector<NamedScene> scenes() {
  std::vector<NamedScene> all = all_scenes();
  std::erase_if(all, [](const NamedScene& scene) {
    World world;
    scene.fill(world);
    return !world.joints.empty();
  });
  all.push_back({"pile", pile});
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
  for (int step = 1; step <= steps; ++step) {
    one(world, dt_of(step), sweeps_of(step));
    other(same, dt_of(step), sweeps_of(step));
    if (hash_of(world) != hash_of(same) || !std::ranges::equal(world.contacts, same.contacts, same_bits)) return step;
  }
  return 0;
}
/// In steps of 1/60 s with 10 sweeps.
int first_difference(const Fill& fill, Stepper one, Stepper other, int steps) {
  return first_difference(
      fill, std::move(one), std::move(other), steps, [](int) { return Real(1) / 60; }, [](int) { return 10; });
}

}  // namespace

TEST_CASE("in every scene without joints, each chapter's plain loop has the bits of its composed solver") {
  for (const Chapter& chapter : chapters) {
    for (const NamedScene& scene : scenes()) {
      INFO(chapter.name << ", " << scene.name);
      CHECK(first_difference(scene.fill, chapter.composed({}), chapter.flat({}), 120) == 0);
    }
  }
}

TEST_CASE("in steps of changing length, from no sweep to 30: likewise") {
  const auto dt_of = [](int step) { return Real(1) / static_cast<Real>(60 + 30 * (step % 7)); };
  const auto sweeps_of = [](int step) { return step % 31; };
  for (const Chapter& chapter : chapters) {
    INFO(chapter.name);
    CHECK(first_difference(pile, chapter.composed({}), chapter.flat({}), 300, dt_of, sweeps_of) == 0);
  }
}

TEST_CASE("with other settings: likewise") {
  for (const Settings& settings : {Settings{0, 0, 0}, Settings{Real(0.6), Real(0.01), 1}, Settings{1, 0, Real(0.3)}}) {
    for (const Chapter& chapter : chapters) {
      INFO(chapter.name << ", beta = " << settings.beta);
      CHECK(first_difference(pile, chapter.composed(settings), chapter.flat(settings), 300) == 0);
    }
  }
}

TEST_CASE("and each chapter is told apart from the one before it") {
  for (std::size_t i = 1; i < std::size(chapters); ++i) {
    INFO(chapters[i].name);
    CHECK(first_difference(pile, chapters[i - 1].composed({}), chapters[i].flat({}), 300) > 0);
  }
}

TEST_CASE("as is a slop that differs in its last bit") {
  Settings other;
  other.slop = std::nextafter(other.slop, Real(1));
  CHECK(first_difference(pile, chapters[6].composed({}), chapters[6].flat(other), 300) > 0);
}

TEST_CASE("the pile has contacts that are new, slide, and stick") {
  World world;
  pile(world);
  FullSolver solver;
  int fresh = 0, sliding = 0, sticking = 0;
  for (int step = 0; step < 300; ++step) {
    world.step(solver, Real(1) / 60);
    for (const Contact& contact : world.contacts) {
      fresh += contact.state == ContactState::fresh;
      sliding += contact.state == ContactState::sliding;
      sticking += contact.state == ContactState::sticking;
    }
  }
  CHECK(fresh > 100);
  CHECK(sliding > 100);
  CHECK(sticking > 100);
}
