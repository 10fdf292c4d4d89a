#include "chapters/07_warm_start/full_solver.h"
#include "chapters/09_joints/split_joints.h"
#include "chapters/14_accuracy_and_time/motion.h"
#include "common/experiment.h"

using namespace pushback;

namespace {

/// Puts every body where it belongs.
struct Truth {
  std::vector<Places> places;
  Rows none = {};

  Truth(const Motion& motion) : places(motion.truth(motion.frames())) {}
  /// Those of the latest whole frame that is over.
  const Places* at(Real time) const {
    const auto frames = static_cast<std::ptrdiff_t>(std::floor(time * frames_per_second + Real(1e-3)));
    return frames == 0 ? nullptr : &places[static_cast<std::size_t>(std::min(frames, std::ssize(places)) - 1)];
  }
  void step(World& world, Real dt, int) {
    world.time += dt;
    if (const Places* found = at(world.time))
      for (std::size_t i = 0; i < found->size(); ++i) world.bodies[i].position = (*found)[i].cast<Real>();
  }
  const Rows& rows() const { return none; }
  /// mm, of the body that is farthest from where it belongs.
  Real error(const World& world) const {
    double largest = 0;
    if (const Places* found = at(world.time))
      for (std::size_t i = 0; i < found->size(); ++i)
        largest = std::max(largest, (world.bodies[i].position.cast<double>() - (*found)[i]).norm());
    return static_cast<Real>(1000 * largest);
  }
};

}  // namespace

int main(int argc, char** argv) {
  Experiment e("14_accuracy_and_time", "What does accuracy cost?");
  return e.run(argc, argv, [&] {
    const auto measure_error = [&](const Truth& truth) {
      e.series(
          "largest error", "mm", [truth](const World& world) { return std::max(truth.error(world), Real(1e-3)); },
          true);
      e.number("largest error", "mm", [](const Run& run) {
        const auto& errors = run.series.at("largest error");
        return *std::max_element(errors.begin(), errors.end());
      });
    };

    const Motion& billiards = motion_named("break");
    e.scene({.name = billiards.title,
             .fill = billiards.fill,
             .camera = {{Real(0.4), Real(4.2), Real(1.6)}, {Real(0.4), 0, 0}},
             .seconds = Real(0.6),
             .instants = {0, Real(0.25), Real(0.4), Real(0.6)}});
    using Balls = Solver<Clamping, Restitution>;
    const Truth of_balls(billiards);
    e.variant("as it should be", of_balls);
    for (const int count : {1, 16, 256})
      e.variant(fmt::format("{} small steps", count), Balls{}).in_small_steps(count).with_exactly(1);
    measure_error(of_balls);

    const Motion& chain = motion_named("chain");
    e.scene({.name = chain.title,
             .fill = [&](World& world) { chain.begin(world); },
             .camera = {{Real(0), Real(-2.6), Real(10)}, {Real(0), Real(-2.6), 0}},
             .seconds = 2,
             .instants = {0, Real(0.7), Real(1.4), 2}});
    using Chain = Solver<SplitJoints>;
    const Truth of_chain(chain);
    e.variant("as it should be", of_chain);
    for (const auto& [count, sweeps] : {std::pair{1, 64}, {4, 16}, {16, 4}, {64, 1}})
      e.variant(fmt::format("{} small steps, {} sweeps", count, sweeps), Chain{})
          .in_small_steps(count)
          .with_exactly(sweeps);
    measure_error(of_chain);
  });
}
