/// ./course run predictions: the predictions of ./course choose compared with its measurements.
#include <filesystem>
#include <thread>

#include "pushback/chapters/26_to_each_its_own/scenes.h"
#include "pushback/chapters/27_which_error/play_within.h"
#include "pushback/chapters/27_which_error/prediction.h"
#include "pushback/common/basics/files.h"
#include "pushback/common/basics/quantile.h"
#include "pushback/common/experiment/program.h"
#include "pushback/engine/substeps/thread_pool.h"
#include "pushback/tools/catalogue/catalogue.h"
#include "pushback/tools/measure/calibration/calibration.h"
#include "pushback/tools/measure/hard_cases/hard_case.h"
#include "pushback/tools/measure/results/markdown.h"

using namespace pushback;
namespace fs = std::filesystem;

namespace {

constexpr std::size_t at_a_time = 16;   // scenes, because each keeps its world after each step
constexpr std::size_t few_bodies = 12;  // so few are played so soon that it is repeated
constexpr Real nothing = Real(1e-9);    // m
/// The hard cases and the scenes from 1,000,000 on were held out until they were played once or twice. Then the prediction was changed.
struct ScenePart {
  std::string name;
  bool for_work;
  std::uint64_t first = 0, past = 0;  // numbers of drawn scenes
};
const std::vector<ScenePart> all_parts{{"chapters", true},
                                       {"drawn, for work", true, 0, 30},
                                       {"hard cases", false},
                                       {"drawn, held out once", false, 1'000'000, 1'000'060},
                                       {"drawn, held out", false, 1'000'060, 1'000'090}};

struct PlayedScene {
  std::string part, name;
  World begin;
  Real asked;
  int steps;
  Prediction prediction = {};
  Played played = {};
  double seconds = 0;
  Real error = 0;
  std::string not_played = {};
};

enum class Verdict { right, not_predictable, wrong };
Verdict verdict(double predicted, double measured, const std::string& why_not) {
  if (!why_not.empty()) return Verdict::not_predictable;
  return predicted <= 2 * measured && measured <= 2 * predicted ? Verdict::right : Verdict::wrong;
}
Verdict of_time(const PlayedScene& row) {
  return verdict(row.prediction.seconds, row.seconds, row.prediction.no_time);
}
Verdict of_error(const PlayedScene& row) {
  return verdict(std::max(row.prediction.error, nothing), std::max(row.error, nothing), row.prediction.no_error);
}

std::vector<PlayedScene> scenes_of(const ScenePart& part, Real seconds) {
  const auto steps = static_cast<int>(std::lround(seconds / dt_within));
  std::vector<PlayedScene> rows;
  const auto add = [&](const std::string& name, const std::function<void(World&)>& fill) {
    rows.push_back({.part = part.name, .name = name, .begin = {}, .asked = Real(1e-3), .steps = steps});
    fill(rows.back().begin);
  };
  if (part.name == "chapters") {
    for (const NamedScene& scene : all_scenes()) add(scene.name, scene.fill);
    add("26-yard", to_each_its_own_scenes::Yard{});
    add("26-chain", to_each_its_own_scenes::Chain{});
  } else if (part.name == "hard cases") {
    for (const HardCase& hard_case : hard_cases()) add(hard_case.name, hard_case.scene.fill);
  } else {
    for (std::uint64_t number = part.first; number < part.past; ++number) {
      calibration::Scene scene = calibration::scene(number);
      rows.push_back({.part = part.name,
                      .name = fmt::format("{} {}", scene.kind, number),
                      .begin = std::move(scene.world),
                      .asked = scene.asked,
                      .steps = calibration::frames});
    }
  }
  return rows;
}

/// The fastest of so many: what else the machine does only makes it slower.
void predict_and_play(PlayedScene& row, int repeats) {
  for (int i = 0; i < repeats; ++i) {
    const Prediction again = predict(row.begin, row.asked, row.steps);
    if (i == 0 || again.seconds < row.prediction.seconds) row.prediction = again;
    row.played = play_within(row.begin, row.asked, row.steps);
    if (i == 0 || row.played.seconds() < row.seconds) row.seconds = row.played.seconds();
  }
}

void measure(PlayedScene& row) {
  if (row.prediction.no_error.empty())
    for (const Real x : off(row.begin, row.played, row.asked, finer_truth)) row.error = std::max(row.error, x);
  row.played = {};
}

void each(std::vector<PlayedScene>& rows, int repeats, ThreadPool& threads) {
  const auto tried = [](PlayedScene& row, const auto& act) {
    if (!row.not_played.empty()) return;
    try {
      act(row);
    } catch (const InvalidInput& refused) {
      row.not_played = refused.what();
    }
  };
  for (std::size_t first = 0; first < rows.size(); first += at_a_time) {
    const std::size_t count = std::min(at_a_time, rows.size() - first);
    for (std::size_t i = first; i < first + count; ++i)
      tried(rows[i],
            [&](PlayedScene& row) { predict_and_play(row, row.begin.bodies.size() <= few_bodies ? repeats : 1); });
    threads.each(count, 1, [&](Part part) {
      for (std::size_t i = part.begin; i < part.end; ++i) tried(rows[first + i], measure);
    });
  }
}

std::string counts(const std::vector<PlayedScene>& rows) {
  std::string text = markdown_heads({"scenes", "played", "time: within a factor of 2", "not predictable", "wrong",
                                     "error: within a factor of 2", "not predictable", "wrong",
                                     "rehearsals, of the play's time", "in the median"});
  for (const ScenePart& part : all_parts) {
    std::vector<const PlayedScene*> of;
    for (const PlayedScene& row : rows)
      if (row.part == part.name && row.not_played.empty()) of.push_back(&row);
    if (of.empty()) continue;
    std::vector<std::string> cells{part.name, fmt::format("{}", of.size())};
    for (const auto judge : {of_time, of_error})
      for (const Verdict one : {Verdict::right, Verdict::not_predictable, Verdict::wrong})
        cells.push_back(fmt::format(
            "{}", std::count_if(of.begin(), of.end(), [&](const PlayedScene* row) { return judge(*row) == one; })));
    double rehearsed = 0, seconds = 0;
    std::vector<double> shares;
    for (const PlayedScene* row : of) {
      if (!row->prediction.no_time.empty()) continue;
      rehearsed += row->prediction.rehearsed, seconds += row->seconds;
      shares.push_back(row->prediction.rehearsed / row->seconds);
    }
    cells.push_back(fmt::format("{:.0f} %", 100 * rehearsed / seconds));
    cells.push_back(fmt::format("{:.0f} %", 100 * median(shares)));
    text += markdown_row(cells);
  }
  return text;
}

std::string each_scene(const std::vector<PlayedScene>& rows) {
  const auto judged = [](Verdict one) { return one == Verdict::wrong ? "wrong" : ""; };
  const auto milliseconds = [](double seconds) { return fmt::format("{:.2g}", 1000 * seconds); };
  const auto millimetres = [](Real metres) {
    return metres <= nothing ? std::string("< 1e-6") : fmt::format("{:.2g}", 1000 * metres);
  };
  std::string text = markdown_heads({"scene", "asked, mm", "time predicted, ms", "measured", "", "error predicted, mm",
                                     "measured", "", "not predictable, because"});
  for (const PlayedScene& row : rows) {
    std::vector<std::string> cells{row.name, fmt::format("{:g}", 1000 * row.asked)};
    const Prediction& before = row.prediction;
    if (row.not_played.empty()) {
      const bool time = before.no_time.empty(), error = before.no_error.empty();
      cells.insert(cells.end(),
                   {time ? milliseconds(before.seconds) : "–", milliseconds(row.seconds), judged(of_time(row)),
                    error ? millimetres(before.error) : "–", error ? millimetres(row.error) : "–",
                    judged(of_error(row)), time ? before.no_error : before.no_time});
    } else {
      cells.insert(cells.end(), {"", "", "", "", "", "", "not played: " + row.not_played});
    }
    text += markdown_row(cells);
  }
  return text;
}

}  // namespace

