#include "pushback/chapters/07_warm_start/study.h"
#include "pushback/common/experiment/experiment.h"
#include "pushback/common/experiment/marks.h"
#include "pushback/common/experiment/row_by_row.h"

using namespace pushback;
using namespace pushback::warm_start_scenes;

namespace {

using Cold = Solver<Clamping, Baumgarte, Slop, Restitution, Friction>;

/// Every contact gets what another one had, some places on in the list.
struct WarmStartWithWrongIds : WarmStart {
  int places = 1;
  void build(StepContext& step) {
    WarmStart::build(step);
    if (first_guess_.empty()) return;
    const auto middle = static_cast<std::ptrdiff_t>(static_cast<std::size_t>(places) % first_guess_.size());
    std::rotate(first_guess_.begin(), first_guess_.begin() + middle, first_guess_.end());
  }
};
using WrongIds = Solver<Clamping, Baumgarte, Slop, Restitution, Friction, WarmStartWithWrongIds>;

constexpr Real unknown = std::numeric_limits<Real>::quiet_NaN();

/// A reader's solver need not say how many rows it has, and how far they are off.
bool tells_rows(const Run& run) {
  return std::any_of(run.samples.begin(), run.samples.end(), [](const Sample& sample) { return sample.rows > 0; });
}

/// Mean from 1 s to 2 s: all of them still stand then.
Real mean(const Run& run, Real Sample::* what) {
  Real sum = 0;
  int count = 0;
  for (const Sample& sample : run.samples) {
    if (sample.time < 1 || sample.time > 2) continue;
    sum += sample.*what;
    ++count;
  }
  return sum / static_cast<Real>(count);
}

/// How far the body that has moved farthest is from where it began, mm.
std::function<Real(const World&)> drift_from(const std::function<void(World&)>& fill) {
  World start;
  fill(start);
  std::vector<Vec3> places;
  for (const Body& body : start.bodies) places.push_back(body.position);
  return [places](const World& world) {
    Real farthest = 0;
    for (std::size_t i = 0; i < places.size(); ++i)
      farthest = std::max(farthest, (world.bodies[i].position - places[i]).norm());
    return 1000 * farthest;
  };
}

/// `seconds` after the start, mm, or at the end where that is earlier. The first value is that after the first step.
Real drift_after(const Run& run, Real seconds) {
  const auto& drift = run.series.at("drift");
  return drift.at(std::clamp(static_cast<std::size_t>(std::lround(seconds / run.dt)), std::size_t(1), drift.size()) -
                  1);
}

Real kinetic_in_last_second(const Run& run) {
  Real most = 0;
  for (const Sample& sample : run.last(1)) most = std::max(most, sample.kinetic_energy);
  return most;
}

/// J, at the most, over what it began with. What rests or falls gains none.
std::function<Real(const Run&)> energy_gained(const std::function<void(World&)>& fill) {
  World start;
  fill(start);
  return [before = potential_energy(start)](const Run& run) {
    Real most = 0;
    for (const Sample& sample : run.samples)
      most = std::max(most, sample.kinetic_energy + sample.potential_energy - before);
    return most;
  };
}

/// Outlines of the bodies where they began.
struct AsBegan {
  World start;

  explicit AsBegan(const std::function<void(World&)>& fill) { fill(start); }
  void operator()(Picture& picture, const World&, Real) const {
    for (const Body& body : start.bodies) add_outline(picture, body, near_black_colour(), Real(0.8));
  }
};

/// Boxes that begin `depth` m deep in each other, the lowest in the ground.
std::function<void(World&)> begun_in_each_other(int boxes, Real depth) {
  return [=](World& world) {
    stack(world, boxes, -depth);
    for (Body& body : world.bodies)
      if (body.movable()) body.position.y() -= depth;
  };
}

/// A stack in the last of some steps, in all of which it stands still, before that step is solved.
World at_rest(int boxes, Real dt, int steps) {
  World world = on_two_corners(boxes, Vec3::Constant(Real(0.5)), 100, Vec3::Zero());
  for (int step = 0; step < steps; ++step) {
    if (step > 0) FullSolver{}.solve(world, dt, 10);
    world.contacts_before = world.contacts;
    world.dt_before = dt;
    for (Body& body : world.bodies)
      if (body.movable()) body.velocity += dt * world.gravity;
  }
  return world;
}

template <class ContactSolver>
ContactSolver with(Real beta, Real slop) {
  ContactSolver solver;
  solver.beta = beta;
  solver.slop = slop;
  return solver;
}

/// Divides each step of --dt into two.
template <class ContactSolver>
struct InTwoSteps : ContactSolver {
  explicit InTwoSteps(ContactSolver solver) : ContactSolver(std::move(solver)) {}
  Plan plan(Real /*dt*/) const override { return {.detections = 2}; }
};

}  // namespace

