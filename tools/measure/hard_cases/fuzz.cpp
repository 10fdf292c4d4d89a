#include "pushback/tools/measure/hard_cases/fuzz.h"

#include "pushback/chapters/07_warm_start/full_solver.h"
#include "pushback/chapters/07_warm_start/scaled.h"
#include "pushback/chapters/12_soft_contacts/soft_contacts.h"
#include "pushback/common/world/forwarding_solver.h"
#include "pushback/common/world/measure.h"
#include "pushback/engine/islands/island_solver.h"
#include "pushback/engine/substeps/wide_solver.h"
#include "pushback/tools/catalogue/solvers.h"
#include "pushback/tools/measure/hard_cases/ledger.h"
#include "pushback/tools/measure/hard_cases/momentum_account.h"
#include "pushback/tools/measure/hard_cases/watcher.h"

namespace pushback {

namespace {

constexpr int steps = 60;

using BookedFullSolver =
    BookedSolver<Solver, Clamping, Baumgarte, Slop, Restitution, Booked<Friction>, WarmStart, Bookkeeper>;
using BookedSoftSolver =
    BookedSolver<RelaxingSolver, Clamping, SoftContacts, Restitution, Booked<Friction>, WarmStart, RelaxingBookkeeper>;
using BookedAllTogether = BookedSolver<RelaxingSolver, Clamping, SoftContacts, SimultaneousImpacts,
                                       Booked<FrictionCone>, ScaledWarmStart, RelaxingBookkeeper>;

void print_scene(const RandomScene& scene) {
  const Vec3& g = scene.world.gravity;
  fmt::print("dt {:.9g} s, gravity ({:.6g}, {:.6g}, {:.6g}) m/s^2{}\n", scene.dt, g.x(), g.y(), g.z(),
             scene.isolated ? ", isolated" : "");
  struct Name {
    std::string operator()(const Sphere& s) const { return fmt::format("sphere {:.6g}", s.radius); }
    std::string operator()(const Box& b) const {
      return fmt::format("box {:.6g} x {:.6g} x {:.6g}", b.half_extents.x(), b.half_extents.y(), b.half_extents.z());
    }
    std::string operator()(const Capsule& c) const {
      return fmt::format("capsule {:.6g}, {:.6g}", c.radius, c.half_length);
    }
    std::string operator()(const HalfSpace&) const { return "half-space"; }
    std::string operator()(const Hull& h) const { return fmt::format("hull of {} corners", h.solid->corners.size()); }
  };
  for (const Body& body : scene.world.bodies) {
    fmt::print("  {:>2} {:<44} 1/m {:<10.4g} mu {:<7.3g} e {:<6.3g} |v| {:<8.3g} |w| {:.3g}\n", body.index,
               std::visit(Name{}, body.shape), body.inverse_mass, body.friction, body.restitution, body.velocity.norm(),
               body.angular_velocity.norm());
  }
}

/// Around a stage's solver: what must hold within a step.
class Felt : public ForwardingSolver {
 public:
  Felt(StepSolver& solver, Watcher& watcher) : solver_(solver), watcher_(watcher) {}
  void solve(World& world, Real h, int sweeps) override {
    solver_.solve(world, h, sweeps);
    watcher_.feel(world);
    before_ = world.bodies;
  }
  void after_move(World& world, Real h) override {
    if (broken.empty()) broken = flown(world);
    solver_.after_move(world, h);
  }
  std::string broken;

 private:
  StepSolver& inner() override { return solver_; }
  const StepSolver& inner() const override { return solver_; }
  /// What flies and turns freely keeps its kinetic energy, each body by itself.
  std::string flown(const World& world) const {
    for (std::size_t i = 0; i < before_.size(); ++i) {
      const Body& body = world.bodies[i];
      if (!body.movable()) continue;
      const Real old_energy = before_[i].angular_velocity.dot(spin_momentum(before_[i])) / 2;
      const Real energy = body.angular_velocity.dot(spin_momentum(body)) / 2;
      const Vec3& inverse = body.principal_inverse_inertia;
      const Real uneven = inverse.minCoeff() > 0 ? inverse.maxCoeff() / inverse.minCoeff() : 1;
      const Real rounding = std::numeric_limits<Real>::epsilon() * (2e4 + 100 * uneven);
      if (!(std::abs(energy - old_energy) <= rounding * old_energy)) {
        return fmt::format("body {} had {:.9g} J of spin and has {:.9g} J after turning freely", i, old_energy, energy);
      }
    }
    return {};
  }

