/// The least thickness of a semicircular arch, by limit analysis of its line of thrust.
#pragma once

#include "pushback/common/basics/types.h"

namespace pushback {

/// The thinnest arch that stands, and the thrust in it.
struct ThinnestArch {
  Real thickness;  ///< as a fraction of the mean radius
  Real thrust;     ///< H, horizontal, as a fraction of the weight of half the arch
};

/// A semicircle of `voussoirs` equal wedges, at least 2, of one thickness. Joints cannot pull, and they do not slip. The arch stands if
/// and only if there is a line of thrust within all joints (the safe theorem, Heyman, The Stone Skeleton, 1966). With many wedges the
/// thickness tends to 0.1075 (Milankovitch, Theorie der Druckkurven, 1907).
ThinnestArch thinnest_arch(int voussoirs);

}  // namespace pushback
