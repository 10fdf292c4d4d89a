/// What may be spent on half steps where contacts are many.
#pragma once

#include <algorithm>

namespace pushback {

/// Nobody knows what half steps will cost an island before they have been tried. What substeps cost is known: so many multiplications
/// a contact. While it has substeps, an island saves a part of that. When it has saved enough it may try half steps, and they are stopped
/// where they have spent it. Half steps that succeed are charged what they took beyond what substeps would have taken; where they took
/// less, the rest is saved. After one that fails twice as much is needed for the next.
///
/// So an island takes at most 1 + `part` times as long as by substeps alone, but for what it has `at_first`. Who has to rent skis or to
/// buy them, without knowing how often there will be snow, does the same.
///   Karlin, Manasse, Rudolph, Sleator, Competitive snoopy caching, Algorithmica 1988.
struct Savings {
  double of_contact = 4000;  ///< multiplications: what one takes in 32 substeps, in a step
  double part = 0.25;        ///< of what substeps take
  double at_first = 480;     ///< of each body: so many contacts in one step, or half as many in two
  double most = 120;         ///< steps of substeps that are ever saved
  double at_once = 20;       ///< and that are spent in one step
};

/// What bodies have saved, and need.
class Purse {
 public:
  Purse() = default;
  explicit Purse(double saved) : saved_(saved), bodies_(1) {}
  /// Bodies that come together put together what they have.
  void add(const Purse& other) {
    saved_ += other.saved_;
    need_ = std::max(need_, other.need_);
    bodies_ += other.bodies_;
  }
  /// Of one of them.
  Purse share() const {
    Purse share(saved_ / std::max(bodies_, 1));
    share.need_ = need_;
    return share;
  }
  /// Multiplications.
  double saved() const { return saved_; }
  /// `price`: what substeps take in a step.
  bool can_pay(double price) const { return saved_ >= need_ * price; }
  void save(double work, double most) { saved_ = std::clamp(saved_ + work, 0.0, std::max(saved_, most)); }
  /// A try has succeeded, or failed; no more than `most` steps are ever needed.
  void succeed(double saves, double most_saved) {
    save(saves, most_saved);
    need_ = std::max(1.0, need_ / 2);
  }
  void fail(double took, double most) {
    saved_ = std::max(0.0, saved_ - took);
    need_ = std::min(most, 2 * need_);
  }

 private:
  double saved_ = 0;
  double need_ = 1;  // steps of substeps
  int bodies_ = 0;
};

}  // namespace pushback
