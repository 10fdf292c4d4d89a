/// A student's bodies and the right ones, seen by one camera.
#pragma once

#include <string>
#include <vector>

#include "pushback/common/experiment/legend.h"
#include "pushback/common/render/image.h"
#include "pushback/tools/classroom/telling_instant.h"

namespace pushback {

struct BodiesPicture {
  Image yours, right;
  std::vector<LegendEntry> legend;
  std::string note;  ///< what else there is to know of it; may be empty
};

/// Velocities and impulses are drawn where they differ, on one scale. A deviation that is too small to see is drawn larger, and
/// the note says how many times; `of_place`: whatever the velocities do. Throws std::runtime_error where no graphics context can be had.
BodiesPicture picture_of_bodies(const World& yours, const World& right, int width, int height, bool of_place = false);

}  // namespace pushback
