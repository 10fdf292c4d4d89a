/// Times of several things, taken in turn, so that other load on the machine affects all of them alike.
#pragma once

#include <algorithm>
#include <chrono>
#include <functional>
#include <vector>

#include "pushback/common/basics/quantile.h"

namespace pushback {

template <class Act>
double seconds_with_clock(const Act& act) {
  const auto begin = std::chrono::steady_clock::now();
  act();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

/// s, less the time that the clock takes itself.
template <class Act>
double seconds_of(const Act& act) {
  static const double clock = [] {
    std::vector<double> nothing(1001);
    for (double& time : nothing) time = seconds_with_clock([] {});
    return median(nothing);
  }();
  return seconds_with_clock(act) - clock;
}

/// Medians over rounds. In each round all things are timed, and each is the first in its turn.
class InTurn {
 public:
  /// Each returns the seconds that it took.
  void round(const std::vector<std::function<double()>>& things) {
    times_.resize(things.size());
    for (std::size_t k = 0; k < things.size(); ++k) {
      const std::size_t thing = (k + rounds_) % things.size();
      times_[thing].push_back(things[thing]());
    }
    ++rounds_;
  }
  double time(std::size_t thing) const { return median(times_[thing]); }
  double ratio(std::size_t thing, std::size_t to) const {
    return median_of_pairs(thing, to, [](double p, double q) { return p / q; });
  }
  double difference(std::size_t thing, std::size_t from) const {
    return median_of_pairs(thing, from, [](double p, double q) { return p - q; });
  }

 private:
  template <class Of>
  double median_of_pairs(std::size_t first, std::size_t second, const Of& of) const {
    std::vector<double> all(rounds_);
    std::transform(times_[first].begin(), times_[first].end(), times_[second].begin(), all.begin(), of);
    return median(all);
  }

  std::vector<std::vector<double>> times_;  // s: of each thing, in each round
  std::size_t rounds_ = 0;
};

}  // namespace pushback
