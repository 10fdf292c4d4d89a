#include "pushback/common/render/canvas.h"

#include <fontconfig/fontconfig.h>
#include <pango/pangocairo.h>
#include <pango/pangofc-fontmap.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <memory>
#include <numbers>
#include <stdexcept>

#include "pushback/common/basics/input.h"

namespace pushback {
namespace {

template <auto free>
struct Freeing {
  void operator()(auto* what) const { free(what); }
};
template <class T, auto free = g_object_unref>
using Held = std::unique_ptr<T, Freeing<free>>;
using Pen = Held<cairo_t, cairo_destroy>;
using Surface = Held<cairo_surface_t, cairo_surface_destroy>;

// Cairo's pixels are blue, green, red and an unused byte; ours begin with red. Because Cairo treats all colours alike, it may confuse
// the two as long as it gets all colours, including the inks', in our order.
static_assert(std::endian::native == std::endian::little);

/// A surface on the image's own pixels. Cairo has no read-only surfaces, so it takes no const pixels.
Surface surface_of(const Image& image) {
  return Surface(cairo_image_surface_create_for_data(const_cast<unsigned char*>(image.pixels.data()),
                                                     CAIRO_FORMAT_RGB24, image.width, image.height, 4 * image.width));
}

Pen pen_on(Image& image, Ink ink = {}, double opacity = 1) {
  Pen pen(cairo_create(surface_of(image).get()));
  cairo_set_source_rgba(pen.get(), ink.blue / 255.0, ink.green / 255.0, ink.red / 255.0, opacity);
  return pen;
}

// ---- text ------------------------------------------------------------------------------------------------------------

/// DejaVu Sans in two weights, from the files of its package. Other fonts, settings and the language of a machine therefore do not
/// change the text.
PangoContext* typesetter() {
  static const Held<PangoContext> context = [] {
    const Held<FcConfig, FcConfigDestroy> fonts(FcConfigCreate());
    std::string bold = PUSHBACK_FONT;
    bold.insert(bold.rfind('.'), "-Bold");
    for (const std::string& file : {std::string(PUSHBACK_FONT), bold}) {
      if (!FcConfigAppFontAddFile(fonts.get(), reinterpret_cast<const FcChar8*>(file.c_str())))
        throw std::runtime_error("the font " + file + " cannot be read");
    }
    const Held<PangoFontMap> map(pango_cairo_font_map_new_for_font_type(CAIRO_FONT_TYPE_FT));
    pango_fc_font_map_set_config(PANGO_FC_FONT_MAP(map.get()), fonts.get());
    Held<PangoContext> made(pango_font_map_create_context(map.get()));
    const Held<cairo_font_options_t, cairo_font_options_destroy> options(cairo_font_options_create());
    cairo_font_options_set_hint_style(options.get(), CAIRO_HINT_STYLE_NONE);
    cairo_font_options_set_hint_metrics(options.get(), CAIRO_HINT_METRICS_OFF);
    cairo_font_options_set_antialias(options.get(), CAIRO_ANTIALIAS_GRAY);
    pango_cairo_context_set_font_options(made.get(), options.get());
    pango_context_set_round_glyph_positions(made.get(), FALSE);
    pango_context_set_language(made.get(), pango_language_from_string("en"));
    return made;
  }();
  return context.get();
}

Held<PangoLayout> laid_out(std::string_view text, float size, bool bold) {
  if (!(size > 0) || !(size <= 4096))
    throw InvalidInput(fmt::format("text of {} pixels is asked for: more than 0 and at most 4096", size));
  constexpr double ems = 2384.0 / 2048;  // from ascender to descender
  Held<PangoLayout> layout(pango_layout_new(typesetter()));
  const Held<PangoFontDescription, pango_font_description_free> font(
      pango_font_description_from_string(bold ? "DejaVu Sans Bold" : "DejaVu Sans"));
  pango_font_description_set_absolute_size(font.get(), size / ems * PANGO_SCALE);
  pango_layout_set_font_description(layout.get(), font.get());
  const Held<char, g_free> valid(g_utf8_make_valid(text.data(), static_cast<gssize>(text.size())));
  pango_layout_set_text(layout.get(), valid.get(), -1);
  return layout;
}

double width_of(const Held<PangoLayout>& layout) {
  int width = 0;
  pango_layout_get_size(layout.get(), &width, nullptr);
  return static_cast<double>(width) / PANGO_SCALE;
}

}  // namespace

void write_text(Image& image, std::string_view text, int x, int y, float size, Ink ink, Align align, bool bold) {
  const auto layout = laid_out(text, size, bold);
  const double before = align == Align::left ? 0 : align == Align::centre ? width_of(layout) / 2 : width_of(layout);
  const Pen pen = pen_on(image, ink);
  cairo_move_to(pen.get(), x - before, y);
  // As outlines, because glyphs would be moved to whole pixels, with uneven gaps between them.
  pango_cairo_layout_line_path(pen.get(), pango_layout_get_line_readonly(layout.get(), 0));
  cairo_fill(pen.get());
}

int text_width(std::string_view text, float size, bool bold) {
  return static_cast<int>(std::ceil(width_of(laid_out(text, size, bold))));
}

std::vector<std::string> wrapped(std::string_view text, float size, int width, bool bold) {
  const auto layout = laid_out(text, size, bold);
  pango_layout_set_width(layout.get(), width * PANGO_SCALE);
  std::vector<std::string> lines;
  for (int i = 0; !text.empty() && i < pango_layout_get_line_count(layout.get()); ++i) {
    const PangoLayoutLine* line = pango_layout_get_line_readonly(layout.get(), i);
    lines.emplace_back(pango_layout_get_text(layout.get()) + line->start_index, line->length);
    if (lines.back().ends_with(' ')) lines.back().pop_back();
  }
  return lines;
}

// ---- shapes ----------------------------------------------------------------------------------------------------------

void fill_rectangle(Image& image, int x, int y, int width, int height, Ink ink, float opacity) {
  const Pen pen = pen_on(image, ink, opacity);
  cairo_rectangle(pen.get(), x, y, width, height);
  cairo_fill(pen.get());
}

void fill_disc(Image& image, float x, float y, float radius, Ink ink) {
  const Pen pen = pen_on(image, ink);
  cairo_arc(pen.get(), x, y, radius, 0, 2 * std::numbers::pi);
  cairo_fill(pen.get());
}

void draw_arrow(Image& image, Spot from, Spot to, float width, Ink ink) {
  const double along = std::hypot(to.x - from.x, to.y - from.y);
  const double head = std::min(5.0 * width, along);
  if (!(along > 0)) return;
  const Pen pen = pen_on(image, ink);
  cairo_translate(pen.get(), from.x, from.y);
  cairo_rotate(pen.get(), std::atan2(to.y - from.y, to.x - from.x));
  cairo_rectangle(pen.get(), 0, -width / 2, along - head, width);
  cairo_move_to(pen.get(), along, 0);
  cairo_line_to(pen.get(), along - head, 0.4 * head);
  cairo_line_to(pen.get(), along - head, -0.4 * head);
  cairo_fill(pen.get());
}

// ---- other images ----------------------------------------------------------------------------------------------------

void paste(const Image& from, Image& onto, int x, int y, int width, int height, float opacity) {
  const Pen pen = pen_on(onto);
  cairo_rectangle(pen.get(), x, y, width, height);
  cairo_clip(pen.get());
  cairo_translate(pen.get(), x, y);
  cairo_scale(pen.get(), static_cast<double>(width) / from.width, static_cast<double>(height) / from.height);
  cairo_set_source_surface(pen.get(), surface_of(from).get(), 0, 0);
  cairo_pattern_set_extend(cairo_get_source(pen.get()), CAIRO_EXTEND_PAD);  // else the edges would fade
  cairo_paint_with_alpha(pen.get(), opacity);
}

void paste(const Image& from, Image& onto, int x, int y) {
  paste(from, onto, x, y, from.width, from.height);
}

Image resized(const Image& image, int width, int height) {
  Image result(width, height);
  paste(image, result, 0, 0, width, height);
  return result;
}

}  // namespace pushback
