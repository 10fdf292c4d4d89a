/// An experiment in a page: Experiment::run makes it available to these functions, which tools/book/live/ calls.
///
/// Returned text is UTF-8 and valid until the next call. If a function returns an error message, empty text means success.
#include <emscripten.h>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <chrono>
#include <cmath>

#include "pushback/common/basics/files.h"
#include "pushback/common/experiment/marks.h"
#include "pushback/common/live/canvas_view.h"
#include "pushback/common/live/live.h"

namespace pushback {

namespace {

std::unique_ptr<Live> live;
std::unique_ptr<CanvasView> on_canvas;
Legend marks_seen;
std::string words_out;
std::vector<Real> numbers_out;
std::vector<int> cells_out;
RowByRow row_by_row_out;
std::vector<std::pair<Vec3, Colour>> guesses;

const char* answered(std::string text) {
  words_out = std::move(text);
  return words_out.c_str();
}

template <class Work>
const char* problem_of(const Work& work) {
  try {
    work();
    return answered("");
  } catch (const std::exception& problem) {
    return answered(problem.what());
  }
}

struct CameraNumbers {
  double eye[3], target[3], field_of_view;

  operator Camera() const { return {{eye[0], eye[1], eye[2]}, {target[0], target[1], target[2]}, field_of_view}; }
};
CameraNumbers looking;

}  // namespace

int Experiment::run(int, const char* const*, const std::function<void()>& define) {
  live = std::make_unique<Live>(*this, define);
  emscripten_exit_with_live_runtime();  // keeps the variables of main, to which the description refers
  return 0;
}

extern "C" {

EMSCRIPTEN_KEEPALIVE const char* live_description() {
  return answered(live->description());
}
EMSCRIPTEN_KEEPALIVE const char* live_parameters() {
  return answered(live->parameters());
}
EMSCRIPTEN_KEEPALIVE const char* live_values() {
  return answered(live->values());
}
EMSCRIPTEN_KEEPALIVE const char* live_set(const char* assignments) {
  return problem_of([&] { live->set(assignments); });
}
/// `variants`: one bit each, the lowest for the first.
EMSCRIPTEN_KEEPALIVE const char* live_choose(int scene, unsigned variants) {
  std::vector<std::size_t> places;
  for (std::size_t i = 0; i < 32; ++i)
    if ((variants >> i & 1) != 0) places.push_back(i);
  return problem_of([&] { live->choose(static_cast<std::size_t>(scene), places); });
}
EMSCRIPTEN_KEEPALIVE int live_scene() {
  return static_cast<int>(live->scene());
}
EMSCRIPTEN_KEEPALIVE int live_lanes() {
  return static_cast<int>(live->tracks());
}
EMSCRIPTEN_KEEPALIVE int live_variant(int track) {
  return static_cast<int>(live->variant(static_cast<std::size_t>(track)));
}

EMSCRIPTEN_KEEPALIVE int live_steps() {
  return static_cast<int>(live->steps());
}
EMSCRIPTEN_KEEPALIVE int live_known() {
  return static_cast<int>(live->known());
}
EMSCRIPTEN_KEEPALIVE int live_now() {
  return static_cast<int>(live->now());
}
/// Goes to a step, or towards it for about `milliseconds` and at least one step. Returns the step reached.
EMSCRIPTEN_KEEPALIVE int live_go_to(int step, double milliseconds) {
  using Clock = std::chrono::steady_clock;
  const Clock::time_point begin = Clock::now();
  const auto target = std::min(static_cast<std::size_t>(std::max(0, step)), live->steps());
  if (target <= live->known()) {
    live->go_to(target);
    return live_now();
  }
  do live->go_to(std::max(live->now(), std::min(live->known(), target)) + 1);
  while (live->now() < target &&
         std::chrono::duration<double, std::milli>(Clock::now() - begin).count() < milliseconds);
  return live_now();
}

/// Seven numbers that the page sets: eye (m), target (m), field of view (rad). Drawing and grabbing use this camera.
EMSCRIPTEN_KEEPALIVE double* live_camera() {
  return &looking.eye[0];
}
EMSCRIPTEN_KEEPALIVE int live_grab(int track, double aspect, double x, double y) {
  return live->grab_at(static_cast<std::size_t>(track), looking, aspect, x, y) ? 1 : 0;
}
EMSCRIPTEN_KEEPALIVE void live_pull(double aspect, double x, double y) {
  live->pull_to(looking, aspect, x, y);
}
EMSCRIPTEN_KEEPALIVE void live_let_go() {
  live->let_go();
}
/// Four numbers, m: centre and radius of a ball around the movable bodies; see Live::reach.
EMSCRIPTEN_KEEPALIVE const double* live_reach() {
  const auto [centre, radius] = live->reach();
  numbers_out.assign({centre.x(), centre.y(), centre.z(), radius});
  return numbers_out.data();
}
/// Three numbers, m: the displacement of the moving bodies in the picture of a strobe scene.
EMSCRIPTEN_KEEPALIVE const double* live_shift() {
  const Vec3 shift = live->shift();
  numbers_out.assign({shift.x(), shift.y(), shift.z()});
  return numbers_out.data();
}

/// The distance (m) along an axis at which the first movable body is nearest to a point of the picture; see Live::way_to.
EMSCRIPTEN_KEEPALIVE double live_way(double x, double y, double z, double aspect, double right, double up) {
  return live->way_to({x, y, z}, looking, aspect, right, up);
}
/// From now on pictures show the first movable body, outlined, at these distances (m) along an axis. A NaN shows none.
EMSCRIPTEN_KEEPALIVE void live_guess(double x, double y, double z, double guess, double truth) {
  guesses.clear();
  for (const auto& [way, colour] : {std::pair{guess, near_black_colour()}, std::pair{truth, normal_arrow_colour()}})
    if (!std::isnan(way)) guesses.emplace_back(way * Vec3(x, y, z), colour);
}

/// Begins a problem of the description, by index.
EMSCRIPTEN_KEEPALIVE const char* live_hold(int problem) {
  return problem_of([&] { live->hold(static_cast<std::size_t>(problem)); });
}
EMSCRIPTEN_KEEPALIVE const char* live_problem() {
  return answered(live->problem());
}
/// The number of entries stored in its matrix. live_matrix: the row, the column and the value (1/kg) of each.
EMSCRIPTEN_KEEPALIVE int live_stored() {
  return static_cast<int>(live->iterated().problem().matrix.nonZeros());
}
EMSCRIPTEN_KEEPALIVE const double* live_matrix() {
  const auto& matrix = live->iterated().problem().matrix;
  numbers_out.clear();
  for (Eigen::Index row = 0; row < matrix.rows(); ++row)
    for (std::decay_t<decltype(matrix)>::InnerIterator it(matrix, row); it; ++it)
      numbers_out.insert(numbers_out.end(), {static_cast<Real>(row), static_cast<Real>(it.col()), it.value()});
  return numbers_out.data();
}
/// Goes to an iteration, or towards it for about `milliseconds` and at least one iteration. Returns the iteration reached.
EMSCRIPTEN_KEEPALIVE int live_iterate(int target, double milliseconds) {
  using Clock = std::chrono::steady_clock;
  const Clock::time_point begin = Clock::now();
  Iterated& iterated = live->iterated();
  for (int next = std::min(iterated.now() + 1, target); iterated.now() != target; ++next) {
    iterated.go_to(next);
    if (iterated.now() != next) break;  // outside 0 to `most`
    if (std::chrono::duration<double, std::milli>(Clock::now() - begin).count() >= milliseconds) break;
  }
  return iterated.now();
}
EMSCRIPTEN_KEEPALIVE int live_iteration() {
  return live->iterated().now();
}
/// The number of residuals computed for a method. The first is for zero impulses.
EMSCRIPTEN_KEEPALIVE int live_iterated(int method) {
  return static_cast<int>(live->iterated().residuals(static_cast<std::size_t>(method)).size());
}
EMSCRIPTEN_KEEPALIVE const double* live_residuals(int method) {
  return live->iterated().residuals(static_cast<std::size_t>(method)).data();
}
/// N s, one per row.
EMSCRIPTEN_KEEPALIVE const double* live_impulses(int method) {
  return live->iterated().impulses(static_cast<std::size_t>(method)).data();
}

/// Makes a step of the description, by index, and returns its states. live_draw_rows draws one of them.
EMSCRIPTEN_KEEPALIVE const char* live_rows(int step) {
  row_by_row_out = live->rows(static_cast<std::size_t>(step));
  return answered(row_by_row_out.in_json());
}
EMSCRIPTEN_KEEPALIVE void live_draw_rows(int state, int width, int height) {
  on_canvas->draw(row_by_row_out.picture(static_cast<std::size_t>(state), looking), {0, 0, width, height}, false);
}

EMSCRIPTEN_KEEPALIVE const char* live_mishap(int track) {
  return answered(live->mishap(static_cast<std::size_t>(track)));
}
/// The number of steps of a track that have samples.
EMSCRIPTEN_KEEPALIVE int live_played(int track) {
  return static_cast<int>(live->samples(static_cast<std::size_t>(track)).size());
}
EMSCRIPTEN_KEEPALIVE const double* live_series(int track, int which) {
  return live->series(static_cast<std::size_t>(track), static_cast<std::size_t>(which)).data();
}
EMSCRIPTEN_KEEPALIVE const double* live_reference(int track, int which) {
  numbers_out = live->reference(static_cast<std::size_t>(track), static_cast<std::size_t>(which));
  return numbers_out.data();
}
/// ["0.31 m/s", "0 m/s"]: the measured and the expected value.
EMSCRIPTEN_KEEPALIVE const char* live_number(int track, int which) {
  const auto [is, should] = live->number_in_words(static_cast<std::size_t>(track), static_cast<std::size_t>(which));
  return answered(fmt::format("[{}, {}]", pushback::quoted(is), pushback::quoted(should)));
}
/// The number of cells in the column of a step. live_cells: their values.
EMSCRIPTEN_KEEPALIVE int live_column(int track, int step) {
  cells_out = live->raster(static_cast<std::size_t>(track)).at(static_cast<std::size_t>(step));
  return static_cast<int>(cells_out.size());
}
EMSCRIPTEN_KEEPALIVE const int* live_cells() {
  return cells_out.data();
}
/// The sample after a step, counted from 0: thirteen numbers, from the time to the residual, without `found` and `lost`.
EMSCRIPTEN_KEEPALIVE const double* live_sample(int track, int step) {
  const Sample& s = live->samples(static_cast<std::size_t>(track)).at(static_cast<std::size_t>(step));
  numbers_out.assign({s.time, s.kinetic_energy, s.potential_energy, s.momentum.x(), s.momentum.y(), s.momentum.z(),
                      s.angular_momentum.x(), s.angular_momentum.y(), s.angular_momentum.z(), s.overlap,
                      static_cast<Real>(s.contacts), static_cast<Real>(s.rows), s.residual});
  return numbers_out.data();
}
/// A hash of all bodies, as sixteen hexadecimal digits.
EMSCRIPTEN_KEEPALIVE const char* live_hash(int track) {
  return answered(fmt::format("{:016x}", hash_of(live->world(static_cast<std::size_t>(track)))));
}
/// Six numbers: position (m) and velocity (m/s) of a body.
EMSCRIPTEN_KEEPALIVE const double* live_body(int track, int index) {
  const Body& body = live->world(static_cast<std::size_t>(track)).bodies.at(static_cast<std::size_t>(index));
  numbers_out.assign(body.position.data(), body.position.data() + 3);
  numbers_out.insert(numbers_out.end(), body.velocity.data(), body.velocity.data() + 3);
  return numbers_out.data();
}
EMSCRIPTEN_KEEPALIVE int live_bodies(int track) {
  return static_cast<int>(live->world(static_cast<std::size_t>(track)).bodies.size());
}

/// Opens a view on the canvas "#id". Call it again after the context was lost.
EMSCRIPTEN_KEEPALIVE const char* live_open(const char* selector) {
  return problem_of([&] {
    on_canvas.reset();
    on_canvas = std::make_unique<CanvasView>(selector);
  });
}
/// Begins a picture of all tracks.
EMSCRIPTEN_KEEPALIVE void live_begin() {
  marks_seen = {};
}
/// `shown`: 1 points, 2 impulses, 4 marks, 8 coarse drawing; 16, 32, 48: what is lit.
EMSCRIPTEN_KEEPALIVE const char* live_draw(int track, int shown, int x, int y, int width, int height) {
  return problem_of([&] {
    Picture picture =
        live->picture(static_cast<std::size_t>(track), looking,
                      {(shown & 1) != 0, (shown & 2) != 0, (shown & 4) != 0, static_cast<Lit>(shown >> 4)});
    for (const auto& [way, colour] : guesses) add_outline(picture, live->displaced(way), colour);
    marks_seen.see(picture);
    on_canvas->draw(picture, {x, y, width, height}, (shown & 8) != 0);
  });
}
/// [["dot", "#rrggbb", "friction below its limit"], ...]
EMSCRIPTEN_KEEPALIVE const char* live_legend() {
  std::vector<std::string> all;
  for (const LegendEntry& entry : marks_seen.entries()) {
    const char* kind = entry.kind == LegendEntry::Kind::dot     ? "dot"
                       : entry.kind == LegendEntry::Kind::arrow ? "arrow"
                                                                : "body";
    all.push_back(fmt::format(R"(["{}", "#{:02x}{:02x}{:02x}", {}])", kind, entry.colour.red, entry.colour.green,
                              entry.colour.blue, pushback::quoted(entry.text)));
  }
  return answered(fmt::format("[{}]", fmt::join(all, ", ")));
}

}  // extern "C"

}  // namespace pushback
