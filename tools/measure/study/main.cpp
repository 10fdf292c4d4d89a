/// ./course study: every motion in every setting by every engine, the diagrams and tables of docs/accuracy_and_time.md.
#include <fmt/ranges.h>

#include "pushback/common/basics/files.h"
#include "pushback/common/experiment/program.h"
#include "pushback/tools/measure/results/machine.h"
#include "pushback/tools/measure/study/every_motion.h"
#include "pushback/tools/measure/study/report.h"

using namespace pushback;
using namespace pushback::study;

namespace {

struct Asked {
  bool quick = false, others = false, redraw = false, methods = false, resume = false;
  std::vector<std::string> only;
  std::string out = "renders", mine, adapter, renew;
};

/// Pictures of motions, a panel each, and tables.
class Report {
 public:
  Report(const AllMeasured& measured, std::filesystem::path folder) : folder_(std::move(folder)) {
    for (const Motion& motion : every_motion())
      if (const auto found = measured.find(motion.name); found != measured.end())
        all_.push_back({&motion, found->second});
  }
  template <class PanelOf>
  void picture(const std::string& file, const PanelOf& panel_of) const {
    std::vector<Panel> panels;
    for (const MotionMeasured& measured : all_) panels.push_back(panel_of(measured));
    write_plot(folder_ / file, panels);
  }
  void table(const std::string& file, const std::string& text) const {
    write_text_file(folder_ / file, text);
    fmt::print("{}\n", text);
  }
  void write(const std::vector<Engine>& engines) const {
    picture("work_precision.png", [&](const auto& one) { return work_precision(one, engines); });
    picture("methods.png", [](const auto& one) { return fronts_of_methods(one, "motion"); });
    picture("steps.png", [](const auto& one) { return fronts_of_methods(one, "motion_wide"); });
    if (const auto panels = panels_of_knobs(all_); !panels.empty()) write_plot(folder_ / "knobs.png", panels);
    table("cheapest.md", table_of_cheapest(all_));
    table("engines.md", table_of_engines(all_, engines));
    table("others.md", table_of_others(all_, engines));
    table("regimes.md", table_of_regimes(all_));
    table("next.md", table_of_next(all_));
    table("half_steps.md", table_of_half_steps(all_));
    table("once.md", table_of_once(all_));
    table("choices.md", table_of_choices(all_));
    table("knobs.md", table_of_knobs(all_));
    table("limits.md", table_of_limits(all_));
    table("hops.md", table_of_hops(all_));
  }
  void write_methods() const {
    picture("fronts.png", fronts_of_compared);
    table("sweep.md", table_of_errors(all_, 16, 1));
    table("sweeps.md", table_of_errors(all_, 4, 4));
    table("times.md", table_of_times(all_, 1e-3));
    table("limits.md", table_of_limits(all_));
  }

 private:
  std::filesystem::path folder_;
  std::vector<MotionMeasured> all_;
};

/// An engine that is loaded from a file finds it by this variable.
void add_engine(std::vector<Engine>& engines, const std::string& program, const char* variable,
                const std::string& file) {
  if (file.empty()) return;
  engines.push_back(engines_named({program}).front());
  setenv(variable, std::filesystem::absolute(file).c_str(), 1);
}

void say(const std::string& what) {
  fmt::print("{}\n", what);
  std::fflush(stdout);
}

/// The measurements of study.csv. Those of the method or engine that is to be renewed are measured again.
AllMeasured stored(const Asked& asked, const std::filesystem::path& programs, const std::vector<Motion>& motions,
                   const std::filesystem::path& folder) {
  const std::filesystem::path file = folder / "study.csv";
  AllMeasured all = read_csv(read_text_file(file));
  make_writable_folder(folder);
  if (asked.renew.empty()) return all;
  std::size_t settings = 0;
  for (const Motion& motion : motions) {
    settings += measure_again(asked.renew, motion, {.engines = {}, .programs = programs, .say = say}, all[motion.name]);
    write_text_file(file, csv_of(all));  // the run may yet be ended
  }
  if (settings == 0)
    throw InvalidInput(fmt::format("--renew: {} has no method or engine '{}'", file.string(), asked.renew));
  return all;
}

void measure_and_draw(const Asked& asked, const std::filesystem::path& programs) {
  std::vector<Motion> motions;
  for (const std::string& name : asked.only) motions.push_back(any_motion_named(name));
  if (motions.empty()) motions = every_motion();
  const std::filesystem::path folder =
      std::filesystem::path(asked.out) / (asked.methods ? "methods" : "19_accuracy_and_time");
  const auto tell = [&](const AllMeasured& all) {
    const Report report(all, folder);
    if (asked.methods) report.write_methods();
    else report.write(engines_of(all));
  };
  if (asked.redraw || !asked.renew.empty()) return tell(stored(asked, programs, motions, folder));
  std::vector<Engine> engines =
      asked.methods ? engines_named({"motion", "motion_wide", "motion_methods"}) : engines_in(programs, asked.others);
  add_engine(engines, "motion_mine", "PUSHBACK_MINE", asked.mine);
  add_engine(engines, "motion_adapter", "PUSHBACK_ADAPTER", asked.adapter);
  make_writable_folder(folder);
  RoundOptions options{.engines = engines, .programs = programs, .quick = asked.quick};
  if (asked.methods) options.methods = compared_methods();
  options.say = say;
  MachineReport run{.load_before = load_now(), .load_after = "", .took = {}, .versions = {}, .resumed = 0};
  for (const Engine& engine : engines) run.versions.push_back(version_of(engine, programs));
  const auto began = std::chrono::steady_clock::now();
  AllMeasured all;
  const std::filesystem::path kept = folder / "study.csv";
  if (asked.resume && std::filesystem::exists(kept)) all = read_csv(read_text_file(kept));
  for (const Motion& motion : motions) {
    if (asked.resume && all.contains(motion.name)) {
      ++run.resumed;
      continue;
    }
    all[motion.name] = measure(motion, options);
    write_text_file(kept, csv_of(all));  // the run may yet be ended
  }
  run.took = std::chrono::steady_clock::now() - began;
  run.load_after = load_now();
  write_text_file(folder / "machine.md", table_of_machine(run, engines, all));
  tell(all);
}

}  // namespace

int main(int argc, char** argv) {
  CommandLine line("What accuracy costs in time: all motions in all settings, timed round after round.");
  Asked asked;
  line.flag("--quick", asked.quick, "Use fewer settings and fewer rounds, which takes two minutes");
  line.flag("--peers", asked.others, "Also measure the other engines, as far as they are built");
  line.flag("--methods", asked.methods,
            "Measure the methods of docs/methods.md and some of ours, and write to methods/ in the folder of --out");
  line.option("--mine", asked.mine, "A solver as a shared object, measured as one more engine");
  line.option("--adapter", asked.adapter, "A program that hands motions to another engine, which is measured too");
  line.flag(
      "--resume", asked.resume,
      "Continue a run that was ended: keep the motions in study.csv of the folder of --out, and measure the others");
  line.flag("--redraw", asked.redraw, "Measure nothing, and make the pictures and tables from study.csv");
  line.option("--renew", asked.renew,
              "within, motion_mujoco: measure only this method or engine, and keep the rest of study.csv");
  line.option("--only", asked.only, "Measure only these motions");
  line.option("--out", asked.out, "The folder to write to").shows_default();
  return line.run(argc, argv,
                  [&] { measure_and_draw(asked, std::filesystem::canonical("/proc/self/exe").parent_path()); });
}
