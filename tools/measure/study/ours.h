/// A solver of ours as a player of motions, one step a substep.
#pragma once

#include "pushback/chapters/01_velocity_constraint/rows_solved.h"
#include "pushback/common/world/any_solver.h"
#include "pushback/tools/measure/study/play.h"

namespace pushback {

class Ours : public PlayerInSubsteps {
 public:
  Ours(const Motion& motion, const Setting& setting, AnySolver solver, bool counts_rows)
      : solver_(std::move(solver)),
        dt_(static_cast<Real>(setting.dt())),
        sweeps_(setting.sweeps),
        counts_rows_(counts_rows) {
    motion.begin(world_);
  }
  void substep() override {
    const std::size_t before = rows_solved;
    world_.step(solver_, dt_, sweeps_);
    rows_solved_ += rows_solved - before;
  }
  Eigen::Vector3d place(std::size_t body) const override { return world_.bodies[body].position.cast<double>(); }
  std::optional<double> row_solves() const override {
    if (!counts_rows_) return {};
    return static_cast<double>(rows_solved_);
  }

 private:
  World world_;
  AnySolver solver_;
  Real dt_;
  int sweeps_;
  bool counts_rows_;
  std::size_t rows_solved_ = 0;  // by this player's steps
};

}  // namespace pushback
