#include "pushback/tools/measure/results/built_by.h"

namespace pushback {

std::string built_by() {
#ifdef __clang__
  const std::string compiler = __VERSION__;
#else
  const std::string compiler = "g++ " __VERSION__;
#endif
  return compiler + ", " PUSHBACK_FLAGS;
}

}  // namespace pushback
