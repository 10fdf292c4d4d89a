/// An external program that simulates with its own engine and is controlled through a pipe. docs/benchmark.md specifies the requests
/// and the answers.
#pragma once

#include <filesystem>

#include "pushback/common/basics/conversation.h"
#include "pushback/tools/measure/adapters/scene_json.h"
#include "pushback/tools/measure/hard_cases/peers.h"

namespace pushback {

/// The command that starts an adapter, which is "node FILE" for .mjs and .js, "python3 FILE" for .py, and FILE if it is executable.
/// Throws InvalidInput if there is no such file, or if it is none of these.
std::vector<std::string> command_of_adapter(const std::filesystem::path& file);

class Adapter {
 public:
  /// Starts the program and requests its settings. This and the functions below throw std::runtime_error, with the request and the
  /// required answer, if an answer is invalid.
  explicit Adapter(const std::filesystem::path& file);

  const std::string& engine() const { return engine_; }  ///< "Rapier 0.21.0"
  const std::vector<PeerSetting>& settings() const { return settings_; }
  /// Whether the setting uses the number of sweeps.
  bool sweeps(const std::string& setting) const;

  /// Replaces the engine's world by this one. Returns an empty text, or the feature that the engine lacks for this world.
  std::string open(const std::string& setting, int substeps, int sweeps, Real dt, const World& world);

  struct Moved {
    double seconds = 0;        ///< measured by the program's own clock
    std::vector<Body> bodies;  ///< position, orientation, velocities and index of the movable bodies
  };
  /// Takes `steps` steps of h, s. With 0 steps it only returns the states of the bodies. `changed`: bodies that the caller has moved, and
  /// immovable bodies with a velocity. `pushed`: bodies whose force or torque is not 0.
  Moved step(int steps, Real h, const std::vector<Body>& changed = {}, const std::vector<Body>& pushed = {});

 private:
  Json ask(const Json& question);

  Conversation conversation_;
  std::string engine_;
  std::vector<PeerSetting> settings_;
  std::vector<bool> sweeps_;
  std::size_t bodies_ = 0;  // number of bodies in the open world
};

/// The adapter in the environment variable PUSHBACK_ADAPTER, started once. Throws InvalidInput if the variable is not set.
Adapter& the_adapter();

}  // namespace pushback
