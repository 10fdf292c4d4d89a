/// What of ours becomes what of ODE's.
#pragma once

#include <ode/ode.h>

#include <stdexcept>
#include <vector>

#include "pushback/common/bodies/body.h"

namespace pushback {

/// Once in a program, before anything else. Where ODE cannot solve a step it would say so, once for each, and go on: errors tell.
inline void start_ode() {
  static const bool ready = dInitODE2(0) != 0;
  if (!ready) throw std::runtime_error("ODE does not start");
  dSetMessageHandler([](int, const char*, va_list) {});
}

/// A hull as ODE wants it, which does not copy it.
struct OdeHull {
  std::vector<dReal> planes, points;
  std::vector<unsigned int> polygons;

  explicit OdeHull(const Polyhedron& solid) {
    for (const Polyhedron::Face& face : solid.faces) {
      planes.insert(planes.end(), {face.normal.x(), face.normal.y(), face.normal.z(), face.offset});
      polygons.push_back(static_cast<unsigned int>(face.corners.size()));
      polygons.insert(polygons.end(), face.corners.begin(), face.corners.end());
    }
    for (const Vec3& corner : solid.corners) points.insert(points.end(), {corner.x(), corner.y(), corner.z()});
  }
  dGeomID made(dSpaceID space) const {
    return dCreateConvex(space, planes.data(), static_cast<unsigned int>(planes.size() / 4), points.data(),
                         static_cast<unsigned int>(points.size() / 3), polygons.data());
  }
};

inline dMass mass_of(const Body& body) {
  const Eigen::Vector3d inertia = body.principal_inverse_inertia.cast<double>().cwiseInverse();
  dMass mass;
  dMassSetParameters(&mass, 1 / static_cast<double>(body.inverse_mass), 0, 0, 0, inertia.x(), inertia.y(), inertia.z(),
                     0, 0, 0);
  return mass;
}

inline void put_where(dBodyID made, const Body& body) {
  const Eigen::Quaterniond q = body.orientation.cast<double>();
  const dQuaternion turn{q.w(), q.x(), q.y(), q.z()};
  dBodySetPosition(made, body.position.x(), body.position.y(), body.position.z());
  dBodySetQuaternion(made, turn);
  dBodySetLinearVel(made, body.velocity.x(), body.velocity.y(), body.velocity.z());
  dBodySetAngularVel(made, body.angular_velocity.x(), body.angular_velocity.y(), body.angular_velocity.z());
}

inline Eigen::Vector3d velocity_at(dBodyID body, const dVector3& point) {
  dVector3 velocity{};
  if (body != nullptr) dBodyGetPointVel(body, point[0], point[1], point[2], velocity);
  return {velocity[0], velocity[1], velocity[2]};
}

/// The first direction of friction becomes that of sliding, where there is any. `runs`: m/s, of a's surface over a, less that of b's.
inline void align(dContact& contact, dBodyID a, dBodyID b, const Eigen::Vector3d& runs = Eigen::Vector3d::Zero()) {
  const Eigen::Map<const Eigen::Vector3d> n(contact.geom.normal);
  Eigen::Vector3d sliding = velocity_at(a, contact.geom.pos) - velocity_at(b, contact.geom.pos) + runs;
  sliding -= n.dot(sliding) * n;
  if (sliding.norm() < 1e-6) return;
  contact.surface.mode |= dContactFDir1;
  Eigen::Map<Eigen::Vector3d>(contact.fdir1) = sliding.normalized();
}

/// One of the two is no body, and its surface runs with `belt`, m/s: friction pulls the other one towards that. ODE asks for the speeds
/// along its two directions, t1 and n x t1, so t1 has to be said. `turned`: the body is the second of the two, and n is turned round.
inline void convey(dContact& contact, const Eigen::Vector3d& belt, bool turned) {
  const Eigen::Vector3d n = (turned ? -1 : 1) * Eigen::Map<const Eigen::Vector3d>(contact.geom.normal);
  Eigen::Map<Eigen::Vector3d> t1(contact.fdir1);
  if ((contact.surface.mode & dContactFDir1) == 0) {
    dVector3 second;
    const dVector3 normal{n.x(), n.y(), n.z()};
    dPlaneSpace(normal, contact.fdir1, second);
  }
  contact.surface.mode |= dContactFDir1 | dContactMotion1 | dContactMotion2;
  contact.surface.motion1 = belt.dot(t1);
  contact.surface.motion2 = belt.dot(n.cross(t1));
}

}  // namespace pushback
