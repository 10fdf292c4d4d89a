/// A solver of ours as a player of motions.
#pragma once

#include "pushback/chapters/01_velocity_constraint/rows_solved.h"
#include "pushback/common/world/any_solver.h"
#include "pushback/tools/measure/study/play.h"

namespace pushback {

/// How a solver takes its steps.
struct Stepping {
  bool divides = false;     ///< a frame of 1/60 s is one step, which it divides itself; else a substep is one
  bool counts_rows = true;  ///< whether rows are all of its work
};

class Ours : public Player {
 public:
  Ours(const Motion& motion, const Setting& setting, AnySolver solver, const Stepping& stepping = {})
      : solver_(std::move(solver)),
        steps_(stepping.divides ? 1 : setting.substeps),
        dt_(static_cast<Real>(Setting{.substeps = steps_}.dt())),
        sweeps_(setting.sweeps),
        counts_rows_(stepping.counts_rows) {
    motion.begin(world_);
  }
  void frame(int) override {
    const std::size_t before = rows_solved;
    for (int i = 0; i < steps_; ++i) world_.step(solver_, dt_, sweeps_);
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
  int steps_;  // in a frame
  Real dt_;
  int sweeps_;
  bool counts_rows_;
  std::size_t rows_solved_ = 0;  // by this player's steps
};

/// Method::begin, by a copy of this solver.
inline auto by_ours(const AnySolver& solver, const Stepping& stepping = {}) {
  return [kept = std::make_shared<const AnySolver>(solver), stepping](const Motion& motion, const Setting& setting) {
    return std::unique_ptr<Player>(std::make_unique<Ours>(motion, setting, *kept, stepping));
  };
}

}  // namespace pushback
