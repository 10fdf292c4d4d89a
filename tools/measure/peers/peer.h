/// What each engine's source defines; a program is linked with one of them.
#pragma once

#include "pushback/tools/measure/peers/engine.h"
#include "pushback/tools/measure/peers/joint_shape.h"
#include "pushback/tools/measure/results/built_by.h"
#include "pushback/tools/measure/study/every_motion.h"

namespace pushback {

/// The engine, in the ways in which it plays motions.
std::vector<Method> peer_methods();

/// For methods that solve all rows at once, in a dense matrix: those of a thousand bodies at rest would take 14 GB.
inline bool few_bodies(const Motion& motion) {
  return moving_bodies(motion) <= 200;
}

/// The settings in which it may play hard cases.
std::vector<PeerSetting> settings_of_peer();

/// With the world of a hard case in it. Throws not_had where the engine lacks something that is in the world.
BeginEngine begin_engine;

/// Its name, its version, and what it says of how it was built.
std::string peer_version();

}  // namespace pushback
