#include "pushback/tools/figures/svg.h"

#include <fmt/format.h>

#include <cmath>

namespace pushback::figures {

namespace {

/// To a tenth of a pixel: the last bits of what was computed do not show.
std::string number(double value) {
  const double tenths = std::round(value * 10) / 10;
  return fmt::format("{:g}", tenths == 0 ? 0.0 : tenths);
}
std::string pair_of(const Place& at) {
  return fmt::format("{},{}", number(at.x()), number(at.y()));
}
std::string stroke(const Pen& pen) {
  if (pen.width == 0) return "";
  return fmt::format(R"( stroke="{}" stroke-width="{}"{})", pen.colour, number(pen.width),
                     pen.dashed ? R"( stroke-dasharray="7 5")" : "");
}
std::string list_of(const std::vector<Place>& points) {
  std::string list;
  for (const Place& point : points) list += fmt::format("{}{}", list.empty() ? "" : " ", pair_of(point));
  return list;
}

constexpr double head_length = 5, head_half_width = 2;  // widths of the line

std::string head(const Place& tip, const Place& direction, const Pen& pen) {
  const double size = std::max(pen.width, 1.6);
  const Place back = tip - head_length * size * direction,
              side = head_half_width * size * Place(-direction.y(), direction.x());
  return fmt::format("<polygon points=\"{}\" fill=\"{}\"/>\n", list_of({tip, back + side, back - side}), pen.colour);
}
/// Where the line of an arrow ends, so that it does not show beside its tip.
Place neck(const Place& tip, const Place& direction, const Pen& pen) {
  return tip - (head_length - 1) * std::max(pen.width, 1.6) * direction;
}

std::string escaped(std::string_view text) {
  std::string safe;
  for (const char c : text) {
    if (c == '&') safe += "&amp;";
    else if (c == '<') safe += "&lt;";
    else if (c == '>') safe += "&gt;";
    else safe += c;
  }
  return safe;
}

/// Letters in one manner.
struct Run {
  std::string letters = {};
  bool formula = false, slanted = false;
  int level = 0;  ///< 1: above the line, -1: below it
  bool same_manner(const Run& other) const {
    return formula == other.formula && slanted == other.slanted && level == other.level;
  }
};

std::size_t bytes_of(char first) {
  const auto c = static_cast<unsigned char>(first);
  return c < 0x80 ? 1 : c < 0xe0 ? 2 : c < 0xf0 ? 3 : 4;
}
bool is_letter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}
/// Small Greek letters, and C with a dot; capital Greek letters stand upright, as in print.
bool is_slanted(std::string_view letter) {
  if (letter.size() == 1) return is_letter(letter[0]);
  return (letter >= "α" && letter <= "ω") || letter == "Ċ";
}

void add(std::vector<Run>& runs, std::string_view letters, bool formula, bool slanted, int level) {
  Run next{std::string(letters), formula, slanted, level};
  if (!runs.empty() && runs.back().same_manner(next)) runs.back().letters += letters;
  else runs.push_back(std::move(next));
}

/// Words of three letters and more stand upright in a formula: they are names, not products.
void add_formula(std::vector<Run>& runs, std::string_view text) {
  int level = 0;
  bool group = false;
  for (std::size_t i = 0; i < text.size();) {
    if (text[i] == '_' || text[i] == '^') {
      level = text[i++] == '^' ? 1 : -1;
      group = i < text.size() && text[i] == '{';
      if (group) ++i;
      continue;
    }
    if (group && text[i] == '}') {
      level = 0;
      group = false;
      ++i;
      continue;
    }
    std::size_t end = i;
    while (end < text.size() && is_letter(text[end])) ++end;
    const bool name = end - i >= 3;
    if (!name) end = i + bytes_of(text[i]);
    const std::string_view letters = text.substr(i, end - i);
    add(runs, letters, true, !name && is_slanted(letters), level);
    if (!group) level = 0;
    i = end;
  }
}

std::vector<Run> runs_of(std::string_view words) {
  std::vector<Run> runs;
  bool formula = false;
  while (!words.empty()) {
    const std::size_t end = std::min(words.find('$'), words.size());
    const std::string_view part = words.substr(0, end);
    if (formula) add_formula(runs, part);
    else if (!part.empty()) add(runs, part, false, false, 0);
    formula = !formula;
    words.remove_prefix(std::min(end + 1, words.size()));
  }
  return runs;
}

}  // namespace

