/// What the parts of an experiment hand to each other. Only common/experiment*.cpp need it.
#pragma once

#include <chrono>
#include <filesystem>
#include <memory>
#include <optional>
#include <set>
#include <utility>

#include "pushback/common/experiment/experiment.h"
#include "pushback/common/experiment/legend.h"
#include "pushback/common/experiment/words.h"
#include "pushback/common/render/painter.h"

namespace pushback {

struct Experiment::Result {
  const Variant* variant = nullptr;
  std::vector<Sample> samples;
  std::map<std::string, std::vector<Real>> series;
  std::vector<Real> numbers;
  std::optional<Image> start;  ///< of the scene, with its first variant
  std::vector<Image> cells;    ///< or the one wide picture
  std::vector<std::string> cell_notes;
  std::vector<std::vector<int>> raster;  ///< a column per step
  Legend legend;                         ///< of the pictures
  std::string mishap;                    ///< why it was not watched to the end; empty where it was
};

/// Where pictures and progress go.
class Experiment::Output {
 public:
  using Size = std::pair<int, int>;  ///< pixels, width and height

  Output(std::filesystem::path folder, bool images, Size frame, std::size_t variants);

  const std::filesystem::path& folder() const { return folder_; }
  bool images() const { return images_; }
  Size frame() const { return frame_; }
  /// A cell of the sheet: as wide as the sheet has it or, for a quick look, as a smaller frame is. `height`: for one that is
  /// cell_width wide; 0: in the frame's proportions.
  Size cell(int height = 0) const;
  /// A picture as wide as the sheet's content, drawn as coarsely as the cells are.
  Size strip(int height) const;
  Painter& painter(Size size);
  void progress(const std::string& name, std::size_t index, const std::string& variant, std::size_t frame,
                std::size_t frames);
  void done() const;

 private:
  std::filesystem::path folder_;
  bool images_, terminal_;
  Size frame_;
  std::size_t variants_;
  std::map<Size, std::unique_ptr<Painter>> painters_;
  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
};

/// Takes the pictures of one variant, step by step.
class Experiment::Shots {
 public:
  Shots(const Experiment& of, std::size_t index, const World& start, Output& output, Result& result);

  /// Once a step.
  void take(const World& world, std::size_t step);
  /// After the last.
  void end();

 private:
  std::size_t step_at(Real time) const;
  World as_drawn(const World& world) const;
  Picture picture(const World& world, std::size_t step) const;
  Image still(const Picture& of, Output::Size size);
  std::string how_magnified() const;

  const Experiment& experiment_;
  const Variant& variant_;
  const Scene& scene_;
  std::size_t index_;
  World start_;
  Output& output_;
  Result& result_;
  std::optional<Real> arrow_;     ///< m for 1 N s, 0: points alone; none: no contacts
  std::filesystem::path folder_;  ///< of the frames
  std::set<std::size_t> cells_;
  std::multiset<std::size_t> frames_;  ///< a step that lasts longer than a frame of a film has several
  std::size_t frames_drawn_ = 0;
  std::optional<Picture> strobe_;
  World marked_;  ///< of the strobe picture's last instant
  Real marked_at_ = 0;
};

}  // namespace pushback
