/// Plays an experiment interactively, forwards and backwards in time, with other parameters and a hand that pulls bodies.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "pushback/common/experiment/experiment.h"
#include "pushback/common/experiment/legend.h"
#include "pushback/common/experiment/row_by_row.h"
#include "pushback/common/live/hand.h"
#include "pushback/common/live/iterated.h"
#include "pushback/common/live/lit.h"
#include "pushback/common/render/picture.h"

namespace pushback {

/// The elements that a picture shows besides bodies.
struct Shown {
  bool points = true, impulses = true, marks = true;
  Lit lit = Lit::nothing;
};

/// Plays the scenes and variants that the experiment's own program plays. All variants shown are at the same step.
class Live {
 public:
  static constexpr std::size_t most_lanes = 4;
  static constexpr std::size_t usual_bytes = std::size_t{96} << 20;

  /// `define` is called again whenever a parameter changes. `bytes`: the approximate memory for the states that are kept.
  Live(Experiment& experiment, std::function<void()> define, std::size_t bytes = usual_bytes);
  ~Live();

  // ---- description ---------------------------------------------------------------------------------------------------

  /// Scenes, their variants, series and numbers, as JSON.
  std::string description() const;
  /// As in_json: the experiment's own parameters, and the sweeps, dt and time, which every experiment has.
  std::string parameters() const;
  /// Their values by flag, as JSON. The list is empty if the scene or the variant determines the value.
  std::string values() const;

  /// Sets parameters: "--beta=0,1.4;--depth=0.1". Flags that are not named get their defaults. The scene begins again, with the same
  /// variants as far as they still exist. If the scene has none left, the first scene that has variants begins instead. Throws
  /// InvalidInput if a value cannot be used, and keeps the old values.
  void set(const std::string& assignments);
  /// Begins a scene, by index, with some of its variants, by index in the scene. Throws InvalidInput if there is no such scene, or
  /// if it has no variant with the current parameters.
  void choose(std::size_t scene, std::vector<std::size_t> variants);

  std::size_t scene() const { return scene_; }
  std::size_t tracks() const;
  /// The index of a track's variant in its scene.
  std::size_t variant(std::size_t track) const { return chosen_[track]; }

  // ---- time ----------------------------------------------------------------------------------------------------------

  std::size_t steps() const;  ///< of the scene; more if a hand grabs a body near its end
  std::size_t known() const;  ///< number of steps that have been played
  std::size_t now() const { return now_; }
  /// Goes to any step, forwards or backwards. A state that was reached before is restored to the last bit.
  void go_to(std::size_t step);

  // ---- the hand ------------------------------------------------------------------------------------------------------

  /// Grabs the movable body under (x, y) of the picture, each from -1 to 1, right and up. False if there is none. The body is held in
  /// all tracks, and the steps played after this instant are discarded.
  bool grab_at(std::size_t track, const Camera& camera, Real aspect, Real x, Real y);
  /// Moves the hand to (x, y), parallel to the image plane.
  void pull_to(const Camera& camera, Real aspect, Real x, Real y);
  void let_go();
  const std::optional<Grab>& held() const { return held_; }

  // ---- a guess --------------------------------------------------------------------------------------------------------

  /// The first movable body of the first track where it began, displaced by `way` m. It moves with the pictures of a strobe scene.
  Body displaced(const Vec3& way) const;
  /// The distance (m) from its start along the unit vector `axis` at which that body is nearest to (x, y) of the picture.
  Real way_to(const Vec3& axis, const Camera& camera, Real aspect, Real x, Real y) const;

  // ---- a problem ------------------------------------------------------------------------------------------------------

  /// Begins a problem of the experiment, by index. `set` discards it. Throws InvalidInput if there is no such problem.
  void hold(std::size_t problem);
  /// The problem that was begun last. Throws std::bad_optional_access if there is none.
  Iterated& iterated() { return iterated_.value(); }
  const Iterated& iterated() const { return iterated_.value(); }
  /// Its rows, blocks, measure and methods, as JSON.
  std::string problem() const;

  /// A step that is solved row by row, by index. Throws std::out_of_range if there is no such step.
  RowByRow rows(std::size_t step) const { return experiment_.rows_.at(step).make(); }

  // ---- results and pictures ------------------------------------------------------------------------------------------

  const World& world(std::size_t track) const;
  const std::vector<Sample>& samples(std::size_t track) const;
  /// The reason why the track ended early, or empty if it did not.
  const std::string& mishap(std::size_t track) const;
  /// One value per step played. A scene without series has one, the deepest overlap, mm.
  const std::vector<Real>& series(std::size_t track, std::size_t which) const;
  const std::vector<std::vector<int>>& raster(std::size_t track) const;
  /// One value per step of the scene.
  std::vector<Real> reference(std::size_t track, std::size_t which) const;
  /// The number for the steps up to now. Not a number before the first step, after a mishap, or if it needs later steps.
  Real number(std::size_t track, std::size_t which) const;
  /// "0.31 m/s", and the expected value or an empty text.
  std::pair<std::string, std::string> number_in_words(std::size_t track, std::size_t which) const;

  /// The centre and the radius, m, of a ball around the movable bodies at the start and the ground below them. The centre moves
  /// horizontally by the mean displacement of the bodies since then.
  std::pair<Vec3, Real> reach() const;
  /// The displacement of the bodies in the picture, m. In a strobe scene they cross the picture and leave an image at each instant.
  Vec3 shift() const;
  Picture picture(std::size_t track, const Camera& camera, const Shown& shown) const;

 private:
  class Track;

  const ParameterWithDefault& parameter(const std::string& flag) const;
  std::vector<const Variant*> variants_of(std::size_t scene) const;
  void begin();
  Ray ray(const Camera& camera, Real aspect, Real x, Real y) const;

  Experiment& experiment_;
  std::function<void()> define_;
  std::size_t bytes_;
  std::vector<ParameterWithDefault> parameters_;
  std::size_t scene_ = 0, now_ = 0;
  std::size_t until_ = 0;  ///< minimum number of steps that can be played
  std::vector<std::size_t> chosen_{0, 1, 2, 3};
  std::vector<Track> tracks_;
  std::vector<std::optional<Grab>> hand_;  ///< in each step that has been played
  std::optional<Grab> held_;
  std::optional<Iterated> iterated_;
};

}  // namespace pushback
