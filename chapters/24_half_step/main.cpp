#include "pushback/chapters/11_substeps/substeps.h"
#include "pushback/chapters/19_accuracy_and_time/true_places.h"
#include "pushback/chapters/24_half_step/on_floor.h"
#include "pushback/chapters/24_half_step/study.h"
#include "pushback/chapters/24_half_step/top.h"
#include "pushback/common/experiment/experiment.h"
#include "pushback/common/experiment/marks.h"
#include "pushback/common/render/palette.h"
#include "pushback/engine/direct/direct_joints.h"

using namespace pushback;
using namespace pushback::half_step_scenes;

namespace {

using Whole = Solver<DirectJoints>;  // chapter 18: the order of chapter 11, joints solved directly

constexpr Real least_tolerance = std::numeric_limits<Real>::digits > 24 ? Real(1e-12) : Real(2e-6);

Real energy(const World& world) {
  return kinetic_energy(world) + potential_energy(world);
}

/// The true motion of a pendulum, in far finer steps than those of the solvers compared with it.
class Fine {
 public:
  explicit Fine(const Motion& motion) {
    motion.begin(world_);
    auto step = in_substeps(4, composed());
    step.tolerance = least_tolerance;
    for (int frame = 0; frame <= 60 * frames_per_second; ++frame) {
      places_.push_back(world_.bodies[0].position);
      world_.step(step, Real(1) / frames_per_second);
    }
  }
  Vec3 place(Real time) const {
    const auto frame = static_cast<std::size_t>(std::max(Real(0), std::round(time * frames_per_second)));
    return places_[std::min(frame, places_.size() - 1)];
  }

 private:
  World world_;
  std::vector<Vec3> places_;
};

Real largest_size(const std::vector<Real>& values) {
  Real largest = 0;
  for (const Real value : values) largest = std::max(largest, std::abs(value));
  return largest;
}

Curve curve(const std::string& label, std::size_t colour) {
  return {label, {}, {}, line_colour(colour), Curve::Style::line_and_points};
}

}  // namespace

