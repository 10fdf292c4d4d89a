#include "pushback/tools/measure/outside/play.h"

#include <algorithm>
#include <cmath>

#include "pushback/common/basics/quantile.h"
#include "pushback/common/basics/stopwatch.h"
#include "pushback/common/world/measure.h"
#include "pushback/tools/measure/results/csv.h"

namespace pushback::outside {

namespace {

constexpr Real dt = Real(1) / 60;

/// Mechanical energy, less the work of pushes and of the drum. With the term by which a body in free fall differs from it when it moves
/// by v += h a, x += h v, as in Watcher.
class EnergyAccount {
 public:
  EnergyAccount(const World& start, const OutsideScene& scene, Real drum) : drum_(drum) {
    Real lowest = std::numeric_limits<Real>::infinity();
    for (const Body& body : start.bodies)
      if (body.movable()) lowest = std::min(lowest, body.position.y());
    for (const Body& body : start.bodies) {
      acceleration_.push_back(start.gravity);
      if (body.movable())
        turned_over_ += start.gravity.norm() / body.inverse_mass * (body.position.y() - lowest + scene.half_thickness);
    }
    for (const Push& push : scene.pushes)
      acceleration_[static_cast<std::size_t>(push.body)] += push.force * start.body(push.body).inverse_mass;
    before_ = state_of(start);
  }

  void look(const World& now, Real h, const std::function<bool(int)>& half_steps) {
    const State state = state_of(now);
    Real work = drum_ * (state.spin - before_.spin - dt * (state.torque + before_.torque) / 2);
    for (std::size_t i = 0; i < now.bodies.size(); ++i)
      if (!half_steps || !half_steps(static_cast<int>(i)))
        work -= h / 2 * acceleration_[i].dot(state.momenta[i] - before_.momenta[i]);
    gained_ += state.energy - before_.energy - work;
    most_gained_ = std::max(most_gained_, gained_);
    most_kinetic_ = std::max(most_kinetic_, kinetic_energy(now));
    before_ = state;
  }
  Real gained() const { return 100 * most_gained_ / (turned_over_ + most_kinetic_); }  // %

 private:
  struct State {
    Real energy = 0, spin = 0, torque = 0;  // of all together, about z
    std::vector<Vec3> momenta;
  };
  State state_of(const World& now) const {
    State state{.energy = kinetic_energy(now), .spin = angular_momentum(now).z(), .momenta = {}};
    for (std::size_t i = 0; i < now.bodies.size(); ++i) {
      const Body& body = now.bodies[i];
      const Real mass = body.movable() ? 1 / body.inverse_mass : 0;
      state.energy -= mass * acceleration_[i].dot(body.position);
      state.torque += mass * body.position.cross(now.gravity).z();
      state.momenta.push_back(mass * body.velocity);
    }
    return state;
  }

  Real drum_;                       // rad/s
  std::vector<Vec3> acceleration_;  // of each body in free fall
  Real turned_over_ = 0, most_kinetic_ = 0, gained_ = 0, most_gained_ = 0;
  State before_;
};

bool all_finite(const World& world) {
  return std::all_of(world.bodies.begin(), world.bodies.end(), [](const Body& body) {
    return body.position.allFinite() && body.velocity.allFinite() && body.angular_velocity.allFinite();
  });
}

}  // namespace

bool Played::passed(const OutsideScene& of) const {
  return broken.empty() && number <= of.limit && gained <= 100 * of.gain && overlap_median <= 100 * of.half_thickness;
}

Played play(const OutsideScene& scene, const Stage& stage, double at_most) {
  Played played{.scene = scene.name, .solver = stage.name};
  World world = begin(scene);
  const World start = world;
  World seen = world;
  const Look look = look_at(scene, start);
  const LargeScene* large = large_scene(scene.name);
  EnergyAccount energy(start, scene, large ? large->drum : 0);
  Stepper stepper = stage.begin();
  std::vector<double> overlaps, times;
  double seconds = 0;
  try {
    for (long i = 0, steps = std::lround(scene.seconds / dt); i < steps; ++i) {
      if (large && large->drive) large->drive(world, start, dt);
      Stopwatch watch;
      watch.go();
      stepper.step(world, dt);
      watch.stop();
      times.push_back(1000 * watch.seconds());
      seconds += watch.seconds();
      if (!all_finite(world)) throw InvalidInput("not finite");
      if (seconds > at_most) throw InvalidInput(fmt::format("took more than {} s", at_most));
      seen.bodies = world.bodies;
      seen.time = world.time;
      seen.find_contacts();
      overlaps.push_back(1000 * static_cast<double>(deepest_overlap(seen)));
      energy.look(seen, dt / static_cast<Real>(stage.substeps(dt)), stepper.half_steps);
      played.number = static_cast<double>(look(seen));
    }
  } catch (const std::exception& problem) {  // an engine that gives up may throw anything
    played.broken = fmt::format("{} after {:.3g} s", problem.what(), world.time);
  }
  if (!overlaps.empty()) {
    played.overlap_median = median(overlaps);
    played.overlap_worst = quantile(overlaps, 1);
  }
  played.gained = static_cast<double>(energy.gained());
  if (large && large->slope && played.broken.empty()) played.slope = static_cast<double>(large->slope(seen));
  if (!times.empty()) {
    played.ms_median = median(times);
    played.ms_worst = quantile(times, 1);
  }
  return played;
}

std::string line_of(const Played& one) {
  return fmt::format("{},{},{:.4g},{:.3g},{:.3g},{:.3g},{:.3g},{:.3g},{:.3g},{}\n", one.scene, csv_field(one.solver),
                     one.number, one.overlap_median, one.overlap_worst, one.gained, one.slope, one.ms_median,
                     one.ms_worst, csv_field(one.broken));
}

std::string text_of(const std::vector<Played>& all) {
  std::string text = fmt::format("{}\n", heading);
  for (const Played& one : all) text += line_of(one);
  return text;
}

std::vector<Played> read_lines(const std::string& text) {
  std::vector<Played> all;
  read_csv_lines(text, heading, [&all](const std::vector<std::string>& fields) {
    const auto number = [&fields](std::size_t i) { return csv_number<double>(fields[i]); };
    scene_named(fields[0]);
    all.push_back({.scene = fields[0],
                   .solver = fields[1],
                   .number = number(2),
                   .overlap_median = number(3),
                   .overlap_worst = number(4),
                   .gained = number(5),
                   .slope = number(6),
                   .ms_median = number(7),
                   .ms_worst = number(8),
                   .broken = fields[9]});
  });
  return all;
}

}  // namespace pushback::outside
