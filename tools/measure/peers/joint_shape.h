/// Which joint a Joint is, read off what it asks for: engines have joints, not equations.
#pragma once

#include <initializer_list>
#include <optional>

#include "pushback/common/world/joint.h"

namespace pushback {

/// World axes, as the bodies stand now.
struct JointShape {
  enum class Kind { ball_and_socket, hinge, angle_limits, twist_limits, cone_limit, motor };
  using enum Kind;
  Kind kind;
  Vec3 anchor_a = Vec3::Zero(), anchor_b = Vec3::Zero();  ///< m; of a ball and socket, and of a hinge
  Vec3 axis = Vec3::Zero();  ///< unit; of a hinge, a motor and limits of a turn; of a cone limit the one that A carries
  Vec3 axis_b = Vec3::Zero();  ///< unit; of a cone limit the one that B carries
  Real low = 0, high = 0;      ///< rad; of limits, from where the bodies stand now. Of a cone: high, its half angle
  Real speed = 0, torque = 0;  ///< rad/s of B against A about the axis, and the most in N m; of a motor
};

/// Throws not_had, naming the joint, where it is none of these.
JointShape shape_of(const World& world, const Joint& joint);

/// A ball and socket or a hinge, with the limits and the motor that act on the same two bodies: in most engines one joint has them all.
struct HeldPair {
  const Joint* joint;  ///< of the world
  JointShape shape;
  std::optional<JointShape> turn = {}, cone = {},
                            motor = {};  ///< angle or twist limits; a cone limit; what drives a hinge
};

inline constexpr auto every_kind = {JointShape::ball_and_socket, JointShape::hinge,      JointShape::angle_limits,
                                    JointShape::twist_limits,    JointShape::cone_limit, JointShape::motor};

/// In the order of the world's joints. `had`: the kinds that the engine has. Throws not_had, naming the joint, for another kind, and for
/// a limit or motor of two bodies that no such joint holds before it.
std::vector<HeldPair> held_pairs(const World& world, std::initializer_list<JointShape::Kind> had = every_kind);

/// The same limits or the same motor, about the one of `axis` and `-axis` that is `axis`.
JointShape turned_to(JointShape shape, const Vec3& axis);

}  // namespace pushback
