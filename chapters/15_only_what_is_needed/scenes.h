/// Every scene that a chapter looks at, and those of this one.
#pragma once

#include "chapters/00_naive_impulses/scenes.h"
#include "chapters/01_velocity_constraint/scenes.h"
#include "chapters/02_clamping/scenes.h"
#include "chapters/03_baumgarte/scenes.h"
#include "chapters/04_slop/scenes.h"
#include "chapters/05_restitution/scenes.h"
#include "chapters/06_friction/scenes.h"
#include "chapters/08_friction_cone/scenes.h"
#include "chapters/12_small_steps/scenes.h"

namespace pushback {

struct NamedScene {
  std::string name;                  ///< the chapter's number, a hyphen, a word or two: as typed on a command line
  std::function<void(World&)> fill;  ///< puts the bodies into an empty world
};

/// Each scene once, under the chapter that looks at it first. Parameters are those that its experiment has by default:
/// steps of 1/60 s among them.
inline std::vector<NamedScene> all_scenes() {
  constexpr Real h = Real(1) / 60;
  const auto boxes = [](int count) { return [count](World& world) { stack(world, count); }; };
  return {
      {"00-one-hit", sparse_hit},
      {"00-one-box", boxes(1)},
      {"00-five-boxes", boxes(5)},
      {"01-dropped", dropped_box},
      {"01-leaving", leaving_box},
      {"01-slope", cube_on_slope},
      {"02-landing", landing_column},
      {"02-three-columns", three_columns},
      {"03-sunken", sunken_box},
      {"03-weightless", sunken_box_without_gravity},
      {"03-three-boxes", boxes(3)},
      {"04-small-pile", small_pile},
      {"05-four-balls", four_balls},
      {"05-at-rest", at_rest},
      {"05-with-gaps", five_in_a_row(Real(0.08))},
      {"05-touching", five_in_a_row(0)},
      {"06-slope", slope},
      {"06-slide", [](World& world) { slide_to_posts(world, three_headings, h); }},
      {"06-thrown-ball", thrown_ball},
      {"07-ten-boxes", boxes(10)},
      {"07-pyramid", [](World& world) { pyramid(world, 10); }},
      {"08-wheel", [](World& world) { wheel(world, longest_half, h); }},
      {"12-twenty-boxes", stack_of_twenty},
      {"12-heavy", heavy_on_light},
      {"12-forty-boxes", boxes(40)},
      {"12-sunken-ball", sunken_ball},
  };
}

}  // namespace pushback
