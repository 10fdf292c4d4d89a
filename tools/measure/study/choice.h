/// Selects settings by engine, method and maker, and formats the errors and times of the tables.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <span>

#include "pushback/common/basics/named.h"
#include "pushback/tools/measure/study/rounds.h"

namespace pushback::study {

struct Tolerance {
  double error;  ///< m
  const char* name;
};
inline constexpr Tolerance all_tolerances[] = {{1e-1, "10 cm"}, {3e-2, "3 cm"},   {1e-2, "1 cm"},
                                               {1e-3, "1 mm"},  {1e-4, "0.1 mm"}, {1e-6, "1 µm"}};
inline constexpr std::span<const Tolerance> tolerances{all_tolerances + 2, 4};

template <class Which>
Measurements those(const Measurements& all, const Which& which) {
  Measurements found;
  std::copy_if(all.begin(), all.end(), std::back_inserter(found), which);
  return found;
}
inline Measurements of_engine(const Measurements& all, const std::string& engine) {
  return those(all, [&](const Measured& one) { return one.engine == engine; });
}
inline Measurements of_method(const Measurements& all, const std::string& method) {
  return those(all, [&](const Measured& one) { return one.method == method; });
}
/// The maker of a program, or empty for programs without one, such as the methods of docs/methods.md.
inline const std::string& maker_of(const Measured& one) {
  return named("engine", known_engines(), one.engine).maker;
}
/// The measurements of one maker's engines, with robust errors.
inline Measurements of_maker(const Measurements& all, const std::string& maker) {
  return robust(those(all, [&](const Measured& one) { return maker_of(one) == maker; }));
}
/// The measurements of all other makers' engines, with robust errors.
inline Measurements of_others(const Measurements& all) {
  return robust(those(all, [](const Measured& one) { return maker_of(one) != ours && !maker_of(one).empty(); }));
}

/// A number with `digits` digits, or with all digits before the point, without an exponent.
inline std::string plain(double value, int digits = 3) {
  return value < 99.5 ? fmt::format("{:.{}g}", value, digits) : fmt::format("{:.0f}", value);
}

/// The wall time of a frame, us.
inline double per_frame(const Motion& motion, double seconds) {
  return 1e6 * seconds / motion.frames();
}

}  // namespace pushback::study
