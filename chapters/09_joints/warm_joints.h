/// Joints that start from where the last step ended, as contacts do in chapter 07.
#pragma once

#include "chapters/09_joints/joints.h"

namespace pushback {

/// In the place of Joints. A joint asks for as many equations in every step: the n-th is known by its place.
struct WarmJoints : Joints {
  void hold(World& world, Real dt) {
    memory_.resize(world.joints.size());  // who comes back is not taken for who was there
    Joints::hold(world, dt);
  }
  void build(const Contacts&, Rows&, Real dt) {
    scale_ = last_dt_ > 0 ? dt / last_dt_ : 0;
    last_dt_ = dt;
  }
  void start(Rows&) {
    each_row([this](Row& row, std::size_t n) {
      if (n < impulses_of(row).size()) row.reach(scale_ * impulses_of(row)[n]);
    });
  }
  void report(Contacts&, const Rows&) { remember(); }
  /// After a teleport, or when joints were exchanged for as many others.
  void forget_joints() {
    for (std::vector<Real>& impulses : memory_) impulses.clear();
  }

 protected:
  void remember() {
    each_row([this](const Row& row, std::size_t n) {
      if (n == 0) impulses_of(row).clear();
      impulses_of(row).push_back(row.impulse);
    });
  }
  /// `use(row, n)`: the n-th of its joint, from 0.
  template <class Use>
  void each_row(const Use& use) {
    int joint = -1;
    std::size_t n = 0;
    for (Row& row : joint_rows_) {
      n = row.contact == joint ? n + 1 : 0;
      joint = row.contact;
      use(row, n);
    }
  }
  std::vector<Real>& impulses_of(const Row& row) { return memory_[static_cast<std::size_t>(row.contact)]; }

 private:
  std::vector<std::vector<Real>> memory_;  // by joint, N s
  Real scale_ = 0, last_dt_ = 0;
};

}  // namespace pushback
