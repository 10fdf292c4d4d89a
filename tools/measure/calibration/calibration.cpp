#include "pushback/tools/measure/calibration/calibration.h"

#include <cmath>
#include <limits>
#include <sstream>

#include "pushback/common/basics/stopwatch.h"
#include "pushback/engine/presets.h"
#include "pushback/tools/measure/results/csv.h"

namespace pushback::calibration {

namespace {

constexpr const char* heading = "scene,sure in m,places in m";
constexpr double most_work = 1e8;  // multiplications in a step: some seconds for a scene

std::vector<Vec3> places_of(const World& world) {
  std::vector<Vec3> places;
  for (const Body& body : world.bodies)
    if (body.movable()) places.push_back(body.position);
  return places;
}

Real farthest(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
  Real largest = 0;
  for (std::size_t i = 0; i < a.size(); ++i) largest = std::max(largest, (a[i] - b[i]).norm());
  return largest;
}

std::vector<Vec3> places_after(World world, int substeps) {
  HalfStep solver = at_impacts(Impacts::sequential);
  solver.substeps = substeps;
  solver.threshold = 0;
  solver.most_work = most_work;
  for (int i = 0; i < frames; ++i) world.step(solver, dt);
  return places_of(world);
}

}  // namespace

Real Truth::error(const World& world) const {
  return farthest(places_of(world), places);
}

Truth find_truth(std::uint64_t number) {
  const World world = scene(number).world;
  Truth truth{.number = number, .sure = std::numeric_limits<Real>::infinity(), .places = {}};
  try {
    const std::vector<Vec3> coarse = places_after(world, 64);
    truth.places = places_after(world, 128);
    truth.sure = farthest(coarse, truth.places);
  } catch (const InvalidInput&) {  // too much work, or Newton's method does not converge
    truth.places.clear();
  }
  return truth;
}

std::string text_of(const std::vector<Truth>& truths) {
  std::string text = fmt::format("{}\n", heading);
  for (const Truth& truth : truths) {
    text += fmt::format("{},{:.2e},", truth.number, truth.sure);
    for (std::size_t i = 0; i < truth.places.size(); ++i) {
      const Vec3& at = truth.places[i];
      text += fmt::format("{}{:.10f} {:.10f} {:.10f}", i == 0 ? "" : " ", at.x(), at.y(), at.z());
    }
    text += "\n";
  }
  return text;
}

std::vector<Truth> truths_in(const std::string& text) {
  std::vector<Truth> truths;
  read_csv_lines(text, heading, [&](const std::vector<std::string>& fields) {
    Truth truth{.number = csv_number<std::uint64_t>(fields[0]), .sure = csv_number<Real>(fields[1]), .places = {}};
    std::istringstream words(fields[2]);
    for (std::string x, y, z; words >> x >> y >> z;)
      truth.places.emplace_back(csv_number<Real>(x), csv_number<Real>(y), csv_number<Real>(z));
    truths.push_back(truth);
  });
  return truths;
}

Played play(const Scene& scene, const Truth& truth) {
  Played played{.number = truth.number,
                .kind = scene.kind,
                .asked = scene.asked,
                .error = 0,
                .said = 0,
                .flagged = false,
                .steps = 0,
                .estimate = 0};
  World world = scene.world, again = scene.world;
  Recommended solver;
  solver.error = scene.asked;
  IslandSolver alone;
  Stopwatch both, steps;
  for (int i = 0; i < frames; ++i) {
    both.go();
    world.step(solver, dt);
    both.stop();
    alone.given = solver.given;
    steps.go();  // in turn, so that both are timed on the same state of the machine
    again.step(alone, dt);
    steps.stop();
    played.said = 0;
    for (const Body& body : world.bodies) {
      const BodyError known = solver.error_of(body.index);
      played.said = std::max(played.said, known.position_error);
      played.flagged |= !known.kept;
    }
  }
  played.error = truth.error(world);
  played.steps = steps.seconds();
  played.estimate = both.seconds() - played.steps;
  return played;
}

}  // namespace pushback::calibration
