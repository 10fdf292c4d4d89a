#include "pushback/chapters/27_which_error/choose.h"

#include <chrono>
#include <map>

#include "pushback/chapters/27_which_error/scenes.h"
#include "pushback/common/basics/files.h"
#include "pushback/common/basics/named.h"
#include "pushback/common/experiment/kept_picture.h"
#include "pushback/common/experiment/picture_of.h"
#include "pushback/common/experiment/plot.h"
#include "pushback/common/experiment/program.h"
#include "pushback/common/experiment/sheet.h"
#include "pushback/common/experiment/words.h"
#include "pushback/common/render/painter.h"
#include "pushback/common/render/palette.h"
#include "pushback/common/world/measure.h"

namespace pushback {

using namespace which_error_scenes;

namespace {

constexpr Real dt = Real(1) / 60;
constexpr Real diverged = 100;  // times the requested error: beyond it, places are meaningless
constexpr int at_once = 15;     // steps

/// Reads "1mm", "0.5 cm" or "2 ms". `units`: the size of each unit in m or s, the unit of the result. Throws InvalidInput.
Real quantity(const std::string& option, const std::string& text, const std::map<std::string, Real>& units) {
  std::size_t read = 0;
  double number = 0;
  try {
    number = std::stod(text, &read);
  } catch (const std::exception&) {
    read = 0;
  }
  std::string unit = text.substr(read);
  unit.erase(0, unit.find_first_not_of(' ') == std::string::npos ? unit.size() : unit.find_first_not_of(' '));
  const auto found = units.find(unit);
  if (read == 0 || found == units.end() || !(number > 0) || !std::isfinite(number)) {
    std::vector<std::string> names;
    for (const auto& [name, size] : units) names.push_back(name);
    throw InvalidInput(fmt::format("{} is '{}': a number above 0 with a unit is needed, one of {}", option, text,
                                   fmt::join(names, ", ")));
  }
  const Real value = static_cast<Real>(number) * found->second;
  if (!(value >= Real(1e-15) && value <= 1000))
    throw InvalidInput(
        fmt::format("{} is '{}': from 1e-15 to 1000 {} is needed", option, text, units.contains("m") ? "m" : "s"));
  return value;
}

struct Step {
  double seconds;  // computing time
  Real known;      // m
  int bodies_kept, bodies;
  std::size_t contacts;
  BodyError most;  // of the body with the largest error in this step
  std::map<std::string, int> ways;
};
struct Played {
  std::vector<Step> steps;
  std::vector<World> worlds;  // after each step

