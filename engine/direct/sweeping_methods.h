/// The sweeping methods by name, and the solution that any method returns.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "pushback/engine/direct/contact_problem.h"

namespace pushback {

struct Solution {
  Vector r;             ///< N s
  double residual = 0;  ///< relative_residual
  int sweeps = 0;       ///< over all contacts
  int systems = 0;      ///< linear systems solved
  int pivots = 0;       ///< exchanges of a variable for its partner
  double work = 0;      ///< multiplications; 0 if they were not counted
};

/// "pgs": friction pyramid. "scaled-back": both tangents solved, then scaled back to the cone. "cone": the exact law. "nscg":
/// conjugate gradients with sweeps of "cone".
std::vector<std::string> sweeping_method_names();

/// One sweep of a method over all contacts, which changes r. It keeps a reference to the problem, which must outlive it, and may
/// keep data from sweep to sweep.
using Sweep = std::function<void(Vector&)>;

/// Throws InvalidInput if there is no such method.
Sweep sweep_of(const ContactProblem& problem, const std::string& method);

/// Sweeps from r = 0 until relative_residual is at most `tolerance`, which is tested after every tenth sweep, or for `sweeps`
/// sweeps. Throws InvalidInput if there is no such method.
Solution solve_by_sweeps(const ContactProblem& problem, const std::string& method, int sweeps, double tolerance);

}  // namespace pushback
