/// Writes the results of an experiment: the table of numbers, the metrics, the sheets, the plot.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "pushback/common/basics/files.h"
#include "pushback/common/experiment/experiment_parts.h"
#include "pushback/common/experiment/kept_picture.h"
#include "pushback/common/experiment/marker.h"
#include "pushback/common/experiment/sheet.h"
#include "pushback/common/experiment/words.h"
#include "pushback/common/render/palette.h"

namespace pushback {

namespace fs = std::filesystem;

namespace {

Ink ink_of(const std::string& colour) {
  const unsigned long rgb = std::stoul(colour.substr(1), nullptr, 16);
  return {static_cast<std::uint8_t>(rgb >> 16 & 255), static_cast<std::uint8_t>(rgb >> 8 & 255),
          static_cast<std::uint8_t>(rgb & 255)};
}

}  // namespace

// ---- diagrams and tables -------------------------------------------------------------------------------------------

/// The name, and the number of sweeps if with_sweeps gave the variant its own.
std::string Experiment::shown_name(const Variant& variant) const {
  const bool said = sweeps_of(variant) == sweeps_ || variant.sweeps == 0 || variant.exactly;
  return said ? variant.name : fmt::format("{}, {} sweeps", variant.name, sweeps_of(variant));
}

namespace {

/// A motion that dies out ends in rounding noise, so the axis ends above it.
constexpr Real decades_of_a_series = 7;

Real floor_of(const Panel& panel) {
  Real largest = 0;
  for (const Curve& curve : panel.curves) {
    for (const Real y : curve.y) largest = std::isfinite(y) ? std::max(largest, y) : largest;
  }
  return largest > 0 ? std::pow(Real(10), std::ceil(std::log10(largest)) - decades_of_a_series) : 0;
}

}  // namespace

/// Without --variants, omits a curve that has no other to compare it with if the scene has a number, which says as much.
std::vector<Panel> Experiment::panels(const std::vector<Result>& results) const {
  std::vector<Panel> all;
  for (std::size_t a = 0; a < scene_records_.size(); ++a) {
    const SceneRecord& record = scene_records_[a];
    const std::size_t quantities = std::max<std::size_t>(1, record.series.size());
    for (std::size_t q = 0; q < quantities; ++q) {
      if (!record.series.empty() && !record.series[q].drawn) continue;
      Panel panel;
      panel.title = record.scene.name;
      panel.x_label = "time, s";
      panel.y_label = record.series.empty()
                          ? "deepest overlap, mm"
                          : fmt::format("{}{}{}", record.series[q].name, record.series[q].unit.empty() ? "" : ", ",
                                        record.series[q].unit);
      panel.log_y = !record.series.empty() && record.series[q].log_y;
      for (const Result& result : results) {
        if (result.variant->scene != a || !result.variant->curves) continue;
        Curve curve{result.variant->name,
                    {},
                    {},
                    line_colour(static_cast<std::size_t>(result.variant->colour)),
                    Curve::Style::line,
                    marker_of(static_cast<std::size_t>(result.variant->colour))};
        for (std::size_t i = 0; i < result.samples.size(); ++i) {
          curve.x.push_back(result.samples[i].time);
          curve.y.push_back(record.series.empty() ? 1000 * result.samples[i].overlap
                                                  : result.series.at(record.series[q].name)[i]);
        }
        const std::vector<Real> times = curve.x;
        panel.curves.push_back(std::move(curve));
        if (q == 0) {
          for (const Reference& reference : result.variant->references) {
            const bool told = std::any_of(panel.curves.begin(), panel.curves.end(),
                                          [&](const Curve& drawn) { return drawn.label == reference.label; });
            Curve dashed{told ? "" : reference.label, times, {}, "#222222", Curve::Style::dashed};
            for (const Real t : times) dashed.y.push_back(reference.of_time(t));
            panel.curves.push_back(std::move(dashed));
          }
        }
      }
      if (panel.log_y) panel.floor = floor_of(panel);
      const bool alone = panel.curves.size() == 1 && !record.numbers.empty() && only_.empty();
      if (!panel.curves.empty() && !alone) all.push_back(std::move(panel));
    }
  }
  all.insert(all.end(), own_panels_.begin(), own_panels_.end());
  return all;
}

std::string Experiment::numbers_table(const std::vector<Result>& results) const {
  std::string table;
  for (std::size_t a = 0; a < scene_records_.size(); ++a) {
    const SceneRecord& record = scene_records_[a];
    std::string header = fmt::format("| {} |", record.scene.name);
    std::string rule = "| --- |";
    for (const Number& number : record.numbers) {
      header += fmt::format(" {} |", number.name);
      rule += " --- |";
    }
    std::string body;
    for (const Result& result : results) {
      if (result.variant->scene != a) continue;
      body += fmt::format("| {} {} |", marker_of(static_cast<std::size_t>(result.variant->colour)),
                          shown_name(*result.variant));
      for (std::size_t i = 0; i < record.numbers.size(); ++i) {
        body += fmt::format(" {}", in_words(result.numbers[i], record.numbers[i].unit));
        const auto should = result.variant->expected.find(record.numbers[i].name);
        if (should != result.variant->expected.end())
          body += fmt::format(" (should be {})", in_words(should->second, ""));
        body += " |";
      }
      if (!result.mishap.empty()) body += " " + result.mishap;
      body += "\n";
    }
    if (!body.empty()) table += (table.empty() ? "" : "\n") + header + "\n" + rule + "\n" + body;
  }
  if (!remarks_.empty()) table += "\n";
  for (const std::string& sentence : remarks_) table += "- " + sentence + "\n";
  return table;
}

namespace {

std::string sample_line(const Sample& s) {
  return fmt::format("{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{}", s.time, s.kinetic_energy, s.potential_energy,
                     s.momentum.x(), s.momentum.y(), s.momentum.z(), s.angular_momentum.x(), s.angular_momentum.y(),
                     s.angular_momentum.z(), s.overlap, s.contacts, s.found, s.lost, s.rows, s.residual,
                     s.solver_seconds);
}

}  // namespace

/// The columns that all scenes have, followed by the series of the scenes.
std::string Experiment::metrics(const std::vector<Result>& results) const {
  std::set<std::string> series;
  for (const SceneRecord& record : scene_records_) {
    for (const Quantity& quantity : record.series) series.insert(quantity.name);
  }
  std::string csv =
      "scene,variant,step,time,kinetic_energy,potential_energy,px,py,pz,lx,ly,lz,deepest_overlap,contacts,found,lost,"
      "rows,residual,solver_seconds";
  for (const std::string& name : series) csv += "," + slug(name);
  csv += "\n";
  for (const Result& result : results) {
    for (std::size_t i = 0; i < result.samples.size(); ++i) {
      csv += fmt::format("\"{}\",\"{}\",{},{}", scene_records_[result.variant->scene].scene.name, result.variant->name,
                         i + 1, sample_line(result.samples[i]));
      for (const std::string& name : series) {
        const auto found = result.series.find(name);
        csv += found == result.series.end() ? std::string(",") : fmt::format(",{}", found->second[i]);
      }
      csv += "\n";
    }
  }
  return csv;
}

void Experiment::report(std::vector<Result>& results, const fs::path& folder) const {
  write_text_file(folder / "metrics.csv", metrics(results));
  const std::string table = numbers_table(results);
  write_text_file(folder / "numbers.md", table);
  fmt::print("{}\n{}", name_, table);
  for (const Result& result : results) {
    if (!result.mishap.empty()) fmt::print("{}: {}\n", result.variant->name, result.mishap);
  }
  if (no_images_) return;
  if (!film_.empty()) make_films(folder);
  draw_sheets(results, folder);
  fmt::print("\n");
  for (const fs::path& plot : write_plot(folder / "plot.png", panels(results))) fmt::print("{}\n", plot.string());
}

std::string Experiment::sheet_file(std::size_t index) const {
  const bool first = std::none_of(scene_records_.begin(), scene_records_.begin() + static_cast<std::ptrdiff_t>(index),
                                  [](const SceneRecord& earlier) { return earlier.scene.pictures; });
  return first ? "sheet.png" : fmt::format("sheet_{}.png", key_of(scene_records_[index].scene));
}

void Experiment::draw_sheets(std::vector<Result>& results, const fs::path& folder) const {
  std::set<fs::path> drawn;
  for (std::size_t a = 0; a < scene_records_.size(); ++a) {
    const std::optional<Sheet> sheet = sheet_of(a, results);
    if (!sheet) continue;
    const fs::path file = folder / sheet_file(a);
    keep_picture(file, make_sheet(*sheet));
    if (file.filename() == "sheet.png") {
      keep_picture(folder / "thumbnail.png", make_thumbnail(*sheet));
      const std::optional<Guess>& guess = scene_records_[a].scene.guess;
      const std::vector<Image> guessed =
          guess && only_.empty() && mine_.empty() ? make_guess(*sheet, *guess) : std::vector<Image>{};
      for (std::size_t i = 0; i < guessed.size(); ++i)
        keep_picture(folder / fmt::format("guess_{}.png", i + 1), guessed[i]);
    }
    drawn.insert(file);
    fmt::print("\n{}", file.string());
  }
  if (!only_.empty()) return;
  std::vector<fs::path> stale;  // of scenes that no longer exist
  for (const auto& entry : fs::directory_iterator(folder)) {
    if (entry.path().filename().string().starts_with("sheet_") && !drawn.contains(entry.path()))
      stale.push_back(entry.path());
  }
  for (const fs::path& file : stale) fs::remove(file);
}

/// "steps of 0.01667 s, 10 sweeps": the values that all variants of the scene share, or the default for names that give none.
std::string Experiment::how_solved(std::size_t index) const {
  std::set<int> substeps, sweeps;
  bool by_default = false;
  for (const Variant& variant : variants_) {
    if (variant.scene != index) continue;
    substeps.insert(variant.plan(dt_).all_substeps());
    sweeps.insert(sweeps_of(variant));
    by_default = by_default || (variant.sweeps == 0 && sweeps_of(variant) == sweeps_);
  }
  std::string text = substeps.size() == 1
                         ? fmt::format("steps of {:.4g} s", dt_ / static_cast<Real>(*substeps.begin()))
                         : fmt::format("steps of {:.4g} s, cut into substeps where a name says so", dt_);
  if (sweeps.size() == 1) text += fmt::format(", {} sweep{}", *sweeps.begin(), *sweeps.begin() == 1 ? "" : "s");
  else if (by_default) text += fmt::format(", {} sweeps where no name says more", sweeps_);
  return text;
}

/// None if the scene has no pictures.
std::optional<Sheet> Experiment::sheet_of(std::size_t index, std::vector<Result>& results) const {
  const Scene& scene = scene_records_[index].scene;
  Sheet sheet{.question = question_,
              .scene = scene.name,
              .caption = scene.caption,
              .foot = name_ + " · " + how_solved(index),
              .start = {},
              .legend = {},
              .raster = scene.raster,
              .wide = scene.strobe.has_value(),
              .rows = {}};
  Legend legend;
  for (Result& result : results) {
    if (result.variant->scene != index || result.cells.empty()) continue;
    const Variant& variant = *result.variant;
    legend.add(result.legend);
    if (result.start) sheet.start = std::move(result.start);
    SheetRow row{marker_of(static_cast<std::size_t>(variant.colour)),
                 shown_name(variant),
                 ink_of(line_colour(static_cast<std::size_t>(variant.colour))),
                 {},
                 std::move(result.cells),
                 std::move(result.cell_notes),
                 std::move(result.raster)};
    for (std::size_t i = 0; i < scene_records_[index].numbers.size(); ++i) {
      const Number& number = scene_records_[index].numbers[i];
      const auto should = variant.expected.find(number.name);
      row.numbers.push_back(
          {fmt::format("{}: {}", number.name, in_words(result.numbers[i], number.unit)),
           should == variant.expected.end() ? "" : "should be " + in_words(should->second, number.unit)});
    }
    sheet.rows.push_back(std::move(row));
  }
  if (sheet.rows.empty()) return {};
  const Image& cell = sheet.rows.front().cells.front();
  sheet.labels = labels_of(scene, static_cast<Real>(cell.width) / static_cast<Real>(cell.height));
  const std::size_t last = sheet.rows.size() - 1;
  const auto [one, other] = scene.in_brief.value_or(std::pair(std::size_t{0}, last));
  sheet.in_brief = {std::min(one, last), std::min(other, last)};  // --variants may have left some out
  sheet.legend = legend.entries();
  for (const auto& [ink, meaning] : scene.colours) sheet.legend.push_back({LegendEntry::Kind::body, ink, meaning});
  return sheet;
}

}  // namespace pushback
