/// Updates a row whose bodies have moved past each other.
#pragma once

#include "pushback/chapters/01_velocity_constraint/row.h"

namespace pushback {

/// Both arms lead to one point if  r_A x n - r_B x n = (x_B - x_A) x n.  The two arms share the change m of the right side:
///
///   r_A x n += s m,   r_B x n -= (1 - s) m      so J V changes by  -s m . w_A - (1 - s) m . w_B
///
/// The body that rotates more slowly gets the larger share, so that J V does not change and a rolling body is not braked. `way`:
/// the change of x_B - x_A, m.
inline void carry(Row& row, const Vec3& way) {
  const Vec3 m = way.cross(row.n);
  const Real of_a = std::abs(m.dot(row.a->angular_velocity)), of_b = std::abs(m.dot(row.b->angular_velocity));
  const Real inverse_masses = row.a->inverse_mass + row.b->inverse_mass;
  const Real s = of_a + of_b > 0 ? of_b / (of_a + of_b) : row.b->inverse_mass / inverse_masses;
  row.ra_n += s * m;
  row.rb_n -= (1 - s) * m;
  row.weigh();
}

}  // namespace pushback
