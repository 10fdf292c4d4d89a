/// What is joined: long chains of rows with a load at the end that outweighs each of them by far.
#include <cmath>

#include "pushback/chapters/15_limits_motors_springs/ragdoll.h"
#include "pushback/common/basics/shortest_turn.h"
#include "pushback/common/world/forces.h"
#include "pushback/common/world/measure.h"
#include "pushback/tools/measure/hard_cases/cases.h"
#include "pushback/tools/measure/hard_cases/gap.h"
#include "pushback/tools/measure/hard_cases/standing.h"

namespace pushback {

namespace {

/// %, of the length of all that is joined in one line: how much longer the gaps make it.
Real stretch_of(const World& world, Real length) {
  Real gaps = 0;
  for (const Joint& joint : world.joints) gaps += gap_of(world, joint);
  return 100 * gaps / length;
}

// ---- chains --------------------------------------------------------------------------------------------------------------

constexpr int links = 10;
constexpr Real link_length = Real(0.5), chain_length = links * link_length;  // m

/// Links of 1 kg from the origin along `way`, on balls and sockets, and a load at the last.
void chain(World& world, const Vec3& way, Body load, Real from_end) {
  const Quat turned = shortest_turn(Vec3::UnitY(), way);
  for (int i = 0; i < links; ++i) {
    const Real along = link_length * static_cast<Real>(i);
    Body link = capsule(Real(0.05), Real(0.2), 1).at((along + link_length / 2) * way);
    link.orientation = turned;
    const int index = world.add(link);
    world.joints.push_back(ball_and_socket(world, i == 0 ? the_world : index - 1, index, along * way));
  }
  const int last = world.add(load.at((chain_length + from_end) * way));
  world.joints.push_back(ball_and_socket(world, last - 1, last, chain_length * way));
}
void weight_on_chain(World& world, const Vec3& way) {
  chain(world, way, sphere(Real(0.25), 100), Real(0.25));
}
void ball_on_chain(World& world) {
  chain(world, Vec3::UnitX(), sphere(Real(0.4), 1000), Real(0.4));
}

/// J: the work of lifting all by `height` m, which is what feeding back a stretch may do.
Allowance lifting(const World& world, Real height) {
  Allowance allowance = standing(world);
  allowance.energy *= height / Real(0.001);
  return allowance;
}

/// What a chain that is let go from the horizontal comes to in 10 s.
struct Swing {
  Real stretch = 0;  // %, the most
  Real lost = 0;     // %, of the energy that the fall to the lowest point sets free, at the end
};
Swing swing(Trial& trial, const std::function<void(World&)>& fill) {
  Play play = trial.play(fill, [](const World& world) { return lifting(world, chain_length / 100); });
  const auto energy = [](const World& world) { return kinetic_energy(world) + potential_energy(world); };
  const Body load = play.world.bodies.back();
  const Real start = energy(play.world);
  const Real fall = play.world.gravity.norm() * load.position.norm() / load.inverse_mass;
  Swing seen;
  play.run(10, frame,
           [&](const World& world) { seen.stretch = std::max(seen.stretch, stretch_of(world, chain_length)); });
  seen.lost = 100 * (start - energy(play.world)) / fall;
  return seen;
}

HardCase heavy_chain() {
  HardCase c;
  c.name = "heavy-chain";
  c.title = "chain, 1 : 100";
  c.stresses = "ten links carry a hundred times the mass of one, hanging and swinging";
  // Of 5 m: 1 mm hanging, 10 mm swinging, which is what the best engine of those measured does.
  c.criteria = {{"stretch hanging", "%", Real(0.02)},
                {"speed in the last second, hanging", "mm/s", 1},
                {"stretch swinging", "%", Real(0.2)}};
  c.scene = {.name = c.title,
             .fill = [](World& world) { weight_on_chain(world, Vec3::UnitX()); },
             .camera = view({0, Real(-2.7), 0}, 8),
             .seconds = Real(1.5)};
  c.run = [fill = c.scene.fill](Trial& trial) -> std::vector<Real> {
    Play hanging = trial.play([](World& world) { weight_on_chain(world, -Vec3::UnitY()); }, standing);
    const Stood s = stand(hanging, 10);
    return {stretch_of(hanging.world, chain_length), 1000 * s.jitter, swing(trial, fill).stretch};
  };
  return c;
}

// A step turns the speed v of what goes round by w h and keeps the part of it that the chain allows, v cos(w h): of the
// kinetic energy T it takes w^2 h T a second. Let go from the horizontal, a pendulum of length L has a mean of w^2 T of
// 2 g / (3 L) m g L: in 10 s and substeps of 1/1920 s, 0.63 %, and in steps of 1/60 s 20 %.
HardCase ball_and_chain() {
  HardCase c;
  c.name = "ball-and-chain";
  c.title = "ball and chain, 1 : 1000";
  c.stresses = "a ball that outweighs a link a thousand times, let go from the horizontal";
  c.criteria = {{"stretch", "%", 1}, {"energy lost in 10 s", "%", 1}};
  c.scene = {.name = c.title, .fill = ball_on_chain, .camera = view({0, Real(-2.7), 0}, 8), .seconds = Real(1.5)};
  c.run = [](Trial& trial) -> std::vector<Real> {
    const Swing s = swing(trial, ball_on_chain);
    return {s.stretch, s.lost};
  };
  return c;
}

// ---- a bridge ------------------------------------------------------------------------------------------------------------

constexpr int planks = 20;
constexpr Real plank_length = Real(0.5), plank_mass = 20;  // m, kg

/// Planks on hinges along an arc of 60 degrees that hangs between two posts, and a load of 100 planks in the middle. The
/// air is thick, so that all comes to rest: the slowest sway by a factor e in 5 s, however well it is solved.
void bridge(World& world) {
  constexpr Real turn = pi / 180 * 3;
  const Real radius = plank_length / (2 * std::sin(turn / 2));
  const auto corner = [&](int i) {
    const Real angle = turn * (static_cast<Real>(i) - Real(planks) / 2);
    return Vec3(radius * std::sin(angle), -radius * std::cos(angle) + radius * std::cos(turn * planks / 2), 0);
  };
  const auto post = [&](const Vec3& end, Real side) {
    return world.add(box({Real(0.25), 1, Real(0.6)}, 1).fixed().at(end + Vec3(Real(0.25) * side, -1, 0)));
  };
  int before = post(corner(0), -1);
  const int right = post(corner(planks), 1);
  for (int i = 0; i < planks; ++i) {
    const Real tilt = turn * (static_cast<Real>(i) + Real(0.5) - Real(planks) / 2);
    const Vec3 middle = (corner(i) + corner(i + 1)) / 2;
    const int plank =
        world.add(box({plank_length / 2, Real(0.04), Real(0.5)}, plank_mass).turned(tilt, Vec3::UnitZ()).at(middle));
    world.joints.push_back(hinge(world, before, plank, corner(i), Vec3::UnitZ()));
    world.forces.push_back(drag(plank, 4 * plank_mass));
    before = plank;
  }
  world.joints.push_back(hinge(world, before, right, corner(planks), Vec3::UnitZ()));
  constexpr Real side = Real(0.4), mass = 100 * plank_mass;
  const int load = world.add(box(Vec3::Constant(side), mass).at(corner(planks / 2) + Vec3(0, side + Real(0.055), 0)));
  world.forces.push_back(drag(load, 4 * mass));
}

HardCase loaded_bridge() {
  HardCase c;
  c.name = "bridge";
  c.title = "bridge of planks, 1 : 100";
  c.stresses = "twenty hinges in a row, held at both ends, and contacts with a load of a hundred planks";
  // Of 10 m, as for the chain: 2 mm at rest, 20 mm while the load goes down.
  c.criteria = {{"stretch at rest", "%", Real(0.02)},
                {"stretch while it sags", "%", Real(0.2)},
                {"speed in the last second", "mm/s", 1},
                {"the load, off the middle", "mm", 1000 * plank_length / 2}};
  c.scene = {.name = c.title, .fill = bridge, .camera = view({0, Real(-0.6), 0}, 9), .seconds = 30};
  c.run = [](Trial& trial) -> std::vector<Real> {
    Play play = trial.play(bridge, standing);
    constexpr Real length = planks * plank_length;
    Real most = 0, fastest = 0;
    play.run(29, frame, [&](const World& world) { most = std::max(most, stretch_of(world, length)); });
    play.run(1, frame, [&](const World& world) { fastest = std::max(fastest, largest_speed(world)); });
    const Vec3& load = play.world.bodies.back().position;
    return {stretch_of(play.world, length), most, 1000 * fastest, 1000 * std::hypot(load.x(), load.z())};
  };
  return c;
}

// ---- a ragdoll -----------------------------------------------------------------------------------------------------------

HardCase ragdoll_on_stairs() {
  using namespace limits_motors_springs_scenes;
  HardCase c;
  c.name = "ragdoll";
  c.title = "ragdoll on stairs";
  c.stresses = "ten joints with limits, eleven bodies between them and five steps: it folds, and comes to rest";
  c.criteria = {{"largest gap, of his height", "%", 1},
                {"a knee or elbow bent backwards", "degrees", 5},
                {"speed in the last second", "mm/s", 1}};
  c.scene = {.name = c.title,
             .fill = [](World& world) { down_the_stairs(world); },
             .camera = view({Real(0.6), Real(0.9), 0}, Real(3.4)),
             .seconds = Real(1.5)};
  c.run = [](Trial& trial) -> std::vector<Real> {
    Ragdoll man{};
    Play play = trial.play([&man](World& world) { man = down_the_stairs(world); },
                           [](const World& world) { return lifting(world, ragdoll_height / 100); });
    Real gap = 0, backwards = 0, fastest = 0;
    const auto look = [&](const World& world) {
      gap = std::max(gap, stretch(world, man));
      backwards = std::max(backwards, bent_backwards(world, man));
    };
    play.run(9, frame, look);
    play.run(1, frame, [&](const World& world) {
      look(world);
      fastest = std::max(fastest, largest_speed(world));
    });
    return {100 * gap, 180 / pi * backwards, 1000 * fastest};
  };
  c.starts = many_starts;
  return c;
}

}  // namespace

std::vector<HardCase> joint_cases() {
  return {heavy_chain(), ball_and_chain(), loaded_bridge(), ragdoll_on_stairs()};
}

}  // namespace pushback
