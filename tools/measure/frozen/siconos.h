/// An independent comparison, the solvers of Siconos (Inria) and its own measure of error on the same contact problems.
///
/// Built with the option PUSHBACK_SICONOS, which needs Debian's libsiconos-numerics-dev. Without it there are no methods.
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "pushback/chapters/17_direct_contacts/methods.h"
#include "pushback/engine/direct/contact_problem.h"

namespace pushback::frozen {

/// "Siconos NSGS" (non-smooth Gauss-Seidel, which solves each contact's problem exactly in turn), "Siconos NSN_AC" (Newton's method
/// for Alart's and Curnier's function), and "Siconos ADMM" (alternating directions). Empty if Siconos is not built in.
std::vector<std::string> siconos_methods();

struct SiconosAnswer {
  Vector r;              ///< N s; starts from r = 0
  int iterations = 0;    ///< counted by Siconos
  bool reached = false;  ///< whether Siconos reports that it has reached the tolerance
  double seconds = 0;    ///< s, of its driver only, including its own conversions of W
};

/// Uses the method's default options, except for the tolerance (of siconos_error) and the maximum number of iterations. A run that
/// takes longer than `patience` s is ended, and its answer is r = 0 after this time. Throws InvalidInput if there is no such method,
/// and std::runtime_error if Siconos reports a fatal error.
SiconosAnswer solve_by_siconos(const ContactProblem& problem, const std::string& method, double tolerance,
                               int iterations, double patience = 600);

/// Siconos' own error of r. It is the error of the natural map, as in relative_residual, but relative to siconos_unit.
double siconos_error(const ContactProblem& problem, const Vector& r);

/// The number by which Siconos 4.4 divides, the largest of ||q||, ||r|| and ||u||, while we divide by ||q||. If ||q|| = 0, it is
/// 1 instead. So Siconos' error is never above ours, and it is far below ours if impulses in N s are large numbers.
inline double siconos_unit(const ContactProblem& problem, const Vector& r) {
  const double q = problem.q.norm();
  return std::max({q > 0 ? q : 1, r.norm(), problem.speeds(r).norm()});
}

/// All compared methods, first the methods of chapters 16 and 17, then the methods of Siconos if it is built in.
inline std::vector<std::string> frozen_methods() {
  std::vector<std::string> names = method_names();
  for (const std::string& name : siconos_methods()) names.push_back(name);
  return names;
}

inline bool is_siconos(const std::string& method) {
  return method.starts_with("Siconos ");
}

}  // namespace pushback::frozen
