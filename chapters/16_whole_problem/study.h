/// The error that sweeps leave, and the criteria by which sweeps stop.
#pragma once

#include <algorithm>

#include "pushback/common/experiment/plot.h"
#include "pushback/common/world/situations.h"
#include "pushback/engine/direct/row_matrix.h"
#include "pushback/engine/direct/sweeping_methods.h"

namespace pushback::whole_problem_scenes {

/// The contacts of a scene at the start of a step, and the rows of their normals.
struct Snapshot {
  World world;
  Rows normals;

  template <class Fill>
  Snapshot(Fill fill, Real dt) {
    fill(world);
    world.begin_step(dt);
    for (std::size_t i = 0; i < world.contacts.size(); ++i)
      normals.emplace_back(world, world.contacts[i], world.contacts[i].normal, i);
  }
};

/// The entries of A that are not 0.
inline Curve pattern(const SparseMatrix& a) {
  Curve curve{"", {}, {}, line_colour(0), Curve::Style::points};
  for (Eigen::Index row = 0; row < a.rows(); ++row) {
    for (SparseMatrix::InnerIterator it(a, row); it; ++it) {
      if (it.value() == 0) continue;
      curve.x.push_back(static_cast<Real>(it.col()));
      curve.y.push_back(static_cast<Real>(row));
    }
  }
  return curve;
}

/// The powers of 1.3 up to `most`, rounded down, each number once.
inline std::vector<int> sweep_counts(int most) {
  std::vector<int> counts;
  for (double count = 1; count <= most; count *= 1.3)
    if (counts.empty() || static_cast<int>(count) > counts.back()) counts.push_back(static_cast<int>(count));
  return counts;
}

/// The residual against the number of sweeps, from zero impulses.
inline Curve convergence(const ContactProblem& problem, const std::string& method, const std::string& name,
                         std::size_t colour) {
  Curve curve{name, {}, {}, line_colour(colour), Curve::Style::line};
  for (const int sweeps : sweep_counts(3000)) {
    curve.x.push_back(static_cast<Real>(sweeps));
    curve.y.push_back(static_cast<Real>(std::max(solve_by_sweeps(problem, method, sweeps, 0).residual, 1e-17)));
  }
  return curve;
}

/// Merges curves with the same x that differ by at most 5 % everywhere, about the width of a line, into one with the names of
/// all.
inline std::vector<Curve> merged(const std::vector<Curve>& curves) {
  std::vector<Curve> apart;
  for (const Curve& curve : curves) {
    const auto same = std::find_if(apart.begin(), apart.end(), [&](const Curve& other) {
      return std::equal(curve.y.begin(), curve.y.end(), other.y.begin(), other.y.end(),
                        [](Real a, Real b) { return std::abs(a - b) <= Real(0.05) * std::max(a, b); });
    });
    if (same == apart.end()) apart.push_back(curve);
    else same->label += ", " + curve.label;
  }
  return apart;
}

/// Two criteria that can be evaluated after each sweep, and the true error, each relative to its full size.
struct Signs {
  std::vector<double> correction;  ///< largest corrective impulse of the sweep, relative to the largest at the end
  std::vector<double> speed;       ///< largest closing speed of a contact, relative to the largest at the start
  std::vector<double> error;       ///< largest vertical speed of a body, relative to g h, which gravity has added
};

/// Sweeps the contacts `sweeps` times without friction. The bodies were at rest before this step.
inline Signs signs(const Snapshot& snapshot, int sweeps) {
  const SparseMatrix a = matrix_of(snapshot.normals);
  const Vector b = speeds_of(snapshot.normals);
  const auto error = [&](const Vector& impulses) {
    Vector speeds(std::ssize(snapshot.world.bodies));
    for (const Body& body : snapshot.world.bodies) speeds[body.index] = static_cast<double>(body.velocity.y());
    for (std::size_t i = 0; i < snapshot.normals.size(); ++i) {
      const Row& row = snapshot.normals[i];
      speeds[row.a->index] += impulses[static_cast<Eigen::Index>(i)] * static_cast<double>(row.dva.y());
      speeds[row.b->index] += impulses[static_cast<Eigen::Index>(i)] * static_cast<double>(row.dvb.y());
    }
    return speeds.cwiseAbs().maxCoeff();
  };
  Vector impulses = Vector::Zero(b.size());
  const double at_start = error(impulses);
  Signs found;
  for (int sweep = 0; sweep < sweeps; ++sweep) {
    const Vector before = impulses;
    for (Eigen::Index i = 0; i < b.size(); ++i) project_row(a, b, i, 0, 1e300, impulses);
    found.correction.push_back((impulses - before).cwiseAbs().maxCoeff());
    found.speed.push_back(std::max(0.0, -(a * impulses + b).minCoeff()) / -b.minCoeff());
    found.error.push_back(error(impulses) / at_start);
  }
  for (double& correction : found.correction) correction /= impulses.maxCoeff();
  return found;
}

/// The first sweep after which `values` is below `limit`; -1 if there is none.
inline int first_below(const std::vector<double>& values, double limit) {
  for (std::size_t i = 0; i < values.size(); ++i)
    if (values[i] < limit) return static_cast<int>(i) + 1;
  return -1;
}

inline Curve curve_of(const std::vector<double>& values, const std::string& name, std::size_t colour) {
  Curve curve{name, {}, {}, line_colour(colour), Curve::Style::line};
  for (const int sweep : sweep_counts(static_cast<int>(values.size()))) {
    curve.x.push_back(static_cast<Real>(sweep));
    curve.y.push_back(static_cast<Real>(std::max(values[static_cast<std::size_t>(sweep) - 1], 1e-12)));
  }
  return curve;
}

}  // namespace pushback::whole_problem_scenes
