/// Tiles that lie flush are as one plane: to what slides and to what rolls, and in whatever direction.
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

enum class Kind { box, ball, hull };

struct Way {
  Vec3 from, along;
  Real speed;
};

Body mover(Kind kind, const Way& way, Real yaw) {
  constexpr Real up = half_side - Real(1e-5);
  const std::vector<Vec3> corners = {{-half_side, -half_side, -half_side}, {half_side, -half_side, -half_side},
                                     {-half_side, -half_side, half_side},  {half_side, -half_side, half_side},
                                     {-half_side / 2, half_side, 0},       {half_side / 2, half_side, half_side},
                                     {half_side, half_side, -half_side}};
  Body body = kind == Kind::box    ? box(Vec3::Constant(half_side), 10)
              : kind == Kind::ball ? sphere(half_side, 10)
                                   : hull(corners, 10);
  Real low = -half_side;
  if (kind != Kind::ball) body.turned(yaw, Vec3::UnitY());
  if (const auto* shape = std::get_if<Hull>(&body.shape)) {
    low = 0;  // its centre of mass is not that of the cube
    for (const Vec3& corner : shape->solid->corners) low = std::min(low, (body.orientation * corner).y());
  }
  body.at(way.from + Vec3(0, up - half_side - low, 0)).moving(way.speed * way.along).rough(mu);
  if (kind == Kind::ball) body.spinning(way.speed / half_side * Vec3::UnitY().cross(way.along));
  return body;
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
void is_one_plane(Kind kind, Real off_at_most) {
  Random random(1);
  for (int i = 0; i < 8; ++i) {
    const Real heading = random.between(0, 2 * pi), yaw = random.between(0, 2 * pi);
    const Way way{{random.between(-1, 1), 0, random.between(-1, 1)},
                  {std::cos(heading), 0, std::sin(heading)},
                  random.between(1, 4)};
    const Body body = mover(kind, way, yaw);
    const auto [over_tiles, highest] = goes(Steps(), body, way, true);
    const auto [on_plane, of_plane] = goes(Steps(), body, way, false);
    CHECK((over_tiles - on_plane).norm() < off_at_most);
    CHECK(highest < of_plane + Real(1e-4));
  }
}

}  // namespace

TEST_CASE("wide: a box slides over tiles that lie flush as on one plane") {
  is_one_plane<DetectedOften>(Kind::box, Real(1e-3));
  is_one_plane<WideSolver<Real>>(Kind::box, Real(1e-3));
  is_one_plane<DetectedOnce>(Kind::box, Real(1e-3));
}
TEST_CASE("wide: a hull slides over tiles that lie flush as on one plane") {
  is_one_plane<DetectedOften>(Kind::hull, Real(1e-3));
  is_one_plane<WideSolver<Real>>(Kind::hull, Real(1e-3));
}
TEST_CASE("wide: a ball rolls over tiles that lie flush as on one plane") {
  is_one_plane<WideSolver<Real>>(Kind::ball, Real(5e-3));  // of up to 8 m: at edges it sinks in by some micrometres
}
