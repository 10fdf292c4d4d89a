/// What is to stand: how long, and by which numbers one sees that it did.
#pragma once

#include "pushback/tools/measure/hard_cases/hard_case.h"

namespace pushback {

inline constexpr Real slop = Real(0.005);    ///< m, of chapter 04: what lies deeper is "beyond"
inline constexpr Real frame = Real(1) / 60;  ///< s, the step of every case that does not say another

/// What is read off while a pile stands.
struct Stood {
  Real drift = 0;    ///< m, sideways, of the body that moved most
  Real moved = 0;    ///< m, in any direction, of the body that moved most
  Real beyond = 0;   ///< m deeper than the slop, the deepest of all steps
  Real jitter = 0;   ///< m/s, the fastest centre of mass in the last second
  Real kinetic = 0;  ///< J, the most in the last second
};

/// Moves on by `seconds`, at least 1, in steps of dt.
Stood stand(Play& play, Real seconds, Real dt = frame);

/// What may be gained where bodies stand: the work of lifting all of them by a millimetre.
Allowance standing(const World& world);

/// A case in which everything stands for ten seconds: drift in mm, deeper than the slop in mm, speed in mm/s.
struct StandingCase {
  std::string name, title, stresses;
  std::function<void(World&)> fill;
  Camera camera;
  Real drift_limit = 1;   ///< mm, sideways
  Real moved_limit = 0;   ///< mm, in any direction; 0: the drift counts, above 0: this in its place
  Real beyond_limit = 1;  ///< mm
};
HardCase must_stand(const StandingCase& what);

/// A case in which what falls comes to rest within ten seconds: speed in mm/s, overlap in mm, the slop and 1 mm.
struct SettlingCase {
  std::string name, title, stresses;
  std::function<void(World&)> fill;
  Camera camera;
  Real seconds;  ///< when its picture is taken
  Real overlap;  ///< m, as deep as it may strike
};
HardCase must_settle(const SettlingCase& what);

/// A stack of three that falls a little, and past it slides a box 0.4 m high, its centre `height` m up.
void falling_and_sliding(World& world, Real height);

/// Sees what is `size` m across and high round `centre`, from the front, a little from the right and above.
Camera view(const Vec3& centre, Real size);

}  // namespace pushback
