#include "pushback/chapters/27_which_error/choose.h"

#include <map>

#include "pushback/chapters/27_which_error/play_within.h"
#include "pushback/chapters/27_which_error/prediction.h"
#include "pushback/chapters/27_which_error/scenes.h"
#include "pushback/common/basics/files.h"
#include "pushback/common/basics/named.h"
#include "pushback/common/basics/number_with_unit.h"
#include "pushback/common/experiment/camera_around.h"
#include "pushback/common/experiment/kept_picture.h"
#include "pushback/common/experiment/picture_of.h"
#include "pushback/common/experiment/plot.h"
#include "pushback/common/experiment/program.h"
#include "pushback/common/experiment/sheet.h"
#include "pushback/common/experiment/words.h"
#include "pushback/common/render/painter.h"
#include "pushback/common/render/palette.h"

namespace pushback {

using namespace which_error_scenes;

namespace {

/// A length in m or a time in s. Throws InvalidInput.
Real quantity(const std::string& option, const std::string& text, const std::map<std::string, Real>& units) {
  const Real value = number_with_unit(option, text, units);
  if (!(value >= Real(1e-15) && value <= 1000))
    throw InvalidInput(
        fmt::format("{} is '{}': from 1e-15 to 1000 {} is needed", option, text, units.contains("m") ? "m" : "s"));
  return value;
}

std::string length_said(Real metres) {
  return metres < Real(1e-9) ? "less than 1e-6 mm" : fmt::format("{:.2g} mm", 1000 * metres);
}

void draw(const std::filesystem::path& folder, const std::string& name, const std::string& asked, const Played& played,
          const std::vector<Real>& measured_off) {
  const Camera camera = camera_around(played.worlds);
  Painter painter(cell_width * 2, cell_width * 9 / 8);
  Sheet sheet;
  sheet.question = name;
  sheet.scene = "within " + asked;
  sheet.caption = "The colour shows how a body was moved in the latest step.";
  for (const auto& [paint, said] : named_paints())
    sheet.legend.push_back({LegendEntry::Kind::body, body_ink(static_cast<int>(paint)), said});
  SheetRow row;
  for (const std::size_t part : {1, 2, 3}) {
    const std::size_t at = std::max<std::size_t>(1, played.worlds.size() * part / 3) - 1;
    row.cells.push_back(painter.draw_still(picture_of(played.worlds[at], camera, {})));
    row.cell_notes.push_back(fmt::format("t = {:.2f} s", played.worlds[at].time));
  }
  sheet.rows.push_back(row);
  keep_picture(folder / "sheet.png", make_sheet(sheet));

  std::vector<Real> times, known, measured, micros, substeps;
  std::map<std::string, Curve> ways;
  for (std::size_t i = 0; i < played.steps.size(); ++i) {
    times.push_back(played.worlds[i].time);
    known.push_back(1000 * played.steps[i].known);
    measured.push_back(1000 * measured_off[i]);
    micros.push_back(static_cast<Real>(1e6 * played.steps[i].seconds));
    substeps.push_back(static_cast<Real>(std::max(1, played.steps[i].most.substeps)));
    for (const auto& [way, count] : played.steps[i].ways) {
      Curve& curve = ways.try_emplace(way, Curve{way, {}, {}, line_colour(ways.size())}).first->second;
      curve.x.push_back(times.back());
      curve.y.push_back(static_cast<Real>(count));
    }
  }
  Panel bodies{.title = name + ", within " + asked, .x_label = "s", .y_label = "bodies"};
  for (const auto& [way, curve] : ways) bodies.curves.push_back(curve);
  write_plot(folder / "plot.png", {bodies,
                                   {.title = "error",
                                    .x_label = "s",
                                    .y_label = "mm",
                                    .log_y = true,
                                    .curves = {{"said", times, known, line_colour(0), Curve::Style::dashed},
                                               {"measured", times, measured, line_colour(2)}},
                                    .floor = Real(1e-6)},
                                   {.title = "time",
                                    .x_label = "s",
                                    .y_label = "us in 1/60 s",
                                    .log_y = true,
                                    .curves = {{"", times, micros, line_colour(1)}}},
                                   {.title = "substeps of the body with the largest error",
                                    .x_label = "s",
                                    .y_label = "in 1/60 s",
                                    .log_y = true,
                                    .curves = {{"", times, substeps, line_colour(3)}}}});
}

/// "3 ms in all, 50 us a step"
std::string time_said(double seconds, std::size_t steps) {
  return fmt::format("{:.3g} ms in all, {:.3g} us a step", 1e3 * seconds, 1e6 * seconds / static_cast<double>(steps));
}

void tell(const Prediction& prediction, std::size_t steps) {
  const auto or_why = [](const std::string& value, const std::string& why) {
    return why.empty() ? value : "not predictable: " + why;
  };
  fmt::print("predicted: {}; error {}\n", or_why(time_said(prediction.seconds, steps), prediction.no_time),
             or_why(length_said(prediction.error), prediction.no_error));
  if (prediction.rehearsed > 0)
    fmt::print("           from the whole scene in steps of 1/15 and 1/30 s, which took {:.3g} ms\n",
               1e3 * prediction.rehearsed);
}

void tell(const Played& played, const std::vector<Real>& measured_off, Real error, const std::string& asked) {
  std::map<std::string, double> ways;
  for (const PlayedStep& step : played.steps)
    for (const auto& [way, count] : step.ways) ways[way] += count;
  const double count = static_cast<double>(played.steps.size());
  fmt::print("\nmoved, on average: ");
  const char* between = "";
  for (const auto& [way, bodies] : ways)
    fmt::print("{}{:.3g} bodies {}", std::exchange(between, ", "), bodies / count, way);
  const Real measured = *std::max_element(measured_off.begin(), measured_off.end());
  fmt::print("\nmeasured:  {}; error {}\n", time_said(played.seconds(), played.steps.size()), length_said(measured));
  int unkept = 0;
  for (const PlayedStep& step : played.steps) unkept += step.bodies_kept < step.bodies;
  if (unkept > 0)
    fmt::print("In {} of {} steps the solver said that some body may be off by more than {}.\n", unkept,
               played.steps.size(), asked);
  if (const std::optional<Real> rate = growth(measured_off, error, dt_within))
    fmt::print(
        "Places part by a factor of e every {:.2g} s: the scene is chaotic, and after some time no error of places can "
        "be kept.\n",
        1 / *rate);
  else if (const Real allowed = error * std::max(Real(1), played.worlds.back().time); measured > allowed)
    fmt::print("More than was asked: {} in this time.\n", length_said(allowed));
}

}  // namespace

int choose(const std::vector<Scene>& scenes, int argc, const char* const* argv) {
  return choose_or_read(scenes, {}, argc, argv);
}

int choose_or_read(const std::vector<Scene>& scenes, const std::function<World(const std::filesystem::path&)>& read,
                   int argc, const char* const* argv) {
  CommandLine line(
      "A scene within an error: which steps each island of it takes, what that costs, and how far off it then is.");
  std::string name, error_text = "1mm", budget_text;
  double seconds = 3;
  int finer = finer_truth;
  std::filesystem::path out = "renders/here";
  bool no_images = false;
  auto which = line.option("scene", name, read ? "A scene, or a file of one in JSON: NAME.json" : "A scene");
  if (scenes.size() != 1) which.required();
  const auto asked_option =
      line.option("--error", error_text, "By which places may be off after a second: 1mm, 0.1 cm, 20um")
          .shows_default();
  auto budget =
      line.option("--budget", budget_text, "Instead: the least error for so much time a step of 1/60 s: 2ms, 500us");
  budget.without(asked_option);
  line.option("--seconds", seconds, "So long it is played").shows_default().between(0.1, 60.0);
  line.option("--finer", finer, "The truth is the same in steps so many times shorter, within so many times less")
      .shows_default()
      .between(2, 1024);
  line.option("--out", out, "A folder for the pictures").shows_default();
  line.flag("--no-images", no_images, "Words alone");
  line.ends_with(fmt::format("The scenes: {}", fmt::join(names_of(scenes), ", ")));
  return line.run(argc, argv, [&] {
    World begin;
    if (read && name.ends_with(".json")) {
      begin = read(name);
      name = std::filesystem::path(name).stem().string();
    } else {
      if (name.empty()) name = scenes.front().name;
      named("scene", scenes, name).fill(begin);
    }
    require_between("--seconds", static_cast<Real>(seconds), Real(0.1), 60);  // the range above lets nan pass
    const int steps = static_cast<int>(std::lround(seconds / static_cast<double>(dt_within)));
    const std::map<std::string, Real> lengths{{"m", 1}, {"cm", Real(1e-2)}, {"mm", Real(1e-3)}, {"um", Real(1e-6)}};
    Real error = quantity("--error", error_text, lengths);
    std::string asked = error_text;
    std::optional<Real> most;
    if (budget.given()) most = quantity("--budget", budget_text, {{"s", 1}, {"ms", Real(1e-3)}, {"us", Real(1e-6)}});
    if (!no_images) make_writable_folder(out / "choose" / slug(name));
    if (most) {
      std::optional<Real> best;
      for (int power = 0; power <= 10; ++power) {
        const Real tried = Real(0.1) * std::pow(Real(10), -static_cast<Real>(power) / 2);
        const Prediction first = predict(begin, tried, steps);
        if (!first.no_time.empty())
          throw InvalidInput(
              fmt::format("--budget is {}, but the time is not predictable: {}", budget_text, first.no_time));
        const Real took = static_cast<Real>(first.seconds / steps);
        fmt::print("within {:<8} {:8.3g} us a step\n", length_said(tried) + ":", 1e6 * took);
        if (took <= *most) best = tried;
      }
      if (!best)
        throw InvalidInput(fmt::format("--budget is {}: none of these errors is to be had for that", budget_text));
      error = *best;
      asked = length_said(error);
    }
    fmt::print("{}, {:g} s, within {} a second\n", name, seconds, asked);
    tell(predict(begin, error, steps), static_cast<std::size_t>(steps));
    std::fflush(stdout);
    const Played played = play_within(begin, error, steps);
    const std::vector<Real> measured_off = off(begin, played, error, finer);
    tell(played, measured_off, error, asked);
    if (no_images) return;
    draw(out / "choose" / slug(name), name, asked, played, measured_off);
    fmt::print("{}\n{}\n", (out / "choose" / slug(name) / "sheet.png").string(),
               (out / "choose" / slug(name) / "plot.png").string());
  });
}

}  // namespace pushback
