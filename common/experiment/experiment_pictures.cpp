/// The pictures of one variant: frames, the cells of its row, or one wide picture of many instants.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "pushback/common/experiment/experiment_parts.h"
#include "pushback/common/experiment/film.h"
#include "pushback/common/experiment/kept_picture.h"
#include "pushback/common/experiment/picture_of.h"
#include "pushback/common/experiment/sheet.h"

namespace pushback {

namespace fs = std::filesystem;

Experiment::Shots::Shots(const Experiment& of, std::size_t index, const World& start, Output& output, Result& result)
    : experiment_(of),
      variant_(of.variants_[index]),
      scene_(of.scene_records_[variant_.scene].scene),
      index_(index),
      start_(start),
      output_(output),
      result_(result) {
  const std::size_t steps = of.steps_of(scene_);
  const Real seconds = static_cast<Real>(steps) * of.dt_;
  if (scene_.contacts == Drawn::points) arrow_ = 0;
  if (scene_.contacts == Drawn::impulses) arrow_ = scene_.arrow > 0 ? scene_.arrow : fitting_arrow(start, of.dt_);
  if (!output.images() || !scene_.pictures) return;

  const bool of_its_own = !scene_.instants.empty() && of.seconds_ == 0;
  if (scene_.strobe) {
    const Real until = scene_.strobe->until > 0 ? std::min(scene_.strobe->until, seconds) : seconds;
    for (Real t = scene_.strobe->from; t <= until + of.dt_ / 2; t += scene_.strobe->every) cells_.insert(step_at(t));
  } else {
    for (const Real t : of_its_own ? scene_.instants : std::vector<Real>{seconds / 3, 2 * seconds / 3, seconds})
      cells_.insert(std::min(steps, step_at(t)));
    if (*cells_.rbegin() > 0) cells_.erase(0);
    while (cells_.size() > 3) cells_.erase(cells_.begin());
  }
  if (!of.film_.empty()) {
    for (int f = 0; f < seconds * frames_per_second; ++f)
      frames_.insert(step_at(static_cast<Real>(f) / frames_per_second));
  }
  for (int f = 0; f < of.frames_; ++f) {
    frames_.insert(of.frames_ == 1 ? steps
                                   : static_cast<std::size_t>(std::lround(
                                         static_cast<double>(f) * static_cast<double>(steps) / (of.frames_ - 1))));
  }
  folder_ = output.folder() / of.frames_folder(variant_);
  fs::remove_all(folder_);  // frames of an earlier run, which may have had more of them
  if (!frames_.empty()) fs::create_directories(folder_);
  const bool first = std::none_of(of.variants_.begin(), of.variants_.begin() + static_cast<std::ptrdiff_t>(index),
                                  [&](const Variant& one) { return one.scene == variant_.scene; });
  if (first && scene_.start_shown && !scene_.strobe)
    result_.start = still(picture(start, 0), output.cell(scene_.cell_height));
  if (first && of.is_first_with_pictures(variant_.scene) && of.mine_.empty()) {
    World filled;  // without the changes of a variant
    scene_.fill(filled);
    Output::Size size = scene_.strobe ? output.strip(scene_.strobe->height) : output.frame();
    if (scene_.cell_height > 0 && !scene_.strobe) {  // else the sides of a wide scene would be cut off
      const auto [width, height] = output.cell(scene_.cell_height);
      size.second = std::min(size.second, size.first * height / width);
    }
    Painter& painter = output.painter(size);
    keep_picture(output.folder() / "start.png", painter.draw_still(picture(filled, 0), of.passes_));
  }
  take(start, 0);
}

bool Experiment::is_first_with_pictures(std::size_t index) const {
  return scene_records_[index].scene.pictures &&
         std::none_of(scene_records_.begin(), scene_records_.begin() + static_cast<std::ptrdiff_t>(index),
                      [](const SceneRecord& one) { return one.scene.pictures; });
}

std::string Experiment::frames_folder(const Variant& variant) const {
  const std::string own = slug(variant.name);
  return scene_records_.size() > 1 ? slug(scene_records_[variant.scene].scene.name) + "_" + own : own;
}

/// Makes one film per scene that has pictures, named like its sheet, and then removes its frames.
void Experiment::make_films(const fs::path& folder) const {
  for (std::size_t a = 0; a < scene_records_.size(); ++a) {
    std::vector<fs::path> frames;
    for (const Variant& variant : variants_) {
      if (variant.scene == a && scene_records_[a].scene.pictures) frames.push_back(folder / frames_folder(variant));
    }
    if (frames.empty()) continue;
    std::string name = sheet_file(a).replace(0, std::string("sheet").size(), "film");
    const fs::path film = folder / fs::path(name).replace_extension(film_);
    write_film(film, frames, static_cast<double>(static_cast<Real>(steps_of(scene_records_[a].scene)) * dt_));
    for (const fs::path& used : frames) fs::remove_all(used);
    fmt::print("{}\n", film.string());
  }
}

std::size_t Experiment::Shots::step_at(Real time) const {
  return static_cast<std::size_t>(std::lround(time / experiment_.dt_));
}

World Experiment::Shots::as_drawn(const World& world) const {
  return scene_.magnified == 1 ? world : magnified(world, start_, scene_.magnified);
}

Picture Experiment::Shots::picture(const World& world, std::size_t step) const {
  const World drawn = as_drawn(world);
  Picture made = picture_of(drawn, scene_.camera, arrow_);
  if (scene_.marks) scene_.marks(made, drawn, static_cast<Real>(step) * experiment_.dt_);
  return made;
}

Image Experiment::Shots::still(const Picture& of, Output::Size size) {
  result_.legend.see(of);
  return output_.painter(size).draw_still(of, experiment_.passes_);
}

void Experiment::Shots::take(const World& world, std::size_t step) {
  const Real time = static_cast<Real>(step) * experiment_.dt_;
  if (frames_.contains(step)) {
    Image frame = output_.painter(output_.frame()).draw(picture(world, step));
    write_text(frame, variant_.name, 14, 30, 20, {}, Align::left, true);
    write_text(frame, fmt::format("t = {:.3f} s", time) + how_magnified(), 14, frame.height - 14, 18);
    const Real aspect = static_cast<Real>(frame.width) / static_cast<Real>(frame.height);
    write_labels(frame, labels_of(scene_, aspect), 0, 0, frame.width, frame.height, 18);
    for (std::size_t n = frames_.count(step); n > 0; --n)
      write_png(folder_ / fmt::format("frame_{:04}.png", frames_drawn_++), frame);
    output_.progress(experiment_.name_, index_, variant_.name, frames_drawn_, frames_.size());
  }
  if (scene_.raster && step > 0 && output_.images() && scene_.pictures)
    result_.raster.push_back(scene_.raster->of(world));
  if (!cells_.contains(step)) return;
  if (scene_.strobe) {
    const World drawn = as_drawn(world);
    const Strobe& strobe = *scene_.strobe;
    if (strobe_) {
      add_moving(*strobe_, drawn, arrow_, strobe.shift_per_second * (time - strobe.from), strobe.marks);
    } else {
      strobe_ = picture_of(drawn, scene_.camera, arrow_);
      if (strobe.marks) strobe.marks(*strobe_, drawn);
    }
    marked_ = drawn;
    marked_at_ = time;
  } else {
    result_.cells.push_back(still(picture(world, step), output_.cell(scene_.cell_height)));
    result_.cell_notes.push_back(fmt::format("t = {:.3g} s", time) + how_magnified());
  }
}

std::string Experiment::Shots::how_magnified() const {
  return scene_.magnified == 1 ? "" : fmt::format(" · displacements × {:g}", scene_.magnified);
}

void Experiment::Shots::end() {
  if (strobe_) {
    if (scene_.marks) scene_.marks(*strobe_, marked_, marked_at_);
    result_.cells.push_back(still(*strobe_, output_.strip(scene_.strobe->height)));
    const std::string instants = cells_.size() == 1 ? "" : fmt::format("every {:.3g} s, up to ", scene_.strobe->every);
    const std::string when = fmt::format("{}t = {:.3g} s", instants, marked_at_);
    result_.cell_notes.push_back((scene_.strobe->note.empty() ? when : scene_.strobe->note) + how_magnified());
  }
  while (!scene_.strobe && !result_.cells.empty() && result_.cells.size() < cells_.size()) {  // after a mishap
    result_.cells.push_back(result_.cells.back());
    result_.cell_notes.emplace_back("no longer a number");
  }
}

}  // namespace pushback