int main(int argc, char** argv) {
  CommandLine line(
      "Predicts the time and the error of scenes as ./course choose does, and compares them with what it measures.");
  bool work = false;
  double seconds = 3;
  int repeats = 3;
  std::string out = "renders/here";
  line.flag("--work", work, "Only the scenes that the predictions were tuned on");
  line.option("--seconds", seconds, "How long the chapters' scenes and the hard cases are played, s")
      .between(0.1, 60.0)
      .shows_default();
  line.option("--repeats", repeats, "Number of plays of each scene; the fastest counts")
      .between(1, 100)
      .shows_default();
  line.option("--out", out, "The folder to write to").shows_default();
  return line.run(argc, argv, [&] {
    const fs::path folder = fs::path(out) / "27_which_error";
    make_writable_folder(folder);
    ThreadPool threads(static_cast<int>(std::thread::hardware_concurrency()), true);
    std::vector<PlayedScene> all;
    for (const ScenePart& part : all_parts) {
      if (work && !part.for_work) continue;
      std::vector<PlayedScene> some = scenes_of(part, static_cast<Real>(seconds));
      each(some, repeats, threads);
      all.insert(all.end(), std::make_move_iterator(some.begin()), std::make_move_iterator(some.end()));
    }
    const std::string said = counts(all);
    fmt::print("{}", said);
    write_text_file(folder / "predictions.md", said + "\n" + each_scene(all));
  });
}
