/// One experiment: these scenes, these variants of the solver, these things measured; side by side in one picture.
///
///   int main(int argc, char** argv) {
///     Experiment e("my_experiment", "Does it stand?");
///     return e.run(argc, argv, [&] {
///       e.scene({.name = "a stack", .fill = [](World& world) { stack(world, 5); }});
///       e.variant("with friction", Solver<Clamping, Friction>{});
///       e.number("deepest overlap", "m", [](const Run& run) { return run.samples.back().overlap; });
///     });
///   }
///
/// leaves in OUT/my_experiment/: sheet.png (a row per variant, a column per instant; of each further scene
/// sheet_KEY.png) and thumbnail.png, start.png (the first scene that has pictures, at t = 0), guess_1.png and on where
/// it has a Guess, plot.png (plot_2.png and on, where there are more than four diagrams), metrics.csv (a row per variant
/// and step) and numbers.md (the measured numbers beside what they should be); with --frames COUNT also
/// SCENE_VARIANT/frame_0000.png and on.
#pragma once

#include <deque>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "pushback/common/experiment/parameter.h"
#include "pushback/common/experiment/plot.h"
#include "pushback/common/experiment/scene.h"
#include "pushback/common/world/any_solver.h"
#include "pushback/common/world/measure.h"
#include "pushback/common/world/situations.h"

namespace pushback {

struct IteratedProblem;
struct Sheet;

/// What is read off the world after every step.
struct Sample {
  Real time = 0;              ///< s
  Real kinetic_energy = 0;    ///< J
  Real potential_energy = 0;  ///< J
  Vec3 momentum;              ///< N s
  Vec3 angular_momentum;      ///< N m s, about the origin
  Real overlap = 0;           ///< m, the deepest
  int contacts = 0;           ///< points in this step
  int found = 0;              ///< of them, those that the step before did not have
  int lost = 0;               ///< points that the step before had and this one has not
  int rows = 0;               ///< constraint rows in the solver
  Real residual = 0;          ///< m/s, the largest error() of a row after the last sweep
  double solver_seconds = 0;  ///< wall time of the solver, for metrics.csv; it alone differs from run to run
};

/// What one variant did, for the numbers.
struct Run {
  const World& world;  ///< at the end
  Real dt;             ///< s
  std::vector<Sample> samples;
  std::map<std::string, std::vector<Real>> series;  ///< by name, one value a step

  /// Samples of the last `seconds`: at least one.
  std::vector<Sample> last(Real seconds) const;
  /// The largest value of the series of this name.
  Real largest(const std::string& name) const;
  /// The mean of that series over all steps.
  Real mean(const std::string& name) const;
};

/// A closed form, drawn dashed beside what was measured.
struct Reference {
  std::string label;
  std::function<Real(Real)> of_time;
};

/// A step that an experiment makes in a way of its own, without a StepSolver. Returns how many rows that took.
using CustomStep = std::function<std::size_t(World&, Real dt, int sweeps)>;

/// One solver on one scene. What it returns can be said more of: e.variant("cold", solver).with_sweeps(50).
struct Variant {
  std::string name;
  std::size_t scene = 0;
  std::optional<AnySolver> solver;  ///< what moves the world on; none: `motion` does
  CustomStep motion;                ///< instead of a solver
  bool checked = true;  ///< whether the scene is refused, before anything is drawn, where the solver refuses it
  std::function<void(World&)> change;    ///< what this variant does to the scene before it begins; empty: nothing
  int sweeps = 0;                        ///< in each substep; 0: what the solver's plan says
  bool exactly = false;                  ///< whether --sweeps has no say
  int colour = -1;                       ///< index of line_colour and marker_of; -1: one for its name
  std::map<std::string, Real> expected;  ///< by the name of a number
  std::vector<Reference> references;
  bool curves = true;  ///< whether its series are drawn

  /// How a step of dt is divided.
  Plan plan(Real dt) const;
  /// Throws InvalidInput where a value cannot be used.
  void check(World& world, Real dt) const;
  /// What this variant does to the scene before it begins: variants may differ in their joints.
  Variant& changing(std::function<void(World&)> how);
  /// Instead of what the solver's plan says; --sweeps overrides it.
  Variant& with_sweeps(int count);
  /// The number of sweeps is what this variant is about: --sweeps leaves it alone.
  Variant& with_exactly(int count);
  /// Instead of the colour and the marker that its name would have in all scenes.
  Variant& coloured(int which);
  /// What the number of that name should be, from a closed form; shown beside it.
  Variant& expect(const std::string& number, Real value);
  /// The curve that the scene's first series should follow.
  Variant& reference(const std::string& label, std::function<Real(Real)> of_time);
  /// Its curves would lie on those of another.
  Variant& without_curves();
};

/// What is done with an experiment's scenes by words of its own; argv[0] is how it was called. Returns the exit status.
using SceneCommand = std::function<int(const std::vector<Scene>& scenes, int argc, const char* const* argv)>;

class Experiment {
 public:
  /// `name` is the folder's and the program's, `question` stands above the sheet.
  Experiment(std::string name, std::string question);

  /// A parameter of this experiment's own, beside those that every experiment has; see parameter.h.
  void parameter(const Parameter& parameter, ParameterVariable variable);
  /// All of its own parameters, in the order in which they were added.
  const std::vector<ParameterWithDefault>& parameters() const;

