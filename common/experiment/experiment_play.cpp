/// Plays one variant to its end.
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

#include "pushback/common/basics/input.h"
#include "pushback/common/experiment/experiment_parts.h"
#include "pushback/common/experiment/played.h"
#include "pushback/common/experiment/sheet.h"

namespace pushback {

namespace fs = std::filesystem;

Experiment::Output::Output(fs::path folder, bool images, Size frame, std::size_t variants)
    : folder_(std::move(folder)),
      images_(images),
      terminal_(isatty(fileno(stdout)) == 1),
      frame_(std::move(frame)),
      variants_(variants) {}

Experiment::Output::Size Experiment::Output::cell(int height) const {
  const int width = std::min(frame_.first, cell_width);
  return {width, std::max(1, height > 0 ? width * height / cell_width : width * frame_.second / frame_.first)};
}

Experiment::Output::Size Experiment::Output::strip(int height) const {
  const int width = cell().first;
  return {width * strip_width / cell_width, std::max(1, width * height / cell_width)};
}

Painter& Experiment::Output::painter(Size size) {
  std::unique_ptr<Painter>& one = painters_[size];
  if (one == nullptr) one = std::make_unique<Painter>(size.first, size.second);
  return *one;
}

void Experiment::Output::progress(const std::string& name, std::size_t index, const std::string& variant,
                                  std::size_t frame, std::size_t frames) {
  const double spent = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_).count();
  const double done = (static_cast<double>(index) +
                       static_cast<double>(frame) / static_cast<double>(std::max<std::size_t>(frames, 1))) /
                      static_cast<double>(variants_);
  if (terminal_) {
    const std::string left = done > 0.02 ? fmt::format(", {:.0f} s left", spent / done - spent) : "";
    fmt::print("\r\033[K{}  {}/{}  {}  frame {}/{}{}", name, index + 1, variants_, variant, frame, frames, left);
    std::fflush(stdout);
  } else if (frame == 0) {
    fmt::print("{}: {} of {}, {}\n", name, index + 1, variants_, variant);
    std::fflush(stdout);
  }
}

void Experiment::Output::done() const {
  if (terminal_) fmt::print("\r\033[K");
}

Experiment::Result Experiment::play(std::size_t index, Output& output) const {
  const Variant& variant = variants_[index];
  const SceneRecord& record = scene_records_[variant.scene];
  const std::size_t steps = steps_of(record.scene);

  Played played(*this, variant);
  Result result;
  result.variant = &variant;
  output.progress(name_, index, variant.name, 0, static_cast<std::size_t>(frames_));
  Shots shots(*this, index, played.world, output, result);
  for (std::size_t step = 1; step <= steps; ++step) {
    try {
      result.samples.push_back(played.step());
    } catch (const InvalidInput& problem) {
      result.mishap =
          fmt::format("ended at {:.3g} s: {}", static_cast<double>(step) * static_cast<double>(dt_), problem.what());
      break;
    }
    for (const Quantity& quantity : record.series) result.series[quantity.name].push_back(quantity.of(played.world));
    shots.take(played.world, step);
  }
  shots.end();
  const Run run{played.world, dt_, result.samples, result.series};
  for (const Number& number : record.numbers)
    result.numbers.push_back(result.mishap.empty() ? number.of(run) : std::numeric_limits<Real>::quiet_NaN());
  return result;
}

}  // namespace pushback
