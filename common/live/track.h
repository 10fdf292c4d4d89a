/// The states of one variant over time. Only common/live/*.cpp need it.
#pragma once

#include <map>

#include "pushback/common/experiment/played.h"
#include "pushback/common/live/live.h"

namespace pushback {

class Live::Track {
 public:
  using Hand = std::vector<std::optional<Grab>>;

  Track(const Experiment& of, const Experiment::SceneRecord& record, const Variant& variant, std::size_t bytes);

  /// Goes to a step. `hand`: the hand's grip in each step.
  void go_to(std::size_t step, const Hand& hand);
  void forget_after(std::size_t step);

  const Variant& variant() const { return *variant_; }
  const World& start() const { return kept_.at(0).world; }
  const World& world() const { return played_.world; }
  std::size_t at() const { return at_; }
  const std::vector<Sample>& samples() const { return samples_; }
  const std::vector<std::vector<Real>>& series() const { return series_; }
  const std::vector<std::vector<int>>& raster() const { return raster_; }
  const std::map<std::size_t, World>& instants() const { return instants_; }
  const std::string& mishap() const { return mishap_; }
  /// The run up to the current step.
  Run run() const;

 private:
  void advance(const Hand& hand);
  void rewind(std::size_t step);
  void record(const Sample& sample);
  void keep();

  const Experiment* experiment_;
  const Experiment::SceneRecord* record_;
  const Variant* variant_;
  std::size_t bytes_;
  Experiment::Played played_;
  std::size_t forces_;  // number of the scene's own forces
  std::size_t at_ = 0;
  // The states at every kept_every_-th step. The interval doubles whenever they take too much memory. Other states are played again
  // from the kept state before them.
  std::map<std::size_t, Experiment::Played> kept_;
  std::size_t kept_every_ = 1;
  std::map<std::size_t, World> instants_;  // of a strobe scene
  std::vector<Sample> samples_;
  std::vector<std::vector<Real>> series_;
  std::vector<std::vector<int>> raster_;
  std::string mishap_;
};

}  // namespace pushback
