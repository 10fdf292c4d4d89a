/// A lane that counts what is done with it: the passes of chapter 22 run with it as they do with a number, to the same bits.
#pragma once

#include <cmath>
#include <concepts>
#include <experimental/simd>

namespace pushback {

/// Of all lanes since it was last set to nothing.
struct Work {
  double operations = 0;  ///< sums, differences, products, comparisons, choices: what a processor begins each cycle
  double slow = 0;        ///< quotients and roots
  double bytes = 0;       ///< read and written
};
inline Work counted_work;

struct CountedMask {
  bool holds;
  CountedMask operator!() const { return {!holds}; }
  friend CountedMask operator&&(CountedMask p, CountedMask q) { return {p.holds && q.holds}; }
  friend CountedMask operator||(CountedMask p, CountedMask q) { return {p.holds || q.holds}; }
  friend bool any_of(CountedMask mask) { return mask.holds; }
  friend bool none_of(CountedMask mask) { return !mask.holds; }
};

/// As much of the interface of std::experimental::simd as the passes use.
template <class Scalar>
class Counted {
 public:
  using value_type = Scalar;
  using mask_type = CountedMask;
  Counted() = default;
  Counted(Scalar number) : number_(number) {}
  template <class Flags>
  Counted(const Scalar* from, Flags) : number_(*from) {
    counted_work.bytes += sizeof(Scalar);
  }
  template <std::invocable<int> Make>
  explicit Counted(const Make& make) : number_(make(0)) {
    counted_work.bytes += sizeof(Scalar);
  }
  static constexpr std::size_t size() { return 1; }
  template <class Flags>
  void copy_to(Scalar* to, Flags) const {
    *to = number_;
    counted_work.bytes += sizeof(Scalar);
  }
  Scalar operator[](std::size_t) const {
    counted_work.bytes += sizeof(Scalar);
    return number_;
  }

  friend Counted operator+(const Counted& p, const Counted& q) { return operation(p.number_ + q.number_); }
  friend Counted operator-(const Counted& p, const Counted& q) { return operation(p.number_ - q.number_); }
  friend Counted operator*(const Counted& p, const Counted& q) { return operation(p.number_ * q.number_); }
  friend Counted operator/(const Counted& p, const Counted& q) { return slow(p.number_ / q.number_); }
  Counted& operator*=(const Counted& factor) { return *this = *this * factor; }
  friend CountedMask operator<(const Counted& p, const Counted& q) { return {operation(p.number_ < q.number_)}; }
  friend CountedMask operator>(const Counted& p, const Counted& q) { return {operation(p.number_ > q.number_)}; }
  friend CountedMask operator>=(const Counted& p, const Counted& q) { return {operation(p.number_ >= q.number_)}; }
  Counted operator-() const { return operation(-number_); }
  friend Counted sqrt(const Counted& of) { return slow(std::sqrt(of.number_)); }
  friend Counted abs(const Counted& of) { return operation(std::abs(of.number_)); }
  friend Counted max(const Counted& p, const Counted& q) { return operation(std::max(p.number_, q.number_)); }
  friend Scalar hmax(const Counted& of) { return of.number_; }

  struct Where {
    bool holds;
    Counted& lane;
    void operator=(const Counted& value) const {
      if (operation(holds)) lane = value;
    }
  };
  friend Where where(CountedMask mask, Counted& lane) { return {mask.holds, lane}; }

 private:
  template <class Result>
  static Result operation(Result result) {
    ++counted_work.operations;
    return result;
  }
  static Counted slow(Scalar result) {
    ++counted_work.slow;
    return result;
  }

  Scalar number_;
};

}  // namespace pushback
