/// Splits the error of a method into the error that remains as h -> 0, which is the error of its contact law, and the error that smaller
/// steps remove.
#pragma once

#include "pushback/chapters/19_accuracy_and_time/front.h"

namespace pushback::study {

/// The limit of the errors as the step is halved repeatedly.
struct Limit {
  enum class Kind {
    unknown,    ///< fewer than three finite errors in a row at the finest steps
    reached,    ///< `least` remains
    falling,    ///< no limit is visible; less than `most` remains, the error at or near the finest step
    scattered,  ///< no limit is visible and errors do not fall; the last three are between `least` and `most`
  };
  Kind kind = Kind::unknown;
  double least = 0, most = 0;  ///< m, the assumed bounds of the limit; equal if it is reached
  double order = 0;  ///< order in h of the error that smaller steps remove; 0 if errors are level or scattered

  /// "< 0.02 mm, order 1.0"
  std::string text() const;
  /// "< 0.02 mm"
  std::string remains() const;
};

/// `errors` (m) are ordered from coarse to fine, each at half the previous step, infinite if the motion was lost. The rules apply to the
/// finest consecutive finite errors, in this order:
///
///   e = a + b h^p through the last three gives an a of 1/4 to 5/4 of the last error,
///   and the same a to a tenth through three that end one or two earlier                  reached: a
///   the last three differ by at most a quarter of the largest                            reached: their median
///   each of the last three is less than its predecessor                                  falling: less than the last
///   their median is less than half the median of the three before                        falling: less than the largest of them
///   otherwise                                                                            scattered
Limit limit_of(const std::vector<double>& errors);

/// The methods of an engine, in the order in which they were measured.
std::vector<std::string> methods_of(const Measurements& all, const std::string& engine);

/// The limit of one method of one engine with this number of sweeps. Missing numbers of substeps, which are powers of 2, count as
/// infinite errors.
Limit limit_of(const Measurements& all, const std::string& engine, const std::string& method, int sweeps);

/// The same with the largest number of sweeps that was tried with at least five step sizes, so that h goes to 0 with as many sweeps as
/// possible, or with the smallest number if there is none.
Limit limit_of(const Measurements& all, const std::string& engine, const std::string& method);

}  // namespace pushback::study
