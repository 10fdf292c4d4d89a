/// The strip under a row of a sheet: a column of coloured cells per step.
#pragma once

#include <vector>

#include "pushback/common/experiment/scene.h"

namespace pushback {

/// Draws it strip_width wide, with a line of text above and the steps' numbers below. Returns where it ends.
int draw_raster(Image& image, const Raster& raster, const std::vector<std::vector<int>>& columns, int x, int y);

}  // namespace pushback
