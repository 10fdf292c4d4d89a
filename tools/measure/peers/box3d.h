/// Box3D with a world of ours in it, for motions and for hard cases. It computes in float.
#pragma once

#include <box3d/box3d.h>

#include "pushback/tools/measure/peers/engine.h"
#include "pushback/tools/measure/peers/joint_shape.h"

namespace pushback {

/// What its settings differ in. As it comes: none of these.
struct Box3dChoice {
  /// Contacts and joints as stiff as Box3D allows for a substep of h: 1/(8 h) and 1/(4 h) Hz, in the place of 30 and 60 Hz. What
  /// bounces does so at any speed, not from 1 m/s on. Bodies may have 10 km/s, not 400 m/s, and turn by any angle in a step, not 45
  /// degrees.
  bool stiff = false;
  /// Manifolds are made in each step, not kept until two bodies have moved by 5 cm or 10 degrees against each other.
  bool anew = false;
};

class Box3d : public Engine {
 public:
  /// Each step is divided into `substeps`: contacts are detected once for all of them. Throws not_had.
  Box3d(const World& world, const Box3dChoice& choice, int substeps);
  ~Box3d() override { b3DestroyWorld(world_); }
  Box3d(const Box3d&) = delete;
  Box3d& operator=(const Box3d&) = delete;

  void put(const Body& body) override;
  void get(Body& body) const override;
  void drive(const Body& now, const Body& then) override;
  void step(const std::vector<Body>& bodies, Real h) override;
  /// Moves on by h, s, with gravity alone.
  void step(double h, int substeps) { b3World_Step(world_, static_cast<float>(h), substeps); }
  /// Of the centre of mass of the body with this index, m.
  Eigen::Vector3d place(std::size_t body) const;

 private:
  struct Made {
    b3JointId id;
    int a, b;
    JointShape shape;            // of the joint itself, without limits
    Vec3 axis_b = Vec3::Zero();  // of its limits; zero: it has none so far
  };

  b3BodyId its(int index) const { return bodies_[static_cast<std::size_t>(index == the_world ? last_ : index)]; }
  void add(const Body& body);
  void add_shape(b3BodyId made, const Body& body) const;
  void add(const World& world, const Joint& joint, const JointShape& shape);
  Made& made_for(const Joint& joint, JointShape::Kind kind);
  void limit(const World& world, const Joint& joint, const JointShape& shape);

  Box3dChoice choice_;
  int substeps_;
  b3WorldId world_;
  std::vector<b3BodyId> bodies_;  // those of the world, and one that stands for the world
  int last_ = 0;
  std::vector<Made> joints_;
};

}  // namespace pushback
