/// Plays a scene within an error, and measures its true error.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "pushback/engine/islands/twin_solver.h"

namespace pushback {

struct PlayedStep {
  double seconds = 0;  ///< computing time
  Real known = 0;      ///< m, the largest reported error of a body
  int bodies_kept = 0, bodies = 0;
  BodyError most = {};              ///< of the body with the largest error
  std::map<std::string, int> ways;  ///< the number of bodies that were moved in each way
};
struct Played {
  std::vector<PlayedStep> steps;
  std::vector<World> worlds;  ///< after each step, coloured by how bodies were moved

  double seconds() const;
};

constexpr Real dt_within = Real(1) / 60;  ///< s
constexpr int finer_truth = 16;           ///< the usual `finer` of `off`

Played play_within(World world, Real error, int steps);

/// The distance from the same scene in steps `finer` times shorter, within an error `finer` times smaller, after each step, m.
std::vector<Real> off(World world, const Played& played, Real error, int finer);

/// The rate at which a difference grows from `error` to a hundred times that, 1/s. `differences` are `dt` (s) apart. None if the
/// difference does not grow so far, or does so in less than a quarter of a second.
std::optional<Real> growth(const std::vector<Real>& differences, Real error, Real dt);

}  // namespace pushback
