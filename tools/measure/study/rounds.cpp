#include "pushback/tools/measure/study/rounds.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <sstream>
#include <stdexcept>
#include <utility>

#include "pushback/common/basics/input.h"
#include "pushback/common/basics/process.h"
#include "pushback/tools/measure/results/csv.h"
#include "pushback/tools/measure/study/choice.h"
#include "pushback/tools/measure/study/play.h"

namespace pushback::study {

namespace {

constexpr double slack = 1.25;  // times as slow as the front, and still timed again
constexpr int few_rounds = 3, enough_rounds = 10, most_rounds = 20;
constexpr double close_enough = 1.1;  // between the quartiles of a time: those of a ratio are then within a tenth of it

/// Nothing where the program crashed.
std::optional<std::vector<std::string>> said_or_crashed(const std::vector<std::string>& command) {
  const Ended ended = run_program(command);
  if (ended.signal != 0) return {};
  if (ended.status != 0) throw std::runtime_error(fmt::format("'{}' failed: {}", fmt::join(command, " "), ended.err));
  return lines_of(ended.out);
}

std::vector<std::string> said_by(const std::vector<std::string>& command) {
  auto said = said_or_crashed(command);
  if (!said) throw std::runtime_error(fmt::format("'{}' failed: it crashed", fmt::join(command, " ")));
  return *std::move(said);
}

using Indices = std::vector<std::size_t>;

class Asking {
 public:
  Asking(const Motion& motion, const RoundOptions& options) : motion_(motion), options_(options) {}

  /// Everything that the engine offers, on the grid.
  Measurements grid(const std::string& engine) const {
    Measurements all;
    for (const std::string& line : said_by(command(engine))) {
      const std::string method = line.substr(0, line.find_first_of("/:"));
      if (!is_asked_for(method)) continue;
      const bool sweeps = line.find("/SWEEPS") < line.find(':');
      for (int substeps = 1; substeps <= most_substeps(); substeps *= options_.quick ? 4 : 2) {
        for (int n = 1; n <= motion_.most_sweeps && n * substeps <= most_passes(); n *= 4) {
          all.push_back({.engine = engine, .method = method, .substeps = substeps, .sweeps = sweeps ? n : 0});
          if (!sweeps) break;
        }
      }
    }
    return all;
  }
  /// Plays those with these indices once more. Where the engine crashes, each is played by itself: what crashes alone is lost.
  void play(Measurements& all, const Indices& which) const {
    for (std::size_t first = 0; first < which.size();) {  // those of one engine in one call
      const std::string engine = all[which[first]].engine;
      std::vector<std::string> asked = command(engine);
      std::size_t last = first;
      for (; last < which.size() && all[which[last]].engine == engine; ++last)
        asked.push_back(all[which[last]].setting());
      for (const std::string& word : patience()) asked.push_back(word);
      const auto lines = said_or_crashed(asked);
      if (lines && lines->size() != last - first)
        throw std::runtime_error(
            fmt::format("{} printed {} lines for {} settings", engine, lines->size(), last - first));
      for (std::size_t i = first; i < last; ++i) {
        if (lines) add_line((*lines)[i - first], all[which[i]]);
        else if (last - first > 1) play(all, {which[i]});
        else lose(all[which[i]]);
      }
      first = last;
    }
  }

 private:
  bool is_asked_for(const std::string& method) const {
    const std::vector<std::string>& only = options_.methods;
    return only.empty() || std::find(only.begin(), only.end(), method) != only.end();
  }
  int most_substeps() const { return options_.quick ? std::min(64, motion_.most_substeps) : motion_.most_substeps; }
  int most_passes() const { return options_.quick ? std::max(1, motion_.most_passes / 8) : motion_.most_passes; }
  std::vector<std::string> command(const std::string& engine) const {
    return {(options_.programs / engine).string(), motion_.name};
  }
  std::vector<std::string> patience() const {
    if (options_.quick) return {"--at-least", "0", "--at-most", "0.15"};
    return {"--at-most", "10"};
  }
  void lose(Measured& one) const {
    options_.say(fmt::format("{}: {} crashed, by {}", motion_.name, one.engine, one.setting()));
    add_line(fmt::format("{} error lost seconds 0 row-solves –", one.setting()), one);  // how long it took nobody knows
  }

