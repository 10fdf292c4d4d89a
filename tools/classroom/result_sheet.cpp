#include "pushback/tools/classroom/result_sheet.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <mutex>
#include <optional>

#include "pushback/common/experiment/plot.h"
#include "pushback/common/render/canvas.h"
#include "pushback/tools/classroom/attempt.h"
#include "pushback/tools/classroom/bodies_picture.h"
#include "pushback/tools/classroom/student_files.h"

namespace pushback {

namespace fs = std::filesystem;

namespace {

constexpr int margin = 40, width = 1600, right_edge = width - margin;
constexpr int strip_left = 150, strip_right = 960, strip_height = 34;
constexpr std::array columns{985, 1180, 1375};  // of the numbers: right, yours, the mistake's
constexpr Ink dark{28, 32, 40}, grey{104, 112, 124}, pale{222, 226, 232}, white{255, 255, 255};
constexpr Ink of_yours{0, 114, 178}, of_mistake{213, 94, 0}, failed{176, 0, 32};
constexpr int frame = 4, half_width = (right_edge - margin - 24) / 2, half_height = 420;  // of the bodies
constexpr Real off_the_strip = 4;  // times as far as what is right and the mistake span

/// Of one check; the mistake's are empty where none is known.
struct Compared {
  const Exercise::Line& check;
  Passed passed;
  NumbersOfScenes right, yours, mistaken;
};

/// The number, if it was sent.
std::optional<Real> sent(const NumbersOfScenes& scenes, std::size_t scene, std::size_t quantity) {
  if (scene >= scenes.size() || quantity >= scenes[scene].size()) return std::nullopt;
  return scenes[scene][quantity];
}

/// What a quantity's strips span.
class Span {
 public:
  Span(const Compared& compared, std::size_t quantity) {
    take(0);
    const Real least = 10 * static_cast<Real>(compared.check.quantities[quantity].tolerance);
    for (std::size_t scene = 0; scene < scenes_of_a_check; ++scene) {
      take(sent(compared.right, scene, quantity));
      take(sent(compared.mistaken, scene, quantity));
    }
    take(low_ - least);
    take(high_ + least);
    const Real reach = off_the_strip * std::max({high_ - low_, std::abs(low_), std::abs(high_)});
    const Real low = low_ - reach, high = high_ + reach;
    for (std::size_t scene = 0; scene < scenes_of_a_check; ++scene) {
      const std::optional<Real> yours = sent(compared.yours, scene, quantity);
      if (yours && *yours >= low && *yours <= high) take(yours);
    }
    const Real room = (high_ - low_) * Real(0.05);
    low_ -= room;
    high_ += room;
  }
  bool holds(Real value) const { return value >= low_ && value <= high_; }
  int x(Real value) const {
    const Real part = std::clamp((value - low_) / (high_ - low_), Real(0), Real(1));
    return strip_left + static_cast<int>(std::lround(part * (strip_right - strip_left)));
  }

 private:
  void take(std::optional<Real> value) {
    if (!value || !std::isfinite(*value)) return;
    low_ = std::min(low_, *value);
    high_ = std::max(high_, *value);
  }
  Real low_ = std::numeric_limits<Real>::infinity(), high_ = -low_;
};

/// The bodies of a scene that fails.
struct Shown {
  std::optional<BodiesPicture> picture;
  std::string scene, yours, right;  ///< which it is; the number that tells, as it is and as it should be
  std::string problem;              ///< why there is no picture
};

/// Draws from the top down; on an image of one pixel, to learn how high it will be.
class Drawing {
 public:
  explicit Drawing(Image& onto) : image_(onto) {}

  int draw(const std::string& title, const Verdict& verdict, const std::optional<Shown>& shown,
           const std::vector<Compared>& checks, const std::vector<Image>& plots) {
    lines(title, 36, dark, true);
    lines(verdict.in_words(), 22, verdict.passed() ? dark : failed, false);
    y_ += 6;
    if (shown) bodies(*shown);
    legend(verdict);
    for (const Compared& compared : checks) check(compared);
    for (const Image& plot : plots) {
      const int wide = std::min(plot.width, right_edge - margin), high = plot.height * wide / plot.width;
      paste(plot, image_, margin, y_ + 10, wide, high);
      y_ += high + 20;
    }
    return y_ + margin;
  }

 private:
  void lines(const std::string& text, float size, Ink ink, bool bold) {
    for (const std::string& line : wrapped(text, size, right_edge - margin, bold)) {
      y_ += static_cast<int>(size * 1.25F);
      write_text(image_, line, margin, y_, size, ink, Align::left, bold);
    }
  }

