#include "pushback/engine/substeps/wide.h"

#include <algorithm>
#include <limits>

#if defined(__SSE__) && !defined(__EMSCRIPTEN__)
#include <xmmintrin.h>
#endif

namespace pushback {

namespace {

constexpr std::size_t least_bundles = 8;  // a part of a pass

/// What is smaller than the smallest normal number counts as 0 while this lives: an impulse that fades away would otherwise take a
/// hundred times as long to multiply.
class NoDenormals {
 public:
#if defined(__SSE__) && !defined(__EMSCRIPTEN__)
  NoDenormals() { _mm_setcsr(before_ | 0x8040); }
  ~NoDenormals() { _mm_setcsr(before_); }

 private:
  unsigned before_ = _mm_getcsr();
#else
  NoDenormals() {}
#endif
};

template <class Scalar>
void put(const Vec3& vector, EightVectors<Scalar>& into, std::size_t lane) {
  into.x.of[lane] = static_cast<Scalar>(vector.x());
  into.y.of[lane] = static_cast<Scalar>(vector.y());
  into.z.of[lane] = static_cast<Scalar>(vector.z());
}
template <class Scalar>
Vec3 vector_of(const EightVectors<Scalar>& from, std::size_t lane) {
  return {static_cast<Real>(from.x.of[lane]), static_cast<Real>(from.y.of[lane]), static_cast<Real>(from.z.of[lane])};
}
template <class Scalar>
void put(const Mat3& symmetric, EightSymmetric<Scalar>& into, std::size_t lane) {
  into.xx.of[lane] = static_cast<Scalar>(symmetric(0, 0));
  into.xy.of[lane] = static_cast<Scalar>(symmetric(0, 1));
  into.xz.of[lane] = static_cast<Scalar>(symmetric(0, 2));
  into.yy.of[lane] = static_cast<Scalar>(symmetric(1, 1));
  into.yz.of[lane] = static_cast<Scalar>(symmetric(1, 2));
  into.zz.of[lane] = static_cast<Scalar>(symmetric(2, 2));
}
/// Number by number into its place: a Twist that is made elsewhere, and copied, waits for what was just written.
template <class Scalar>
void put(const Vec3& v, const Vec3& w, Twist<Scalar>& into) {
  for (int i = 0; i < 3; ++i) into.of[i] = static_cast<Scalar>(v[i]), into.of[3 + i] = static_cast<Scalar>(w[i]);
}
template <class Scalar>
Inertia<Scalar> inertia_of(const Mat3& m) {
  return {{static_cast<Scalar>(m(0, 0)), static_cast<Scalar>(m(0, 1)), static_cast<Scalar>(m(0, 2)),
           static_cast<Scalar>(m(1, 1)), static_cast<Scalar>(m(1, 2)), static_cast<Scalar>(m(2, 2))},
          {}};
}
template <class Scalar>
Vec3 linear(const Twist<Scalar>& of) {
  return {static_cast<Real>(of.of[0]), static_cast<Real>(of.of[1]), static_cast<Real>(of.of[2])};
}
template <class Scalar>
Vec3 angular(const Twist<Scalar>& of) {
  return {static_cast<Real>(of.of[3]), static_cast<Real>(of.of[4]), static_cast<Real>(of.of[5])};
}
/// Those that are to turn, until there are eight of them.
class TurningBodies {
 public:
  explicit TurningBodies(const Passes<Real>& passes) : turn_(passes.turn) {}
  void add(Body& body, Real h) {
    const Quat& q = body.orientation;
    numbers_.x.of[count_] = q.x(), numbers_.y.of[count_] = q.y(), numbers_.z.of[count_] = q.z();
    numbers_.s.of[count_] = q.w();
    put(body.angular_velocity, numbers_.w, count_);
    put(body.principal_inverse_inertia, numbers_.inverse_inertia, count_);
    bodies_[count_] = &body;
    if (++count_ == lanes_of_bundle) turn(h);
  }
  void turn(Real h) {
    turn_(numbers_, h);
    for (std::size_t i = 0; i < count_; ++i) {
      Body& body = *bodies_[i];
      if (numbers_.solved.of[i] == 0) {
        spin_freely(body, h);
        continue;
      }
      body.orientation = Quat(numbers_.s.of[i], numbers_.x.of[i], numbers_.y.of[i], numbers_.z.of[i]);
      body.angular_velocity = vector_of(numbers_.w, i);
    }
    count_ = 0;
  }

