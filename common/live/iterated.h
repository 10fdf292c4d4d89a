/// A problem that is solved iteration by iteration, forwards and backwards.
#pragma once

#include "pushback/common/experiment/iterated_problem.h"

namespace pushback {

/// Keeps the impulses after every iteration of every method, so that going back restores them to the last bit.
class Iterated {
 public:
  explicit Iterated(IteratedProblem problem);

  const IteratedProblem& problem() const { return problem_; }
  int now() const { return now_; }
  /// Goes to any iteration from 0 to the problem's `most`. A method that has finished stays at its last iteration.
  void go_to(int iteration);
  /// The current impulses, N s, one per row.
  const Eigen::VectorXd& impulses(std::size_t method) const;
  /// The residuals after 0, 1, 2 ... iterations, up to the last iteration computed.
  const std::vector<double>& residuals(std::size_t method) const { return courses_[method].residuals; }

 private:
  struct Course {
    std::vector<Eigen::VectorXd> impulses;
    std::vector<double> residuals;
    bool ended = false;
  };

  IteratedProblem problem_;
  std::vector<Course> courses_;
  int now_ = 0;
};

}  // namespace pushback
