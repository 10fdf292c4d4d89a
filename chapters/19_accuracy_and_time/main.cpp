#include "pushback/chapters/05_restitution/restitution.h"
#include "pushback/chapters/11_substeps/study.h"
#include "pushback/chapters/13_joints/joints.h"
#include "pushback/chapters/19_accuracy_and_time/true_places.h"
#include "pushback/common/experiment/experiment.h"
#include "pushback/common/experiment/marks.h"

using namespace pushback;
using namespace pushback::substeps_scenes;

namespace {

/// Draws a ring at the true place of each ball and a line along each link from pin to pin.
void mark(const TruePlaces& truth, Picture& picture, const World& world, Real time) {
  const Places* found = truth.at(time);
  if (found == nullptr) return;
  const Vec3 towards = (picture.camera.eye - picture.camera.target).normalized();
  Vec3 pin = Vec3::Zero();
  for (std::size_t i = 0; i < found->size(); ++i) {
    const Vec3 place = (*found)[i].cast<Real>();
    if (const auto* ball = std::get_if<Sphere>(&world.bodies[i].shape)) {
      add_ring(picture, place, towards, ball->radius);
    } else {
      const Vec3 end = 2 * place - pin;
      add_line(picture, {pin, end});
      pin = end;
    }
  }
}

}  // namespace

int main(int argc, char** argv) {
  Experiment e("19_accuracy_and_time", "What does accuracy cost?");
  std::vector<int> steps_of_balls{1, 16, 256}, steps_of_chain{1, 4, 16};
  e.parameter({"--ball-steps", "", "", "Substeps per step for the balls", 1, 1024}, &steps_of_balls);
  e.parameter({"--chain-steps", "", "", "Substeps per step for the chain", 1, 16}, &steps_of_chain);
  return e.run(argc, argv, [&] {
    constexpr Real least_drawn = Real(1e-3);  // mm
    const auto measure_error = [&](const TruePlaces& truth) {
      e.series(
          "largest error", "mm", [=](const World& world) { return std::max(truth.error(world), least_drawn); }, true);
      e.number("largest error", "mm", [=](const Run& run) {
        const Real largest = run.largest("largest error");
        return largest > least_drawn ? largest : 0;
      });
    };
    const auto counted = [](int count, const std::string& what) {
      return fmt::format("{} {}{}", count, what, count == 1 ? "" : "s");
    };

    const auto ghosts = [](const TruePlaces& truth) {
      return [truth](Picture& picture, const World& world, Real time) { mark(truth, picture, world, time); };
    };

    const Motion& billiards = motion_named("break");
    static const TruePlaces of_balls(billiards);  // slow, and no parameter changes it
    e.scene({.name = billiards.title,
             .fill = billiards.fill,
             .camera = {{Real(0.55), Real(3.3), Real(1)}, {Real(0.55), 0, 0}},
             .seconds = Real(0.6),
             .instants = {Real(0.5)},
             .key = "break",
             .caption = "Rings: where each ball should be. With which steps do the balls lie in their rings?",
             .start_shown = false,
             .marks = ghosts(of_balls),
             .cell_height = 400});
    int colour = 0;
    for (const int steps : steps_of_balls)
      e.variant(counted(steps, "step") + " in 1/60 s", Substeps(Solver<Clamping, Restitution>{}, steps))
          .with_exactly(1)
          .coloured(colour++);
    measure_error(of_balls);

    const Motion& chain = motion_named("chain");
    static const TruePlaces of_chain(chain);
    e.scene(
        {.name = chain.title,
         .fill = [&](World& world) { chain.begin(world); },
         .camera = {{0, Real(-2.9), Real(10)}, {0, Real(-2.9), 0}},
         .seconds = 2,
         .instants = {Real(1.4)},
         .key = "chain",
         .caption = "Thin line: the true chain. All three do 16 sweeps in 1/60 s; they differ in the number of steps.",
         .start_shown = false,
         .marks = ghosts(of_chain),
         .cell_height = 500});
    colour = 0;
    for (const int steps : steps_of_chain)
      e.variant(counted(steps, "step") + " of " + counted(16 / steps, "sweep"), Substeps(Solver<Joints>{}, steps))
          .with_exactly(16 / steps)
          .coloured(colour++);
    measure_error(of_chain);
  });
}
