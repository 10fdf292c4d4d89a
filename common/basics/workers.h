/// Work divided into independent parts, none of which reads data that another part writes.
#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>

namespace pushback {

/// The items from `begin` to before `end`. `index`: the number of the part, from 0.
struct Part {
  std::size_t begin, end, index;
};

class Workers;

/// The default workers: one thread.
Workers& alone();

/// Runs the parts. This type runs them one after the other, and a derived type runs several at a time.
class Workers {
 public:
  Workers() = default;
  Workers(const Workers&) = delete;
  Workers& operator=(const Workers&) = delete;
  virtual ~Workers() = default;

  /// The workers for a step of so many bodies. One thread runs a step of fewer than `least_bodies`, because waking another thread
  /// would take longer than its share of the step.
  static constexpr std::size_t least_bodies = 256;
  Workers& of_bodies(std::size_t bodies) { return always_split_ || bodies >= least_bodies ? *this : alone(); }

  /// The number of parts into which `each` divides so many items. Two or more parts have at least `least` items each, because
  /// sharing less work takes longer than running it on one thread.
  std::size_t parts(std::size_t items, std::size_t least) const {
    return std::clamp<std::size_t>(items / (always_split_ ? 1 : least), 1, most_parts_);
  }
  /// Calls `act(part)` for each part, in no particular order, and returns when all calls have returned. The division depends only
  /// on the two numbers and the settings of the workers.
  template <class Act>
  void each(std::size_t items, std::size_t least, const Act& act) {
    const std::size_t count = parts(items, least);
    if (count == 1) return act(Part{0, items, 0});
    share(count, [&](std::size_t k) { act(Part{items * k / count, items * (k + 1) / count, k}); });
  }

 protected:
  /// With `always_split`, any amount of work is shared, which exposes threading errors in small scenes.
  explicit Workers(std::size_t most_parts, bool always_split = false)
      : most_parts_(most_parts), always_split_(always_split) {}

 private:
  virtual void share(std::size_t count, const std::function<void(std::size_t index)>& act) {
    for (std::size_t k = 0; k < count; ++k) act(k);
  }
  std::size_t most_parts_ = 1;
  bool always_split_ = false;
};

inline Workers& alone() {
  static Workers one;
  return one;
}

}  // namespace pushback