  void bodies(const Shown& shown) {
    if (!shown.picture) return lines("The bodies could not be drawn: " + shown.problem, 18, grey, false);
    y_ += 12;
    half(shown.picture->yours, margin, of_yours, "yours", shown.yours);
    half(shown.picture->right, right_edge - half_width, dark, "right", shown.right);
    y_ += half_height + 2 * frame + 30;
    write_text(image_, shown.scene, margin, y_, 18, grey);
    if (!shown.picture->legend.empty()) y_ += 28;
    int x = margin;
    for (const LegendEntry& entry : shown.picture->legend) {
      const int wide = 48 + text_width(entry.text, 18);
      if (x + wide > right_edge) {
        x = margin;
        y_ += 26;
      }
      const double middle = y_ - 6;
      if (entry.kind == LegendEntry::Kind::arrow) {
        draw_arrow(image_, {x + 0.0, middle}, {x + 36.0, middle}, 5, entry.colour);
      } else {
        fill_disc(image_, static_cast<float>(x) + 28, static_cast<float>(middle), 8, dark);  // a rim: one is white
        fill_disc(image_, static_cast<float>(x) + 28, static_cast<float>(middle), 6.5F, entry.colour);
      }
      write_text(image_, entry.text, x + 48, y_, 18, dark);
      x += wide + 30;
    }
    lines(shown.picture->note, 18, grey, false);
    y_ += 4;
  }

  /// In a frame of the colour that its numbers have.
  void half(const Image& picture, int x, Ink ink, const std::string& whose, const std::string& number) {
    fill_rectangle(image_, x, y_, half_width, half_height + 2 * frame, ink);
    paste(picture, image_, x + frame, y_ + frame, half_width - 2 * frame, half_height);
    const int left = x + frame, base = y_ + frame + 30, wide = text_width(whose, 26, true);
    fill_rectangle(image_, left, y_ + frame, wide + text_width(number, 26) + 36, 40, white);
    write_text(image_, whose, left + 12, base, 26, dark, Align::left, true);
    write_text(image_, number, left + wide + 24, base, 26, dark);
  }

  void legend(const Verdict& verdict) {
    y_ += 34;
    int x = margin + 12;
    const auto entry = [&](const std::string& words, Ink ink, const auto& draw) {
      draw(x, y_ - 7);
      write_text(image_, words, x + 24, y_, 20, ink);
      x += 24 + text_width(words, 20) + 60;
    };
    entry("right", dark, [&](int at, int y) { bar(at, y); });
    entry("yours", of_yours, [&](int at, int y) { disc(at, y); });
    if (verdict.resembles)
      entry("the mistake that it resembles: " + verdict.resembles->name, of_mistake,
            [&](int at, int y) { ring(at, y); });
    y_ += 16;
  }

  void check(const Compared& compared) {
    fill_rectangle(image_, margin, y_ + 8, right_edge - margin, 2, pale);
    y_ += 44;
    const bool passed = compared.passed == Passed::yes;
    write_text(image_,
               passed                          ? "✓"
               : compared.passed == Passed::no ? "✗"
                                               : "·",
               margin, y_, 26, passed ? dark : failed, Align::left, true);
    write_text(image_, compared.check.says, margin + 34, y_, 26, dark, Align::left, true);
    for (std::size_t i = 0; i < compared.check.quantities.size(); ++i) quantity(compared, i);
    y_ += 14;
  }

  void quantity(const Compared& compared, std::size_t i) {
    const Quantity& quantity = compared.check.quantities[i];
    y_ += 32;
    write_text(image_, quantity.words, margin + 34, y_, 20, grey);
    write_text(image_, "right", columns[0], y_, 18, grey);
    write_text(image_, "yours", columns[1], y_, 18, grey);
    if (!compared.mistaken.empty()) write_text(image_, "the mistake's", columns[2], y_, 18, grey);
    const Span span(compared, i);
    y_ += 6;
    for (std::size_t scene = 0; scene < scenes_of_a_check; ++scene) {
      const int middle = y_ + strip_height / 2;
      write_text(image_, fmt::format("scene {}", scene + 1), margin + 34, middle + 7, 18, grey);
      draw_line(image_, {strip_left, static_cast<double>(middle)}, {strip_right, static_cast<double>(middle)}, 1.5F,
                pale);
      fill_rectangle(image_, span.x(0), y_ + 4, 1, strip_height - 8, grey, 0.6F);
      if (const std::optional<Real> mistaken = sent(compared.mistaken, scene, i)) {
        if (!std::isnan(*mistaken)) ring(span.x(*mistaken), middle);
        number(*mistaken, quantity, 2, of_mistake);
      }
      const Real right = *sent(compared.right, scene, i);
      bar(span.x(right), middle);
      number(right, quantity, 0, dark);
      const std::optional<Real> yours = sent(compared.yours, scene, i);
      if (!yours) write_text(image_, "not reached", columns[1], middle + 7, 20, failed);
      else number(*yours, quantity, 1, of_yours);
      if (yours && span.holds(*yours)) disc(span.x(*yours), middle);
      else if (yours && !std::isnan(*yours)) beyond(*yours > 0, middle);
      y_ += strip_height;
    }
    write_text(image_, "0", span.x(0), y_ + 8, 15, grey, Align::centre);
  }

