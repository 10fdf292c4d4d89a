/// Another engine plays motions. Each engine's source defines this, and a program is linked with one of them.
#pragma once

#include "pushback/tools/measure/hard_cases/peers.h"
#include "pushback/tools/measure/study/play.h"

namespace pushback {

/// The engine, in the ways in which it is played. Friction and restitution of a motion's bodies become those of each pair.
std::vector<Method> peer_methods();

/// The settings in which it may play hard cases.
std::vector<PeerSetting> settings_of_peer();

/// Its name, its version, and what it says of how it was built.
std::string peer_version();

}  // namespace pushback
