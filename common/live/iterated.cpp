#include "pushback/common/live/iterated.h"

#include <algorithm>

namespace pushback {

Iterated::Iterated(IteratedProblem problem) : problem_(std::move(problem)), courses_(problem_.methods.size()) {
  for (Course& course : courses_) {
    course.impulses.emplace_back(Eigen::VectorXd::Zero(problem_.matrix.rows()));
    course.residuals.push_back(problem_.residual(course.impulses.back()));
  }
}

void Iterated::go_to(int iteration) {
  now_ = std::clamp(iteration, 0, problem_.most);
  for (std::size_t i = 0; i < courses_.size(); ++i) {
    Course& course = courses_[i];
    while (!course.ended && std::ssize(course.impulses) <= now_) {
      Eigen::VectorXd next = course.impulses.back();
      course.ended = !problem_.methods[i].iterate(next);
      if (course.ended) break;
      course.residuals.push_back(problem_.residual(next));
      course.impulses.push_back(std::move(next));
    }
  }
}

const Eigen::VectorXd& Iterated::impulses(std::size_t method) const {
  const std::vector<Eigen::VectorXd>& all = courses_[method].impulses;
  return all[std::min(static_cast<std::size_t>(now_), all.size() - 1)];
}

}  // namespace pushback
