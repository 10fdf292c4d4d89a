/// Work that falls into parts of which none reads what another writes.
#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>

namespace pushback {

/// The items from `begin` to before `end`; `index`: which of the parts this is.
struct Part {
  std::size_t begin, end, index;
};

class Workers;

/// The workers of a program that names no others: one thread.
Workers& alone();

/// What does the parts. This type does them one after the other; a type derived from it does several at a time.
class Workers {
 public:
  Workers() = default;
  Workers(const Workers&) = delete;
  Workers& operator=(const Workers&) = delete;
  virtual ~Workers() = default;

  /// The workers for a step of so many bodies. With few bodies one thread does all, as waking another would take longer than its
  /// part of the step.
  static constexpr std::size_t least_bodies = 256;
  Workers& of_bodies(std::size_t bodies) { return however_little_ || bodies >= least_bodies ? *this : alone(); }

  /// Into how many parts `each` cuts so many items: with `least` or more in each, as what is little takes longer shared than alone.
  std::size_t parts(std::size_t items, std::size_t least) const {
    return std::clamp<std::size_t>(items / (however_little_ ? 1 : least), 1, most_parts_);
  }
  /// `act(part)` for each part, in no order; returns when all are done. Where the cuts are depends on the numbers alone.
  template <class Act>
  void each(std::size_t items, std::size_t least, const Act& act) {
    const std::size_t count = parts(items, least);
    if (count == 1) return act(Part{0, items, 0});
    share(count, [&](std::size_t k) { act(Part{items * k / count, items * (k + 1) / count, k}); });
  }

 protected:
  /// With `however_little`, nothing is too little to be shared: for who looks for what goes wrong in small scenes.
  explicit Workers(std::size_t most_parts, bool however_little = false)
      : most_parts_(most_parts), however_little_(however_little) {}

 private:
  virtual void share(std::size_t count, const std::function<void(std::size_t index)>& act) {
    for (std::size_t k = 0; k < count; ++k) act(k);
  }
  std::size_t most_parts_ = 1;
  bool however_little_ = false;
};

inline Workers& alone() {
  static Workers one;
  return one;
}

}  // namespace pushback
