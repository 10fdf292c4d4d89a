/// What of ours becomes what of Bullet's. BT_USE_DOUBLE_PRECISION has to fit the libraries.
#pragma once

#include <btBulletDynamicsCommon.h>

#include <memory>

#include "pushback/common/bodies/body.h"

namespace pushback {

inline btVector3 bullet(const Vec3& v) {
  return {static_cast<btScalar>(v.x()), static_cast<btScalar>(v.y()), static_cast<btScalar>(v.z())};
}

inline btQuaternion bullet(const Quat& q) {
  return {static_cast<btScalar>(q.x()), static_cast<btScalar>(q.y()), static_cast<btScalar>(q.z()),
          static_cast<btScalar>(q.w())};
}

/// A half-space is a plane under balls. Under boxes it is a slab of half that depth, m, as Bullet finds one corner of a box on
/// a plane in a step, but all four of a box on a box.
struct Slab {
  bool used = false;
  btScalar half = 20;

  std::unique_ptr<btCollisionShape> shape_of(const Body& body) const {
    if (const auto* ball = std::get_if<Sphere>(&body.shape))
      return std::make_unique<btSphereShape>(static_cast<btScalar>(ball->radius));
    if (const auto* box = std::get_if<Box>(&body.shape)) return std::make_unique<btBoxShape>(bullet(box->half_extents));
    if (const auto* capsule = std::get_if<Capsule>(&body.shape))
      return std::make_unique<btCapsuleShape>(static_cast<btScalar>(capsule->radius),
                                              static_cast<btScalar>(2 * capsule->half_length));
    if (const auto* hull = std::get_if<Hull>(&body.shape)) {
      auto made = std::make_unique<btConvexHullShape>();
      for (const Vec3& corner : hull->solid->corners) made->addPoint(bullet(corner), false);
      made->recalcLocalAabb();
      return made;
    }
    if (used) return std::make_unique<btBoxShape>(btVector3(half, half, half));
    return std::make_unique<btStaticPlaneShape>(bullet(std::get<HalfSpace>(body.shape).normal), btScalar(0));
  }

  /// Where the shape's origin is and how it is turned.
  btTransform transform_of(const Body& body) const {
    const auto* half_space = std::get_if<HalfSpace>(&body.shape);
    if (half_space == nullptr || !used) return btTransform(bullet(body.orientation), bullet(body.position));
    const btTransform top(bullet(Quat::FromTwoVectors(Vec3::UnitY(), half_space->normal)), bullet(body.position));
    return top * btTransform(btQuaternion::getIdentity(), btVector3(0, -half, 0));
  }
};

/// The inertia is the true one: Bullet's own would be of the shape with its margin around it.
inline btRigidBody::btRigidBodyConstructionInfo mass_of(const Body& body, btCollisionShape* shape) {
  btRigidBody::btRigidBodyConstructionInfo info(0, nullptr, shape);
  if (body.movable()) {
    info.m_mass = static_cast<btScalar>(1 / body.inverse_mass);
    info.m_localInertia = bullet(Vec3(body.principal_inverse_inertia.cwiseInverse()));
  }
  return info;
}

}  // namespace pushback
