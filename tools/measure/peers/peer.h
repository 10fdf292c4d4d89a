/// The functions that the source file of each engine defines. A program is linked with one of these files.
#pragma once

#include "pushback/tools/measure/peers/engine.h"
#include "pushback/tools/measure/peers/joint_shape.h"
#include "pushback/tools/measure/results/built_by.h"
#include "pushback/tools/measure/study/every_motion.h"

namespace pushback {

/// The methods with which the engine plays motions.
std::vector<Method> peer_methods();

/// For methods that solve all rows at once in a dense matrix. The matrix of a thousand resting bodies would take 14 GB.
inline bool few_bodies(const Motion& motion) {
  return moving_bodies(motion) <= 200;
}

/// The settings in which the engine may play hard cases.
std::vector<PeerSetting> settings_of_peer();

/// Makes an engine with the world of a hard case. Throws not_had if the engine lacks a feature of the world.
BeginEngine begin_engine;

/// The engine's name, its version, and its build settings if it reports them.
std::string peer_version();

}  // namespace pushback
