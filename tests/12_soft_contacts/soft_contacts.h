/// What the tests of soft contacts share: no relaxing pass, and a pair that is free.
#pragma once

#include "pushback/chapters/11_substeps/substeps.h"
#include "pushback/chapters/12_soft_contacts/soft_contacts.h"
#include "pushback/common/bodies/random.h"
#include "pushback/common/world/measure.h"
#include "tests/support/catch.h"
#include "tests/support/on_ground.h"

namespace pushback {

/// The springs without the pass that takes their push back.
template <class... Effects>
struct Unrelaxed : RelaxingSolver<Effects...> {
  void after_move(World&, Real) override {}
};

/// Two boxes that overlap and turn, and nothing else: free.
inline void overlapping_pair(World& world, Random& random) {
  world.gravity.setZero();
  for (const int side : {-1, 1}) {
    const Vec3 spin = random.vector(1);
    world.add(box(Vec3::Constant(Real(0.5)), random.over_decades(1, 100))
                  .at({static_cast<Real>(side) * Real(0.46), 0, 0})
                  .spinning(spin));
  }
}

}  // namespace pushback
