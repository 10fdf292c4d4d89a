/// Text and simple shapes on an image.
#pragma once

#include <string_view>

#include "pushback/common/render/image.h"

namespace pushback {

/// 8-bit sRGB.
struct Ink {
  std::uint8_t red = 30, green = 34, blue = 42;
};

enum class Align { left, centre, right };

/// Writes one line of UTF-8 text in DejaVu Sans with its baseline at (x, y), `size` pixels from ascender to descender;
/// characters that the font lacks are drawn as boxes.
void write_text(Image& image, std::string_view text, int x, int y, float size, Ink ink = {}, Align align = Align::left,
                bool bold = false);
/// Width in pixels that write_text would cover.
int text_width(std::string_view text, float size, bool bold = false);
void fill_rectangle(Image& image, int x, int y, int width, int height, Ink ink, float opacity = 1);
void fill_disc(Image& image, float x, float y, float radius, Ink ink);

}  // namespace pushback
