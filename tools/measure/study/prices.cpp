/// ./course run prices: what the three presets cost, and by how much they are off, beside the engines that were built.
#include <array>
#include <cmath>
#include <filesystem>

#include "pushback/common/basics/files.h"
#include "pushback/common/basics/process.h"
#include "pushback/common/basics/quantile.h"
#include "pushback/common/experiment/program.h"
#include "pushback/engine/presets.h"
#include "pushback/tools/measure/results/markdown.h"
#include "pushback/tools/measure/results/origin.h"
#include "pushback/tools/measure/study/every_motion.h"
#include "pushback/tools/measure/study/ours.h"

using namespace pushback;
using study::Measured;
namespace fs = std::filesystem;

namespace {

struct Contender {
  std::string title;
  /// Once. Nothing where an engine has no way to play the motion.
  std::function<std::optional<Measured>(const Motion&, const std::vector<Places>& truth)> play;
};

template <class Preset>
Contender of_preset(const std::string& title) {
  const Preset preset;
  const Method method{.name = title, .title = title, .begin = by_ours(preset), .divides = true};
  const Setting setting{.sweeps = preset.plan(Real(1) / frames_per_second).sweeps};
  return {title, [method, setting](const Motion& motion, const std::vector<Places>& truth) {
            return std::optional(play(motion, truth, method, setting, {.at_least = 0, .at_most = 3600}));
          }};
}

struct WithinATenth : Recommended {  // of a millimetre
  WithinATenth() { error = Real(1e-4); }
};

/// One of the programs that play motions by other engines, in a setting of its.
Contender of_program(const std::string& title, const fs::path& program, const Measured& setting) {
  return {title, [program, setting](const Motion& motion, const std::vector<Places>&) -> std::optional<Measured> {
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
  std::vector<Contender> all{of_preset<Fast>("Fast"), of_preset<Recommended>("Recommended"),
                             of_preset<WithinATenth>("Recommended, 0.1 mm asked"), of_preset<Exact>("Exact")};
  const std::vector<std::pair<const char*, Measured>> others{{"Bullet", {"motion_bullet", "bullet", 1, 10}},
                                                             {"ODE", {"motion_ode", "ode", 1, 20}},
                                                             {"MuJoCo", {"motion_mujoco", "mujoco-default", 1}},
                                                             {"Box3D", {"motion_box3d", "box3d", 4}},
                                                             {"Jolt", {"motion_jolt", "jolt", 1}}};
  for (const auto& [title, setting] : others)
    if (fs::exists(programs / setting.engine)) all.push_back(of_program(title, programs / setting.engine, setting));
  return all;
}

/// Error in mm and us a step, in two digits or whole numbers.
std::string said(const Motion& motion, const Measured& one) {
  const auto two_digits = [](double number) {
    return number < 100 ? fmt::format("{:.2g}", number) : fmt::format("{:.0f}", number);
  };
  const double mm = 1000 * one.error, us = 1e6 * one.median() / motion.frames();
  const std::string off = std::isinf(mm) ? "lost" : mm < 1e-6 ? "< 1e-6" : two_digits(mm);
  return us > 0 ? fmt::format("{}; {}", off, two_digits(us))
                : off;  // what is lost before it has moved has taken no time
}

std::string table_of(const std::vector<Contender>& all, int rounds) {
  std::vector<std::string> heads{"error in mm; µs a step"};
  for (const Contender& one : all) heads.push_back(one.title);
  std::string table = markdown_heads(heads);
  for (const Motion& motion : every_motion()) {
    const std::vector<Places> truth = motion.truth(motion.frames());
    std::vector<std::optional<Measured>> measured(all.size());
    for (int round = 0; round < rounds; ++round)
      for (std::size_t i = 0; i < all.size(); ++i) {
        const auto once = all[i].play(motion, truth);
        if (round == 0) measured[i] = once;
        else if (once) measured[i]->seconds.push_back(once->median());
      }
    std::vector<std::string> row{motion.title};
    for (const auto& one : measured) row.push_back(one ? said(motion, *one) : "–");
    table += markdown_row(row);
  }
  return table;
}

}  // namespace

int main(int argc, char** argv) {
  CommandLine line(
      "Error and time of the presets Fast, Recommended, also with 0.1 mm asked, and Exact; and of other engines as "
      "they come.");
  int rounds = 5;
  std::string out = "renders/here";
  line.option("--rounds", rounds, "Each plays so often, in turn; times are medians").between(1, 1000).shows_default();
  line.option("--out", out, "The folder to write to").shows_default();
  return line.run(argc, argv, [&] {
    const fs::path folder = fs::path(out) / "26_to_each_its_own";
    make_writable_folder(folder);
    const std::string load = load_now();
    const std::string table = table_of(contenders(fs::canonical("/proc/self/exe").parent_path()), rounds);
    write_text_file(folder / "prices.md",
                    fmt::format("{}\nLoad of the machine before and after: {} and {}.\n", table, load, load_now()));
    fmt::print("{}", table);
  });
}
