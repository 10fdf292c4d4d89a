#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <tuple>

#include "pushback/chapters/19_accuracy_and_time/true_places.h"
#include "pushback/chapters/27_which_error/plain.h"
#include "pushback/chapters/27_which_error/scenes.h"
#include "pushback/common/experiment/experiment.h"
#include "pushback/common/render/palette.h"

using namespace pushback;
using namespace pushback::which_error_scenes;

namespace {

/// mm: the largest error of a motion within `error`.
Real largest_error(const Motion& motion, const TruePlaces& truth, Real error) {
  World world;
  motion.begin(world);
  TwinSolver solver;
  solver.error = error;
  Real largest = 0;
  for (int frame = 0; frame < motion.frames(); ++frame) {
    world.step(solver, Real(1) / frames_per_second);
    largest = std::max(largest, truth.error(world));
  }
  return largest;
}

constexpr Real least_shown = Real(1e-2);  // mm

/// A bar of plain.h for two seconds, mm.
struct PlayedBar {
  std::vector<Real> times, error, halves, twin;
  Real largest(const std::vector<Real>& of) const { return *std::max_element(of.begin(), of.end()); }
};
PlayedBar play_bar(Real height, Real angle) {
  constexpr Real dt = Real(1) / frames_per_second;
  constexpr int of_truth = 4096;  // substeps
  const plain_27::Bar begin{height, 0, angle, 0};
  plain_27::Played bar{begin, begin};
  plain_27::Bar truth = begin;
  PlayedBar played;
  for (int frame = 1; frame <= 2 * frames_per_second; ++frame) {
    play_step(bar, dt);
    truth = step(truth, dt, of_truth);
    played.times.push_back(static_cast<Real>(frame) * dt);
    played.error.push_back(1000 * std::abs(bar.bar.y - truth.y));
    played.halves.push_back(1000 * bar.halves);
    played.twin.push_back(1000 * bar.said_by_twin());
  }
  return played;
}

/// Compares both estimates with the true error, for one bar over time and for 450 bars.
void tell_of_bars(Experiment& e) {
  const PlayedBar one = play_bar(1, Real(0.7));
  e.panel({.title = "a bar falls from 1 m at 40 degrees",
           .x_label = "s",
           .y_label = "error, mm",
           .log_y = true,
           .curves = {{"true", one.times, one.error, line_colour(2)},
                      {"said by halves", one.times, one.halves, line_colour(1), Curve::Style::dashed},
                      {"said by a twin", one.times, one.twin, line_colour(0), Curve::Style::dashed}},
           .floor = least_shown});
  Curve halves{"halves", {}, {}, line_colour(1), Curve::Style::points, marker_of(1)},
      twin{"a twin", {}, {}, line_colour(0), Curve::Style::points, marker_of(0)};
  int bars = 0, past_halves = 0, past_twin = 0;
  for (int height = 6; height <= 20; ++height)
    for (int angle = 1; angle <= 30; ++angle) {
      const PlayedBar bar = play_bar(static_cast<Real>(height) / 10, static_cast<Real>(angle) / 20);
      const Real error = bar.largest(bar.error);
      for (auto& [curve, said, past] :
           {std::tuple<Curve&, const std::vector<Real>&, int&>{halves, bar.halves, past_halves},
            {twin, bar.twin, past_twin}}) {
        curve.x.push_back(bar.largest(said));
        curve.y.push_back(error);
        past += error > 3 * curve.x.back();
      }
      ++bars;
    }
  e.panel(
      {.title = "450 bars",
       .x_label = "largest error said, mm",
       .y_label = "largest true error, mm",
       .log_x = true,
       .log_y = true,
       .curves = {halves, twin, {"as said", {Real(0.1), 1000}, {Real(0.1), 1000}, "#888888", Curve::Style::dashed}}});
  for (const auto& [said, past] : {std::pair("the sum of halves", past_halves), {"what a twin says", past_twin}})
    e.remark(fmt::format("the true error exceeds 3 times {} for {} of {} bars", said, past, bars));
}

}  // namespace

int main(int argc, char** argv) {
  Experiment e("27_which_error", "Which error do you want?");
  Real asked = 1;  // mm
  e.parameter({"--error", "error", "mm", "Allowed position error in the second row", Real(0.001), 1000}, &asked);
  return e.run(argc, argv, [&] {
    const std::vector<std::pair<Paint, std::string>> paints = named_paints();
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
             .seconds = Real(0.6),
             .instants = {Real(0.2), Real(0.4), Real(0.6)},
             .contacts = Drawn::nothing,
             .caption = "The colour shows how a body was moved in the latest step.",
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
      tell_of_bars(e);
      const std::vector<Real> all_asked{10, 1, Real(0.1), Real(0.01), Real(0.001)};
      std::vector<Curve> got;
      std::map<Real, Real, std::greater<>> largest;
      for (const Motion& motion : all_motions()) {
        const TruePlaces truth(motion);
        Curve curve{motion.title,         {}, {}, line_colour(got.size()), Curve::Style::line_and_points,
                    marker_of(got.size())};
        for (const Real mm : all_asked) {
          const Real off = largest_error(motion, truth, mm / 1000);
          curve.x.push_back(mm);
          curve.y.push_back(std::max(off, Real(1e-6)));
          largest[mm] = std::max(largest[mm], off);
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
      for (const auto& [mm, off] : largest)
        e.remark(fmt::format("ten motions, {:g} mm asked: off by up to {:.2g} mm", mm, off));

      std::vector<Curve> substeps;
      for (const auto& [body, name] : {std::pair(2, "a stack"), {12, "a chain"}, {1, "a box that slides"}}) {
        Curve curve{name, {}, {}, line_colour(substeps.size()), Curve::Style::line, marker_of(substeps.size())};
        World world;
        to_each_its_own_scenes::Yard{}(world);
        TwinSolver solver;
        solver.error = Real(1e-3);
        while (world.time < Real(2.4)) {
          world.step(solver, Real(1) / 60);
          curve.x.push_back(world.time);
          curve.y.push_back(static_cast<Real>(solver.error_of(body).substeps));
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
