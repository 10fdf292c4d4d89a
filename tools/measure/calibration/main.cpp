/// ./course run calibration: whether an error that is said is true, in scenes that were drawn.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <thread>

#include "pushback/common/basics/files.h"
#include "pushback/common/basics/quantile.h"
#include "pushback/common/experiment/plot.h"
#include "pushback/common/experiment/program.h"
#include "pushback/common/render/palette.h"
#include "pushback/engine/substeps/thread_pool.h"
#include "pushback/tools/measure/calibration/calibration.h"
#include "pushback/tools/measure/results/markdown.h"

using namespace pushback;
using namespace pushback::calibration;
namespace fs = std::filesystem;

namespace {

constexpr std::uint64_t first_held_out = 1'000'000;

fs::path stored(const std::string& name) {
  return fs::path(PUSHBACK_TRUTHS) / (name + ".csv");
}

struct Set {
  std::vector<Scene> scenes;   // all
  std::vector<Played> played;  // those with a truth
};

/// The share of those of which `is` is true, %.
template <class Is>
double share(const std::vector<Played>& all, const Is& is) {
  return all.empty()
             ? 0
             : 100 * static_cast<double>(std::count_if(all.begin(), all.end(), is)) / static_cast<double>(all.size());
}

std::string row(const std::string& name, std::size_t scenes, const std::vector<Played>& all) {
  std::vector<double> ratios;
  double steps = 0, estimates = 0;
  for (const Played& one : all) {
    steps += one.steps, estimates += one.estimate;
    if (one.error > 1e-7) ratios.push_back(one.said / one.error);
  }
  const auto missed = [](const Played& one) { return one.missed(); };
  return markdown_row({name, fmt::format("{}", scenes), fmt::format("{}", all.size()),
                       fmt::format("{:.1f} %", share(all, [](const Played& one) { return one.flagged; })),
                       fmt::format("{} ({:.2f} %)", std::count_if(all.begin(), all.end(), missed), share(all, missed)),
                       fmt::format("{:.1f} %", share(all, [](const Played& one) { return one.covered(); })),
                       ratios.empty() ? "–" : fmt::format("{:.2g}", quantile(ratios, 0.5)),
                       fmt::format("{:.0f} %", 100 * estimates / steps)});
}

std::string remark(const Played& one) {
  return fmt::format("- not flagged: scene {}, {}, {:g} mm asked, {:.2g} mm said, {:.3g} mm off\n", one.number,
                     one.kind, 1000 * one.asked, 1000 * one.said, 1000 * one.error);
}

/// Of the scenes for work one row, and of those that were held out a row for each kind and each error.
std::string table(const Set& work, const Set& held_out) {
  std::string text =
      markdown_heads({"scenes", "drawn", "with a truth", "flagged", "not flagged, and above what was asked",
                      "error at most 3 times what is said", "said / error, median", "price of saying it"});
  text += row("for work", work.scenes.size(), work.played);
  text += row("held out", held_out.scenes.size(), held_out.played);
  const auto part = [&](const std::string& name, const auto& belongs) {
    std::vector<Played> some;
    std::copy_if(held_out.played.begin(), held_out.played.end(), std::back_inserter(some), belongs);
    text += row(name, static_cast<std::size_t>(std::count_if(held_out.scenes.begin(), held_out.scenes.end(), belongs)),
                some);
  };
  for (const char* kind : {"thrown", "meeting", "sliding", "rolling", "struck", "jointed"})
    part(kind, [kind](const auto& one) { return one.kind == kind; });
  for (const Real mm : {Real(10), Real(1), Real(0.1)})
    part(fmt::format("{:g} mm asked", mm), [mm](const auto& one) { return std::abs(1000 * one.asked - mm) < mm / 2; });
  text += "\n";
  for (const Set* set : {&work, &held_out})
    for (const Played& one : set->played)
      if (one.missed()) text += remark(one);
  return text;
}

/// A dot for each scene, and a ring with its name around each that was missed.
void draw(const fs::path& file, const std::vector<Played>& all) {
  constexpr Real least = Real(1e-4), most = 1000;  // mm
  Curve kept{"not flagged", {}, {}, line_colour(0), Curve::Style::points},
      flagged{"flagged", {}, {}, line_colour(1), Curve::Style::points};
  std::string rings;
  Real above = Real(0.5);  // lines
  for (const Played& one : all) {
    Curve& curve = one.flagged ? flagged : kept;
    const Real said = std::clamp(1000 * one.said, least, most), error = std::clamp(1000 * one.error, least, most);
    curve.x.push_back(said);
    curve.y.push_back(error);
    if (!one.missed()) continue;
    above = -above;  // neighbours have their names above and below
    rings += fmt::format("set label '{}, {:g} mm asked' at {:g},{:g} right offset -1.2,{:g} point pt 6 ps 2.2 lw 2\n",
                         one.kind, 1000 * one.asked, said, error, above);
  }
  write_plot(file,
             {{.title = fmt::format("{} drawn scenes that Recommended was not tuned on", all.size()),
               .x_label = "error said, mm",
               .y_label = "true error, mm",
               .log_x = true,
               .log_y = true,
               .curves = {kept, flagged, {"as said", {least, most}, {least, most}, "#888888", Curve::Style::dashed}},
               .x_range = {least, most},
               .y_range = {least, most},
               .extra = rings}});
}

Set play_all(const std::string& name, int most) {
  std::vector<Truth> truths = truths_in(read_text_file(stored(name)));
  truths.resize(std::min(truths.size(), static_cast<std::size_t>(most)));
  Set set;
  for (const Truth& truth : truths) {
    set.scenes.push_back(scene(truth.number));
    if (truth.good_for(set.scenes.back().asked)) set.played.push_back(play(set.scenes.back(), truth));
  }
  return set;
}

std::vector<Truth> find_truths(std::uint64_t first, int count) {
  std::vector<Truth> truths(static_cast<std::size_t>(count));
  ThreadPool threads(static_cast<int>(std::thread::hardware_concurrency()), true);
  threads.each(truths.size(), 1, [&](Part part) {
    for (std::size_t i = part.begin; i < part.end; ++i) truths[i] = find_truth(first + i);
  });
  return truths;
}

}  // namespace

int main(int argc, char** argv) {
  CommandLine line(
      "Plays drawn scenes by Recommended with an error, and compares what it says of its error with what is true: "
      "2,000 scenes that it was "
      "tuned on, and 1,000 that it was not.");
  bool find = false;
  int most = 2000;
  std::string out = "renders/here";
  line.option("--scenes", most, "Largest number of scenes of each kind").between(1, 2000).shows_default();
  line.flag("--find-truth", find,
            "Find the true positions again, which takes 20 minutes, and write them to the sources");
  line.option("--out", out, "The folder to write to").shows_default();
  return line.run(argc, argv, [&] {
    if (find) {
      write_text_file(stored("work"), text_of(find_truths(0, 2000)));
      write_text_file(stored("held_out"), text_of(find_truths(first_held_out, 1000)));
      return;
    }
    const fs::path folder = fs::path(out) / "27_which_error";
    make_writable_folder(folder);
    const Set work = play_all("work", most), held_out = play_all("held_out", most);
    const std::string said = table(work, held_out);
    fmt::print("{}", said);
    write_text_file(folder / "calibration.md", said);
    draw(folder / "calibration.png", held_out.played);
    fmt::print("{}\n", (folder / "calibration.png").string());
  });
}
