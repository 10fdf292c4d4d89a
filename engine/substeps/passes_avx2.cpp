// Compiled with -mavx2, and called only on processors with AVX2. It must not include Eigen, containers of the standard library
// or other headers with inline functions. The linker keeps one copy of an inline function, and if that were this file's, other
// processors would fail.
#include "pushback/engine/substeps/passes.h"

namespace pushback {

template <>
Passes<float> avx2_passes(int lanes) {
  return passes_for<float>("AVX2", lanes);
}
template <>
Passes<double> avx2_passes(int lanes) {
  return passes_for<double>("AVX2", lanes);
}

}  // namespace pushback
