#include "pushback/common/experiment/experiment.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>

#include "pushback/common/basics/input.h"
#include "pushback/common/experiment/iterated_problem.h"
#include "pushback/common/experiment/row_by_row.h"
#include "pushback/common/experiment/words.h"

namespace pushback {

// ---- definition ------------------------------------------------------------------------------------------------------

Experiment::Experiment(std::string name, std::string question)
    : name_(std::move(name)), question_(std::move(question)) {}

namespace {

template <class Number>
std::vector<double> as_list(const Number& value) {
  return {static_cast<double>(value)};
}
template <class Number>
std::vector<double> as_list(const std::vector<Number>& values) {
  return {values.begin(), values.end()};
}

}  // namespace

void Experiment::parameter(const Parameter& parameter, ParameterVariable variable) {
  std::visit(
      [&](const auto* value) {
        using Held = std::decay_t<decltype(*value)>;
        constexpr bool whole = std::is_same_v<Held, int> || std::is_same_v<Held, std::vector<int>>;
        parameters_.push_back({parameter, as_list(*value), whole, variable});
      },
      variable);
}

const std::vector<ParameterWithDefault>& Experiment::parameters() const {
  return parameters_;
}

void Experiment::command(const std::string& flag, const std::string& what, SceneCommand act) {
  commands_.push_back({flag, what, std::move(act)});
}

std::vector<Sample> Run::last(Real seconds) const {
  const auto count = std::clamp<std::size_t>(static_cast<std::size_t>(std::lround(seconds / dt)), 1, samples.size());
  return {samples.end() - static_cast<std::ptrdiff_t>(count), samples.end()};
}

Real Run::largest(const std::string& name) const {
  const std::vector<Real>& values = series.at(name);
  return *std::max_element(values.begin(), values.end());
}

Real Run::mean(const std::string& name) const {
  const std::vector<Real>& values = series.at(name);
  return std::accumulate(values.begin(), values.end(), Real(0)) / static_cast<Real>(values.size());
}

Variant& Variant::with_sweeps(int count) {
  sweeps = count;
  return *this;
}

Plan Variant::plan(Real dt) const {
  return solver ? solver->plan(dt) : Plan{};
}

void Variant::check(World& world, Real dt) const {
  if (!checked) return;
  if (!solver) {
    motion(world, dt, 1);
    return;
  }
  AnySolver probe = *solver;
  check_solvable(world, probe);
  probe.check(world, dt / static_cast<Real>(probe.plan(dt).all_substeps()));
}

Variant& Variant::changing(std::function<void(World&)> how) {
  change = std::move(how);
  return *this;
}

Variant& Variant::with_exactly(int count) {
  sweeps = count;
  exactly = true;
  return *this;
}

Variant& Variant::coloured(int which) {
  colour = which;
  return *this;
}

Variant& Variant::expect(const std::string& number, Real value) {
  expected[number] = value;
  return *this;
}

Variant& Variant::reference(const std::string& label, std::function<Real(Real)> of_time) {
  references.push_back({label, std::move(of_time)});
  return *this;
}

Variant& Variant::without_curves() {
  curves = false;
  return *this;
}

void Experiment::scene(Scene scene) {
  scene_records_.push_back({std::move(scene), {}, {}});
}

void Experiment::series(const std::string& name, const std::string& unit, std::function<Real(const World&)> of,
                        bool log_y) {
  scene_records_.back().series.push_back({name, unit, std::move(of), log_y, true});
}

void Experiment::series_without_curves(const std::string& name, std::function<Real(const World&)> of) {
  scene_records_.back().series.push_back({name, "", std::move(of), false, false});
}

void Experiment::number(const std::string& name, const std::string& unit, std::function<Real(const Run&)> of) {
  scene_records_.back().numbers.push_back({name, unit, std::move(of)});
}

Variant& Experiment::add_variant(const std::string& name) {
  Variant& added = variants_.emplace_back();
  added.name = name;
  added.scene = scene_records_.size() - 1;
  return added;
}

Variant& Experiment::variant(const std::string& name, AnySolver solver) {
  Variant& added = add_variant(name);
  added.solver = std::move(solver);
  return added;
}

Variant& Experiment::motion(const std::string& name, CustomStep step) {
  Variant& added = add_variant(name);
  added.motion = std::move(step);
  return added;
}

void Experiment::study(std::function<void()> work) {
  studies_.push_back(std::move(work));
}

void Experiment::iterations(const std::string& of, std::function<IteratedProblem()> make) {
  problems_.push_back({of, std::move(make)});
}

void Experiment::rows(const std::string& of, std::function<RowByRow()> make) {
  rows_.push_back({of, std::move(make)});
}

void Experiment::panel(Panel panel) {
  own_panels_.push_back(std::move(panel));
}

void Experiment::remark(std::string sentence) {
  remarks_.push_back(std::move(sentence));
}

// ---- preparation -----------------------------------------------------------------------------------------------------

void Experiment::describe(const std::function<void()>& define, const AnySolver* one_more) {
  scene_records_.clear();
  variants_.clear();
  studies_.clear();
  problems_.clear();
  rows_.clear();
  define();
  if (one_more) add_to_all_scenes("mine", *one_more);
  refuse_twins();
  choose_colours();
}

std::size_t Experiment::steps_of(const Scene& scene) const {
  const Real seconds = seconds_ > 0 ? seconds_ : scene.seconds;
  return std::max<std::size_t>(1, static_cast<std::size_t>(std::lround(seconds / dt_)));
}

int Experiment::sweeps_of(const Variant& variant) const {
  if (variant.exactly) return variant.sweeps;
  if (told_.contains("--sweeps")) return sweeps_;
  if (variant.sweeps > 0) return variant.sweeps;
  return variant.solver ? variant.plan(dt_).sweeps : sweeps_;
}

namespace {

/// Detects contacts at least `detections` times per step, so that an added solver has half steps, too, if the scene has them.
class DetectingAsOften : public ForwardingSolver {
 public:
  DetectingAsOften(AnySolver solver, int detections) : solver_(std::move(solver)), detections_(detections) {}
  Plan plan(Real dt) const override {
    Plan plan = solver_.plan(dt);
    plan.detections = std::max(plan.detections, detections_);
    return plan;
  }