 private:
  void (*turn_)(Turning<Real>&, Real);
  Turning<Real> numbers_{};
  Body* bodies_[lanes_of_bundle];
  std::size_t count_ = 0;
};
}  // namespace

template <class Scalar>
Passes<Scalar> passes_of_this_processor(int lanes) {
#ifdef PUSHBACK_AVX2
  if (__builtin_cpu_supports("avx2")) return avx2_passes<Scalar>(lanes > 0 ? lanes : 32 / int(sizeof(Scalar)));
#endif
  return plain_passes<Scalar>(lanes > 0 ? lanes : sizeof(Scalar) == 4 ? 4 : 1);  // what SSE2 is faster with
}

template <class Scalar, class JointEffect>
std::size_t Wide<Scalar, JointEffect>::place_of(World& world, std::size_t body) {
  constexpr std::size_t none = std::numeric_limits<std::size_t>::max();
  if (places_.empty()) places_.assign(world.bodies.size(), none);
  if (places_[body] == none) {
    places_[body] = bodies_.size();
    bodies_.push_back(&world.bodies[body]);
  }
  return places_[body];
}

template <class Scalar, class JointEffect>
void Wide<Scalar, JointEffect>::detected(World& world, Real h) {
  const NoDenormals none;
  at_work_ = &(crew ? *crew : alone()).of_bodies(world.bodies.size());
  measured_.reset();
  bodies_.clear();
  places_.clear();
  const std::vector<PairOfBodies> touching = touching_pairs(world.contacts);
  Sets sets = sets_of(touching, world);
  for (auto& set : sets)
    for (PairOfBodies& pair : set) pair.a = place_of(world, pair.a), pair.b = place_of(world, pair.b);
  bodies_.push_back(&world.body(the_world));
  for (auto* twists : {&now_, &before_, &moved_, &given_}) twists->assign(bodies_.size(), Twist<Scalar>{});
  inertias_.resize(bodies_.size());
  where_.resize(world.contacts.size());
  bouncy_ =
      std::any_of(world.contacts.begin(), world.contacts.end(), [](const Contact& c) { return c.restitution > 0; });
  measure_reaches(world);
  floats_ = floating(touching, world);
  something_floats_ = std::any_of(bodies_.begin(), bodies_.end() - 1,
                                  [this](const Body* b) { return floats_[static_cast<std::size_t>(b->index)]; });
  guesses_.assign(world.contacts.size(), Vec3::Zero());
  start_from_last_step(world, h, [this](std::size_t i, const Vec3& impulse) { guesses_[i] = impulse; });
  lay_out(sets);
  each_bundle([&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) pack(world, i, packed_[i]);
  });
  set_by_set([&](std::size_t begin, std::size_t end) { passes.prepare(bundles(begin, end)); });
}

template <class Scalar, class JointEffect>
void Wide<Scalar, JointEffect>::measure_reaches(const World& world) {
  reaches_.assign(bodies_.size(), 0);
  for (const Contact& contact : world.contacts)
    for (const std::uint32_t i : {contact.id.body_a, contact.id.body_b}) {
      const Body& body = world.bodies[i];
      Real& reach = reaches_[places_[i]];
      reach = std::max(reach, (contact.point - body.position).squaredNorm());
    }
  for (Real& reach : reaches_) reach = std::sqrt(reach);
  shortest_reach_ = std::numeric_limits<Real>::infinity();
  for (std::size_t i = 0; i < bodies_.size(); ++i)
    if (bodies_[i]->movable()) shortest_reach_ = std::min(shortest_reach_, reaches_[i]);
}

/// Which pairs are in which bundle, and where its contacts are.
template <class Scalar, class JointEffect>
void Wide<Scalar, JointEffect>::lay_out(const Sets& sets) {
  bundles_.clear();
  packed_.clear();
  ends_.clear();
  int contacts = 0;
  for (const auto& set : sets) {
    for (std::size_t first = 0; first < set.size(); first += lanes_of_bundle) {
      Bundle<Scalar>& bundle = bundles_.emplace_back();
      packed_.push_back(std::span(set).subspan(first, std::min<std::size_t>(lanes_of_bundle, set.size() - first)));
      bundle.first = contacts;
      bundle.end = contacts += static_cast<int>(set[first].count);  // the most of all in the set that are left
    }
    ends_.push_back(bundles_.size());
  }
  contacts_.resize(static_cast<std::size_t>(contacts));
  points_.resize(static_cast<std::size_t>(contacts));
  starts_.resize(static_cast<std::size_t>(contacts));
}

