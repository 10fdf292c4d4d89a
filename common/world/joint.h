/// Joints, as the equations that they impose on their bodies. The chapters define the kinds of joints and the solvers.
#pragma once

#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "pushback/common/bodies/body.h"
#include "pushback/common/world/jacobian.h"

namespace pushback {

class World;

/// The index of a joint's body that stands for the immovable world.
inline constexpr int the_world = -1;

/// The step from `time` to `time + dt`, s.
struct TimeStep {
  Real time, dt;
};

/// One scalar equation C(x, t) = 0 between two bodies, linearised where they are now:   C' = J V + b
///
/// Units are m and N, or rad and N m in a rotational equation.
struct Equation {
  Jacobian jacobian;
  Real error = 0;     ///< C, the error to feed back
  Real bias = 0;      ///< b, per second: the partial derivative dC/dt, or minus the target speed
  Real softness = 0;  ///< gamma, 1/kg or 1/(kg m^2): the speed that it yields per unit of its own impulse
  Real lo = -std::numeric_limits<Real>::infinity();  ///< the least force
  Real hi = std::numeric_limits<Real>::infinity();   ///< the largest force
};
using Equations = std::vector<Equation>;

/// The load that a joint bears, or the largest that it may bear.
struct Load {
  Real force;   ///< N
  Real torque;  ///< N m, without the moment of the force
};

/// Holds two bodies together, or one body to the world.
struct Joint {
  std::string name;  ///< "a hinge"
  int a, b;          ///< indices in World::bodies, or the_world
  /// Appends the equations of the joint, the same number in every step. `a` and `b` are the bodies with its indices.
  std::function<void(const Body& a, const Body& b, const TimeStep& now, Equations& equations)> ask;
  /// The corners (m, world axes) of a thin line that shows the joint, or empty if it is not drawn.
  std::function<std::vector<Vec3>(const Body& a, const Body& b)> line = {};
  bool driven = false;     ///< the equations prescribe a motion or change with time, so its bodies never come to rest
  bool colliding = false;  ///< whether its two bodies may touch; most bodies overlap at their joint
  /// World::step removes the joint after a step in which its average load is larger.
  Load breaks_at = {std::numeric_limits<Real>::infinity(), std::numeric_limits<Real>::infinity()};
  /// The total impulse that the solver applied in the latest step, N s or N m s, for each equation in their order.
  std::vector<Real> impulses = {};
  /// The same for only the last substep, without impulses that only closed gaps. Written by solvers that warm start from it.
  std::vector<Real> last_impulses = {};
};

/// The average load on a joint in the latest step, of dt (s), along its present equations.
Load load_of(const World& world, const Joint& joint, Real dt);
/// Removes the joints that have borne more than `breaks_at`. World::step calls it.
void break_joints(World& world, Real dt);

/// World::body, for code that has only the forward declaration of World.
const Body& body_of(const World& world, int index);

/// Throws InvalidInput, naming the joint, unless a and b are two different bodies, or one of them the_world, at least one can move,
/// and none conveys.
void check_joined(const World& world, const std::string& joint, int a, int b);

/// Throws InvalidInput if there are any joints. For solvers that do not solve joints.
void check_no_joints(const std::vector<Joint>& joints);

/// Converts a point (m) from world coordinates to body axes, from the centre of mass, and back.
inline Vec3 point_on(const Body& body, const Vec3& point) {
  return body.orientation.conjugate() * (point - body.position);
}
inline Vec3 point_of(const Body& body, const Vec3& on_body) {
  return body.position + body.orientation * on_body;
}

/// The pairs of bodies that must not touch because a joint that is not `colliding` joins them.
class JoinedPairs {
 public:
  explicit JoinedPairs(const std::vector<Joint>& joints);
  bool contain(int a, int b) const;

 private:
  std::vector<std::pair<int, int>> pairs_;  // ascending, each with the lower index first
};

}  // namespace pushback
