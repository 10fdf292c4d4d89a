/// How thin a semicircular arch may be: limit analysis of its line of thrust.
#pragma once

#include "pushback/common/basics/types.h"

namespace pushback {

/// The thinnest arch that stands, and the thrust in it.
struct ThinnestArch {
  Real thickness;  ///< of the mean radius
  Real thrust;     ///< H, level, of the weight of half the arch
};

/// A semicircle of `voussoirs` equal wedges, at least 2, of one thickness. No joint pulls, and none slips. It stands exactly if
/// there is a line of thrust within all joints (Heyman, The Stone Skeleton, 1966: the safe theorem). With many wedges the thickness
/// tends to 0.1075 (Milankovitch, Theorie der Druckkurven, 1907).
ThinnestArch thinnest_arch(int voussoirs);

}  // namespace pushback
