#include "pushback/common/experiment/sheet.h"

#include <algorithm>

namespace pushback {

namespace {

constexpr int margin = 36, gap = 10, label_width = 480, title_height = 112, group_height = 62, legend_height = 66;
constexpr Ink dark{28, 32, 40}, grey{104, 112, 124}, pale{222, 226, 232};

int write_wrapped(Image& sheet, const std::string& text, int x, int y, float size, Ink ink, int width, bool bold) {
  for (const std::string& line : wrapped(text, size, width, bold)) {
    write_text(sheet, line, x, y, size, ink, Align::left, bold);
    y += static_cast<int>(size * 1.22F);
  }
  return y;
}

void draw_label(Image& sheet, const SheetRow& row, int y) {
  fill_disc(sheet, margin + 9.0F, static_cast<float>(y) + 19.0F, 8, row.colour);
  int line = write_wrapped(sheet, row.name, margin + 28, y + 26, 24, dark, label_width - 44, true) + 4;
  for (const SheetNumber& number : row.numbers) {
    const int used = text_width(number.text, 20) + 12;
    const bool beside = used + text_width(number.expected, 18) <= label_width - 44;
    if (beside) write_text(sheet, number.expected, margin + 28 + used, line, 18, grey);
    line = write_wrapped(sheet, number.text, margin + 28, line, 20, dark, label_width - 44, false);
    if (!beside) line = write_wrapped(sheet, number.expected, margin + 28, line, 18, grey, label_width - 44, false);
    line += 6;
  }
}

int height_of(const SheetGroup& group) {
  int height = group.title.empty() ? 0 : group_height;
  for (const SheetRow& row : group.rows) height += row.cells.front().height + gap;
  return height;
}

}  // namespace

Image make_thumbnail(const SheetGroup& group) {
  constexpr int between = 4;
  const Image& first = group.rows.front().cells.back();
  const int wide = first.width * 2 / 3;
  const int high = first.height * 2 / 3;
  const int count = static_cast<int>(std::min<std::size_t>(group.rows.size(), 3));
  Image thumbnail(3 * wide + 2 * between, high, 255);
  for (int i = 0; i < count; ++i) {
    const int x = i * (wide + between) + (3 - count) * (wide + between) / 2;
    paste(group.rows[static_cast<std::size_t>(i)].cells.back(), thumbnail, x, 0, wide, high);
  }
  return thumbnail;
}

Image make_sheet(const std::string& title, const std::string& question, const std::vector<SheetGroup>& groups,
                 const std::vector<SheetLegend>& legend) {
  int width = 0;
  int height = title_height + legend_height;
  for (const SheetGroup& group : groups) {
    height += height_of(group);
    for (const SheetRow& row : group.rows) {
      const int columns = static_cast<int>(row.cells.size());
      width = std::max(width, 2 * margin + label_width + columns * (row.cells.front().width + gap) - gap);
    }
  }
  Image sheet(width, height, 255);
  write_text(sheet, question, margin, 56, 38, dark, Align::left, true);
  write_text(sheet, title, margin, 92, 21, grey);

  int y = title_height;
  for (const SheetGroup& group : groups) {
    if (!group.title.empty()) {
      fill_rectangle(sheet, margin, y + 6, width - 2 * margin, 2, pale);
      write_text(sheet, group.title, margin, y + 42, 27, dark, Align::left, true);
      y += group_height;
    }
    for (const SheetRow& row : group.rows) {
      draw_label(sheet, row, y);
      for (std::size_t column = 0; column < row.cells.size(); ++column) {
        const Image& cell = row.cells[column];
        const int x = margin + label_width + static_cast<int>(column) * (cell.width + gap);
        paste(cell, sheet, x, y);
        const std::string& note = row.cell_notes[column];
        fill_rectangle(sheet, x + 6, y + cell.height - 30, text_width(note, 18) + 12, 24, {255, 255, 255}, 0.7F);
        write_text(sheet, note, x + 12, y + cell.height - 12, 18, dark);
      }
      y += row.cells.front().height + gap;
    }
  }

  int x = margin;
  for (const SheetLegend& entry : legend) {
    const float centre = static_cast<float>(height) - 31;
    fill_disc(sheet, static_cast<float>(x) + 8, centre, 8.5F, dark);  // a rim, since one of the colours is white
    fill_disc(sheet, static_cast<float>(x) + 8, centre, 7, entry.colour);
    x += 24;
    write_text(sheet, entry.text, x, height - 25, 19, grey);
    x += text_width(entry.text, 19) + 30;
  }
  return sheet;
}

}  // namespace pushback
