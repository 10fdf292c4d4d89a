#include "pushback/chapters/20_only_what_is_needed/dispatch.h"

namespace pushback {

void OnlyWhatIsNeeded::fit(const World& world) {
  solver_.fit(world);
  look(world);
}

void OnlyWhatIsNeeded::step(World& world, Real dt, std::optional<int> sweeps) {
  const bool as_it_was =
      world.bodies.size() == bodies_ && world.forces.size() == forces_ && world.joints.size() == joints_;
  if (!as_it_was) fit(world);
  const Plan plan = solver_.plan(dt);
  all_bodies_.workers = &plan.workers->of_bodies(world.bodies.size());
  if (!sleep && solver_.divides_worlds()) solver_.whole_step(world, dt, sweeps.value_or(plan.sweeps));
  else if (sleep) pushback::step(world, solver_, dt, sweeps.value_or(plan.sweeps), *sleep);
  else pushback::step(world, solver_, dt, sweeps.value_or(plan.sweeps), all_bodies_);
}

void OnlyWhatIsNeeded::look(const World& world) {
  for (const Force& force : world.forces) check_bodies_of(force, world);
  all_bodies_.touching = NeedsContacts::in(world).yes;
  bodies_ = world.bodies.size();
  forces_ = world.forces.size();
  joints_ = world.joints.size();
}

}  // namespace pushback
