#include "pushback/common/experiment/plot.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <stdexcept>

#include "pushback/common/basics/files.h"
#include "pushback/common/basics/process.h"
#include "pushback/common/experiment/kept_picture.h"
#include "pushback/common/experiment/marker.h"
#include "pushback/common/experiment/plot_layout.h"

namespace pushback {

namespace {

constexpr std::size_t most_own_markers = 40;  // a curve with more points has markers at only a few

std::string shape_of(const Curve& curve) {
  if (!curve.marker.empty()) return curve.marker;
  const auto found = std::find(line_colours.begin(), line_colours.end(), curve.colour);
  return found == line_colours.end() ? "" : marker_of(static_cast<std::size_t>(found - line_colours.begin()));
}

/// The marker as gnuplot options. Gnuplot places its own shapes more exactly than it does characters.
std::string points_with(const std::string& marker, const std::string& colour) {
  static const std::map<std::string, int> own{{"●", 7}, {"■", 5}, {"▲", 9}, {"◆", 13}, {"▼", 11}};
  const auto found = own.find(marker);
  if (found == own.end()) return fmt::format("with points pt '{}' font 'DejaVu Sans,18' tc rgb '{}'", marker, colour);
  return fmt::format("with points pt {} ps 1.9 lc rgb '{}'", found->second, colour);
}

/// Darker than the line, because thin strokes of a bright colour are hard to read on white.
std::string text_colour(const std::string& colour) {
  const unsigned long rgb = std::stoul(colour.substr(1), nullptr, 16);
  const auto darker = [&](int shift) { return (rgb >> shift & 255) * 3 / 4; };
  return fmt::format("#{:02x}{:02x}{:02x}", darker(16), darker(8), darker(0));
}

std::string axis_commands(const char* name, const Axis& axis) {
  std::vector<std::string> ticks;
  for (const auto& [value, label] : axis.ticks) ticks.push_back(fmt::format("{} {}", quoted(label), value));
  return fmt::format("{3}set logscale {0}\nset {0}range [{1}:{2}]\nset {0}tics ({4})\n", name, axis.from, axis.to,
                     axis.log ? "" : "un", fmt::join(ticks, ", "));
}

/// The gnuplot commands of one panel.
class PanelScript {
 public:
  PanelScript(const Panel& panel, const PanelLayout& layout, const FigureLayout& figure)
      : panel_(panel), layout_(layout), figure_(figure) {}

  std::string text() {
    draw_axes();
    draw_lines_to_compare();
    for (const PlacedName& name : layout_.names) draw_name(name);
    const std::string plots = fmt::format("{}", fmt::join(plot_elements(), ", "));
    return text_ + panel_.extra + "\nplot " + (plots.empty() ? "NaN notitle" : plots) + "\nunset label\nunset arrow\n";
  }

 private:
  using Points = std::vector<std::pair<Real, Real>>;

  std::string screen(Real x, Real y) const {
    return fmt::format("screen {:.6f},{:.6f}", x / static_cast<Real>(figure_.width),
                       1 - y / static_cast<Real>(figure_.height));
  }

  void write(const std::string& what, Real x, Real y, const std::string& align, const std::string& colour,
             const std::string& font = "DejaVu Sans,16") {
    text_ += fmt::format("set label {} at {} {} noenhanced front font '{}' tc rgb '{}'\n", quoted(what), screen(x, y),
                         align, font, colour);
  }

  void draw_axes() {
    const auto left = static_cast<Real>(layout_.left), right = static_cast<Real>(layout_.right);
    const auto top = static_cast<Real>(layout_.top), bottom = static_cast<Real>(layout_.bottom);
    const auto across = static_cast<Real>(figure_.width), down = static_cast<Real>(figure_.height);
    text_ += fmt::format(
        "set lmargin at screen {:.6f}\nset rmargin at screen {:.6f}\nset tmargin at screen {:.6f}\nset bmargin at "
        "screen "
        "{:.6f}\n",
        left / across, right / across, 1 - top / down, 1 - bottom / down);
    text_ += axis_commands("x", layout_.x) + axis_commands("y", layout_.y);
    Real y = top - 22 - static_cast<Real>(plot_line_height) * static_cast<Real>(layout_.title.size());
    for (const std::string& line : layout_.title) {
      write(line, static_cast<Real>(layout_.edge), y, "left", "#1c202a", "DejaVu Sans:Bold,16");
      y += plot_line_height;
    }
    write(panel_.y_label, static_cast<Real>(layout_.edge), y, "left", "#555555");
    write(panel_.x_label, (left + right) / 2, bottom + 56, "center", "#555555");
  }

