#include "pushback/common/experiment/plot.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <stdexcept>

#include "pushback/common/basics/files.h"
#include "pushback/common/basics/process.h"
#include "pushback/common/experiment/kept_picture.h"

namespace pushback {

std::string line_colour(std::size_t index) {
  static constexpr std::array colours{"#0072b2", "#d55e00", "#009e73", "#cc79a7",
                                      "#e69f00", "#56b4e9", "#444444", "#b8a900"};
  return colours[index % colours.size()];
}

namespace {

std::string drawn_as(const Curve& curve) {
  const std::string ink = "lc rgb " + quoted(curve.colour);
  switch (curve.style) {
    case Curve::Style::line:
      return "with lines lw 2.2 " + ink;
    case Curve::Style::dashed:
      return "with lines lw 1.6 dt (6,5) " + ink;
    case Curve::Style::points:
      return "with points pt 7 ps 0.8 " + ink;
    case Curve::Style::line_and_points:
      return "with linespoints lw 2 pt 7 ps 0.8 " + ink;
  }
  return {};
}

std::string script_of(const Panel& panel, std::size_t index) {
  std::string script;
  const auto data_name = [&](std::size_t c) { return fmt::format("$d{}_{}", index, c); };
  for (std::size_t c = 0; c < panel.curves.size(); ++c) {
    const Curve& curve = panel.curves[c];
    script += data_name(c) + " << EOD\n";
    for (std::size_t i = 0; i < curve.x.size(); ++i) script += fmt::format("{} {}\n", curve.x[i], curve.y[i]);
    script += "EOD\n";
  }
  script += fmt::format("set title {} offset 0,-0.3\nset xlabel {}\nset ylabel {}\n", quoted(panel.title),
                        quoted(panel.x_label), quoted(panel.y_label));
  script += fmt::format("set key {} Left reverse samplen 1.6 spacing 1.15\n", panel.key);
  script += fmt::format("{}set logscale x\n", panel.log_x ? "" : "un");
  script += fmt::format("{}set logscale y\n", panel.log_y ? "" : "un");
  script += fmt::format("set format x '{}'\nset format y '{}'\n", panel.log_x ? "10^{%L}" : "%g",
                        panel.log_y ? "10^{%L}" : "%g");
  script +=
      "set autoscale\nset size noratio\nset xtics autofreq\nset ytics autofreq\n";  // nothing left of the last one
  script += panel.extra + "\nplot ";
  for (std::size_t c = 0; c < panel.curves.size(); ++c) {
    const Curve& curve = panel.curves[c];
    const std::string title = curve.label.empty() ? "notitle" : "title " + quoted(curve.label);
    script += fmt::format("{}{} {} {}", c == 0 ? "" : ", ", data_name(c), drawn_as(curve), title);
  }
  return script + "\nunset label\nunset arrow\n";
}

}  // namespace

void write_plot(const std::filesystem::path& file, const std::vector<Panel>& panels) {
  // Drawn beside its final place.
  std::filesystem::path unfinished = file;
  unfinished += ".part";
  const std::size_t columns = panels.size() == 4 ? 2 : std::min<std::size_t>(panels.size(), 3);
  const std::size_t rows = (panels.size() + columns - 1) / columns;
  std::string script = fmt::format(
      "set terminal pngcairo size {},{} font 'DejaVu Sans,13' background rgb '#ffffff'\nset encoding utf8\nset output "
      "{}\n"
      "set border 3 lc rgb '#555555'\nset tics nomirror textcolor rgb '#333333'\nset grid lc rgb '#dddddd' lw 1\n"
      "set multiplot layout {},{}\n",
      columns == 1 ? 1000 : 860 * columns, 520 * rows, quoted(unfinished.string()), rows, columns);
  for (std::size_t i = 0; i < panels.size(); ++i) script += script_of(panels[i], i);
  script += "unset multiplot\nset output\n";

  const Ended gnuplot = run_program({"gnuplot"}, 120, script);
  if (gnuplot.status == 127) throw std::runtime_error("gnuplot is not found: is the package gnuplot-nox installed?");
  if (gnuplot.status != 0)
    throw std::runtime_error(fmt::format("gnuplot could not draw {}: {}", file.string(), gnuplot.err));
  const Image drawn = read_png(unfinished);
  std::filesystem::remove(unfinished);
  keep_picture(file, drawn);
}

}  // namespace pushback