/// Up to eight pairs side by side: what their rows are made of.
template <class Scalar, class JointEffect>
void Wide<Scalar, JointEffect>::pack(const World& world, std::size_t at, std::span<const PairOfBodies> pairs) {
  const int nobody = static_cast<int>(bodies_.size()) - 1;
  Bundle<Scalar>& bundle = bundles_[at];
  std::fill(bundle.a, bundle.a + lanes_of_bundle, nobody);
  std::fill(bundle.b, bundle.b + lanes_of_bundle, nobody);
  bundle.placed_way = bundle.placed_turn_a = bundle.placed_turn_b = {};
  bundle.on_a = bundle.on_b = bundle.between = {};
  bundle.radius_a = bundle.radius_b = bundle.reach_a = bundle.reach_b = {};
  std::fill_n(bundle.stays_within.of, lanes_of_bundle, std::numeric_limits<Scalar>::infinity());
  const std::size_t begin = static_cast<std::size_t>(bundle.first);
  for (int c = bundle.first; c < bundle.end; ++c) {  // what is not written below, or by passes.prepare
    WideContact<Scalar>& contact = contacts_[static_cast<std::size_t>(c)];
    contact.normal.impulse = contact.tangent1.impulse = contact.tangent2.impulse = {};
    contact.found = contact.restitution = {};
    contact.sum = {};
  }
  std::fill(points_.begin() + bundle.first, points_.begin() + bundle.end, WidePoint<Scalar>{});
  for (std::size_t lane = 0; lane < pairs.size(); ++lane) {
    const PairOfBodies& pair = pairs[lane];
    const Body &a = *bodies_[pair.a], &b = *bodies_[pair.b];
    const Contact& of_pair = world.contacts[pair.first];
    const auto [tangent1, tangent2] = tangents_of(of_pair.normal);
    bundle.a[lane] = static_cast<int>(pair.a);
    bundle.b[lane] = static_cast<int>(pair.b);
    bundle.inverse_mass_a.of[lane] = static_cast<Scalar>(a.inverse_mass);
    bundle.inverse_mass_b.of[lane] = static_cast<Scalar>(b.inverse_mass);
    bundle.friction.of[lane] = static_cast<Scalar>(of_pair.friction);
    put(a.inverse_inertia, bundle.inverse_inertia_a, lane);
    put(b.inverse_inertia, bundle.inverse_inertia_b, lane);
    put(of_pair.normal, bundle.n, lane);
    put(tangent1, bundle.tangent1, lane);
    put(tangent2, bundle.tangent2, lane);
    put(of_pair.normal, bundle.found_n, lane);
    put(tangent1, bundle.found_tangent1, lane);
    put(tangent2, bundle.found_tangent2, lane);
    const Real reach_a = reaches_[pair.a], reach_b = reaches_[pair.b];
    bundle.reach_a.of[lane] = static_cast<Scalar>(reach_a);
    bundle.reach_b.of[lane] = static_cast<Scalar>(reach_b);
    const Rides rides = what_it_rides_on(a, b, of_pair.normal, reach_a, reach_b);
    bundle.on_a.of[lane] = rides == Rides::on_a;
    bundle.on_b.of[lane] = rides == Rides::on_b;
    bundle.between.of[lane] = rides == Rides::between;
    bundle.radius_a.of[lane] = static_cast<Scalar>(radius_of(a) + a.skin);
    bundle.radius_b.of[lane] = static_cast<Scalar>(radius_of(b) + b.skin);
    const bool floats = floats_[std::size_t(a.movable() ? a.index : b.index)];
    const Real shorter = !a.movable() ? reach_b : !b.movable() ? reach_a : std::min(reach_a, reach_b);
    const Real within = floats ? 0 : stays_within * shorter;
    bundle.stays_within.of[lane] = static_cast<Scalar>(within * within);
    for (std::size_t point = 0; point < pair.count; ++point) {
      const std::size_t index = pair.first + point;
      const Contact& found = world.contacts[index];
      const Vec3 guess = within_cone(guesses_[index], of_pair.normal, of_pair.friction);
      WidePoint<Scalar>& where = points_[begin + point];
      WideContact<Scalar>& wide = contacts_[begin + point];
      put(Vec3(found.point - a.position), where.arm_a, lane);
      put(Vec3(found.point - b.position), where.arm_b, lane);
      where.gap.of[lane] = static_cast<Scalar>(-found.depth);
      where.present.of[lane] = 1;
      wide.found.of[lane] = static_cast<Scalar>(-found.depth);
      wide.restitution.of[lane] = static_cast<Scalar>(found.restitution);
      wide.normal.impulse.of[lane] = static_cast<Scalar>(guess.dot(of_pair.normal));
      if (of_pair.friction > 0) {
        wide.tangent1.impulse.of[lane] = static_cast<Scalar>(guess.dot(tangent1));
        wide.tangent2.impulse.of[lane] = static_cast<Scalar>(guess.dot(tangent2));
      }
      where_[index] = {at, begin + point, lane};
    }
  }
}

