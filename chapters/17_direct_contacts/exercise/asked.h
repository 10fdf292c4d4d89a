/// The answer to exercise 17, and its checks.
#pragma once

#include <Eigen/Core>
#include <utility>

#include "pushback/common/exercise/exercise.h"

namespace pushback::exercise_17 {

/// Equations. Each is solved for one variable, its basic variable. All other variables are 0.
struct Tableau {
  Eigen::MatrixXd t;                ///< a column for each variable, and last the right-hand sides
  std::vector<Eigen::Index> basis;  ///< the column of the basic variable of each row
};

struct Answer {
  Eigen::Index (*pivot)(Tableau& tableau, Eigen::Index entering);
};

std::vector<Check<Answer>> checks_of(const Answer& /*any*/);

}  // namespace pushback::exercise_17
