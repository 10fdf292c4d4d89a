// Compiled with -mavx2, and called only where the processor has that. Nothing of Eigen, of the standard library's containers or
// of our own headers with functions is included: the linker keeps one copy of an inline function, and it may keep this file's.
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