template <class Scalar, class JointEffect>
Bundles<Scalar> Wide<Scalar, JointEffect>::bundles(std::size_t begin, std::size_t end) {
  return {bundles_.data() + begin,
          static_cast<int>(end - begin),
          points_.data(),
          contacts_.data(),
          now_.data(),
          before_.data(),
          moved_.data(),
          given_.data(),
          inertias_.data(),
          starts_.data()};
}

/// `act(i)` for each of the bodies that touch. It changes nothing of any other.
template <class Scalar, class JointEffect>
template <class Act>
void Wide<Scalar, JointEffect>::each_body(const Act& act) {
  at_work_->each(bodies_.size(), 256, [&](Part part) {
    for (std::size_t i = part.begin; i < part.end; ++i) act(i);
  });
}
/// `act(begin, end)` for parts of all bundles: it changes no body. Returns the largest of what it returns.
template <class Scalar, class JointEffect>
template <class Act>
Scalar Wide<Scalar, JointEffect>::each_bundle(const Act& act) {
  return largest_in(0, bundles_.size(), act);
}
/// The same for the bundles of one set after the other: it changes the bodies of its bundles, and nobody else's.
template <class Scalar, class JointEffect>
template <class Act>
Scalar Wide<Scalar, JointEffect>::set_by_set(const Act& act) {
  Scalar largest = 0;
  std::size_t begin = 0;
  for (const std::size_t end : ends_) {
    largest = std::max(largest, largest_in(begin, end, act));
    begin = end;
  }
  return largest;
}
template <class Scalar, class JointEffect>
template <class Act>
Scalar Wide<Scalar, JointEffect>::largest_in(std::size_t begin, std::size_t end, const Act& act) {
  const std::size_t items = end - begin;
  largest_.assign(at_work_->parts(items, least_bundles), 0);
  at_work_->each(items, least_bundles, [&](Part part) {
    if constexpr (std::is_void_v<decltype(act(begin, end))>) act(begin + part.begin, begin + part.end);
    else largest_[part.index] = act(begin + part.begin, begin + part.end);
  });
  return *std::max_element(largest_.begin(), largest_.end());
}

template <class Scalar, class JointEffect>
void Wide<Scalar, JointEffect>::solve(World& world, Real h, int sweeps) {
  const NoDenormals none;
  StepContext step = joints_step(world, h);
  joints.build(step);
  forget_impacts();
  if (bouncy_) {
    each_body([&](std::size_t i) {
      put(bodies_[i]->velocity_before, bodies_[i]->angular_velocity_before, before_[i]);
      put(bodies_[i]->velocity, bodies_[i]->angular_velocity, now_[i]);
    });
  }
  const PushOut wanted = push_out(h);
  const WidePushOut<Scalar> in_lanes{static_cast<Scalar>(wanted.rate), static_cast<Scalar>(wanted.gamma_by_K),
                                     static_cast<Scalar>(wanted.fastest), static_cast<Scalar>(wanted.threshold),
                                     static_cast<Scalar>(h)};
  fastest_ = each_bundle(
      [&](std::size_t begin, std::size_t end) { return passes.prepare_substep(bundles(begin, end), in_lanes); });
  if (fastest_ > 0) each_bundle([&](std::size_t begin, std::size_t end) { passes.save_impulses(bundles(begin, end)); });
  joints.start(step);
  each_body([&](std::size_t i) {
    bodies_[i]->velocity += linear(given_[i]);
    bodies_[i]->angular_velocity += angular(given_[i]);
  });
  for (int i = 0; i < sweeps; ++i) sweep(step, passes.solve_friction);
  joints.finish(step);
  joints.report(step);
}

