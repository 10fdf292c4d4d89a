/// The ways to solve a contact problem, by name.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "pushback/chapters/17_direct_contacts/best.h"

namespace pushback {

/// pgs: sweeps, friction in a pyramid; scaled-back: both tangents solved, then scaled back; cone: the exact law;
/// nscg: conjugate gradients over sweeps of the cone; best: what it takes, sweeps and Newton's method.
std::vector<std::string> method_names();

/// One sweep of a method over all contacts: r is changed. It refers to the problem, and may remember where it was going.
using Sweep = std::function<void(Vector&)>;

/// Empty for `best`, which is no matter of sweeps. Throws InvalidInput where there is no such method.
Sweep sweep_of(const ContactProblem& problem, const std::string& method);

/// From r = 0, until relative_residual is `tolerance` at most, looked at after every tenth sweep, or `sweeps` are done. `best`
/// counts its own sweeps and takes the tolerance only. Throws InvalidInput where there is no such method.
Solution solve(const ContactProblem& problem, const std::string& method, int sweeps, double tolerance);

}  // namespace pushback
