/// Helpers that cases share: cameras, allowances of energy and overlap, and measurements of a standing pile.
#pragma once

#include "pushback/tools/measure/hard_cases/hard_case.h"

namespace pushback {

inline constexpr Real slop = Real(0.005);    ///< m, of chapter 04; a larger depth counts as "beyond"
inline constexpr Real frame = Real(1) / 60;  ///< s, the default step of a case

/// A camera that shows `size` m of width and height around `centre`, from the front, slightly from the right and above.
Camera view(const Vec3& centre, Real size);
/// A scene with this camera. `seconds`: the time of its picture, s.
Scene seen(std::function<void(World&)> fill, const Camera& camera, Real seconds);

/// An allowance for standing bodies. They may gain the energy that would lift all of them by 1 mm.
Allowance standing(const World& world);
/// The same with this height, m.
AllowanceOf lifting(Real height);
/// The same, and falling bodies may overlap by this depth (m) when they strike.
AllowanceOf striking(Real overlap);
/// Allows no gain of energy, except for a thousandth, because sweeps do not solve bounces exactly. `other`: the other limits.
AllowanceOf bouncing(const Allowance& other = {});

/// Measurements of a standing pile.
struct Stood {
  Real drift = 0;    ///< m, the largest horizontal displacement of a body
  Real moved = 0;    ///< m, the largest displacement of a body in any direction
  Real beyond = 0;   ///< m, the largest overlap of all steps beyond the slop
  Real jitter = 0;   ///< m/s, the largest speed of a centre of mass in the last second
  Real kinetic = 0;  ///< J, the largest value in the last second
  Real gained = 0;   ///< J, the largest gain over the start
};

/// Advances by `seconds`, at least 1, in steps of dt.
Stood stand(Play& play, Real seconds, Real dt = frame);

/// A member of Stood and its limit, in mm, mm/s, mJ or J.
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

/// `what` with these criteria for the result of `how`.
HardCase must_stand(HardCase what, const std::vector<Asked>& asked, const std::function<Stood(Trial&)>& how);
/// The same for a scene that is to stand for `seconds`, in steps of dt.
HardCase must_stand(HardCase what, const std::vector<Asked>& asked, Real seconds = 10, Real dt = frame);

/// A case whose falling bodies must come to rest within ten seconds, and may overlap by `overlap` m when they strike.
HardCase must_settle(HardCase what, Real overlap);

/// A stack of three that falls a little, and a box 0.4 m high that slides past it, with its centre at `height` m.
void falling_and_sliding(World& world, Real height);

/// Advances both worlds by five seconds. Returns the largest distance between the same body in both, apart from `shift`, mm.
Real farthest_apart(Play& one, Play& other, const Vec3& shift = Vec3::Zero());

/// The distance between the two points that a joint should hold together, m.
Real gap_of(const World& world, const Joint& joint);

}  // namespace pushback
