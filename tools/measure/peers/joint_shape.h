/// Finds the kind of a Joint from its equations, because engines have kinds of joints instead of equations.
#pragma once

#include <initializer_list>
#include <optional>

#include "pushback/common/world/joint.h"

namespace pushback {

/// The kind of a joint and its parameters, in world axes for the current poses.
struct JointShape {
  enum class Kind { ball_and_socket, hinge, angle_limits, twist_limits, cone_limit, motor };
  using enum Kind;
  Kind kind;
  Vec3 anchor_a = Vec3::Zero(), anchor_b = Vec3::Zero();  ///< m, for a ball and socket or a hinge
  Vec3 axis = Vec3::Zero();    ///< unit, of a hinge, a motor or angle limits; for a cone limit the axis fixed in A
  Vec3 axis_b = Vec3::Zero();  ///< unit, for a cone limit the direction fixed in B
  Real low = 0, high = 0;      ///< rad, limits relative to the current poses; for a cone, `high` is its half angle
  Real speed = 0, torque = 0;  ///< for a motor: rad/s of B relative to A about the axis, and its largest torque, N m
};

/// Throws not_had, naming the joint, if it is none of these kinds.
JointShape shape_of(const World& world, const Joint& joint);

/// A ball and socket or a hinge, with the limits and the motor that act on the same two bodies. Most engines combine them in one joint.
struct HeldPair {
  const Joint* joint;  ///< a joint of the world
  JointShape shape;
  std::optional<JointShape> turn = {}, cone = {},
                            motor = {};  ///< angle or twist limits; a cone limit; the motor of a hinge
};

inline constexpr auto every_kind = {JointShape::ball_and_socket, JointShape::hinge,      JointShape::angle_limits,
                                    JointShape::twist_limits,    JointShape::cone_limit, JointShape::motor};

/// The pairs in the order of the world's joints. `had`: the kinds that the engine has. Throws not_had, naming the joint, for another
/// kind, and for a limit or motor whose two bodies are not held by an earlier ball and socket or hinge.
std::vector<HeldPair> held_pairs(const World& world, std::initializer_list<JointShape::Kind> had = every_kind);

/// The same limits or motor, expressed about `axis`, which is the axis of `shape` or its opposite.
JointShape turned_to(JointShape shape, const Vec3& axis);

}  // namespace pushback
