#include "pushback/common/render/canvas.h"

#include <stb/stb_truetype.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>
#include <vector>

#include "pushback/common/basics/input.h"

namespace pushback {
namespace {

/// Text looks too heavy where coverage is mixed in sRGB levels and too thin where it is mixed in linear light: this
/// lies between the two.
constexpr float text_gamma = 1.4f;

class Font {
 public:
  explicit Font(const std::string& file) {
    std::ifstream in(file, std::ios::binary);
    bytes_.assign(std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>());
    const auto* start = reinterpret_cast<const unsigned char*>(bytes_.data());
    if (bytes_.empty() || !stbtt_InitFont(&info, start, stbtt_GetFontOffsetForIndex(start, 0))) {
      throw std::runtime_error("the font " + file + " cannot be read");
    }
  }
  Font(const Font&) = delete;
  Font& operator=(const Font&) = delete;

  stbtt_fontinfo info{};

 private:
  std::vector<char> bytes_;  // `info` points into them
};

const Font& font(bool bold) {
  if (bold) {
    static const Font heavy = [] {
      std::string file = PUSHBACK_FONT;
      file.insert(file.rfind('.'), "-Bold");
      return Font(file);
    }();
    return heavy;
  }
  static const Font regular(PUSHBACK_FONT);
  return regular;
}

/// Takes one character off the front; what is not UTF-8 gives U+FFFD, a byte at a time.
int next_character(std::string_view& text) {
  const auto byte = [&](std::size_t i) { return i < text.size() ? static_cast<unsigned char>(text[i]) : 0u; };
  const unsigned lead = byte(0);
  const std::size_t length = lead < 0x80 ? 1 : lead >> 5 == 0x6 ? 2 : lead >> 4 == 0xE ? 3 : lead >> 3 == 0x1E ? 4 : 0;
  unsigned character = length == 1 ? lead : lead & (0x7Fu >> length);
  bool valid = length > 0;
  for (std::size_t i = 1; i < length; ++i) {
    valid = valid && byte(i) >> 6 == 0x2;
    character = character << 6 | (byte(i) & 0x3Fu);
  }
  constexpr std::array<unsigned, 5> least = {0, 0, 0x80, 0x800, 0x10000};  // fewer bytes would have done: not UTF-8
  valid = valid && character >= least[length] && character <= 0x10FFFF;
  text.remove_prefix(valid ? length : 1);
  return valid ? static_cast<int>(character) : 0xFFFD;
}

struct Glyph {
  int index;
  float x;  // pixels from the start of the text
};

struct Line {
  std::vector<Glyph> glyphs;
  float width = 0;  // pixels
};

Line set_line(const stbtt_fontinfo& info, std::string_view text, float scale) {
  Line line;
  int previous = -1;
  while (!text.empty()) {
    const int glyph = stbtt_FindGlyphIndex(&info, next_character(text));  // 0, a box, where the font lacks it
    int advance = 0, bearing = 0;
    stbtt_GetGlyphHMetrics(&info, glyph, &advance, &bearing);
    if (previous >= 0) line.width += scale * static_cast<float>(stbtt_GetGlyphKernAdvance(&info, previous, glyph));
    line.glyphs.push_back({glyph, line.width});
    line.width += scale * static_cast<float>(advance);
    previous = glyph;
  }
  return line;
}

float scale_of(const stbtt_fontinfo& info, float size) {
  if (!(size > 0) || !(size <= 4096))
    throw InvalidInput(fmt::format("text of {} pixels is asked for: more than 0 and at most 4096", size));
  return stbtt_ScaleForPixelHeight(&info, size);
}

std::array<std::uint8_t, 3> levels(Ink ink) {
  return {ink.red, ink.green, ink.blue};
}

void mix_level(std::uint8_t& below, std::uint8_t above, float share) {
  below = static_cast<std::uint8_t>(static_cast<float>(below) +
                                    share * (static_cast<float>(above) - static_cast<float>(below)) + 0.5f);
}

void mix_text(std::uint8_t& below, std::uint8_t above, float share) {
  const float a = std::pow(static_cast<float>(below) / 255, text_gamma),
              b = std::pow(static_cast<float>(above) / 255, text_gamma);
  below = static_cast<std::uint8_t>(255 * std::pow(a + share * (b - a), 1 / text_gamma) + 0.5f);
}

bool inside(const Image& image, int x, int y) {
  return x >= 0 && y >= 0 && x < image.width && y < image.height;
}

}  // namespace

void write_text(Image& image, std::string_view text, int x, int y, float size, Ink ink, Align align, bool bold) {
  const stbtt_fontinfo& info = font(bold).info;
  const float scale = scale_of(info, size);
  const Line line = set_line(info, text, scale);
  const float start = static_cast<float>(x) - (align == Align::left     ? 0
                                               : align == Align::centre ? line.width / 2
                                                                        : line.width);
  const std::array<std::uint8_t, 3> above = levels(ink);
  std::vector<unsigned char> coverage;
  for (const Glyph& glyph : line.glyphs) {
    const float place = start + glyph.x;
    const float whole = std::floor(place);
    int left = 0, top = 0, right = 0, bottom = 0;
    stbtt_GetGlyphBitmapBoxSubpixel(&info, glyph.index, scale, scale, place - whole, 0, &left, &top, &right, &bottom);
    const int width = right - left, height = bottom - top;
    if (width <= 0 || height <= 0) continue;  // a space
    coverage.assign(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), 0);
    stbtt_MakeGlyphBitmapSubpixel(&info, coverage.data(), width, height, width, scale, scale, place - whole, 0,
                                  glyph.index);
    for (int row = 0; row < height; ++row) {
      for (int column = 0; column < width; ++column) {
        const int to_x = static_cast<int>(whole) + left + column, to_y = y + top + row;
        const unsigned char share = coverage[static_cast<std::size_t>(row) * static_cast<std::size_t>(width) +
                                             static_cast<std::size_t>(column)];
        if (share == 0 || !inside(image, to_x, to_y)) continue;
        std::uint8_t* pixel = image.at(to_x, to_y);
        for (std::size_t i = 0; i < 3; ++i) mix_text(pixel[i], above[i], static_cast<float>(share) / 255);
      }
    }
  }
}

