#include "tests/hard_cases/hard_case.h"

#include <chrono>
#include <cmath>
#include <limits>

#include "common/input.h"
#include "tests/hard_cases/cases.h"

namespace pushback {

Play::Play(Trial& trial, World start, const Allowance& allowance, bool doubled)
    : world(std::move(start)),
      trial_(&trial),
      stepper_(doubled ? trial.stage_->begin_doubled() : trial.stage_->begin()),
      watcher_(world, allowance) {}

void Play::step(Real dt) {
  if (!sound_) return;
  std::string said;
  const auto begin = std::chrono::steady_clock::now();
  try {
    stepper_(world, dt);
  } catch (const InvalidInput& refused) {  // joints; or between two small steps, a number was no longer finite
    sound_ = false;
    said = refused.what();
  }
  trial_->seconds_ += std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  ++trial_->steps_;
  watcher_.look(world, dt, trial_->stage_->small_steps);
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

Play Trial::play(const std::function<void(World&)>& fill, const std::function<Allowance(const World&)>& allowance_of) {
  World start;
  fill(start);
  const Allowance allowance = allowance_of(start);
  return {*this, std::move(start), allowance, false};
}

Play Trial::play(const std::function<void(World&)>& fill, const Allowance& allowance) {
  return play(fill, [&allowance](const World&) { return allowance; });
}

Play Trial::play_doubled(const std::function<void(World&)>& fill,
                         const std::function<Allowance(const World&)>& allowance_of) {
  World start;
  fill(start);
  const Allowance allowance = allowance_of(start);
  return {*this, std::move(start), allowance, true};
}

bool Outcome::passed(const HardCase& of) const {
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    if (!(numbers[i] <= of.criteria[i].limit)) return false;
  }
  return broken.empty();
}

std::size_t Outcome::worst(const HardCase& of) const {
  std::size_t worst = 0;
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    if (std::isnan(numbers[i])) return i;
    if (numbers[i] * of.criteria[worst].limit > numbers[worst] * of.criteria[i].limit) worst = i;
  }
  return worst;
}

Outcome outcome_of(const HardCase& hard_case, const Stage& stage) {
  Trial trial(stage);
  Outcome outcome;
  outcome.numbers = hard_case.run(trial);
  if (!trial.sound()) outcome.numbers.assign(hard_case.criteria.size(), std::numeric_limits<Real>::quiet_NaN());
  outcome.broken = trial.broken();
  outcome.ms_per_step = trial.ms_per_step();
  return outcome;
}

const std::vector<HardCase>& hard_cases() {
  static const std::vector<HardCase> all = [] {
    std::vector<HardCase> list;
    for (auto&& group : {stack_cases(), pile_cases(), stone_cases(), friction_cases(), bounce_cases(), impact_cases(),
                         scale_cases(), step_cases(), joint_cases()})
      list.insert(list.end(), group.begin(), group.end());
    return list;
  }();
  return all;
}

const HardCase& hard_case_named(const std::string& name) {
  std::string names;
  for (const HardCase& hard_case : hard_cases()) {
    if (hard_case.name == name) return hard_case;
    names += (names.empty() ? "" : ", ") + hard_case.name;
  }
  throw InvalidInput(fmt::format("hard case is '{}': one of these is needed: {}", name, names));
}

}  // namespace pushback
