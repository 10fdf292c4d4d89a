/// The strip below a row of a sheet, or next to its only cell, with a column of coloured cells per step.
#pragma once

#include <vector>

#include "pushback/common/experiment/scene.h"

namespace pushback {

/// Colours of text and lines on a sheet.
inline constexpr Ink sheet_dark{28, 32, 40}, sheet_grey{104, 112, 124};

/// Where a raster is drawn, in pixels. A height of 0: as high as it needs.
struct RasterPlace {
  int x, y, width, height;
};

/// Draws the raster with a line of text above and the numbers of steps below. Returns the y of its lower end.
int draw_raster(Image& image, const Raster& raster, const std::vector<std::vector<int>>& columns, RasterPlace place);

}  // namespace pushback