  void number(Real value, const Quantity& quantity, std::size_t column, Ink ink) {
    write_text(image_, in_words(value, quantity), columns[column], y_ + strip_height / 2 + 7, 20, ink);
  }
  void bar(int x, int y) { fill_rectangle(image_, x - 2, y - 14, 4, 28, dark); }
  void disc(int x, int y) { fill_disc(image_, static_cast<float>(x), static_cast<float>(y), 6.5F, of_yours); }
  void ring(int x, int y) {
    fill_disc(image_, static_cast<float>(x), static_cast<float>(y), 12.5F, of_mistake);
    fill_disc(image_, static_cast<float>(x), static_cast<float>(y), 9, white);
  }
  /// Yours lies past an end.
  void beyond(bool high, int y) {
    const double end = high ? strip_right : strip_left, from = high ? end - 30 : end + 30;
    draw_arrow(image_, {from, static_cast<double>(y)}, {end, static_cast<double>(y)}, 4, of_yours);
  }

  Image& image_;
  int y_ = margin - 16;
};

/// Behind the quantities of the first scene.
Curve curve_of(const NumbersOfScenes& scenes, const Exercise::Line& check, std::size_t length, const std::string& label,
               const std::string& colour, Curve::Style style) {
  Curve curve{.label = label, .x = {}, .y = {}, .colour = colour, .style = style};
  for (std::size_t i = 0; !scenes.empty() && i < length; ++i) {
    const std::optional<Real> value = sent(scenes, 0, check.quantities.size() + i);
    if (!value) break;
    curve.x.push_back(static_cast<Real>(i));
    curve.y.push_back(*value);
  }
  return curve;
}

std::vector<Image> plots_of(const std::vector<Compared>& checks, const Verdict& verdict) {
  std::vector<Panel> panels;
  for (const Compared& one : checks) {
    if (!one.check.recorded || one.yours.empty()) continue;
    const Recorded& recorded = *one.check.recorded;
    const std::size_t length = one.right[0].size() - one.check.quantities.size();
    Panel panel{one.check.says + ", scene 1", recorded.over, recorded.words + ", " + recorded.unit};
    panel.curves.push_back(curve_of(one.right, one.check, length, "right", "#1c2028", Curve::Style::dashed));
    if (verdict.resembles)
      panel.curves.push_back(
          curve_of(one.mistaken, one.check, length, verdict.resembles->name, "#d55e00", Curve::Style::line));
    panel.curves.push_back(curve_of(one.yours, one.check, length, "yours", "#0072b2", Curve::Style::line));
    panels.push_back(std::move(panel));
  }
  std::vector<Image> plots;
  if (panels.empty()) return plots;
  const ScratchFolder scratch;
  for (const fs::path& file : write_plot(scratch.path / "plot.png", panels)) plots.push_back(read_png(file));
  return plots;
}

/// Of the check that the verdict is about, if its scene shows any.
std::optional<Shown> bodies_of(const Exercise& exercise, std::uint64_t seed, const Attempt& outcome,
                               const Verdict& verdict) {
  const std::optional<TellingInstant> telling = telling_instant(exercise, seed, outcome, verdict);
  if (!telling) return std::nullopt;
  const auto [check, scene, quantity, yours, right, of_place] = *telling;
  const Quantity& which = exercise.checks[check].quantities[quantity];
  const auto number = [&, scene = scene, quantity = quantity](const NumbersOfScenes& scenes) {
    return in_words(scenes[scene][quantity], which);
  };
  std::string words = fmt::format("{}, scene {}", exercise.checks[check].says, scene + 1);
  if (right.time > 0) words += fmt::format(", t = {:.3g} s", right.time);
  Shown shown{{}, words, number(outcome.numbers[check]), number(scenes_of(exercise.right, seed, check)), {}};
  try {
    shown.picture = picture_of_bodies(yours, right, half_width - 2 * frame, half_height, of_place);
  } catch (const std::runtime_error& problem) {  // no graphics here: the numbers need none
    shown.problem = problem.what();
  }
  return shown;
}

}  // namespace

bool write_result_sheet(const fs::path& file, const Exercise& exercise, std::uint64_t seed, const Attempt& outcome,
                        const Verdict& verdict) {
  if (outcome.numbers.empty()) {
    fs::remove(file);
    return false;
  }
  std::vector<Compared> checks;
  for (std::size_t i = 0; i < exercise.checks.size(); ++i)
    checks.push_back({exercise.checks[i], verdict.checks[i], scenes_of(exercise.right, seed, i),
                      i < outcome.numbers.size() ? outcome.numbers[i] : NumbersOfScenes{},
                      verdict.resembles ? scenes_of(verdict.resembles->played, seed, i) : NumbersOfScenes{}});
  const std::string title = short_name(exercise) + ": " + exercise.title;
  static std::mutex one_at_a_time;  // letters are laid out in one place for all
  const std::lock_guard guard(one_at_a_time);
  const std::optional<Shown> shown = bodies_of(exercise, seed, outcome, verdict);
  const std::vector<Image> plots = plots_of(checks, verdict);
  Image nothing(1, 1);
  Image image(width, Drawing(nothing).draw(title, verdict, shown, checks, plots));
  Drawing(image).draw(title, verdict, shown, checks, plots);
  write_png(file, image);
  return true;
}

}  // namespace pushback
