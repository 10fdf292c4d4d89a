/// The velocities of several bodies, gathered into lanes and scattered back.
///
/// In an anonymous namespace, as lanes.h.
#pragma once

#include <type_traits>
#include <utility>

#include "pushback/engine/substeps/lanes.h"

namespace pushback {
namespace {

/// v and w, or displacement and turn, of one body per lane.
template <class Lanes>
struct Motions {
  Vec<Lanes> v, w;
};

/// A square matrix with one register per row. Each register has two halves of 16 bytes, because few instructions move numbers
/// between them.
template <class Real>
struct Square {
  static constexpr int width = 32 / sizeof(Real), half = width / 2;
  using Row [[gnu::vector_size(32), gnu::may_alias]] = Real;
  Row rows[width];

  /// Transposes each quarter, then swaps the two quarters off the diagonal.
  [[gnu::always_inline]] void transpose() { transpose(std::make_integer_sequence<int, width>()); }

 private:
  template <int... i>
  [[gnu::always_inline]] void transpose(std::integer_sequence<int, i...>) {
    for (int dealt = 1; dealt < half; dealt *= 2)
      for (int first = 0; first < width; first += half) {
        Row before[half];
        for (int row = 0; row < half; ++row) before[row] = rows[first + row];
        for (int row = 0; row < half / 2; ++row) {  // interleaves two rows
          const Row p = before[row], q = before[row + half / 2];
          rows[first + 2 * row] = __builtin_shufflevector(p, q, (i / half * half + i % half / 2 + i % 2 * width)...);
          rows[first + 2 * row + 1] =
              __builtin_shufflevector(p, q, (i / half * half + half / 2 + i % half / 2 + i % 2 * width)...);
        }
      }
    for (int row = 0; row < half; ++row) {
      const Row p = rows[row], q = rows[row + half];
      rows[row] = __builtin_shufflevector(p, q, (i < half ? i : i + half)...);
      rows[row + half] = __builtin_shufflevector(p, q, (i < half ? i + half : i + width)...);
    }
  }
};

/// Twists of as many bodies as a register has numbers. After `transpose`, each row has one number of all twists, a lane for
/// each body.
template <class Real>
struct Twists {
  static constexpr int bodies = Square<Real>::width, squares = 8 / bodies;
  using Row = typename Square<Real>::Row;
  Square<Real> part[squares];

  [[gnu::always_inline]] Row& number(int i) { return part[i / bodies].rows[i % bodies]; }
  [[gnu::always_inline]] void transpose() {
    for (Square<Real>& square : part) square.transpose();
  }
  [[gnu::always_inline]] void read(int body, const Twist<Real>& from) {
    for (int i = 0; i < squares; ++i) part[i].rows[body] = reinterpret_cast<const Row*>(&from)[i];
  }
  [[gnu::always_inline]] void write(int body, Twist<Real>& to) const {
    for (int i = 0; i < squares; ++i) reinterpret_cast<Row*>(&to)[i] = part[i].rows[body];
  }
};
/// Whether the lanes fill one such register. Then transposing takes half the time of gathering number by number.
template <class Lanes, class Real>
constexpr bool fill_a_register =
    int(Lanes::size()) == Square<Real>::width && sizeof(Lanes) == sizeof(typename Square<Real>::Row) &&
    std::is_trivially_copyable_v<Lanes>;

template <class Lanes, class Real>
[[gnu::always_inline]] inline Motions<Lanes> fetch(const int* which, const Twist<Real>* bodies) {
  if constexpr (fill_a_register<Lanes, Real>) {
    Twists<Real> twists;
    for (int i = 0; i < twists.bodies; ++i) twists.read(i, bodies[which[i]]);
    twists.transpose();
    const auto lanes = [&](int i) { return __builtin_bit_cast(Lanes, twists.number(i)); };  // em++ has no std::bit_cast
    return {{lanes(0), lanes(1), lanes(2)}, {lanes(3), lanes(4), lanes(5)}};
  } else {
    const auto each = [&](int number) { return Lanes([&](int i) { return bodies[which[i]].values[number]; }); };
    return {{each(0), each(1), each(2)}, {each(3), each(4), each(5)}};
  }
}

/// Immovable bodies are not written, because other bundles of the set may contain them as well.
template <class Lanes, class Real>
[[gnu::always_inline]] inline void put(const Motions<Lanes>& motion, const int* which, const Real* inverse_masses,
                                       Twist<Real>* bodies) {
  if constexpr (fill_a_register<Lanes, Real>) {
    Twists<Real> twists;
    const auto set = [&](int i, const Lanes& lanes) {
      twists.number(i) = __builtin_bit_cast(typename Twists<Real>::Row, lanes);
    };
    set(0, motion.v.x), set(1, motion.v.y), set(2, motion.v.z);
    set(3, motion.w.x), set(4, motion.w.y), set(5, motion.w.z);
    set(6, Lanes(0)), set(7, Lanes(0));
    twists.transpose();
    for (int i = 0; i < twists.bodies; ++i)
      if (inverse_masses[i] != 0) twists.write(i, bodies[which[i]]);
  } else {
    for (int i = 0; i < int(Lanes::size()); ++i) {
      if (inverse_masses[i] == 0) continue;
      const auto lane = static_cast<std::size_t>(i);
      Twist<Real>& body = bodies[which[i]];
      body.values[0] = motion.v.x[lane], body.values[1] = motion.v.y[lane], body.values[2] = motion.v.z[lane];
      body.values[3] = motion.w.x[lane], body.values[4] = motion.w.y[lane], body.values[5] = motion.w.z[lane];
    }
  }
}

}  // namespace
}  // namespace pushback
