#include "pushback/common/experiment/played.h"

#include <algorithm>
#include <chrono>
#include <iterator>

namespace pushback {

namespace {

std::vector<ContactId> ids_of(const Contacts& contacts) {
  std::vector<ContactId> ids;
  for (const Contact& contact : contacts)
    if (!contact.parted) ids.push_back(contact.id);
  return ids;
}

int count_missing(const std::vector<ContactId>& from, const std::vector<ContactId>& in) {
  std::vector<ContactId> missing;
  std::set_difference(from.begin(), from.end(), in.begin(), in.end(), std::back_inserter(missing));
  return static_cast<int>(missing.size());
}

/// Wraps the variant's solver. It times only the solver, and records its rows after the sweeps of the last substep, before a relaxing
/// pass changes them.
class Watched : public ForwardingSolver {
 public:
  Watched(AnySolver& solver, int substeps, Sample& sample)
      : solver_(solver), substeps_left_(substeps), sample_(sample) {}
  void after_detection(World& world, Real h) override {
    timed([&] { solver_.after_detection(world, h); });
  }
  void solve(World& world, Real h, int sweeps) override {
    timed([&] { solver_.solve(world, h, sweeps); });
    if (--substeps_left_ > 0) return;
    const SolveStats solved = solver_.stats();
    sample_.rows = solved.rows;
    sample_.residual = solved.residual;
  }
  void after_move(World& world, Real h) override {
    timed([&] { solver_.after_move(world, h); });
  }
  void end_detection(World& world) override {
    timed([&] { solver_.end_detection(world); });
  }

 private:
  StepSolver& inner() override { return solver_; }
  const StepSolver& inner() const override { return solver_; }
  template <class Work>
  void timed(const Work& work) {
    const auto begin = std::chrono::steady_clock::now();
    work();
    sample_.solver_seconds += std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  }
  AnySolver& solver_;
  int substeps_left_;
  Sample& sample_;
};

}  // namespace

Experiment::Played::Played(const Experiment& of, const Variant& variant)
    : experiment_(&of), variant_(&variant), solver_(variant.solver), motion_(variant.motion) {
  of.fill(world, variant);
}

Sample Experiment::Played::step() {
  Sample sample;
  const Real dt = experiment_->dt_;
  const int sweeps = experiment_->sweeps_of(*variant_);
  if (solver_ && solver_->divides_worlds()) {
    const auto begin = std::chrono::steady_clock::now();
    world.step(*solver_, dt, sweeps);
    sample.solver_seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    const SolveStats solved = solver_->stats();
    sample.rows = solved.rows;
    sample.residual = solved.residual;
  } else if (solver_) {
    Watched watched(*solver_, solver_->plan(dt).all_substeps(), sample);
    world.step(watched, dt, sweeps);
  } else {
    sample.rows = static_cast<int>(motion_(world, dt, sweeps));
  }
  sample.time = static_cast<Real>(++steps_) * dt;
  sample.kinetic_energy = kinetic_energy(world);
  sample.potential_energy = potential_energy(world);
  sample.momentum = momentum(world);
  sample.angular_momentum = angular_momentum(world);
  sample.overlap = deepest_overlap(world);
  std::vector<ContactId> now = ids_of(world.contacts);
  sample.contacts = static_cast<int>(now.size());
  sample.found = count_missing(now, contacts_before_);
  sample.lost = count_missing(contacts_before_, now);
  contacts_before_ = std::move(now);
  return sample;
}

}  // namespace pushback
