/// A variant of an experiment as it is at an instant.
#pragma once

#include "pushback/common/experiment/experiment.h"

namespace pushback {

/// A value: a copy goes on as the original would, to the last bit. It refers to the experiment and its variant.
class Experiment::Played {
 public:
  Played(const Experiment& of, const Variant& variant);

  /// Moves on by one step of --dt, and says what it has come to. Throws InvalidInput where
  /// the state is none that can be simulated.
  Sample step();

  World world;

 private:
  const Experiment* experiment_;
  const Variant* variant_;
  std::optional<AnySolver> solver_;         // a copy: its memory starts empty
  CustomStep motion_;                       // likewise
  std::vector<ContactId> contacts_before_;  // of the step before, not of the substep
  std::size_t steps_ = 0;
};

}  // namespace pushback
