// The part of ErrorControl that is about substeps and free bodies.
#include <algorithm>
#include <cmath>
#include <utility>

#include "pushback/common/world/measure.h"
#include "pushback/engine/half_step/gap.h"
#include "pushback/engine/islands/error_control.h"

namespace pushback {

namespace {

constexpr Real horizon = 1;           // s: T
constexpr Real stiffest = Real(1e9);  // Hz, the largest stiffness that substeps hold, 1 / (8 h)
constexpr int most_of_flight = 64;

/// Springs as stiff as the substeps hold, while it lives.
class StiffSprings {
 public:
  explicit StiffSprings(SoftContacts& spring) : spring_(spring), hertz_(std::exchange(spring.hertz, stiffest)) {}
  ~StiffSprings() { spring_.hertz = hertz_; }
  StiffSprings(const StiffSprings&) = delete;
  StiffSprings& operator=(const StiffSprings&) = delete;

 private:
  SoftContacts& spring_;
  Real hertz_;
};

}  // namespace

/// The rotation of a tumbling body is of second order, and its corners must be in the right place.
int ErrorControl::parts_of_flight(const Body& body, const IslandSettings& settings, Real dt) {
  if (std::isinf(settings.error) || !tumbles(body)) return 1;
  const Real reach = reach_of_core(body);
  const auto turned = [&](int parts) {
    Body copy = body;
    for (int i = 0; i < parts; ++i) spin_freely(copy, dt / static_cast<Real>(parts));
    return copy.orientation;
  };
  Quat coarse = turned(1);
  for (int parts = 2;; parts *= 2) {
    const Quat fine = turned(parts);
    const Real off = reach * fine.angularDistance(coarse) / parts_of_difference(2);
    if (off <= settings.error * dt / horizon || parts == most_of_flight) return parts;
    coarse = fine;
  }
}

/// x += h v has an error of h / 2 times the change of v (chapter 24). That and the depth of contacts are known after a step. If they are
/// too large, the step is repeated with more substeps. The first error falls with their number, the second with its square.
SolveStats ErrorControl::step_remaining(RemainingBodies& remaining, World& world, StepClassifier& classifier,
                                        Contacts& found, const SubstepPass& pass) {
  WideSolver<Real>& solver = pass.solver;
  const IslandSettings& settings = pass.settings;
  const auto moves = [&](const Body& body) { return classifier.step_of(body.index) == StepType::substeps; };
  const auto once = [&] { return remaining.step(world, classifier, found, pass); };
  if (std::isinf(settings.error)) return once();
  in_a_second_ *= 1 - std::min(Real(1), pass.dt / horizon);
  sunken_ = 0;
  met_.assign(world.bodies.size(), false);
  if (std::none_of(world.bodies.begin(), world.bodies.end(), moves)) return once();
  const World before = world;
  const Contacts all = found;
  SolveStats solved;
  const auto stiffly = [&] { return step_stiffly(remaining, world, before, classifier, found, pass, solved); };
  Real largest = stiffly();
  const Real off = substep_error(largest, settings.error);
  if (off > 1 && solver.substeps < settings.most_substeps) {
    for (Real left = off; left > 1 && solver.substeps < settings.most_substeps; left /= 2) solver.substeps *= 2;
    solver.substeps = std::min(solver.substeps, settings.most_substeps);
    world = before;
    found = all;
    largest = stiffly();
  } else if (fewer_will_do(off, 2)) {
    solver.substeps = std::max(least_substeps, solver.substeps / 2);
  }
  in_a_second_ += largest;
  find_meetings(all, before, world, classifier, pass);
  return solved;
}

/// Returns the largest error of the step, m, and sets the errors of the bodies.
Real ErrorControl::step_stiffly(RemainingBodies& remaining, World& world, const World& before,
                                const StepClassifier& classifier, Contacts& found, const SubstepPass& pass,
                                SolveStats& solved) {
  {
    const StiffSprings springs(pass.solver.spring);
    solved = remaining.step(world, classifier, found, pass);
  }
  const Real half = pass.dt / static_cast<Real>(2 * pass.solver.plan(pass.dt).all_substeps());
  const auto moves = [&](int body) { return classifier.step_of(body) == StepType::substeps; };
  Real largest = 0;
  for (std::size_t i = 0; i < world.bodies.size(); ++i) {
    if (!moves(static_cast<int>(i))) continue;
    bodies_[i].step_x = half * (world.bodies[i].velocity - before.bodies[i].velocity);
    largest = std::max(largest, bodies_[i].step_x.norm());
  }
  sunken_ = sunken(world, moves);
  return largest;
}

/// Marks islands in which something has bounced, or in which joined bodies approached faster than a step of fall makes them, and do so no
/// more.
void ErrorControl::find_meetings(const Contacts& found, const World& before, const World& after,
                                 StepClassifier& classifier, const SubstepPass& pass) {
  const auto meet = [&](const Contact& contact) {
    for (const std::size_t body : {contact.id.body_a, contact.id.body_b})
      if (after.bodies[body].movable()) met_[std::size_t(classifier.island_of(static_cast<int>(body)))] = true;
  };
  for (const Contact& contact : after.contacts)
    if (contact.restitution > 0 && !contact.impulse.isZero(0) &&
        separating_speed(before, contact) < -pass.solver.threshold)
      meet(contact);
  std::vector<bool> is_joined(after.bodies.size());
  for (const Joint& joint : after.joints)
    for (const int body : {joint.a, joint.b})
      if (body != the_world) is_joined[std::size_t(body)] = true;
  for (const Contact& contact : found) {
    const Real came = separating_speed(before, contact);
    if ((is_joined[contact.id.body_a] || is_joined[contact.id.body_b]) && came <= -pass.dt * after.gravity.norm() &&
        separating_speed(after, contact) >= came / 2)
      meet(contact);
  }
}

}  // namespace pushback
