#include "tests/hard_cases/table_picture.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

#include "pushback/common/experiment/picture_of.h"
#include "pushback/common/experiment/sheet.h"
#include "pushback/common/render/canvas.h"
#include "pushback/common/render/painter.h"

namespace pushback {

namespace {

// Filled against hollow and dark against light, so that it reads without colours too. All are among the levels of `coarse`.
constexpr Ink dark{34, 34, 51}, grey{102, 102, 119}, pale{221, 221, 221}, white{255, 255, 255};
constexpr Ink pass_fill{0, 85, 136}, fail_fill{255, 238, 221}, fail_ink{153, 51, 0}, gold{255, 187, 0};
constexpr int portrait_width = 144, portrait_height = 84;

/// Pixels; what differs between the table and its overview.
struct Style {
  int least, margin, label, cell, row, gap;  ///< label: left of the cells; least: width of all; row: at least so high
  float title, head, number, name, small;    ///< sizes of text
  bool details;
};
constexpr Style full{1560, 36, 736, 118, 84, 6, 40, 24, 19, 21, 16, true};
constexpr Style brief{780, 28, 262, 78, 27, 3, 30, 20, 18, 19, 15, false};
constexpr int between_groups = 18;

int line_height(float size) {
  return static_cast<int>(size * 1.25F);
}

/// Only every `step`th level of each channel, where `step` divides 255. With 17, letters are still smooth, with 15 small
/// pictures are hardly banded, and half of the file is saved.
void coarse(Image& image, int step) {
  for (std::uint8_t& level : image.pixels) level = static_cast<std::uint8_t>((level + step / 2) / step * step);
}

/// Writes `lines` below each other, the first baseline at y.
void write_lines(Image& image, const std::vector<std::string>& lines, int x, int y, float size, Ink ink, Align align) {
  for (const std::string& line : lines) {
    write_text(image, line, x, y, size, ink, align);
    y += line_height(size);
  }
}

/// The largest size up to `size`, but not below 14, at which `text` is no wider than `width`.
float fitting(const std::string& text, float size, int width, bool bold) {
  while (size > 14 && text_width(text, size, bold) > width) size -= 0.5F;
  return size;
}

class Drawing {
 public:
  Drawing(const Table& table, const Style& style) : table_(table), style_(style) {
    text_wide_ = style_.label - (style_.details ? portrait_width + 38 : 16);
    for (const HardCase& hard_case : table_.cases) {
      stresses_.push_back(wrapped(hard_case.stresses, style_.small, text_wide_));
      criteria_.push_back(wrapped(criteria_of(hard_case), style_.small, text_wide_));
      const auto lines = static_cast<int>(stresses_.back().size() + criteria_.back().size());
      heights_.push_back(style_.details ? std::max(style_.row, 32 + lines * line_height(style_.small)) : style_.row);
    }
    for (const Stage& stage : table_.stages) {
      heads_.push_back(wrapped(stage.name.substr(stage.name.find(' ') + 1), style_.small, style_.cell - 4));
      head_lines_ = std::max(head_lines_, static_cast<int>(heads_.back().size()));
    }
    width_ = std::max(style_.least, cell_x(table_.stages.size() - 1) + style_.cell + style_.margin);
    head_y_ = style_.margin + (style_.details ? 104 : 66);
    rows_y_ = head_y_ + 44 + line_height(style_.head) + (head_lines_ + 1) * line_height(style_.small);
    const int rows = std::accumulate(heights_.begin(), heights_.end(), 0);
    foot_y_ = rows_y_ + rows + static_cast<int>(heights_.size()) * style_.gap + 10;
  }

  Image draw(const std::vector<Image>& portraits) {
    const auto stages = static_cast<int>(table_.stages.size());
    const int legend = 5 * line_height(legend_size()) + 30;
    const int list = style_.details ? ((stages + 1) / 2 + 1) * line_height(legend_size()) + 10 : 0;
    image_ = Image(width_, foot_y_ + legend + list + style_.margin / 2);
    draw_heads();
    int y = rows_y_;
    for (std::size_t row = 0; row < table_.cases.size(); ++row) {
      draw_label(row, y);
      for (std::size_t column = 0; column < table_.stages.size(); ++column) draw_cell(row, column, y);
      y += heights_[row] + style_.gap;
    }
    draw_legend(foot_y_);
    if (style_.details) draw_stages(foot_y_ + legend);
    coarse(image_, 17);
    y = rows_y_;
    for (std::size_t row = 0; row < portraits.size(); ++row) {
      paste(portraits[row], image_, style_.margin, y);
      y += heights_[row] + style_.gap;
    }
    return std::move(image_);
  }

