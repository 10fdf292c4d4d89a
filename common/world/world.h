/// The world: bodies, forces and joints, and the contacts kept from step to step.
#pragma once

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "pushback/common/basics/workers.h"
#include "pushback/common/bodies/body.h"
#include "pushback/common/collision/contact.h"
#include "pushback/common/collision/margin.h"
#include "pushback/common/world/joint.h"

namespace pushback {

class World;
class StepSolver;

/// An applied force. `apply` is called in each substep and adds to the `force` and `torque` of bodies.
struct Force {
  std::function<void(World&)> apply;
  std::string name = "a force";
  std::vector<int> bodies = {};  ///< indices of the bodies that it acts on and couples to each other; empty: all bodies
};

/// A value type. A copy continues as the original would, to the last bit.
class World {
 public:
  static constexpr Real g = Real(9.81);  ///< m/s^2, the default gravity

  std::vector<Body> bodies;
  Vec3 gravity{0, -g, 0};     ///< m/s^2
  std::vector<Force> forces;  ///< see forces.h
  std::vector<Joint> joints;  ///< each with its impulses of the latest step
  Real time = 0;              ///< s, simulated so far
  /// The contacts of the latest step, in ascending order of id, with the solver's impulses. They include contacts that acted in the
  /// step and have parted.
  Contacts contacts;
  /// The contacts of the detection before, each with the impulse of the latest substep that had it, for solvers that warm start.
  /// They include contacts of bodies that have just been woken.
  Contacts contacts_before;
  Real dt_before = 0;  ///< s, of the latest substep; 0 before the first
  /// Whether `step` has written Contact::last_impulse. A program that composes its own steps writes only `impulse`.
  bool last_impulses_known = false;
  /// The factor that scales an impulse of the latest substep to a substep of dt, s; 0 before the first substep.
  Real impulse_scale(Real dt) const { return dt_before > 0 ? dt / dt_before : 0; }

  /// Puts a body into the world and returns its index. Throws InvalidInput if a number in it cannot be simulated.
  int add(const Body& body);

  /// Takes a body out of the world, with its joints, the forces that name it, and its contacts. Its place stays empty, so that the
  /// indices of all other bodies stay valid. Throws InvalidInput unless there is a body at this index.
  void remove(int body);

  /// Advances the world by dt (s), see step.h. `sweeps`: in each substep, by default the number in the solver's plan. Throws
  /// InvalidInput unless 0 < dt <= 1, sweeps >= 0, every body's state is finite, and the solver can solve this world. No body has
  /// moved then. (If a state becomes infinite between two detections of one step, the world stays as it was before the later
  /// detection.)
  void step(StepSolver& solver, Real dt, int sweeps);
  void step(StepSolver& solver, Real dt);

  /// The first part of a step, which is everything before the solver, for programs that solve by themselves.
  void begin_step(Real dt);
  /// Replaces `contacts` by the contacts of bodies that touch now or are within the margin.
  void find_contacts(const Margin& margin = {}, Workers& workers = alone());
  /// x += h v and the rotation of all bodies, and time += h.
  void move(Real dt);

  /// A and B of a contact.
  std::pair<Body&, Body&> bodies_of(const Contact& at) { return {bodies[at.id.body_a], bodies[at.id.body_b]}; }
  std::pair<const Body&, const Body&> bodies_of(const Contact& at) const {
    return {bodies[at.id.body_a], bodies[at.id.body_b]};
  }
  /// The body with this index. For the_world, it is an immovable body with its centre at the origin.
  Body& body(int index) { return index == the_world ? immovable_ : bodies[static_cast<std::size_t>(index)]; }
  const Body& body(int index) const {
    return index == the_world ? immovable_ : bodies[static_cast<std::size_t>(index)];
  }

 private:
  Body immovable_ = sphere(1, 1).fixed();
};

/// The speed (m/s) at which P_B - P_A grows along n: (v_B + w_B x r_B - v_A - w_A x r_A) . n.
Real separating_speed(const World& world, const Contact& at);

// ---- the parts of a step, for one body -------------------------------------------------------------------------------

/// Throws InvalidInput unless 0 < dt <= 1, sweeps >= 0 and the gravity is finite.
void check_step(Real dt, int sweeps, const Vec3& gravity);
/// Throws InvalidInput if the force acts on, or the joint holds, a body that is not in the world, or if the joint joins a body to
/// itself.
void check_bodies_of(const Force& force, const World& world);
void check_bodies_of(const Joint& joint, const World& world);
/// The same for all forces and joints. Also throws unless each body's index is its place in World::bodies.
void check_places(const World& world);
/// Throws InvalidInput unless every number of the body's state is finite and its orientation has unit length.
void check_state(const Body& body);
/// Sets velocity_before and angular_velocity_before.
void keep_velocity(Body& body);
/// v += h (g + F/m),  w += h I^-1 tau,  and F = tau = 0.
void integrate_velocity(Body& body, const Vec3& gravity, Real dt);
/// x += h v and the rotation, unless the body conveys. Does not refresh I^-1.
void integrate_position(Body& body, Real dt);
/// x += h v and the rotation, unless the body conveys. Refreshes I^-1.
void move(Body& body, Real dt);

/// Whether a body's inertia differs from axis to axis, so that a free spin does not keep its axis.
bool tumbles(const Body& body);
/// Turns a body by dt seconds of its own spin, without refreshing I^-1. No torque acts, so its angular momentum L is constant. If the
/// body tumbles, its angular velocity changes accordingly (the gyroscopic term, w x I w). An immovable body turns by exactly w dt,
/// whatever the number of substeps.
void spin_freely(Body& body, Real dt);
/// The same for a movable body that does not tumble, at constant angular velocity:   q' = normalise(q + h/2 (0, w) q)
void spin_evenly(Body& body, Real dt);

}  // namespace pushback
