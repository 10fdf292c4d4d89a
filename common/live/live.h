/// An experiment that is played where somebody looks on: to and fro in time, with other parameters, by hand.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "pushback/common/experiment/experiment.h"
#include "pushback/common/experiment/legend.h"
#include "pushback/common/live/hand.h"
#include "pushback/common/live/iterated.h"
#include "pushback/common/render/picture.h"

namespace pushback {

/// What a picture has besides bodies.
struct Shown {
  bool points = true, impulses = true, marks = true;
};

/// Plays the description that the experiment's own program plays. All variants that are shown move in step.
class Live {
 public:
  static constexpr std::size_t most_lanes = 4;
  static constexpr std::size_t usual_bytes = std::size_t{96} << 20;

  /// `define` is called again whenever a parameter changes. `bytes`: what the states that are kept may take, about.
  Live(Experiment& experiment, std::function<void()> define, std::size_t bytes = usual_bytes);
  ~Live();

  // ---- what there is -------------------------------------------------------------------------------------------------

  /// Scenes, their variants, series and numbers, as JSON.
  std::string description() const;
  /// As in_json: the experiment's own parameters, and of those of every experiment the sweeps, dt and the time.
  std::string parameters() const;
  /// Their values, by flag; of those that follow the scene or the variant none.
  std::string values() const;

  /// "--beta=0,1.4;--depth=0.1": a flag that is not named has its default. Throws InvalidInput where a value cannot be used;
  /// then nothing has changed. Otherwise the scene begins again, with the same variants as far as there are so many.
  void set(const std::string& assignments);
  /// By their places: of the scene, and of its variants in it. Begins the scene.
  void choose(std::size_t scene, std::vector<std::size_t> variants);

  std::size_t scene() const { return scene_; }
  std::size_t lanes() const;
  /// The place of a lane's variant in its scene.
  std::size_t variant(std::size_t lane) const { return chosen_[lane]; }

  // ---- time ----------------------------------------------------------------------------------------------------------

  std::size_t steps() const;  ///< of the scene; longer where a hand takes hold towards its end
  std::size_t known() const;  ///< so many have been played
  std::size_t now() const { return now_; }
  /// To any step, in both directions. A state that was there before comes again to the last bit.
  void go_to(std::size_t step);

  // ---- the hand ------------------------------------------------------------------------------------------------------

  /// Whether there is something to hold under (x, y) of the picture, each from -1 to 1, right and up. It is held in all lanes. What
  /// was played after this instant is forgotten.
  bool grab_at(std::size_t lane, const Camera& camera, Real aspect, Real x, Real y);
  /// The hand moves across the picture that it grabbed in.
  void pull_to(const Camera& camera, Real aspect, Real x, Real y);
  void let_go();
  const std::optional<Grab>& held() const { return held_; }

  // ---- a problem ------------------------------------------------------------------------------------------------------

  /// Begins a problem of the experiment, by its place. It goes with what a parameter changes.
  void hold(std::size_t problem);
  /// The one that was begun last. Throws std::bad_optional_access where there is none.
  Iterated& iterated() { return iterated_.value(); }
  const Iterated& iterated() const { return iterated_.value(); }
  /// Its rows, blocks, measure and methods, as JSON.
  std::string problem() const;

  // ---- what is to be seen --------------------------------------------------------------------------------------------

  const World& world(std::size_t lane) const;
  const std::vector<Sample>& samples(std::size_t lane) const;
  /// Why it was not played further; empty where it was.
  const std::string& mishap(std::size_t lane) const;
  /// One value a step, as far as it is known. By default, of a scene without any, the deepest overlap, mm.
  const std::vector<Real>& series(std::size_t lane, std::size_t which) const;
  const std::vector<std::vector<int>>& raster(std::size_t lane) const;
  /// A value a step of the scene.
  std::vector<Real> reference(std::size_t lane, std::size_t which) const;
  /// As it is now, of what has been played up to now. Not a number before the first step.
  Real number(std::size_t lane, std::size_t which) const;
  /// "0.31 m/s", and what it should be, or an empty text.
  std::pair<std::string, std::string> number_in_words(std::size_t lane, std::size_t which) const;

  /// A ball around the bodies that move, as they begin, and the ground below them, gone along over the ground with them: its centre
  /// and its radius, m.
  std::pair<Vec3, Real> reach() const;
  /// How far bodies are moved in it, m: those of a strobe scene go across the picture, and leave an image at each instant.
  Vec3 shift() const;
  Picture picture(std::size_t lane, const Camera& camera, const Shown& shown) const;

 private:
  class Lane;

  const ParameterWithDefault& parameter(const std::string& flag) const;
  void begin();
  Ray ray(const Camera& camera, Real aspect, Real x, Real y) const;

  Experiment& experiment_;
  std::function<void()> define_;
  std::size_t bytes_;
  std::vector<ParameterWithDefault> parameters_;
  std::size_t scene_ = 0, now_ = 0;
  std::size_t until_ = 0;  ///< at least so many steps can be played
  std::vector<std::size_t> chosen_{0, 1, 2, 3};
  std::vector<Lane> lanes_;
  std::vector<std::optional<Grab>> hand_;  ///< in each step that is known
  std::optional<Grab> held_;
  std::optional<Iterated> iterated_;
};

}  // namespace pushback
