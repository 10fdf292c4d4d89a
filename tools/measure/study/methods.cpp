#include "pushback/tools/measure/study/methods.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "pushback/tools/measure/results/markdown.h"

namespace pushback::study {

namespace {

Measurements of_method(const Measurements& all, const std::string& method) {
  Measurements found;
  std::copy_if(all.begin(), all.end(), std::back_inserter(found),
               [&](const Measured& one) { return one.method == method; });
  return found;
}

/// Two digits, no exponent.
std::string two_digits(double value) {
  if (value >= 99.5) return fmt::format("{:.0f}", value);
  return fmt::format("{:.{}f}", value, std::max(0, 1 - static_cast<int>(std::floor(std::log10(value)))));
}

/// A row for each method that was measured, with what `cell(motion, its measurements)` says.
template <class Cell>
std::string table(const std::vector<MotionMeasured>& all, const Cell& cell) {
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
  static const std::vector<std::string> methods{"slim",      "split-joints", "direct-joints", "jointed", "once",
                                                "half-step", "xpbd",         "avbd",          "nncg",    "sap"};
  return methods;
}

Panel fronts_of_compared(const MotionMeasured& measured) {
  Panel panel{.title = measured.motion->title,
              .x_label = "wall time for a second, ms",
              .y_label = "largest error, m",
              .log_x = true,
              .log_y = true,
              .floor = Real(1e-7)};
  for (std::size_t i = 0; i < compared_methods().size(); ++i) {
    const std::string& method = compared_methods()[i];
    const bool ours = method == "slim" || method.ends_with("joints") || method == "jointed";
    Curve curve{method,
                {},
                {},
                line_colour(ours ? 0 : i - 3),
                method == "direct-joints" || method == "nncg" || method == "sap" ? Curve::Style::dashed
                                                                                 : Curve::Style::line_and_points,
                marker_of(ours ? 0 : i - 3)};  // of two that share a colour, each has its own shape
    for (const Measured& one : front(robust(of_method(measured.all, method)))) {
      if (!std::isfinite(one.error)) continue;
      curve.x.push_back(static_cast<Real>(1000 * one.median() / measured.motion->seconds));
      curve.y.push_back(static_cast<Real>(one.error));
    }
    if (!curve.x.empty()) panel.curves.push_back(curve);
  }
  return panel;
}

std::string table_of_errors(const std::vector<MotionMeasured>& all, int substeps, int sweeps) {
  return table(all, [&](const Motion&, const Measurements& its) -> std::string {
    for (const Measured& one : its)
      if (one.substeps == substeps && (one.sweeps == sweeps || one.sweeps == 0))
        return std::isfinite(one.error) ? two_digits(std::max(1000 * one.error, 1e-4)) : one.late ? "late" : "lost";
    return "–";
  });
}

std::string table_of_times(const std::vector<MotionMeasured>& all, double error) {
  return table(all, [&](const Motion& motion, const Measurements& its) -> std::string {
    const auto found = cheapest(robust(its), error);
    if (!found) return "not reached";
    const std::string setting = found->setting();
    return fmt::format("{} µs, `{}`", two_digits(1e6 * found->median() / motion.frames()),
                       setting.substr(setting.find('/') + 1));
  });
}

}  // namespace pushback::study
