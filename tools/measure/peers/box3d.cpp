/// Box3D plays motions.
#include "pushback/tools/measure/peers/box3d.h"

#include <fmt/format.h>

#include "pushback/tools/measure/peers/peer.h"

namespace pushback {

namespace {

class PlaysMotion : public Player {
 public:
  /// `often`: substeps are steps of Box3D's, each with so many substeps of its own as there are sweeps. Else a frame is a step.
  PlaysMotion(const Motion& motion, const Setting& setting, const Box3dChoice& choice, bool often)
      : world_(begun(motion)), box3d_(world_, choice, 1), setting_(setting), often_(often) {}
  void frame(int substeps) override {
    if (!often_) return box3d_.step(1.0 / frames_per_second, substeps);
    for (int i = 0; i < substeps; ++i) box3d_.step(setting_.dt(), setting_.sweeps);
  }
  Eigen::Vector3d place(std::size_t body) const override { return box3d_.place(body); }

 private:
  static World begun(const Motion& motion) {
    World world;
    motion.begin(world);
    return world;
  }

  World world_;
  Box3d box3d_;
  Setting setting_;
  bool often_;
};

Method method(const std::string& name, const std::string& title, const Box3dChoice& choice, bool often = false) {
  return {.name = name,
          .title = title,
          .plays = [](const Motion&) { return true; },
          .begin = [=](const Motion& motion, const Setting& setting) -> std::unique_ptr<Player> {
            return std::make_unique<PlaysMotion>(motion, setting, choice, often);
          },
          .sweeps = often};
}

}  // namespace

std::vector<Method> peer_methods() {
  return {method("box3d", "Box3D", {}), method("box3d-stiff", "Box3D, stiff", {.stiff = true}),
          method("box3d-often", "Box3D, stiff, contacts detected in each substep", {.stiff = true}, true),
          method("box3d-manifolds-anew", "Box3D, stiff, manifolds made in each step", {.stiff = true, .anew = true})};
}

std::string peer_version() {
  const b3Version version = b3GetVersion();
  return fmt::format("Box3D {}.{}.{}, float; called by {}", version.major, version.minor, version.revision, built_by());
}

}  // namespace pushback