  void draw_lines_to_compare() {
    const auto left = static_cast<Real>(layout_.left), right = static_cast<Real>(layout_.right);
    for (const PlacedLine& line : layout_.lines) {
      text_ += fmt::format("set arrow from {} to {} nohead lw 1.4 lc rgb '#a8a8a8'\n", screen(left, line.y),
                           screen(right, line.y));
      write(line.label, line.at_left ? left + 8 : right - 8, line.y - 13, line.at_left ? "left" : "right", "#666666",
            "DejaVu Sans,14");
    }
  }

  void draw_name(const PlacedName& name) {
    const Curve& curve = panel_.curves[name.curve];
    const std::string marker = shape_of(curve), ink = text_colour(curve.colour);
    const auto shape = static_cast<Real>(layout_.right + 34);
    if (std::isfinite(name.end_x))
      text_ +=
          fmt::format("set arrow from {} to {} nohead {} lc rgb '{}'\n", screen(name.end_x, name.wanted),
                      screen(shape - 12, name.middle),
                      name.end_x < static_cast<Real>(layout_.right) - 2 ? "lw 1.4 dt (3,4)" : "lw 1.4", curve.colour);
    if (!marker.empty()) write(marker, shape, name.middle, "center", curve.colour);
    Real y = name.middle - name.height / 2 + static_cast<Real>(plot_line_height) / 2;
    for (const std::string& line : name.lines) {
      write(line, marker.empty() ? shape - 6 : shape + 14, y, "left", ink);
      y += plot_line_height;
    }
  }

  /// Lines first, so that no line covers a marker of another curve.
  std::vector<std::string> plot_elements() {
    std::vector<std::string> elements;
    for (const Curve& curve : panel_.curves) {
      const Points points = points_of(curve);
      if (points.empty()) continue;
      const std::string ink = "lc rgb " + quoted(curve.colour);
      elements.push_back(data(points) +
                         (curve.style == Curve::Style::points   ? " notitle with points pt 7 ps 0.7 "
                          : curve.style == Curve::Style::dashed ? " notitle with lines lw 2.2 dt (7,5) "
                                                                : " notitle with lines lw 2.8 ") +
                         ink);
    }
    for (std::size_t c = 0; c < panel_.curves.size(); ++c) {
      const Curve& curve = panel_.curves[c];
      const std::string marker = shape_of(curve);
      const Points points = marker.empty() || curve.style == Curve::Style::points ? Points() : marked(curve, c);
      if (points.empty()) continue;
      elements.push_back(data(points) + " notitle " + points_with(marker, curve.colour));
    }
    return elements;
  }

  Points points_of(const Curve& curve) const {
    Points points;
    for (std::size_t i = 0; i < curve.x.size(); ++i) {
      const Real y = drawn(panel_, curve.y[i]);
      const bool has_place = std::isfinite(curve.x[i]) && std::isfinite(y) && (!panel_.log_x || curve.x[i] > 0);
      points.emplace_back(has_place ? curve.x[i] : not_drawn, y);
    }
    return points;
  }

