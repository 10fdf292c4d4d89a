#include <fmt/format.h>

#include <algorithm>

#include "pushback/chapters/19_accuracy_and_time/true_places.h"
#include "pushback/chapters/26_to_each_its_own/scenes.h"
#include "pushback/common/experiment/experiment.h"
#include "pushback/common/render/palette.h"

using namespace pushback;
using namespace pushback::to_each_its_own_scenes;

namespace {

Real all_of(const World& world) {
  return kinetic_energy(world) + potential_energy(world);
}

/// Without a restitution threshold, so that bounces at every speed are compared.
template <class Each>
Each at_every_speed() {
  Each solver;
  if constexpr (std::same_as<Each, IslandSolver>)
    solver.substep_solver.threshold = solver.contact_half_step.threshold = 0;
  else solver.threshold = 0;
  return solver;
}

/// A chain for ten seconds: the error of its energy, in % of Chain::fall, and the number of its half steps.
struct Played {
  Curve energy, substeps;
};
Played play(const Chain& chain, IslandSolver solver, const std::string& label, std::size_t colour) {
  World world;
  chain(world);
  const Real begin = all_of(world);
  Played played{{label, {}, {}, line_colour(colour)}, {label, {}, {}, line_colour(colour)}};
  while (world.time < 10) {
    world.step(solver, Real(1) / 60);
    played.energy.x.push_back(world.time);
    played.energy.y.push_back(100 * (all_of(world) - begin) / chain.fall());
    played.substeps.x.push_back(world.time);
    played.substeps.y.push_back(static_cast<Real>(solver.half_steps_of(0)));
  }
  return played;
}
Real largest_size(const Curve& curve) {
  Real largest = 0;
  for (const Real y : curve.y) largest = std::max(largest, std::abs(y));
  return largest;
}

}  // namespace

int main(int argc, char** argv) {
  Experiment e("26_to_each_its_own", "Which part of a scene calls for which step?");
  Yard yard;
  e.parameter({"--speed", "v", "m/s", "Speed of the ball that hits ten others", 0, 20}, &yard.speed);
  return e.run(argc, argv, [&] {
    const std::vector<std::pair<StepType, std::string>> ways{
        {StepType::flight, "in flight"}, {StepType::half_steps, "by half steps"}, {StepType::substeps, "by substeps"}};
    std::vector<std::pair<Ink, std::string>> colours;
    for (const auto& [how, name] : ways) colours.emplace_back(body_ink(colour_of(how)), name);
    e.scene({.name = "a yard",
             .fill =
                 [yard](World& world) {
                   yard(world);
                   for (Body& body : world.bodies)  // until the first step
                     if (body.movable()) body.coloured(5);
                 },
             .camera = {{Real(-0.4), Real(6.5), 17}, {Real(-0.4), Real(2.1), 0}},
             .seconds = Real(2.4),
             .instants = {Real(0.2), Real(0.8), Real(2.4)},
             .contacts = Drawn::nothing,
             .caption = "The colour of a body: how it was moved in the latest step.",
             .colours = colours,
             .start_shown = false});
    e.variant("by island", Painted{}).with_exactly(1).coloured(2);
    for (const auto& [how, name] : ways) {
      const std::string series = name + ", on average";
      e.series_without_curves(series,
                              [way = how](const World& world) { return static_cast<Real>(moved_so(world, way)); });
      e.number(series, "bodies", [series](const Run& run) { return run.mean(series); });
    }

    for (const Motion& motion : all_motions()) {
      const TruePlaces& truth = true_places_of(motion);
      e.scene({.name = motion.title,
               .fill = [&motion](World& world) { motion.begin(world); },
               .seconds = static_cast<Real>(motion.seconds),
               .pictures = false});
      e.variant("substeps", at_every_speed<WideSolver<Real>>()).with_exactly(1).coloured(0);
      e.variant("by island", at_every_speed<IslandSolver>()).with_exactly(1).coloured(2);
      const auto error = [&truth](const World& world) { return truth.error(world); };
      if (motion.name == "chain") e.series("error", "mm", error, true);
      else e.series_without_curves("error", error);
      e.number("largest error", "mm", [](const Run& run) { return run.largest("error"); });
    }

    e.study([&e, &yard, ways] {
      World world;
      yard(world);
      Painted solver;
      std::vector<Curve> moved;
      for (const auto& [how, name] : ways) {
        const Ink ink = body_ink(colour_of(how));
        const std::string colour = fmt::format("#{:02x}{:02x}{:02x}", ink.red, ink.green, ink.blue);
        moved.push_back({name, {}, {}, colour, Curve::Style::line, marker_of(moved.size())});
      }
      while (world.time < Real(2.4)) {
        world.step(solver, Real(1) / 60);
        for (std::size_t i = 0; i < ways.size(); ++i) {
          moved[i].x.push_back(world.time);
          moved[i].y.push_back(static_cast<Real>(moved_so(world, ways[i].first)));
        }
      }
      e.panel({.title = "a yard", .x_label = "s", .y_label = "bodies", .curves = moved});

      IslandSolver careless;
      careless.energy = Real(1e6);               // no step is repeated
      careless.joint_half_step.most_work = 1e7;  // and few fall back to substeps
      const Chain chain;
      const Played four = play(chain, careless, "four, always", 0), more = play(chain, {}, "as energy says", 2);
      const std::string title = "a chain that whips";
      e.panel({.title = title, .x_label = "s", .y_label = "energy off, %", .curves = {four.energy, more.energy}});
      e.panel({.title = title,
               .x_label = "s",
               .y_label = "substeps in 1/60 s",
               .log_y = true,
               .curves = {four.substeps, more.substeps}});
      for (const Played* played : {&four, &more})
        e.remark(fmt::format("{}, substeps {}: energy off by up to {:.2g} %", title, played->energy.label,
                             largest_size(played->energy)));
    });
  });
}
