/// Structures of many joints: ropes, a cloth, a bridge.
#pragma once

#include "pushback/chapters/13_joints/ball_and_socket.h"
#include "pushback/chapters/13_joints/distance.h"
#include "pushback/common/world/forces.h"
#include "pushback/common/world/situations.h"

namespace pushback::joints_under_load_scenes {

/// A ball that does not rotate. Balls joined at their centres would otherwise roll, and friction could not hold them.
inline Body particle(Real radius, Real mass) {
  Body ball = sphere(radius, mass);
  ball.principal_inverse_inertia.setZero();
  return ball;
}
/// A rod from centre to centre, as long as their current distance.
inline Joint rod_between(const World& world, int a, int b) {
  return distance(world, a, body_of(world, a).position, b, body_of(world, b).position);
}

// ---- ropes -------------------------------------------------------------------------------------------------------------

inline constexpr int rope_links = 24;
inline constexpr Real rope_link = Real(0.15);                          // m
inline constexpr Real rope_span = Real(0.7) * rope_links * rope_link;  // m, between the ends of the hanging rope
inline constexpr Real rope_x = -Real(1.5), rope_y = Real(2.6);         // m, the middle between its ends

/// Adds a particle of `mass` kg at each of `places` (m) and joins it to the one before. Returns the index of the first.
inline int rope(World& world, const std::vector<Vec3>& places, Real mass, int colour) {
  const int first = static_cast<int>(world.bodies.size());
  for (std::size_t i = 0; i < places.size(); ++i) {
    const int here = world.add(particle(Real(0.05), mass).at(places[i]).coloured(colour));
    if (i > 0) world.joints.push_back(rod_between(world, here - 1, here));
  }
  return first;
}

/// A rope hung at both ends, at first straight from each end to its middle. It swings until drag has brought it to rest.
inline void hanging_rope(World& world) {
  world.add(ground());
  const Real half = rope_span / 2, down = std::sqrt(std::pow(rope_links * rope_link / 2, 2) - half * half);
  std::vector<Vec3> places;
  for (int i = 1; i < rope_links; ++i) {
    const Real along = 2 * static_cast<Real>(i) / rope_links - 1;  // -1 ... 1
    places.push_back({rope_x + half * along, rope_y - down * (1 - std::abs(along)), 0});
  }
  const int first = rope(world, places, Real(0.1), 0), last = first + rope_links - 2;
  world.joints.push_back(distance(world, the_world, {rope_x - half, rope_y, 0}, first, places.front()));
  world.joints.push_back(distance(world, last, places.back(), the_world, {rope_x + half, rope_y, 0}));
  for (int i = first; i <= last; ++i) world.forces.push_back(drag(i, Real(0.2)));
  for (const Real side : {Real(-1), Real(1)})
    world.add(
        box({Real(0.05), rope_y / 2, Real(0.05)}, 1).fixed().at({rope_x + side * (half + Real(0.05)), rope_y / 2, 0}));
}

/// The hanging rope, and a rope that falls over a bar.
inline void ropes(World& world) {
  hanging_rope(world);
  world.add(capsule(Real(0.15), 1, 1).fixed().rough(1).turned(pi / 2, Vec3::UnitX()).at({2, Real(1.8), 0}));
  std::vector<Vec3> places;
  for (int i = 0; i <= 24; ++i) places.push_back({2 + Real(0.12) * static_cast<Real>(i - 13), Real(2.1), 0});
  rope(world, places, Real(0.1), 3);
}

/// The hanging rope at rest, in closed form. All links have the same horizontal tension H, and the vertical tension grows by a
/// particle's weight from link to link. H follows from the span, the sum of L cos(slope angle) over all links.
struct HangingRope {
  Real pull;  ///< H / (m g)
  std::vector<Vec3> places;

  HangingRope() {
    Real low = 0, high = 1000;
    for (int i = 0; i < 200; ++i) {
      pull = (low + high) / 2;
      (width(pull) < rope_span ? low : high) = pull;
    }
    Vec3 at(rope_x - rope_span / 2, rope_y, 0);
    for (int i = 0; i + 1 < rope_links; ++i) {
      const Real rise = steepness(i);
      at += rope_link * Vec3(pull, rise, 0) / std::hypot(pull, rise);
      places.push_back(at);
    }
  }

