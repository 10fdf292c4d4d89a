#include "pushback/common/experiment/sheet.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>
#include <span>

#include "pushback/common/experiment/sheet_raster.h"

namespace pushback {

namespace {

constexpr int margin = 40, gap = 10, right_edge = margin + strip_width;
constexpr Ink dark_grey{66, 72, 84}, pale{222, 226, 232}, white{255, 255, 255};

int high(const Image& image, int wide) {
  return image.height * wide / image.width;
}

/// Whether the variants stand side by side instead of in rows, because each has a single picture.
bool side_by_side(const Sheet& sheet) {
  return !sheet.wide && !sheet.raster && sheet.rows.size() > 1 &&
         std::all_of(sheet.rows.begin(), sheet.rows.end(), [](const SheetRow& row) { return row.cells.size() == 1; });
}

/// Draws from the top down. To measure the height of a sheet, draw it on an image of one pixel.
class Drawing {
 public:
  explicit Drawing(Image& onto) : image_(onto) {}

  int draw(const Sheet& sheet) {
    labels_ = &sheet.labels;
    head(sheet);
    if (side_by_side(sheet)) beside_each_other(sheet);
    else rows(sheet);
    return y_ + margin - 24;
  }

 private:
  void rows(const Sheet& sheet) {
    for (const SheetRow& row : sheet.rows) {
      fill_rectangle(image_, margin, y_, strip_width, 2, pale);
      y_ += 14;
      label(row, margin, strip_width, false);
      const int top = y_;
      cells(row, sheet.wide);
      if (sheet.raster && !row.raster.empty()) {
        const bool beside = !sheet.wide && row.cells.size() == 1;
        if (beside) draw_raster(image_, *sheet.raster, row.raster, {column(1), top, right_edge - column(1), y_ - top});
        else y_ = draw_raster(image_, *sheet.raster, row.raster, {margin, y_ + 8, strip_width, 0});
      }
      y_ += 24;
    }
  }

  /// Three variants per line: a reader's own variant may be the fourth, and then stands below the others.
  void beside_each_other(const Sheet& sheet) {
    constexpr std::size_t most = 3;
    for (std::size_t first = 0; first < sheet.rows.size(); first += most)
      beside_each_other(sheet, std::span(sheet.rows).subspan(first, std::min(most, sheet.rows.size() - first)));
  }
  void beside_each_other(const Sheet& sheet, std::span<const SheetRow> rows) {
    fill_rectangle(image_, margin, y_, strip_width, 2, pale);
    const int top = y_ + 14;
    const std::size_t from = start_beside(sheet) ? 1 : 0;  // the start is on the left
    int lowest = top;
    for (std::size_t c = 0; c < rows.size(); ++c) {
      y_ = top;
      label(rows[c], column(from + c), cell_width, true);
      lowest = std::max(lowest, y_);
    }
    y_ = lowest;
    if (from > 0) start(sheet, column(0), y_);
    for (std::size_t c = 0; c < rows.size(); ++c)
      cell(rows[c].cells[0], column(from + c), y_, cell_width, rows[c].cell_notes[0]);
    y_ += high(rows.front().cells[0], cell_width) + 24;
  }

  static int column(std::size_t index) { return margin + static_cast<int>(index) * (cell_width + gap); }

  /// Writes wrapped text downwards from y_.
  void lines(const std::string& text, float size, Ink ink, int width, bool bold, int after) {
    const int line = static_cast<int>(std::lround(size * 1.22F));
    for (const std::string& one : wrapped(text, size, width, bold)) {
      write_text(image_, one, margin, y_ + static_cast<int>(size * 0.86F), size, ink, Align::left, bold);
      y_ += line;
    }
    if (!text.empty()) y_ += after;
  }

  void head(const Sheet& sheet) {
    const bool here = sheet.start && !start_beside(sheet);
    const int width = here ? 2 * cell_width + gap - 20 : strip_width;
    y_ = margin - 4;
    lines(sheet.question, 40, sheet_dark, width, true, 10);
    lines(sheet.scene, 28, sheet_dark, width, true, 6);
    lines(sheet.caption, 24, dark_grey, width, false, 10);
    legend(sheet.legend, margin + width);
    lines(sheet.foot, 18, sheet_grey, width, false, 0);
    if (here) {
      start(sheet, right_edge - cell_width, margin);
      y_ = std::max(y_, margin + high(*sheet.start, cell_width));
    }
    y_ += 20;
  }

