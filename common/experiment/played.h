/// The state of an experiment's variant at an instant.
#pragma once

#include "pushback/common/experiment/experiment.h"

namespace pushback {

/// A copy continues as the original would, to the last bit. It refers to the experiment and its variant.
class Experiment::Played {
 public:
  Played(const Experiment& of, const Variant& variant);

  /// Advances by one step of --dt and returns the sample after it. Throws InvalidInput if the state cannot be simulated.
  Sample step();

  World world;

 private:
  const Experiment* experiment_;
  const Variant* variant_;
  std::optional<AnySolver> solver_;         // a copy, so its memory starts empty
  CustomStep motion_;                       // likewise
  std::vector<ContactId> contacts_before_;  // of the previous step, not of the previous substep
  std::size_t steps_ = 0;
};

}  // namespace pushback
