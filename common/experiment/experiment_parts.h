/// Classes shared by the sources of Experiment. Only common/experiment/experiment_*.cpp need them.
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
  std::optional<Image> start;  ///< the scene at t = 0; only with its first variant
  std::vector<Image> cells;    ///< or the single wide picture
  std::vector<std::string> cell_notes;
  std::vector<std::vector<int>> raster;  ///< a column per step
  Legend legend;                         ///< of the pictures
  std::string mishap;                    ///< why the run ended early; empty if it did not
};

/// The folder and the painters for pictures, and the display of progress.
class Experiment::Output {
 public:
  using Size = std::pair<int, int>;  ///< pixels, width and height

  Output(std::filesystem::path folder, bool images, Size frame, std::size_t variants);

  const std::filesystem::path& folder() const { return folder_; }
  bool images() const { return images_; }
  Size frame() const { return frame_; }
  /// The size of a sheet's cell: cell_width wide, or as wide as the frame if that is smaller. `height`: pixels for a cell that is
  /// cell_width wide; 0: in the frame's proportions.
  Size cell(int height = 0) const;
  /// The size of a picture as wide as the sheet's content, at the resolution of the cells. `height`: pixels for a width of strip_width.
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

/// Draws the pictures of one variant, step by step.
class Experiment::Shots {
 public:
  Shots(const Experiment& of, std::size_t index, const World& start, Output& output, Result& result);

  /// Call it once per step.
  void take(const World& world, std::size_t step);
  /// Call it after the last step.
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
  std::optional<Real> arrow_;     ///< m for 1 N s; 0: only points; none: no contacts
  std::filesystem::path folder_;  ///< of the frames
  std::set<std::size_t> cells_;
  std::multiset<std::size_t> frames_;  ///< a step longer than a film's frame occurs several times
  std::size_t frames_drawn_ = 0;
  std::optional<Picture> strobe_;
  World marked_;  ///< of the strobe picture's last instant
  Real marked_at_ = 0;
};

}  // namespace pushback
