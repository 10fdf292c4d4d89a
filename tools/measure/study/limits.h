/// The two errors of a method: what remains as h -> 0, which is its law's, and what smaller steps remove.
#pragma once

#include "pushback/chapters/19_accuracy_and_time/front.h"

namespace pushback::study {

/// What errors tend to as the step is halved again and again.
struct Limit {
  enum class Kind {
    unknown,    ///< fewer than three finite errors in a row at the finest steps
    reached,    ///< `least` remains
    falling,    ///< no limit is visible: less than `most` remains, the error at the finest step, or near it
    scattered,  ///< no limit is visible, and the errors do not fall: the last three lie between `least` and `most`
  };
  Kind kind = Kind::unknown;
  double least = 0, most = 0;  ///< m, between which the limit is taken to lie; the same where it is reached
  double order = 0;            ///< of what smaller steps remove, in h; 0 where errors are level or scattered

  /// "< 0.02 mm, order 1.0"
  std::string text() const;
  /// "< 0.02 mm"
  std::string remains() const;
};

/// `errors` (m) from coarse to fine, each at half the step before it, infinite where the motion was lost. Of the finest that are
/// finite, without a gap, in this order:
///
///   e = a + b h^p through the last three gives an a of 1/4 to 5/4 of the last of them,
///   and through the three that end one or two before them the same, to a tenth          reached: a
///   the last three differ by a quarter of the largest at most                           reached: their median
///   each of the last three is less than the one before it                               falling: less than the last
///   their median is less than half that of the three before them                        falling: less than the largest of them
///   else                                                                                scattered
Limit limit_of(const std::vector<double>& errors);

/// In the order in which they were measured.
std::vector<std::string> methods_of(const Measurements& all, const std::string& engine);

/// Of one method of one engine with so many sweeps. Not finite where substeps of the grid, powers of 2, are missing.
Limit limit_of(const Measurements& all, const std::string& engine, const std::string& method, int sweeps);

/// With the most sweeps that were tried with five step sizes or more, so that h goes to 0 and sweeps are as many as may be;
/// with the fewest where there is no such number.
Limit limit_of(const Measurements& all, const std::string& engine, const std::string& method);

}  // namespace pushback::study
