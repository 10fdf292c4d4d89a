#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "pushback/tools/measure/results/markdown.h"
#include "pushback/tools/measure/study/limits.h"
#include "pushback/tools/measure/study/report.h"

namespace pushback::study {

namespace {

/// One knob of one motion turned, all else as it is.
struct Turned {
  const char* motion;
  const char* method;
  int substeps, sweeps;  // 0: the one that is turned
};
constexpr Turned turned[] = {{"bounce", "slim", 0, 1},          {"sliding", "slim", 0, 4},
                             {"incline", "slim", 0, 4},         {"rolling", "slim", 0, 1},
                             {"break", "slim", 0, 1},           {"pendulum", "split-joints", 0, 1},
                             {"chain", "split-joints", 0, 4},   {"stack-10", "soft", 0, 1},
                             {"pyramid-10", "soft", 0, 1},      {"heavy-on-light", "soft", 0, 1},
                             {"stack-10", "full", 4, 0},        {"stack-10", "slim", 4, 0},
                             {"stack-10", "slim-cold", 4, 0},   {"pyramid-10", "full", 4, 0},
                             {"pyramid-10", "full-cold", 4, 0}, {"heavy-on-light", "slim-cold", 4, 0},
                             {"chain", "joints", 16, 0},        {"chain", "split-joints", 4, 0}};

// m: what is farther off has fallen, and follows no law; more sweeps alone are not that near
constexpr double near_enough = 0.1, near_enough_for_sweeps = 0.7;

struct Line {
  std::vector<double> knob, error, seconds;
  std::string remains = "–";
};

Line line_of(const std::vector<MotionMeasured>& all, const Turned& how) {
  const bool substeps = how.substeps == 0;
  std::map<int, const Measured*> found;  // by the knob
  Line line;
  for (const MotionMeasured& of : all) {
    if (of.motion->name != how.motion) continue;
    for (const Measured& one : of.all)
      if (one.engine == "motion" && one.method == how.method && one.error > 0 &&
          one.error < (substeps ? near_enough : near_enough_for_sweeps) &&
          (substeps ? one.sweeps == how.sweeps : one.substeps == how.substeps))
        found[substeps ? one.substeps : one.sweeps] = &one;
    if (substeps) line.remains = limit_of(of.all, "motion", how.method, how.sweeps).remains();
  }
  for (const auto& [knob, one] : found) {
    line.knob.push_back(knob);
    line.error.push_back(one->error);
    line.seconds.push_back(one->median());
  }
  return line;
}

/// What a change of method or engine does, all else being equal: the geometric means of the ratios.
struct Ratio {
  double error = 0, seconds = 0;
  int settings = 0;
};

template <class Other>
Ratio ratio(const Measurements& all, const Other& is_other_of) {
  Ratio mean;
  for (const Measured& one : all) {
    for (const Measured& other : all) {
      if (!is_other_of(one, other) || !std::isfinite(one.error) || !std::isfinite(other.error)) continue;
      if (one.substeps != other.substeps || one.sweeps != other.sweeps || one.error * other.error == 0) continue;
      mean.error += std::log(other.error / one.error);
      mean.seconds += std::log(other.median() / one.median());
      ++mean.settings;
    }
  }
  mean.error = std::exp(mean.error / mean.settings);
  mean.seconds = std::exp(mean.seconds / mean.settings);
  return mean;
}

std::string ratio_row(const std::string& what, const std::string& motion, const Ratio& mean) {
  if (mean.settings == 0) return "";
  return fmt::format("| {} | {} | {:.2g} times the error | {:.2g} times the time | – | {} settings |\n", what, motion,
                     mean.error, mean.seconds, mean.settings);
}

}  // namespace

std::string table_of_knobs(const std::vector<MotionMeasured>& all) {
  std::string text = markdown_heads({"knob", "motion", "error", "time", "remains as h → 0", "measured"});
  for (const Turned& how : turned) {
    const Line line = line_of(all, how);
    if (line.knob.size() < 3) continue;
    const bool small = how.substeps == 0;
    text += fmt::format(
        "| {} doubled | {} | times {:.2f}, slope {:.2f} | times {:.2f} | {} | `{}` with {} {}, {:g} to {:g} |\n",
        small ? "substeps" : "sweeps", how.motion, std::pow(2, slope(line.knob, line.error)),
        slope(line.knob, line.error), std::pow(2, slope(line.knob, line.seconds)), line.remains, how.method,
        small ? how.sweeps : how.substeps, small ? "sweeps" : "substeps", line.knob.front(), line.knob.back());
  }
  for (const MotionMeasured& measured : all) {
    for (const std::string method : {"full", "slim", "steady"})
      text += ratio_row(fmt::format("`{}` without warm start", method), measured.motion->name,
                        ratio(measured.all, [&](const Measured& one, const Measured& other) {
                          return one.engine == "motion" && other.engine == "motion" && one.method == method &&
                                 other.method == method + "-cold";
                        }));
  }
  for (const MotionMeasured& measured : all)
    text += ratio_row("float for double", measured.motion->name,
                      ratio(measured.all, [](const Measured& one, const Measured& other) {
                        return one.engine == "motion" && other.engine == "motion_float" && one.method == other.method;
                      }));
  return text;
}

std::vector<Panel> panels_of_knobs(const std::vector<MotionMeasured>& all) {
  std::vector<Panel> panels;
  const Turned* next = turned;
  for (const auto& [title, count] : {std::pair{"more substeps: free bodies in motion", 5},
                                     {"more substeps: joints, bodies at rest", 5},
                                     {"more sweeps: a stack, a pyramid", 5},
                                     {"more sweeps: a heavy box, a chain", 3}}) {
    Panel panel{.title = title,
                .x_label = next->substeps == 0 ? "substeps in 1/60 s" : "sweeps in a substep",
                .y_label = "largest error, m",
                .log_x = true,
                .log_y = true,
                .floor = 1e-9};
    for (const Turned* const end = next + count; next < end; ++next) {
      const Line line = line_of(all, *next);
      Curve curve{fmt::format("{}, {}", next->motion, next->method),
                  {line.knob.begin(), line.knob.end()},
                  {line.error.begin(), line.error.end()},
                  line_colour(panel.curves.size()),
                  Curve::Style::line_and_points};
      if (!curve.x.empty()) panel.curves.push_back(curve);
    }
    if (!panel.curves.empty()) panels.push_back(panel);
  }
  return panels;
}

}  // namespace pushback::study
