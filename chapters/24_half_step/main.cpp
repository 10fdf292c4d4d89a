#include "pushback/chapters/11_substeps/substeps.h"
#include "pushback/chapters/18_direct_joints/direct_joints.h"
#include "pushback/chapters/24_half_step/scenes.h"
#include "pushback/chapters/24_half_step/study.h"
#include "pushback/common/experiment/experiment.h"
#include "pushback/common/experiment/marks.h"

using namespace pushback;
using namespace pushback::half_step_scenes;

namespace {

using Whole = Solver<DirectJoints>;  // chapter 18: the order of chapter 11, joints solved directly

Real energy(const World& world) {
  return kinetic_energy(world) + potential_energy(world);
}

/// After each 1/60 s.
struct Truth {
  std::vector<Places> places;

  explicit Truth(const Motion& motion) : places(motion.truth(motion.frames())) {}
  const Places* at(Real time) const {
    const auto frames = static_cast<std::ptrdiff_t>(std::floor(time * frames_per_second + Real(1e-3)));
    return frames == 0 ? nullptr : &places[static_cast<std::size_t>(std::min(frames, std::ssize(places)) - 1)];
  }
  /// mm
  Real error(const World& world) const {
    double largest = 0;
    if (const Places* found = at(world.time))
      for (std::size_t i = 0; i < found->size(); ++i)
        largest = std::max(largest, (world.bodies[i].position.cast<double>() - (*found)[i]).norm());
    return static_cast<Real>(1000 * largest);
  }
  /// A line along each link, and a ring where the ball belongs.
  void mark(Picture& picture, const World& world, Real time) const {
    const Places* found = at(time);
    if (found == nullptr) return;
    Vec3 pin = Vec3::Zero();
    for (std::size_t i = 0; i < found->size(); ++i) {
      const Vec3 place = (*found)[i].cast<Real>();
      if (const auto* ball = std::get_if<Sphere>(&world.bodies[i].shape)) {
        add_ring(picture, place, (picture.camera.eye - picture.camera.target).normalized(), ball->radius);
      } else {
        const Vec3 end = 2 * place - pin;
        add_line(picture, {pin, end});
        pin = end;
      }
    }
  }
};

Curve curve(const std::string& label, std::size_t colour) {
  return {label, {}, {}, line_colour(colour), Curve::Style::line_and_points};
}

}  // namespace

