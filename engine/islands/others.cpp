/// What `many` moves, while everybody else stands still.
#include "pushback/common/basics/input.h"
#include "pushback/common/world/step.h"
#include "pushback/engine/islands/by_island.h"

namespace pushback {

namespace {

/// Who is left to `many`, in a world whose contacts have been found.
struct Others {
  const Calls& calls;
  Contacts& found;
  bool are_found = true;  // only those of the first detection are

  static void check(const World&) {}
  void find_contacts(World& world, const Margin& margin) {
    if (are_found) world.contacts.swap(found);
    else find_again(world, margin);
    are_found = false;
  }
  void find_again(World& world, const Margin& margin) const {
    world.find_contacts(margin);
    std::erase_if(world.contacts, [&](const Contact& contact) {
      const auto [a, b] = world.bodies_of(contact);
      const auto stands = [this](const Body& body) {  // while these are moved: it has its own step
        return body.movable() && calls.of(body.index) != MovedBy::substeps;
      };
      return stands(a) || stands(b);
    });
  }
  template <class Act>
  void each(World& world, const Act& act) const {
    for (Body& body : world.bodies)
      if (!body.movable() || calls.of(body.index) == MovedBy::substeps) act(body);
  }
  static void end(World&, Real /*dt*/) {}
};

/// The same with contacts detected `times` in a step.
class DetectedAgain : public ForwardingSolver {
 public:
  DetectedAgain(StepSolver& solver, int times) : solver_(solver), times_(times) {}
  Plan plan(Real dt) const override {
    Plan plan = solver_.plan(dt / static_cast<Real>(times_));
    plan.detections = times_;
    return plan;
  }

 private:
  StepSolver& inner() override { return solver_; }
  const StepSolver& inner() const override { return solver_; }
  StepSolver& solver_;
  int times_;
};

}  // namespace

void ByIsland::move_others(World& world, Real dt, int sweeps) {
  const auto by_many = [this](const Body& body) { return calls_.of(body.index) == MovedBy::substeps; };
  if (std::none_of(world.bodies.begin(), world.bodies.end(), by_many)) {
    world.contacts_before.swap(world.contacts);
    world.contacts.clear();
    for (Body& body : world.bodies) {
      if (body.movable()) continue;
      keep_velocity(body);
      integrate_velocity(body, world.gravity, dt);  // which clears its forces
      move(body, dt);
    }
    world.time += dt;
    world.dt_before = dt / static_cast<Real>(many.plan(dt).all_substeps());
    return;
  }
  std::erase_if(found_, [&](const Contact& contact) {
    const auto [a, b] = world.bodies_of(contact);
    return !by_many(a.movable() ? a : b) || contact.id.feature == beside;
  });
  Real fastest = 0;
  for (const Body& body : world.bodies)
    if (by_many(body)) fastest = std::max(fastest, body.angular_velocity.norm());
  for (detections_ = 1;
       2 * detections_ <= limits.most_detections && fastest * dt > limits.turn * static_cast<Real>(detections_);)
    detections_ *= 2;
  joints_.swap(world.joints);
  std::vector<std::size_t> lent;
  for (std::size_t i = 0; i < joints_.size(); ++i) {
    const Body &a = world.body(joints_[i].a), &b = world.body(joints_[i].b);
    if (!by_many(a.movable() ? a : b)) continue;
    world.joints.push_back(std::move(joints_[i]));
    lent.push_back(i);
  }
  velocities_.clear();
  for (Body& body : world.bodies) {
    velocities_.emplace_back(body.velocity, body.angular_velocity);
    if (body.movable() && !by_many(body)) body.velocity = body.angular_velocity = Vec3::Zero();
  }
  const auto give_back = [&] {
    for (std::size_t i = 0; i < lent.size(); ++i) joints_[lent[i]] = std::move(world.joints[i]);
    joints_.swap(world.joints);
    joints_.clear();
    for (Body& body : world.bodies) {
      if (!body.movable() || by_many(body)) continue;
      std::tie(body.velocity, body.angular_velocity) = velocities_[std::size_t(body.index)];
    }
  };
  try {
    Others others{calls_, found_};
    DetectedAgain solver(inner(), detections_);
    pushback::step(world, solver, dt, sweeps, others);
  } catch (const InvalidInput&) {
    give_back();
    throw;
  }
  give_back();
  add_up(inner().solved());
}

}  // namespace pushback
