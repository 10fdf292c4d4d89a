#include "pushback/chapters/03_baumgarte/scenes.h"
#include "pushback/chapters/03_baumgarte/tuning.h"
#include "pushback/common/experiment/experiment.h"
#include "pushback/common/experiment/marks.h"

using namespace pushback;
using namespace pushback::baumgarte_scenes;

namespace {

/// Millimetres that the box is in the ground; negative in the air.
Real depth(const World& world) {
  const Body& last = world.bodies.back();
  return 1000 * (std::get<Box>(last.shape).half_extents.y() - last.position.y());
}

Real height(const World& world) {
  return -depth(world);
}

/// A ruler across the picture: the surface, and a thin line for every 200 mm above it.
void add_ruler(Picture& picture) {
  for (int line = 0; line <= 3; ++line) {
    const Real y = Real(0.2) * static_cast<Real>(line);
    add_line(picture, {{-2, y, SunkenSmallBox::half}, {8, y, SunkenSmallBox::half}}, near_black_colour(),
             line == 0 ? Real(2.5) : Real(1.2));
  }
}
Real speed_upwards(const Run& run) {
  return run.world.bodies.back().velocity.y();
}

/// Largest distance, mm, between the depths of a run and d0 (1 - beta)^k, with the beta that its first step shows.
Real away_from_geometric(const Run& run, Real d0) {
  const auto& depths = run.series.at("overlap");
  const Real beta = 1 - depths[0] / (1000 * d0);
  Real largest = 0;
  for (std::size_t k = 0; k < depths.size(); ++k) {
    const Real closed_form = 1000 * d0 * std::pow(1 - beta, static_cast<Real>(k + 1));
    largest = std::max(largest, std::abs(depths[k] - closed_form));
  }
  return largest;
}

}  // namespace

int main(int argc, char** argv) {
  Experiment e("03_baumgarte", "Does the overlap go away?");
  std::vector<Real> betas{0, Real(0.2), Real(0.5), 1};
  Real unstable = Real(0.2);
  e.parameter({"--beta", "β", "", "Baumgarte factors to put side by side", 0, 2}, &betas);
  SunkenBox sunken;
  e.parameter({"--depth", "d₀", "m", "Overlap at the start", 0.001, 0.2}, &sunken.depth);
  e.parameter({"--unstable", "", "m/s", "Jitter above which a stack counts as unstable", 0.001, 10}, &unstable);
  return e.run(argc, argv, [&] {
    const Real h = e.dt(), d0 = sunken.depth;
    const SunkenBox weightless{d0, true};
    const auto away = [d0](const Run& run) { return away_from_geometric(run, d0); };

    e.scene({.name = fmt::format("{:.3g} mm too deep, under gravity", 1000 * d0),
             .fill = SunkenSmallBox{d0},
             .camera = {{Real(2.3), Real(1.05), 20}, {Real(2.3), Real(0.44), 0}, Real(0.0645)},
             .seconds = Real(0.8),
             .key = "gravity",
             .caption = "One box, from left to right. It should come to rest on the thick line. The thin lines, 200 mm "
                        "apart, show how far it is thrown.",
             .marks = [](Picture& picture, const World&, Real) { add_ruler(picture); },
             .strobe =
                 Strobe{.every = Real(0.05), .shift_per_second = {Real(11.5), 0, 0}, .height = 340, .until = Real(0.4)},
             .guess = Guess{{0, 1, 2, 3}}});
    for (std::size_t i = 0; i < betas.size(); ++i) {
      e.variant(fmt::format("β = {}", betas[i]), with_beta<Solver<Clamping, Baumgarte>>(betas[i]))
          .coloured(static_cast<int>(i));
    }
    e.series("height over the ground", "mm", height);
    e.series_without_curves("overlap", depth);
    e.number("highest jump", "mm", [](const Run& run) {
      return std::max(Real(0), -*std::min_element(run.series.at("overlap").begin(), run.series.at("overlap").end()));
    });
    e.number("overlap left", "mm", [](const Run& run) { return std::max(Real(0), run.series.at("overlap").back()); });
    e.number("away from d₀ (1−β)ᵏ", "mm", away);

    e.scene({.name = "without gravity, a contact leaves at β d₀ / h",
             .fill = weightless,
             .seconds = Real(0.4),
             .pictures = false});
    for (std::size_t i = 0; i < betas.size(); ++i) {
      const Real beta = betas[i];
      if (beta <= 0 || beta >= 1) continue;
      e.variant(fmt::format("contact, β = {}", beta), with_beta<Solver<Clamping, Baumgarte>>(beta))
          .coloured(static_cast<int>(i))
          .expect("exit speed", beta * d0 / h)
          .reference("d₀ (kβ − 1)", [=](Real t) { return 1000 * d0 * (beta * t / h - 1); });
    }
    e.series("height over the ground", "mm", height);
    e.number("exit speed", "m/s", speed_upwards);

    e.scene({.name = "an equality row follows d₀ (1−β)ᵏ",
             .fill = weightless,
             .seconds = Real(0.4),
             .pictures = false,
             .open = false});
    for (std::size_t i = 0; i < betas.size(); ++i) {
      const Real beta = betas[i];
      if (beta <= 0 || beta >= 1) continue;
      e.variant(fmt::format("equality, β = {}", beta), with_beta<Solver<Baumgarte>>(beta))
          .coloured(static_cast<int>(i))
          .reference("d₀ exp(−β t/h)", [=](Real t) { return 1000 * d0 * std::exp(-beta * t / h); })
          .expect("away from d₀ (1−β)ᵏ", 0);
    }
    e.series("overlap", "mm", depth);
    e.number("away from d₀ (1−β)ᵏ", "mm", away);

    e.study([&e, unstable, h] {
      const Tuning tuning = tune_beta(unstable, h);
      e.panel(tuning.panel);
      if (tuning.unstable_from > 0) {
        e.remark(fmt::format("the tuning rule: a stack of three is unstable from β = {:.3g} on, so use β = {:.3g}",
                             tuning.unstable_from, tuning.unstable_from / 2));
      } else {
        e.remark("the tuning rule: no β up to 2 made a stack of three unstable");
      }
    });
  });
}
