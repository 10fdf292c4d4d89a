/// ./course run prices: what the three presets cost, and by how much they are off, beside the engines that were built. All of it is in
/// prices.csv, from which prices.md is made.
#include <cmath>
#include <filesystem>

#include "pushback/common/basics/files.h"
#include "pushback/common/basics/process.h"
#include "pushback/common/experiment/program.h"
#include "pushback/engine/presets.h"
#include "pushback/tools/measure/results/machine.h"
#include "pushback/tools/measure/results/markdown.h"
#include "pushback/tools/measure/study/choice.h"
#include "pushback/tools/measure/study/every_motion.h"
#include "pushback/tools/measure/study/ours.h"

using namespace pushback;
using study::Measured;
namespace fs = std::filesystem;

namespace {

struct Contender {
  std::string title;
  Measured setting;
  /// Once. Nothing where an engine has no way to play the motion.
  std::function<std::optional<Measured>(const Motion&, const std::vector<Places>& truth)> play;
};

template <class Preset>
Contender of_preset(const std::string& title, const std::string& name) {
  const Preset preset;
  const Method method{.name = name, .title = title, .begin = by_ours(preset), .sweeps = false, .divides = true};
  const Setting setting{.sweeps = preset.plan(Real(1) / frames_per_second).sweeps};
  return {title,
          {.engine = "presets", .method = name},
          [method, setting](const Motion& motion, const std::vector<Places>& truth) {
            Measured played = play(motion, truth, method, setting, {.at_least = 0, .at_most = 3600});
            played.engine = "presets";
            return std::optional(played);
          }};
}

struct WithinATenth : Recommended {  // of a millimetre
  WithinATenth() { error = Real(1e-4); }
};

/// One of the programs that play motions by other engines, in a setting of its.
Contender of_program(const std::string& title, const fs::path& programs, const Measured& setting) {
  const fs::path program = programs / setting.engine;
  return {title, setting, [program, setting](const Motion& motion, const auto&) -> std::optional<Measured> {
            const Ended methods = run_program({program.string(), motion.name});
            if (methods.out.find(setting.method + "/") == std::string::npos) return {};
            const Ended ended = run_program({program.string(), motion.name, setting.setting(), "--at-least", "0"});
            if (ended.status != 0)
              throw InvalidInput(fmt::format("{} cannot play {}: {}", setting.setting(), motion.name, ended.err));
            Measured played = setting;
            study::add_line(lines_of(ended.out).at(0), played);
            return played;
          }};
}

std::vector<Contender> contenders(const fs::path& programs) {
  std::vector<Contender> all{of_preset<Fast>("Fast", "fast"), of_preset<Recommended>("Recommended", "recommended"),
                             of_preset<WithinATenth>("Recommended, 0.1 mm asked", "recommended-0.1-mm"),
                             of_preset<Exact>("Exact", "exact")};
  const std::vector<std::pair<const char*, Measured>> others{{"Bullet", {"motion_bullet", "bullet", 1, 10}},
                                                             {"ODE", {"motion_ode", "ode", 1, 20}},
                                                             {"MuJoCo", {"motion_mujoco", "mujoco-default", 1}},
                                                             {"Box3D", {"motion_box3d", "box3d", 4}},
                                                             {"Jolt", {"motion_jolt", "jolt", 1}}};
  for (const auto& [title, setting] : others) all.push_back(of_program(title, programs, setting));
  return all;
}

bool is_here(const Measured& setting, const fs::path& programs) {
  return setting.engine == "presets" || fs::exists(programs / setting.engine);
}

/// All that are here, in turn, so many rounds. Of the others, what was measured before stays.
void measure(const Motion& motion, std::vector<Contender> all, const fs::path& programs, int rounds,
             study::Measurements& row) {
  std::erase_if(all, [&](const Contender& one) { return !is_here(one.setting, programs); });
  std::erase_if(row, [&](const Measured& one) { return is_here(one, programs); });
  const std::vector<Places> truth = motion.truth(motion.frames());
  std::vector<std::optional<Measured>> found(all.size());
  for (int round = 0; round < rounds; ++round)
    for (std::size_t i = 0; i < all.size(); ++i) {
      const auto once = all[i].play(motion, truth);
      if (round == 0) found[i] = once;
      else if (once) found[i]->seconds.push_back(once->median());
    }
  for (const auto& one : found)
    if (one) row.push_back(*one);
}

/// Error in mm and us a step, in two digits or whole numbers.
std::string said(const Motion& motion, const Measured& one) {
  const double mm = 1000 * one.error, us = study::per_frame(motion, one.median());
  const std::string off = std::isinf(mm) ? "lost" : mm < 1e-6 ? "< 1e-6" : study::plain(mm, 2);
  return us > 0 ? fmt::format("{}; {}", off, study::plain(us, 2))
                : off;  // what is lost before it has moved has taken no time
}

std::string table_of(const study::AllMeasured& all, const std::vector<Contender>& columns) {
  std::vector<std::string> heads{"error in mm; µs a step"};
  for (const Contender& one : columns) heads.push_back(one.title);
  std::string table = markdown_heads(heads);
  for (const Motion& motion : every_motion()) {
    const auto row = all.find(motion.name);
    if (row == all.end()) continue;
    std::vector<std::string> cells{motion.title};
    for (const Contender& column : columns) {
      const auto found = std::ranges::find_if(row->second, [&](const Measured& one) {
        return one.engine == column.setting.engine && one.setting() == column.setting.setting();
      });
      cells.push_back(found == row->second.end() ? "–" : said(motion, *found));
    }
    table += markdown_row(cells);
  }
  return table;
}

}  // namespace

int main(int argc, char** argv) {
  CommandLine line(
      "Error and time of the presets Fast, Recommended, also with 0.1 mm asked, and Exact; and of other engines as "
      "they come.");
  int rounds = 10;
  bool redraw = false;
  std::vector<std::string> renew;
  std::string out = "renders/here";
  line.option("--rounds", rounds, "How often each engine plays, in turn; times are medians")
      .between(1, 1000)
      .shows_default();
  line.option("--renew", renew,
              "Measure these motions with the engines that are built, and keep the rest of prices.csv");
  line.flag("--redraw", redraw, "Measure nothing, and make the table from prices.csv");
  line.option("--out", out, "The folder to write to").shows_default();
  return line.run(argc, argv, [&] {
    const fs::path folder = fs::path(out) / "26_to_each_its_own", file = folder / "prices.csv";
    const fs::path programs = fs::canonical("/proc/self/exe").parent_path();
    const std::vector<Contender> all = contenders(programs);
    std::vector<Motion> motions;
    for (const std::string& name : renew) motions.push_back(any_motion_named(name));
    study::AllMeasured prices;
    if (redraw || !renew.empty()) prices = study::read_csv(read_text_file(file));
    else motions = every_motion();
    make_writable_folder(folder);
    const std::string load = load_now();
    for (const Motion& motion : motions) {
      measure(motion, all, programs, rounds, prices[motion.name]);
      write_text_file(file, study::csv_of(prices));
    }
    write_text_file(folder / "prices.md", table_of(prices, all));
    fmt::print("{}\nLoad of the machine before and after: {} and {}.\n", table_of(prices, all), load, load_now());
  });
}
