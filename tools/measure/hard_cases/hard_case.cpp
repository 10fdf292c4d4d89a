#include "pushback/tools/measure/hard_cases/hard_case.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>

#include "pushback/common/basics/named.h"
#include "pushback/common/bodies/random.h"

namespace pushback {

Play::Play(Trial& trial, World start, const Allowance& allowance, Stepper stepper)
    : world(std::move(start)), trial_(&trial), stepper_(std::move(stepper)), watcher_(world, allowance) {}

void Play::step(Real dt) {
  if (!sound_) return;
  std::string said;
  const auto begin = std::chrono::steady_clock::now();
  try {
    stepper_.step(world, dt);
  } catch (const InvalidInput& refused) {  // joints; or between two substeps, a number was no longer finite
    sound_ = false;
    said = refused.what();
  }
  trial_->seconds_ += std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  ++trial_->steps_;
  watcher_.look(world, dt, trial_->stage_->substeps(dt), stepper_.half_steps);
  if (trial_->broken_.empty()) trial_->broken_ = watcher_.broken();
  if (trial_->broken_.empty() && !sound_) trial_->broken_ = said;
  for (const Body& body : world.bodies) sound_ = sound_ && body.position.allFinite() && body.velocity.allFinite();
  trial_->sound_ = trial_->sound_ && sound_;
}

void Play::run(Real seconds, Real dt, const std::function<void(World&)>& after_each) {
  const long steps = std::lround(seconds / dt);
  for (long i = 0; i < steps && sound_; ++i) {
    step(dt);
    if (after_each && sound_) after_each(world);
  }
}

Real Play::largest(Real seconds, const std::function<Real(const World&)>& of) {
  Real most = 0;
  run(seconds, Real(1) / 60, [&](const World& now) { most = std::max(most, of(now)); });
  return most;
}

Play Trial::play(const std::function<void(World&)>& fill, const AllowanceOf& allowance_of, GivenContacts given) {
  World world;
  fill(world);
  if (start_ > 0) {
    Random random(static_cast<std::uint64_t>(start_));
    for (Body& body : world.bodies)
      if (body.movable()) body.position += random.vector(nudge);
  }
  Allowance allowance = allowance_of(world);
  allowance.epsilon = stage_->epsilon;
  return {*this, std::move(world), allowance, stage_->begin(given)};
}

Play Trial::play(const std::function<void(World&)>& fill, const Allowance& allowance) {
  return play(fill, [&allowance](const World&) { return allowance; });
}

namespace {

bool within(const std::vector<Real>& numbers, const std::vector<Criterion>& criteria) {
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    if (!(numbers[i] <= criteria[i].limit)) return false;
  }
  return true;
}

/// What is no number is worse than any.
Real larger(Real p, Real q) {
  return std::isnan(p) || std::isnan(q) ? std::numeric_limits<Real>::quiet_NaN() : std::max(p, q);
}

}  // namespace

std::string Criterion::limit_with_unit() const {
  return fmt::format("{:g}{}{}", limit, unit.empty() ? "" : " ", unit);
}

std::string criteria_of(const HardCase& hard_case) {
  std::string text;
  for (const Criterion& one : hard_case.criteria)
    text += fmt::format("{}{} ≤ {}", text.empty() ? "" : "; ", one.what, one.limit_with_unit());
  return text;
}

bool Outcome::passed(const HardCase& of) const {
  return within(largest, of.criteria) && broken.empty();
}

std::size_t Outcome::worst(const HardCase& of) const {
  const auto part_of_limit = [&](std::size_t i) {
    if (of.criteria[i].limit > 0) return largest[i] / of.criteria[i].limit;
    return largest[i] > 0 ? std::numeric_limits<Real>::infinity() : 0;
  };
  std::size_t worst = 0;
  for (std::size_t i = 0; i < largest.size(); ++i) {
    if (std::isnan(largest[i])) return i;
    if (part_of_limit(i) > part_of_limit(worst)) worst = i;
  }
  return worst;
}

Outcome outcome_of(const HardCase& hard_case, const Stage& stage) {
  Outcome outcome;
  outcome.starts = std::min(hard_case.starts, stage.most_starts);
  double seconds = 0;
  int steps = 0;
  for (int start = 0; start < outcome.starts; ++start) {
    Trial trial(stage, start);
    std::vector<Real> numbers = hard_case.run(trial);
    if (!trial.sound()) numbers.assign(hard_case.criteria.size(), std::numeric_limits<Real>::quiet_NaN());
    if (trial.broken().empty() && within(numbers, hard_case.criteria)) ++outcome.starts_passed;
    if (outcome.broken.empty() && !trial.broken().empty())
      outcome.broken = (start > 0 ? fmt::format("start {}: ", start + 1) : "") + trial.broken();
    if (start == 0) outcome.numbers = outcome.largest = numbers;
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      outcome.largest[i] = larger(outcome.largest[i], numbers[i]);
    }
    seconds += trial.seconds();
    steps += trial.steps();
  }
  outcome.ms_per_step = steps > 0 ? 1000 * seconds / steps : 0;
  return outcome;
}

const std::vector<HardCase>& hard_cases() {
  static const std::vector<HardCase> all = [] {
    std::vector<HardCase> list;
    for (auto&& group : {stack_cases(), pile_cases(), stone_cases(), friction_cases(), bounce_cases(), impact_cases(),
                         guided_cases(), no_solution_cases(), scale_cases(), step_cases(), joint_cases(), ball_cases(),
                         edge_cases(), mechanism_cases()})
      list.insert(list.end(), group.begin(), group.end());
    for (HardCase& hard_case : list) hard_case.scene.name = hard_case.title;
    return list;
  }();
  return all;
}

const HardCase& hard_case_named(const std::string& name) {
  return named("hard case", hard_cases(), name);
}

}  // namespace pushback
