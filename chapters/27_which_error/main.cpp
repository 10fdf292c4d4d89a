#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "pushback/chapters/19_accuracy_and_time/true_places.h"
#include "pushback/chapters/27_which_error/scenes.h"
#include "pushback/common/experiment/experiment.h"
#include "pushback/common/render/palette.h"

using namespace pushback;
using namespace pushback::which_error_scenes;

namespace {

/// Without a restitution threshold, so that bounces at every speed are compared.
IslandSolver at_every_speed(Real error) {
  IslandSolver solver;
  solver.error = error;
  solver.substep_solver.threshold = solver.contact_half_step.threshold = 0;
  return solver;
}

/// The errors of a motion within `error`, mm: the largest measured one, and the known and the measured one after each step.
struct Played {
  Real largest = 0;
  std::vector<Real> times, known, measured;
};
Played play(const Motion& motion, const TruePlaces& truth, Real error) {
  World world;
  motion.begin(world);
  IslandSolver solver = at_every_speed(error);
  Played played;
  for (int frame = 0; frame < motion.frames(); ++frame) {
    world.step(solver, Real(1) / frames_per_second);
    Real known = 0;
    for (const Body& body : world.bodies) known = std::max(known, solver.error_of(body.index).place);
    played.times.push_back(world.time);
    played.known.push_back(1000 * known);
    played.measured.push_back(truth.error(world));
    played.largest = std::max(played.largest, played.measured.back());
  }
  return played;
}

}  // namespace

int main(int argc, char** argv) {
  Experiment e("27_which_error", "Which error do you want?");
  Real asked = 1;  // mm
  e.parameter({"--error", "error", "mm", "Allowed position error in the second row", Real(0.001), 1000}, &asked);
  return e.run(argc, argv, [&] {
    const std::vector<std::pair<Paint, std::string>> paints{{Paint::flight, "in flight"},
                                                            {Paint::two, "one or two half steps"},
                                                            {Paint::more, "more half steps"},
                                                            {Paint::fourth, "fourth order"},
                                                            {Paint::substeps, "substeps"}};
    std::vector<std::pair<Ink, std::string>> colours;
    for (const auto& [paint, name] : paints) colours.emplace_back(body_ink(static_cast<int>(paint)), name);
    const to_each_its_own_scenes::Yard yard;
    e.scene({.name = "a yard",
             .fill =
                 [yard](World& world) {
                   yard(world);
                   for (Body& body : world.bodies)  // until the first step
                     if (body.movable()) body.coloured(3);
                 },
             .camera = {{Real(-0.4), Real(6.5), 17}, {Real(-0.4), Real(2.1), 0}},
             .seconds = Real(2.4),
             .instants = {Real(0.2), Real(0.8), Real(2.4)},
             .contacts = Drawn::nothing,
             .caption = "The colour of a body: what its error called for in the latest step.",
             .colours = colours,
             .start_shown = false});
    for (const Real millimetres : {10 * asked, asked, asked / 100})
      e.variant(fmt::format("{:g} mm asked", millimetres), Painted{millimetres / 1000}).with_exactly(1);
    for (const auto& [paint, name] : paints) {
      const auto colour = static_cast<int>(paint);
      e.series_without_curves(name, [colour](const World& world) {
        return static_cast<Real>(std::count_if(world.bodies.begin(), world.bodies.end(), [colour](const Body& body) {
          return body.movable() && body.colour == colour;
        }));
      });
      e.number(name + ", on average", "bodies", [series = name](const Run& run) { return run.mean(series); });
    }

    e.study([&e] {
      const std::vector<Real> all_asked{10, 1, Real(0.1), Real(0.01), Real(0.001)};
      std::vector<Curve> got;
      std::map<Real, Real, std::greater<>> largest;
      std::vector<Panel> along;
      for (const Motion& motion : all_motions()) {
        const TruePlaces truth(motion);
        const bool joined = !motion.pins.empty();
        Curve curve{motion.title,         {}, {}, line_colour(got.size()), Curve::Style::line_and_points,
                    marker_of(got.size())};
        for (const Real mm : all_asked) {
          const Played played = play(motion, truth, mm / 1000);
          curve.x.push_back(mm);
          curve.y.push_back(std::max(played.largest, Real(1e-6)));
          largest[mm] = std::max(largest[mm], played.largest);
          if (!joined || mm != 1) continue;
          along.push_back({.title = motion.title + ", asked 1 mm",
                           .x_label = "s",
                           .y_label = "error, mm",
                           .log_y = true,
                           .curves = {{"known", played.times, played.known, line_colour(0), Curve::Style::dashed},
                                      {"measured", played.times, played.measured, line_colour(2)}},
                           .floor = Real(1e-4)});
        }
        const bool never_off = *std::max_element(curve.y.begin(), curve.y.end()) <= Real(1e-6);
        if (!never_off) got.push_back(curve);
      }
      got.push_back({"as asked", all_asked, all_asked, "#888888", Curve::Style::dashed});
      e.panel({.title = "ten motions",
               .x_label = "error asked, mm",
               .y_label = "largest error, mm",
               .log_x = true,
               .log_y = true,
               .curves = got,
               .floor = Real(1e-6)});
      for (const Panel& panel : along) e.panel(panel);
      for (const auto& [mm, off] : largest)
        e.remark(fmt::format("ten motions, {:g} mm asked: off by up to {:.2g} mm", mm, off));

      std::vector<Curve> substeps;
      for (const auto& [body, name] : {std::pair(2, "a stack"), {12, "a chain"}, {1, "a box that slides"}}) {
        Curve curve{name, {}, {}, line_colour(substeps.size()), Curve::Style::line, marker_of(substeps.size())};
        World world;
        to_each_its_own_scenes::Yard{}(world);
        IslandSolver solver;
        solver.error = Real(1e-3);
        while (world.time < Real(2.4)) {
          world.step(solver, Real(1) / 60);
          const BodyError known = solver.error_of(body);
          curve.x.push_back(world.time);
          curve.y.push_back(static_cast<Real>(known.order == 4 ? 5 * known.substeps : known.substeps));
        }
        substeps.push_back(curve);
      }
      e.panel({.title = "a yard, asked 1 mm",
               .x_label = "s",
               .y_label = "substeps in 1/60 s",
               .log_y = true,
               .curves = substeps});
    });
  });
}
