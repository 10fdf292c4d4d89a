/// What exercise 17 asks for.
#pragma once

#include <Eigen/Core>
#include <utility>

#include "pushback/common/exercise/exercise.h"

namespace pushback::exercise_17 {

/// Equations, each solved for one variable, its basic one. All other variables are 0.
struct Tableau {
  Eigen::MatrixXd t;                ///< a column for each variable, and last what each equation equals
  std::vector<Eigen::Index> basis;  ///< the basic variable of each row: its column
};

struct Answer {
  Eigen::Index (*pivot)(Tableau& tableau, Eigen::Index entering);
};

std::vector<Check<Answer>> checks_of(const Answer& /*any*/);

}  // namespace pushback::exercise_17
