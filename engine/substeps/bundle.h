/// Contacts of eight pairs of bodies side by side, as plain arrays: what files compiled for different processors hand each other.
///
/// Nothing here is a function that two such files could share: the linker would keep one for both.
#pragma once

namespace pushback {

inline constexpr int lanes_of_bundle = 8;

/// A number for each of eight pairs.
template <class Real>
struct alignas(lanes_of_bundle * sizeof(Real)) Eight {
  Real of[lanes_of_bundle];
};
template <class Real>
struct EightVectors {
  Eight<Real> x, y, z;
};
template <class Real>
struct EightSymmetric {
  Eight<Real> xx, xy, xz, yy, yz, zz;
};

/// A row of chapter 01: what J has beside n, and what M^-1 J^T has beside the masses.
template <class Real>
struct WideRow {
  EightVectors<Real> ra_n, rb_n, dwa, dwb;
  Eight<Real> impulse;  ///< N s
};
/// Where a point of contact of each pair is: what its rows are made of.
template <class Real>
struct WidePoint {
  EightVectors<Real> arm_a, arm_b;  ///< m, from the centres of mass
  Eight<Real> gap;                  ///< C_0, m
  Eight<Real> present;              ///< 1; or 0 where a pair has fewer points
};
/// A point of contact of each pair: a KeptContact of chapter 21.
template <class Real>
struct WideContact {
  WideRow<Real> normal, tangent1, tangent2;
  Eight<Real> found, restitution, rigid_mass, step_size;  ///< C_0, e, 1 / K, 1 / k; all 0 where a pair has fewer points
  Eight<Real> bias, softness, mass, bounce;               ///< b, gamma, 1 / (K + gamma), e v_n, of this pass
  EightVectors<Real> sum;                                 ///< N s, on B, world axes: over the substeps so far
};
/// Eight pairs, no two of which share a body that moves.
template <class Real>
struct Bundle {
  int a[lanes_of_bundle], b[lanes_of_bundle];  ///< in the list of bodies
  Eight<Real> inverse_mass_a, inverse_mass_b, friction;
  EightSymmetric<Real> inverse_inertia_a, inverse_inertia_b;  ///< I^-1, world axes
  EightVectors<Real> n, tangent1, tangent2;
  EightVectors<Real> found_n, found_tangent1, found_tangent2;  ///< as detected
  Eight<Real> on_a, on_b,
      between;  ///< 1: n turns with A; with B; is the direction from core to core. Else rows are carried
  Eight<Real> radius_a, radius_b;  ///< m: so far is what is touched, skin and all, from its core
  Eight<Real> reach_a, reach_b;    ///< m, the longest arm
  EightVectors<Real> placed_way, placed_turn_a,
      placed_turn_b;         ///< when the rows were placed: by which B had moved past A, m, and
                             ///< by which each had turned, rad, since detection
  Eight<Real> stays_within;  ///< m, squared: once a pair has moved or turned as far since, its rows are placed anew
  int first, end;            ///< of its contacts in their list: as many as the pair with the most points has
};

/// v and w of a body, or x and theta: in m/s and rad/s, or m and rad; and two numbers that are nothing.
template <class Real>
struct alignas(8 * sizeof(Real)) Twist {
  Real of[8];
};

/// I^-1 of a body, world axes.
template <class Real>
struct alignas(8 * sizeof(Real)) Inertia {
  Real of[6], none[2];  ///< xx, xy, xz, yy, yz, zz
};

/// Eight bodies that turn.
template <class Real>
struct Turning {
  Eight<Real> x, y, z, s;              ///< their orientation, a unit quaternion with the scalar part s
  EightVectors<Real> w;                ///< rad/s, world axes
  EightVectors<Real> inverse_inertia;  ///< the principal ones, 1/(kg m^2)
  Eight<Real> solved;                  ///< 1; or 0 where it turns so far that Newton's method has not followed
};

/// All of it.
template <class Real>
struct Bundles {
  Bundle<Real>* bundles;
  int count;
  const WidePoint<Real>* points;
  WideContact<Real>* contacts;
  Twist<Real>*now, *before;   ///< of each body: its velocity; that as the substep began
  Twist<Real>*moved, *given;  ///< what it has moved since detection; what its contacts' impulses add to its velocity
  const Inertia<Real>* inertias;
  EightVectors<Real>* starts;  ///< of each contact: the impulses that a substep in which something bounces starts from
};

/// What soft contacts ask for: PushOut of chapter 21.
template <class Real>
struct WidePushOut {
  Real rate, gamma_by_K, fastest, threshold, h;
};

/// The passes over all contacts, for one number of lanes and one kind of processor.
template <class Real>
struct Passes {
  const char* processor;
  int lanes;
  void (*prepare)(const Bundles<Real>&);
  Real (*prepare_substep)(const Bundles<Real>&, const WidePushOut<Real>&);  ///< returns the fastest bounce, m/s
  void (*along)(const Bundles<Real>&);
  void (*relax)(const Bundles<Real>&);
  Real (*solve_normals)(const Bundles<Real>&);           ///< all normals; returns by how much it changed a speed, m/s
  void (*solve_friction)(const Bundles<Real>&);          ///< all tangents
  void (*solve_friction_and_sum)(const Bundles<Real>&);  ///< the same, the last pass of a substep: impulses are summed
  void (*save_impulses)(const Bundles<Real>&);
  void (*restore)(const Bundles<Real>&);
  void (*turn)(Turning<Real>&, Real h);
};

/// For any processor, and for one with AVX2. `lanes`: 1, 4 or 8.
template <class Real>
Passes<Real> plain_passes(int lanes);
template <class Real>
Passes<Real> avx2_passes(int lanes);
template <>
Passes<float> plain_passes(int lanes);
template <>
Passes<double> plain_passes(int lanes);
template <>
Passes<float> avx2_passes(int lanes);
template <>
Passes<double> avx2_passes(int lanes);

}  // namespace pushback