  /// The points at which the curve has a marker.
  Points marked(const Curve& curve, std::size_t index) const {
    Points points = points_of(curve);
    std::erase_if(points, [&](const auto& point) {
      const Real x = layout_.x.part(point.first), y = layout_.y.part(point.second);
      return !(x >= 0 && x <= 1 && y >= 0 && y <= 1);
    });
    const bool each = curve.style == Curve::Style::line_and_points && points.size() <= most_own_markers;
    if (each || points.size() < 2) return points;
    const auto width = static_cast<Real>(layout_.right - layout_.left);
    const auto height = static_cast<Real>(layout_.bottom - layout_.top);
    for (auto& [x, y] : points) {
      x = layout_.x.part(x) * width;
      y = layout_.y.part(y) * height;
    }
    points = marker_places(points, width, index, panel_.curves.size());
    for (auto& [x, y] : points) {
      x = layout_.x.at(x / width);
      y = layout_.y.at(y / height);
    }
    return points;
  }

  /// Defines a data block and returns its name, for the plot command.
  std::string data(const Points& points) {
    const std::string name = fmt::format("$d{}", blocks_++);
    text_ += name + " << EOD\n";
    for (const auto& [x, y] : points) text_ += std::isfinite(x) ? fmt::format("{} {}\n", x, y) : "\n";
    text_ += "EOD\n";
    return name;
  }

  const Panel& panel_;
  const PanelLayout& layout_;
  const FigureLayout& figure_;
  std::string text_;
  int blocks_ = 0;
};

void draw_figure(const std::filesystem::path& file, const std::vector<Panel>& panels) {
  // Gnuplot draws to a temporary file next to `file`.
  std::filesystem::path unfinished = file;
  unfinished += ".part";
  const FigureLayout figure = lay_out(panels);
  std::string script = fmt::format(
      "set terminal pngcairo size {},{} font 'DejaVu Sans,16' background rgb '#ffffff'\nset encoding utf8\nset output "
      "{}\nset border 3 lc rgb '#555555'\nset tics nomirror scale 0.6 textcolor rgb '#333333'\n"
      "set grid lt 1 lc rgb '#e4e4e4' lw 1\nunset key\nset multiplot\n",
      figure.width, figure.height, quoted(unfinished.string()));
  for (std::size_t i = 0; i < panels.size(); ++i) script += PanelScript(panels[i], figure.panels[i], figure).text();
  script += "unset multiplot\nset output\n";

  const Ended gnuplot = run_program({"gnuplot"}, 120, script);
  std::error_code error;
  if (gnuplot.status != 0) std::filesystem::remove(unfinished, error);
  if (gnuplot.status == 127) throw std::runtime_error("gnuplot is not found: is the package gnuplot-nox installed?");
  if (gnuplot.status != 0)
    throw std::runtime_error(fmt::format("gnuplot could not draw {}: {}", file.string(), gnuplot.err));
  const Image drawn = read_png(unfinished);
  std::filesystem::remove(unfinished);
  keep_picture(file, drawn);
}

std::filesystem::path numbered(const std::filesystem::path& file, std::size_t number) {
  if (number == 1) return file;
  return file.parent_path() / fmt::format("{}_{}{}", file.stem().string(), number, file.extension().string());
}

}  // namespace

std::vector<std::vector<Panel>> in_figures(const std::vector<Panel>& panels) {
  std::vector<std::vector<Panel>> figures;
  for (std::size_t first = 0, end = 0; first < panels.size(); first = end) {
    while (end < panels.size() && panels[end].title == panels[first].title && end - first < panels_in_a_figure) ++end;
    if (figures.empty() || figures.back().size() + end - first > panels_in_a_figure) figures.emplace_back();
    figures.back().insert(figures.back().end(), panels.begin() + static_cast<std::ptrdiff_t>(first),
                          panels.begin() + static_cast<std::ptrdiff_t>(end));
  }
  return figures;
}

std::vector<std::filesystem::path> write_plot(const std::filesystem::path& file, const std::vector<Panel>& panels) {
  std::vector<std::filesystem::path> files;
  for (const std::vector<Panel>& figure : in_figures(panels)) {
    files.push_back(numbered(file, files.size() + 1));
    draw_figure(files.back(), figure);
  }
  for (std::size_t next = files.size() + 1; std::filesystem::remove(numbered(file, next)); ++next) continue;
  return files;
}

}  // namespace pushback
