#include "pushback/common/experiment/sheet_raster.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "pushback/common/experiment/sheet.h"

namespace pushback {

namespace {

constexpr Ink empty{244, 246, 248};

/// The tick distance for about eight ticks: 1, 2 or 5 times a power of ten.
int tick_of(int steps) {
  const double rough = std::max(1.0, steps / 8.0), power = std::pow(10, std::floor(std::log10(rough)));
  const double factor = rough / power;
  return static_cast<int>(power * (factor <= 1 ? 1 : factor <= 2 ? 2 : factor <= 5 ? 5 : 10));
}

}  // namespace

int draw_raster(Image& image, const Raster& raster, const std::vector<std::vector<int>>& columns, RasterPlace place) {
  constexpr int above = 28, below = 26;
  const int x = place.x;
  int y = place.y;
  write_text(image, raster.label, x, y + 18, 20, sheet_dark);
  int right = x + place.width;
  for (auto one = raster.meaning.rbegin(); one != raster.meaning.rend(); ++one) {
    right -= text_width(one->second, 20);
    write_text(image, one->second, right, y + 18, 20, sheet_dark);
    right -= 26;
    fill_rectangle(image, right, y + 3, 18, 18, one->first);
    right -= 26;
  }
  y += above;

  std::size_t rows = 1;
  for (const std::vector<int>& column : columns) rows = std::max(rows, column.size());
  const int cell = place.height > 0 ? std::max(2, (place.height - above - below) / static_cast<int>(rows))
                                    : std::clamp(120 / static_cast<int>(rows), 2, 20);
  const int height = static_cast<int>(rows) * cell;
  const int steps = static_cast<int>(columns.size());
  const auto edge = [&](int step) { return x + static_cast<int>(static_cast<long long>(step) * place.width / steps); };
  fill_rectangle(image, x, y, place.width, height, empty);
  for (int step = 0; step < steps; ++step) {
    const std::vector<int>& column = columns[static_cast<std::size_t>(step)];
    const int wide = std::max(1, edge(step + 1) - edge(step));
    for (std::size_t row = 0; row < column.size(); ++row) {
      if (column[row] < 0) continue;
      const Ink ink = raster.meaning.at(static_cast<std::size_t>(column[row])).first;
      fill_rectangle(image, edge(step), y + static_cast<int>(row) * cell, wide, cell, ink);
    }
  }
  constexpr int apart = 10;  // pixels; lower rows would lose too much of their height to the lines between them
  if (cell >= apart) {
    for (int row = 1; row < static_cast<int>(rows); ++row)
      fill_rectangle(image, x, y + row * cell - 1, place.width, 2, empty);
  }
  y += height;

  const int tick = tick_of(steps);
  for (int step = tick; step <= steps; step += tick) {
    const int at = (edge(step - 1) + edge(step)) / 2;
    fill_rectangle(image, at, y, 2, 6, sheet_grey);
    const std::string text = step == tick ? fmt::format("step {}", step) : fmt::format("{}", step);
    const bool last = at + text_width(text, 18) / 2 > x + place.width;
    write_text(image, text, last ? x + place.width : at, y + 23, 18, sheet_grey, last ? Align::right : Align::centre);
  }
  return y + below;
}

}  // namespace pushback