 private:
  static Real steepness(int i) { return static_cast<Real>(i) - Real(rope_links - 1) / 2; }
  static Real width(Real pull) {
    Real sum = 0;
    for (int i = 0; i < rope_links; ++i) sum += rope_link * pull / std::hypot(pull, steepness(i));
    return sum;
  }
};

// ---- cloth -------------------------------------------------------------------------------------------------------------

inline constexpr int cloth_side = 17;             // particles
inline constexpr Real thread = Real(0.15);        // m, between them
inline constexpr Real knot_radius = Real(0.045);  // m

/// A grid of small balls. The threads along and across are drawn. The threads along the diagonals, which keep the squares from
/// collapsing to lines, are not. Particles that are not joined collide.
inline void cloth_over_ball(World& world) {
  world.add(ground());
  world.add(sphere(Real(0.7), 1).fixed().rough(1).at({0, Real(0.7), 0}).coloured(2));
  const int first = static_cast<int>(world.bodies.size());
  const auto index = [first](int i, int j) { return first + cloth_side * i + j; };
  for (int i = 0; i < cloth_side; ++i) {
    for (int j = 0; j < cloth_side; ++j) {
      const Real middle = Real(cloth_side - 1) / 2;
      world.add(particle(knot_radius, Real(0.01))
                    .at({thread * (static_cast<Real>(i) - middle), Real(1.6), thread * (static_cast<Real>(j) - middle)})
                    .coloured((i / 2 + j / 2) % 2 == 0 ? 4 : 0));
      world.forces.push_back(drag(index(i, j), Real(0.01)));
    }
  }
  for (int i = 0; i < cloth_side; ++i) {
    for (int j = 0; j < cloth_side; ++j) {
      if (i > 0) world.joints.push_back(rod_between(world, index(i - 1, j), index(i, j)));
      if (j > 0) world.joints.push_back(rod_between(world, index(i, j - 1), index(i, j)));
      if (i == 0 || j == 0) continue;
      for (const auto& [a, b] :
           {std::pair(index(i - 1, j - 1), index(i, j)), std::pair(index(i - 1, j), index(i, j - 1))}) {
        world.joints.push_back(rod_between(world, a, b));
        world.joints.back().line = {};
      }
    }
  }
}

// ---- a suspension bridge -----------------------------------------------------------------------------------------------

inline constexpr int planks = 16;
inline constexpr Real plank_length = Real(0.5);  // m, along the bridge
inline constexpr Real deck_height = 2;           // m
inline constexpr Real middle_of_deck = planks * plank_length / 2;

/// Planks with a ball and socket at each corner, on hangers from two cables. Three boxes fall on the bridge.
inline void suspension_bridge(World& world) {
  world.add(ground());
  constexpr Real half_width = Real(0.6), tower = Real(1.7);
  const Vec3 bank_size(1, deck_height / 2, 1);
  int bank[2];
  for (const int side : {0, 1}) {
    const Real x = side == 0 ? -middle_of_deck : middle_of_deck, out = side == 0 ? -1 : 1;
    bank[side] = world.add(box(bank_size, 1).fixed().at({x + out * bank_size.x(), bank_size.y(), 0}));
    for (const Real edge : {-half_width - Real(0.1), half_width + Real(0.1)})
      world.add(
          box({Real(0.06), tower / 2, Real(0.06)}, 1).fixed().at({x + out * Real(0.1), deck_height + tower / 2, edge}));
  }
  const auto x_of = [](int plank) { return plank_length * (static_cast<Real>(plank) + Real(0.5)) - middle_of_deck; };
  const Real deck = deck_height - Real(0.05);
  int before = bank[0], first_plank = 0;
  for (int i = 0; i <= planks; ++i) {
    const int here = i == planks ? bank[1]
                                 : world.add(box({plank_length / 2 - Real(0.02), Real(0.05), half_width}, 10)
                                                 .at({x_of(i), deck, 0})
                                                 .coloured(2 + i % 2));
    if (i == 0) first_plank = here;
    for (const Real edge : {-half_width, half_width})
      world.joints.push_back(ball_and_socket(world, before, here, {x_of(i) - plank_length / 2, deck, edge}));
    before = here;
  }
  for (const Real edge : {-half_width, half_width}) {  // a parabola, as a cable has under a load uniform along x
    const auto cable_at = [=](Real x) {
      return Vec3(x, deck_height + Real(0.3) + (tower - Real(0.3)) * x * x / (middle_of_deck * middle_of_deck), edge);
    };
    int last = the_world;
    Vec3 from = cable_at(-middle_of_deck);
    for (int i = 0; i < planks; ++i) {
      const Vec3 at = cable_at(x_of(i));
      const int knot = world.add(sphere(Real(0.05), 1).at(at).coloured(0));
      world.joints.push_back(distance(world, last, from, knot, at));
      world.joints.push_back(distance(world, first_plank + i, {at.x(), deck, edge}, knot, at));
      last = knot;
      from = at;
    }
    world.joints.push_back(distance(world, last, from, the_world, cable_at(middle_of_deck)));
  }
  const Real half = Real(0.3);
  for (int i = 0; i < 3; ++i)
    world.add(box(Vec3::Constant(half), 40)
                  .at({Real(1.2) * static_cast<Real>(i) - Real(2.4), Real(3.2) + Real(0.9) * static_cast<Real>(i),
                       Real(0.1) * static_cast<Real>(i - 1)})
                  .turned(Real(0.3) * static_cast<Real>(i), Vec3::UnitY())
                  .coloured(4));
}

}  // namespace pushback::joints_under_load_scenes