/// Eight at a time of those that turn.
template <class Scalar, class JointEffect>
void Wide<Scalar, JointEffect>::integrate_positions(World& world, Real h) {
  at_work_->each(world.bodies.size(), 256, [&](Part part) {
    TurningBodies eight(turning);
    for (std::size_t i = part.begin; i < part.end; ++i) {
      Body& body = world.bodies[i];
      if (body.conveys) continue;
      body.position += h * body.velocity;
      if (body.angular_velocity == Vec3::Zero()) continue;
      if (body.movable()) eight.add(body, h);
      else spin_freely(body, h);
    }
    eight.turn(h);
  });
}

template <class Scalar, class JointEffect>
void Wide<Scalar, JointEffect>::moved(World& world, Real h) {
  const NoDenormals none;
  each_body([&](std::size_t i) {
    if (bodies_[i]->conveys) return;
    const Vec3 &v = bodies_[i]->velocity, &w = bodies_[i]->angular_velocity;
    for (int k = 0; k < 3; ++k) {
      moved_[i].of[k] += static_cast<Scalar>(h * v[k]);
      moved_[i].of[3 + k] += static_cast<Scalar>(h * w[k]);
    }
  });
  place_rows();
  each_bundle([&](std::size_t begin, std::size_t end) { passes.relax(bundles(begin, end)); });
  StepContext step = joints_step(world, h);
  joints.update_geometry(step);
  sweep(step, passes.solve_friction_and_sum);
  joints.report(step);
}

/// Rows of bodies that have passed each other, or turned, far enough are placed anew. Where nothing floats and no body has moved by
/// half of what the first pair may, there is nothing to do.
template <class Scalar, class JointEffect>
void Wide<Scalar, JointEffect>::place_rows() {
  const Real within = stays_within * shortest_reach_ / 2;
  bool far = something_floats_;
  for (std::size_t i = 0; i < bodies_.size() && !far; ++i)
    far = linear(moved_[i]).norm() >= within || reaches_[i] * angular(moved_[i]).norm() >= within;
  if (!far) return;
  each_body([&](std::size_t i) {
    bodies_[i]->refresh_inertia();
    put(bodies_[i]->velocity, bodies_[i]->angular_velocity, now_[i]);
    inertias_[i] = inertia_of<Scalar>(bodies_[i]->inverse_inertia);
  });
  set_by_set([&](std::size_t begin, std::size_t end) { passes.along(bundles(begin, end)); });
}

/// Velocities are copied into lanes, and only what the contacts have added is copied back: the velocity of a body on which no
/// contact acts keeps its bits.
template <class Scalar, class JointEffect>
void Wide<Scalar, JointEffect>::sweep(StepContext& step, void (*friction_pass)(const Bundles<Scalar>&)) {
  joints.sweep(step);
  each_body([&](std::size_t i) { put(bodies_[i]->velocity, bodies_[i]->angular_velocity, now_[i]); });
  solve_normals_until_solved([this] {
    rows_solved += where_.size();
    return static_cast<Real>(
        set_by_set([&](std::size_t begin, std::size_t end) { return passes.solve_normals(bundles(begin, end)); }));
  });
  set_by_set([&](std::size_t begin, std::size_t end) { friction_pass(bundles(begin, end)); });
  each_body([&](std::size_t i) {
    Vec3 &v = bodies_[i]->velocity, &w = bodies_[i]->angular_velocity;
    for (int k = 0; k < 3; ++k) {
      const Scalar dv = now_[i].of[k] - static_cast<Scalar>(v[k]), dw = now_[i].of[3 + k] - static_cast<Scalar>(w[k]);
      given_[i].of[k] += dv;
      given_[i].of[3 + k] += dw;
      v[k] += static_cast<Real>(dv);
      w[k] += static_cast<Real>(dw);
    }
  });
  rows_solved += 2 * where_.size();
}

/// An impact is over in one substep: the next one starts from the impulses that it started from.
template <class Scalar, class JointEffect>
void Wide<Scalar, JointEffect>::forget_impacts() {
  if (fastest_ > 0) set_by_set([&](std::size_t begin, std::size_t end) { passes.restore(bundles(begin, end)); });
  fastest_ = 0;
}