  /// Whether the start is drawn next to the variants: two of them side by side leave room for it.
  static bool start_beside(const Sheet& sheet) { return sheet.start && side_by_side(sheet) && sheet.rows.size() < 3; }

  void start(const Sheet& sheet, int x, int y) {
    cell(*sheet.start, x, y, cell_width, sheet.rows.size() > 1 ? "t = 0: all start like this" : "t = 0", Align::right);
  }

  void legend(const std::vector<LegendEntry>& entries, int right) {
    if (entries.empty()) return;
    constexpr int line = 32;
    int x = margin;
    for (const LegendEntry& entry : entries) {
      const int sign = entry.kind == LegendEntry::Kind::arrow ? 44 : 26, wide = sign + text_width(entry.text, 20);
      if (x > margin && x + wide > right) {
        x = margin;
        y_ += line;
      }
      const float middle = static_cast<float>(y_) + 14, left = static_cast<float>(x);
      if (entry.kind == LegendEntry::Kind::arrow) {
        draw_arrow(image_, {left, middle}, {left + 34, middle}, 4.5F, entry.colour);
      } else if (entry.kind == LegendEntry::Kind::body) {
        fill_rectangle(image_, x, y_ + 5, 18, 18, sheet_dark);
        fill_rectangle(image_, x + 1, y_ + 6, 16, 16, entry.colour);
      } else {
        fill_disc(image_, left + 9, middle, 9, sheet_dark);  // a rim, because one of the colours is white
        fill_disc(image_, left + 9, middle, 7.2F, entry.colour);
      }
      write_text(image_, entry.text, x + sign, y_ + 21, 20, sheet_dark);
      x += wide + 30;
    }
    y_ += line + 4;
  }

  /// Writes the name, and the numbers after it in as many lines as they take or, if `below`, each on a line below it.
  void label(const SheetRow& row, int from, int width, bool below) {
    constexpr int line = 36;
    const int left = from + 34, right = from + width;
    write_text(image_, row.marker, from + 12, y_ + 26, 30, row.colour, Align::centre);
    write_text(image_, row.name, left, y_ + 26, 28, sheet_dark, Align::left, true);
    int x = left + text_width(row.name, 28, true) + 32;
    for (const SheetNumber& number : row.numbers) {
      const std::string expected = number.expected.empty() ? "" : fmt::format(" ({})", number.expected);
      const int first = text_width(number.text, 22), wide = first + text_width(expected, 22);
      if (x > left && (below || x + wide > right)) {
        x = left;
        y_ += line;
      }
      write_text(image_, number.text, x, y_ + 26, 22, sheet_dark);
      write_text(image_, expected, x + first + 6, y_ + 26, 22, sheet_grey);
      x += wide + 6 + 32;
    }
    y_ += line + 6;
  }

  void cells(const SheetRow& row, bool wide) {
    const int width = wide ? strip_width : cell_width;
    for (std::size_t i = 0; i < row.cells.size(); ++i)
      cell(row.cells[i], column(i), y_, width, wide ? "" : row.cell_notes[i]);
    y_ += high(row.cells.front(), width);
    if (!wide) return;
    write_text(image_, row.cell_notes.front(), right_edge, y_ + 22, 18, sheet_grey,
               Align::right);  // below, because bodies cover the whole strip
    y_ += 26;
  }

  /// Draws a picture with its note at the top, where the sky is.
  void cell(const Image& picture, int x, int y, int width, const std::string& note, Align side = Align::left) {
    const int height = high(picture, width), wide = text_width(note, 20) + 16;
    const int left = side == Align::left ? x + 8 : x + width - 8 - wide;
    if (picture.width == width) paste(picture, image_, x, y);
    else paste(picture, image_, x, y, width, height);
    write_labels(image_, *labels_, x, y, width, height, 20);
    if (note.empty()) return;
    fill_rectangle(image_, left, y + 8, wide, 28, white, 0.72F);
    write_text(image_, note, left + 8, y + 29, 20, sheet_dark);
  }