int main(int argc, char** argv) {
  Experiment e("24_half_step", "What does it cost to be right to second order?");
  int substeps = 4;
  e.parameter({"--substeps", "", "", "Substeps in each step", 1, 64}, &substeps);
  return e.run(argc, argv, [&] {
    constexpr Real least_drawn = Real(1e-4);  // mm
    const auto measure_error = [&](const std::function<Real(const World&)>& error) {
      e.series("largest error", "mm", [=](const World& world) { return std::max(error(world), least_drawn); }, true);
      e.number("largest error", "mm", [=](const Run& run) {
        const auto& errors = run.series.at("largest error");
        const Real largest = *std::max_element(errors.begin(), errors.end());
        return largest > least_drawn ? largest : 0;
      });
    };

    const Top top;
    e.scene({.name = "a top on a pin",
             .fill = top,
             .camera = {{0, Real(1.3), Real(3.2)}, {0, Real(0.35), 0}},
             .seconds = 10,
             .instants = {9},
             .key = "top",
             .caption = "Thin ring and line: where the disc and its stem should be, by the closed form.",
             .start_shown = false,
             .marks =
                 [top](Picture& picture, const World&, Real time) {
                   const Vec3 axis = top.axis(time);
                   add_line(picture, {Vec3::Zero(), Real(1.4) * Top::stem * axis});
                   add_ring(picture, Top::stem * axis, axis, Top::half_width);
                 },
             .cell_height = 420});
    const auto off_the_cone = [top](const World& world) {
      return 1000 * (world.bodies[0].position - Top::stem * top.axis(world.time)).norm();
    };
    e.variant(fmt::format("whole step, {} substeps", substeps), Substeps(Whole{}, substeps)).with_exactly(1);
    e.variant(fmt::format("half step, {} substeps", substeps), in_substeps(substeps)).with_exactly(1);
    measure_error(off_the_cone);

    const Motion& chain = motion_named("chain");
    static const Truth of_chain(chain);  // takes its time, and no parameter changes it
    e.scene({.name = chain.title,
             .fill = [&chain](World& world) { chain.begin(world); },
             .camera = {{0, Real(-2.9), Real(10)}, {0, Real(-2.9), 0}},
             .seconds = 2,
             .instants = {Real(1.4)},
             .key = "chain",
             .caption = "Thin line: the true chain.",
             .start_shown = false,
             .marks = [](Picture& picture, const World& world, Real time) { of_chain.mark(picture, world, time); },
             .cell_height = 500});
    e.variant(fmt::format("whole step, {} substeps", substeps), Substeps(Whole{}, substeps)).with_exactly(1);
    e.variant(fmt::format("half step, {} substeps", substeps), in_substeps(substeps)).with_exactly(1);
    e.variant("order 4, 1 substep", in_substeps<Composed<Suzuki>>(1)).with_exactly(1);
    measure_error([](const World& world) { return of_chain.error(world); });

    const Motion& pendulum = motion_named("pendulum");
    e.scene({.name = "a ball on a pin, for a minute",
             .fill = [&pendulum](World& world) { pendulum.begin(world); },
             .seconds = 60,
             .pictures = false});
    e.variant("whole step", Whole{}).with_exactly(1).expect("energy at the end", 0).expect("energy off by up to", 0);
    e.variant("half step", HalfStep{}).with_exactly(1).expect("energy at the end", 0).expect("energy off by up to", 0);
    World begin;
    pendulum.begin(begin);
    const Real from = energy(begin);
    e.series_without_curves("energy",
                            [from](const World& world) { return 100 * (energy(world) - from) / std::abs(from); });
    e.number("energy at the end", "%", [](const Run& run) { return run.series.at("energy").back(); });
    e.number("energy off by up to", "%", [](const Run& run) {
      Real largest = 0;
      for (const Real off : run.series.at("energy")) largest = std::max(largest, std::abs(off));
      return largest;
    });

    for (const std::string name : {"sliding", "rolling", "stack-10", "bounce"}) {
      const Motion& motion = motion_named(name);
      static std::map<std::string, Truth> truths;
      const Truth& truth = truths.try_emplace(name, motion).first->second;
      e.scene({.name = motion.title,
               .fill = [&motion](World& world) { motion.begin(world); },
               .seconds = static_cast<Real>(motion.seconds),
               .pictures = false});
      e.variant("half step", in_substeps(1)).with_exactly(1);
      e.variant("half step, 8 substeps", in_substeps(8)).with_exactly(1);
      e.series_without_curves("largest error", [&truth](const World& world) { return truth.error(world); });
      e.number("largest error", "mm", [](const Run& run) {
        const auto& errors = run.series.at("largest error");
        const Real largest = *std::max_element(errors.begin(), errors.end());
        return largest > Real(1e-7) ? largest : 0;
      });
    }

    e.study([&e, &chain] {
      const auto truth = places_of_bob(composed_step, 64);
      std::vector<Curve> bob{curve("impulse along the new rod", 0), curve("whole step", 1),
                             curve("average of velocities", 2), curve("half step", 3), curve("order 4", 4)};
      for (const int count : {1, 2, 4, 8, 16}) {
        const auto add = [&](Curve& to, const auto& step) {
          to.x.push_back(static_cast<Real>(count));
          to.y.push_back(1000 * largest_distance(places_of_bob(step, count), truth));
        };
        add(bob[0], plain_24::new_rod_step);
        add(bob[1], plain_24::whole_step);
        add(bob[2], plain_24::average_step);
        add(bob[3], plain_24::half_step);
        add(bob[4], composed_step);
      }
      e.panel({.title = "a ball on a rod, five steps",
               .x_label = "substeps in 1/60 s",
               .y_label = "largest error, mm",
               .log_x = true,
               .log_y = true,
               .curves = bob});
      std::vector<Curve> links{curve("whole step", 1), curve("half step", 3), curve("order 4", 4)};
      for (const int count : {2, 4, 8, 16}) {
        const auto add = [&](Curve& to, const AnySolver& solver) {
          to.x.push_back(static_cast<Real>(count));
          to.y.push_back(1000 * largest_error(chain, of_chain.places, solver));
        };
        auto composed = in_substeps<Composed<Suzuki>>(count);
        composed.tolerance = Real(1e-12);  // or the rods' own error would be seen
        add(links[0], Substeps(Whole{}, count));
        add(links[1], in_substeps(count));
        add(links[2], composed);
      }
      e.panel({.title = "ten links and a hundredfold ball",
               .x_label = "substeps in 1/60 s",
               .y_label = "largest error, mm",
               .log_x = true,
               .log_y = true,
               .curves = links});
      for (const std::vector<Curve>* curves : {&bob, &links})
        for (const Curve& one : *curves)
          e.remark(fmt::format("{}, {}: {:.2f} times less for twice the substeps",
                               curves == &bob ? "a ball on a rod" : "ten links", one.label,
                               one.y.end()[-2] / one.y.back()));
    });
  });
}
