/// What an experiment leaves behind: the table of numbers, the metrics, the sheet, the plot.
#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>

#include "pushback/common/basics/files.h"
#include "pushback/common/experiment/experiment_parts.h"
#include "pushback/common/experiment/kept_picture.h"
#include "pushback/common/experiment/sheet.h"
#include "pushback/common/render/palette.h"

namespace pushback {

namespace fs = std::filesystem;

// ---- words -------------------------------------------------------------------------------------------------------------

namespace {

/// Three significant digits; what is rounding noise, or no number, says so.
std::string in_words(Real value, const std::string& unit) {
  if (!std::isfinite(value)) return "–";
  std::string text;
  const Real size = std::abs(value);
  if (size == 0) text = "0";
  else if (size < 1e-6) text = "< 1e-6";
  else if (size < 1e-3 || size >= 1e6) text = fmt::format("{:.2e}", value);
  else if (size >= 1000) text = fmt::format("{:.0f}", value);
  else text = fmt::format("{:.3g}", value);
  return unit.empty() ? text : text + " " + unit;
}

Ink ink_of(const std::string& colour) {
  const unsigned long rgb = std::stoul(colour.substr(1), nullptr, 16);
  return {static_cast<std::uint8_t>(rgb >> 16 & 255), static_cast<std::uint8_t>(rgb >> 8 & 255),
          static_cast<std::uint8_t>(rgb & 255)};
}

}  // namespace

std::string slug(std::string name) {
  static const std::vector<std::pair<std::string, std::string>> spelling{
      {"β", "beta"}, {"μ", "mu"}, {"Σ", "sum-"}, {"λ", "lambda"}, {"θ", "theta"}, {"ω", "omega"}, {"≥", "at-least"}};
  for (const auto& [symbol, word] : spelling) {
    for (std::size_t at = name.find(symbol); at != std::string::npos; at = name.find(symbol, at))
      name.replace(at, symbol.size(), word);
  }
  std::string out;
  for (const unsigned char c : name) {
    const bool keep = c < 0x80 && (std::isalnum(c) != 0 || c == '.');
    if (keep) out += static_cast<char>(std::tolower(c));
    else if (!out.empty() && out.back() != '-') out += '-';
  }
  while (!out.empty() && out.back() == '-') out.pop_back();
  return out;
}

// ---- diagrams and tables -------------------------------------------------------------------------------------------

/// Where a variant has a number of sweeps of its own, its name says so.
std::string Experiment::shown_name(const Variant& variant) const {
  const bool said = sweeps_of(variant) == sweeps_ || variant.exactly;
  return said ? variant.name : fmt::format("{}, {} sweeps", variant.name, sweeps_of(variant));
}

std::string Experiment::colour_of(const Variant& variant, std::size_t place) {
  return line_colour(variant.colour < 0 ? place : static_cast<std::size_t>(variant.colour));
}

std::vector<Panel> Experiment::panels(const std::vector<Result>& results) const {
  std::vector<Panel> all;
  for (std::size_t a = 0; a < acts_.size(); ++a) {
    const Act& act = acts_[a];
    const std::size_t quantities = std::max<std::size_t>(1, act.series.size());
    for (std::size_t q = 0; q < quantities; ++q) {
      Panel panel;
      panel.title = act.scene.name;
      panel.x_label = "time, s";
      panel.y_label = act.series.empty() ? "deepest overlap, mm"
                                         : fmt::format("{}{}{}", act.series[q].name,
                                                       act.series[q].unit.empty() ? "" : ", ", act.series[q].unit);
      panel.log_y = !act.series.empty() && act.series[q].log_y;
      for (std::size_t r = 0; r < results.size(); ++r) {
        const Result& result = results[r];
        if (result.variant->scene != a) continue;
        Curve curve{shown_name(*result.variant), {}, {}, colour_of(*result.variant, r), Curve::Style::line};
        for (std::size_t i = 0; i < result.samples.size(); ++i) {
          curve.x.push_back(result.samples[i].time);
          curve.y.push_back(act.series.empty() ? 1000 * result.samples[i].overlap
                                               : result.series.at(act.series[q].name)[i]);
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
      if (!panel.curves.empty()) all.push_back(std::move(panel));
    }
  }
  all.insert(all.end(), own_panels_.begin(), own_panels_.end());
  return all;
}

std::string Experiment::numbers_table(const std::vector<Result>& results) const {
  std::string table;
  for (std::size_t a = 0; a < acts_.size(); ++a) {
    const Act& act = acts_[a];
    std::string header = fmt::format("| {} |", act.scene.name);
    std::string rule = "| --- |";
    for (const Number& number : act.numbers) {
      header += fmt::format(" {} |", number.name);
      rule += " --- |";
    }
    std::string body;
    for (const Result& result : results) {
      if (result.variant->scene != a) continue;
      body += fmt::format("| {} |", shown_name(*result.variant));
      for (std::size_t i = 0; i < act.numbers.size(); ++i) {
        body += fmt::format(" {}", in_words(result.numbers[i], act.numbers[i].unit));
        const auto should = result.variant->expected.find(act.numbers[i].name);
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

/// What the dots, arrows and colours mean, as far as the pictures have them.
std::vector<SheetLegend> legend(const std::set<ContactState>& seen, bool sleepers) {
  const bool friction = seen.count(ContactState::sticking) + seen.count(ContactState::sliding) > 0;
  const bool memory = seen.count(ContactState::warm) > 0 || (friction && seen.count(ContactState::fresh) > 0);
  std::vector<SheetLegend> entries;
  const auto add = [&](ContactState state, const std::string& text) {
    if (seen.count(state) > 0) entries.push_back({contact_ink(state), text});
  };
  add(ContactState::fresh, memory ? "contact point: new in this step" : "contact point");
  add(ContactState::warm, "contact point: kept from the step before");
  add(ContactState::sticking, "contact point: sticking");
  add(ContactState::sliding, "contact point: sliding");
  if (!seen.empty()) entries.push_back({normal_arrow_ink(), "arrow: normal impulse"});
  if (friction) entries.push_back({friction_arrow_ink(), "arrow: friction impulse"});
  if (sleepers) entries.push_back({asleep_ink(), "body: asleep"});
  return entries;
}

std::string sample_line(const Sample& s) {
  return fmt::format("{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{}", s.time, s.kinetic_energy, s.potential_energy,
                     s.momentum.x(), s.momentum.y(), s.momentum.z(), s.angular_momentum.x(), s.angular_momentum.y(),
                     s.angular_momentum.z(), s.overlap, s.contacts, s.found, s.lost, s.rows, s.residual,
                     s.solver_seconds);
}

}  // namespace

/// The series of a scene stand behind the columns that all scenes have.
std::string Experiment::metrics(const std::vector<Result>& results) const {
  std::set<std::string> series;
  for (const Act& act : acts_) {
    for (const Quantity& quantity : act.series) series.insert(quantity.name);
  }
  std::string csv =
      "scene,variant,step,time,kinetic_energy,potential_energy,px,py,pz,lx,ly,lz,deepest_overlap,contacts,found,lost,"
      "rows,residual,solver_seconds";
  for (const std::string& name : series) csv += "," + slug(name);
  csv += "\n";
  for (const Result& result : results) {
    for (std::size_t i = 0; i < result.samples.size(); ++i) {
      csv += fmt::format("\"{}\",\"{}\",{},{}", acts_[result.variant->scene].scene.name, result.variant->name, i + 1,
                         sample_line(result.samples[i]));
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
  draw_sheet(results, folder);
  write_plot(folder / "plot.png", panels(results));
  fmt::print("\n{}\n{}\n", (folder / "sheet.png").string(), (folder / "plot.png").string());
}

void Experiment::draw_sheet(std::vector<Result>& results, const fs::path& folder) const {
  std::set<ContactState> states;
  bool sleepers = false;
  for (const Result& result : results) {
    states.insert(result.states.begin(), result.states.end());
    sleepers = sleepers || result.sleepers;
  }
  std::vector<SheetGroup> groups;
  for (std::size_t a = 0; a < acts_.size(); ++a) {
    SheetGroup group{acts_.size() > 1 ? acts_[a].scene.name : "", {}};
    for (std::size_t r = 0; r < results.size(); ++r) {
      Result& result = results[r];
      if (result.variant->scene != a || result.cells.empty()) continue;
      SheetRow row{shown_name(*result.variant),
                   ink_of(colour_of(*result.variant, r)),
                   {},
                   std::move(result.cells),
                   std::move(result.cell_notes)};
      for (std::size_t i = 0; i < acts_[a].numbers.size(); ++i) {
        const Number& number = acts_[a].numbers[i];
        const auto should = result.variant->expected.find(number.name);
        row.numbers.push_back(
            {fmt::format("{}: {}", number.name, in_words(result.numbers[i], number.unit)),
             should == result.variant->expected.end() ? "" : "should be " + in_words(should->second, number.unit)});
      }
      group.rows.push_back(std::move(row));
    }
    if (!group.rows.empty()) groups.push_back(std::move(group));
  }
  keep_picture(folder / "sheet.png",
               make_sheet(fmt::format("{}  ·  step {:.4g} s, {} sweeps unless said", name_, dt_, sweeps_), question_,
                          groups, legend(states, sleepers)));
  if (!groups.empty()) keep_picture(folder / "thumbnail.png", make_thumbnail(groups.front()));
}

}  // namespace pushback
