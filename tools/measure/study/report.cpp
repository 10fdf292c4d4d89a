#include "pushback/tools/measure/study/report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "pushback/tools/measure/results/machine.h"
#include "pushback/tools/measure/results/markdown.h"
#include "pushback/tools/measure/study/choice.h"
#include "pushback/tools/measure/study/limits.h"

namespace pushback::study {

namespace {

/// A stroke from quartile to quartile of each time.
void add_quartiles(Panel& panel, const Measurements& points, const Motion& motion) {
  Curve strokes{"", {}, {}, "#909090"};
  for (const Measured& one : points)
    for (const double seconds : {one.quartile(1), one.quartile(3), std::nan("")}) {
      strokes.x.push_back(static_cast<Real>(1000 * seconds / motion.seconds));
      strokes.y.push_back(static_cast<Real>(one.error));
    }
  if (!points.empty()) panel.curves.push_back(strokes);
}

void add_curve(Panel& panel, const Measurements& points, const Motion& motion, Curve curve) {
  for (const Measured& one : points) {
    if (!std::isfinite(one.error)) continue;
    curve.x.push_back(static_cast<Real>(1000 * one.median() / motion.seconds));
    curve.y.push_back(static_cast<Real>(one.error));
  }
  if (!curve.x.empty()) panel.curves.push_back(curve);
}

Panel error_against_time(const Motion& motion) {
  return {.title = motion.title,
          .x_label = "wall time for a second, ms",
          .y_label = "largest error, m",
          .log_x = true,
          .log_y = true,
          .floor = Real(1e-7)};  // m: what is less is drawn here
}
void add_tolerances(Panel& panel) {
  for (const Tolerance& tolerance : tolerances)
    panel.lines.push_back({static_cast<Real>(tolerance.error), tolerance.name});
}

const char* in_float(const Measured& ours) {
  return ours.engine == "motion_float" ? " in float" : "";
}

}  // namespace

Panel work_precision(const MotionMeasured& measured, const std::vector<Engine>& engines) {
  const Motion& motion = *measured.motion;
  Panel panel = error_against_time(motion);
  add_tolerances(panel);
  add_curve(panel, of_engine(measured.all, "motion"), motion, {"", {}, {}, "#c4d8e8", Curve::Style::points});
  for (std::size_t i = engines.size(); i-- > 0;) {  // ours last, on top
    const Measurements settings = of_engine(measured.all, engines[i].name);
    Curve curve{fmt::format("{}, of {}", engines[i].title, settings.size()),
                {},
                {},
                line_colour(engines[i].colour),
                engines[i].dashed ? Curve::Style::dashed : Curve::Style::line_and_points};
    if (engines[i].dashed) curve.marker = marker_of(engines[i].colour + 3);
    add_curve(panel, front(robust(settings)), motion, curve);
    add_quartiles(panel, front(robust(settings)), motion);
  }
  return panel;
}

namespace {

/// Methods that not every motion is played by, each in the same colour everywhere.
constexpr const char* divided[] = {"once",   "wide",      "wide-float", "by-island",
                                   "within", "half-step", "order-4",    "impact"};

}  // namespace

Panel fronts_of_methods(const MotionMeasured& measured, const std::string& engine) {
  Panel panel = error_against_time(*measured.motion);
  add_tolerances(panel);
  const Measurements all = of_engine(measured.all, engine);
  std::size_t next = 0;
  for (const std::string& method : methods_of(all, engine)) {
    const bool like_sister = method.ends_with("-cold") || method.ends_with("-stiff");  // in her colour, dashed
    const auto* known = std::find(std::begin(divided), std::end(divided), method.substr(0, method.find("-stiff")));
    const std::size_t colour =
        known != std::end(divided) ? static_cast<std::size_t>(known - divided) : next - (like_sister ? 1 : 0);
    if (!like_sister) ++next;
    add_curve(
        panel, front(robust(of_method(all, method))), *measured.motion,
        {method, {}, {}, line_colour(colour), like_sister ? Curve::Style::dashed : Curve::Style::line_and_points});
  }
  return panel;
}

std::string table_of_cheapest(const std::vector<MotionMeasured>& all) {
  std::string text =
      markdown_heads({"motion", "of settings", "below 1 cm", "below 1 mm", "below 0.1 mm", "below 1 µm"});
  for (const MotionMeasured& measured : all) {
    const Measurements our = of_maker(measured.all, ours);
    std::vector<std::string> row{measured.motion->title, std::to_string(our.size())};
    const auto frame = [&](double seconds) { return plain(per_frame(*measured.motion, seconds)); };
    for (const Tolerance& tolerance : tolerances) {
      const auto found = cheapest(our, tolerance.error);
      row.emplace_back("not reached");
      if (!found) continue;
      const auto other =
          cheapest(those(our, [&](const Measured& one) { return one.method != found->method; }), tolerance.error);
      // What remains is in double, where its method was played with all steps.
      const std::string engine = found->engine == "motion_float" ? "motion" : found->engine;
      row.back() = fmt::format(
          "`{}`{}: {} µs ({} to {}), {} row solves, {} mm off, {} remains", found->setting(), in_float(*found),
          frame(found->median()), frame(found->quartile(1)), frame(found->quartile(3)),
          found->row_solves ? plain(*found->row_solves / measured.motion->frames()) : "–", plain(1000 * found->error),
          limit_of(measured.all, engine, found->method, found->sweeps).remains());
      if (other && faster(*found, *other) == 0) row.back() += fmt::format("; equal: `{}`", other->setting());
    }
    text += markdown_row(row);
  }
  return text;
}

std::string table_of_engines(const std::vector<MotionMeasured>& all, const std::vector<Engine>& engines) {
  std::vector<std::string> makers, heads{"an error below 1 mm", "Pushback, 1 mm asked"};
  for (const Engine& engine : engines)
    if (!engine.maker.empty() && std::find(makers.begin(), makers.end(), engine.maker) == makers.end())
      makers.push_back(engine.maker);
  heads.insert(heads.end(), makers.begin(), makers.end());
  std::string text = markdown_heads(heads);
  for (const MotionMeasured& measured : all) {
    std::vector<std::string> row{measured.motion->title, "–"};
    const auto frame = [&](const Measured& one) { return plain(per_frame(*measured.motion, one.median())); };
    for (const Measured& within : of_method(measured.all, "within"))
      if (within.substeps == 1 && within.sweeps <= 1)
        row.back() = fmt::format("{} µs, {} mm off", frame(within), plain(1000 * within.error, 2));
    for (const std::string& maker : makers) {
      const Measurements settings = of_maker(measured.all, maker), best = front(settings);
      const auto found = cheapest(settings, 1e-3);
      const bool equal = maker != ours && found && faster(of_maker(measured.all, ours), settings, 1e-3) == 0;
      row.push_back(best.empty() ? "–"
                    : found      ? fmt::format("{} µs, `{}`{}{}", frame(*found), found->setting(), in_float(*found),
                                          equal ? ", equal" : "")
                                 : fmt::format("not below {} mm", plain(1000 * best.back().error, 2)));
    }
    text += markdown_row(row);
  }
  return text;
}

std::string table_of_others(const std::vector<MotionMeasured>& all, const std::vector<Engine>& engines) {
  std::string text =
      markdown_heads({"motion", "engine", "of settings", "below 1 cm", "below 1 mm", "below 0.1 mm", "below 1 µm"});
  for (const MotionMeasured& measured : all) {
    const Measurements our = of_maker(measured.all, ours);
    for (const Engine& engine : engines) {
      if (engine.maker == ours) continue;
      const Measurements theirs = robust(of_engine(measured.all, engine.name));
      std::vector<std::string> row{measured.motion->title, engine.title, std::to_string(theirs.size())};
      for (const Tolerance& tolerance : tolerances) {
        const auto found = cheapest(theirs, tolerance.error), best = cheapest(our, tolerance.error);
        row.push_back(theirs.empty() ? "it does not play this"
                      : !found       ? "not reached"
                      : !best ? fmt::format("{} µs, we not at all", plain(per_frame(*measured.motion, found->median())))
                              : fmt::format("{} times as long{}", plain(found->median() / best->median(), 2),
                                            faster(our, theirs, tolerance.error) == 0 ? ", equal" : ""));
      }
      text += markdown_row(row);
    }
  }
  return text;
}

namespace {

/// A row for each compared method that was measured, with what `cell(motion, its measurements)` says.
template <class Cell>
std::string table_of_compared(const std::vector<MotionMeasured>& all, const Cell& cell) {
  std::vector<std::string> heads{"method"};
  for (const MotionMeasured& measured : all) heads.push_back(fmt::format("`{}`", measured.motion->name));
  std::string text = markdown_heads(heads);
  for (const std::string& method : compared_methods()) {
    std::vector<std::string> row{fmt::format("`{}`", method)};
    bool measured_at_all = false;
    for (const MotionMeasured& measured : all) {
      const Measurements its = of_method(measured.all, method);
      measured_at_all = measured_at_all || !its.empty();
      row.push_back(its.empty() ? "–" : cell(*measured.motion, its));
    }
    if (measured_at_all) text += markdown_row(row);
  }
  return text;
}

}  // namespace

const std::vector<std::string>& compared_methods() {
  static const std::vector<std::string> methods{"slim", "split-joints", "direct-joints", "jointed",
                                                "once", "half-step",    "xpbd",          "avbd",
                                                "nncg", "sap",          "sap-lagged"};
  return methods;
}

Panel fronts_of_compared(const MotionMeasured& measured) {
  Panel panel = error_against_time(*measured.motion);
  for (std::size_t i = 0; i < compared_methods().size(); ++i) {
    const std::string& method = compared_methods()[i];
    const std::size_t look =
        i < 4
            ? 0
            : i - 3;  // those of one step a substep are alike; else of two that share a colour, each has its own shape
    const bool dashed = method == "direct-joints" || method == "nncg" || method.starts_with("sap");
    add_curve(panel, front(robust(of_method(measured.all, method))), *measured.motion,
              {method,
               {},
               {},
               line_colour(look),
               dashed ? Curve::Style::dashed : Curve::Style::line_and_points,
               marker_of(look)});
  }
  return panel;
}

std::string table_of_errors(const std::vector<MotionMeasured>& all, int substeps, int sweeps) {
  return table_of_compared(all, [&](const Motion&, const Measurements& its) -> std::string {
    for (const Measured& one : its)
      if (one.substeps == substeps && (one.sweeps == sweeps || one.sweeps == 0))
        return std::isfinite(one.error) ? two_digits(std::max(1000 * one.error, 1e-4)) : one.late ? "late" : "lost";
    return "–";
  });
}

std::string table_of_times(const std::vector<MotionMeasured>& all, double error) {
  return table_of_compared(all, [&](const Motion& motion, const Measurements& its) -> std::string {
    const auto found = cheapest(robust(its), error);
    if (!found) return "not reached";
    const std::string setting = found->setting();
    return fmt::format("{} µs, `{}`", two_digits(per_frame(motion, found->median())),
                       setting.substr(setting.find('/') + 1));
  });
}

std::string table_of_machine(const MachineReport& run, const std::vector<Engine>& engines, const AllMeasured& all) {
  std::string text = "| measured | |\n| --- | --- |\n";
  text += fmt::format("| on | {} |\n", processor());
  text += fmt::format("| in | {:.0f} min, one program at a time |\n", std::ceil(run.took.count() / 60));
  if (run.resumed > 0) text += fmt::format("| motions measured before, by a run that was ended | {} |\n", run.resumed);
  text += fmt::format("| load of 1, 5, 15 min as it began | {} |\n", run.load_before);
  text += fmt::format("| as it ended, this run itself being 1 | {} |\n\n", run.load_after);
  text += markdown_heads({"engine", "version", "settings tried", "timed again near a front", "lost", "given up"});
  for (std::size_t i = 0; i < engines.size(); ++i) {
    int tried = 0, again = 0, lost = 0, late = 0;
    for (const auto& [motion, measured] : all) {
      for (const Measured& one : of_engine(measured, engines[i].name)) {
        ++tried;
        again += one.seconds.size() > 1 ? 1 : 0;
        late += one.late ? 1 : 0;
        lost += !one.late && !std::isfinite(one.error) ? 1 : 0;
      }
    }
    text += fmt::format("| {} | {} | {} | {} | {} | {} |\n", engines[i].title, run.versions.at(i), tried, again, lost,
                        late);
  }
  return text;
}

}  // namespace pushback::study
