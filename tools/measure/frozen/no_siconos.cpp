/// Where Siconos is not built in.
#include "pushback/common/basics/input.h"
#include "pushback/tools/measure/frozen/siconos.h"

namespace pushback::frozen {

std::vector<std::string> siconos_methods() {
  return {};
}

SiconosAnswer solve_by_siconos(const ContactProblem&, const std::string& method, double, int, double) {
  throw InvalidInput(fmt::format("method is '{}': a build with PUSHBACK_SICONOS is needed", method));
}

double siconos_error(const ContactProblem&, const Vector&) {
  throw InvalidInput("Siconos' error: a build with PUSHBACK_SICONOS is needed");
}

}  // namespace pushback::frozen
