#include "pushback/engine/substeps/wide_solver.h"

#include <algorithm>

#include "pushback/engine/substeps/floating_bodies.h"
#include "pushback/engine/substeps/flush_denormals.h"
#include "pushback/engine/substeps/integrate_bodies.h"
#include "pushback/engine/substeps/lane_access.h"

namespace pushback {

template <class Scalar>
Passes<Scalar> passes_of_this_processor(int lanes) {
#ifdef PUSHBACK_AVX2
  if (__builtin_cpu_supports("avx2")) return avx2_passes<Scalar>(lanes > 0 ? lanes : 32 / int(sizeof(Scalar)));
#endif
  return plain_passes<Scalar>(lanes > 0 ? lanes : sizeof(Scalar) == 4 ? 4 : 1);  // the faster choice with SSE2
}

template <class Scalar, class JointEffect>
void WideSubsteps<Scalar, JointEffect>::after_detection(World& world, Real h) {
  const FlushDenormals flush;
  at_work_ = &(workers ? *workers : alone()).of_bodies(world.bodies.size());
  measured_.reset();
  const std::vector<TouchingPair> touching = touching_pairs(world.contacts);
  const std::vector<bool> floats = floating_bodies(touching, world);
  guesses_.assign(world.contacts.size(), Vec3::Zero());
  start_from_last_step(world, h, [this](std::size_t i, const Vec3& impulse) { guesses_[i] = impulse; });
  packed_.build(world, make_sets(touching, world), {guesses_, floats, rebuild_fraction}, *at_work_);
  shortest_reach_ = packed_.shortest_reach();
  const std::vector<Body*>& bodies = packed_.bodies;
  for (auto* twists : {&velocities_, &velocities_before_, &displacements_, &impulse_velocities_})
    twists->assign(bodies.size(), Twist<Scalar>{});
  inertias_.resize(bodies.size());
  start_impulses_.resize(packed_.contacts.size());
  bouncy_ =
      std::any_of(world.contacts.begin(), world.contacts.end(), [](const Contact& c) { return c.restitution > 0; });
  something_floats_ = std::any_of(bodies.begin(), bodies.end() - 1,
                                  [&](const Body* b) { return floats[static_cast<std::size_t>(b->index)]; });
  set_by_set([&](std::size_t begin, std::size_t end) { passes.prepare(bundles(begin, end)); });
}

template <class Scalar, class JointEffect>
BundleRange<Scalar> WideSubsteps<Scalar, JointEffect>::bundles(std::size_t begin, std::size_t end) {
  return {packed_.bundles.data() + begin,
          static_cast<int>(end - begin),
          packed_.points.data(),
          packed_.contacts.data(),
          velocities_.data(),
          velocities_before_.data(),
          displacements_.data(),
          impulse_velocities_.data(),
          inertias_.data(),
          start_impulses_.data()};
}

/// Calls `act(i)` for each body with contacts. `act` may change only the i-th body.
template <class Scalar, class JointEffect>
template <class Act>
void WideSubsteps<Scalar, JointEffect>::each_body(const Act& act) {
  at_work_->each(packed_.bodies.size(), 256, [&](Part part) {
    for (std::size_t i = part.begin; i < part.end; ++i) act(i);
  });
}
/// Calls `act(begin, end)` for parts of all bundles. `act` must not change bodies. Returns the largest result.
template <class Scalar, class JointEffect>
template <class Act>
Scalar WideSubsteps<Scalar, JointEffect>::each_bundle(const Act& act) {
  return largest_in(0, packed_.bundles.size(), act);
}
/// The same for one set of bundles after the other. `act` may change the bodies of its bundles.
template <class Scalar, class JointEffect>
template <class Act>
Scalar WideSubsteps<Scalar, JointEffect>::set_by_set(const Act& act) {
  Scalar largest = 0;
  std::size_t begin = 0;
  for (const std::size_t end : packed_.set_ends) {
    largest = std::max(largest, largest_in(begin, end, act));
    begin = end;
  }
  return largest;
}
template <class Scalar, class JointEffect>
template <class Act>
Scalar WideSubsteps<Scalar, JointEffect>::largest_in(std::size_t begin, std::size_t end, const Act& act) {
  const std::size_t items = end - begin;
  largest_.assign(at_work_->parts(items, least_bundles), 0);
  at_work_->each(items, least_bundles, [&](Part part) {
    if constexpr (std::is_void_v<decltype(act(begin, end))>) act(begin + part.begin, begin + part.end);
    else largest_[part.index] = act(begin + part.begin, begin + part.end);
  });
  return *std::max_element(largest_.begin(), largest_.end());
}

template <class Scalar, class JointEffect>
void WideSubsteps<Scalar, JointEffect>::solve(World& world, Real h, int sweeps) {
  const FlushDenormals flush;
  StepContext step = joints_step(world, h);
  joints.build(step);
  forget_impacts();
  if (bouncy_) {
    each_body([&](std::size_t i) {
      write_twist(packed_.bodies[i]->velocity_before, packed_.bodies[i]->angular_velocity_before,
                  velocities_before_[i]);
      write_twist(packed_.bodies[i]->velocity, packed_.bodies[i]->angular_velocity, velocities_[i]);
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
    packed_.bodies[i]->velocity += linear_of(impulse_velocities_[i]);
    packed_.bodies[i]->angular_velocity += angular_of(impulse_velocities_[i]);
  });
  for (int i = 0; i < sweeps; ++i) sweep(step, passes.solve_friction);
  joints.finish(step);
  joints.report(step);
}

template <class Scalar, class JointEffect>
void WideSubsteps<Scalar, JointEffect>::integrate_positions(World& world, Real h) {
  at_work_->each(world.bodies.size(), 256, [&](Part part) {
    integrate_bodies(std::span(world.bodies).subspan(part.begin, part.end - part.begin), h, body_passes.turn);
  });
}

template <class Scalar, class JointEffect>
void WideSubsteps<Scalar, JointEffect>::after_move(World& world, Real h) {
  const FlushDenormals flush;
  each_body([&](std::size_t i) {
    if (packed_.bodies[i]->conveys) return;
    const Vec3 &v = packed_.bodies[i]->velocity, &w = packed_.bodies[i]->angular_velocity;
    for (int k = 0; k < 3; ++k) {
      displacements_[i].values[k] += static_cast<Scalar>(h * v[k]);
      displacements_[i].values[3 + k] += static_cast<Scalar>(h * w[k]);
    }
  });
  rebuild_rows();
  each_bundle([&](std::size_t begin, std::size_t end) { passes.relax(bundles(begin, end)); });
  StepContext step = joints_step(world, h);
  joints.update_geometry(step);
  sweep(step, passes.solve_friction_and_sum);
  joints.report(step);
}

/// Rebuilds the rows of pairs that have moved or turned far enough. There is nothing to do if no body floats and no body has
/// moved by half of the smallest distance at which rows are rebuilt.
template <class Scalar, class JointEffect>
void WideSubsteps<Scalar, JointEffect>::rebuild_rows() {
  const Real within = rebuild_fraction * shortest_reach_ / 2;
  bool far = something_floats_;
  for (std::size_t i = 0; i < packed_.bodies.size() && !far; ++i)
    far = linear_of(displacements_[i]).norm() >= within ||
          packed_.reaches[i] * angular_of(displacements_[i]).norm() >= within;
  if (!far) return;
  each_body([&](std::size_t i) {
    packed_.bodies[i]->refresh_inertia();
    write_twist(packed_.bodies[i]->velocity, packed_.bodies[i]->angular_velocity, velocities_[i]);
    inertias_[i] = inertia_of<Scalar>(packed_.bodies[i]->inverse_inertia);
  });
  set_by_set([&](std::size_t begin, std::size_t end) { passes.rebuild_rows(bundles(begin, end)); });
}

/// Velocities are copied into lanes, and only the changes by contacts are copied back. So the velocity of a body on which no
/// contact acts keeps its bits.
template <class Scalar, class JointEffect>
void WideSubsteps<Scalar, JointEffect>::sweep(StepContext& step, void (*friction_pass)(const BundleRange<Scalar>&)) {
  joints.sweep(step);
  each_body([&](std::size_t i) {
    write_twist(packed_.bodies[i]->velocity, packed_.bodies[i]->angular_velocity, velocities_[i]);
  });
  solve_normals_until_solved([this] {
    rows_solved += packed_.locations.size();
    return static_cast<Real>(
        set_by_set([&](std::size_t begin, std::size_t end) { return passes.solve_normals(bundles(begin, end)); }));
  });
  set_by_set([&](std::size_t begin, std::size_t end) { friction_pass(bundles(begin, end)); });
  each_body([&](std::size_t i) {
    Vec3 &v = packed_.bodies[i]->velocity, &w = packed_.bodies[i]->angular_velocity;
    for (int k = 0; k < 3; ++k) {
      const Scalar dv = velocities_[i].values[k] - static_cast<Scalar>(v[k]),
                   dw = velocities_[i].values[3 + k] - static_cast<Scalar>(w[k]);
      impulse_velocities_[i].values[k] += dv;
      impulse_velocities_[i].values[3 + k] += dw;
      v[k] += static_cast<Real>(dv);
      w[k] += static_cast<Real>(dw);
    }
  });
  rows_solved += 2 * packed_.locations.size();
}

/// An impact is over in one substep. So the next substep starts from the same impulses as the substep of the impact.
template <class Scalar, class JointEffect>
void WideSubsteps<Scalar, JointEffect>::forget_impacts() {
  if (fastest_ > 0)
    set_by_set([&](std::size_t begin, std::size_t end) { passes.restore_impulses(bundles(begin, end)); });
  fastest_ = 0;
}

template <class Scalar, class JointEffect>
void WideSubsteps<Scalar, JointEffect>::end_detection(World& world) {
  if (fastest_ > 0) measured_ = measure();  // an impact's impulses are about to be forgotten
  forget_impacts();
  at_work_->each(packed_.locations.size(), 256, [&](Part part) {
    for (std::size_t i = part.begin; i < part.end; ++i) write_back(world.contacts[i], i);
  });
  std::erase_if(world.contacts, [](const Contact& c) { return c.depth < 0 && c.impulse.isZero(0); });
}

template <class Scalar, class JointEffect>
void WideSubsteps<Scalar, JointEffect>::write_back(Contact& contact, std::size_t i) const {
  packed_.write_back(i, displacements_, known_[i], contact);
}

template <class Scalar, class JointEffect>
SolveStats WideSubsteps<Scalar, JointEffect>::measure() const {
  SolveStats all = stats_of(joints.joint_rows());
  all.rows += 3 * static_cast<int>(packed_.locations.size());
  all.residual = std::max(all.residual, packed_.residual());
  return all;
}

template Passes<float> passes_of_this_processor(int lanes);
template Passes<double> passes_of_this_processor(int lanes);
template class WideSubsteps<float, DirectTreeJoints>;
template class WideSubsteps<double, DirectTreeJoints>;
template class WideSubsteps<float, SteadyJoints>;
template class WideSubsteps<double, SteadyJoints>;

}  // namespace pushback