  const Motion& motion_;
  const RoundOptions& options_;
};

bool is_near(const Measured& one, const Measurements& its) {
  return is_near_front(one, its, slack);
}
/// Whether it may be the cheapest for an error of the tables, or for one close to it.
bool may_decide(const Measured& one, const Measurements& its) {
  for (const Tolerance& tolerance : all_tolerances)
    for (const double error : {0.8 * tolerance.error, tolerance.error, 1.25 * tolerance.error})
      if (one.error <= error && one.median() <= 1.1 * cheapest(its, error)->median()) return true;
  return false;
}

/// Those of which this is so among all of their engine; or of their method, if it is one that `Recommended` is made of. By robust errors.
Indices kept(const Measurements& all, Indices which, bool (*is_kept)(const Measured&, const Measurements&)) {
  const Measurements latest = robust(all);
  std::erase_if(which, [&](std::size_t i) {
    const Measured& one = latest[i];
    const Measurements its = of_engine(latest, one.engine);
    return !is_kept(one, its) &&
           !((one.method == "by-island" || one.method == "within") && is_kept(one, of_method(its, one.method)));
  });
  return which;
}

/// Times these settings, all of them in every round before the next begins: three rounds, then further rounds for those that may
/// decide a table, until their times are known.
void play_rounds(const Asking& asking, const Motion& motion, const RoundOptions& options, Measurements& all,
                 Indices which) {
  for (int round = 1; round <= (options.quick ? 1 : most_rounds) && !which.empty(); ++round) {
    options.say(fmt::format("{}: round {}, {} settings near a front", motion.name, round, which.size()));
    asking.play(all, which);
    if (round < few_rounds) continue;
    which = kept(all, which, may_decide);
    if (round < enough_rounds) continue;
    std::erase_if(which, [&](std::size_t i) { return all[i].quartile(3) <= close_enough * all[i].quartile(1); });
  }
}

}  // namespace

const std::vector<Engine>& known_engines() {
  static const std::vector<Engine> engines{{"motion", "ours, double", ours, 0},
                                           {"motion_float", "ours, float", ours, 0, true},
                                           {"motion_wide", "ours, 21 to 27", ours, 6},
                                           {"motion_bullet", "Bullet, float", "Bullet", 1, true},
                                           {"motion_bullet_double", "Bullet, double", "Bullet", 1},
                                           {"motion_ode", "ODE, double", "ODE", 2},
                                           {"motion_mujoco", "MuJoCo, double", "MuJoCo", 3},
                                           {"motion_box3d", "Box3D, float", "Box3D", 4},
                                           {"motion_jolt", "Jolt, float", "Jolt", 5},
                                           {"motion_methods", "other methods", "", 1},
                                           {"motion_mine", "mine", "mine", 7},
                                           {"motion_adapter", "entered", "entered", 7}};
  return engines;
}

std::vector<Engine> engines_named(const std::vector<std::string>& programs) {
  std::vector<Engine> found;
  for (const std::string& program : programs) found.push_back(named("engine", known_engines(), program));
  return found;
}

std::vector<Engine> engines_in(const std::filesystem::path& programs, bool others) {
  std::vector<Engine> found = engines_named({"motion", "motion_float", "motion_wide"});
  if (!others) return found;
  const std::size_t own = found.size();
  for (const Engine& engine : engines_named(
           {"motion_bullet", "motion_bullet_double", "motion_ode", "motion_mujoco", "motion_box3d", "motion_jolt"}))
    if (std::filesystem::exists(programs / engine.name)) found.push_back(engine);
  if (found.size() == own)
    throw std::runtime_error("no other engine's program is there: configure with -DPUSHBACK_PEERS=ON");
  return found;
}

std::vector<Engine> engines_of(const AllMeasured& all) {
  std::set<std::string> measured;
  for (const auto& [motion, of_motion] : all)
    for (const Measured& one : of_motion) measured.insert(one.engine);
  std::vector<Engine> found = known_engines();
  std::erase_if(found, [&](const Engine& engine) { return !measured.contains(engine.name); });
  return found;
}

std::string version_of(const Engine& engine, const std::filesystem::path& programs) {
  const auto lines = said_by({(programs / engine.name).string(), "--version"});
  if (lines.size() != 1) throw std::runtime_error(fmt::format("{} does not say its version", engine.name));
  return lines[0];
}

Measurements measure(const Motion& motion, const RoundOptions& options) {
  const Asking asking(motion, options);
  Measurements all;
  Indices near;
  for (const Engine& engine : options.engines) {
    options.say(fmt::format("{}: {}", motion.name, engine.title));
    const std::size_t first = all.size();
    if (engine.name == "motion_float") {
      for (const std::size_t i : near) {
        Measured one = all[i];
        one.engine = engine.name;
        one.seconds.clear();
        all.push_back(one);
      }
    } else {
      const Measurements grid = asking.grid(engine.name);
      all.insert(all.end(), grid.begin(), grid.end());
    }
    Indices latest;
    for (std::size_t i = first; i < all.size(); ++i) latest.push_back(i);
    asking.play(all, latest);
    latest = kept(all, latest, is_near);
    near.insert(near.end(), latest.begin(), latest.end());
  }
  play_rounds(asking, motion, options, all, near);
  return all;
}

std::size_t measure_again(const std::string& word, const Motion& motion, const RoundOptions& options,
                          Measurements& all) {
  const auto is_of_engine = [&](const Measured& one) { return one.engine == word; };
  const std::vector<Engine> engines = known_engines();
  const bool engine = std::ranges::any_of(engines, [&](const Engine& one) { return one.name == word; });
  if (engine && word != "motion_float") {  // float has no grid of its own
    std::erase_if(all, is_of_engine);
    RoundOptions only = options;
    only.engines = engines_named({word});
    const Measurements found = measure(motion, only);
    all.insert(all.end(), found.begin(), found.end());
    return found.size();
  }
  const Asking asking(motion, options);
  Indices which;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (all[i].method != word && !is_of_engine(all[i])) continue;
    which.push_back(i);
    all[i].seconds.clear();
  }
  options.say(fmt::format("{}: {} settings", motion.name, which.size()));
  asking.play(all, which);
  play_rounds(asking, motion, options, all, kept(all, which, is_near));
  return which.size();
}