 private:
  int cell_x(std::size_t column) const {
    return style_.margin + style_.label + static_cast<int>(column) * (style_.cell + style_.gap) +
           (column >= table_.chapters && table_.chapters > 0 ? between_groups : 0);
  }
  float legend_size() const { return style_.small + 1; }

  void draw_group(const std::string& title, const std::string& in_brief, std::size_t first, std::size_t end) {
    if (first == end) return;
    const int left = cell_x(first), right = cell_x(end - 1) + style_.cell;
    const bool fits = text_width(title, style_.small + 2) <= right - left;
    write_text(image_, fits ? title : in_brief, (left + right) / 2, head_y_ + 14, style_.small + 2, grey,
               Align::centre);
    fill_rectangle(image_, left, head_y_ + 24, right - left, 2, grey);
  }

  void draw_heads() {
    const int top = style_.margin + static_cast<int>(style_.title * 0.7F);
    write_text(image_, "Which feature keeps which hard case stable?", style_.margin, top, style_.title, dark,
               Align::left, true);
    write_text(image_,
               style_.details
                   ? "A row is a case, a column a solver; steps of 1/60 s unless the case says otherwise. In a "
                     "cell: the criterion nearest to its limit, or furthest beyond."
                   : "A row is a case, a column a solver. Numbers and limits: table.png, table.md",
               style_.margin, top + 32, style_.small + (style_.details ? 5 : 2), grey);
    draw_group("one more feature in each chapter", "chapters", 0, table_.chapters);
    draw_group("what came after", "after", table_.chapters, table_.stages.size());
    for (std::size_t column = 0; column < table_.stages.size(); ++column) {
      const int x = cell_x(column) + style_.cell / 2;
      int y = head_y_ + 30 + line_height(style_.head);
      const std::string& name = table_.stages[column].name;
      write_text(image_, name.substr(0, name.find(' ')), x, y, style_.head, dark, Align::centre, true);
      y += line_height(style_.small);
      for (const std::string& line : heads_[column]) {
        float size = style_.small;  // a long word is set smaller, so that it does not run into the next column's
        while (size > 11 && text_width(line, size) > style_.cell) size -= 0.5F;
        write_text(image_, line, x, y, size, dark, Align::centre);
        y += line_height(style_.small);
      }
      std::size_t count = 0;
      for (std::size_t row = 0; row < table_.cases.size(); ++row) count += table_.passed(row, column) ? 1 : 0;
      write_text(image_, fmt::format("{} of {}", count, table_.cases.size()), x, rows_y_ - 10, style_.small, grey,
                 Align::centre);
    }
    write_text(image_, "passed:", style_.margin + style_.label - 14, rows_y_ - 10, style_.small, grey, Align::right);
  }

  void draw_label(std::size_t row, int y) {
    const int x = style_.margin + (style_.details ? portrait_width + 18 : 0);
    const std::string& title = table_.cases[row].title;
    if (!style_.details) {
      write_text(image_, title, x, y + style_.row - 8, fitting(title, style_.name, text_wide_, false), dark);
      return;
    }
    write_text(image_, title, x, y + 19, fitting(title, style_.name, text_wide_, true), dark, Align::left, true);
    y += 19 + line_height(style_.small) + 3;
    write_lines(image_, stresses_[row], x, y, style_.small, dark, Align::left);
    y += static_cast<int>(stresses_[row].size()) * line_height(style_.small);
    write_lines(image_, criteria_[row], x, y, style_.small, grey, Align::left);
  }

