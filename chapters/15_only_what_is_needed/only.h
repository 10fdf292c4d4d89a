/// The solver and the step with those effects that a scene calls for, and nothing else in the program.
#pragma once

#include "chapters/05_restitution/from_surface.h"
#include "chapters/05_restitution/in_turn.h"
#include "chapters/06_friction/friction.h"
#include "chapters/09_joints/joints.h"
#include "chapters/15_only_what_is_needed/questions.h"

namespace pushback {

// ---- without a yes to its question, an effect would do nothing ---------------------------------------------------------

/// Yes to one of these is enough.
template <class E>
struct DependsOn {
  using questions = CalledFor<Touching>;
};
template <RelaxingEffect E>
struct DependsOn<E> {
  using questions = CalledFor<Touching, Holding>;  // joints are relaxed as well
};
template <std::derived_from<Joints> E>
struct DependsOn<E> {
  using questions = CalledFor<Holding>;
};
template <std::derived_from<Friction> E>
struct DependsOn<E> {
  using questions = CalledFor<Rubbing>;
};
template <class E>
  requires std::derived_from<E, Restitution> || std::derived_from<E, RestitutionFromSurface> ||
           std::derived_from<E, ImpactsInTurn>
struct DependsOn<E> {
  using questions = CalledFor<Bouncing>;
};

template <class Called, class... Questions>
constexpr bool has_one_of(CalledFor<Questions...>) {
  return (Called::template has<Questions> || ...);
}

// ---- Only<FullSolver, CalledFor<Touching, Bouncing>> is FullSolver without Friction ----------------------------------------

template <class Called, class Kept, class... Rest>
struct Keep {
  using type = Kept;
};
template <class Called, class... Kept, class E, class... Rest>
struct Keep<Called, Solver<Kept...>, E, Rest...> {
  static constexpr bool needed = has_one_of<Called>(typename DependsOn<E>::questions{});
  using with = std::conditional_t<needed, Solver<Kept..., E>, Solver<Kept...>>;
  using type = typename Keep<Called, with, Rest...>::type;
};

template <class Full, class Called>
struct OnlyOf {  // not composed of effects: there is nothing to leave out
  using type = Full;
};
template <class... Effects, class Called>
struct OnlyOf<Solver<Effects...>, Called> {
  using type = typename Keep<Called, Solver<>, Effects...>::type;
};
template <class Full, class Called>
using Only = typename OnlyOf<Full, Called>::type;

/// What is left of `full`, with the same settings and the same memory.
template <class Called, class Full>
Only<Full, Called> only(const Full& full) {
  if constexpr (std::same_as<Only<Full, Called>, Full>) {
    return full;
  } else {
    Only<Full, Called> left;
    [&]<class... Left>(Solver<Left...>& its) {
      ((static_cast<Left&>(its) = static_cast<const Left&>(full)), ...);
    }(left);
    return left;
  }
}
/// And back into the whole.
template <class Full, class Left>
void put_back(const Left& left, Full& full) {
  if constexpr (std::same_as<Left, Full>) {
    full = left;
  } else {
    [&]<class... Kept>(const Solver<Kept...>& its) {
      ((static_cast<Kept&>(full) = static_cast<const Kept&>(its)), ...);
    }(left);
  }
}

// ---- the order of a step, as World has it ---------------------------------------------------------------------------------

/// What each body does by itself: World's `push` and `move`, less what nobody calls for.
template <class Called>
struct Integrator {
  static void begin(Body& body) {
    if constexpr (Called::template has<Bouncing>) begin_step(body);
  }
  static void push(Body& body, const Vec3& gravity, Real dt) {
    if constexpr (Called::template has<Pulling>) {
      pushback::push(body, gravity, dt);
    } else if (body.movable()) {  // a force of 0 makes 0 of -0, and so does this
      body.velocity += dt * (gravity + Vec3::Zero());
      body.angular_velocity += Vec3::Zero();
    }
  }
  static void move(Body& body, Real dt) {
    if constexpr (Called::template has<Tumbling>) {
      pushback::move(body, dt);
    } else {
      body.position += dt * body.velocity;
      if (body.angular_velocity != Vec3::Zero()) spin_evenly(body, dt);
    }
  }
};

/// Is there anything to be solved?
template <class Called>
inline constexpr bool solving = has_one_of<Called>(CalledFor<Touching, Holding>{});

/// What touches or is joined is solved. Where nothing can touch, nothing is left of what did before: no contacts, and no
/// memory of them.
template <class Called, class ContactSolver>
void solve_only(World& world, ContactSolver& solver, Real dt, int sweeps) {
  if constexpr (!Called::template has<Touching>) {
    world.contacts.clear();
    if constexpr (requires { solver.forget(); }) solver.forget();
  }
  if constexpr (Called::template has<Holding> && JointSolver<ContactSolver>) solver.hold(world, dt);
  if constexpr (solving<Called>) solver.solve(world.contacts, dt, sweeps);
}

/// Time, and where a solver has something to do after the bodies have moved, that.
template <class Called, class ContactSolver>
void end_step(World& world, ContactSolver& solver, Real dt) {
  world.time += dt;
  if constexpr (solving<Called> && requires { solver.relax(world.contacts); }) solver.relax(world.contacts);
  if constexpr (solving<Called> && requires { solver.correct(); }) solver.correct();
}

/// World::step of what is called for. `ContactSolver`: see World::step.
template <class Called, class ContactSolver>
void step_only(World& world, ContactSolver& solver, Real dt, int sweeps = 10) {
  check_step(dt, sweeps, world.gravity);
  for (const Body& body : world.bodies) check_state(body);
  if constexpr (!JointSolver<ContactSolver>) check_no_joints(world.joints);
  for (Body& body : world.bodies) Integrator<Called>::begin(body);
  if constexpr (Called::template has<Pulling>) {
    for (const Force& force : world.forces) force.apply(world);
  }
  for (Body& body : world.bodies) Integrator<Called>::push(body, world.gravity, dt);
  if constexpr (Called::template has<Touching>) world.find_contacts();
  solve_only<Called>(world, solver, dt, sweeps);
  for (Body& body : world.bodies) Integrator<Called>::move(body, dt);
  end_step<Called>(world, solver, dt);
}

}  // namespace pushback
