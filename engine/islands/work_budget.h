/// Limits the work of half steps in islands with many contacts.
#pragma once

#include <algorithm>

namespace pushback {

/// The work of half steps is unknown before they are tried. The work of substeps is known, as a number of multiplications per
/// contact. While an island gets substeps, it saves a fraction of their work. When it has saved enough, half steps are tried, and
/// stopped when they have spent the savings. A successful try is charged the work beyond the work of substeps. If it took less, the
/// difference is saved. After a failure, the next try needs twice the savings.
///
/// So an island takes at most 1 + `fraction` times as long as with substeps only, apart from its initial savings `at_first`. This is
/// the ski rental problem of renting or buying without knowing how often there will be snow.
///   Karlin, Manasse, Rudolph, Sleator, Competitive snoopy caching, Algorithmica 1988.
struct WorkBudgetSettings {
  double per_contact = 4000;  ///< multiplications per contact, the work of a step of 32 substeps
  double fraction = 0.25;     ///< the saved fraction of the work of substeps
  double at_first = 480;      ///< initial savings per body, in units of per_contact
  double most = 120;          ///< the largest savings, in steps of substeps
  double at_once = 20;        ///< the most that one step may spend, in steps of substeps
};

/// The savings of some bodies, and the savings that their next try requires.
class WorkBudget {
 public:
  WorkBudget() = default;
  explicit WorkBudget(double saved) : saved_(saved), bodies_(1) {}
  /// Adds the savings of another body of the same island.
  void add(const WorkBudget& other) {
    saved_ += other.saved_;
    required_steps_ = std::max(required_steps_, other.required_steps_);
    bodies_ += other.bodies_;
  }
  /// The share of one body.
  WorkBudget share() const {
    WorkBudget share(saved_ / std::max(bodies_, 1));
    share.required_steps_ = required_steps_;
    return share;
  }
  /// The savings, in multiplications.
  double saved() const { return saved_; }
  /// `price`: the work of substeps in a step.
  bool can_pay(double price) const { return saved_ >= required_steps_ * price; }
  void save(double work, double most) { saved_ = std::clamp(saved_ + work, 0.0, std::max(saved_, most)); }
  void succeed(double saves, double most_saved) {
    save(saves, most_saved);
    required_steps_ = std::max(1.0, required_steps_ / 2);
  }
  /// No more than `most` steps are ever required.
  void fail(double work, double most) {
    saved_ = std::max(0.0, saved_ - work);
    required_steps_ = std::min(most, 2 * required_steps_);
  }

 private:
  double saved_ = 0;
  double required_steps_ = 1;  // the required savings, in steps of substeps
  int bodies_ = 0;
};

}  // namespace pushback