  double seconds() const {
    double all = 0;
    for (const Step& step : steps) all += step.seconds;
    return all;
  }
  /// The mean time of a step, s, without the first ones, which still allocate memory and fill caches.
  double seconds_of_step() const {
    const std::size_t first = std::min<std::size_t>(5, steps.size() / 2);
    double all = 0;
    for (std::size_t i = first; i < steps.size(); ++i) all += steps[i].seconds;
    return all / static_cast<double>(steps.size() - first);
  }
  Real known() const {
    Real largest = 0;
    for (const Step& step : steps) largest = std::max(largest, step.known);
    return largest;
  }
};

std::string way_of(const BodyError& known) {
  switch (known.how) {
    case StepType::flight:
      return "in flight";
    case StepType::half_steps:
      return known.order == 4 ? "steps of fourth order" : "half steps";
    case StepType::substeps:
      return "substeps";
    case StepType::none:
      break;
  }
  return "not at all";
}

Played play(World world, Real error, int steps) {
  Painted solver(error);
  Played played;
  for (int i = 0; i < steps; ++i) {
    const auto began = std::chrono::steady_clock::now();
    solver.within.whole_step(world, dt, 1);
    Step step{std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count(),
              0,
              0,
              0,
              world.contacts.size(),
              {},
              {}};
    for (Body& body : world.bodies) {
      if (!body.movable()) continue;
      const BodyError known = solver.within.error_of(body.index);
      body.coloured(static_cast<int>(paint_of(known)));
      ++step.bodies;
      step.bodies_kept += known.kept;
      step.known = std::max(step.known, known.place);
      if (known.step >= step.most.step) step.most = known;
      ++step.ways[way_of(known)];
    }
    played.steps.push_back(step);
    played.worlds.push_back(world);
  }
  return played;
}

/// The distance from the same scene in steps `finer` times shorter, within an error `finer` times smaller, after each 1/60 s, m.
std::vector<Real> measure(World world, const Played& played, Real error, int finer) {
  IslandSolver truth;
  truth.error = error / static_cast<Real>(finer);
  std::vector<Real> off;
  for (const World& at : played.worlds) {
    for (int i = 0; i < finer; ++i) world.step(truth, dt / static_cast<Real>(finer));
    off.push_back(apart(at, world));
  }
  return off;
}

/// The rate at which a difference grows from `error` to `diverged` times that, 1/s. Nothing if it does not grow that far, or does so
/// in fewer than `at_once` steps.
std::optional<Real> growth(const std::vector<Real>& off, Real error) {
  const auto first = std::find_if(off.begin(), off.end(), [&](Real x) { return x > error; });
  const auto last = std::find_if(off.begin(), off.end(), [&](Real x) { return x > diverged * error; });
  if (last == off.end() || last - first < at_once) return {};
  return std::log(*last / *first) / (dt * static_cast<Real>(last - first));
}

/// The number of steps to rehearse: a fifth of them, but at most a second, and at least one.
int rehearsed(int steps) {
  return std::clamp(steps / 5, 1, 60);
}

std::string length_said(Real metres) {
  return metres < Real(1e-9) ? "less than 1e-6 mm" : fmt::format("{:.2g} mm", 1000 * metres);
}

/// A camera above and in front of the movable bodies, far enough away to show all of them.
Camera camera_for(const std::vector<World>& worlds) {
  Vec3 low = Vec3::Constant(std::numeric_limits<Real>::infinity()), high = -low;
  for (const World* world : {&worlds.front(), &worlds[worlds.size() / 2], &worlds.back()})
    for (const Body& body : world->bodies) {
      if (!body.movable()) continue;
      low = low.cwiseMin(body.position);
      high = high.cwiseMax(body.position);
    }
  const Vec3 middle = (low + high) / 2;
  const Real size = std::max(Real(1), (high - low).norm());
  return {middle + size * Vec3(Real(0.15), Real(0.25), Real(1.05)), middle};
}

void draw(const std::filesystem::path& folder, const std::string& name, const std::string& asked, const Played& played,
          const std::vector<Real>& off) {
  const Camera camera = camera_for(played.worlds);
  Painter painter(cell_width * 2, cell_width * 9 / 8);
  Sheet sheet;
  sheet.question = name;
  sheet.scene = "within " + asked;
  sheet.caption = "The colour of a body: how it was moved in the latest step.";
  for (const auto& [paint, said] : {std::pair(Paint::flight, "in flight"),
                                    {Paint::two, "one or two half steps"},
                                    {Paint::more, "more half steps"},
                                    {Paint::fourth, "fourth order"},
                                    {Paint::substeps, "substeps"}})
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
    measured.push_back(1000 * off[i]);
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
                                    .curves = {{"known", times, known, line_colour(0), Curve::Style::dashed},
                                               {"measured", times, measured, line_colour(2)}},
                                    .floor = Real(1e-6)},
                                   {.title = "time",
                                    .x_label = "s",
                                    .y_label = "us in 1/60 s",
                                    .log_y = true,
                                    .curves = {{"", times, micros, line_colour(1)}}},
                                   {.title = "substeps of what is worst",
                                    .x_label = "s",
                                    .y_label = "in 1/60 s",
                                    .log_y = true,
                                    .curves = {{"", times, substeps, line_colour(3)}}}});
}

