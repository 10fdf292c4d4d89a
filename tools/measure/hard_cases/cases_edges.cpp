/// At the edge of what holds: friction a thousandth above the least, and an arch a twentieth above and below its least thickness.
#include <cmath>

#include "pushback/tools/measure/hard_cases/cases.h"
#include "pushback/tools/measure/hard_cases/standing.h"
#include "pushback/tools/measure/hard_cases/thinnest_arch.h"

namespace pushback {

namespace {

// ---- tan(theta) ------------------------------------------------------------------------------------------------------------

constexpr Real slope_angle = 30 * pi / 180;                                           // rad
constexpr Real half_wide = Real(0.5), half_high = Real(0.1), box_depth = Real(1e-5);  // m
constexpr int boxes_high = 3;

/// Flat boxes of 1 m x 0.2 m on each other, mu = 1.001 tan(theta), each 0.01 mm deep, so that all corners touch from the start. They
/// stick, as mu > tan(theta). They do not topple: the weight's line leaves the base by 0.3 m tan(theta) = 0.17 m from its middle, and
/// it reaches to 0.5 m. The slope falls along x, as one of the two tangents of each contact does, so a pyramid of friction is as
/// strong there as the cone.
void stack_on_slope(World& world) {
  const Real mu = Real(1.001) * std::tan(slope_angle);
  const Vec3 up{-std::sin(slope_angle), std::cos(slope_angle), 0};
  world.add(half_space(up).rough(mu));
  for (int i = 0; i < boxes_high; ++i) {
    const auto level = static_cast<Real>(i);
    world.add(box({half_wide, half_high, half_wide}, 100)
                  .turned(slope_angle, Vec3::UnitZ())
                  .at((half_high * (2 * level + 1) - box_depth * (level + 1)) * up)
                  .rough(mu));
  }
}

/// mm, that the lowest and the highest box have moved after ten minutes, 36,000 steps. What has slid by a metre has failed, and is
/// not followed further.
std::vector<Real> ten_minutes_on_the_slope(Trial& trial) {
  Play play = trial.play(stack_on_slope, standing);
  const Vec3 lowest = play.world.bodies[1].position, highest = play.world.bodies[boxes_high].position;
  const auto moved = [&](int body, const Vec3& from) {
    return (play.world.bodies[static_cast<std::size_t>(body)].position - from).norm();
  };
  for (int second = 0; second < 600 && moved(boxes_high, highest) < 1; ++second) play.run(1);
  return {1000 * moved(1, lowest), 1000 * moved(boxes_high, highest)};
}

// ---- an arch -----------------------------------------------------------------------------------------------------------------

constexpr int wedges = 13;
constexpr Real mean_radius = 10;  // m: a slop of 5 mm is a tenth of what 5 % of the thickness are

/// A semicircle that stands with both ends on the ground: `part` of the thickness that is the least with which it can. mu = 1, and no
/// joint asks for more than 0.4.
void thin_arch(World& world, Real part) {
  const Real half = part * thinnest_arch(wedges).thickness * mean_radius / 2;
  world.add(ground().rough(1));
  for (int i = 0; i < wedges; ++i) {
    std::vector<Vec3> points;
    for (const int joint : {i, i + 1}) {
      const Real angle = pi / wedges * static_cast<Real>(joint);
      for (const Real r : {mean_radius - half, mean_radius + half}) {
        for (const Real z : {Real(-1), Real(1)}) points.push_back({r * std::cos(angle), r * std::sin(angle), z});
      }
    }
    world.add(hull(points, 1000).rough(1));
  }
}

/// The thick one may move by half of what it is thicker than the least. The crown of the thin one must come down by half the
/// radius in 10 s; it is followed until then, so that nothing strikes the ground.
std::vector<Real> thick_and_thin(Trial& trial) {
  constexpr Real above = Real(1.05), below = Real(0.95);
  Play stands = trial.play([](World& world) { thin_arch(world, above); }, standing);
  const Stood stood = stand(stands, 10);
  Play falls = trial.play([](World& world) { thin_arch(world, below); },
                          [](const World& world) {
                            Allowance allowance = standing(world);
                            allowance.overlap = Real(0.5);  // stones that fall on each other
                            return allowance;
                          });
  const auto left = [&] { return falls.world.bodies[1 + wedges / 2].position.y() - mean_radius / 2; };
  for (int i = 0; i < 100 && left() > 0; ++i) falls.run(Real(0.1));
  return {1000 * stood.moved, 1000 * stood.jitter, std::max(Real(0), left())};
}

}  // namespace

std::vector<HardCase> edge_cases() {
  HardCase slope;
  slope.name = "tan-theta";
  slope.title = "ten minutes at tan(theta)";
  slope.stresses = "friction a thousandth above what three boxes on a slope need: the least creep adds up";
  slope.criteria = {{"lowest box after 10 minutes", "mm", Real(1.7)},  // 10 mm an hour
                    {"highest box after 10 minutes", "mm", Real(1.7)}};
  slope.scene = {
      .name = slope.title, .fill = stack_on_slope, .camera = view({0, Real(0.3), 0}, Real(1.8)), .seconds = 0};
  slope.run = ten_minutes_on_the_slope;

  HardCase arch;
  arch.name = "milankovitch";
  arch.title = "as thin as an arch may be";
  arch.stresses = "stands with 1.05 of the least thickness that has a line of thrust, and falls with 0.95 of it";
  arch.criteria = {{"1.05: largest displacement after 10 s", "mm", 25},
                   {"1.05: speed in the last second", "mm/s", 1},
                   {"0.95: crown above half the radius after 10 s", "m", 0}};
  arch.scene = {.name = arch.title,
                .fill = [](World& world) { thin_arch(world, Real(0.95)); },
                .camera = view({0, 5, 0}, 21),
                .seconds = 5};
  arch.run = thick_and_thin;
  return {slope, arch};
}

}  // namespace pushback
