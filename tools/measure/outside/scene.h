/// Scenes that others made, taken as data with their source, and large ones that move. The list in scenes/scenes.json says what must
/// come of each. It was written down before any solver played them.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "pushback/common/world/world.h"

namespace pushback::outside {

/// Called after each step, with the contacts that our collision detection finds then. Returns the number by which the scene is
/// judged, as of now.
using Look = std::function<Real(const World&)>;

/// A constant force, N, on the centre of mass, and the acceleration that comes of it, m/s^2, where it has a closed form.
struct Push {
  int body;
  Vec3 force, acceleration;
};

/// A line of the list.
struct OutsideScene {
  std::string name;   ///< as typed; the scene itself is in scenes/NAME.json, or among large_scenes
  std::string title;  ///< as read
  std::string source;
  std::string judge;  ///< one of the judges: "is displaced"
  std::string must;   ///< its number in words: "largest sideways displacement"
  std::string unit;
  Real limit;           ///< of that number
  Real seconds;         ///< simulated, in steps of 1/60 s
  Real after;           ///< s: from then on the judge looks
  Real half_thickness;  ///< m, of the thinnest body that moves
  Real gain;            ///< how much energy may be gained, as a fraction of the energy that is turned over
  std::vector<Push> pushes;
};

const std::vector<OutsideScene>& outside_scenes();
/// Throws InvalidInput, naming those that there are.
const OutsideScene& scene_named(const std::string& name);

/// The scene as it begins, with its pushes.
World begin(const OutsideScene& scene);

/// Judges by its judge and from its time on.
Look look_at(const OutsideScene& scene, const World& start);

/// The text of a file in scenes/.
std::string scene_text(const std::string& name);

/// A scene that is made by a program.
struct LargeScene {
  std::string name;
  std::function<void(World&)> fill;
  std::function<void(World&, const World& start, Real dt)> drive = {};  ///< called before each step
  Real drum = 0;    ///< rad/s about the axis z: all immovable bodies that are touched turn so
  Look slope = {};  ///< degrees: the slope of the pile
};
const std::vector<LargeScene>& large_scenes();
/// That of this name; none: nullptr.
const LargeScene* large_scene(const std::string& name);

}  // namespace pushback::outside