int main(int argc, char** argv) {
  Experiment e("24_half_step", "Why is x += h v wrong by h/2, and what does it cost to be right?");
  int substeps = 4;
  e.parameter({"--substeps", "", "", "Substeps per step for the top and chain", 1, 64}, &substeps);
  return e.run(argc, argv, [&] {
    constexpr Real least_drawn = Real(1e-4);  // mm
    const auto measure_error = [&](const std::function<Real(const World&)>& error, bool drawn) {
      if (drawn) {
        e.series("largest error", "mm", [=](const World& world) { return std::max(error(world), least_drawn); }, true);
      } else {
        e.series_without_curves("largest error", error);
      }
      e.number("largest error", "mm", [=](const Run& run) {
        const Real largest = run.largest("largest error");
        return largest > (drawn ? least_drawn : Real(1e-7)) ? largest : 0;
      });
    };

    const auto by_each_step = [&] {
      e.variant(fmt::format("whole step, {} substeps", substeps), Substeps(Whole{}, substeps))
          .with_exactly(1)
          .coloured(0);
      e.variant(fmt::format("half step, {} substeps", substeps), in_substeps(substeps)).with_exactly(1).coloured(1);
      e.variant(fmt::format("order 4, {} substeps", substeps), in_substeps(substeps, composed()))
          .with_exactly(1)
          .coloured(2);
    };

    const Motion& pendulum = motion_named("pendulum");
    static const auto fine = std::make_shared<const Fine>(pendulum);  // no parameter changes it
    e.scene({.name = "a ball on a pin, for a minute",
             .fill = [&pendulum](World& world) { pendulum.begin(world); },
             .camera = {{0, Real(-0.25), Real(2.2)}, {0, Real(-0.25), 0}},
             .seconds = 60,
             .instants = {5, 20, 60},
             .caption = "Ring: where the ball should be. Dot: the pin. All three take one step in 1/60 s.",
             .start_shown = false,
             .marks =
                 [](Picture& picture, const World& world, Real time) {
                   add_line(picture, {Vec3::Zero(), world.bodies[0].position}, near_black_colour());
                   add_ring(picture, Vec3::Zero(), Vec3::UnitZ(), Real(0.012), near_black_colour(), 8);
                   add_ring(picture, fine->place(time), Vec3::UnitZ(), Real(0.3));
                 },
             .cell_height = 360});
    const auto keeps_its_energy = [](Variant& variant, int colour) {
      variant.with_exactly(1).coloured(colour).expect("energy at the end", 0).expect("energy off by up to", 0);
    };
    keeps_its_energy(e.variant("whole step", Whole{}), 0);
    keeps_its_energy(e.variant("half step", HalfStep{}), 1);
    keeps_its_energy(e.variant("order 4", composed()), 2);
    World begin;
    pendulum.begin(begin);
    const Real from = energy(begin);
    e.series("energy", "%", [from](const World& world) { return 100 * (energy(world) - from) / std::abs(from); });
    e.series_without_curves(
        "off", [](const World& world) { return 1000 * (world.bodies[0].position - fine->place(world.time)).norm(); });
    e.number("energy at the end", "%", [](const Run& run) { return run.series.at("energy").back(); });
    e.number("energy off by up to", "%", [](const Run& run) { return largest_size(run.series.at("energy")); });
    e.number("largest error", "mm", [](const Run& run) { return largest_size(run.series.at("off")); });

    const Motion& chain = motion_named("chain");
    const TruePlaces& of_chain = true_places_of(chain);
    e.scene(
        {.name = chain.title, .fill = [&chain](World& world) { chain.begin(world); }, .seconds = 2, .pictures = false});
    by_each_step();
    measure_error([&of_chain](const World& world) { return of_chain.error(world); }, true);

    const Top top;
    e.scene({.name = "a top on a pin", .fill = top, .seconds = 10, .pictures = false});
    by_each_step();
    measure_error(
        [top](const World& world) {
          return 1000 * (world.bodies[0].position - Top::stem * top.axis(world.time)).norm();
        },
        false);

    for (const std::string name : {"sliding", "rolling", "stack-10", "bounce"}) {
      const Motion& motion = motion_named(name);
      const TruePlaces& truth = true_places_of(motion);
      e.scene({.name = motion.title,
               .fill = [&motion](World& world) { motion.begin(world); },
               .seconds = static_cast<Real>(motion.seconds),
               .pictures = false});
      e.variant("half step", in_substeps(1)).with_exactly(1).coloured(1);
      e.variant("half step, 8 substeps", in_substeps(8)).with_exactly(1).coloured(3);
      measure_error([&truth](const World& world) { return truth.error(world); }, false);
    }

    const OnFloor round{Real(0.2)};
    e.scene(
        {.name = "a ball on a rod slides round on a floor", .fill = round, .seconds = Real(0.5), .pictures = false});
    e.variant("half step", in_substeps(1)).with_exactly(1).coloured(1);
    e.variant("half step, 8 substeps", in_substeps(8)).with_exactly(1).coloured(3);
    measure_error(
        [round](const World& world) { return 1000 * (world.bodies[1].position - round.place(world.time)).norm(); },
        false);

    e.study([&e, &chain, &of_chain] {
      const auto truth = places_of_bob(composed_step, 64);
      std::vector<Curve> bob{curve("impulse along the new rod", 4), curve("whole step", 0),
                             curve("average of velocities", 3), curve("half step", 1), curve("order 4", 2)};
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
      std::vector<Curve> links{curve("whole step", 0), curve("half step", 1), curve("order 4", 2)};
      for (const int count : {2, 4, 8, 16}) {
        const auto add = [&](Curve& to, const AnySolver& solver) {
          to.x.push_back(static_cast<Real>(count));
          to.y.push_back(1000 * largest_error(chain, of_chain.places, solver));
        };
        HalfStep fourth = in_substeps(count, composed());
        fourth.tolerance = least_tolerance;  // otherwise the error of the rods' lengths would be seen
        add(links[0], Substeps(Whole{}, count));
        add(links[1], in_substeps(count));
        add(links[2], fourth);
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
