#include "chapters/14_accuracy_and_time/rounds.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <cstdio>
#include <memory>
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

class Asking {
 public:
  Asking(const Motion& motion, const RoundOptions& options) : motion_(motion), options_(options) {}

  /// Everything that the engine offers, on the grid.
  Measurements grid(const std::string& engine) const {
    Measurements all;
    for (const std::string& line : lines_of(command(engine))) {
      const std::string method = line.substr(0, line.find_first_of("/:"));
      const bool sweeps = line.find("/SWEEPS") < line.find(':');
      for (int small_steps = 1; small_steps <= motion_.most_small_steps; small_steps *= options_.quick ? 4 : 2) {
        for (int n = 1; n <= motion_.most_sweeps && n * small_steps <= most_passes(); n *= 4) {
          all.push_back({.engine = engine, .method = method, .small_steps = small_steps, .sweeps = sweeps ? n : 0});
          if (!sweeps) break;
        }
      }
    }
    return all;
  }
  /// Plays all of them once more.
  void play(Measurements& all) const {
    for (std::size_t first = 0; first < all.size();) {  // those of one engine in one call
      std::string settings;
      std::size_t last = first;
      for (; last < all.size() && all[last].engine == all[first].engine; ++last)
        settings += fmt::format(" {}", all[last].setting());
      const std::vector<std::string> lines = lines_of(command(all[first].engine) + settings + patience());
      if (lines.size() != last - first)
        throw std::runtime_error(
            fmt::format("{} printed {} lines for {} settings", all[first].engine, lines.size(), last - first));
      for (std::size_t i = first; i < last; ++i) read(lines[i - first], all[i]);
      first = last;
    }
  }

 private:
  int most_passes() const { return options_.quick ? std::max(1, motion_.most_passes / 8) : motion_.most_passes; }
  std::string patience() const { return options_.quick ? " --at-least 0.002 --at-most 0.4" : " --at-most 10"; }
  std::string command(const std::string& engine) const {
    return fmt::format("'{}' {}", (options_.programs / engine).string(), motion_.name);
  }
  static void read(const std::string& line, Measured& into) {
    std::istringstream in(line);
    std::string setting, word, error;
    double seconds = 0;
    in >> setting >> word >> error >> word >> seconds >> word >> into.row_solves;
    if (!in || setting != into.setting()) throw std::runtime_error(fmt::format("not a measurement: {}", line));
    into.error = error == "lost" || error == "late" ? std::numeric_limits<double>::infinity() : std::stod(error);
    into.seconds.insert(std::upper_bound(into.seconds.begin(), into.seconds.end(), seconds), seconds);
  }

  const Motion& motion_;
  const RoundOptions& options_;
};

/// Moves those of `all` that are near a front of their engine to `near`.
void pick(Measurements& all, Measurements& near) {
  near = near_front(all, slack);
  std::erase_if(all, [&](const Measured& one) {
    return std::any_of(near.begin(), near.end(),
                       [&](const Measured& other) { return other.setting() == one.setting(); });
  });
}

}  // namespace

std::vector<Engine> engines_in(const std::filesystem::path& programs) {
  std::vector<Engine> found;
  for (const Engine& engine : std::vector<Engine>{{"motion", "ours, double"},
                                                  {"motion_float", "ours, float"},
                                                  {"motion_bullet", "Bullet, float"},
                                                  {"motion_ode", "ODE, double"},
                                                  {"motion_mujoco", "MuJoCo, double"}})
    if (std::filesystem::exists(programs / engine.program)) found.push_back(engine);
  return found;
}

Measurements measure(const Motion& motion, const RoundOptions& options) {
  const Asking asking(motion, options);
  Measurements all, near;
  for (const Engine& engine : engines_in(options.programs)) {
    options.say(fmt::format("{}: {}", motion.name, engine.title));
    Measurements of_engine;
    if (engine.program == "motion_float") {
      for (Measured one : near) {
        one.engine = engine.program;
        one.seconds.clear();
        of_engine.push_back(one);
      }
    } else {
      of_engine = asking.grid(engine.program);
    }
    asking.play(of_engine);
    Measurements of_engine_near;
    pick(of_engine, of_engine_near);
    near.insert(near.end(), of_engine_near.begin(), of_engine_near.end());
    all.insert(all.end(), of_engine.begin(), of_engine.end());
  }
  for (int round = 1; round <= options.rounds; ++round) {
    options.say(
        fmt::format("{}: round {} of {}, {} settings near a front", motion.name, round, options.rounds, near.size()));
    asking.play(near);
  }
  all.insert(all.end(), near.begin(), near.end());
  return all;
}

std::string csv_of(const std::map<std::string, Measurements>& by_motion) {
  std::string text = "motion,engine,method,small_steps,sweeps,error_m,seconds,quartile1,quartile3,rounds,row_solves\n";
  for (const auto& [motion, all] : by_motion)
    for (const Measured& one : all)
      text +=
          fmt::format("{},{},{},{},{},{},{:.4e},{:.4e},{:.4e},{},{:.4e}\n", motion, one.engine, one.method,
                      one.small_steps, one.sweeps, std::isfinite(one.error) ? fmt::format("{:.4e}", one.error) : "lost",
                      one.median(), one.quartile(1), one.quartile(3), one.seconds.size(), one.row_solves);
  return text;
}

}  // namespace pushback
