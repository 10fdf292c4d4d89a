/// An experiment: scenes, the solver variants that play them, and the measured quantities. A sheet shows the variants side by side.
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
/// writes to OUT/my_experiment/
///   sheet.png       a row per variant, a column per instant, and sheet_KEY.png for each further scene
///   thumbnail.png
///   start.png       the first scene that has pictures, at t = 0
///   guess_1.png     and guess_2.png, ..., if that scene has a Guess
///   plot.png        and plot_2.png, ..., if there are more than four diagrams
///   metrics.csv     a row per variant and step
///   numbers.md      the measured and the expected numbers
/// With --frames COUNT it also writes SCENE_VARIANT/frame_0000.png, ..., or VARIANT/frame_0000.png, ... if there is only one scene.
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
struct RowByRow;
struct Sheet;

/// Quantities measured in the world after every step.
struct Sample {
  Real time = 0;              ///< s
  Real kinetic_energy = 0;    ///< J
  Real potential_energy = 0;  ///< J
  Vec3 momentum;              ///< N s
  Vec3 angular_momentum;      ///< N m s, about the origin
  Real overlap = 0;           ///< m, the deepest
  int contacts = 0;           ///< contact points in this step
  int found = 0;              ///< points that the previous step did not have
  int lost = 0;               ///< points of the previous step that this step does not have
  int rows = 0;               ///< constraint rows in the solver
  Real residual = 0;          ///< m/s, the largest error() of a row after the last sweep
  double solver_seconds = 0;  ///< wall time of the solver, for metrics.csv; the only value that differs between runs
};

/// The record of one variant, from which numbers are computed.
struct Run {
  const World& world;  ///< at the end
  Real dt;             ///< s
  std::vector<Sample> samples;
  std::map<std::string, std::vector<Real>> series;  ///< by name, one value per step

  /// The samples of the last `seconds`, at least one.
  std::vector<Sample> last(Real seconds) const;
  /// The largest value of the series `name`. Throws std::out_of_range if there is no such series.
  Real largest(const std::string& name) const;
  /// The mean of the series `name` over all steps. Throws as `largest` does.
  Real mean(const std::string& name) const;
};

/// A closed-form curve, drawn dashed with the measured ones.
struct Reference {
  std::string label;
  std::function<Real(Real)> of_time;  ///< takes s, returns the unit of the series
};

/// A step of `dt` s that an experiment implements itself, without a StepSolver. Returns the number of rows it solved.
using CustomStep = std::function<std::size_t(World&, Real dt, int sweeps)>;

/// One solver on one scene. Calls can be chained: e.variant("cold", solver).with_sweeps(50).
struct Variant {
  std::string name;
  std::size_t scene = 0;
  std::optional<AnySolver> solver;       ///< advances the world; none: `motion` does
  CustomStep motion;                     ///< replaces a solver
  bool checked = true;                   ///< whether `check` lets the solver reject the scene before anything is drawn
  std::function<void(World&)> change;    ///< changes the scene before its first step; may be empty
  int sweeps = 0;                        ///< in each substep; 0: as in the solver's plan
  bool exactly = false;                  ///< whether --sweeps is ignored
  int colour = -1;                       ///< index for line_colour and marker_of; -1: chosen by name
  std::map<std::string, Real> expected;  ///< by the name of a number
  std::vector<Reference> references;
  bool curves = true;  ///< whether its series are drawn

  /// How the solver divides a step of `dt` s.
  Plan plan(Real dt) const;
  /// Throws InvalidInput if the solver or the motion cannot use the scene or a value.
  void check(World& world, Real dt) const;
  /// Changes the scene before its first step, so that variants may differ in their joints, for example.
  Variant& changing(std::function<void(World&)> how);
  /// Replaces the number of sweeps in the solver's plan. --sweeps overrides it.
  Variant& with_sweeps(int count);
  /// The same, but --sweeps does not override it. For variants that compare numbers of sweeps.
  Variant& with_exactly(int count);
  /// Sets the index of the colour and marker. By default, a name has the same ones in all scenes.
  Variant& coloured(int which);
  /// Sets the closed-form value of the number `number`, which is shown with it.
  Variant& expect(const std::string& number, Real value);
  /// Adds a curve over time (s) that the scene's first series should follow.
  Variant& reference(const std::string& label, std::function<Real(Real)> of_time);
  /// Omits its curves, because they would coincide with another variant's.
  Variant& without_curves();
};

/// A command of an experiment's own that uses its scenes. argv[0] is the program's name and the flag. Returns the exit status.
using SceneCommand = std::function<int(const std::vector<Scene>& scenes, int argc, const char* const* argv)>;