int text_width(std::string_view text, float size, bool bold) {
  const stbtt_fontinfo& info = font(bold).info;
  return static_cast<int>(std::ceil(set_line(info, text, scale_of(info, size)).width));
}

void fill_rectangle(Image& image, int x, int y, int width, int height, Ink ink, float opacity) {
  const float share = std::clamp(opacity, 0.0f, 1.0f);
  const std::array<std::uint8_t, 3> above = levels(ink);
  const long long right = std::min<long long>(image.width, static_cast<long long>(x) + width);
  const long long bottom = std::min<long long>(image.height, static_cast<long long>(y) + height);
  for (int row = std::max(0, y); row < bottom; ++row) {
    for (int column = std::max(0, x); column < right; ++column) {
      for (std::size_t i = 0; i < 3; ++i) mix_level(image.at(column, row)[i], above[i], share);
    }
  }
}

void fill_disc(Image& image, float x, float y, float radius, Ink ink) {
  if (!(radius > 0) || !std::isfinite(x) || !std::isfinite(y)) return;
  const std::array<std::uint8_t, 3> above = levels(ink);
  const auto clamp_to = [](float value, int side) {
    return static_cast<int>(std::clamp(value, 0.0f, static_cast<float>(side)));
  };
  const int left = clamp_to(x - radius - 1, image.width), right = clamp_to(x + radius + 2, image.width);
  const int top = clamp_to(y - radius - 1, image.height), bottom = clamp_to(y + radius + 2, image.height);
  for (int row = top; row < bottom; ++row) {
    for (int column = left; column < right; ++column) {
      const float distance = std::hypot(static_cast<float>(column) + 0.5f - x, static_cast<float>(row) + 0.5f - y);
      const float share = std::clamp(radius - distance + 0.5f, 0.0f, 1.0f);  // the edge is one pixel wide
      for (std::size_t i = 0; i < 3; ++i) mix_text(image.at(column, row)[i], above[i], share);
    }
  }
}

}  // namespace pushback
