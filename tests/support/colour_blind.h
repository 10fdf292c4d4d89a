/// How far two colours are apart for those who see them all, and for the colour-blind.
#pragma once

#include <array>
#include <cmath>
#include <string>

#include "pushback/common/basics/types.h"
#include "pushback/common/render/palette.h"

namespace pushback {

/// Of linear red, green and blue: everybody's; without the cones for red (protanopia), without those for green (deuteranopia).
/// G. Machado, M. Oliveira, L. Fernandes, "A physiologically-based model for simulation of color vision deficiency", IEEE
/// TVCG 2009: the matrices of severity 1.
inline std::array<Mat3, 3> ways_to_see() {
  Mat3 protanopia, deuteranopia;
  protanopia << Real(0.152286), Real(1.052583), Real(-0.204868), Real(0.114503), Real(0.786281), Real(0.099216),
      Real(-0.003882), Real(-0.048116), Real(1.051998);
  deuteranopia << Real(0.367322), Real(0.860646), Real(-0.227968), Real(0.280085), Real(0.672501), Real(0.047413),
      Real(-0.011820), Real(0.042940), Real(0.968881);
  return {Mat3(Mat3::Identity()), protanopia, deuteranopia};
}

/// CIELAB.
inline Vec3 seen(Ink ink, const Mat3& eyes) {
  const Colour colour = linear(ink);
  const Vec3 light = (eyes * Vec3(colour.red, colour.green, colour.blue)).cwiseMax(0).cwiseMin(1);
  const auto f = [](Real t) { return t > Real(0.008856) ? std::cbrt(t) : Real(7.787) * t + Real(16) / 116; };
  const Real x = f(light.dot(Vec3(Real(0.4124), Real(0.3576), Real(0.1805))) / Real(0.9505));
  const Real y = f(light.dot(Vec3(Real(0.2126), Real(0.7152), Real(0.0722))));
  const Real z = f(light.dot(Vec3(Real(0.0193), Real(0.1192), Real(0.9505))) / Real(1.089));
  return {116 * y - 16, 500 * (x - y), 200 * (y - z)};
}

/// CIE76: 2.3 can just be told apart side by side, 100 is black and white.
inline Real apart(Ink one, Ink other, const Mat3& eyes) {
  return (seen(one, eyes) - seen(other, eyes)).norm();
}

/// Of "#rrggbb".
inline Ink ink_of(const std::string& colour) {
  const unsigned long rgb = std::stoul(colour.substr(1), nullptr, 16);
  return {static_cast<std::uint8_t>(rgb >> 16 & 255), static_cast<std::uint8_t>(rgb >> 8 & 255),
          static_cast<std::uint8_t>(rgb & 255)};
}

}  // namespace pushback
