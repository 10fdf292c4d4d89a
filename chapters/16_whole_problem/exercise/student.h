/// Exercise 16: the residual by the natural map. The task is chapters/16_whole_problem/exercise/task.md.
#pragma once

#include "pushback/chapters/16_whole_problem/exercise/asked.h"

namespace student {

using namespace pushback;

/// The error of the impulses r; 0 exactly if they solve the problem.
///
/// You read   problem.contacts()    the number of contacts
///            problem.mu[c]         the coefficient of friction of contact c
///            problem.q             q, m/s
///            r.segment<3>(3 * c)   the impulses of contact c, N s: along the normal, and along two tangents
///            u.segment<3>(3 * c)   its speeds, m/s, in the same order
inline double residual(const ContactProblem& problem, const Vector& r) {
  const Vector u = problem.speeds(r);
  // TODO the natural map: the projection of r - (u + mu |u_t| n) to each contact's cone, and the error as a fraction of |q|
  return 0 * u.norm();  // take this line out
  // TODO ends
}

inline const exercise_16::Answer answer{residual};

}  // namespace student
