#include "pushback/engine/substeps/contact_bundles.h"

#include <algorithm>
#include <limits>

#include "pushback/engine/substeps/lane_access.h"
#include "pushback/engine/substeps/normal_source.h"
#include "pushback/engine/substeps/substepping.h"

namespace pushback {

template <class Scalar>
void ContactBundles<Scalar>::build(World& world, PairSets sets, const BundleInput& input, Workers& workers) {
  bodies.clear();
  indices_.assign(world.bodies.size(), std::numeric_limits<std::size_t>::max());
  for (auto& set : sets)
    for (TouchingPair& pair : set) pair.a = index_of(world, pair.a), pair.b = index_of(world, pair.b);
  bodies.push_back(&world.body(the_world));
  measure_reaches(world);
  locations.resize(world.contacts.size());
  const std::vector<std::span<const TouchingPair>> pairs = lay_out(sets);
  workers.each(bundles.size(), least_bundles, [&](Part part) {
    for (std::size_t i = part.begin; i < part.end; ++i) {
      clear(bundles[i]);
      for (std::size_t lane = 0; lane < pairs[i].size(); ++lane) pack_pair(world, pairs[i][lane], input, i, lane);
    }
  });
}

template <class Scalar>
std::size_t ContactBundles<Scalar>::index_of(World& world, std::size_t body) {
  constexpr std::size_t none = std::numeric_limits<std::size_t>::max();
  if (indices_[body] == none) {
    indices_[body] = bodies.size();
    bodies.push_back(&world.bodies[body]);
  }
  return indices_[body];
}

template <class Scalar>
void ContactBundles<Scalar>::measure_reaches(const World& world) {
  reaches.assign(bodies.size(), 0);
  for (const Contact& contact : world.contacts)
    for (const std::uint32_t i : {contact.id.body_a, contact.id.body_b}) {
      const Body& body = world.bodies[i];
      Real& reach = reaches[indices_[i]];
      reach = std::max(reach, (contact.point - body.position).squaredNorm());
    }
  for (Real& reach : reaches) reach = std::sqrt(reach);
}

template <class Scalar>
Real ContactBundles<Scalar>::shortest_reach() const {
  Real shortest = std::numeric_limits<Real>::infinity();
  for (std::size_t i = 0; i < bodies.size(); ++i)
    if (bodies[i]->movable()) shortest = std::min(shortest, reaches[i]);
  return shortest;
}

/// Makes the bundles and their lists of contacts, all empty. Returns the pairs of each bundle, which are views of `sets`.
template <class Scalar>
std::vector<std::span<const TouchingPair>> ContactBundles<Scalar>::lay_out(const PairSets& sets) {
  std::vector<std::span<const TouchingPair>> pairs;
  bundles.clear();
  set_ends.clear();
  int count = 0;
  for (const auto& set : sets) {
    for (std::size_t first = 0; first < set.size(); first += lanes_per_bundle) {
      Bundle<Scalar>& bundle = bundles.emplace_back();
      pairs.push_back(std::span(set).subspan(first, std::min<std::size_t>(lanes_per_bundle, set.size() - first)));
      bundle.first = count;
      bundle.end = count += static_cast<int>(set[first].count);  // no pair that follows in the set has more
    }
    set_ends.push_back(bundles.size());
  }
  contacts.resize(static_cast<std::size_t>(count));
  points.resize(static_cast<std::size_t>(count));
  return pairs;
}

/// Writes the empty lanes, and all values that neither `pack_pair` nor Passes::prepare will write.
template <class Scalar>
void ContactBundles<Scalar>::clear(Bundle<Scalar>& bundle) {
  const int world = static_cast<int>(bodies.size()) - 1;
  std::fill(bundle.a, bundle.a + lanes_per_bundle, world);
  std::fill(bundle.b, bundle.b + lanes_per_bundle, world);
  bundle.rebuilt_displacement = bundle.rebuilt_turn_a = bundle.rebuilt_turn_b = {};
  bundle.face_a = bundle.face_b = bundle.cores = {};
  bundle.radius_a = bundle.radius_b = bundle.reach_a = bundle.reach_b = {};
  std::fill_n(bundle.rebuild_distance_squared.values, lanes_per_bundle, std::numeric_limits<Scalar>::infinity());
  for (int c = bundle.first; c < bundle.end; ++c) {
    WideContact<Scalar>& contact = contacts[static_cast<std::size_t>(c)];
    contact.normal.impulse = contact.tangent1.impulse = contact.tangent2.impulse = {};
    contact.found = contact.restitution = {};
    contact.sum = {};
  }
  std::fill(points.begin() + bundle.first, points.begin() + bundle.end, WidePoint<Scalar>{});
}

/// Copies the masses, inertias and shapes of a pair, and the source of its normal.
template <class Scalar>
void ContactBundles<Scalar>::pack_bodies(const TouchingPair& pair, const Vec3& n, const BundleInput& input,
                                         Bundle<Scalar>& bundle, std::size_t lane) {
  const Body &a = *bodies[pair.a], &b = *bodies[pair.b];
  bundle.a[lane] = static_cast<int>(pair.a);
  bundle.b[lane] = static_cast<int>(pair.b);
  bundle.inverse_mass_a.values[lane] = static_cast<Scalar>(a.inverse_mass);
  bundle.inverse_mass_b.values[lane] = static_cast<Scalar>(b.inverse_mass);
  write_lane(a.inverse_inertia, bundle.inverse_inertia_a, lane);
  write_lane(b.inverse_inertia, bundle.inverse_inertia_b, lane);
  const Real reach_a = reaches[pair.a], reach_b = reaches[pair.b];
  bundle.reach_a.values[lane] = static_cast<Scalar>(reach_a);
  bundle.reach_b.values[lane] = static_cast<Scalar>(reach_b);
  const NormalSource source = normal_source_of(a, b, n, reach_a, reach_b);
  bundle.face_a.values[lane] = source == NormalSource::face_a;
  bundle.face_b.values[lane] = source == NormalSource::face_b;
  bundle.cores.values[lane] = source == NormalSource::cores;
  bundle.radius_a.values[lane] = static_cast<Scalar>(radius_of(a) + a.skin);
  bundle.radius_b.values[lane] = static_cast<Scalar>(radius_of(b) + b.skin);
  const bool floats = input.floats[std::size_t(a.movable() ? a.index : b.index)];
  const Real shorter = !a.movable() ? reach_b : !b.movable() ? reach_a : std::min(reach_a, reach_b);
  const Real within = floats ? 0 : input.rebuild_fraction * shorter;
  bundle.rebuild_distance_squared.values[lane] = static_cast<Scalar>(within * within);
}

/// Copies a pair and its contacts. All of them get the normal and friction of the first one.
template <class Scalar>
void ContactBundles<Scalar>::pack_pair(const World& world, const TouchingPair& pair, const BundleInput& input,
                                       std::size_t at, std::size_t lane) {
  Bundle<Scalar>& bundle = bundles[at];
  const Contact& first = world.contacts[pair.first];
  const auto [tangent1, tangent2] = tangents_of(first.normal);
  pack_bodies(pair, first.normal, input, bundle, lane);
  bundle.friction.values[lane] = static_cast<Scalar>(first.friction);
  write_lane(first.normal, bundle.n, lane);
  write_lane(tangent1, bundle.tangent1, lane);
  write_lane(tangent2, bundle.tangent2, lane);
  write_lane(first.normal, bundle.found_n, lane);
  write_lane(tangent1, bundle.found_tangent1, lane);
  write_lane(tangent2, bundle.found_tangent2, lane);
  for (std::size_t i = 0; i < pair.count; ++i) {
    const std::size_t index = pair.first + i, to = static_cast<std::size_t>(bundle.first) + i;
    const Contact& found = world.contacts[index];
    const Vec3 guess = clamped_to_cone(input.guesses[index], first.normal, first.friction);
    WidePoint<Scalar>& point = points[to];
    WideContact<Scalar>& contact = contacts[to];
    write_lane(Vec3(found.point - bodies[pair.a]->position), point.arm_a, lane);
    write_lane(Vec3(found.point - bodies[pair.b]->position), point.arm_b, lane);
    point.gap.values[lane] = static_cast<Scalar>(-found.depth);
    point.present.values[lane] = 1;
    contact.found.values[lane] = static_cast<Scalar>(-found.depth);
    contact.restitution.values[lane] = static_cast<Scalar>(found.restitution);
    contact.normal.impulse.values[lane] = static_cast<Scalar>(guess.dot(first.normal));
    if (first.friction > 0) {
      contact.tangent1.impulse.values[lane] = static_cast<Scalar>(guess.dot(tangent1));
      contact.tangent2.impulse.values[lane] = static_cast<Scalar>(guess.dot(tangent2));
    }
    locations[index] = {at, to, lane};
  }
}

template <class Scalar>
void ContactBundles<Scalar>::write_back(std::size_t i, const std::vector<Twist<Scalar>>& displacements, bool known,
                                        Contact& contact) const {
  const auto [b, c, lane] = locations[i];
  const Bundle<Scalar>& bundle = bundles[b];
  const WideContact<Scalar>& wide = contacts[c];
  const Vec3 n = read_lane(bundle.n, lane);
  const Twist<Scalar>&a_moved = displacements[std::size_t(bundle.a[lane])],
        &b_moved = displacements[std::size_t(bundle.b[lane])];
  contact.normal = n;
  contact.depth = -static_cast<Real>(wide.found.values[lane]) - n.dot(linear_of(b_moved) - linear_of(a_moved)) -
                  read_lane(wide.normal.rb_n, lane).dot(angular_of(b_moved)) +
                  read_lane(wide.normal.ra_n, lane).dot(angular_of(a_moved));
  const Scalar pushed = wide.normal.impulse.values[lane], rubbed1 = wide.tangent1.impulse.values[lane],
               rubbed2 = wide.tangent2.impulse.values[lane];
  const Vec3 t1 = read_lane(bundle.tangent1, lane), t2 = read_lane(bundle.tangent2, lane);
  contact.impulse = read_lane(wide.sum, lane);
  contact.last_impulse =
      static_cast<Real>(pushed) * n + static_cast<Real>(rubbed1) * t1 + static_cast<Real>(rubbed2) * t2;
  contact.state = state_of(known, bundle.friction.values[lane], pushed, rubbed1, rubbed2);
}

template <class Scalar>
Real ContactBundles<Scalar>::residual() const {
  Real largest = 0;
  for (const Location& at : locations) {
    const std::size_t lane = at.lane;
    const Bundle<Scalar>& bundle = bundles[at.bundle];
    const WideContact<Scalar>& wide = contacts[at.contact];
    const Body &first = *bodies[std::size_t(bundle.a[lane])], &second = *bodies[std::size_t(bundle.b[lane])];
    const auto speed = [&](const EightVectors<Scalar>& direction, const WideRow<Scalar>& row) {
      return read_lane(direction, lane).dot(second.velocity - first.velocity) +
             read_lane(row.rb_n, lane).dot(second.angular_velocity) -
             read_lane(row.ra_n, lane).dot(first.angular_velocity);
    };
    const auto number = [lane](const EightNumbers<Scalar>& of) { return static_cast<Real>(of.values[lane]); };
    const Real pushed = number(wide.normal.impulse), rubbed1 = number(wide.tangent1.impulse),
               rubbed2 = number(wide.tangent2.impulse), step_size = number(wide.step_size);
    const Real wanted = speed(bundle.n, wide.normal) + number(wide.bias) + number(wide.softness) * pushed;
    const Real total = std::max(Real(0), pushed - number(wide.mass) * wanted);
    largest = std::max(largest, std::abs(total - pushed) / number(wide.rigid_mass));
    Real total1 = rubbed1 - step_size * speed(bundle.tangent1, wide.tangent1);
    Real total2 = rubbed2 - step_size * speed(bundle.tangent2, wide.tangent2);
    const Real radius = number(bundle.friction) * pushed, size = std::hypot(total1, total2);
    if (size > radius) total1 *= radius / size, total2 *= radius / size;
    largest = std::max(largest, std::hypot(total1 - rubbed1, total2 - rubbed2) / step_size);
  }
  return largest;
}

template struct ContactBundles<float>;
template struct ContactBundles<double>;

}  // namespace pushback