  Image& image_;
  const std::vector<SheetLabel>* labels_ = nullptr;
  int y_ = 0;
};

/// A scale bar for displacements: the largest of 1, 2 and 5 times a power of ten of metres that covers at most a sixth of the
/// picture's height. `aspect`: its width by its height.
SheetLabel scale_bar(const Scene& scene, Real aspect) {
  const Real height = scene.camera.height_at(scene.camera.target), most = height / (6 * scene.magnified);
  const Real power = std::pow(Real(10), std::floor(std::log10(most))), factor = most / power;
  const Real length = power * static_cast<Real>(factor < 2 ? 1 : factor < 5 ? 2 : 5);
  return {0.01F, 0.9F, fmt::format("{:g} mm", 1000 * length),
          static_cast<float>(length * scene.magnified / (height * aspect))};
}

constexpr float small_text = 13;  // pixels, of labels in small pictures

Image small(const Image& picture, const Sheet& sheet, int width) {
  Image image = resized(picture, width, high(picture, width));
  write_labels(image, sheet.labels, 0, 0, image.width, image.height, small_text);
  return image;
}

}  // namespace

Image make_sheet(const Sheet& sheet) {
  Image nothing(1, 1);
  Image image(2 * margin + strip_width, Drawing(nothing).draw(sheet));
  Drawing(image).draw(sheet);
  return image;
}

Image make_thumbnail(const Sheet& sheet) {
  constexpr int between = 4, width = 320;
  const auto [one, other] = sheet.in_brief;
  const Image& last = sheet.rows[other].cells.back();
  if (sheet.wide) return small(last, sheet, 2 * width + between);
  Image thumbnail(2 * width + between, high(last, width), 255);
  const std::vector<Image>& first = sheet.rows[one].cells;
  paste(small(one != other ? first.back() : first.front(), sheet, width), thumbnail, 0, 0);
  paste(small(last, sheet, width), thumbnail, width + between, 0);
  return thumbnail;
}

void write_labels(Image& image, const std::vector<SheetLabel>& labels, int x, int y, int width, int height,
                  float size) {
  for (const SheetLabel& label : labels) {
    const int left = x + static_cast<int>(std::lround(label.x * static_cast<float>(width)));
    const int base = y + static_cast<int>(std::lround(label.y * static_cast<float>(height)));
    const int bar = static_cast<int>(std::lround(label.bar * static_cast<float>(width))),
              end = static_cast<int>(size / 5);
    if (bar > 0) {
      fill_rectangle(image, left, base - 1, bar, 2, sheet_dark);
      for (const int at : {left, left + bar - 2}) fill_rectangle(image, at, base - end, 2, 2 * end, sheet_dark);
    }
    const int foot = base - static_cast<int>(0.3F * size), top = foot - static_cast<int>(size);
    fill_rectangle(image, left, top, text_width(label.text, size), base - 2 - top, white, 0.5F);  // it may be on a body
    write_text(image, label.text, left, foot, size, sheet_dark);
  }
}

std::vector<SheetLabel> labels_of(const Scene& scene, Real aspect) {
  std::vector<SheetLabel> all;
  for (const Label& label : scene.labels) {
    const Camera& camera = scene.camera;
    const Vec3 ahead = (camera.target - camera.eye).normalized(), right = ahead.cross(Vec3::UnitY()).normalized();
    const Vec3 from_middle = (label.at - camera.eye) / camera.height_at(label.at);
    all.push_back({static_cast<float>(Real(0.5) + right.dot(from_middle) / aspect),
                   static_cast<float>(Real(0.5) - right.cross(ahead).dot(from_middle)), label.text});
  }
  if (scene.magnified != 1) all.push_back(scale_bar(scene, aspect));
  return all;
}

std::vector<std::size_t> guess_order(const std::string& name, std::size_t count) {
  std::minstd_rand random(std::accumulate(name.begin(), name.end(), 1U, [](unsigned sum, char letter) {
    return 31 * sum + static_cast<unsigned char>(letter);
  }));
  std::vector<std::size_t> order(count);
  std::iota(order.begin(), order.end(), std::size_t{0});
  for (std::size_t i = count; i > 1; --i) std::swap(order[i - 1], order[random() % i]);
  return order;
}

std::vector<Image> make_guess(const Sheet& sheet, const Guess& guess) {
  std::vector<const Image*> all;
  for (const std::size_t place : guess.among) {
    if (place < sheet.rows.size()) all.push_back(&sheet.rows[place].cells.back());  // parameters may leave some out
  }
  if (guess.start && sheet.start) all.push_back(&*sheet.start);
  std::vector<Image> mixed;
  for (const std::size_t which : guess_order(sheet.scene, all.size())) {
    const Image& image = *all[which];
    const int wide = sheet.wide ? 640 : std::clamp(240 * image.width / image.height, 180, 320);
    mixed.push_back(small(image, sheet, wide));
  }
  return mixed;
}

}  // namespace pushback
