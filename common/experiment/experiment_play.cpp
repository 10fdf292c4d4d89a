/// Watching one variant: its steps, its samples, its pictures.
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <iterator>
#include <limits>

#include "pushback/common/basics/input.h"
#include "pushback/common/experiment/experiment_parts.h"
#include "pushback/common/experiment/picture_of.h"
#include "pushback/common/render/canvas.h"

namespace pushback {

namespace fs = std::filesystem;

Experiment::Output::Output(fs::path folder, bool images, int width, int height, std::size_t variants)
    : folder_(std::move(folder)), terminal_(isatty(fileno(stdout)) == 1), variants_(variants) {
  if (images) painter_.emplace(width, height);
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

namespace {

std::vector<ContactId> ids_of(const Contacts& contacts) {
  std::vector<ContactId> ids;
  for (const Contact& contact : contacts) ids.push_back(contact.id);
  return ids;
}

int count_missing(const std::vector<ContactId>& from, const std::vector<ContactId>& in) {
  std::vector<ContactId> missing;
  std::set_difference(from.begin(), from.end(), in.begin(), in.end(), std::back_inserter(missing));
  return static_cast<int>(missing.size());
}

}  // namespace

std::size_t Experiment::steps_of(const Scene& scene) const {
  const Real seconds = seconds_ > 0 ? seconds_ : scene.seconds;
  return std::max<std::size_t>(1, static_cast<std::size_t>(std::lround(seconds / dt_)));
}

Experiment::Result Experiment::play(const Variant& variant, std::size_t index, Output& output) const {
  const Act& act = acts_[variant.scene];
  const Scene& scene = act.scene;
  const std::size_t steps = steps_of(scene);
  const Real seconds = static_cast<Real>(steps) * dt_;

  World world;
  fill(world, variant);
  // The impulses that a picture shows are those of the latest substep.
  const Real arrow = static_cast<Real>(variant.substeps) * (scene.arrow > 0 ? scene.arrow : fitting_arrow(world, dt_));

  std::vector<Real> instants = scene.instants;
  if (instants.empty() || seconds_ > 0) instants = {0, seconds / 3, 2 * seconds / 3, seconds};
  std::multiset<std::size_t> columns;
  for (const Real t : instants) columns.insert(std::min(steps, static_cast<std::size_t>(std::lround(t / dt_))));
  std::set<std::size_t> frames;
  for (int f = 0; f < (scene.pictures ? frames_ : 0); ++f) {
    frames.insert(frames_ == 1 ? steps
                               : static_cast<std::size_t>(
                                     std::lround(static_cast<double>(f) * static_cast<double>(steps) / (frames_ - 1))));
  }

  Result result;
  result.variant = &variant;
  const fs::path folder =
      output.folder() / (acts_.size() > 1 ? slug(scene.name) + "_" + slug(variant.name) : slug(variant.name));
  if (output.images()) {
    fs::remove_all(folder);  // frames of an earlier run, which may have had more of them
    if (!frames.empty()) fs::create_directories(folder);
  }
  std::size_t frames_drawn = 0;
  const auto draw = [&](std::size_t step) {
    if (!output.images() || !scene.pictures) return;
    if (frames.count(step) > 0) {
      Image frame = output.painter().draw(picture_of(world, scene.camera, arrow));
      write_text(frame, variant.name, 14, 30, 20, {}, Align::left, true);
      write_text(frame, fmt::format("t = {:.3f} s", static_cast<double>(step) * static_cast<double>(dt_)), 14,
                 frame.height - 14, 18);
      write_png(folder / fmt::format("frame_{:04}.png", frames_drawn++), frame);
      output.progress(name_, index, variant.name, frames_drawn, frames.size());
    }
    if (columns.count(step) > 0) {
      for (const Contact& contact : world.contacts) result.states.insert(contact.state);
      for (const Body& body : world.bodies) result.sleepers = result.sleepers || body.asleep;
      const Image still = output.painter().draw_still(picture_of(world, scene.camera, arrow), 16);
      for (std::size_t n = columns.count(step); n > 0; --n) {
        result.cells.push_back(resized(still, 352, 352 * height_ / width_));
        result.cell_notes.push_back(fmt::format("t = {:.3g} s", static_cast<double>(step) * static_cast<double>(dt_)));
      }
    }
  };

  output.progress(name_, index, variant.name, 0, frames.size());
  auto step_once = variant.step;  // a copy: the solver's memory starts empty
  std::vector<ContactId> before;
  draw(0);
  for (std::size_t step = 1; step <= steps; ++step) {
    Sample sample;
    try {
      for (int i = 0; i < variant.substeps; ++i) {
        step_once(world, dt_ / static_cast<Real>(variant.substeps), sweeps_of(variant), sample);
      }
    } catch (const InvalidInput& problem) {
      result.mishap =
          fmt::format("ended at {:.3g} s: {}", static_cast<double>(step) * static_cast<double>(dt_), problem.what());
      break;
    }
    sample.time = static_cast<Real>(step) * dt_;
    sample.kinetic_energy = kinetic_energy(world);
    sample.potential_energy = potential_energy(world);
    sample.momentum = momentum(world);
    sample.angular_momentum = angular_momentum(world);
    sample.overlap = deepest_overlap(world);
    sample.contacts = static_cast<int>(world.contacts.size());
    std::vector<ContactId> now = ids_of(world.contacts);
    sample.found = count_missing(now, before);
    sample.lost = count_missing(before, now);
    before = std::move(now);
    result.samples.push_back(sample);
    for (const Quantity& quantity : act.series) result.series[quantity.name].push_back(quantity.of(world));
    draw(step);
  }
  while (!result.cells.empty() && result.cells.size() < columns.size()) {  // after a mishap
    result.cells.push_back(result.cells.back());
    result.cell_notes.emplace_back("no longer a number");
  }
  const Run run{world, dt_, result.samples, result.series};
  for (const Number& number : act.numbers)
    result.numbers.push_back(result.mishap.empty() ? number.of(run) : std::numeric_limits<Real>::quiet_NaN());
  return result;
}

}  // namespace pushback
