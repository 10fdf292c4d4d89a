// For any processor. Eight lanes take as many registers as they need.
#include "pushback/engine/substeps/passes.h"

namespace pushback {

template <>
Passes<float> plain_passes(int lanes) {
  return passes_for<float>("any processor", lanes);
}
template <>
Passes<double> plain_passes(int lanes) {
  return passes_for<double>("any processor", lanes);
}

}  // namespace pushback
