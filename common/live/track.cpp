#include "pushback/common/live/track.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "pushback/common/basics/input.h"

namespace pushback {

namespace {

/// The approximate size of a kept state.
std::size_t bytes_of(const World& world, const std::vector<Sample>& samples) {
  constexpr std::size_t of_a_row = 600, of_a_joint = 300;
  const std::size_t rows = samples.empty() ? 0 : static_cast<std::size_t>(samples.back().rows);
  return world.bodies.size() * sizeof(Body) + (world.contacts.size() + world.contacts_before.size()) * sizeof(Contact) +
         world.joints.size() * (sizeof(Joint) + of_a_joint) + rows * of_a_row;
}

template <class Value>
void cut(std::vector<Value>& values, std::size_t count) {
  if (values.size() > count) values.erase(values.begin() + static_cast<std::ptrdiff_t>(count), values.end());
}

}  // namespace

Live::Track::Track(const Experiment& of, const Experiment::SceneRecord& record, const Variant& variant,
                   std::size_t bytes)
    : experiment_(&of),
      record_(&record),
      variant_(&variant),
      bytes_(bytes),
      played_(of, variant),
      forces_(played_.world.forces.size()),
      series_(std::max<std::size_t>(1, record.series.size())) {
  keep();
}

void Live::Track::keep() {
  if (record_->scene.strobe) {
    const Strobe& strobe = *record_->scene.strobe;
    const auto step_at = [&](Real time) { return static_cast<std::size_t>(std::lround(time / experiment_->dt_)); };
    const auto instant = std::lround((static_cast<Real>(at_) * experiment_->dt_ - strobe.from) / strobe.every);
    const Real time = strobe.from + static_cast<Real>(instant) * strobe.every;
    const bool wanted = instant >= 0 && (strobe.until == 0 || time <= strobe.until + experiment_->dt_ / 2);
    if (wanted && step_at(time) == at_) instants_.try_emplace(at_, played_.world);
  }
  if (at_ % kept_every_ != 0 || kept_.contains(at_)) return;
  kept_.emplace(at_, played_);
  if (kept_.size() < 3 || kept_.size() * bytes_of(played_.world, samples_) <= bytes_) return;
  kept_every_ *= 2;
  std::erase_if(kept_, [this](const auto& one) { return one.first % kept_every_ != 0; });
}

void Live::Track::rewind(std::size_t step) {
  const auto before = std::prev(kept_.upper_bound(step));
  played_ = before->second;
  at_ = before->first;
}

void Live::Track::go_to(std::size_t step, const Hand& hand) {
  if (!mishap_.empty()) step = std::min(step, samples_.size());
  const auto nearest = std::prev(kept_.upper_bound(step));
  if (step < at_ || nearest->first > at_) rewind(step);
  while (at_ < step && (mishap_.empty() || at_ < samples_.size())) advance(hand);
}

void Live::Track::advance(const Hand& hand) {
  played_.world.forces.resize(forces_);
  if (at_ < hand.size() && hand[at_]) {
    const Real dt = experiment_->dt_ / static_cast<Real>(variant_->plan(experiment_->dt_).all_substeps());
    played_.world.forces.push_back(pull_of(*hand[at_], dt));
  }
  try {
    const Sample sample = played_.step();
    ++at_;
    if (at_ > samples_.size()) record(sample);
  } catch (const InvalidInput& problem) {
    mishap_ = fmt::format("ended at {:.3g} s: {}", static_cast<double>(at_ + 1) * static_cast<double>(experiment_->dt_),
                          problem.what());
    go_to(samples_.size(), hand);  // some of the substeps may already be done
    return;
  }
  keep();
}

void Live::Track::record(const Sample& sample) {
  samples_.push_back(sample);
  for (std::size_t i = 0; i < record_->series.size(); ++i) series_[i].push_back(record_->series[i].of(played_.world));
  if (record_->series.empty()) series_[0].push_back(1000 * sample.overlap);
  if (record_->scene.raster) raster_.push_back(record_->scene.raster->of(played_.world));
}

void Live::Track::forget_after(std::size_t step) {
  if (at_ > step) rewind(step);
  kept_.erase(kept_.upper_bound(step), kept_.end());
  instants_.erase(instants_.upper_bound(step), instants_.end());
  cut(samples_, step);
  cut(raster_, step);
  for (std::vector<Real>& values : series_) cut(values, step);
  mishap_.clear();
}

Run Live::Track::run() const {
  Run run{world(), experiment_->dt_, samples_, {}};
  cut(run.samples, at_);
  for (std::size_t i = 0; i < record_->series.size(); ++i) {
    std::vector<Real>& values = run.series[record_->series[i].name];
    values = series_[i];
    cut(values, at_);
  }
  return run;
}

}  // namespace pushback
