#include "pushback/common/live/live.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <stdexcept>

#include "pushback/common/basics/files.h"
#include "pushback/common/basics/input.h"
#include "pushback/common/experiment/picture_of.h"
#include "pushback/common/experiment/words.h"
#include "pushback/common/live/track.h"
#include "pushback/common/render/palette.h"

namespace pushback {

// ---- parameters --------------------------------------------------------------------------------------------------------

namespace {

std::vector<std::string> split(const std::string& text, char at) {
  std::vector<std::string> parts;
  for (std::size_t from = 0; from < text.size();) {
    const std::size_t to = std::min(text.find(at, from), text.size());
    parts.push_back(text.substr(from, to - from));
    from = to + 1;
  }
  return parts;
}

double number_in(const ParameterWithDefault& which, const std::string& text) {
  const Parameter& told = which.parameter;
  char* end = nullptr;
  const double number = std::strtod(text.c_str(), &end);
  if (text.empty() || *end != '\0' || !(number >= told.least && number <= told.most) ||
      (which.whole && number != std::floor(number))) {
    throw InvalidInput(fmt::format("{}: '{}' is not allowed: a {} from {} to {} is needed", told.flag, text,
                                   which.whole ? "whole number" : "number", told.least, told.most));
  }
  return number;
}

struct Assign {
  const std::vector<double>& values;

