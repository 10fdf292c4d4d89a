#include "pushback/chapters/04_slop/scenes.h"
#include "pushback/chapters/04_slop/slop.h"
#include "pushback/common/experiment/experiment.h"

using namespace pushback;
using namespace pushback::slop_scenes;

namespace {

/// Marks the contact points that the step before already had. (Chapter 07 will have a better use for them.)
struct MarkOld : Effect {
  std::vector<ContactId> before;
  void report(Step& step) {
    std::vector<ContactId> now;
    for (Contact& contact : step.contacts) {
      const bool old = std::binary_search(before.begin(), before.end(), contact.id);
      contact.state = old ? ContactState::warm : ContactState::fresh;
      now.push_back(contact.id);
    }
    before = std::move(now);
  }
};

Real found_and_lost_each_second(const Run& run) {
  Real changes = 0;
  const std::vector<Sample> last = run.last(2);
  for (const Sample& sample : last) changes += static_cast<Real>(sample.found + sample.lost);
  return changes / (static_cast<Real>(last.size()) * run.dt);
}

/// Mean overlap of the last second, mm.
Real resting_depth(const Run& run) {
  Real sum = 0;
  const std::vector<Sample> last = run.last(1);
  for (const Sample& sample : last) sum += sample.overlap;
  return 1000 * sum / static_cast<Real>(last.size());
}

}  // namespace

int main(int argc, char** argv) {
  Experiment e("04_slop", "Why leave a little overlap alone?");
  std::vector<Real> slops{0, Real(0.005), Real(0.02)};
  e.parameter({"--slop", "slop", "m", "Overlaps to leave alone", 0, 0.1}, &slops);
  Real beta = Baumgarte{}.beta;
  e.parameter({"--beta", "β", "", "How much of what exceeds the slop one step takes away", 0, 1}, &beta);
  SmallPile pile;
  e.parameter({"--depth", "", "m", "How deep each box is in what it lies on at the start", 0, 0.05}, &pile.depth);
  return e.run(argc, argv, [&] {
    const Real h = e.dt();
    // Consecutive steps: what flickers in the motion stands side by side here.
    e.scene({.name = "three boxes at rest",
             .fill = pile,
             .camera = {{Real(2.6), Real(2.2), Real(4.2)}, {0, Real(0.85), 0}},
             .seconds = 4,
             .instants = {3, 3 + h, 3 + 2 * h, 3 + 3 * h}});
    for (const Real slop : slops) {
      Solver<Clamping, Baumgarte, Slop, MarkOld> solver;
      solver.slop = slop;
      solver.beta = beta;
      e.variant(fmt::format("slop = {:.3g} mm", 1000 * slop), solver).with_sweeps(40);
    }
    e.series("contact points", "", [](const World& world) { return static_cast<Real>(world.contacts.size()); });
    e.series("deepest overlap", "mm", [](const World& world) { return 1000 * deepest_overlap(world); });
    e.number("points found or lost", "each second", found_and_lost_each_second);
    e.number("resting depth", "mm", resting_depth);
  });
}
