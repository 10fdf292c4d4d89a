/// Contacts of eight pairs of bodies side by side, as plain arrays: what files compiled for different processors hand each other.
///
/// Nothing here is a function that two such files could share: the linker would keep one for both.
#pragma once

namespace pushback {

inline constexpr int lanes_per_bundle = 8;

/// A number for each of eight pairs.
template <class Real>
struct alignas(lanes_per_bundle * sizeof(Real)) EightNumbers {
  Real values[lanes_per_bundle];
};
template <class Real>
struct EightVectors {
  EightNumbers<Real> x, y, z;
};
template <class Real>
struct EightSymmetricMatrices {
  EightNumbers<Real> xx, xy, xz, yy, yz, zz;
};

/// A row of chapter 01: what J has beside n, and what M^-1 J^T has beside the masses.
template <class Real>
struct WideRow {
  EightVectors<Real> ra_n, rb_n, dwa, dwb;
  EightNumbers<Real> impulse;  ///< N s
};
/// Where a point of contact of each pair is: what its rows are made of.
template <class Real>
struct WidePoint {
  EightVectors<Real> arm_a, arm_b;  ///< m, from the centres of mass
  EightNumbers<Real> gap;           ///< C_0, m
  EightNumbers<Real> present;       ///< 1; or 0 where a pair has fewer points
};
/// A point of contact of each pair: a KeptContact of chapter 21.
template <class Real>
struct WideContact {
  WideRow<Real> normal, tangent1, tangent2;
  EightNumbers<Real> found, restitution, rigid_mass,
      step_size;                                    ///< C_0, e, 1 / K, 1 / k; all 0 where a pair has fewer points
  EightNumbers<Real> bias, softness, mass, bounce;  ///< b, gamma, 1 / (K + gamma), e v_n, of this pass
  EightVectors<Real> sum;                           ///< N s, on B, world axes: over the substeps so far
};
/// Eight pairs, no two of which share a body that moves.
template <class Real>
struct Bundle {
  int a[lanes_per_bundle], b[lanes_per_bundle];  ///< in the list of bodies
  EightNumbers<Real> inverse_mass_a, inverse_mass_b, friction;
  EightSymmetricMatrices<Real> inverse_inertia_a, inverse_inertia_b;  ///< I^-1, world axes
  EightVectors<Real> n, tangent1, tangent2;
  EightVectors<Real> found_n, found_tangent1, found_tangent2;  ///< as detected
  EightNumbers<Real> face_a, face_b,
      cores;  ///< 1: n turns with A; with B; is the direction from core to core. Else rows are carried
  EightNumbers<Real> radius_a, radius_b;  ///< m: so far is what is touched, skin and all, from its core
  EightNumbers<Real> reach_a, reach_b;    ///< m, the longest arm
  EightVectors<Real> rebuilt_displacement, rebuilt_turn_a,
      rebuilt_turn_b;  ///< when the rows were placed: by which B had moved past A, m, and
                       ///< by which each had turned, rad, since detection
  EightNumbers<Real>
      rebuild_distance_squared;  ///< m, squared: once a pair has moved or turned as far since, its rows are placed anew
  int first, end;                ///< of its contacts in their list: as many as the pair with the most points has
};

/// v and w of a body, or x and theta: in m/s and rad/s, or m and rad; and two numbers that are nothing.
template <class Real>
struct alignas(8 * sizeof(Real)) Twist {
  Real values[8];
};

/// I^-1 of a body, world axes.
template <class Real>
struct alignas(8 * sizeof(Real)) Inertia {
  Real values[6], padding[2];  ///< xx, xy, xz, yy, yz, zz
};

/// Eight bodies that turn.
template <class Real>
struct EightRotations {
  EightNumbers<Real> x, y, z, s;       ///< their orientation, a unit quaternion with the scalar part s
  EightVectors<Real> w;                ///< rad/s, world axes
  EightVectors<Real> inverse_inertia;  ///< the principal ones, 1/(kg m^2)
  EightNumbers<Real> solved;           ///< 1; or 0 where it turns so far that Newton's method has not followed
};

/// All of it.
template <class Real>
struct BundleRange {
  Bundle<Real>* bundles;
  int count;
  const WidePoint<Real>* points;
  WideContact<Real>* contacts;
  Twist<Real>*velocities, *velocities_before;
  Twist<Real>*displacements, *impulse_velocities;
  const Inertia<Real>* inertias;
  EightVectors<Real>* start_impulses;
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
  void (*prepare)(const BundleRange<Real>&);
  Real (*prepare_substep)(const BundleRange<Real>&, const WidePushOut<Real>&);  ///< returns the fastest bounce, m/s
  void (*rebuild_rows)(const BundleRange<Real>&);
  void (*relax)(const BundleRange<Real>&);
  Real (*solve_normals)(const BundleRange<Real>&);   ///< all normals; returns by how much it changed a speed, m/s
  void (*solve_friction)(const BundleRange<Real>&);  ///< all tangents
  void (*solve_friction_and_sum)(
      const BundleRange<Real>&);  ///< the same, the last pass of a substep: impulses are summed
  void (*save_impulses)(const BundleRange<Real>&);
  void (*restore_impulses)(const BundleRange<Real>&);
  void (*turn)(EightRotations<Real>&, Real h);
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
