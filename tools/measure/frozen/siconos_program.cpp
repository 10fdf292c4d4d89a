/// Siconos solves a contact problem: a program of its own, since Siconos 4.4 does not give back all the memory that it takes, and what it
/// calls a fatal error is the end of a program.
///
///   siconos "Siconos NSGS" TOLERANCE ITERATIONS <PROBLEM    prints iterations, 0 if it has reached that, seconds, and then the impulses
///   siconos error <PROBLEM-AND-IMPULSES                prints its own error of these impulses, relative to ||q||
#include <FrictionContactProblem.h>
#include <Friction_cst.h>
#include <NonSmoothDrivers.h>
#include <NumericsVerbose.h>
#include <SolverOptions.h>
#include <fc3d_compute_error.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <numeric>
#include <string>
#include <vector>

#include "pushback/common/basics/stopwatch.h"

int main(int argc, char** argv) {
  const std::map<std::string, int> methods{{"Siconos NSGS", SICONOS_FRICTION_3D_NSGS},
                                           {"Siconos NSN_AC", SICONOS_FRICTION_3D_NSN_AC},
                                           {"Siconos ADMM", SICONOS_FRICTION_3D_ADMM},
                                           {"error", SICONOS_FRICTION_3D_NSGS}};  // for a place for its workings
  const std::string asked = argc > 1 ? argv[1] : "";
  const bool only_error = asked == "error";
  if (!methods.contains(asked) || argc != (only_error ? 2 : 4)) return 2;
  FrictionContactProblem* const problem = frictionContact_newFromFile(stdin);
  if (!problem) return 1;
  numerics_set_verbose(0);
  SolverOptions* const options = solver_options_create(methods.at(asked));
  std::vector<double> r(3 * static_cast<std::size_t>(problem->numberOfContacts)), u = r;
  if (only_error) {
    for (double& each : r)
      if (std::scanf("%lf", &each) != 1) return 1;
    const double norm = std::sqrt(std::inner_product(problem->q, problem->q + r.size(), problem->q, 0.0));
    double error = 0;
    fc3d_compute_error(problem, r.data(), u.data(), 1, options, norm > 0 ? norm : 1, &error);
    std::printf("%.17g\n", error);
    return 0;
  }
  options->dparam[SICONOS_DPARAM_TOL] = std::atof(argv[2]);
  options->iparam[SICONOS_IPARAM_MAX_ITER] = std::atoi(argv[3]);
  pushback::Stopwatch solving;
  solving.go();
  const int info = fc3d_driver(problem, r.data(), u.data(), options);
  solving.stop();
  std::printf("%d %d %.17g\n", options->iparam[SICONOS_IPARAM_ITER_DONE], info, solving.seconds());
  for (const double each : r) std::printf("%.17g\n", each);
}
