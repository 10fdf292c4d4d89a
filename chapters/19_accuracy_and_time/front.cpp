#include "pushback/chapters/19_accuracy_and_time/front.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "pushback/common/basics/quantile.h"

namespace pushback::study {

double Measured::median() const {
  return pushback::median(seconds);
}
double Measured::quartile(int which) const {
  return seconds.size() > 1 ? quantile(seconds, 0.25 * which) : seconds.front() * (1 + 0.2 * (which - 2));
}
std::string Measured::setting() const {
  return sweeps == 0 ? fmt::format("{}/{}", method, substeps) : fmt::format("{}/{}/{}", method, substeps, sweeps);
}

bool is_as_fine(const Measured& one, const Measured& than) {
  return one.engine == than.engine && one.method == than.method && one.substeps >= than.substeps &&
         one.sweeps >= than.sweeps;
}

Measurements robust(const Measurements& all) {
  Measurements found = all;
  for (Measured& one : found)
    for (const Measured& finer : all)
      if (!finer.late && is_as_fine(finer, one)) one.error = std::max(one.error, finer.error);
  return found;
}

Measurements front(Measurements all) {
  std::sort(all.begin(), all.end(), [](const Measured& a, const Measured& b) {
    return std::pair(a.median(), a.error) < std::pair(b.median(), b.error);
  });
  Measurements found;
  for (const Measured& one : all)
    if (std::isfinite(one.error) && (found.empty() || one.error < found.back().error)) found.push_back(one);
  return found;
}

bool is_near_front(const Measured& one, const Measurements& all, double slack) {
  return std::isfinite(one.error) && one.median() <= slack * cheapest(all, one.error)->median();
}

std::optional<Measured> cheapest(const Measurements& all, double error) {
  std::optional<Measured> found;
  for (const Measured& one : all)
    if (one.error <= error && (!found || one.median() < found->median())) found = one;
  return found;
}

int faster(const Measured& one, const Measured& other) {
  constexpr double least = 1.1;
  if (other.median() >= least * one.median() && other.quartile(1) > one.quartile(3)) return 1;
  return one.median() >= least * other.median() && one.quartile(1) > other.quartile(3) ? -1 : 0;
}

int faster(const Measurements& ones, const Measurements& others, double error) {
  int sum = 0;
  for (const double near : {0.8 * error, error, 1.25 * error}) {
    const auto one = cheapest(ones, near), other = cheapest(others, near);
    sum += one && other ? faster(*one, *other) : (one ? 1 : 0) - (other ? 1 : 0);
  }
  return sum / 3;
}

double slope(const std::vector<double>& x, const std::vector<double>& y) {
  double mean_x = 0, mean_y = 0, xx = 0, xy = 0;
  const auto n = static_cast<double>(x.size());
  for (std::size_t i = 0; i < x.size(); ++i) {
    mean_x += std::log(x[i]) / n;
    mean_y += std::log(y[i]) / n;
  }
  for (std::size_t i = 0; i < x.size(); ++i) {
    xx += (std::log(x[i]) - mean_x) * (std::log(x[i]) - mean_x);
    xy += (std::log(x[i]) - mean_x) * (std::log(y[i]) - mean_y);
  }
  return xy / xx;
}

}  // namespace pushback::study
