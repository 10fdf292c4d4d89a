/// The seven chapters in one piece: no effects, no hooks, every line where it happens. What FullSolver is composed of is
/// written out here by hand; a test holds the two to the same bits, a benchmark compares their times.
#pragma once

#include <vector>

#include "pushback/common/world/step.h"

namespace pushback {

class FlatSolver : public StepSolver {
 public:
  Real beta = Real(0.2);
  Real slop = Real(0.005);     ///< m
  Real threshold = Real(0.1);  ///< m/s

  void solve(World& world, Real dt, int sweeps);

 private:
  /// What one direction of one contact needs.
  struct Direction {
    Vec3 n, ra_n, rb_n, dva, dwa, dvb, dwb;
    Real effective_mass, impulse;
  };
  struct Point {
    Body *a, *b;
    Real bias, friction;
    Direction normal, tangent1, tangent2;
  };

  static Direction direction(const Body& a, const Body& b, const Vec3& point, const Vec3& n);
  static Real speed(const Point& p, const Direction& d);
  static void apply(const Point& p, const Direction& d, Real lambda);
  static void reach(const Point& p, Direction& d, Real total, Real lo, Real hi);

  std::vector<Point> points_;
};

}  // namespace pushback
