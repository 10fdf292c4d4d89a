/// The comparison sheet of one scene, 1600 pixels wide. It shows the question and the caption, then a row per variant, with its
/// measured numbers above its pictures.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "pushback/common/experiment/legend.h"
#include "pushback/common/experiment/scene.h"
#include "pushback/common/render/image.h"

namespace pushback {

inline constexpr int cell_width = 500;    ///< pixels; a row has up to three cells
inline constexpr int strip_width = 1520;  ///< pixels, of a picture that takes a whole row

struct SheetNumber {
  std::string text;      ///< "rebound speed: 0.31 m/s"
  std::string expected;  ///< "should be 0 m/s", or empty
};

struct SheetRow {
  std::string marker, name;
  Ink colour;  ///< of the variant, as in the plot
  std::vector<SheetNumber> numbers;
  std::vector<Image> cells;              ///< all of one size; scaled to cell_width or strip_width
  std::vector<std::string> cell_notes;   ///< "t = 0.50 s"
  std::vector<std::vector<int>> raster;  ///< a column per step, as Raster::of returns it
};

/// A text in every picture of a sheet. It begins just above a place, given as fractions of the picture's width and height from its
/// top left corner.
struct SheetLabel {
  float x, y;
  std::string text;
  float bar = 0;  ///< of the picture's width: the length of a scale bar at that place; 0: none
};

struct Sheet {
  std::string question, scene, caption, foot;  ///< all but the question may be empty
  std::optional<Image> start;                  ///< the cell at t = 0
  std::vector<LegendEntry> legend;
  std::optional<Raster> raster;  ///< the label and meaning of the rows' rasters
  bool wide = false;             ///< whether the cells are strips
  std::vector<SheetRow> rows;
  std::vector<SheetLabel> labels = {};
  std::pair<std::size_t, std::size_t> in_brief = {0, 0};  ///< the rows that the thumbnail shows
};

Image make_sheet(const Sheet& sheet);

/// The picture for a table of contents. It shows the last pictures of the two variants of in_brief side by side, the first and the
/// last picture of a single variant, or the strip of the second variant.
Image make_thumbnail(const Sheet& sheet);

/// The pictures of `guess` that the sheet has, small, in the order of guess_order.
std::vector<Image> make_guess(const Sheet& sheet, const Guess& guess);

/// The labels of a scene in a picture whose width is `aspect` times its height, and a scale bar if displacements are magnified.
std::vector<SheetLabel> labels_of(const Scene& scene, Real aspect);

/// Writes labels on a picture that covers a part of `image`, in text of the size `size`. All in pixels.
void write_labels(Image& image, const std::vector<SheetLabel>& labels, int x, int y, int width, int height, float size);

/// A shuffled order of `count` pictures, with the index of the picture at each place. The same name gives the same order.
std::vector<std::size_t> guess_order(const std::string& name, std::size_t count);

}  // namespace pushback
