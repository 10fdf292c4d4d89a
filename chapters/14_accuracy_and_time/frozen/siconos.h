/// An independent judge: the solvers of Siconos (Inria), and its own measure of error, on the same contact problems.
///
/// Built in with the option PUSHBACK_SICONOS, where Debian's libsiconos-numerics-dev is. Where it is not, there are no methods.
#pragma once

#include <string>
#include <vector>

#include "chapters/13_global_solve/contact_problem.h"

namespace pushback {

/// "Siconos NSGS": non-smooth Gauss-Seidel, each contact's own problem solved exactly in turn; "Siconos NSN_AC": Newton's
/// method on Alart's and Curnier's function; "Siconos ADMM": alternating directions. Empty where Siconos is not built in.
std::vector<std::string> siconos_methods();

struct SiconosAnswer {
  Vector r;              ///< N s; from r = 0
  int iterations = 0;    ///< as Siconos counts them
  bool reached = false;  ///< what Siconos says itself
  double seconds = 0;    ///< of its driver alone, conversions of W that it makes for itself included
};

/// With the options that are the method's default, but for the tolerance, of relative_residual, and the most iterations.
/// Throws InvalidInput where the method is none, std::runtime_error where Siconos gives up by what it calls a fatal error.
SiconosAnswer solve_by_siconos(const ContactProblem& problem, const std::string& method, double tolerance,
                               int iterations);

/// Siconos' own error of r, the natural map's, of the length of q: what relative_residual should be. Not divided where q is 0.
double siconos_error(const ContactProblem& problem, const Vector& r);

}  // namespace pushback
