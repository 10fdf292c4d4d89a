/// Plays motions with one of our solvers.
#pragma once

#include "pushback/chapters/01_velocity_constraint/rows_solved.h"
#include "pushback/common/world/any_solver.h"
#include "pushback/tools/measure/study/play.h"

namespace pushback {

class Ours : public Player {
 public:
  /// `counts_rows`: whether row solves measure all of its work.
  Ours(const World& world, AnySolver solver, int sweeps, bool counts_rows = true)
      : world_(world), solver_(std::move(solver)), sweeps_(sweeps), counts_rows_(counts_rows) {}
  void steps(int count, double h) override {
    const std::size_t before = rows_solved;
    for (int i = 0; i < count; ++i) world_.step(solver_, static_cast<Real>(h), sweeps_);
    rows_solved_ += rows_solved - before;
  }
  void get(Body& body) const override { body = world_.bodies[static_cast<std::size_t>(body.index)]; }
  std::optional<double> row_solves() const override {
    if (!counts_rows_) return {};
    return static_cast<double>(rows_solved_);
  }

 private:
  World world_;
  AnySolver solver_;
  int sweeps_;
  bool counts_rows_;
  std::size_t rows_solved_ = 0;  // by the steps of this player
};

/// Method::begin with a copy of this solver.
inline auto by_ours(const AnySolver& solver, bool counts_rows = true) {
  return [kept = std::make_shared<const AnySolver>(solver), counts_rows](const World& world, const Setting& setting) {
    return std::unique_ptr<Player>(std::make_unique<Ours>(world, *kept, setting.sweeps, counts_rows));
  };
}

}  // namespace pushback
