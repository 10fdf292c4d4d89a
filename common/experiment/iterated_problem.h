/// One step's problem, held still: its matrix, and what solves it iteration by iteration. A page draws both.
#pragma once

#include <Eigen/SparseCore>
#include <functional>
#include <string>
#include <vector>

namespace pushback {

struct IteratedProblem {
  struct Method {
    std::string name;
    /// Takes the impulses on by one iteration; at first they are 0. False where it has nothing left to do: they are as before then.
    std::function<bool(Eigen::VectorXd&)> iterate;
  };

  Eigen::SparseMatrix<double, Eigen::RowMajor> matrix =
      {};                       ///< 1/kg: the speed of a row by an impulse of 1 N s on another
  int block = 1;                ///< so many rows, one after the other, belong together
  std::string block_name = "";  ///< as what: "contact"
  std::string iteration = "";   ///< what one is: "a sweep over all contacts"
  std::string measure = "";     ///< what `residual` is
  std::function<double(const Eigen::VectorXd&)> residual = {};
  std::vector<Method> methods = {};  ///< four at most
  int most = 1000;                   ///< iterations
};

}  // namespace pushback
