/// The ways to sweep a contact problem, by name; and what any method leaves.
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
  double work = 0;      ///< multiplications; 0 where they were not counted
};

/// pgs: friction in a pyramid; scaled-back: both tangents solved, then scaled back; cone: the exact law; nscg: conjugate
/// gradients over sweeps of the cone.
std::vector<std::string> sweeping_method_names();

/// One sweep of a method over all contacts: r is changed. It refers to the problem, and may remember where it was going.
using Sweep = std::function<void(Vector&)>;

/// Throws InvalidInput where there is no such method.
Sweep sweep_of(const ContactProblem& problem, const std::string& method);

/// From r = 0, until relative_residual is `tolerance` at most, looked at after every tenth sweep, or `sweeps` are done. Throws
/// InvalidInput where there is no such method.
Solution solve_by_sweeps(const ContactProblem& problem, const std::string& method, int sweeps, double tolerance);

}  // namespace pushback
