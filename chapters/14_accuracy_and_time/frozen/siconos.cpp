#include "chapters/14_accuracy_and_time/frozen/siconos.h"

#include <FrictionContactProblem.h>
#include <Friction_cst.h>
#include <NonSmoothDrivers.h>
#include <NumericsVerbose.h>
#include <SolverOptions.h>
#include <fc3d_compute_error.h>
#include <sn_error_handling.h>

#include <cstdio>
#include <memory>
#include <stdexcept>

#include "chapters/13_global_solve/problem_file.h"
#include "chapters/14_accuracy_and_time/stopwatch.h"
#include "common/input.h"

namespace pushback {

namespace {

struct Method {
  const char* name;
  int id;
};
constexpr Method methods[] = {{"Siconos NSGS", SICONOS_FRICTION_3D_NSGS},
                              {"Siconos NSN_AC", SICONOS_FRICTION_3D_NSN_AC},
                              {"Siconos ADMM", SICONOS_FRICTION_3D_ADMM}};

template <class T, auto free>
struct Freed {
  void operator()(T* what) const { free(what); }
};
using Problem = std::unique_ptr<FrictionContactProblem, Freed<FrictionContactProblem, frictionContactProblem_free>>;
using Options = std::unique_ptr<SolverOptions, Freed<SolverOptions, solver_options_delete>>;

/// Through the text of its own format: every number in as many digits as give the same bits. A new one for each call, since
/// the solvers keep what they make of a matrix beside it.
Problem in_siconos(const ContactProblem& problem) {
  std::string text = problem_text(problem);
  const std::unique_ptr<std::FILE, Freed<std::FILE, std::fclose>> file(fmemopen(text.data(), text.size(), "r"));
  if (!file) throw std::runtime_error("no memory for a problem of Siconos");
  Problem made(frictionContact_newFromFile(file.get()));
  if (!made) throw std::runtime_error("Siconos does not read the problem");
  return made;
}

/// Siconos keeps it for the whole program; it prints by that.
void be_silent() {
  numerics_set_verbose(0);
}

/// What it calls fatal is a jump to here, or the program's end where nobody waits. So nothing in here has a destructor.
bool drive(FrictionContactProblem* problem, double* r, double* u, SolverOptions* options, int* info) {
  if (SN_SETJMP_EXTERNAL_START != 0) return false;
  *info = fc3d_driver(problem, r, u, options);
  SN_SETJMP_EXTERNAL_STOP
  return true;
}

}  // namespace

std::vector<std::string> siconos_methods() {
  std::vector<std::string> names;
  for (const Method& method : methods) names.emplace_back(method.name);
  return names;
}

SiconosAnswer solve_by_siconos(const ContactProblem& problem, const std::string& method, double tolerance,
                               int iterations) {
  const Method* asked = nullptr;
  for (const Method& each : methods)
    if (each.name == method) asked = &each;
  if (asked == nullptr)
    throw InvalidInput(fmt::format("method is '{}': one of {} is needed", method, fmt::join(siconos_methods(), ", ")));
  be_silent();
  const Problem made = in_siconos(problem);
  const Options options(solver_options_create(asked->id));
  options->dparam[SICONOS_DPARAM_TOL] = tolerance;
  options->iparam[SICONOS_IPARAM_MAX_ITER] = iterations;
  SiconosAnswer answer{.r = Vector::Zero(problem.q.size())};
  Vector u = Vector::Zero(problem.q.size());
  int info = 1;
  Stopwatch solving;
  solving.go();
  const bool came_back = drive(made.get(), answer.r.data(), u.data(), options.get(), &info);
  solving.stop();
  if (!came_back) throw std::runtime_error(method + " has given up by what Siconos calls a fatal error");
  answer.iterations = options->iparam[SICONOS_IPARAM_ITER_DONE];
  answer.reached = info == 0;
  answer.seconds = solving.seconds();
  return answer;
}

double siconos_error(const ContactProblem& problem, const Vector& r) {
  be_silent();
  const Problem made = in_siconos(problem);
  const Options options(solver_options_create(SICONOS_FRICTION_3D_NSGS));  // a place for its workings
  Vector at = r, u = Vector::Zero(r.size());
  double error = 0;
  const double unit = problem.q.norm();
  fc3d_compute_error(made.get(), at.data(), u.data(), 1, options.get(), unit > 0 ? unit : 1, &error);
  return error;
}

}  // namespace pushback
