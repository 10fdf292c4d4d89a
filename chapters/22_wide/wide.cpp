#include "pushback/chapters/22_wide/wide.h"

#ifdef __SSE__
#include <xmmintrin.h>
#endif

namespace pushback {

namespace {

/// What is smaller than the smallest normal number counts as 0 while this lives: an impulse that fades away would otherwise take a
/// hundred times as long to multiply.
class NoDenormals {
 public:
#ifdef __SSE__
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
void put(const Row& row, WideRow<Scalar>& into, std::size_t lane) {
  put(row.ra_n, into.ra_n, lane);
  put(row.rb_n, into.rb_n, lane);
  put(Vec3(-row.dwa), into.dwa, lane);
  put(row.dwb, into.dwb, lane);
  into.impulse.of[lane] = static_cast<Scalar>(row.impulse);
}
template <class Scalar>
Twist<Scalar> twist_of(const Vec3& v, const Vec3& w) {
  Twist<Scalar> twist{};
  for (int i = 0; i < 3; ++i) twist.v[i] = static_cast<Scalar>(v[i]), twist.w[i] = static_cast<Scalar>(w[i]);
  return twist;
}
template <class Scalar>
Vec3 vector_of(const Scalar (&from)[3]) {
  return {static_cast<Real>(from[0]), static_cast<Real>(from[1]), static_cast<Real>(from[2])};
}

}  // namespace

template <class Scalar>
Passes<Scalar> passes_of_this_processor(int lanes) {
#ifdef PUSHBACK_AVX2
  if (__builtin_cpu_supports("avx2")) return avx2_passes<Scalar>(lanes > 0 ? lanes : 32 / int(sizeof(Scalar)));
#endif
  return plain_passes<Scalar>(lanes > 0 ? lanes : sizeof(Scalar) == 4 ? 4 : 1);  // what SSE2 is faster with
}

template <class Scalar>
std::size_t Wide<Scalar>::place_of(World& world, std::size_t body) {
  constexpr std::size_t none = std::numeric_limits<std::size_t>::max();
  if (places_.empty()) places_.assign(world.bodies.size(), none);
  if (places_[body] == none) {
    places_[body] = bodies_.size();
    bodies_.push_back(&world.bodies[body]);
  }
  return places_[body];
}

template <class Scalar>
void Wide<Scalar>::detected(World& world, Real h) {
  bodies_.clear();
  places_.clear();
  bundles_.clear();
  contacts_.clear();
  Sets sets = sets_of(touching_pairs(world.contacts), world);
  for (auto& set : sets)
    for (PairOfBodies& pair : set) pair.a = place_of(world, pair.a), pair.b = place_of(world, pair.b);
  bodies_.push_back(&world.body(the_world));
  for (auto* twists : {&now_, &before_, &moved_, &given_}) twists->assign(bodies_.size(), Twist<Scalar>{});
  where_.resize(world.contacts.size());
  known_.assign(world.contacts.size(), false);
  for (const auto& set : sets) pack(world, set, world.contacts_before, world.impulse_scale(h));
}

/// Rows are chapter 21's, copied side by side.
template <class Scalar>
void Wide<Scalar>::pack(World& world, const std::vector<PairOfBodies>& set, const Contacts& before, Real scale) {
  const int nobody = static_cast<int>(bodies_.size()) - 1;
  for (std::size_t first = 0; first < set.size(); first += lanes_of_bundle) {
    Bundle<Scalar>& bundle = bundles_.emplace_back();
    std::fill(bundle.a, bundle.a + lanes_of_bundle, nobody);
    std::fill(bundle.b, bundle.b + lanes_of_bundle, nobody);
    bundle.first = static_cast<int>(contacts_.size());
    contacts_.resize(contacts_.size() + set[first].count);  // of all in the set that are left, this has the most
    bundle.end = static_cast<int>(contacts_.size());
    for (std::size_t lane = 0; lane < lanes_of_bundle && first + lane < set.size(); ++lane) {
      const PairOfBodies& pair = set[first + lane];
      bundle.a[lane] = static_cast<int>(pair.a);
      bundle.b[lane] = static_cast<int>(pair.b);
      bundle.inverse_mass_a.of[lane] = static_cast<Scalar>(bodies_[pair.a]->inverse_mass);
      bundle.inverse_mass_b.of[lane] = static_cast<Scalar>(bodies_[pair.b]->inverse_mass);
      bundle.friction.of[lane] = static_cast<Scalar>(world.contacts[pair.first].friction);
      for (std::size_t point = 0; point < pair.count; ++point) {
        const std::size_t index = pair.first + point, contact = static_cast<std::size_t>(bundle.first) + point;
        KeptContact kept(world, index, pair.a, pair.b);
        const Contact& now = world.contacts[index];
        const auto old = std::lower_bound(before.begin(), before.end(), now.id,
                                          [](const Contact& one, const ContactId& id) { return one.id < id; });
        known_[index] = old != before.end() && old->id == now.id;
        if (known_[index]) kept.guess(scale * old->impulse);
        if (point == 0) {
          put(kept.normal.n, bundle.n, lane);
          put(kept.tangent1.n, bundle.tangent1, lane);
          put(kept.tangent2.n, bundle.tangent2, lane);
        }
        WideContact<Scalar>& wide = contacts_[contact];
        put(kept.normal, wide.normal, lane);
        put(kept.tangent1, wide.tangent1, lane);
        put(kept.tangent2, wide.tangent2, lane);
        wide.found.of[lane] = static_cast<Scalar>(kept.found);
        wide.restitution.of[lane] = static_cast<Scalar>(kept.restitution);
        wide.rigid_mass.of[lane] = static_cast<Scalar>(kept.normal.effective_mass);
        wide.step_size.of[lane] = static_cast<Scalar>(kept.step_size);
        where_[index] = {bundles_.size() - 1, contact, lane};
        for (const Row* row : {&kept.normal, &kept.tangent1, &kept.tangent2}) {
          const auto add = [](Twist<Scalar>& to, const Twist<Scalar>& what) {
            for (int i = 0; i < 3; ++i) to.v[i] += what.v[i], to.w[i] += what.w[i];
          };
          add(given_[pair.a], twist_of<Scalar>(row->impulse * row->dva, row->impulse * row->dwa));
          add(given_[pair.b], twist_of<Scalar>(row->impulse * row->dvb, row->impulse * row->dwb));
        }
      }
    }
  }
}

template <class Scalar>
Bundles<Scalar> Wide<Scalar>::bundles() {
  return {bundles_.data(), static_cast<int>(bundles_.size()), contacts_.data(), now_.data(), before_.data(),
          moved_.data()};
}

template <class Scalar>
void Wide<Scalar>::solve(World& world, Real h, int sweeps) {
  const NoDenormals none;
  Step step = joints_step(world, h);
  joints.build(step);
  for (std::size_t i = 0; i < bodies_.size(); ++i)
    before_[i] = twist_of<Scalar>(bodies_[i]->velocity_before, bodies_[i]->angular_velocity_before);
  const PushOut wanted = push_out(h);
  passes.aim(bundles(),
             {static_cast<Scalar>(wanted.rate), static_cast<Scalar>(wanted.gamma_by_K),
              static_cast<Scalar>(wanted.fastest), static_cast<Scalar>(wanted.threshold), static_cast<Scalar>(h)});
  joints.start(step);
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    bodies_[i]->velocity += vector_of(given_[i].v);
    bodies_[i]->angular_velocity += vector_of(given_[i].w);
  }
  for (int i = 0; i < sweeps; ++i) sweep(step);
  joints.finish(step);
  joints.report(step);
}

template <class Scalar>
void Wide<Scalar>::after_move(World& world, Real h) {
  const NoDenormals none;
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    const Twist<Scalar> way = twist_of<Scalar>(h * bodies_[i]->velocity, h * bodies_[i]->angular_velocity);
    for (int k = 0; k < 3; ++k) moved_[i].v[k] += way.v[k], moved_[i].w[k] += way.w[k];
  }
  passes.relax(bundles());
  Step step = joints_step(world, h);
  joints.moved(step);
  sweep(step);
  joints.report(step);
}

