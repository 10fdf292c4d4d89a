/// The contacts of one step, copied into bundles of eight pairs of bodies, and back.
#pragma once

#include <span>
#include <vector>

#include "pushback/common/basics/workers.h"
#include "pushback/engine/substeps/bundle.h"
#include "pushback/engine/substeps/pair_colouring.h"

namespace pushback {

/// The least number of bundles in each part of a pass that threads share.
inline constexpr std::size_t least_bundles = 8;

/// The values of a bundle that do not come from the contacts of the world.
struct BundleInput {
  const std::vector<Vec3>& guesses;  ///< N s, on B, world axes, the initial impulse of each contact
  const std::vector<bool>& floats;   ///< of each body: see floating_bodies.h
  Real rebuild_fraction;             ///< WideSolver::rebuild_fraction
};

/// The arrays on which the passes of bundle.h work, set by set. Defined for float and double.
template <class Scalar>
struct ContactBundles {
  struct Location {
    std::size_t bundle, contact, lane;
  };

  std::vector<Body*> bodies;  ///< all bodies with contacts, then `the_world`, which fills empty lanes
  std::vector<Real> reaches;  ///< m, of each of `bodies`: its longest arm
  std::vector<Bundle<Scalar>> bundles;
  std::vector<std::size_t> set_ends;          ///< of each set, in `bundles`
  std::vector<WidePoint<Scalar>> points;      ///< of all bundles
  std::vector<WideContact<Scalar>> contacts;  ///< one for each of `points`
  std::vector<Location> locations;            ///< of each contact of the world

  /// Copies World::contacts, all pairs of which are in `sets`. Rows are left to Passes::prepare.
  void build(World& world, PairSets sets, const BundleInput& input, Workers& workers);
  /// The shortest reach of a body that moves, or infinity if no body moves, m.
  Real shortest_reach() const;
  /// Copies the normal, the depth, the impulses and the state of the i-th contact. `displacements`: of each of `bodies`, since
  /// detection. `known`: whether the previous step had this contact.
  void write_back(std::size_t i, const std::vector<Twist<Scalar>>& displacements, bool known, Contact& contact) const;
  /// The largest change of the speed along a row by another sweep (KeptContact::error of chapter 21), m/s.
  Real residual() const;

 private:
  std::size_t index_of(World& world, std::size_t body);
  void measure_reaches(const World& world);
  std::vector<std::span<const TouchingPair>> lay_out(const PairSets& sets);
  void clear(Bundle<Scalar>& bundle);
  void pack_bodies(const TouchingPair& pair, const Vec3& n, const BundleInput& input, Bundle<Scalar>& bundle,
                   std::size_t lane);
  void pack_pair(const World& world, const TouchingPair& pair, const BundleInput& input, std::size_t at,
                 std::size_t lane);

  std::vector<std::size_t> indices_;  // of each body of the world, in `bodies`
};

extern template struct ContactBundles<float>;  // compiled once, in contact_bundles.cpp
extern template struct ContactBundles<double>;

}  // namespace pushback
