#include "pushback/tools/measure/study/play.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <chrono>
#include <cmath>
#include <sstream>
#include <stdexcept>

#include "pushback/common/basics/quantile.h"
#include "pushback/common/basics/stopwatch.h"
#include "pushback/common/experiment/program.h"
#include "pushback/tools/measure/results/csv.h"
#include "pushback/tools/measure/study/every_motion.h"

namespace pushback {

using study::Measured;

namespace {

constexpr double lost_beyond = 1e4;  // m

/// Plays once, and keeps the places of every frame: with the stopwatch at rest.
struct Playing {
  std::vector<Places> places;
  double seconds = 0;
  std::optional<double> row_solves;
  bool lost = false, late = false;

  Playing(const Motion& motion, const Method& method, const Setting& setting, double at_most)
      : places(static_cast<std::size_t>(motion.frames())) {
    MotionRun run(motion, method, setting);
    const auto begin = std::chrono::steady_clock::now();
    Stopwatch own;
    try {
      for (Places& frame : places) {
        own.go();
        run.frame();
        own.stop();
        frame = run.places();
        if (std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count() <= at_most) continue;
        late = &frame != &places.back();
        break;
      }
    } catch (const InvalidInput&) {  // a state that is no number any more
      lost = true;
    }
    seconds = run.player().seconds().value_or(own.seconds());
    row_solves = run.player().row_solves();
  }
};

/// Plays once more, and does nothing else: where a frame takes a microsecond, a stopwatch that stops at each is felt.
double seconds_of(const Motion& motion, const Method& method, const Setting& setting) {
  MotionRun run(motion, method, setting);
  const int frames = motion.frames();
  Stopwatch own;
  own.go();
  try {
    for (int i = 0; i < frames; ++i) run.frame();
  } catch (const InvalidInput&) {  // it was lost at this frame before
  }
  own.stop();
  return run.player().seconds().value_or(own.seconds());
}

double largest_error(const std::vector<Places>& places, const std::vector<Places>& truth) {
  double largest = 0;
  for (std::size_t frame = 0; frame < places.size(); ++frame) {
    for (std::size_t body = 0; body < places[frame].size(); ++body) {
      const double error = (places[frame][body] - truth[frame][body]).norm();
      if (!(error < lost_beyond)) return std::numeric_limits<double>::infinity();
      largest = std::max(largest, error);
    }
  }
  return largest;
}

/// Given up before it has begun.
Measured not_played(const Method& method, const Setting& setting) {
  return {.engine = "",
          .method = method.name,
          .substeps = setting.substeps,
          .sweeps = method.sweeps ? setting.sweeps : 0,
          .error = std::numeric_limits<double>::infinity(),
          .late = true,
          .seconds = {0}};
}

}  // namespace

MotionRun::MotionRun(const Motion& motion, const Method& method, const Setting& setting)
    : count_(method.divides ? 1 : setting.substeps), h_(method.divides ? Setting{}.dt() : setting.dt()) {
  motion.begin(begin_);
  player_ = method.begin(begin_, setting);
}

Places MotionRun::places() const {
  Places places;
  for (Body body : begin_.bodies) {
    if (body.movable()) player_->get(body);
    places.emplace_back(body.position.cast<double>());
  }
  return places;
}

Measured play(const Motion& motion, const std::vector<Places>& truth, const Method& method, const Setting& setting,
              const Patience& patience) {
  const Playing once(motion, method, setting, patience.at_most);
  Measured played = not_played(method, setting);
  if (!once.lost && !once.late) played.error = largest_error(once.places, truth);
  played.late = once.late;
  played.row_solves = once.row_solves;
  played.seconds = {once.seconds};
  if (once.late || once.seconds >= patience.at_least) return played;
  std::vector<double> times;
  for (double spent = 0; spent < patience.at_least && times.size() < 1000; spent += times.back())
    times.push_back(seconds_of(motion, method, setting));
  played.seconds = {median(times)};
  return played;
}

namespace {

struct Asked {
  const Method* method;
  Setting setting;
};

int number_in(const std::string& text, const std::string& asked, int most) {
  int number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc() || end != text.data() + text.size() || number < 1 || number > most)
    throw InvalidInput(fmt::format("'{}' in '{}': a whole number from 1 to {} is needed", text, asked, most));
  return number;
}

Asked read(const std::string& asked, const Motion& motion, const std::vector<Method>& methods) {
  std::vector<std::string> words;
  std::istringstream parts(asked);
  for (std::string word; std::getline(parts, word, '/');) words.push_back(word);
  if (words.empty()) words.emplace_back();
  std::vector<std::string> names;
  for (const Method& method : methods) {
    if (!method.plays(motion)) continue;
    names.push_back(method.name);
    if (words[0] != method.name) continue;
    const std::size_t numbers = method.sweeps ? 2 : 1;
    if (words.size() != 1 + numbers)
      throw InvalidInput(
          fmt::format("'{}': {}/SMALL-STEPS{} is needed", asked, method.name, method.sweeps ? "/SWEEPS" : ""));
    Asked read{&method, {.substeps = number_in(words[1], asked, 1 << 16)}};
    if (method.sweeps) read.setting.sweeps = number_in(words[2], asked, 1 << 20);
    return read;
  }
  if (names.empty()) throw InvalidInput(fmt::format("method is '{}': none plays {}", words[0], motion.name));
  throw InvalidInput(fmt::format("method is '{}': one of {} plays {}", words[0], fmt::join(names, ", "), motion.name));
}

}  // namespace

