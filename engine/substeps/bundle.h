/// The data of the wide solver, with contacts of eight pairs of bodies side by side in plain arrays. Files that are compiled
/// for different processors share these types.
///
/// This header defines no functions. The linker would keep one copy of each, which might use instructions that the processor
/// lacks.
#pragma once

namespace pushback {

inline constexpr int lanes_per_bundle = 8;

/// One number for each of eight pairs.
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

/// A Row of chapter 01 for each pair, without n, which the rows of a bundle share.
template <class Real>
struct WideRow {
  EightVectors<Real> ra_n, rb_n, dwa, dwb;
  EightNumbers<Real> impulse;  ///< N s
};
/// A contact point of each pair, as detected.
template <class Real>
struct WidePoint {
  EightVectors<Real> arm_a, arm_b;  ///< m, from the centres of mass
  EightNumbers<Real> gap;           ///< C_0, m
  EightNumbers<Real> present;       ///< 1, or 0 if the pair has fewer points
};
/// A contact of each pair: a KeptContact of chapter 21. If a pair has fewer points, its masses are 0.
template <class Real>
struct WideContact {
  WideRow<Real> normal, tangent1, tangent2;
  EightNumbers<Real> found, restitution;     ///< C_0, m; e
  EightNumbers<Real> rigid_mass, step_size;  ///< 1 / K of the normal; 1 / k of both tangents (chapter 08); kg
  EightNumbers<Real> bias, softness, mass;   ///< of the normal in this pass: b, m/s; gamma, 1/kg; 1 / (K + gamma), kg
  EightNumbers<Real> bounce;                 ///< minus the speed after a bounce in this substep, m/s; 0: no bounce
  EightVectors<Real> sum;                    ///< N s, on B, world axes, the sum over the substeps so far
};
/// Eight pairs, no two of which share a movable body.
template <class Real>
struct Bundle {
  int a[lanes_per_bundle], b[lanes_per_bundle];  ///< indices in the list of bodies
  EightNumbers<Real> inverse_mass_a, inverse_mass_b, friction;
  EightSymmetricMatrices<Real> inverse_inertia_a, inverse_inertia_b;  ///< I^-1, world axes
  EightVectors<Real> n, tangent1, tangent2;
  EightVectors<Real> found_n, found_tangent1, found_tangent2;  ///< as detected
  EightNumbers<Real> face_a, face_b, cores;  ///< one of them is 1, see NormalSource; all are 0 for NormalSource::none
  EightNumbers<Real> radius_a, radius_b;     ///< m, from the core to the surface with its skin
  EightNumbers<Real> reach_a, reach_b;       ///< m, the longest arm
  /// The displacement of B minus the displacement of A from detection to the latest rebuild of the rows, m.
  EightVectors<Real> rebuilt_displacement;
  EightVectors<Real> rebuilt_turn_a, rebuilt_turn_b;  ///< the rotation of each body in the same time, rad
  /// The rows are rebuilt once the pair has moved or turned by this squared distance since, m^2.
  EightNumbers<Real> rebuild_distance_squared;
  int first, end;  ///< the range of its contacts in the list of all, as many as the pair with the most points has
};

/// v, m/s, and w, rad/s, of a body, or its displacement, m, and its rotation, rad. The last two numbers are padding.
template <class Real>
struct alignas(8 * sizeof(Real)) Twist {
  Real values[8];
};

/// I^-1 of a body, world axes.
template <class Real>
struct alignas(8 * sizeof(Real)) Inertia {
  Real values[6], padding[2];  ///< xx, xy, xz, yy, yz, zz
};

/// Eight bodies that rotate freely.
template <class Real>
struct EightRotations {
  EightNumbers<Real> x, y, z, s;       ///< the orientation, a unit quaternion with the scalar part s
  EightVectors<Real> w;                ///< rad/s, world axes
  EightVectors<Real> inverse_inertia;  ///< the principal ones, 1/(kg m^2)
  EightNumbers<Real> solved;           ///< 1, or 0 if the body turns so far that Newton's method did not converge
};

/// The bundles on which a pass works, and the arrays to which they refer.
template <class Real>
struct BundleRange {
  Bundle<Real>* bundles;
  int count;
  const WidePoint<Real>* points;
  WideContact<Real>* contacts;
  Twist<Real>*velocities, *velocities_before;  ///< of each body: now; as the substep began
  Twist<Real>* displacements;                  ///< of each body since detection
  Twist<Real>* impulse_velocities;             ///< of each body: the velocity that the impulses of its contacts add
  const Inertia<Real>* inertias;
  EightVectors<Real>* start_impulses;  ///< of each contact: along n and both tangents, as a substep with a bounce began
};

/// The coefficients of soft contacts for one length of substep. PushOut of substepping.h describes them.
template <class Real>
struct WidePushOut {
  Real rate, gamma_by_K, fastest, threshold, h;
};

/// The passes over contacts, for one number of lanes and one kind of processor.
template <class Real>
struct Passes {
  const char* processor;
  int lanes;
  /// Once per step: builds the rows, and applies the initial impulses to impulse_velocities.
  void (*prepare)(const BundleRange<Real>&);
  /// Sets the target velocities of normals for a substep. Returns the fastest bounce, m/s.
  Real (*prepare_substep)(const BundleRange<Real>&, const WidePushOut<Real>&);
  /// Rebuilds the rows of pairs that have moved far enough.
  void (*rebuild_rows)(const BundleRange<Real>&);
  /// Removes the push-out after the bodies have moved (chapter 12).
  void (*relax)(const BundleRange<Real>&);
  /// Solves all normals. Returns the largest change of a speed, m/s.
  Real (*solve_normals)(const BundleRange<Real>&);
  void (*solve_friction)(const BundleRange<Real>&);
  /// The last pass of a substep, which also adds the impulses to WideContact::sum.
  void (*solve_friction_and_sum)(const BundleRange<Real>&);
  void (*save_impulses)(const BundleRange<Real>&);
  void (*restore_impulses)(const BundleRange<Real>&);
  /// The free rotation of eight bodies in h, s.
  void (*turn)(EightRotations<Real>&, Real h);
};

/// The passes for any processor, and for processors with AVX2. `lanes`: 1, 4 or 8.
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
