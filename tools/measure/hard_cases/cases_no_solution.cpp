/// What rigid bodies cannot satisfy: by forces alone, or at all.
#include <cmath>

#include "pushback/common/world/measure.h"
#include "pushback/tools/measure/hard_cases/paradox.h"
#include "pushback/tools/measure/hard_cases/standing.h"

namespace pushback {

// ---- Painleve's rod ----------------------------------------------------------------------------------------------------

namespace {

constexpr Real half_long = Real(0.5), rod_half_thick = Real(0.01), rod_speed = 1, rod_friction = 2;

}  // namespace

void sliding_rod(World& world) {
  world.add(ground().rough(rod_friction));
  const Real lean = std::atan(Real(0.5));  // from upright, so tan(a) = 2
  const Real height = half_long * std::cos(lean) + rod_half_thick * std::sin(lean);
  world.add(box({rod_half_thick, half_long, Real(0.05)}, 1)
                .turned(lean, Vec3::UnitZ())
                .at({0, height - Real(1e-5), 0})
                .moving({rod_speed, 0, 0})
                .rough(rod_friction));
}

Vec3 tip_of(const World& world) {
  const Body& rod = world.bodies.back();
  return rod.position + rod.orientation * Vec3(-rod_half_thick, -half_long, 0);
}

Paradox paradox_of(const World& world, Real time) {
  const Body& rod = world.bodies.back();
  const Vec3 r = tip_of(world) - rod.position;
  const Real m = 1 / rod.inverse_mass, I = 1 / rod.principal_inverse_inertia.z();
  const Real k_nn = 1 / m + r.x() * r.x() / I, k_nt = -r.x() * r.y() / I;
  return {.normal_mass = k_nn - rod_friction * k_nt,
          .cone_share = k_nn / (rod_friction * k_nt),
          .turning = (r.y() * rod_speed - world.gravity.y() * time * r.x()) * m / (I + m * r.squaredNorm())};
}

namespace {

/// The tip stays where it stopped for 0.2 s: so long w lasts against gravity. Then the rod falls back, and lies.
std::vector<Real> painleve(Trial& trial) {
  Play play = trial.play(sliding_rod, striking(Real(0.2)));  // its end comes down with 5 m/s: 90 mm in a step
  const Paradox paradox = paradox_of(play.world, frame);
  const Real start = kinetic_energy(play.world);
  play.run(frame);
  const Body& rod = play.world.bodies[1];
  // A step solves J V = 0 for the rod as it lay before it was moved: turned back by that much, its tip stands still.
  const Real back = rod.angular_velocity.norm() * trial.substep();
  const Vec3 axis = rod.angular_velocity.norm() > 0 ? rod.angular_velocity.normalized() : Vec3::UnitZ();
  const Vec3 arm = Eigen::AngleAxis<Real>(-back, axis) * (tip_of(play.world) - rod.position);
  const Real tip = rod.velocity_at(rod.position + arm).norm();
  const Real turning = rod.angular_velocity.z();
  const Vec3 stopped = tip_of(play.world);
  play.run(Real(0.2) - frame);
  const Vec3 slid = tip_of(play.world) - stopped;
  const Real beyond = std::max(Real(0), play.watcher().deepest() - slop);
  play.run(Real(2.8));
  return {100 * tip / rod_speed, 100 * std::abs(turning / paradox.turning - 1), 1000 * std::hypot(slid.x(), slid.z()),
          1000 * beyond,         100 * play.watcher().energy_gained() / start,  1000 * largest_speed(play.world)};
}

// ---- between a fixed and a driven body -----------------------------------------------------------------------------------

constexpr Real half_side = Real(0.5), press_speed = Real(0.1), squeeze = Real(0.02);
constexpr Real pressing = squeeze / press_speed;  // s

/// A box on the ground, and right above it a slab that nothing stops.
void squeezed(World& world) {
  world.add(ground());
  world.add(box(Vec3::Constant(half_side), 100).at({0, half_side, 0}));
  world.add(box({1, Real(0.1), 1}, 1).fixed().at({0, 2 * half_side + Real(0.1), 0}).moving({0, -press_speed, 0}));
}

/// The slab comes down by 20 mm, stays for 1 s, and leaves. While it is down, 20 mm of overlap cannot be avoided: every
/// position of the box breaks a law, and what can be asked for is the sharing of it in two equal parts, 10 mm each. On its
/// way down the slab moves the box by half of what it moves itself; faster than the slab the box never has to be. Once the
/// slab has left, the box may come up to the surface, and not beyond it.
std::vector<Real> squeeze_and_let_go(Trial& trial) {
  Play play = trial.play(squeezed, [](const World& world) {
    Allowance allowance = standing(world);  // the slab does work: as much as brings the box to its own speed
    allowance.energy += press_speed * press_speed / (2 * world.bodies[1].inverse_mass);
    return allowance;
  });
  const auto speed_of_box = [](const World& world) { return world.bodies[1].velocity.norm(); };
  Real fastest = play.largest(pressing, speed_of_box);
  play.world.bodies[2].velocity.setZero();
  fastest = std::max(fastest, play.largest(Real(0.5), speed_of_box));
  const Real trembling = play.largest(Real(0.5), speed_of_box);
  const Real middle = play.world.bodies[1].position.y() - (half_side - squeeze / 2);
  play.world.bodies[2].velocity = {0, 1, 0};
  const Real highest =
      std::max(half_side, play.largest(2, [](const World& world) { return world.bodies[1].position.y(); }));
  const Vec3 end = play.world.bodies[1].position;
  return {100 * std::max(fastest, trembling) / press_speed,
          1000 * std::abs(middle),
          1000 * trembling,
          1000 * (highest - half_side),
          1000 * std::hypot(end.x(), end.z()),
          1000 * speed_of_box(play.world)};
}

}  // namespace

std::vector<HardCase> no_solution_cases() {
  return {{.name = "painleve",
           .title = "Painlevé's sliding rod",
           .stresses = "the more the ground presses, the more friction turns the tip into it: only an impact ends that",
           .criteria = {{"speed of the tip after 1/60 s", "%", 1},
                        {"turns after 1/60 s, off the closed form", "%", 1},
                        {"the tip slides in 0.2 s", "mm", 1},
                        {"deeper than the slop in 0.2 s", "mm", 1},
                        {"energy gained", "%", Real(0.1)},
                        {"speed after 3 s", "mm/s", 1}},
           .scene = seen(sliding_rod, view({0, Real(0.4), 0}, Real(1.3)), 0),
           .run = painleve},
          {.name = "squeezed",
           .title = "a box in a press",
           .stresses = "driven 20 mm into what has no room: no solution, nothing may grow, and it is let go again",
           .criteria = {{"fastest in the press, of the press's speed", "%", 100},
                        {"overlap, off an equal share", "mm", 1},
                        {"speed after half a second in the press", "mm/s", 1},
                        {"jumps when let go", "mm", 1},
                        {"drift", "mm", 1},
                        {"speed after 2 s", "mm/s", 1}},
           .scene = seen(squeezed, view({0, Real(0.6), 0}, Real(2.2)), pressing),
           .run = squeeze_and_let_go}};
}

}  // namespace pushback
