#include "pushback/tools/measure/study/limits.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "pushback/common/basics/quantile.h"
#include "pushback/tools/measure/results/markdown.h"

namespace pushback::study {

namespace {

constexpr std::size_t enough_steps = 5;            // of a number of sweeps that limits are taken of
constexpr double agreement = 0.1;                  // of extrapolations
constexpr double level = 0.25;                     // of the largest of the last three errors, which differ by no more
constexpr double nearest = 0.25, farthest = 1.25;  // times the last error: extrapolations beyond are not trusted
constexpr double seen = 1e-7;                      // m: what is less is rounding's, and only said to be less

struct Extrapolated {
  double limit = 0, order = 0;
  bool valid = false;
};

/// a and p of  e = a + b h^p  through three errors, each at half the step before it.   Aitken:   e3 - (e3 - e2) q / (1 - q)
Extrapolated extrapolated(double e1, double e2, double e3) {
  const double before = e1 - e2, last = e2 - e3, q = last / before;  // q = 2^-p
  if (!(q > 0 && q < 1)) return {};
  const double limit = e3 - last * q / (1 - q);
  return {.limit = limit, .order = -std::log2(q), .valid = limit >= nearest * e3 && limit <= farthest * e3};
}

}  // namespace

std::string Limit::remains() const {
  const auto mm = [](double metres) { return two_digits(1000 * metres); };
  if (kind == Kind::unknown) return "–";
  if (most < seen) return fmt::format("< {:.4f} mm", 1000 * seen);
  if (kind == Kind::reached) return mm(least) + " mm";
  if (kind == Kind::falling) return "< " + mm(most) + " mm";
  return mm(std::max(least, seen)) + " to " + mm(most) + " mm";
}

std::string Limit::text() const {
  return order > 0 && most >= seen ? fmt::format("{}, order {:.1f}", remains(), order) : remains();
}

Limit limit_of(const std::vector<double>& errors) {
  const auto lost = std::find_if(errors.rbegin(), errors.rend(), [](double error) { return !std::isfinite(error); });
  const std::vector<double> e(lost.base(), errors.end());
  const std::size_t n = e.size();
  if (n < 3) return {};
  const auto [least, most] = std::minmax_element(e.end() - 3, e.end());
  if (n >= 5) {
    const Extrapolated last = extrapolated(e[n - 3], e[n - 2], e[n - 1]);
    const auto agrees = [&](const Extrapolated& other) {
      return other.valid && std::abs(other.limit - last.limit) <= agreement * last.limit;
    };
    if (last.valid && agrees(extrapolated(e[n - 4], e[n - 3], e[n - 2])) &&
        agrees(extrapolated(e[n - 5], e[n - 4], e[n - 3])))
      return {Limit::Kind::reached, last.limit, last.limit, last.order};
  }
  if (*most - *least <= level * *most) {
    const double middle = median({e.end() - 3, e.end()});
    return {Limit::Kind::reached, middle, middle, 0};
  }
  if (e[n - 1] < e[n - 2] && e[n - 2] < e[n - 3])
    return {Limit::Kind::falling, 0, e[n - 1], e[n - 1] > 0 ? std::log2(e[n - 3] / e[n - 1]) / 2 : 0};
  if (n >= 6) {
    const double before = median({e.end() - 6, e.end() - 3}), last = median({e.end() - 3, e.end()});
    if (last < before / 2) return {Limit::Kind::falling, 0, *most, last > 0 ? std::log2(before / last) / 3 : 0};
  }
  return {Limit::Kind::scattered, *least, *most, 0};
}

Limit limit_of(const Measurements& all, const std::string& engine, const std::string& method, int sweeps) {
  std::map<int, double> by_steps;
  for (const Measured& one : all)
    if (one.engine == engine && one.method == method && one.sweeps == sweeps) by_steps[one.substeps] = one.error;
  if (by_steps.empty()) return {};
  std::vector<double> errors;
  for (int steps = 1; steps <= by_steps.rbegin()->first; steps *= 2) {
    const auto found = by_steps.find(steps);
    errors.push_back(found == by_steps.end() ? std::numeric_limits<double>::infinity() : found->second);
  }
  return limit_of(errors);
}

std::vector<std::string> methods_of(const Measurements& all, const std::string& engine) {
  std::vector<std::string> methods;
  for (const Measured& one : all)
    if (one.engine == engine && std::find(methods.begin(), methods.end(), one.method) == methods.end())
      methods.push_back(one.method);
  return methods;
}

Limit limit_of(const Measurements& all, const std::string& engine, const std::string& method) {
  std::map<int, std::set<int>> steps_of;  // by sweeps
  for (const Measured& one : all)
    if (one.engine == engine && one.method == method) steps_of[one.sweeps].insert(one.substeps);
  int sweeps = steps_of.empty() ? 0 : steps_of.begin()->first;
  for (const auto& [number, steps] : steps_of)
    if (steps.size() >= enough_steps) sweeps = number;
  return limit_of(all, engine, method, sweeps);
}

}  // namespace pushback::study
