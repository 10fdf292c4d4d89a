/// Motions in which nothing may move: a box that friction alone holds up, and a pile of a thousand hulls.
#pragma once

#include "pushback/chapters/19_accuracy_and_time/motion.h"

namespace pushback::further {

/// Tongs hold a box. Each of its two jaws is a square bar, turned so that an edge touches a side of the box, and hangs on a pin of the world
/// above the box by an arm without mass. The pins are nearer to the middle than the sides are, so a jaw's weight swings it inwards,
/// and so does the box's weight, by friction. With the contact H below the pin and w farther out, the jaw's centre of mass
/// c farther still, M a jaw's mass and m the box's, all planar:
///
///   N H = M g (w + c) + F w     moments about a pin                 F = m g / 2     forces on the box, upwards
///   F <= mu N                   Coulomb                       =>    mu >= m H / (2 M (w + c) + m w)
///
/// Nothing else balances: a box that slides down has F = mu N, and falls with  g - 2 mu N / m > 0  only where mu is less than that. For
/// mu w >= H the jaws would jam. The box hangs: its centre is below both contacts, and they are below the pins.
struct Grasp {
  Real height = Real(0.4), out = Real(0.15);      ///< m: H, w
  Real load = 4, jaw = 9;                         ///< kg: m, M
  Real mu = Real(0.5);                            ///< of all pairs; 1.43 times the friction needed
  static constexpr Real half = Real(0.2);         ///< m, of the box, across and upwards
  static constexpr Real half_side = Real(0.05);   ///< m, of a jaw's square
  static constexpr Real contact_at = Real(0.05);  ///< m, of the contacts, above the box's centre
  static constexpr Real to_floor = 1;             ///< m, below the pins: what is let go falls there
  static constexpr double seconds = 2;

  /// The least mu that holds.
  Real friction_needed() const;
  /// The floor, the left jaw, the right jaw, the box.
  void operator()(World& world) const;
  std::vector<Pin> pins() const;
  std::vector<Places> truth(int frames) const;
};

/// A square pyramid of convex hulls: layers of 14 x 14, 13 x 13 ... 1. A hull is a block with its four upright edges cut off, an octagonal
/// prism, and stands on a corner of each of the four below. Hulls of a layer do not touch. Patches of contact lie above patches of contact, so
/// normal forces balance every hull: its own weight goes down by four quarters, and a load from above goes straight down.
struct PileOfHulls {
  int base = 14;                                                                    // 1,015 hulls
  static constexpr Real half_width = Real(0.5), cut = Real(0.2), high = Real(0.5);  // m
  static constexpr Real apart = Real(1.1), mass = 100;                              // m, between centres of a layer; kg
  static constexpr double seconds = 0.5;

  void operator()(World& world) const;
  std::vector<Places> truth(int frames) const;
};

}  // namespace pushback::further
