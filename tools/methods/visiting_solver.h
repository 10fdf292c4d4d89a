/// A solver whose sweep visits contacts by a method of its own.
#pragma once

#include "pushback/chapters/01_velocity_constraint/solver.h"

namespace pushback {

/// One of its effects has a function `visit(StepContext&, i)`, which is called in each sweep in the place of Row::solve, for the
/// normal of each contact in turn. What it does there is its own: it may solve the tangents too, or the normals of a whole manifold.
template <class... Effects>
class VisitingSolver : public SequentialImpulses<Effects...> {
  struct VisitingContext : StepContext {
    VisitingSolver& solver;
    void solve(std::size_t i) { solver.visit(*this, i); }
  };

 public:
  void solve(World& world, Real dt, int sweeps) override {
    VisitingContext step{{world, world.contacts, this->rows_, dt}, *this};
    this->solve_rows(step, sweeps);
  }
};

/// An entry of J M^-1 J^T of two rows of the same two bodies, 1/kg: how fast one becomes by 1 N s on the other.
inline Real coupling(const Row& one, const Row& other) {
  return one.n.dot(other.dvb - other.dva) + one.rb_n.dot(other.dwb) - one.ra_n.dot(other.dwa);
}

}  // namespace pushback
