/// The bodies, and what is known of them from step to step.
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

/// Something that pushes or pulls: called as a step begins, it adds to the `force` and `torque` of bodies.
struct Force {
  std::function<void(World&)> apply;
  std::string name = "a force";
  std::vector<int> bodies =
      {};  ///< indices of those that it acts on, and that feel each other through it; empty: of all
};

/// A value: what a copy goes on to do is what the original would have done, to the last bit.
class World {
 public:
  static constexpr Real g = Real(9.81);  ///< m/s^2: what a world has, unless it is changed

  std::vector<Body> bodies;
  Vec3 gravity{0, -g, 0};     ///< m/s^2
  std::vector<Force> forces;  ///< see forces.h
  std::vector<Joint> joints;  ///< each with what it bore in the latest step
  Real time = 0;              ///< s, simulated so far
  /// What touched in the latest step, in ascending order of id, with what the solver did there. A contact that acted in the step is
  /// here also if it has parted.
  Contacts contacts;
  /// Those of the detection before it, each with the impulse of the latest substep that had it, for solvers that start from
  /// there. Contacts of bodies that have just been woken are among them.
  Contacts contacts_before;
  Real dt_before = 0;  ///< s, of the latest substep; 0: there was none
  /// Whether `step` has written Contact::last_impulse. A program that composes its steps by itself writes `impulse` alone.
  bool last_impulses_known = false;
  /// By this an impulse of the latest substep is to be multiplied to be of one of dt, s.
  Real impulse_scale(Real dt) const { return dt_before > 0 ? dt / dt_before : 0; }

  /// Puts a body into the world and returns its index. Throws InvalidInput if a number in it cannot be simulated.
  int add(const Body& body);

  /// Takes a body out of the world, with its joints, the forces that name it and all that is remembered of its contacts. Its place
  /// stays, empty: the indices of all other bodies mean what they meant. Throws InvalidInput unless there is a body at this index.
  void remove(int body);

  /// Moves everything on by dt seconds; see step.h. `sweeps`: in each substep; by default what the solver's plan says. Throws
  /// InvalidInput unless 0 < dt <= 1, sweeps >= 0, every body's state is finite, and the solver can solve what is here; then
  /// nothing has changed. (Where a state becomes infinite between two detections of one step, the world stays as it was
  /// before the later one.)
  void step(StepSolver& solver, Real dt, int sweeps);
  void step(StepSolver& solver, Real dt);

  /// The first part of a step, for those who solve by themselves: all that goes before the solver.
  void begin_step(Real dt);
  /// Finds what touches now, or is within the margin, in the place of what was found.
  void find_contacts(const Margin& margin = {}, Workers& workers = alone());
  /// x += h v and the turn, of all bodies; and time goes on.
  void move(Real dt);

  /// A and B of a contact.
  std::pair<Body&, Body&> bodies_of(const Contact& at) { return {bodies[at.id.body_a], bodies[at.id.body_b]}; }
  std::pair<const Body&, const Body&> bodies_of(const Contact& at) const {
    return {bodies[at.id.body_a], bodies[at.id.body_b]};
  }
  /// The body with this index; for the_world one that never moves, with its centre in the origin.
  Body& body(int index) { return index == the_world ? immovable_ : bodies[static_cast<std::size_t>(index)]; }
  const Body& body(int index) const {
    return index == the_world ? immovable_ : bodies[static_cast<std::size_t>(index)];
  }

 private:
  Body immovable_ = sphere(1, 1).fixed();
};

/// P_B - P_A along n grows at this speed, m/s: (v_B + w_B x r_B - v_A - w_A x r_A) . n.
Real separating_speed(const World& world, const Contact& at);

// ---- what a step does to one body by itself -------------------------------------------------------------------------

/// Throws InvalidInput unless 0 < dt <= 1, sweeps >= 0 and the gravity is finite.
void check_step(Real dt, int sweeps, const Vec3& gravity);
/// Throws InvalidInput if a force acts on a body that is not there, or a joint holds one.
void check_bodies_of(const Force& force, const World& world);
void check_bodies_of(const Joint& joint, const World& world);
/// The same for all of them, and unless each body's index is its place in World::bodies.
void check_places(const World& world);
/// Throws InvalidInput unless every number of the body's state is finite, and its orientation of unit length.
void check_state(const Body& body);
/// velocity_before and angular_velocity_before.
void keep_velocity(Body& body);
/// v += h (g + F/m),  w += h I^-1 tau,  and F = tau = 0.
void integrate_velocity(Body& body, const Vec3& gravity, Real dt);
/// x += h v, and the turn, unless the body conveys; I^-1 in world axes stays behind until it is refreshed.
void integrate_position(Body& body, Real dt);
/// x += h v, the turn, and I^-1.
void move(Body& body, Real dt);

/// Whether a body's inertia differs from axis to axis, so that a free spin does not keep its axis.
bool tumbles(const Body& body);
/// Turns a body by dt seconds of its own spin, all but its I^-1. Nothing acts on it, so its angular momentum L stays as it is, and
/// where it tumbles the angular velocity has to follow (the gyroscopic term, w x I w). One that nothing moves turns by w dt exactly, in
/// however many substeps.
void spin_freely(Body& body, Real dt);
/// The same for a movable one that does not tumble: its angular velocity stays.   q' = normalise(q + h/2 (0, w) q)
void spin_evenly(Body& body, Real dt);

}  // namespace pushback
