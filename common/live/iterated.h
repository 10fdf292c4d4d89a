/// A problem that is solved to and fro.
#pragma once

#include "pushback/common/experiment/iterated_problem.h"

namespace pushback {

/// Impulses are kept after every iteration of every method, so that going back gives what was there, to the last bit.
class Iterated {
 public:
  explicit Iterated(IteratedProblem problem);

  const IteratedProblem& problem() const { return problem_; }
  int now() const { return now_; }
  /// To any iteration, from 0 to the problem's `most`. A method that has come to its end stays there.
  void go_to(int iteration);
  /// N s, a row each, as they are now.
  const Eigen::VectorXd& impulses(std::size_t method) const;
  /// After 0, 1, 2 ... iterations, as far as they are known, or as the method goes.
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