int play_program(int argc, const char* const* argv, const std::string& about, const std::string& version,
                 const std::vector<Method>& methods) {
  CommandLine line(about);
  line.version(version, "Which engine plays, of which version, built how");
  std::string motion_name;
  std::vector<std::string> settings;
  Patience patience;
  line.option("motion", motion_name, "The motion to play; without it, list the motions");
  line.option("settings", settings, "METHOD/SMALL-STEPS/SWEEPS ...; without them, list the motion's methods");
  line.option("--at-least", patience.at_least,
              "Shortest total time for which each setting is played again and again, s")
      .between(0.0, 60.0)
      .shows_default();
  line.option("--at-most", patience.at_most, "Time after which a setting is given up, s")
      .between(0.0, 3600.0)
      .shows_default();
  return line.run(argc, argv, [&] {
    require_between("--at-least", static_cast<Real>(patience.at_least), 0, 60);  // the ranges above let nan pass
    require_between("--at-most", static_cast<Real>(patience.at_most), 0, 3600);
    if (motion_name.empty()) {
      for (const Motion& motion : every_motion()) fmt::print("{}: {}\n", motion.name, motion.title);
      return;
    }
    const Motion& motion = any_motion_named(motion_name);
    if (settings.empty()) {
      for (const Method& method : methods)
        if (method.plays(motion))
          fmt::print("{}/SMALL-STEPS{}: {}\n", method.name, method.sweeps ? "/SWEEPS" : "", method.title);
      return;
    }
    std::vector<Asked> all;
    for (const std::string& setting : settings) all.push_back(read(setting, motion, methods));
    const std::vector<Places> truth = motion.truth(motion.frames());  // once: of the chain it takes half a second
    study::Measurements late;
    for (const Asked& asked : all) {
      Measured one = not_played(*asked.method, asked.setting);
      const auto asks_for_more = [&](const Measured& before) { return study::is_as_fine(one, before); };
      if (std::none_of(late.begin(), late.end(), asks_for_more))
        one = play(motion, truth, *asked.method, asked.setting, patience);
      if (one.late) late.push_back(one);
      fmt::print("{}\n", study::line_of(one));
      std::fflush(stdout);
    }
  });
}

}  // namespace pushback

namespace pushback::study {

namespace {

constexpr const char* no_measure = "–";

double not_negative(const std::string& word) {
  const double number = csv_number<double>(word);
  if (!(number >= 0)) throw InvalidInput(fmt::format("there is '{}' where a number from 0 on is needed", word));
  return number;
}

}  // namespace

std::string error_text(const Measured& one) {
  return one.late ? "late" : std::isfinite(one.error) ? fmt::format("{:.4e}", one.error) : "lost";
}

std::string row_solves_text(const Measured& one) {
  return one.row_solves ? fmt::format("{:.4e}", *one.row_solves) : no_measure;
}

void read_error(const std::string& word, Measured& into) {
  into.late = word == "late";
  into.error = into.late || word == "lost" ? std::numeric_limits<double>::infinity() : not_negative(word);
}

void read_row_solves(const std::string& word, Measured& into) {
  into.row_solves.reset();
  if (word != no_measure) into.row_solves = not_negative(word);
}

std::string line_of(const Measured& once) {
  return fmt::format("{} error {} seconds {:.4e} row-solves {}", once.setting(), error_text(once), once.median(),
                     row_solves_text(once));
}

void add_line(const std::string& line, Measured& into) {
  try {
    std::istringstream in(line);
    std::string setting, word, error, time, row_solves;
    in >> setting >> word >> error >> word >> time >> word >> row_solves;
    if (setting != into.setting()) throw InvalidInput(fmt::format("there is '{}'", setting));
    read_error(error, into);
    read_row_solves(row_solves, into);
    const double seconds = not_negative(time);
    if (std::isfinite(into.error) && seconds == 0) throw InvalidInput("it has taken no time");
    into.seconds.insert(std::upper_bound(into.seconds.begin(), into.seconds.end(), seconds), seconds);
  } catch (const InvalidInput& problem) {
    throw std::runtime_error(
        fmt::format("{} printed no measurement of {}: '{}': {}", into.engine, into.setting(), line, problem.what()));
  }
}

}  // namespace pushback::study
