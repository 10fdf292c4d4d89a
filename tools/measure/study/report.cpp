#include "pushback/tools/measure/study/report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "pushback/tools/measure/results/markdown.h"
#include "pushback/tools/measure/study/limits.h"

namespace pushback::study {

namespace {

constexpr Real least_drawn = 1e-7;  // m: what is less is drawn here

struct Tolerance {
  double error;  // m
  const char* name;
};
constexpr Tolerance tolerances[] = {{1e-2, "1 cm"}, {1e-3, "1 mm"}, {1e-4, "0.1 mm"}, {1e-6, "1 µm"}};

template <class Which>
Measurements those(const Measurements& all, const Which& which) {
  Measurements found;
  std::copy_if(all.begin(), all.end(), std::back_inserter(found), which);
  return found;
}
Measurements of_engine(const Measurements& all, const std::string& engine) {
  return those(all, [&](const Measured& one) { return one.engine == engine; });
}
bool is_ours(const std::string& engine) {
  return engine == "motion" || engine == "motion_float" || engine == "motion_wide";
}
Measurements ours(const Measurements& all) {
  return those(all, [](const Measured& one) { return is_ours(one.engine); });
}

Curve curve_of(const Measurements& points, const Motion& motion, const std::string& label, const std::string& colour,
               Curve::Style style) {
  Curve curve{label, {}, {}, colour, style};
  for (const Measured& one : points) {
    if (!std::isfinite(one.error)) continue;
    curve.x.push_back(static_cast<Real>(1000 * one.median() / motion.seconds));
    curve.y.push_back(static_cast<Real>(one.error));
  }
  return curve;
}

void add(Panel& panel, const Curve& curve) {
  if (!curve.x.empty()) panel.curves.push_back(curve);
}

Panel error_against_time(const Motion& motion) {
  Panel panel{.title = motion.title,
              .x_label = "wall time for a second, ms",
              .y_label = "largest error, m",
              .log_x = true,
              .log_y = true,
              .floor = least_drawn};
  for (const Tolerance& tolerance : tolerances)
    panel.lines.push_back({static_cast<Real>(tolerance.error), tolerance.name});
  return panel;
}

/// So many digits, and no exponent; of what is larger, all before the point.
std::string plain(double value, int digits = 3) {
  return value < 99.5 ? fmt::format("{:.{}g}", value, digits) : fmt::format("{:.0f}", value);
}

/// Of all methods of these engines, in steps down to `finest`; float is left to those that have nothing else.
std::string least_remaining(const Measurements& all, const std::vector<std::string>& engines, int finest) {
  std::pair<std::string, Limit> least;
  for (const std::string& engine : engines) {
    const auto of_this = least_limit(all, engine, finest);
    if (least.first.empty() || (!of_this.first.empty() && of_this.second.most < least.second.most)) least = of_this;
  }
  return least.first.empty() ? "–" : fmt::format("{} (`{}`)", least.second.remains(), least.first);
}

const char* in_float(const Measured& ours) {
  return ours.engine == "motion_float" ? " in float" : "";
}

/// us of wall time for a frame.
double per_frame(const Motion& motion, double seconds) {
  return 1e6 * seconds / motion.frames();
}

}  // namespace

Panel work_precision(const MotionMeasured& measured, const std::vector<Engine>& engines) {
  const Motion& motion = *measured.motion;
  Panel panel = error_against_time(motion);
  add(panel, curve_of(of_engine(measured.all, "motion"), motion, "", "#c4d8e8", Curve::Style::points));
  for (std::size_t i = engines.size(); i-- > 0;) {  // ours last, on top
    const Measurements settings = of_engine(measured.all, engines[i].program);
    const std::size_t colour = engines[i].colour;
    Curve curve =
        curve_of(front(robust(settings)), motion, fmt::format("{}, of {}", engines[i].title, settings.size()),
                 line_colour(colour), engines[i].dashed ? Curve::Style::dashed : Curve::Style::line_and_points);
    if (engines[i].dashed) curve.marker = marker_of(colour + 3);
    add(panel, curve);
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
  const Measurements all = of_engine(measured.all, engine);
  std::vector<std::string> methods;
  for (const Measured& one : all)
    if (std::find(methods.begin(), methods.end(), one.method) == methods.end()) methods.push_back(one.method);
  std::size_t next = 0;
  for (const std::string& method : methods) {
    const bool like_sister = method.ends_with("-cold") || method.ends_with("-stiff");  // in her colour, dashed
    const auto* known = std::find(std::begin(divided), std::end(divided), method.substr(0, method.find("-stiff")));
    const std::size_t colour =
        known != std::end(divided) ? static_cast<std::size_t>(known - divided) : next - (like_sister ? 1 : 0);
    if (!like_sister) ++next;
    const Measurements settings = those(all, [&](const Measured& one) { return one.method == method; });
    add(panel, curve_of(front(robust(settings)), *measured.motion, method, line_colour(colour),
                        like_sister ? Curve::Style::dashed : Curve::Style::line_and_points));
  }
  return panel;
}

std::string table_of_cheapest(const std::vector<MotionMeasured>& all) {
  std::string text =
      markdown_heads({"motion", "of settings", "below 1 cm", "below 1 mm", "below 0.1 mm", "below 1 µm"});
  for (const MotionMeasured& measured : all) {
    const Measurements our = robust(ours(measured.all));
    text += fmt::format("| {} | {} ", measured.motion->title, our.size());
    for (const Tolerance& tolerance : tolerances) {
      const auto found = cheapest(our, tolerance.error);
      const auto frame = [&](double seconds) { return plain(per_frame(*measured.motion, seconds)); };
      const auto rows = [&] { return found->row_solves ? plain(*found->row_solves / measured.motion->frames()) : "–"; };
      text += found ? fmt::format("| `{}`{}: {} µs ({} to {}), {} row solves, {} mm off, {} remains ", found->setting(),
                                  in_float(*found), frame(found->median()), frame(found->quartile(1)),
                                  frame(found->quartile(3)), rows(), plain(1000 * found->error),
                                  // in double, where its method was played with all steps
                                  limit_of(measured.all, found->engine == "motion_float" ? "motion" : found->engine,
                                           found->method, found->sweeps)
                                      .remains())
                    : "| not reached ";
    }
    text += "|\n";
  }
  return text;
}

std::string table_of_engines(const std::vector<MotionMeasured>& all) {
  struct Maker {
    const char* name;
    std::vector<std::string> engines;
  };
  std::vector<Maker> makers{{"Pushback", {"motion", "motion_float", "motion_wide"}},
                            {"Bullet", {"motion_bullet", "motion_bullet_double"}},
                            {"ODE", {"motion_ode"}},
                            {"MuJoCo", {"motion_mujoco"}}};
  for (const Maker& maker :
       {Maker{"Box3D", {"motion_box3d"}}, {"Jolt", {"motion_jolt"}}, {"entered", {"motion_adapter"}}})
    if (std::any_of(all.begin(), all.end(), [&](const MotionMeasured& measured) {
          return !of_engine(measured.all, maker.engines.front()).empty();
        }))
      makers.push_back(maker);
  std::vector<std::string> heads{"an error below 1 mm", "Pushback, told 1 mm"};
  for (const Maker& maker : makers) heads.emplace_back(maker.name);
  std::string text = markdown_heads(heads);
  for (const MotionMeasured& measured : all) {
    const auto told = std::find_if(measured.all.begin(), measured.all.end(), [](const Measured& one) {
      return one.method == "within" && one.substeps == 1 && one.sweeps <= 1;
    });
    text += fmt::format("| {} | {} |", measured.motion->title,
                        told == measured.all.end()
                            ? "–"
                            : fmt::format("{} µs, {} mm off", plain(per_frame(*measured.motion, told->median())),
                                          plain(1000 * told->error, 2)));
    for (const Maker& maker : makers) {
      const Measurements settings = robust(those(measured.all, [&](const Measured& one) {
        return std::find(maker.engines.begin(), maker.engines.end(), one.engine) != maker.engines.end();
      }));
      const Measurements best = front(settings);
      const auto found = cheapest(settings, 1e-3);
      text += best.empty() ? " – |"
              : found      ? fmt::format(" {} µs, `{}`{} |", plain(per_frame(*measured.motion, found->median())),
                                         found->setting(), in_float(*found))
                           : fmt::format(" not below {} mm |", plain(1000 * best.back().error, 2));
    }
    text += "\n";
  }
  return text;
}

std::string table_of_others(const std::vector<MotionMeasured>& all, const std::vector<Engine>& engines) {
  std::string text = markdown_heads({"motion", "engine", "of settings", "below 1 cm", "below 1 mm", "below 0.1 mm",
                                     "below 1 µm", "where its front is between 10 cm and 0.01 mm, we take at most",
                                     "substeps, at most", "remains of theirs as h → 0, at least", "of ours"});
  for (const MotionMeasured& measured : all) {
    for (const Engine& engine : engines) {
      if (is_ours(engine.program)) continue;
      const Measurements theirs = robust(of_engine(measured.all, engine.program)), our = robust(ours(measured.all));
      text += fmt::format("| {} | {} | {} ", measured.motion->title, engine.title, theirs.size());
      for (const Tolerance& tolerance : tolerances) {
        const auto found = cheapest(theirs, tolerance.error), best = cheapest(our, tolerance.error);
        text += !found  ? "| not reached "
                : !best ? fmt::format("| {} µs, we not at all ", plain(per_frame(*measured.motion, found->median())))
                        : fmt::format("| {} times as long ", plain(found->median() / best->median(), 2));
      }
      const double slower = times_slower(our, theirs, 1e-5, 1e-1);
      text += theirs.empty()       ? "| it does not play this "
              : slower == 0        ? "| it has no such front "
              : std::isinf(slower) ? "| we do not reach all of it "
                                   : fmt::format("| {} times its time ", plain(slower, 2));
      const int own = std::max(finest_of(our, "motion"), finest_of(our, "motion_wide"));
      const int finest = theirs.empty() ? own : std::min(own, finest_of(theirs, engine.program));
      text += fmt::format("| {} | {} | {} |\n", finest > 0 ? std::to_string(finest) : "–",
                          least_remaining(measured.all, {engine.program}, finest),
                          least_remaining(measured.all, {"motion", "motion_wide"}, finest));
    }
  }
  return text;
}

}  // namespace pushback::study
