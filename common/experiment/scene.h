/// What is looked at: what is in it, from where one looks, and what its sheet shows.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "pushback/common/render/canvas.h"
#include "pushback/common/render/picture.h"
#include "pushback/common/world/world.h"

namespace pushback {

/// One wide picture of many instants: the movable bodies at each of them, with their joints, contacts and arrows, moved by
/// shift_per_second * (t - from).
struct Strobe {
  Real every;             ///< s
  Vec3 shift_per_second;  ///< m/s
  Real from = 0;          ///< s
  int height = 300;       ///< pixels, of a picture 1520 wide
  Real until = 0;         ///< s; 0: to the end of the scene
  /// What else stands with the bodies at each instant, moved as they are.
  std::function<void(Picture&, const World&)> marks = {};
  std::string note = {};  ///< what is said under it; empty: when the instants are
};

/// A strip of coloured cells, a column of them per step.
struct Raster {
  std::string label;  ///< what a row of cells is: "contact point"
  /// The column of a world, from the top: each an index into `meaning`, or -1 for nothing.
  std::function<std::vector<int>(const World&)> of;
  std::vector<std::pair<Ink, std::string>> meaning;
};

/// What a picture shows of the contacts.
enum class Drawn { nothing, points, impulses };

/// Pictures that a page shows before its sheet, without saying whose they are: which is which?
struct Guess {
  std::vector<std::size_t> among;  ///< the last pictures of these variants, by their places
  bool start = false;              ///< and what all of them begin with; not in a strobe picture
};

struct Scene {
  std::string name;                  ///< a few words
  std::function<void(World&)> fill;  ///< puts the bodies into an empty world
  Camera camera = {};
  Real seconds = 2;  ///< how long it is watched
  std::vector<Real> instants =
      {};                ///< s, the columns of the sheet: of those after the start, the last three; empty: at
                         ///< one third, at two thirds and at the end. One: the variants stand beside each other
  bool pictures = true;  ///< false: only numbers and curves, for what an eye could not tell apart
  Drawn contacts = Drawn::impulses;
  Real arrow = 0;        ///< m to draw for an impulse of 1 N s; 0: as long as a body for what holds it against gravity
  std::string key = "";  ///< of the sheet's file, sheet_KEY.png; empty: from the name
  std::string caption = "";                               ///< what to look for, one sentence, on the sheet
  std::vector<std::pair<Ink, std::string>> colours = {};  ///< what colours mean in this scene alone
  bool start_shown = true;  ///< whether the sheet's head shows the start, which all variants share
  Real magnified = 1;       ///< how many times as large as they are displacements and turns from the start are drawn
  /// What else stands in each picture, see marks.h: what should be, as thin lines; arrows. The world is as it is drawn,
  /// magnified where the scene says so. A strobe picture is marked once, with the world of its last instant.
  std::function<void(Picture&, const World&, Real time)> marks = {};
  std::optional<Strobe> strobe = {};  ///< instead of the columns
  std::optional<Raster> raster = {};  ///< under each row, or beside its picture where there is one only
  int cell_height = 0;                ///< pixels, of a cell 500 wide; 0: as --size has it, which is 281
  bool open = true;  ///< whether a reader's own solver plays it, too: false where no contacts are solved
  /// The two that stand for all in the table of contents, by their places; by default the first and the last.
  std::optional<std::pair<std::size_t, std::size_t>> in_brief = {};
  std::optional<Guess> guess = {};  ///< guess_1.png and on, of the first scene that has pictures
};

}  // namespace pushback
