/// ./course study: every motion in every setting by every engine, the diagrams and tables of docs/accuracy_and_time.md.
#include <fmt/ranges.h>

#include "pushback/common/basics/files.h"
#include "pushback/common/basics/shard.h"
#include "pushback/common/experiment/program.h"
#include "pushback/tools/measure/study/every_motion.h"
#include "pushback/tools/measure/study/machine.h"
#include "pushback/tools/measure/study/methods.h"
#include "pushback/tools/measure/study/report.h"

using namespace pushback;
using namespace pushback::study;

namespace {

struct Asked {
  bool quick = false, others = false, redraw = false, methods = false, resume = false;
  int rounds = 0;
  std::vector<std::string> only;
  std::string out = "renders", shard = "1/1", mine, adapter;
  std::size_t parts = 0;
};

using Tables = std::vector<std::pair<std::string, std::string>>;  // a file's name, and what is in it

void write_tables(const std::filesystem::path& folder, const Tables& tables) {
  for (const auto& [name, table] : tables) {
    write_text_file(folder / name, table);
    fmt::print("{}\n", table);
  }
}

std::vector<MotionMeasured> in_order(const AllMeasured& all) {
  std::vector<MotionMeasured> found;
  for (const Motion& motion : every_motion())
    if (const auto measured = all.find(motion.name); measured != all.end())
      found.push_back({&motion, measured->second});
  return found;
}

template <class PanelOf>
void write_panels(const std::filesystem::path& file, const std::vector<MotionMeasured>& all, const PanelOf& panel_of) {
  std::vector<Panel> panels;
  for (const MotionMeasured& measured : all) panels.push_back(panel_of(measured));
  write_plot(file, panels);
}

void report(const AllMeasured& measured, const std::vector<Engine>& engines, const std::filesystem::path& folder) {
  const std::vector<MotionMeasured> all = in_order(measured);
  write_panels(folder / "work_precision.png", all, [&](const auto& one) { return work_precision(one, engines); });
  write_panels(folder / "methods.png", all, [](const auto& one) { return fronts_of_methods(one, "motion"); });
  write_panels(folder / "steps.png", all, [](const auto& one) { return fronts_of_methods(one, "motion_wide"); });
  if (const auto panels = panels_of_knobs(all); !panels.empty()) write_plot(folder / "knobs.png", panels);
  write_tables(folder, {{"cheapest.md", table_of_cheapest(all)},
                        {"engines.md", table_of_engines(all)},
                        {"others.md", table_of_others(all, engines)},
                        {"knobs.md", table_of_knobs(all)},
                        {"limits.md", table_of_limits(all)},
                        {"hops.md", table_of_hops(all)}});
}

void report_on_methods(const AllMeasured& measured, const std::filesystem::path& folder) {
  const std::vector<MotionMeasured> all = in_order(measured);
  write_panels(folder / "fronts.png", all, fronts_of_compared);
  write_tables(folder, {{"sweep.md", table_of_errors(all, 16, 1)},
                        {"sweeps.md", table_of_errors(all, 4, 4)},
                        {"times.md", table_of_times(all, 1e-3)},
                        {"limits.md", table_of_limits(all)}});
}

/// The parts, put together: they have timed, so of one kind of machine.
AllMeasured join(std::size_t parts, const std::filesystem::path& folder) {
  const auto folders = folders_of_parts(folder, parts, "origin.txt", Holds::times);
  std::vector<AllMeasured> measured;
  for (const std::string& text : texts_of_parts(folders, "study.csv")) measured.push_back(read_csv(text));
  std::string machines;
  for (const std::string& text : texts_of_parts(folders, "machine.md")) machines += text + "\n";
  const AllMeasured all = together(measured);
  write_text_file(folder / "study.csv", csv_of(all));
  write_text_file(folder / "machine.md", machines);
  return all;
}

void measure_and_draw(const Asked& asked, const std::filesystem::path& programs) {
  std::vector<const Motion*> motions;
  for (const Motion& motion : every_motion())
    if (asked.only.empty()) motions.push_back(&motion);
  for (const std::string& name : asked.only) motions.push_back(&any_motion_named(name));
  std::filesystem::path folder =
      std::filesystem::path(asked.out) / (asked.methods ? "methods" : "19_accuracy_and_time");
  const auto tell = [&](const AllMeasured& all) {
    if (asked.methods) report_on_methods(all, folder);
    else report(all, engines_of(all), folder);
  };
  if (asked.parts > 0) return tell(join(asked.parts, folder));
  const Shard shard = shard_of(asked.shard);
  if (asked.resume && !shard.whole()) throw InvalidInput("--resume is for the whole, not for --shard: a part is small");
  if (asked.redraw) {
    make_writable_folder(folder);
    return tell(read_csv(read_text_file(folder / "study.csv")));
  }
  std::vector<Engine> engines = asked.methods ? engines_of_methods() : engines_in(programs, asked.others);
  if (!asked.mine.empty()) {
    engines.push_back(engine_of_mine());
    setenv("PUSHBACK_MINE", std::filesystem::absolute(asked.mine).c_str(), 1);  // where its program looks for it
  }
  if (!asked.adapter.empty()) {
    engines.push_back(engine_of_adapter());
    setenv("PUSHBACK_ADAPTER", std::filesystem::absolute(asked.adapter).c_str(), 1);
  }
  const std::vector<Piece> pieces = pieces_of(motions, engines, shard);
  if (!shard.whole()) folder /= shard.folder();
  make_writable_folder(folder);
  RoundOptions options{.engines = {}, .programs = programs, .quick = asked.quick};
  if (asked.methods) options.methods = compared_methods();
  if (asked.rounds > 0 || asked.quick) options.rounds = std::max(1, asked.rounds);
  options.say = [](const std::string& what) {
    fmt::print("{}\n", what);
    std::fflush(stdout);
  };
  MachineReport run{.load_before = load_now(), .load_after = "", .took = {}, .versions = {}, .resumed = 0};
  for (const Engine& engine : engines) run.versions.push_back(version_of(engine, programs));
  const auto began = std::chrono::steady_clock::now();
  AllMeasured all;
  const std::filesystem::path kept = folder / "study.csv";
  if (asked.resume && std::filesystem::exists(kept)) all = read_csv(read_text_file(kept));
  for (const Piece& piece : pieces) {
    const std::string& name = piece.motion->name;
    if (asked.resume && all.contains(name)) {
      ++run.resumed;
      continue;
    }
    options.engines = piece.engines;
    const Measurements found = measure(*piece.motion, options);
    all[name].insert(all[name].end(), found.begin(), found.end());
    write_text_file(kept, csv_of(all));  // the run may yet be ended
  }
  run.took = std::chrono::steady_clock::now() - began;
  run.load_after = load_now();
  write_text_file(folder / "machine.md", table_of_machine(run, engines, all));
  if (shard.whole()) tell(all);
  else write_text_file(folder / "origin.txt", origin_text(origin_here()));
}

}  // namespace

