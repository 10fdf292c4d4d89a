/// An engine that is a program of somebody else's, asked through a pipe. docs/benchmark.md says what is asked, and what is to be
/// answered.
#pragma once

#include <filesystem>

#include "pushback/common/basics/conversation.h"
#include "pushback/tools/measure/adapters/scene_json.h"
#include "pushback/tools/measure/hard_cases/peers.h"

namespace pushback {

/// How an adapter is called: "node FILE" for .mjs and .js, "python3 FILE" for .py, and FILE by itself where it can be executed.
/// Throws InvalidInput where there is no such file, or it is none of these.
std::vector<std::string> command_of_adapter(const std::filesystem::path& file);

class Adapter {
 public:
  /// Starts it, and asks which settings it has. Throws std::runtime_error where it answers wrongly, here and below, with what was asked
  /// and what is needed.
  explicit Adapter(const std::filesystem::path& file);

  const std::string& engine() const { return engine_; }  ///< "Rapier 0.21.0"
  const std::vector<PeerSetting>& settings() const { return settings_; }
  /// Whether the number of sweeps means something to the setting.
  bool sweeps(const std::string& setting) const;

  /// The world becomes the engine's, and what was in it before is gone. Nothing where it plays it; else what it lacks.
  std::string open(const std::string& setting, int substeps, int sweeps, Real dt, const World& world);

  struct Moved {
    double seconds = 0;        ///< of its own clock
    std::vector<Body> bodies;  ///< position, orientation, velocities, index: of the movable
  };
  /// `steps` steps of h, s. `changed`: bodies that others have moved, and those that nothing moves but their velocity. `pushed`: those
  /// whose force or torque is not 0. 0 steps: only where bodies are.
  Moved step(int steps, Real h, const std::vector<Body>& changed = {}, const std::vector<Body>& pushed = {});

 private:
  Json ask(const Json& question);

  Conversation conversation_;
  std::string engine_;
  std::vector<PeerSetting> settings_;
  std::vector<bool> sweeps_;
  std::size_t bodies_ = 0;  // of the world that is open
};

/// That of PUSHBACK_ADAPTER in the environment, started once. Throws InvalidInput where there is none.
Adapter& the_adapter();

}  // namespace pushback
