/// What joints ask of bodies, said as geometry. Chapters say which joints there are, and what solves them.
#pragma once

#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "pushback/common/bodies/body.h"
#include "pushback/common/world/jacobian.h"

namespace pushback {

class World;

/// Stands for a body's index where a joint holds on to the immovable world.
inline constexpr int the_world = -1;

/// The step from `time` to `time + dt`, s.
struct TimeStep {
  Real time, dt;
};

/// One scalar equation C(x, t) = 0 between two bodies, as it stands where they are now:   C' = J V + b
///
/// Lengths are in m, forces in N; of an equation between turns, rad and N m.
struct Equation {
  Jacobian jacobian;
  Real error = 0;     ///< C: what is to be fed back
  Real bias = 0;      ///< b, a second: of C that depends on time, or minus a speed that is wanted
  Real softness = 0;  ///< gamma, 1/kg or 1/(kg m^2): how far it gives way to its own impulse
  Real lo = -std::numeric_limits<Real>::infinity();  ///< the least force
  Real hi = std::numeric_limits<Real>::infinity();   ///< the largest
};
using Equations = std::vector<Equation>;

/// What a joint bears, or may bear at most.
struct Load {
  Real force;   ///< N
  Real torque;  ///< N m, beside that of the force
};

/// Something that holds two bodies together, or one to the world.
struct Joint {
  std::string name;  ///< "a hinge"
  int a, b;          ///< indices in World::bodies, or the_world
  /// Appends its equations, as many of them in every step. The bodies are those of the indices.
  std::function<void(const Body& a, const Body& b, const TimeStep& now, Equations& equations)> ask;
  /// The corners of a thin line that shows it, m, world axes; empty: it is not drawn.
  std::function<std::vector<Vec3>(const Body& a, const Body& b)> line = {};
  bool driven =
      false;  ///< asks for a motion, or for something else at another time: what it holds does not come to rest
  bool colliding = false;  ///< whether the two may touch. Mostly they overlap where they are joined
  /// A step in which it bears more, on average, is its last: World::step takes it out of the world then.
  Load breaks_at = {std::numeric_limits<Real>::infinity(), std::numeric_limits<Real>::infinity()};
  /// N s, or N m s, for each of its equations, in their order: all that the solver applied in the latest step.
  std::vector<Real> impulses = {};
  /// The same for the step's last substep alone, without what only closed gaps. Kept by solvers that start from it.
  std::vector<Real> last_impulses = {};
};

/// What a joint has borne in the latest step, of dt (s), along its equations as they are now.
Load load_of(const World& world, const Joint& joint, Real dt);
/// Takes out of the world what has borne more than it may. World::step calls it.
void break_joints(World& world, Real dt);

/// World::body, for those who know the world by its name only.
const Body& body_of(const World& world, int index);

/// Throws InvalidInput unless a and b are two different bodies, or one of them the_world, one can move, and none conveys.
void check_joined(const World& world, const std::string& joint, int a, int b);

/// Throws InvalidInput if there are any: for a solver that holds none.
void check_no_joints(const std::vector<Joint>& joints);

/// Where a point of the world (m) is on the body, body axes from its centre of mass; and back.
inline Vec3 point_on(const Body& body, const Vec3& point) {
  return body.orientation.conjugate() * (point - body.position);
}
inline Vec3 point_of(const Body& body, const Vec3& on_body) {
  return body.position + body.orientation * on_body;
}

/// Which pairs are joined and are therefore not to touch.
class JoinedPairs {
 public:
  explicit JoinedPairs(const std::vector<Joint>& joints);
  bool contain(int a, int b) const;

 private:
  std::vector<std::pair<int, int>> pairs_;  // each the lower index first, ascending
};

}  // namespace pushback