class Experiment {
 public:
  /// `name`: of the folder and the program. `question`: the heading of the sheet.
  Experiment(std::string name, std::string question);

  /// Adds a parameter to the ones that every experiment has, see parameter.h.
  void parameter(const Parameter& parameter, ParameterVariable variable);
  /// The added parameters, in the order in which they were added.
  const std::vector<ParameterWithDefault>& parameters() const;

  /// Adds a command. If the first argument is `flag`, `run` only calls `act` with the arguments after it, and parameters keep their
  /// defaults. --help prints `what`.
  void command(const std::string& flag, const std::string& what, SceneCommand act);

  // ---- to be called inside `run`'s `define` --------------------------------------------------------------------------

  /// Begins a scene, to which the calls up to the next scene apply.
  void scene(Scene scene);
  /// Adds a solver that plays the latest scene: any solver that World::step takes.
  Variant& variant(const std::string& name, AnySolver solver);
  /// Adds a variant that moves the bodies of the latest scene without a solver. A copy of `step` plays the scene.
  Variant& motion(const std::string& name, CustomStep step);
  /// Adds a quantity of the latest scene that is recorded after every step and plotted against time. References are drawn with
  /// the first quantity. For a scene without any, the deepest overlap is plotted. `log_y`: see Panel.
  void series(const std::string& name, const std::string& unit, std::function<Real(const World&)> of,
              bool log_y = false);
  /// The same for a quantity that is recorded for the numbers and metrics.csv, but not plotted.
  void series_without_curves(const std::string& name, std::function<Real(const World&)> of);
  /// Adds a number that is shown with each variant of the latest scene. It must not come from a clock, because files that git
  /// tracks would change with every run.
  void number(const std::string& name, const std::string& unit, std::function<Real(const Run&)> of);
  /// Adds computations of the experiment itself. `work` is called after all variants have been played, and calls `panel` and `remark`.
  void study(std::function<void()> work);
  /// Adds a diagram after the diagrams of the scenes.
  void panel(Panel panel);
  /// Adds the problem of a step, which an interactive page solves iteration by iteration (iterated_problem.h) and makes on demand.
  void iterations(const std::string& of, std::function<IteratedProblem()> make);
  /// Adds a step, which an interactive page solves row by row (row_by_row.h) and makes on demand.
  void rows(const std::string& of, std::function<RowByRow()> make);
  /// Adds a finding that concerns no single variant. It is printed below the tables of numbers.
  void remark(std::string sentence);

  // ---------------------------------------------------------------------------------------------------------------------

  /// Reads the command line, calls `define`, and plays the experiment. Returns the program's exit status: 0; 2 after a message if
  /// a value cannot be used (values are checked before anything is written); 1 after a message about any other error.
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
  struct SceneRecord {
    Scene scene;
    std::vector<Quantity> series;
    std::vector<Number> numbers;
  };
  struct Command {
    std::string flag, what;
    SceneCommand act;
  };
  template <class Made>
  struct Named {
    std::string name;
    std::function<Made()> make;
  };
  struct Result;
  class Output;
  class Shots;
  class Played;
  friend class Live;  // plays the same experiment in a page: common/live/

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
  std::string sheet_file(std::size_t index) const;
  bool is_first_with_pictures(std::size_t index) const;
  std::string frames_folder(const Variant& variant) const;
  void make_films(const std::filesystem::path& folder) const;
  std::string how_solved(std::size_t index) const;
  std::optional<Sheet> sheet_of(std::size_t index, std::vector<Result>& results) const;
  std::size_t steps_of(const Scene& scene) const;
  int sweeps_of(const Variant& variant) const;
  std::string shown_name(const Variant& variant) const;

  std::string name_, question_;
  std::vector<ParameterWithDefault> parameters_;
  std::vector<Command> commands_;
  std::vector<SceneRecord> scene_records_;
  std::deque<Variant> variants_;  // not a vector, because `variant` returns references
  std::vector<Panel> own_panels_;
  std::vector<std::string> remarks_;
  std::vector<std::function<void()>> studies_;
  std::vector<Named<IteratedProblem>> problems_;
  std::vector<Named<RowByRow>> rows_;

  std::string out_ = "renders", size_ = "640x360";
  int width_ = 0, height_ = 0;
  Real seconds_ = 0, dt_ = Real(1) / 60;
  int frames_ = 0, sweeps_ = 10, passes_ = 16;
  std::set<std::string> told_;  ///< the flags that were given
  std::string film_;            ///< file extension of the films; empty: none
  std::vector<std::string> only_;
  std::string mine_;  ///< shared object with a further solver; empty: none
  bool no_images_ = false, no_study_ = false, first_scene_ = false, list_ = false, list_parameters_ = false;
};

}  // namespace pushback
