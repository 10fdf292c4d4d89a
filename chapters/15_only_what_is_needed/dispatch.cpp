#include "chapters/15_only_what_is_needed/dispatch.h"

namespace pushback {

void OnlyWhatIsNeeded::fit(const World& world) {
  solver_.fit(world);
  choose_step(world);
}

void OnlyWhatIsNeeded::step(World& world, Real dt, int sweeps) {
  const bool as_it_was =
      world.bodies.size() == bodies_ && world.forces.size() == forces_ && world.joints.size() == joints_;
  if (!as_it_was) fit(world);
  if (sleep) step_awake_(world, solver_, *sleep, dt, sweeps);
  else step_all_(world, solver_, dt, sweeps);
}

void OnlyWhatIsNeeded::choose_step(const World& world) {
  const auto choose = [this](auto called) {
    step_all_ = step_only<decltype(called), FittingSolver>;
    step_awake_ = step_awake<decltype(called), FittingSolver>;
  };
  with_answers(world, choose, EveryQuestion{}, CalledFor<>{});
  bodies_ = world.bodies.size();
  forces_ = world.forces.size();
  joints_ = world.joints.size();
}

}  // namespace pushback
