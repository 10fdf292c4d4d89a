#include "pushback/tools/measure/frozen/siconos.h"

#include <fmt/ranges.h>

#include <sstream>
#include <stdexcept>

#include "pushback/chapters/16_whole_problem/problem_file.h"
#include "pushback/common/basics/input.h"
#include "pushback/common/basics/process.h"

namespace pushback::frozen {

namespace {

constexpr std::string_view program = PUSHBACK_SICONOS_PROGRAM;  // empty: it is not built in

Ended asked(const std::vector<std::string>& arguments, double patience, const std::string& input) {
  if (program.empty()) throw InvalidInput("Siconos is asked: a build with PUSHBACK_SICONOS is needed");
  std::vector<std::string> command{std::string(program)};
  command.insert(command.end(), arguments.begin(), arguments.end());
  Ended ended = run_program(command, patience, input);
  if (ended.status != 0 && !ended.out_of_time)
    throw std::runtime_error(fmt::format("'{}' has given up: {}", fmt::join(command, " "), ended.err));
  return ended;
}

}  // namespace

std::vector<std::string> siconos_methods() {
  if (program.empty()) return {};
  return {"Siconos NSGS", "Siconos NSN_AC", "Siconos ADMM"};
}

SiconosAnswer solve_by_siconos(const ContactProblem& problem, const std::string& method, double tolerance,
                               int iterations, double patience) {
  const std::vector<std::string> all = siconos_methods();
  if (std::find(all.begin(), all.end(), method) == all.end())
    throw InvalidInput(fmt::format("method is '{}': one of these is needed, of a build with PUSHBACK_SICONOS: {}",
                                   method, fmt::join(all, ", ")));
  const Ended ended =
      asked({method, fmt::format("{}", tolerance), std::to_string(iterations)}, patience, problem_text(problem));
  SiconosAnswer answer{.r = Vector::Zero(problem.q.size())};
  if (ended.out_of_time) {
    answer.seconds = patience;
    return answer;
  }
  std::istringstream said(ended.out);
  int info = 1;
  said >> answer.iterations >> info >> answer.seconds;
  std::string word;
  for (double& each : answer.r)
    if (said >> word) each = std::strtod(word.c_str(), nullptr);  // it may be nan
  if (!said) throw std::runtime_error(fmt::format("{} printed no solution: {}", method, ended.out.substr(0, 200)));
  answer.reached = info == 0;
  return answer;
}

double siconos_error(const ContactProblem& problem, const Vector& r) {
  std::string input = problem_text(problem);
  for (const double each : r) input += fmt::format("{}\n", each);
  return std::stod(asked({"error"}, 0, input).out);
}

}  // namespace pushback::frozen
