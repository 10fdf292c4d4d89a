/// One detection for several substeps.
#pragma once

#include "pushback/common/world/step.h"
#include "pushback/common/world/surface_points.h"

namespace pushback {

/// Everybody; but what touches is found when it is asked for only. In the steps between, the contacts that were found are where
/// their bodies have carried them: P_A and P_B, the points of the two surfaces, ride on A and on B, the normal stays.
///
///   depth = (P_A - P_B) . n,   point = (P_A + P_B) / 2          those that have parted are left out, until they meet again
///
/// What comes to touch meanwhile is not seen before the next detection.
class CarriedContacts : public Everybody {
 public:
  /// In the next step contacts are found anew.
  void find_anew() { anew_ = true; }

  void find_contacts(World& world, const Margin& margin = {}) {
    if (anew_) {
      world.find_contacts(margin);
      keep(world);
    } else {
      carry(world);
    }
  }

 private:
  struct Carried {
    Contact found;
    SurfacePoints points;
  };
  void keep(const World& world) {
    anew_ = false;
    carried_.clear();
    for (const Contact& at : world.contacts) {
      const auto [a, b] = world.bodies_of(at);
      carried_.push_back({at, SurfacePoints(a, b, at)});
    }
  }
  void carry(World& world) const {
    world.contacts.clear();
    for (const Carried& each : carried_) {
      const auto [a, b] = world.bodies_of(each.found);
      const Vec3 p_a = point_of(a, each.points.on_a), p_b = point_of(b, each.points.on_b);
      const Real depth = (p_a - p_b).dot(each.found.normal);
      if (depth < 0) continue;
      Contact& now = world.contacts.emplace_back(each.found);
      now.depth = depth;
      now.point = (p_a + p_b) / 2;
    }
  }

  std::vector<Carried> carried_;
  bool anew_ = true;
};

}  // namespace pushback
