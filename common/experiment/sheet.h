/// The comparison sheet of one scene, 1600 pixels wide: the question and what to look for, then a row per variant, its
/// measured numbers above its pictures.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "pushback/common/experiment/legend.h"
#include "pushback/common/experiment/scene.h"
#include "pushback/common/render/image.h"

namespace pushback {

inline constexpr int cell_width = 500;    ///< pixels; three stand in a row
inline constexpr int strip_width = 1520;  ///< of what takes a whole row

struct SheetNumber {
  std::string text;      ///< "rebound speed: 0.31 m/s"
  std::string expected;  ///< "should be 0 m/s", or empty
};

struct SheetRow {
  std::string marker, name;
  Ink colour;  ///< of the variant, as in the plot
  std::vector<SheetNumber> numbers;
  std::vector<Image> cells;              ///< all of one size; pasted cell_width wide
  std::vector<std::string> cell_notes;   ///< "t = 0.50 s"
  std::vector<std::vector<int>> raster;  ///< a column per step, as Raster::of gives it
};

struct Sheet {
  std::string question, scene, caption, foot;  ///< each but the question may be empty
  std::optional<Image> start;                  ///< a cell
  std::vector<LegendEntry> legend;
  std::optional<Raster> raster;  ///< what the rows' are
  bool wide = false;             ///< the cells are strips
  std::vector<SheetRow> rows;
  std::pair<std::size_t, std::size_t> in_brief = {0, 0};  ///< the rows that the thumbnail shows
};

Image make_sheet(const Sheet& sheet);

/// The sheet in brief, for a table of contents: how two variants end, side by side; of a single variant its first and its last
/// picture; of strips the second one's.
Image make_thumbnail(const Sheet& sheet);

/// Small, in the order of guess_order; of those that the sheet has.
std::vector<Image> make_guess(const Sheet& sheet, const Guess& guess);

/// How `count` pictures are mixed: which of them stands at each place. Always the same for the same name.
std::vector<std::size_t> guess_order(const std::string& name, std::size_t count);

}  // namespace pushback
