/// The strip under a row of a sheet, or beside its only cell: a column of coloured cells per step.
#pragma once

#include <vector>

#include "pushback/common/experiment/scene.h"

namespace pushback {

/// Of words and lines on a sheet.
inline constexpr Ink sheet_dark{28, 32, 40}, sheet_grey{104, 112, 124};

/// Where a raster is drawn, pixels; a height of 0: as it needs.
struct RasterPlace {
  int x, y, width, height;
};

/// Draws it there, with a line of text above and the steps' numbers below. Returns where it ends.
int draw_raster(Image& image, const Raster& raster, const std::vector<std::vector<int>>& columns, RasterPlace place);

}  // namespace pushback
