/// Helpers that cases share: cameras, allowances of energy and overlap, and measurements of a standing pile.
#pragma once

#include "pushback/tools/measure/hard_cases/hard_case.h"

namespace pushback {

inline constexpr Real slop = Real(0.005);    ///< m, of chapter 04: what lies deeper is "beyond"
inline constexpr Real frame = Real(1) / 60;  ///< s, the step of every case that does not say another

/// Sees what is `size` m across and high round `centre`, from the front, a little from the right and above.
Camera view(const Vec3& centre, Real size);
/// `seconds`: when its picture is taken.
Scene seen(std::function<void(World&)> fill, const Camera& camera, Real seconds);

/// The energy that standing bodies may gain: the work of lifting all of them by a millimetre.
Allowance standing(const World& world);
/// The same, with this height in m.
AllowanceOf lifting(Real height);
/// The same, and falling bodies may overlap by this much, m, when they strike.
AllowanceOf striking(Real overlap);
/// Nothing may be gained; a thousandth is for bounces that sweeps leave not quite solved. What is allowed besides: `other`.
AllowanceOf bouncing(const Allowance& other = {});

/// Measurements of a standing pile.
struct Stood {
  Real drift = 0;    ///< m, sideways, of the body that moved most
  Real moved = 0;    ///< m, in any direction, of the body that moved most
  Real beyond = 0;   ///< m deeper than the slop, the deepest of all steps
  Real jitter = 0;   ///< m/s, the fastest centre of mass in the last second
  Real kinetic = 0;  ///< J, the most in the last second
  Real gained = 0;   ///< J, above the start, the most
};

/// Moves on by `seconds`, at least 1, in steps of dt.
Stood stand(Play& play, Real seconds, Real dt = frame);

/// Which of these numbers has which limit: in thousandths where the unit is one of mm, mm/s and mJ, or in J.
struct Asked {
  Criterion criterion;
  Real Stood::* number;
};
inline Asked drift_up_to(Real limit) {
  return {{"drift after 10 s", "mm", limit}, &Stood::drift};
}
inline Asked displaced_up_to(Real limit) {
  return {{"largest displacement after 10 s", "mm", limit}, &Stood::moved};
}
inline Asked beyond_the_slop(Real limit = 1) {
  return {{"deeper than the slop", "mm", limit}, &Stood::beyond};
}
inline Asked at_rest() {
  return {{"speed in the last second", "mm/s", 1}, &Stood::jitter};
}

/// `what`, with these criteria, of how it stands.
HardCase must_stand(HardCase what, const std::vector<Asked>& asked, const std::function<Stood(Trial&)>& how);
/// Its scene is to stand for so long, in steps of dt.
HardCase must_stand(HardCase what, const std::vector<Asked>& asked, Real seconds = 10, Real dt = frame);

/// What falls in its scene comes to rest within ten seconds, and may strike as deep as `overlap` m.
HardCase must_settle(HardCase what, Real overlap);

/// A stack of three that falls a little, and past it slides a box 0.4 m high, its centre `height` m up.
void falling_and_sliding(World& world, Real height);

/// mm: both move on by five seconds; how far a body is at most from where the other world has it, but for `shift`.
Real farthest_apart(Play& one, Play& other, const Vec3& shift = Vec3::Zero());

/// m, of points that a joint holds on each other: how far apart they are.
Real gap_of(const World& world, const Joint& joint);

}  // namespace pushback