/// Velocities are copied here, and what the contacts have added to them back: what nothing pushes keeps its bits.
template <class Scalar>
void Wide<Scalar>::sweep(Step& step) {
  joints.sweep(step);
  for (std::size_t i = 0; i < bodies_.size(); ++i)
    now_[i] = twist_of<Scalar>(bodies_[i]->velocity, bodies_[i]->angular_velocity);
  start_ = now_;
  passes.sweep(bundles());
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    Twist<Scalar> change{};
    for (int k = 0; k < 3; ++k) {
      change.v[k] = now_[i].v[k] - start_[i].v[k];
      change.w[k] = now_[i].w[k] - start_[i].w[k];
      given_[i].v[k] += change.v[k];
      given_[i].w[k] += change.w[k];
    }
    bodies_[i]->velocity += vector_of(change.v);
    bodies_[i]->angular_velocity += vector_of(change.w);
  }
  rows_solved += 3 * where_.size();
}

template <class Scalar>
void Wide<Scalar>::done(World& world) {
  for (std::size_t i = 0; i < where_.size(); ++i) {
    const auto [b, c, lane] = where_[i];
    const Bundle<Scalar>& bundle = bundles_[b];
    const WideContact<Scalar>& wide = contacts_[c];
    Contact& contact = world.contacts[i];
    const Vec3 n = vector_of(bundle.n, lane);
    const Twist<Scalar>&a_moved = moved_[std::size_t(bundle.a[lane])], &b_moved = moved_[std::size_t(bundle.b[lane])];
    contact.depth = -static_cast<Real>(wide.found.of[lane]) - n.dot(vector_of(b_moved.v) - vector_of(a_moved.v)) -
                    vector_of(wide.normal.rb_n, lane).dot(vector_of(b_moved.w)) +
                    vector_of(wide.normal.ra_n, lane).dot(vector_of(a_moved.w));
    const Scalar pushed = wide.normal.impulse.of[lane], rubbed1 = wide.tangent1.impulse.of[lane],
                 rubbed2 = wide.tangent2.impulse.of[lane];
    contact.impulse = static_cast<Real>(pushed) * n + static_cast<Real>(rubbed1) * vector_of(bundle.tangent1, lane) +
                      static_cast<Real>(rubbed2) * vector_of(bundle.tangent2, lane);
    contact.state = state_of(known_[i], bundle.friction.of[lane], pushed, rubbed1, rubbed2);
  }
  std::erase_if(world.contacts, [](const Contact& c) { return c.depth < 0 && c.impulse.isZero(0); });
}

template Passes<float> passes_of_this_processor(int lanes);
template Passes<double> passes_of_this_processor(int lanes);
template class Wide<float>;
template class Wide<double>;

}  // namespace pushback
