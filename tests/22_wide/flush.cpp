/// Tiles that lie flush are as one plane, in whatever direction.
#include <cmath>

#include "pushback/chapters/04_slop/slop.h"
#include "pushback/chapters/08_friction_cone/friction_cone.h"
#include "pushback/chapters/11_substeps/substeps.h"
#include "pushback/chapters/21_detected_once/detected_once.h"
#include "pushback/common/bodies/random.h"
#include "pushback/engine/substeps/wide_solver.h"
#include "tests/support/catch.h"
#include "tests/support/tiles.h"
#include "tests/support/yardstick.h"

using namespace pushback;

namespace {

constexpr Real half_side = Real(0.2), mu = Real(0.2), tile = Real(0.25);

/// Chapter 11's: in each substep, and without a margin.
using DetectedOften = Substeps<Solver<Clamping, Baumgarte, Slop, Restitution, FrictionCone, WarmStart>>;

struct Way {
  Vec3 from, along;
  Real speed;
};

Body mover(const Way& way, Real yaw) {
  return box(Vec3::Constant(half_side), 10)
      .turned(yaw, Vec3::UnitY())
      .at(way.from + Vec3(0, half_side - Real(1e-5), 0))
      .moving(way.speed * way.along)
      .rough(mu);
}

/// After two seconds; and how high it came.
template <class Steps>
std::pair<Vec3, Real> goes(Steps solver, const Body& body, const Way& way, bool tiled) {
  World world;
  if (tiled) add_tiles(world, tile, way.from, way.along, 11, 1, mu);
  else world.add(box({40, tile, 40}, 1).fixed().at({0, -tile, 0}).rough(mu));
  const auto which = static_cast<std::size_t>(world.add(body));
  Real highest = 0;
  for (int i = 0; i < 120; ++i) {
    world.step(solver, h);
    highest = std::max(highest, world.bodies[which].position.y() - body.position.y());
  }
  return {world.bodies[which].position, highest};
}

template <class Steps>
void is_one_plane(Real off_at_most) {
  Random random(1);
  for (int i = 0; i < 8; ++i) {
    const Real heading = random.between(0, 2 * pi), yaw = random.between(0, 2 * pi);
    const Way way{{random.between(-1, 1), 0, random.between(-1, 1)},
                  {std::cos(heading), 0, std::sin(heading)},
                  random.between(1, 4)};
    const Body body = mover(way, yaw);
    const auto [over_tiles, highest] = goes(Steps(), body, way, true);
    const auto [on_plane, of_plane] = goes(Steps(), body, way, false);
    CHECK((over_tiles - on_plane).norm() < off_at_most);
    CHECK(highest < of_plane + Real(1e-4));
  }
}

}  // namespace

TEST_CASE("wide: a box slides over tiles that lie flush as on one plane") {
  is_one_plane<DetectedOften>(Real(1e-3));
  is_one_plane<WideSolver<Real>>(Real(1e-3));
  is_one_plane<DetectedOnce>(Real(1e-3));
}
