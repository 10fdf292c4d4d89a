/// The problem of one step: its matrix, and the methods that solve it iteration by iteration. An interactive page draws both.
#pragma once

#include <Eigen/SparseCore>
#include <functional>
#include <string>
#include <vector>

namespace pushback {

struct IteratedProblem {
  struct Method {
    std::string name;
    /// Advances the impulses (N s, at first 0) by one iteration. Returns false, and leaves them unchanged, if the method has finished.
    std::function<bool(Eigen::VectorXd&)> iterate;
  };

  Eigen::SparseMatrix<double, Eigen::RowMajor> matrix =
      {};                       ///< 1/kg: the change in a row's speed per impulse on another row
  int block = 1;                ///< number of consecutive rows that belong together
  std::string block_name = "";  ///< name of a block: "contact"
  std::string iteration = "";   ///< name of an iteration: "a sweep over all contacts"
  std::string measure = "";     ///< name of `residual`
  std::function<double(const Eigen::VectorXd&)> residual = {};
  std::vector<Method> methods = {};  ///< four at most
  int most = 1000;                   ///< maximum number of iterations
};

}  // namespace pushback