 private:
  StepSolver& inner() override { return solver_; }
  const StepSolver& inner() const override { return solver_; }
  AnySolver solver_;
  int detections_;
};

}  // namespace

/// Adds the solver after the last variant of each open scene, with that variant's sweeps, detections per step and changes to the scene.
void Experiment::add_to_all_scenes(const std::string& name, const AnySolver& solver) {
  std::deque<Variant> all;
  for (std::size_t index = 0; index < scene_records_.size(); ++index) {
    for (const Variant& variant : variants_)
      if (variant.scene == index) all.push_back(variant);
    if (!scene_records_[index].scene.open || all.empty() || all.back().scene != index) continue;
    Variant added = all.back();
    added.name = name;
    added.solver = DetectingAsOften(solver, added.solver ? added.plan(dt_).detections : 1);
    added.motion = {};
    added.checked = true;
    added.colour = -1;
    added.curves = true;
    added.expected.clear();
    added.references.clear();
    all.push_back(std::move(added));
  }
  variants_ = std::move(all);
}

/// Two variants with the same name would share a folder, and two scenes with the same key would share a sheet.
void Experiment::refuse_twins() const {
  for (std::size_t a = 0; a < scene_records_.size(); ++a) {
    for (std::size_t b = 0; b < a; ++b) {
      if (key_of(scene_records_[a].scene) == key_of(scene_records_[b].scene))
        throw InvalidInput(
            fmt::format("two scenes have the key '{}': each needs one of its own", key_of(scene_records_[a].scene)));
    }
  }
  for (auto one = variants_.begin(); one != variants_.end(); ++one) {
    for (auto other = variants_.begin(); other != one; ++other) {
      if (one->scene == other->scene && slug(one->name) == slug(other->name)) {
        throw InvalidInput(
            fmt::format("two variants are called '{}': each needs a name, and so a value, of its own", one->name));
      }
    }
  }
}

/// One colour per name, in order of appearance, in addition to the colours that variants were given.
void Experiment::choose_colours() {
  std::map<std::string, int> of_name;
  std::set<int> taken;
  for (const Variant& variant : variants_) {
    if (variant.colour < 0) continue;
    of_name.emplace(variant.name, variant.colour);
    taken.insert(variant.colour);
  }
  int next = 0;
  for (Variant& variant : variants_) {
    if (variant.colour >= 0) continue;
    while (taken.contains(next)) ++next;
    const auto [known, is_new] = of_name.emplace(variant.name, next);
    if (is_new) ++next;
    variant.colour = known->second;
  }
}

/// Throws InvalidInput if a value cannot be used, before anything is written.
void Experiment::check() const {
  for (const Variant& variant : variants_) {
    World world;
    fill(world, variant);
    variant.check(world, dt_);
  }
}

void Experiment::fill(World& world, const Variant& variant) const {
  scene_records_[variant.scene].scene.fill(world);
  if (variant.change) variant.change(world);
}

}  // namespace pushback