  /// Where the first word is `flag`, `act` is called with the words after it, instead of what `run` does else: `what` says so to
  /// --help. Parameters have their defaults then.
  void command(const std::string& flag, const std::string& what, SceneCommand act);

  // ---- to be called inside `run`'s `define` --------------------------------------------------------------------------

  /// What follows, up to the next scene, belongs to this one.
  void scene(Scene scene);
  /// A solver to watch on the latest scene: anything that World::step takes.
  Variant& variant(const std::string& name, AnySolver solver);
  /// What moves the scene's bodies on in a way of its own. A copy of it plays the scene.
  Variant& motion(const std::string& name, CustomStep step);
  /// A quantity to record after every step and to plot against time, for the latest scene. The first is the one that
  /// references are drawn with. Without any, the deepest overlap is plotted. `log_y`: as Panel has it.
  void series(const std::string& name, const std::string& unit, std::function<Real(const World&)> of,
              bool log_y = false);
  /// The same, recorded for the numbers alone.
  void series_without_curves(const std::string& name, std::function<Real(const World&)> of);
  /// A number to show beside each variant of the latest scene. None may come from a clock: what git tracks would change with
  /// every run.
  void number(const std::string& name, const std::string& unit, std::function<Real(const Run&)> of);
  /// What the experiment works out itself, once all variants have been watched: `work` calls `panel` and `remark`.
  void study(std::function<void()> work);
  /// A further diagram that the experiment works out itself, after the scenes' own.
  void panel(Panel panel);
  /// A step's problem that a page solves iteration by iteration (iterated_problem.h). `make` is called where one asks for it.
  void iterations(const std::string& of, std::function<IteratedProblem()> make);
  /// A finding that belongs to no single variant; it stands below the tables of numbers.
  void remark(std::string sentence);

  // ---------------------------------------------------------------------------------------------------------------------

  /// Reads the command line, lets `define` say what there is, and does it. Returns the program's exit status: 0; 2 after
  /// a message where a value cannot be used (nothing is written then); 1 where something else went wrong.
  int run(int argc, const char* const* argv, const std::function<void()>& define);

  Real dt() const { return dt_; }
  int sweeps() const { return sweeps_; }

 private:
  struct Quantity {
    std::string name, unit;
    std::function<Real(const World&)> of;
    bool log_y, drawn;
  };
  struct Number {
    std::string name, unit;
    std::function<Real(const Run&)> of;
  };
  struct Act {
    Scene scene;
    std::vector<Quantity> series;
    std::vector<Number> numbers;
  };
  struct Command {
    std::string flag, what;
    SceneCommand act;
  };
  struct Posed {
    std::string name;
    std::function<IteratedProblem()> make;
  };
  struct Result;
  class Output;
  class Shots;
  class Played;
  friend class Live;  // plays the same where somebody looks on: common/live/

  Variant& add_variant(const std::string& name);
  std::optional<int> run_command(int argc, const char* const* argv, const std::function<void()>& define);
  std::optional<int> read_command_line(int argc, const char* const* argv);
  void describe(const std::function<void()>& define, const AnySolver* one_more = nullptr);
  void refuse_twins() const;
  void choose_colours();
  void add_to_all_scenes(const std::string& name, const AnySolver& solver);
  void choose_variants();
  void check() const;
  void fill(World& world, const Variant& variant) const;
  void list() const;
  void play();
  Result play(std::size_t index, Output& output) const;
  std::vector<Panel> panels(const std::vector<Result>& results) const;
  std::string numbers_table(const std::vector<Result>& results) const;
  std::string metrics(const std::vector<Result>& results) const;
  void report(std::vector<Result>& results, const std::filesystem::path& folder) const;
  void draw_sheets(std::vector<Result>& results, const std::filesystem::path& folder) const;
  std::string sheet_file(std::size_t act) const;
  bool is_first_with_pictures(std::size_t act) const;
  std::string frames_folder(const Variant& variant) const;
  void make_films(const std::filesystem::path& folder) const;
  std::string how_solved(std::size_t act) const;
  std::optional<Sheet> sheet_of(std::size_t act, std::vector<Result>& results) const;
  std::size_t steps_of(const Scene& scene) const;
  int sweeps_of(const Variant& variant) const;
  std::string shown_name(const Variant& variant) const;

  std::string name_, question_;
  std::vector<ParameterWithDefault> parameters_;
  std::vector<Command> commands_;
  std::vector<Act> acts_;
  std::deque<Variant> variants_;  // `variant` hands out references
  std::vector<Panel> own_panels_;
  std::vector<std::string> remarks_;
  std::vector<std::function<void()>> studies_;
  std::vector<Posed> posed_;

  std::string out_ = "renders", size_ = "640x360";
  int width_ = 0, height_ = 0;
  Real seconds_ = 0, dt_ = Real(1) / 60;
  int frames_ = 0, sweeps_ = 10, passes_ = 16;
  std::set<std::string> told_;  ///< the flags that were given
  std::string film_;            ///< ending of the films; empty: none
  std::vector<std::string> only_;
  std::string mine_;  ///< shared object with one more solver; empty: none
  bool no_images_ = false, no_study_ = false, first_scene_ = false, list_ = false, list_parameters_ = false;
};

}  // namespace pushback
