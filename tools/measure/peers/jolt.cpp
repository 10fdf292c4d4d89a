/// Jolt plays motions.
#include "pushback/tools/measure/peers/jolt.h"

#include <fmt/format.h>

#include "pushback/tools/measure/peers/peer.h"

namespace pushback {

namespace {

class PlaysMotion : public PlayerInSubsteps {
 public:
  PlaysMotion(const Motion& motion, const Setting& setting, bool tuned) : h_(static_cast<float>(setting.dt())) {
    start_jolt();
    World world;
    motion.begin(world);
    jolt_.emplace(world, JoltChoice{.tuned = tuned, .sweeps = setting.sweeps});
  }
  void substep() override { jolt_->step(h_); }
  Eigen::Vector3d place(std::size_t body) const override { return jolt_->place(body); }

 private:
  float h_;
  std::optional<Jolt> jolt_;
};

Method method(const std::string& name, const std::string& title, bool tuned) {
  return {.name = name,
          .title = title,
          .plays = [](const Motion&) { return true; },
          .begin = [tuned](const Motion& motion, const Setting& setting) -> std::unique_ptr<Player> {
            return std::make_unique<PlaysMotion>(motion, setting, tuned);
          },
          .sweeps = tuned};
}

}  // namespace

std::vector<Method> peer_methods() {
  return {method("jolt", "Jolt, as it comes", false), method("jolt-tuned", "Jolt, tuned", true)};
}

std::string peer_version() {
  return fmt::format("Jolt {}.{}.{}, float; called by {}", JPH_VERSION_MAJOR, JPH_VERSION_MINOR, JPH_VERSION_PATCH,
                     built_by());
}

}  // namespace pushback