int main(int argc, char** argv) {
  Experiment e("07_warm_start", "What is last step's answer worth?");
  std::vector<int> sweep_counts{1, 2, 3, 5, 8, 10, 15, 20, 30, 50, 80, 120, 200, 400, 800};
  e.parameter({"--sweep-counts", "", "", "Numbers of sweeps for the diagrams", 1, 10000}, &sweep_counts);
  WrongIds wrong_ids;
  e.parameter({"--wrong-ids", "", "", "Shift of stored impulses in the contact list", 0, 100}, &wrong_ids.places);
  int boxes = 10, base = 10;
  e.parameter({"--boxes", "n", "", "Boxes in each stack", 1, 20}, &boxes);
  e.parameter({"--base", "", "", "Boxes in the lowest row of the pyramid", 1, 15}, &base);
  Real depth = Real(0.005);
  e.parameter({"--depth", "", "m", "Initial overlap in the last stack", 0, 0.05}, &depth);
  return e.run(argc, argv, [&] {
    const auto scene = [&e](Scene told) {
      told.seconds = 60;
      const auto fill = told.fill;
      const bool pictures = told.pictures;
      e.scene(std::move(told));
      e.series("drift", "mm", drift_from(fill), true);
      if (!pictures) e.number("drift after 10 s", "mm", [](const Run& run) { return drift_after(run, 10); });
      e.number("drift after 60 s", "mm", [](const Run& run) { return run.series.at("drift").back(); });
      e.number("residual, 1 to 2 s", "m/s",
               [](const Run& run) { return tells_rows(run) ? mean(run, &Sample::residual) : unknown; });
      if (pictures) {
        e.number("overlap, 1 to 2 s", "mm", [](const Run& run) { return 1000 * mean(run, &Sample::overlap); });
        return;
      }
      e.number("kinetic energy, last second", "J", kinetic_in_last_second);
      e.number("energy gained", "J", energy_gained(fill));
    };
    const std::string tall = "a stack of " + spelled(boxes);
    const auto stacked = [boxes](World& world) { stack(world, boxes); };
    const Real middle = static_cast<Real>(boxes) / 10;
    const Camera of_stack{middle * Vec3(7, 7, 14), {0, middle * Real(4.9), 0}, Real(0.68)};

    const auto piled = [base](World& world) { pyramid(world, base); };
    const Real half = static_cast<Real>(base) / 10;
    scene({.name = "a pyramid, " + spelled(base) + " wide, in steps of h/2",
           .fill = piled,
           .camera = {half * Vec3(4, 7, 18), {0, half * Real(4.5), 0}, Real(0.62)},
           .instants = {40},
           .contacts = Drawn::nothing,
           .key = "pyramid",
           .caption = "After 40 s, with the same number of sweeps. The thin outlines are the boxes at the start. Cold, "
                      "the pyramid has collapsed. Warm, it stands. With wrong ids it is coming apart, and will "
                      "collapse within the minute.",
           .start_shown = false,
           .marks = AsBegan(piled),
           .cell_height = 440,
           .in_brief = {{0, 1}},
           .guess = Guess{{0, 1, 2}}});
    e.variant("cold", InTwoSteps(Cold{})).with_sweeps(2).coloured(0);
    e.variant("warm", InTwoSteps(FullSolver{})).with_sweeps(2).coloured(1);
    e.variant("warm, wrong ids", InTwoSteps(wrong_ids)).with_sweeps(2).coloured(2);

    scene({.name = tall + " in steps of h/2",
           .fill = stacked,
           .camera = of_stack,
           .instants = {60},
           .key = "stack",
           .caption = "After a minute, with the same number of sweeps. The thin outlines are the boxes at the start. "
                      "Cold, the stack has fallen. Warm, it stands. With the impulses of neighbouring contacts, it "
                      "sways.",
           .start_shown = false,
           .marks = AsBegan(stacked),
           .cell_height = 520,
           .in_brief = {{0, 1}}});
    e.variant("cold", InTwoSteps(Cold{})).with_sweeps(5).coloured(0);
    e.variant("warm", InTwoSteps(FullSolver{})).with_sweeps(5).coloured(1);
    e.variant("warm, wrong ids", InTwoSteps(wrong_ids)).with_sweeps(5).coloured(2);

    // What falls although it is started warm, and what of it is to blame.
    scene({.name = tall + " in steps of h", .fill = stacked, .camera = of_stack, .pictures = false});
    e.variant("cold", Cold{}).coloured(0);
    e.variant("warm", FullSolver{}).coloured(1);
    e.variant("warm, 20 sweeps", FullSolver{}).with_exactly(20).coloured(2);
    e.variant("warm, without slop", with<FullSolver>(Real(0.2), 0)).coloured(3);
    e.variant("warm, without push-out", with<FullSolver>(0, Real(0.005))).coloured(4);
    scene({.name = fmt::format("the same, begun {:.3g} mm in each other", 1000 * depth),
           .fill = begun_in_each_other(boxes, depth),
           .camera = of_stack,
           .pictures = false});
    e.variant("warm", FullSolver{}).coloured(1);

    const auto tenth_step = [&e](const auto& solver) { return row_by_row(at_rest(3, e.dt(), 10), solver, e.dt(), 8); };
    e.rows("cold", [=] { return tenth_step(Cold{}); });
    e.rows("warm", [=] { return tenth_step(FullSolver{}); });

    e.study([&, tall] {
      const auto study_of = [&](const std::string& name, const auto& solver, std::size_t colour) {
        return study(name, solver, boxes, sweep_counts, e.dt(), colour);
      };
      std::vector<Study> studies{study_of("cold", Cold{}, 0), study_of("warm", FullSolver{}, 1),
                                 study_of("warm, wrong ids", wrong_ids, 2)};
      Panel residual{.title = tall + ", at rest",
                     .x_label = "sweeps",
                     .y_label = "residual, m/s",
                     .log_x = true,
                     .log_y = true,
                     .lines = {{Real(1e-3), "1 mm/s"}},
                     .floor = Real(1e-6)};
      for (Study& s : studies) {
        residual.curves.push_back(std::move(s.residual));
        e.remark(s.verdict);
      }
      e.panel(residual);
    });
  });
}
