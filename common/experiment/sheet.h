/// The comparison sheet: a row per variant, a column per instant, the measured numbers beside each row.
#pragma once

#include <string>
#include <vector>

#include "pushback/common/render/canvas.h"
#include "pushback/common/render/image.h"

namespace pushback {

struct SheetNumber {
  std::string text;      ///< "rebound speed  0.31 m/s"
  std::string expected;  ///< "should be 0", or empty
};

struct SheetRow {
  std::string name;
  Ink colour;  ///< of the variant, as in the plot
  std::vector<SheetNumber> numbers;
  std::vector<Image> cells;             ///< all of one size
  std::vector<std::string> cell_notes;  ///< "t = 0.50 s"
};

/// Rows that share a scene.
struct SheetGroup {
  std::string title;
  std::vector<SheetRow> rows;
};

struct SheetLegend {
  Ink colour;
  std::string text;
};

/// The sheet in brief, for a table of contents: how each of the first three variants ends, side by side.
Image make_thumbnail(const SheetGroup& group);

Image make_sheet(const std::string& title, const std::string& question, const std::vector<SheetGroup>& groups,
                 const std::vector<SheetLegend>& legend);

}  // namespace pushback