Svg::Svg(double width, double height, std::string_view title) : width_(width), height_(height) {
  body_ = fmt::format("<title>{}</title>\n", escaped(title));
  body_ +=
      fmt::format(R"(<rect width="{}" height="{}" rx="12" fill="#ffffff"/>)", number(width), number(height)) + "\n";
}

void Svg::line(const Place& from, const Place& to, const Pen& pen) {
  polyline({from, to}, pen);
}
void Svg::arrow(const Place& from, const Place& to, const Pen& pen) {
  const Place direction = (to - from).normalized();
  line(from, neck(to, direction, pen), pen);
  body_ += head(to, direction, pen);
}
void Svg::measure(const Place& from, const Place& to, const Pen& pen) {
  const Place direction = (to - from).normalized();
  line(neck(from, -direction, pen), neck(to, direction, pen), pen);
  body_ += head(from, -direction, pen) + head(to, direction, pen);
}
void Svg::polyline(const std::vector<Place>& points, const Pen& pen) {
  body_ += fmt::format("<polyline points=\"{}\" fill=\"none\"{} stroke-linejoin=\"round\"/>\n", list_of(points),
                       stroke(pen));
}
void Svg::polygon(const std::vector<Place>& points, const char* fill, const Pen& pen) {
  body_ += fmt::format("<polygon points=\"{}\" fill=\"{}\"{} stroke-linejoin=\"round\"/>\n", list_of(points), fill,
                       stroke(pen));
}
void Svg::circle(const Place& centre, double radius, const char* fill, const Pen& pen) {
  body_ += fmt::format("<circle cx=\"{}\" cy=\"{}\" r=\"{}\" fill=\"{}\"{}/>\n", number(centre.x()), number(centre.y()),
                       number(radius), fill, stroke(pen));
}
void Svg::arc(const Place& centre, double radius, double from, double to, const Pen& pen, bool with_head) {
  const Place end = centre + towards(to, radius);
  const double turn = to > from ? 1 : -1;
  // The line of an arc with a head ends where the head begins; the head points along the chord of its own length.
  const double short_of = with_head ? turn * head_length * std::max(pen.width, 1.6) / radius : 0;
  const Place last = centre + towards(to - short_of * 0.8, radius);
  body_ += fmt::format("<path d=\"M {} A {} {} 0 {} {} {}\" fill=\"none\"{}/>\n",
                       pair_of(centre + towards(from, radius)), number(radius), number(radius),
                       std::abs(to - from) > std::numbers::pi ? 1 : 0, to > from ? 0 : 1, pair_of(last), stroke(pen));
  if (with_head) body_ += head(end, (end - (centre + towards(to - short_of, radius))).normalized(), pen);
}

void Svg::text(const Place& baseline, std::string_view words, const Lettering& lettering) {
  constexpr const char* anchors[] = {"", R"( text-anchor="middle")", R"( text-anchor="end")"};
  body_ += fmt::format(
      R"(<text x="{}" y="{}" font-size="{}" fill="{}"{}{}{}>)", number(baseline.x()), number(baseline.y()),
      number(lettering.size), lettering.colour, anchors[static_cast<std::size_t>(lettering.at)],
      lettering.bold ? R"( font-weight="bold")" : "",
      lettering.halo ? R"( stroke="#ffffff" stroke-width="5" stroke-linejoin="round" paint-order="stroke")" : "");
  double risen = 0;  // px above the line
  for (const Run& run : runs_of(words)) {
    // A formula's letters are a little larger: a serif font looks smaller beside one without.
    const double size = lettering.size * (run.formula ? 1.12 : 1) * (run.level == 0 ? 1 : 0.78);
    const double rise = run.level * lettering.size * (run.level > 0 ? 0.36 : 0.26);
    std::string manner;
    if (run.formula) manner += R"( font-family="serif")";
    if (run.slanted) manner += R"( font-style="italic")";
    if (run.formula) manner += fmt::format(R"( font-size="{}")", number(size));
    if (rise != risen) manner += fmt::format(R"( dy="{}")", number(risen - rise));
    risen = rise;
    body_ += manner.empty() ? escaped(run.letters) : fmt::format("<tspan{}>{}</tspan>", manner, escaped(run.letters));
  }
  body_ += "</text>\n";
}

void Svg::clip(const Place& centre, double radius) {
  body_ += fmt::format(
      "<clipPath id=\"clip{}\"><circle cx=\"{}\" cy=\"{}\" r=\"{}\"/></clipPath>\n<g clip-path=\"url(#clip{})\">\n",
      clips_, number(centre.x()), number(centre.y()), number(radius), clips_);
  ++clips_;
}
void Svg::unclip() {
  body_ += "</g>\n";
}

std::string Svg::str() const {
  return fmt::format(
             R"(<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {0} {1}" width="{0}" height="{1}" role="img" font-family="sans-serif" xml:space="preserve">)",
             number(width_), number(height_)) +
         "\n" + body_ + "</svg>\n";
}

}  // namespace pushback::figures
