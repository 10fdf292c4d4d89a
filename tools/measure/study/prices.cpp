/// ./course run prices: what the three presets cost, and by how much they are off, beside the engines that were built.
#include <fmt/ranges.h>

#include <array>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <sstream>

#include "pushback/chapters/19_accuracy_and_time/true_places.h"
#include "pushback/chapters/27_which_error/presets.h"
#include "pushback/common/basics/files.h"
#include "pushback/common/basics/process.h"
#include "pushback/common/basics/quantile.h"
#include "pushback/common/experiment/program.h"
#include "pushback/tools/measure/results/markdown.h"
#include "pushback/tools/measure/study/every_motion.h"
#include "pushback/tools/measure/study/machine.h"

using namespace pushback;
namespace fs = std::filesystem;

namespace {

struct Price {
  double error = 0;    // mm, of the body that is farthest from its true place, the largest of all frames
  double seconds = 0;  // of the whole motion
};
struct Contender {
  std::string title;
  std::function<Price(const Motion&, const TruePlaces&)> play;
};

template <class Preset>
Price play(const Motion& motion, const TruePlaces& truth) {
  World world;
  motion.begin(world);
  Preset solver;
  Price price;
  for (int frame = 0; frame < motion.frames(); ++frame) {
    const auto began = std::chrono::steady_clock::now();
    world.step(solver, Real(1) / frames_per_second);
    price.seconds += std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
    price.error = std::max(price.error, static_cast<double>(truth.error(world)));
  }
  return price;
}

struct WithinATenth : Recommended {  // of a millimetre
  WithinATenth() { error = Real(1e-4); }
};

constexpr Price no_price{std::numeric_limits<double>::quiet_NaN(), 0};  // where an engine has no way to play a motion

/// One of the programs that play motions by other engines, in a setting of its: it prints  SETTING error METRES seconds S ...
Contender of_program(const std::string& title, const fs::path& program, const std::string& setting) {
  return {title, [program, setting](const Motion& motion, const TruePlaces&) -> Price {
            const std::string method = setting.substr(0, setting.find('/') + 1);
            if (run_program({program.string(), motion.name}).out.find(method) == std::string::npos) return no_price;
            const Ended ended = run_program({program.string(), motion.name, setting, "--at-least", "0"});
            if (ended.status != 0)
              throw InvalidInput(fmt::format("{} cannot play {}: {}", setting, motion.name, ended.err));
            std::istringstream said(ended.out);
            std::string word, error;
            Price price;
            said >> word >> word >> error >> word >> price.seconds;
            price.error =
                error == "lost" || error == "late" ? std::numeric_limits<double>::infinity() : 1000 * std::stod(error);
            return price;
          }};
}

std::vector<Contender> contenders(const fs::path& programs) {
  std::vector<Contender> all{{"Fast", play<Fast>},
                             {"Recommended", play<Recommended>},
                             {"Recommended, 0.1 mm asked", play<WithinATenth>},
                             {"Exact", play<Exact>}};
  for (const auto& [title, program, setting] : {std::array{"Bullet", "motion_bullet", "bullet/1/10"},
                                                {"ODE", "motion_ode", "ode/1/20"},
                                                {"MuJoCo", "motion_mujoco", "mujoco-default/1"},
                                                {"Box3D", "motion_box3d", "box3d/4"},
                                                {"Jolt", "motion_jolt", "jolt/1"}})
    if (fs::exists(programs / program)) all.push_back(of_program(title, programs / program, setting));
  return all;
}

/// Two digits, or the whole number.
std::string two_digits(double number) {
  return number < 100 ? fmt::format("{:.2g}", number) : fmt::format("{:.0f}", number);
}
/// What is lost before it has moved has taken no time.
std::string said(double error, double us) {
  const std::string off = std::isinf(error) ? "lost" : error < 1e-6 ? "< 1e-6" : two_digits(error);
  return us > 0 ? fmt::format("{}; {}", off, two_digits(us)) : off;
}

std::string table_of(const std::vector<Contender>& all, int rounds) {
  std::vector<std::string> heads{"error in mm; µs a step"};
  for (const Contender& one : all) heads.push_back(one.title);
  std::string table = markdown_heads(heads);
  for (const Motion& motion : every_motion()) {
    const TruePlaces truth(motion);
    std::vector<std::vector<double>> seconds(all.size());
    std::vector<double> errors(all.size());
    for (int round = 0; round < rounds; ++round)
      for (std::size_t i = 0; i < all.size(); ++i) {
        const Price price = all[i].play(motion, truth);
        errors[i] = price.error;
        seconds[i].push_back(price.seconds);
      }
    std::vector<std::string> row{motion.title};
    for (std::size_t i = 0; i < all.size(); ++i) {
      const double us = 1e6 * median(seconds[i]) / static_cast<double>(motion.frames());
      row.push_back(std::isnan(errors[i]) ? "–" : said(errors[i], us));
    }
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
    const std::string load = study::load_now();
    const std::string table = table_of(contenders(fs::canonical("/proc/self/exe").parent_path()), rounds);
    write_text_file(folder / "prices.md", fmt::format("{}\nLoad of the machine before and after: {} and {}.\n", table,
                                                      load, study::load_now()));
    fmt::print("{}", table);
  });
}