template <class Scalar, class JointEffect>
void Wide<Scalar, JointEffect>::done(World& world) {
  if (fastest_ > 0) measured_ = measure();  // an impact's impulses are about to be forgotten
  forget_impacts();
  at_work_->each(where_.size(), 256, [&](Part part) {
    for (std::size_t i = part.begin; i < part.end; ++i) write_back(world.contacts[i], i);
  });
  std::erase_if(world.contacts, [](const Contact& c) { return c.depth < 0 && c.impulse.isZero(0); });
}

/// Writes the impulses, the depth and the state of the i-th contact.
template <class Scalar, class JointEffect>
void Wide<Scalar, JointEffect>::write_back(Contact& contact, std::size_t i) const {
  const auto [b, c, lane] = where_[i];
  const Bundle<Scalar>& bundle = bundles_[b];
  const WideContact<Scalar>& wide = contacts_[c];
  const Vec3 n = vector_of(bundle.n, lane);
  const Twist<Scalar>&a_moved = moved_[std::size_t(bundle.a[lane])], &b_moved = moved_[std::size_t(bundle.b[lane])];
  contact.normal = n;
  contact.depth = -static_cast<Real>(wide.found.of[lane]) - n.dot(linear(b_moved) - linear(a_moved)) -
                  vector_of(wide.normal.rb_n, lane).dot(angular(b_moved)) +
                  vector_of(wide.normal.ra_n, lane).dot(angular(a_moved));
  const Scalar pushed = wide.normal.impulse.of[lane], rubbed1 = wide.tangent1.impulse.of[lane],
               rubbed2 = wide.tangent2.impulse.of[lane];
  const Vec3 t1 = vector_of(bundle.tangent1, lane), t2 = vector_of(bundle.tangent2, lane);
  contact.impulse = vector_of(wide.sum, lane);
  contact.last_impulse =
      static_cast<Real>(pushed) * n + static_cast<Real>(rubbed1) * t1 + static_cast<Real>(rubbed2) * t2;
  contact.state = state_of(known_[i], bundle.friction.of[lane], pushed, rubbed1, rubbed2);
}

/// Of each row by how much another sweep would change the speed along it: KeptContact::error of chapter 21.
template <class Scalar, class JointEffect>
Solved Wide<Scalar, JointEffect>::measure() const {
  Solved all = solved_of(joints.joint_rows());
  all.rows += 3 * static_cast<int>(where_.size());
  for (const Place& place : where_) {
    const std::size_t lane = place.lane;
    const Bundle<Scalar>& bundle = bundles_[place.bundle];
    const WideContact<Scalar>& wide = contacts_[place.contact];
    const Body &first = *bodies_[std::size_t(bundle.a[lane])], &second = *bodies_[std::size_t(bundle.b[lane])];
    const auto speed = [&](const EightVectors<Scalar>& direction, const WideRow<Scalar>& row) {
      return vector_of(direction, lane).dot(second.velocity - first.velocity) +
             vector_of(row.rb_n, lane).dot(second.angular_velocity) -
             vector_of(row.ra_n, lane).dot(first.angular_velocity);
    };
    const auto number = [lane](const Eight<Scalar>& of) { return static_cast<Real>(of.of[lane]); };
    const Real pushed = number(wide.normal.impulse), rubbed1 = number(wide.tangent1.impulse),
               rubbed2 = number(wide.tangent2.impulse), step_size = number(wide.step_size);
    const Real wanted = speed(bundle.n, wide.normal) + number(wide.bias) + number(wide.softness) * pushed;
    const Real total = std::max(Real(0), pushed - number(wide.mass) * wanted);
    all.residual = std::max(all.residual, std::abs(total - pushed) / number(wide.rigid_mass));
    Real total1 = rubbed1 - step_size * speed(bundle.tangent1, wide.tangent1);
    Real total2 = rubbed2 - step_size * speed(bundle.tangent2, wide.tangent2);
    const Real radius = number(bundle.friction) * pushed, size = std::hypot(total1, total2);
    if (size > radius) total1 *= radius / size, total2 *= radius / size;
    all.residual = std::max(all.residual, std::hypot(total1 - rubbed1, total2 - rubbed2) / step_size);
  }
  return all;
}

template Passes<float> passes_of_this_processor(int lanes);
template Passes<double> passes_of_this_processor(int lanes);
template class Wide<float>;
template class Wide<double>;
template class Wide<float, SteadyJoints>;
template class Wide<double, SteadyJoints>;

}  // namespace pushback
