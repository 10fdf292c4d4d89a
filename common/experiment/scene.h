/// A scene: its bodies, its camera, and the contents of its sheet.
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

/// One wide picture of many instants. It shows the movable bodies at each instant with their joints, contacts and arrows, displaced
/// by shift_per_second * (t - from).
struct Strobe {
  Real every;             ///< s
  Vec3 shift_per_second;  ///< m/s
  Real from = 0;          ///< s
  int height = 300;       ///< pixels, for a picture 1520 wide
  Real until = 0;         ///< s; 0: to the end of the scene
  /// Adds further marks at each instant, displaced like the bodies.
  std::function<void(Picture&, const World&)> marks = {};
  std::string note = {};  ///< the text below it; empty: the times of the instants
};

/// A strip of coloured cells, one column per step.
struct Raster {
  std::string label;  ///< name of a row of cells: "contact point"
  /// The cells in the column of a world, from the top. Each is an index into `meaning`, or -1 for an empty cell.
  std::function<std::vector<int>(const World&)> of;
  std::vector<std::pair<Ink, std::string>> meaning;
};

/// A text in a picture, which begins just above a point.
struct Label {
  Vec3 at;  ///< m, world axes
  std::string text;
};

/// How a picture shows contacts.
enum class Drawn { nothing, points, impulses };

/// Pictures that a page shows before its sheet, without the names of the variants. The reader guesses which is which.
struct Guess {
  std::vector<std::size_t> among;  ///< indices of the variants whose last pictures are shown
  bool start = false;              ///< whether to add the start that all of them share; not in a strobe picture
};

struct Scene {
  std::string name;                  ///< a few words
  std::function<void(World&)> fill;  ///< puts the bodies into an empty world
  Camera camera = {};
  Real seconds = 2;  ///< s, simulated time
  std::vector<Real> instants =
      {};                ///< s, the columns of the sheet: the last three after the start; empty: at one third,
                         ///< at two thirds and at the end. One instant: the variants stand side by side
  bool pictures = true;  ///< false: only numbers and curves, for variants that look alike
  Drawn contacts = Drawn::impulses;
  Real arrow = 0;                                         ///< m, length for an impulse of 1 N s; 0: from fitting_arrow
  std::string key = "";                                   ///< of the sheet's file, sheet_KEY.png; empty: from the name
  std::string caption = "";                               ///< one sentence on the sheet: what to look for
  std::vector<std::pair<Ink, std::string>> colours = {};  ///< the meaning of colours that only this scene uses
  bool start_shown = true;  ///< whether the sheet shows the start, which all variants share
  /// Factor on the drawn displacements and rotations since the start. If it is not 1, the pictures get a scale bar.
  Real magnified = 1;
  /// Adds further marks to each picture (see marks.h), such as expected positions as thin lines, or arrows. It gets the world as it is
  /// drawn, including `magnified`. It marks a strobe picture once, with the world of its last instant. `time`: s.
  std::function<void(Picture&, const World&, Real time)> marks = {};
  std::vector<Label> labels = {};     ///< in all pictures of the sheet, also in the reader's guess
  std::optional<Strobe> strobe = {};  ///< replaces the columns
  std::optional<Raster> raster = {};  ///< below each row, or to the right of its picture if there is only one
  int cell_height = 0;                ///< pixels, for a cell 500 wide; 0: in the proportions of --size, by default 281
  bool open = true;                   ///< whether a reader's own solver plays it, too; false if no contacts are solved
  /// Indices of the two variants that the table of contents shows, by default the first and the last.
  std::optional<std::pair<std::size_t, std::size_t>> in_brief = {};
  std::optional<Guess> guess = {};  ///< guess_1.png, ...; only for the first scene that has pictures
};

}  // namespace pushback
