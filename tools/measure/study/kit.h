/// Plain questions to an engine, and what it does instead of the answer: what an adapter gets wrong.
#pragma once

#include <string>
#include <vector>

#include "pushback/tools/measure/study/play.h"

namespace pushback {

struct Finding {
  enum Is { right, wrong, not_played };
  std::string about;  ///< "friction"
  Is is;
  std::string says;  ///< what was measured, beside what was asked; and where it is wrong, what that looks like
};

/// Thirteen small motions in 16 substeps of a frame, and 32 sweeps where sweeps are a knob: where bodies are, gravity, damping, turning,
/// inertia, gyroscopic torque, friction, restitution, sleep, margins, pairs that are pinned, the same bits twice, its clock. What a right engine
/// leaves by its step is allowed; what its law leaves is not, so an engine can be told what it is known for.
std::vector<Finding> findings_of(const Method& method);

/// "16 substeps of 1/60 s, of 32 sweeps each"
std::string kit_setting(const Method& method);

}  // namespace pushback