/// Warns that the prediction does not hold if a later step has more than twice the contacts of the rehearsal.
void warn_of_later_contacts(const Played& rehearsal, const Played& played) {
  const auto more = [](const Step& p, const Step& q) { return p.contacts < q.contacts; };
  const auto most = std::max_element(rehearsal.steps.begin(), rehearsal.steps.end(), more)->contacts;
  const auto first = std::find_if(played.steps.begin(), played.steps.end(),
                                  [most](const Step& step) { return step.contacts > 2 * most; });
  if (first == played.steps.end()) return;
  const auto at = static_cast<std::size_t>(first - played.steps.begin());
  fmt::print(
      "The prediction does not hold: the rehearsal ended at {:.2g} s with at most {} contacts, and at {:.2g} s there "
      "are "
      "{}.\n",
      static_cast<double>(rehearsal.worlds.back().time), most, static_cast<double>(played.worlds[at].time),
      first->contacts);
}

void tell(const Played& played, const std::vector<Real>& off, Real error, const std::string& asked) {
  std::map<std::string, double> ways;
  for (const Step& step : played.steps)
    for (const auto& [way, count] : step.ways) ways[way] += count;
  const double count = static_cast<double>(played.steps.size());
  fmt::print("\nmoved, on average: ");
  const char* between = "";
  for (const auto& [way, bodies] : ways)
    fmt::print("{}{:.3g} bodies {}", std::exchange(between, ", "), bodies / count, way);
  const Real measured = *std::max_element(off.begin(), off.end());
  fmt::print("\nmeasured:  {:.3g} ms in all, {:.3g} us a step; error {}\n", 1e3 * played.seconds(),
             1e6 * played.seconds() / count, length_said(measured));
  int unkept = 0;
  for (const Step& step : played.steps) unkept += step.bodies_kept < step.bodies;
  if (unkept > 0)
    fmt::print(
        "In {} of {} steps {} is not kept by some island: something bounces, who touches first or sticks is decided "
        "otherwise in more substeps, or their bound is reached.\n",
        unkept, played.steps.size(), asked);
  if (const std::optional<Real> rate = growth(off, error))
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
  int finer = 64;
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
    const int steps = static_cast<int>(std::lround(seconds / static_cast<double>(dt)));
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
        const Played first = play(begin, tried, rehearsed(steps));
        const Real took = static_cast<Real>(first.seconds_of_step());
        fmt::print("within {:<8} {:8.3g} us a step\n", length_said(tried) + ":", 1e6 * took);
        if (took <= *most) best = tried;
      }
      if (!best)
        throw InvalidInput(fmt::format("--budget is {}: none of these errors is to be had for that", budget_text));
      error = *best;
      asked = length_said(error);
    }
    const Played first = play(begin, error, rehearsed(steps));
    const double more = static_cast<double>(steps) / static_cast<double>(first.steps.size());
    fmt::print(
        "{}, {:g} s, within {} a second\nrehearsed: {:.2g} s\npredicted: {:.3g} ms in all, {:.3g} us a step; error "
        "{}\n",
        name, seconds, asked, static_cast<double>(first.worlds.back().time), 1e3 * first.seconds_of_step() * steps,
        1e6 * first.seconds_of_step(), length_said(first.known() * static_cast<Real>(more)));
    if (std::any_of(first.steps.begin(), first.steps.end(),
                    [](const Step& step) { return step.bodies_kept < step.bodies; }))
      fmt::print("It will not be kept by all islands in all steps.\n");
    std::fflush(stdout);
    const Played played = play(begin, error, steps);
    const std::vector<Real> off = measure(begin, played, error, finer);
    warn_of_later_contacts(first, played);
    tell(played, off, error, asked);
    if (no_images) return;
    draw(out / "choose" / slug(name), name, asked, played, off);
    fmt::print("{}\n{}\n", (out / "choose" / slug(name) / "sheet.png").string(),
               (out / "choose" / slug(name) / "plot.png").string());
  });
}

}  // namespace pushback
