/// Lanes for compilers without <experimental/simd>, such as the one for web pages. There is only one lane, whatever the width,
/// with the same bits.
///
/// In an anonymous namespace, as lanes.h.
#pragma once

#include <algorithm>
#include <cmath>
#include <concepts>
#include <cstddef>

namespace pushback {
namespace {

namespace simd {
struct ElementAligned {};
constexpr ElementAligned element_aligned;
}  // namespace simd

/// A number with the part of std::experimental::simd's interface that the passes use.
template <class Real>
class OneLane {
 public:
  using mask_type = bool;
  using value_type = Real;
  OneLane() = default;
  OneLane(Real number) : number_(number) {}
  OneLane(const Real* from, simd::ElementAligned) : number_(*from) {}
  template <std::invocable<int> Make>
  explicit OneLane(const Make& make) : number_(make(0)) {}
  static constexpr std::size_t size() { return 1; }
  void copy_to(Real* to, simd::ElementAligned) const { *to = number_; }
  Real operator[](std::size_t) const { return number_; }

  friend OneLane operator+(const OneLane& p, const OneLane& q) { return p.number_ + q.number_; }
  friend OneLane operator-(const OneLane& p, const OneLane& q) { return p.number_ - q.number_; }
  friend OneLane operator*(const OneLane& p, const OneLane& q) { return p.number_ * q.number_; }
  friend OneLane operator/(const OneLane& p, const OneLane& q) { return p.number_ / q.number_; }
  OneLane& operator*=(const OneLane& factor) { return *this = *this * factor; }
  friend bool operator<(const OneLane& p, const OneLane& q) { return p.number_ < q.number_; }
  friend bool operator>(const OneLane& p, const OneLane& q) { return p.number_ > q.number_; }
  friend bool operator>=(const OneLane& p, const OneLane& q) { return p.number_ >= q.number_; }
  OneLane operator-() const { return -number_; }
  friend OneLane sqrt(const OneLane& of) { return std::sqrt(of.number_); }
  friend OneLane abs(const OneLane& of) { return std::abs(of.number_); }
  friend OneLane max(const OneLane& p, const OneLane& q) { return std::max(p.number_, q.number_); }
  friend Real hmax(const OneLane& of) { return of.number_; }

  /// where(mask, lanes) = values assigns in the lanes in which the mask is true.
  class Where {
   public:
    Where(bool holds, OneLane& lane) : holds_(holds), lane_(lane) {}
    void operator=(const OneLane& value) const {
      if (holds_) lane_ = value;
    }

   private:
    bool holds_;
    OneLane& lane_;
  };
  friend Where where(bool holds, OneLane& lane) { return {holds, lane}; }

 private:
  Real number_;
};
inline bool any_of(bool holds) {
  return holds;
}
inline bool none_of(bool holds) {
  return !holds;
}

template <class Real, int>
using LanesOf = OneLane<Real>;

}  // namespace
}  // namespace pushback