namespace {

constexpr const char* csv_heading =
    "motion,engine,method,substeps,sweeps,error_m,row_solves,median_s,quartile1_s,quartile3_s,all_s";

}  // namespace

std::string csv_of(const AllMeasured& all) {
  std::string text = fmt::format("{}\n", csv_heading);
  for (const auto& [motion, measured] : all)
    for (const Measured& one : measured)
      text += fmt::format("{},{},{},{},{},{},{},{:.4e},{:.4e},{:.4e},{:.4e}\n", motion, one.engine, one.method,
                          one.substeps, one.sweeps, error_text(one), row_solves_text(one), one.median(),
                          one.quartile(1), one.quartile(3), fmt::join(one.seconds, " "));
  return text;
}

AllMeasured read_csv(const std::string& text) {
  AllMeasured all;
  read_csv_lines(text, csv_heading, [&](const std::vector<std::string>& fields) {
    Measured one{.engine = fields[1],
                 .method = fields[2],
                 .substeps = csv_number<int>(fields[3]),
                 .sweeps = csv_number<int>(fields[4])};
    read_error(fields[5], one);
    read_row_solves(fields[6], one);
    for (const std::size_t of_all : {7, 8, 9}) csv_number<double>(fields[of_all]);  // for who draws by other means
    std::istringstream times(fields[10]);
    for (std::string time; times >> time;) one.seconds.push_back(csv_number<double>(time));
    if (one.seconds.empty()) throw InvalidInput("a time is needed");
    std::sort(one.seconds.begin(), one.seconds.end());
    all[fields[0]].push_back(one);
  });
  return all;
}

}  // namespace pushback::study