  template <class Number>
  void operator()(Number* to) const {
    *to = static_cast<Number>(values.front());
  }
  template <class Number>
  void operator()(std::vector<Number>* to) const {
    to->clear();
    for (const double value : values) to->push_back(static_cast<Number>(value));
  }
};

struct Values {
  template <class Number>
  std::vector<double> operator()(const Number* of) const {
    return {static_cast<double>(*of)};
  }
  template <class Number>
  std::vector<double> operator()(const std::vector<Number>* of) const {
    return {of->begin(), of->end()};
  }
};

bool is_list(const ParameterWithDefault& which) {
  return which.variable.index() >= 2;
}

}  // namespace

Live::Live(Experiment& experiment, std::function<void()> define, std::size_t bytes)
    : experiment_(experiment), define_(std::move(define)), bytes_(bytes), parameters_(experiment.parameters()) {
  const auto common = [this](const Parameter& parameter, double value, bool whole, ParameterVariable variable) {
    parameters_.push_back({parameter, {value}, whole, variable});
  };
  common({"--sweeps", "", "", "Sweeps per step, in every variant", 1, 200}, experiment.sweeps_, true,
         &experiment.sweeps_);
  common({"--dt", "h", "s", "Time step", 0.001, 0.1}, static_cast<double>(experiment.dt_), false, &experiment.dt_);
  common({"--seconds", "", "s", "Simulated time", 0.1, 120}, 0, false, &experiment.seconds_);
  experiment_.describe(define_);
  begin();
}

Live::~Live() = default;

std::string Live::parameters() const {
  return in_json(parameters_);
}

std::string Live::values() const {
  std::vector<std::string> all;
  for (const ParameterWithDefault& each : parameters_) {
    const std::string& flag = each.parameter.flag;
    const bool follows = (flag == "--sweeps" || flag == "--seconds") && !experiment_.told_.contains(flag);
    all.push_back(fmt::format("{}: [{}]", pushback::quoted(flag),
                              follows ? "" : fmt::format("{}", fmt::join(std::visit(Values{}, each.variable), ", "))));
  }
  return fmt::format("{{{}}}", fmt::join(all, ", "));
}

const ParameterWithDefault& Live::parameter(const std::string& flag) const {
  for (const ParameterWithDefault& each : parameters_)
    if (each.parameter.flag == flag) return each;
  throw InvalidInput(fmt::format("there is no parameter '{}'", flag));
}

void Live::set(const std::string& assignments) {
  std::vector<std::vector<double>> before, after;
  for (const ParameterWithDefault& each : parameters_) {
    before.push_back(std::visit(Values{}, each.variable));
    after.push_back(each.defaults);
  }
  std::set<std::string> told;
  for (const std::string& assignment : split(assignments, ';')) {
    const std::size_t equals = std::min(assignment.find('='), assignment.size());
    const std::string flag = assignment.substr(0, equals);
    const ParameterWithDefault& which = parameter(flag);
    std::vector<double> values;
    for (const std::string& word : split(assignment.substr(std::min(equals + 1, assignment.size())), ','))
      values.push_back(number_in(which, word));
    if (values.empty() || (values.size() > 1 && !is_list(which)))
      throw InvalidInput(fmt::format("{}: {} is needed", flag, is_list(which) ? "at least one number" : "one number"));
    after[static_cast<std::size_t>(&which - parameters_.data())] = values;
    told.insert(flag);
  }
  const auto take = [this](const std::vector<std::vector<double>>& values) {
    for (std::size_t i = 0; i < parameters_.size(); ++i) std::visit(Assign{values[i]}, parameters_[i].variable);
  };
  tracks_.clear();  // they refer to the old description
  iterated_.reset();
  take(after);
  experiment_.told_.swap(told);
  try {
    experiment_.describe(define_);
    begin();
  } catch (const InvalidInput&) {
    tracks_.clear();
    take(before);
    experiment_.told_.swap(told);
    experiment_.describe(define_);
    begin();
    throw;
  }
}

std::vector<const Variant*> Live::variants_of(std::size_t scene) const {
  std::vector<const Variant*> all;
  for (const Variant& variant : experiment_.variants_)
    if (variant.scene == scene) all.push_back(&variant);
  return all;
}

void Live::choose(std::size_t scene, std::vector<std::size_t> variants) {
  if (scene >= experiment_.scene_records_.size())
    throw InvalidInput(fmt::format("scene {}: there are {}, the first is 0", scene, experiment_.scene_records_.size()));
  if (variants_of(scene).empty())
    throw InvalidInput(
        fmt::format("'{}' has no variant with these parameters", experiment_.scene_records_[scene].scene.name));
  scene_ = scene;
  chosen_ = std::move(variants);
  begin();
}

void Live::begin() {
  tracks_.clear();
  hand_.clear();
  held_.reset();
  now_ = until_ = 0;
  scene_ = std::min(scene_, experiment_.scene_records_.size() - 1);
  if (variants_of(scene_).empty()) scene_ = experiment_.variants_.at(0).scene;
  const std::vector<const Variant*> here = variants_of(scene_);
  std::erase_if(chosen_, [&](std::size_t place) { return place >= here.size(); });
  std::sort(chosen_.begin(), chosen_.end());
  chosen_.erase(std::unique(chosen_.begin(), chosen_.end()), chosen_.end());
  if (chosen_.empty()) chosen_ = {0};
  if (chosen_.size() > most_lanes) chosen_.resize(most_lanes);
  for (const std::size_t place : chosen_) {
    World probe;
    experiment_.fill(probe, *here[place]);
    here[place]->check(probe, experiment_.dt_);
  }
  for (const std::size_t place : chosen_)
    tracks_.emplace_back(experiment_, experiment_.scene_records_[scene_], *here[place], bytes_ / chosen_.size());
}

// ---- time --------------------------------------------------------------------------------------------------------------

std::size_t Live::steps() const {
  return std::max(until_, experiment_.steps_of(experiment_.scene_records_[scene_].scene));
}

std::size_t Live::tracks() const {
  return tracks_.size();
}

std::size_t Live::known() const {
  return hand_.size();
}

void Live::go_to(std::size_t step) {
  step = std::min(step, steps());
  if (hand_.size() < step) hand_.resize(step, held_);
  for (Track& track : tracks_) track.go_to(step, hand_);
  now_ = step;
}

// ---- the hand ----------------------------------------------------------------------------------------------------------

Ray Live::ray(const Camera& camera, Real aspect, Real x, Real y) const {
  const Vec3 ahead = (camera.target - camera.eye).normalized();
  const Vec3 right = ahead.cross(Vec3::UnitY()).normalized();
  const Real half = std::tan(camera.field_of_view / 2);
  return {.origin = camera.eye - shift(), .direction = ahead + half * (aspect * x * right + y * right.cross(ahead))};
}

bool Live::grab_at(std::size_t track, const Camera& camera, Real aspect, Real x, Real y) {
  const Scene& scene = experiment_.scene_records_[scene_].scene;
  const Track& in = tracks_[track];
  const World drawn = scene.magnified == 1 ? in.world() : magnified(in.world(), in.start(), scene.magnified);
  std::optional<Grab> found = grab(drawn, ray(camera, aspect, x, y));
  if (!found) return false;
  if (scene.magnified != 1) found->hand = point_of(in.world().bodies[found->body], found->on_body);
  hand_.resize(now_);
  for (Track& each : tracks_) each.forget_after(now_);
  held_ = found;
  constexpr Real time_to_see_it = 5;  // s
  until_ = std::max(until_, now_ + static_cast<std::size_t>(std::lround(time_to_see_it / experiment_.dt_)));
  return true;
}

void Live::pull_to(const Camera& camera, Real aspect, Real x, Real y) {
  if (!held_) return;
  const Ray towards = ray(camera, aspect, x, y);
  const Vec3 ahead = (camera.target - camera.eye).normalized();
  const Real depth = (held_->hand - towards.origin).dot(ahead);
  held_->hand = towards.origin + depth / towards.direction.dot(ahead) * towards.direction;
}

Body Live::displaced(const Vec3& way) const {
  const std::vector<Body>& bodies = tracks_[0].start().bodies;
  Body first = *std::find_if(bodies.begin(), bodies.end(), [](const Body& body) { return body.movable(); });
  first.position += way + shift();
  return first;
}

Real Live::way_to(const Vec3& axis, const Camera& camera, Real aspect, Real x, Real y) const {
  const Ray seen = ray(camera, aspect, x, y);
  const Vec3 ahead = seen.direction.normalized(), from = seen.origin + shift() - displaced(Vec3::Zero()).position;
  const Real aligned = axis.dot(ahead);
  return (axis.dot(from) - aligned * ahead.dot(from)) / (1 - aligned * aligned);
}

void Live::let_go() {
  held_.reset();
}

// ---- a problem ---------------------------------------------------------------------------------------------------------

void Live::hold(std::size_t problem) {
  if (problem >= experiment_.problems_.size())
    throw InvalidInput(fmt::format("problem {}: there are {}, the first is 0", problem, experiment_.problems_.size()));
  iterated_.emplace(experiment_.problems_[problem].make());
}

// ---- results and pictures ----------------------------------------------------------------------------------------------

const World& Live::world(std::size_t track) const {
  return tracks_[track].world();
}

const std::vector<Sample>& Live::samples(std::size_t track) const {
  return tracks_[track].samples();
}

const std::string& Live::mishap(std::size_t track) const {
  return tracks_[track].mishap();
}

const std::vector<Real>& Live::series(std::size_t track, std::size_t which) const {
  return tracks_[track].series().at(which);
}

const std::vector<std::vector<int>>& Live::raster(std::size_t track) const {
  return tracks_[track].raster();
}

std::vector<Real> Live::reference(std::size_t track, std::size_t which) const {
  const Reference& reference = tracks_[track].variant().references.at(which);
  std::vector<Real> values;
  for (std::size_t step = 1; step <= steps(); ++step)
    values.push_back(reference.of_time(static_cast<Real>(step) * experiment_.dt_));
  return values;
}

Real Live::number(std::size_t track, std::size_t which) const {
  if (tracks_[track].at() == 0 || !mishap(track).empty()) return std::numeric_limits<Real>::quiet_NaN();
  try {
    return experiment_.scene_records_[scene_].numbers.at(which).of(tracks_[track].run());
  } catch (const std::out_of_range&) {  // it needs steps that have not been played yet
    return std::numeric_limits<Real>::quiet_NaN();
  }
}

std::pair<std::string, std::string> Live::number_in_words(std::size_t track, std::size_t which) const {
  const Experiment::Number& number = experiment_.scene_records_[scene_].numbers.at(which);
  const auto& expected = tracks_[track].variant().expected;
  const auto should = expected.find(number.name);
  return {in_words(this->number(track, which), number.unit),
          should == expected.end() ? "" : in_words(should->second, number.unit)};
}

namespace {

/// The arrow length for 1 N s, m; 0: only points; none: no contacts.
std::optional<Real> arrow_of(const Scene& scene, const World& start, Real dt, const Shown& shown) {
  if (shown.impulses || shown.lit == Lit::impulses) return scene.arrow > 0 ? scene.arrow : fitting_arrow(start, dt);
  return shown.points ? std::optional<Real>(0) : std::nullopt;
}

/// The distance from the centre of mass to the farthest point, m.
struct Farthest {
  Real operator()(const Sphere& ball) const { return ball.radius; }
  Real operator()(const Box& box) const { return box.half_extents.norm(); }
  Real operator()(const Capsule& capsule) const { return capsule.radius + capsule.half_length; }
  Real operator()(const HalfSpace&) const { return 0; }
  Real operator()(const Hull& hull) const {
    Real farthest = 0;
    for (const Vec3& corner : hull.solid->corners) farthest = std::max(farthest, corner.norm());
    return farthest;
  }
};

}  // namespace

std::pair<Vec3, Real> Live::reach() const {
  Eigen::AlignedBox<Real, 3> around;
  const World &start = tracks_[0].start(), &now = tracks_[0].world();
  Vec3 moved = Vec3::Zero();
  Real movable = 0;
  for (const Body& body : start.bodies) {
    if (!body.movable()) continue;
    moved += now.bodies[static_cast<std::size_t>(body.index)].position - body.position;
    ++movable;
    const Vec3 farthest = Vec3::Constant(std::visit(Farthest{}, body.shape));
    around.extend(Vec3(body.position - farthest));
    around.extend(Vec3(body.position + farthest));
  }
  if (around.isEmpty()) return {Vec3::Zero(), Real(1)};
  const Vec3 middle = around.center();
  around.extend(Vec3(middle.x(), std::min(middle.y(), Real(0)), middle.z()));
  moved.y() = 0;
  return {Vec3(around.center() + moved / movable), around.diagonal().norm() / 2};
}

Vec3 Live::shift() const {
  const std::optional<Strobe>& strobe = experiment_.scene_records_[scene_].scene.strobe;
  if (!strobe) return Vec3::Zero();
  const Real time = static_cast<Real>(now_) * experiment_.dt_;
  return std::max(Real(0), (strobe->until > 0 ? std::min(time, strobe->until) : time) - strobe->from) *
         strobe->shift_per_second;
}

Picture Live::picture(std::size_t track, const Camera& camera, const Shown& shown) const {
  const Scene& scene = experiment_.scene_records_[scene_].scene;
  const Track& of = tracks_[track];
  const auto as_drawn = [&](const World& world) {
    return scene.magnified == 1 ? world : magnified(world, of.start(), scene.magnified);
  };
  const std::optional<Real> arrow = arrow_of(scene, of.start(), experiment_.dt_, shown);
  const World now = as_drawn(of.world());
  Real time = static_cast<Real>(of.at()) * experiment_.dt_;
  Picture made;
  if (scene.strobe) {
    const Strobe& strobe = *scene.strobe;
    World fixed = now;
    std::erase_if(fixed.bodies, [](const Body& body) { return body.movable(); });
    fixed.contacts.clear();
    fixed.joints.clear();
    made = picture_of(fixed, camera, {});
    const auto marks = shown.marks ? strobe.marks : nullptr;
    for (const auto& [step, world] : of.instants()) {
      if (step >= of.at()) break;
      const Real then = static_cast<Real>(step) * experiment_.dt_ - strobe.from;
      add_moving(made, as_drawn(world), arrow, then * strobe.shift_per_second, marks);
    }
    add_moving(made, now, arrow, shift(), marks);
    if (strobe.until > 0) time = std::min(time, strobe.until);
  } else {
    made = picture_of(now, camera, arrow);
  }
  if (shown.marks && scene.marks) scene.marks(made, now, time);
  if (!shown.points) made.dots.clear();
  light(made, now, shift(), shown.lit);
  if (held_) {
    const Vec3 point = point_of(now.bodies[held_->body], held_->on_body) + shift(), hand = held_->hand + shift();
    constexpr Real pixels = 3;
    made.lines.push_back({point, hand, pixels / 281 * camera.height_at(point), near_black_colour()});
    made.dots.push_back({hand, Real(0.012) * camera.height_at(hand), near_black_colour()});
  }
  return made;
}

}  // namespace pushback