  StepSolver& solver_;
  Watcher& watcher_;
  std::vector<Body> before_;  // as they were when they began to move
};

/// Energy is the ledger's, and overlaps are what they are.
Watcher watcher_of(const RandomScene& scene) {
  constexpr Real any = std::numeric_limits<Real>::infinity();
  return {scene.world, {.energy = any, .overlap = any, .isolated = scene.isolated}};
}

/// Each step is cut into so many parts from outside, and by the solver into so many. `within`: what is wrong within a step.
template <class Within>
FuzzResult watched(const RandomScene& scene, Watcher& watcher, StepSolver& solver, int parts, int sweeps, int substeps,
                   bool log, const Within& within) {
  if (log) print_scene(scene);
  World world = scene.world;
  const Real dt = scene.dt / static_cast<Real>(parts);
  FuzzResult finding;
  for (int step = 1; step <= steps && finding.broken.empty(); ++step) {
    for (int i = 0; i < parts && finding.broken.empty(); ++i) {
      world.step(solver, dt, sweeps);
      finding.broken = within();
      watcher.look(world, dt, substeps);
      if (finding.broken.empty()) finding.broken = watcher.broken();
    }
    finding.step = step;
    if (log)
      fmt::print("{:>3}  T {:<13.6g} |p| {:<13.6g} |L| {:<13.6g} {:>3} contacts, {:.4g} m deep  {}\n", step,
                 kinetic_energy(world), momentum(world).norm(), angular_momentum(world).norm(), world.contacts.size(),
                 deepest_overlap(world), finding.broken);
  }
  finding.hash = hash_of(world);
  return finding;
}

/// A solver that keeps books, in steps that are cut from outside.
template <class ContactSolver, int parts, int sweeps>
FuzzResult with_books(const RandomScene& scene, bool log) {
  Watcher watcher = watcher_of(scene);
  Ledger ledger;
  ContactSolver solver(ledger);
  Felt felt(solver, watcher);
  return watched(scene, watcher, felt, parts, sweeps, 1, log,
                 [&] { return felt.broken.empty() ? ledger.broken : felt.broken; });
}

/// A solver that divides its steps itself: within them, the world after each substep is felt.
template <class Full>
struct FeltWhole : Full {
  Watcher* watcher = nullptr;
  void solve(World& world, Real h, int sweeps) override {
    Full::solve(world, h, sweeps);
    feel(world);
  }
  void after_move(World& world, Real h) override {
    Full::after_move(world, h);
    feel(world);
  }

 private:
  void feel(World& world) {
    for (std::size_t i = 0; i < world.contacts.size(); ++i) {
      Full::write_back(world.contacts[i], i);
      world.contacts[i].impulse = world.contacts[i].last_impulse;  // of this substep
    }
    watcher->feel(world);
  }
};
/// Each island by its own step: within that of the many, too, is felt.
struct FeltIslands : IslandSolver {
  FeltWhole<WideSolver<Real>> felt;

 private:
  StepSolver& inner() override { return felt; }
  const StepSolver& inner() const override { return felt; }
};
/// A solver that divides its steps itself, by `felt`.
FuzzResult felt_within(const RandomScene& scene, bool log, StepSolver& solver, FeltWhole<WideSolver<Real>>& felt) {
  Watcher watcher = watcher_of(scene);
  felt.watcher = &watcher;
  return watched(scene, watcher, solver, 1, solver.plan(scene.dt).sweeps, felt.substeps, log,
                 [] { return std::string(); });
}
FuzzResult wide(const RandomScene& scene, bool log) {
  FeltWhole<WideSolver<Real>> solver;
  return felt_within(scene, log, solver, solver);
}
FuzzResult islands(const RandomScene& scene, bool log) {
  FeltIslands solver;
  return felt_within(scene, log, solver, solver.felt);
}

struct FuzzedStage {
  const char* name;
  FuzzResult (*watched)(const RandomScene& scene, bool log);
};
constexpr FuzzedStage watched_within[] = {{"07 warm start", with_books<BookedFullSolver, 1, 10>},
                                          {"11 substeps", with_books<BookedFullSolver, 32, 1>},
                                          {"12 soft contacts", with_books<BookedSoftSolver, 32, 1>},
                                          {"22 wide", wide},
                                          {"26 by island", islands},
                                          {"all together", with_books<BookedAllTogether, 32, 1>}};

/// Of any solver: what it says it did.
FuzzResult accounted(const RandomScene& scene, const NamedSolver& named) {
  World world = scene.world;
  AnySolver solver = named.solver;
  MomentumAccount account(world);
  FuzzResult finding;
  for (int step = 1; step <= steps && finding.broken.empty(); ++step) {
    world.step(solver, scene.dt);
    finding.step = step;
    if (finite(world)) finding.broken = account.look(world, scene.dt);
    else if (named.name != "00 naive") finding.broken = "not finite";
    else break;  // chapter 00 says so itself
  }
  finding.hash = hash_of(world);
  return finding;
}

}  // namespace

std::vector<std::string> fuzzed_stages() {
  std::vector<std::string> all;
  for (const NamedSolver& solver : all_solvers()) all.push_back(solver.name);
  return all;
}

FuzzResult fuzz(const RandomScene& scene, const std::string& stage, bool log) {
  const NamedSolver& solver = solver_named(stage);
  try {
    FuzzResult finding = accounted(scene, solver);
    for (const FuzzedStage& one : watched_within)
      if (finding.broken.empty() && one.name == stage) return one.watched(scene, log);
    return finding;
  } catch (const InvalidInput& refused) {  // a part of a step began from what the part before had left
    FuzzResult finding;
    finding.broken = refused.what();
    return finding;
  }
}

}  // namespace pushback
