/// Jolt with a world of ours in it, for motions and for hard cases. It computes in float, here on one thread.
#pragma once

// Theirs begins with this one.
#include <Jolt/Jolt.h>
//
#include <Jolt/Core/JobSystemSingleThreaded.h>
#include <Jolt/Core/TempAllocator.h>
#include <Jolt/Physics/Body/Body.h>
#include <Jolt/Physics/Collision/BroadPhase/BroadPhaseLayerInterfaceTable.h>
#include <Jolt/Physics/Collision/BroadPhase/ObjectVsBroadPhaseLayerFilterTable.h>
#include <Jolt/Physics/Collision/ContactListener.h>
#include <Jolt/Physics/Collision/GroupFilterTable.h>
#include <Jolt/Physics/Collision/ObjectLayerPairFilterTable.h>
#include <Jolt/Physics/PhysicsSystem.h>

#include <optional>

#include "pushback/tools/measure/peers/engine.h"
#include "pushback/tools/measure/peers/joint_shape.h"

namespace pushback {

/// What its settings differ in.
struct JoltChoice {
  /// Bounces at any speed, no overlap that is let be, no rounding of corners, a gyroscopic torque, and as many velocity sweeps
  /// as are asked, a quarter as many of positions. Else as it comes: 10 and 2; it bounces from 1 m/s on, leaves 20 mm, and
  /// rounds by 50 mm.
  bool tuned = false;
  int sweeps = 10;
};

/// Once in a program, before anything else of Jolt's.
void start_jolt();

/// Contacts of surfaces that convey.
class Belts : public JPH::ContactListener {
 public:
  /// m/s, world axes; 0 where no surface of the body conveys.
  std::vector<JPH::Vec3> speeds;  // in the order of Body::GetUserData

  void OnContactAdded(const JPH::Body& one, const JPH::Body& other, const JPH::ContactManifold&,
                      JPH::ContactSettings& settings) override {
    settings.mRelativeLinearSurfaceVelocity = speeds[other.GetUserData()] - speeds[one.GetUserData()];
  }
  void OnContactPersisted(const JPH::Body& one, const JPH::Body& other, const JPH::ContactManifold& manifold,
                          JPH::ContactSettings& settings) override {
    OnContactAdded(one, other, manifold, settings);
  }
};

class Jolt : public Engine {
 public:
  /// Throws not_had.
  Jolt(const World& world, const JoltChoice& choice);
  ~Jolt() override;
  Jolt(const Jolt&) = delete;
  Jolt& operator=(const Jolt&) = delete;

  void put(const Body& body) override;
  void get(Body& body) const override;
  void drive(const Body& now, const Body& then) override;
  void step(const std::vector<Body>& bodies, Real h) override;
  /// Moves on by h, s, with gravity alone. Throws InvalidInput where Jolt has no room for the contacts.
  void step(float h);
  /// Of the centre of mass of the body with this index, m.
  Eigen::Vector3d place(std::size_t body) const;

 private:
  /// A joint with its limits and its motor: each is a single constraint of Jolt's.
  struct Asked {
    const Joint* joint;
    JointShape shape;
    std::optional<JointShape> turn, cone, motor;  // angle or twist limits, a cone, and what drives a hinge
  };

  JPH::Body& its(int index) const;
  JPH::RefConst<JPH::Shape> shape_of(const Body& body) const;
  void add(const Body& body);
  void add(const Asked& asked);
  void add_socket_with_limits(const Asked& asked);

  JoltChoice choice_;
  JPH::ObjectLayerPairFilterTable pairs_{2};
  JPH::BroadPhaseLayerInterfaceTable layers_{2, 2};
  std::optional<JPH::ObjectVsBroadPhaseLayerFilterTable> layer_pairs_;
  JPH::TempAllocatorImplWithMallocFallback memory_{8 << 20};
  JPH::JobSystemSingleThreaded jobs_{JPH::cMaxPhysicsJobs};
  Belts belts_;
  JPH::PhysicsSystem system_;
  JPH::Ref<JPH::GroupFilterTable> unjoined_;
  std::vector<JPH::Body*> bodies_;
};

}  // namespace pushback
