/// An independent judge: the solvers of Siconos (Inria), and its own measure of error, on the same contact problems.
///
/// Built with the option PUSHBACK_SICONOS, where Debian's libsiconos-numerics-dev is. Where it is not, there are no methods.
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "pushback/chapters/17_direct_contacts/methods.h"
#include "pushback/engine/direct/contact_problem.h"

namespace pushback::frozen {

/// "Siconos NSGS": non-smooth Gauss-Seidel, each contact's own problem solved exactly in turn; "Siconos NSN_AC": Newton's
/// method on Alart's and Curnier's function; "Siconos ADMM": alternating directions. Empty where Siconos is not built in.
std::vector<std::string> siconos_methods();

struct SiconosAnswer {
  Vector r;              ///< N s; from r = 0
  int iterations = 0;    ///< as Siconos counts them
  bool reached = false;  ///< what Siconos says itself
  double seconds = 0;    ///< of its driver alone, conversions of W that it makes for itself included
};

/// With the options that are the method's default, but for the tolerance, of siconos_error, and the most iterations.
/// A run that takes longer than `patience` s is ended, and its answer is r = 0 after so many seconds.
/// Throws InvalidInput where the method is none, std::runtime_error where Siconos gives up by what it calls a fatal error.
SiconosAnswer solve_by_siconos(const ContactProblem& problem, const std::string& method, double tolerance,
                               int iterations, double patience = 600);

/// Siconos' own error of r. It is the natural map's, as in relative_residual, but relative to siconos_unit.
double siconos_error(const ContactProblem& problem, const Vector& r);

/// What Siconos 4.4 divides by: the largest of ||q||, ||r|| and ||u||, where we divide by ||q||. 1 in the place of ||q|| = 0.
/// Its error is never above ours, and far below where impulses in N s are large numbers.
inline double siconos_unit(const ContactProblem& problem, const Vector& r) {
  const double q = problem.q.norm();
  return std::max({q > 0 ? q : 1, r.norm(), problem.speeds(r).norm()});
}

/// All methods that are compared: those of chapters 16 and 17, then those of Siconos if it was found.
inline std::vector<std::string> frozen_methods() {
  std::vector<std::string> names = method_names();
  for (const std::string& name : siconos_methods()) names.push_back(name);
  return names;
}

inline bool is_siconos(const std::string& method) {
  return method.starts_with("Siconos ");
}

}  // namespace pushback::frozen
