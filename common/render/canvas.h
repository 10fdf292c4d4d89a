/// Draws text, shapes and other images on an image, with Cairo and Pango.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "pushback/common/render/image.h"

namespace pushback {

/// 8-bit sRGB.
struct Ink {
  std::uint8_t red = 30, green = 34, blue = 42;
};

/// Pixels from the top left corner of the image, to the right and down.
struct Spot {
  double x = 0, y = 0;
};

enum class Align { left, centre, right };

/// Writes one line of UTF-8 text in DejaVu Sans with its baseline at (x, y), `size` pixels from ascender to descender;
/// characters that the font lacks are drawn as boxes. Throws InvalidInput if `size` is not above 0 and at most 4096.
void write_text(Image& image, std::string_view text, int x, int y, float size, Ink ink = {}, Align align = Align::left,
                bool bold = false);
/// Width in pixels that write_text would cover.
int text_width(std::string_view text, float size, bool bold = false);
/// Breaks `text` between words into lines of at most `width` pixels. A longer word is not broken.
std::vector<std::string> wrapped(std::string_view text, float size, int width, bool bold = false);

void fill_rectangle(Image& image, int x, int y, int width, int height, Ink ink, float opacity = 1);
void fill_disc(Image& image, float x, float y, float radius, Ink ink);
/// The tip of its head is at `to`.
void draw_arrow(Image& image, Spot from, Spot to, float width, Ink ink);

/// Draws `from` on `onto`, its top left corner at (x, y), scaled to `width` and `height` and clipped at the edges of `onto`.
void paste(const Image& from, Image& onto, int x, int y, int width, int height, float opacity = 1);
/// The same without scaling.
void paste(const Image& from, Image& onto, int x, int y);
/// The image at another size.
Image resized(const Image& image, int width, int height);

}  // namespace pushback
