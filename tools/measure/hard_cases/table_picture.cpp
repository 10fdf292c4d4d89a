#include <fmt/format.h>

#include <algorithm>

#include "pushback/common/render/canvas.h"
#include "pushback/tools/measure/hard_cases/table.h"

namespace pushback {

namespace {

// Filled against hollow and dark against light, so that it reads without colours too. All are among the levels of `coarse`.
constexpr Ink dark{34, 34, 51}, grey{102, 102, 119}, white{255, 255, 255};
constexpr Ink pass_fill{0, 85, 136}, fail_fill{255, 238, 221}, fail_ink{153, 51, 0}, gold{255, 187, 0},
    none_fill{238, 238, 238};
// Pixels. A page shows the picture half as wide: text of 24 is then as high as its own.
constexpr int width = 1600, margin = 24, label = 300, between_groups = 16, gap = 3, row_height = 32, legend_line = 40;
constexpr float text = 24;

/// Only every 17th level of each channel: letters are still smooth, and half of the file is saved.
void coarse(Image& image) {
  for (std::uint8_t& level : image.pixels) level = static_cast<std::uint8_t>((level + 8) / 17 * 17);
}

/// Turned by a quarter, so that what was written to the right goes upwards.
Image turned(const Image& image) {
  Image upwards(image.height, image.width);
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) std::copy_n(image.at(x, y), 4, upwards.at(y, image.width - 1 - x));
  }
  return upwards;
}

class Drawing {
 public:
  explicit Drawing(const Table& table) : table_(table) {
    const int stages = static_cast<int>(table_.stages.size());
    cell_ = (width - 2 * margin - label - between_groups) / stages - gap;
    for (const Stage& stage : table_.stages) heads_ = std::max(heads_, text_width(stage.name, text) + 8);
    rows_y_ = 150 + heads_ + row_height;
    image_ = Image(width, rows_y_ + static_cast<int>(table_.cases.size()) * (row_height + gap) + 4 * legend_line);
  }

  Image draw() {
    write_text(image_, table_.asks, margin, 58, 44, dark, Align::left, true);
    write_text(image_, "A row is a case, a column a solver.", margin, 98, text, grey);
    draw_group(table_.first, 0, table_.chapters);
    draw_group(table_.others, table_.chapters, table_.stages.size());
    for (std::size_t column = 0; column < table_.stages.size(); ++column) draw_head(column);
    write_text(image_, fmt::format("pass, of {}", table_.cases.size()), margin, rows_y_ - 10, text, grey);
    for (std::size_t row = 0; row < table_.cases.size(); ++row) draw_row(row);
    draw_legend();
    coarse(image_);
    return std::move(image_);
  }

 private:
  int cell_x(std::size_t column) const {
    return margin + label + static_cast<int>(column) * (cell_ + gap) +
           (column >= table_.chapters && table_.chapters > 0 ? between_groups : 0);
  }

  void draw_group(const std::string& title, std::size_t first, std::size_t end) {
    if (first == end) return;
    const int left = cell_x(first), right = cell_x(end - 1) + cell_;
    if (text_width(title, text) <= right - left)
      write_text(image_, title, (left + right) / 2, 132, text, grey, Align::centre);
    fill_rectangle(image_, left, 140, right - left, 2, grey);
  }

  /// The name upwards, and how many cases pass.
  void draw_head(std::size_t column) {
    Image name(heads_, row_height);
    write_text(name, table_.stages[column].name, 4, 25, text, dark);
    paste(turned(name), image_, cell_x(column) + (cell_ - row_height) / 2, rows_y_ - row_height - 6 - heads_);
    write_text(image_, std::to_string(table_.passes(column)), cell_x(column) + cell_ / 2, rows_y_ - 10, text, dark,
               Align::centre, true);
  }

  void draw_row(std::size_t row) {
    const int y = rows_y_ + static_cast<int>(row) * (row_height + gap);
    write_text(image_, table_.cases[row].title, margin, y + 25, text, dark);
    for (std::size_t column = 0; column < table_.stages.size(); ++column) {
      if (!table_.at(row, column).possible()) draw_none(cell_x(column), y);
      else draw_cell(cell_x(column), y, table_.passed(row, column), rescuer(table_, row) == column);
    }
  }

  void draw_cell(int x, int y, bool passed, bool rescued) {
    fill_rectangle(image_, x, y, cell_, row_height, passed ? pass_fill : fail_fill);
    const int centre = x + cell_ / 2;
    write_text(image_, passed ? "✓" : "✗", rescued ? centre - 14 : centre, y + 26, text + 2, passed ? white : fail_ink,
               Align::centre, true);
    if (rescued) write_text(image_, "★", centre + 14, y + 26, text + 2, gold, Align::centre);
  }

  /// Neither passes nor fails.
  void draw_none(int x, int y) {
    fill_rectangle(image_, x, y, cell_, row_height, none_fill);
    write_text(image_, "—", x + cell_ / 2, y + 26, text + 2, grey, Align::centre, true);
  }

  void draw_legend() {
    int y = rows_y_ + static_cast<int>(table_.cases.size()) * (row_height + gap) + 14;
    const auto say = [&](const std::string& meaning) {
      write_text(image_, meaning, margin + cell_ + 16, y + 26, text, dark);
      y += legend_line;
    };
    const auto entry = [&](bool passed, bool rescued, const std::string& meaning) {
      draw_cell(margin, y, passed, rescued);
      say(meaning);
    };
    entry(true, false, "passes: every number is within its limit, and no invariant broke");
    entry(false, false, "fails: a number is beyond its limit, or an invariant broke");
    if (table_.rescues) return entry(true, true, "the feature that rescues the case");
    draw_none(margin, y);
    say("the engine does not have what the case asks for");
  }

  const Table& table_;
  int cell_ = 0, heads_ = 0, rows_y_ = 0;
  Image image_;
};

}  // namespace

Image draw_overview(const Table& table) {
  return Drawing(table).draw();
}

}  // namespace pushback