  void draw_cell(std::size_t row, std::size_t column, int y) {
    const bool passed = table_.passed(row, column);
    const int x = cell_x(column), centre = x + style_.cell / 2, high = heights_[row];
    const Ink ink = passed ? white : fail_ink;
    fill_rectangle(image_, x, y, style_.cell, high, passed ? pass_fill : fail_fill);
    const bool starred = rescuer(table_, row) == column;
    const std::string symbol = passed ? "✓" : "✗";
    const std::string starts = passed_of_starts(table_.at(row, column));
    if (!style_.details) {
      const bool counted = !passed && !starts.empty();
      write_text(image_, symbol, counted ? x + 16 : centre, y + high - 7, style_.number, ink, Align::centre, true);
      if (counted) write_text(image_, starts, x + 28, y + high - 8, style_.small, ink);
      if (starred) write_text(image_, "★", x + style_.cell - 18, y + high - 7, style_.number, gold, Align::centre);
      return;
    }
    const std::string word = in_a_word(table_.at(row, column).broken);
    const int top = y + (high - style_.row) / 2 + (word.empty() && starts.empty() ? 8 : 0);
    write_text(image_, symbol, centre, top + 26, 24, ink, Align::centre, true);
    const std::string number = worst_number(table_, row, column);
    write_text(image_, number, centre, top + 52, fitting(number, style_.number, style_.cell - 8, true), ink,
               Align::centre, true);
    const std::string below = starts + (starts.empty() || word.empty() ? "" : ", ") + word;
    write_text(image_, below, centre, top + 74, fitting(below, style_.small, style_.cell - 8, false), ink,
               Align::centre);
    if (!starred) return;
    fill_rectangle(image_, x, y, style_.cell, 5, gold);
    write_text(image_, "★", x + style_.cell - 19, y + 27, 26, gold, Align::centre);
  }

  void draw_legend(int y) {
    const float size = legend_size();
    const auto entry = [&](Ink fill, Ink ink, const char* symbol, const std::string& text) {
      y += line_height(size) + 4;
      fill_rectangle(image_, style_.margin, y - 16, 48, 21, fill);
      write_text(image_, symbol, style_.margin + 24, y, size, ink, Align::centre, true);
      write_text(image_, text, style_.margin + 60, y, size, dark);
    };
    fill_rectangle(image_, style_.margin, y, width_ - 2 * style_.margin, 2, pale);
    entry(pass_fill, white, "✓", "passes: every number is within its limit, and no invariant broke");
    entry(fail_fill, fail_ink, "✗",
          style_.details
              ? "fails; below the number, the invariant that broke first: energy gained, a contact that pulls, "
                "friction beyond its bound, overlap of more than is allowed, a number that is not finite (NaN)"
              : "fails: a number is beyond its limit, or an invariant broke");
    const std::string knife =
        fmt::format("a case at a knife's edge, from {} starts that differ by up to 0.001 mm", many_starts);
    entry(fail_fill, fail_ink, "n/30",
          style_.details ? knife + ": n of them pass, the number is the largest of all, and the case passes if all do"
                         : knife + ": n pass, and all would have to");
    entry(pass_fill, gold, "★",
          style_.details
              ? "the feature that rescues the case: from here on all chapters pass; or, where the chapters do "
                "not, the first that passes after them"
              : "the feature that rescues the case");
  }

  /// What the columns are, in two columns.
  void draw_stages(int y) {
    const std::size_t half = (table_.stages.size() + 1) / 2;
    for (std::size_t i = 0; i < table_.stages.size(); ++i) {
      const int x = style_.margin + (i < half ? 0 : width_ / 2 - style_.margin);
      const int line = y + static_cast<int>(i % half + 1) * line_height(legend_size());
      const Stage& stage = table_.stages[i];
      write_text(image_, stage.name, x, line, legend_size(), dark, Align::left, true);
      write_text(image_, stage.what, x + 280, line, legend_size(), grey);
    }
  }

  const Table& table_;
  const Style& style_;
  std::vector<std::vector<std::string>> stresses_, criteria_, heads_;
  std::vector<int> heights_;
  int text_wide_ = 0, head_lines_ = 1, width_ = 0, head_y_ = 0, rows_y_ = 0, foot_y_ = 0;
  Image image_;
};

}  // namespace

std::vector<Image> portraits(const Table& table, const std::vector<World>& ends) {
  Painter painter(2 * portrait_width, 2 * portrait_height);
  std::vector<Image> images;
  for (std::size_t i = 0; i < ends.size(); ++i) {
    Picture picture = picture_of(ends[i], table.cases[i].scene.camera, 0);
    picture.dots.clear();  // specks, at this size
    images.push_back(resized(painter.draw_still(picture), portrait_width, portrait_height));
    coarse(images.back(), 15);
  }
  return images;
}

Image draw_table(const Table& table, const std::vector<Image>& portraits) {
  return Drawing(table, full).draw(portraits);
}

Image draw_overview(const Table& table) {
  return Drawing(table, brief).draw({});
}

}  // namespace pushback
