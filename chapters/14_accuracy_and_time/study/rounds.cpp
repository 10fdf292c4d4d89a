#include "chapters/14_accuracy_and_time/study/rounds.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <sstream>
#include <stdexcept>

namespace pushback {

namespace {

constexpr double slack = 2;  // times as slow as the front, and still timed again

std::vector<std::string> lines_of(const std::string& command) {
  std::FILE* pipe = popen(command.c_str(), "r");
  if (pipe == nullptr) throw std::runtime_error(fmt::format("'{}' could not be started", command));
  std::string text;
  for (int c = std::fgetc(pipe); c != EOF; c = std::fgetc(pipe)) text += static_cast<char>(c);
  if (pclose(pipe) != 0) throw std::runtime_error(fmt::format("'{}' failed", command));
  std::vector<std::string> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

using Indices = std::vector<std::size_t>;

class Asking {
 public:
  Asking(const Motion& motion, const RoundOptions& options) : motion_(motion), options_(options) {}

  /// Everything that the engine offers, on the grid.
  Measurements grid(const std::string& engine) const {
    Measurements all;
    for (const std::string& line : lines_of(command(engine))) {
      const std::string method = line.substr(0, line.find_first_of("/:"));
      const bool sweeps = line.find("/SWEEPS") < line.find(':');
      for (int small_steps = 1; small_steps <= most_small_steps(); small_steps *= options_.quick ? 4 : 2) {
        for (int n = 1; n <= motion_.most_sweeps && n * small_steps <= most_passes(); n *= 4) {
          all.push_back({.engine = engine, .method = method, .small_steps = small_steps, .sweeps = sweeps ? n : 0});
          if (!sweeps) break;
        }
      }
    }
    return all;
  }
  /// Plays those with these indices once more.
  void play(Measurements& all, const Indices& which) const {
    for (std::size_t first = 0; first < which.size();) {  // those of one engine in one call
      const std::string engine = all[which[first]].engine;
      std::string settings;
      std::size_t last = first;
      for (; last < which.size() && all[which[last]].engine == engine; ++last)
        settings += fmt::format(" {}", all[which[last]].setting());
      const std::vector<std::string> lines = lines_of(command(engine) + settings + patience());
      if (lines.size() != last - first)
        throw std::runtime_error(
            fmt::format("{} printed {} lines for {} settings", engine, lines.size(), last - first));
      for (std::size_t i = first; i < last; ++i) read(lines[i - first], all[which[i]]);
      first = last;
    }
  }

 private:
  int most_small_steps() const {
    return options_.quick ? std::min(64, motion_.most_small_steps) : motion_.most_small_steps;
  }
  int most_passes() const { return options_.quick ? std::max(1, motion_.most_passes / 8) : motion_.most_passes; }
  std::string patience() const { return options_.quick ? " --at-least 0 --at-most 0.15" : " --at-most 10"; }
  std::string command(const std::string& engine) const {
    return fmt::format("'{}' {}", (options_.programs / engine).string(), motion_.name);
  }
  static void read(const std::string& line, Measured& into) {
    std::istringstream in(line);
    std::string setting, word, error;
    double seconds = 0;
    in >> setting >> word >> error >> word >> seconds >> word >> into.row_solves;
    into.late = error == "late";
    into.error = std::numeric_limits<double>::infinity();
    const bool known = !into.late && error != "lost";
    const auto end = error.data() + error.size();
    if (!in || setting != into.setting() || !(seconds > 0) ||
        (known && (std::from_chars(error.data(), end, into.error).ptr != end || !(into.error >= 0))))
      throw std::runtime_error(fmt::format("{} printed no measurement of {}: '{}'", into.engine, into.setting(), line));
    into.seconds.insert(std::upper_bound(into.seconds.begin(), into.seconds.end(), seconds), seconds);
  }

  const Motion& motion_;
  const RoundOptions& options_;
};

/// From `first` on.
Indices indices_of_those_near_front(const Measurements& all, std::size_t first) {
  const Measurements latest(all.begin() + static_cast<std::ptrdiff_t>(first), all.end());
  Indices found;
  for (std::size_t i = 0; i < latest.size(); ++i)
    if (is_near_front(latest[i], latest, slack)) found.push_back(first + i);
  return found;
}

}  // namespace

std::vector<Engine> engines_in(const std::filesystem::path& programs, bool others) {
  std::vector<Engine> found{{"motion", "ours, double"}, {"motion_float", "ours, float"}};
  if (!others) return found;
  for (const Engine& engine : std::vector<Engine>{{"motion_bullet", "Bullet, float"},
                                                  {"motion_bullet_double", "Bullet, double"},
                                                  {"motion_ode", "ODE, double"},
                                                  {"motion_mujoco", "MuJoCo, double"}})
    if (std::filesystem::exists(programs / engine.program)) found.push_back(engine);
  if (found.size() == 2)
    throw std::runtime_error("no other engine's program is there: configure with -DPUSHBACK_PEERS=ON");
  return found;
}

Measurements measure(const Motion& motion, const RoundOptions& options) {
  const Asking asking(motion, options);
  Measurements all;
  Indices near;
  for (const Engine& engine : options.engines) {
    options.say(fmt::format("{}: {}", motion.name, engine.title));
    const std::size_t first = all.size();
    if (engine.program == "motion_float") {
      for (const std::size_t i : near) {
        Measured one = all[i];
        one.engine = engine.program;
        one.seconds.clear();
        all.push_back(one);
      }
    } else {
      const Measurements grid = asking.grid(engine.program);
      all.insert(all.end(), grid.begin(), grid.end());
    }
    Indices latest;
    for (std::size_t i = first; i < all.size(); ++i) latest.push_back(i);
    asking.play(all, latest);
    latest = indices_of_those_near_front(all, first);
    near.insert(near.end(), latest.begin(), latest.end());
  }
  for (int round = 1; round <= options.rounds; ++round) {
    options.say(
        fmt::format("{}: round {} of {}, {} settings near a front", motion.name, round, options.rounds, near.size()));
    asking.play(all, near);
  }
  return all;
}

std::string csv_of(const std::map<std::string, Measurements>& by_motion) {
  std::string text = "motion,engine,method,small_steps,sweeps,error_m,seconds,quartile1,quartile3,rounds,row_solves\n";
  for (const auto& [motion, all] : by_motion)
    for (const Measured& one : all)
      text += fmt::format("{},{},{},{},{},{},{:.4e},{:.4e},{:.4e},{},{:.4e}\n", motion, one.engine, one.method,
                          one.small_steps, one.sweeps,
                          one.late                   ? "late"
                          : std::isfinite(one.error) ? fmt::format("{:.4e}", one.error)
                                                     : "lost",
                          one.median(), one.quartile(1), one.quartile(3), one.seconds.size(), one.row_solves);
  return text;
}

}  // namespace pushback