int main(int argc, char** argv) {
  CommandLine line("What accuracy costs in time: all motions in all settings, timed round after round.");
  Asked asked;
  line.flag("--quick", asked.quick, "Fewer settings, fewer rounds: in two minutes");
  line.flag("--peers", asked.others, "The other engines as well, those that were built");
  line.flag("--methods", asked.methods,
            "The methods of docs/methods.md and some of ours, into methods/ in that folder");
  line.option("--mine", asked.mine, "A solver as a shared object, as one more engine");
  line.option("--adapter", asked.adapter, "A program that hands motions to another engine, as one more engine");
  line.option("--rounds", asked.rounds, "In which all that is near a front is timed; 3, or 1 with --quick")
      .between(1, 1000);
  line.flag(
      "--resume", asked.resume,
      "Motions that study.csv in that folder has stay as they are, of a run that was ended; the others are measured");
  line.flag("--redraw", asked.redraw, "Nothing is measured: pictures and tables of what is in study.csv");
  line.option("--only", asked.only, "These motions");
  line.option("--shard", asked.shard, "2/5: the second of five parts, for a machine of its own, into shard_2_of_5");
  line.option("--join", asked.parts, "5: nothing is measured; pictures and tables of five such parts").between(2, 1000);
  line.option("--out", asked.out, "The folder to write to").shows_default();
  return line.run(argc, argv,
                  [&] { measure_and_draw(asked, std::filesystem::canonical("/proc/self/exe").parent_path()); });
}
