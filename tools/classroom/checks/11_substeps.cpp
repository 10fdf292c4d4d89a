#include "pushback/chapters/07_warm_start/full_solver.h"
#include "pushback/chapters/11_substeps/exercise/asked.h"
#include "pushback/common/exercise/shown.h"

namespace pushback::exercise_11 {

void Parts::add_gravity(Real seconds) {
  for (Body& body : world_.bodies) {
    keep_velocity(body);
    integrate_velocity(body, world_.gravity, seconds);
  }
}
void Parts::detect() {
  world_.contacts_before.swap(world_.contacts);
  world_.find_contacts();
}
void Parts::solve(Real seconds, Real scale) {
  world_.dt_before = seconds / scale;
  FullSolver().solve(world_, seconds, 1);
}
void Parts::move(Real seconds) {
  world_.move(seconds);
}

namespace {

/// A frame of some length, in some substeps, after one that was of another.
struct Frame {
  Real dt, before;
  int count;
  explicit Frame(Random& random)
      : dt(1 / random.between(50, 70)),
        before(dt * random.between(Real(0.6), Real(0.9))),
        count(4 + static_cast<int>(random.below(5))) {}
  Real substep() const { return dt / static_cast<Real>(count); }
  void simulate(World& world, const Answer& answer) const {
    Parts parts(world);
    answer.frame(parts, dt, count, before);
    show(world);
  }
};

/// A ball and the ground below it.
World ball(Random& random, Real depth, Real fall) {
  const Real radius = random.between(Real(0.3), Real(0.5));
  World world;
  world.add(ground());
  world.add(sphere(radius, random.between(5, 20)).at({0, radius - depth, 0}).moving({0, -fall, 0}));
  return world;
}

std::vector<Check<Answer>> checks() {
  return {
      {"a ball that falls freely falls along g h² k (k + 1) / 2",
       1,
       {{"your ball, which falls freely from rest, falls with", "m/s", 1e-6},
        {"your ball, which falls freely from rest, has fallen by", "mm", 1e-5}},
       [](Random& random, const Answer& answer) -> Numbers {
         const Frame frame(random);
         World world = ball(random, -2, 0);
         const Real top = world.bodies[1].position.y();
         frame.simulate(world, answer);
         return {-world.bodies[1].velocity.y(), 1000 * (top - world.bodies[1].position.y())};
       }},
      {"a ball that is too deep is pushed out at β (d − slop) / h, with h of the substep",
       1,
       {{"your ball, which weighs nothing and is too deep, leaves with", "m/s", 1e-6}},
       [](Random& random, const Answer& answer) -> Numbers {
         const Frame frame(random);
         World world = ball(random, random.between(Real(0.02), Real(0.04)), 0);
         world.gravity.setZero();
         frame.simulate(world, answer);
         return {world.bodies[1].velocity.y()};
       }},
      {"a ball that arrives within the frame is stopped within it",
       1,
       {{"your ball, which is thrown at the ground and arrives in the frame, ends it with", "m/s", 1e-5},
        {"your ball, which is thrown at the ground, ends the frame deep by", "mm", 1e-4}},
       [](Random& random, const Answer& answer) -> Numbers {
         const Frame frame(random);
         const Real fall = random.between(8, 10);
         const Real gap =
             fall * frame.substep() * random.between(Real(1.2), Real(1.5));  // the second substep takes it in
         World world = ball(random, -gap, fall);
         const Real rest = world.bodies[1].position.y() - gap;
         frame.simulate(world, answer);
         return {world.bodies[1].velocity.y(), 1000 * (rest - world.bodies[1].position.y())};
       }},
      {"a column at rest stays at rest, also where substeps become longer or shorter",
       2,
       {{"the top of your column, which was at rest, moves with", "m/s", 1e-6},
        {"in the last substep the ground carries your column, which was at rest, with", "N s", 1e-4}},
       [](Random& random, const Answer& answer) -> Numbers {
         const Frame frame(random);
         constexpr Real radius = Real(0.5);
         World world;
         world.add(ground());
         for (int i = 0; i < 3; ++i)
           world.add(
               sphere(radius, random.between(5, 20))
                   .at({0, radius + static_cast<Real>(i) * 2 * radius - static_cast<Real>(i + 1) * Real(1e-4), 0}));
         world.find_contacts();
         for (Contact& contact : world.contacts) {  // each carries what is above it
           Real mass = 0;
           for (std::size_t above = contact.id.body_b; above < world.bodies.size(); ++above)
             mass += 1 / world.bodies[above].inverse_mass;
           contact.impulse = mass * World::g * frame.before * contact.normal;
         }
         frame.simulate(world, answer);
         return {world.bodies[3].velocity.y(), world.contacts.empty() ? 0 : world.contacts[0].impulse.y()};
       }},
  };
}

/// The loop that the mistakes are made in: `substep(h, scale)` for each, with what it should be called with.
template <class Substep>
void loop(Real dt, int count, Real before, const Substep& substep) {
  const Real h = dt / static_cast<Real>(count);
  for (int i = 0; i < count; ++i) {
    substep(h, h / before);
    before = h;
  }
}

void always_scaled_by(Real scale, Parts& parts, Real dt, int count) {
  loop(dt, count, dt, [&](Real h, Real) {
    parts.add_gravity(h);
    parts.detect();
    parts.solve(h, scale);
    parts.move(h);
  });
}

/// The chapter's substeps, part by part: what a contact's impulse then is, is that of the last substep.
void right(Parts& parts, Real dt, int count, Real before) {
  loop(dt, count, before, [&](Real h, Real scale) {
    parts.add_gravity(h);
    parts.detect();
    parts.solve(h, scale);
    parts.move(h);
  });
}

std::vector<Mistake<Answer>> mistakes() {
  const std::string once =
      "it looks as if all of the frame's gravity were added before the first substep. The speed at the end is the "
      "same, but the bodies fall at it from the start, and the first sweep has the error of a whole step to undo.";
  const std::string not_rescaled =
      "it looks as if the impulses were not rescaled. What carried a weight for `before` seconds is too much for a "
      "shorter substep, and the column is thrown up: an impulse is a force times a time.";
  const std::string a_substep =
      "it looks as if there were not `count` substeps. `count` of them, each of dt / count seconds, make up the frame.";
  const std::string moved_first =
      "it looks as if gravity were added after the move. Each substep moves the bodies by the velocity that it ends "
      "with: gravity, contacts, solver, move.";
  return {
      {"gravity after the move", moved_first, {[](Parts& parts, Real dt, int count, Real before) {
         loop(dt, count, before, [&](Real h, Real scale) {
           parts.detect();
           parts.solve(h, scale);
           parts.move(h);
           parts.add_gravity(h);
         });
       }}},
      {"detected after the move",
       "it looks as if contacts were detected after the move, and the first substep had none of its own. A substep "
       "solves what touches as it begins: detect before solve.",
       {[](Parts& parts, Real dt, int count, Real before) {
         loop(dt, count, before, [&](Real h, Real scale) {
           parts.add_gravity(h);
           parts.solve(h, scale);
           parts.move(h);
           parts.detect();
         });
       }}},
      {"another number of substeps", a_substep, {[](Parts& parts, Real dt, int count, Real before) {
         const Real h = dt / static_cast<Real>(count);
         right(parts, dt - h, count - 1, before);
       }}},
      {"another number of substeps", a_substep, {[](Parts& parts, Real dt, int count, Real before) {
         const Real h = dt / static_cast<Real>(count);
         right(parts, dt + h, count + 1, before);
       }}},
      {"solved twice",
       "it looks as if a substep solved more than once. One sweep a substep: the next substep goes on from what is "
       "kept.",
       {[](Parts& parts, Real dt, int count, Real before) {
         loop(dt, count, before, [&](Real h, Real scale) {
           parts.add_gravity(h);
           parts.detect();
           parts.solve(h, scale);
           parts.solve(h, 1);
           parts.move(h);
         });
       }}},
      {"gravity once a frame", once, {[](Parts& parts, Real dt, int count, Real before) {
         parts.add_gravity(dt);
         loop(dt, count, before, [&](Real h, Real scale) {
           parts.detect();
           parts.solve(h, scale);
           parts.move(h);
         });
       }}},
      {"the frame's gravity in each substep",
       "it looks as if each substep added the gravity of the whole frame.",
       {[](Parts& parts, Real dt, int count, Real before) {
         loop(dt, count, before, [&](Real h, Real scale) {
           parts.add_gravity(dt);
           parts.detect();
           parts.solve(h, scale);
           parts.move(h);
         });
       }}},
      {"impulses not rescaled", not_rescaled, {[](Parts& parts, Real dt, int count, Real) {
         always_scaled_by(1, parts, dt, count);
       }}},
      {"rescaled in each substep",
       "it looks as if every substep scaled by h / `before`. The second one starts from the impulses of the first, "
       "which was as long as itself: `before` is then h.",
       {[](Parts& parts, Real dt, int count, Real before) {
         loop(dt, count, before, [&](Real h, Real) {
           parts.add_gravity(h);
           parts.detect();
           parts.solve(h, h / before);
           parts.move(h);
         });
       }}},
      {"scale upside down",
       "it looks as if the scale were upside down. A shorter substep needs less: new length over old length.",
       {[](Parts& parts, Real dt, int count, Real before) {
         loop(dt, count, before, [&](Real h, Real scale) {
           parts.add_gravity(h);
           parts.detect();
           parts.solve(h, 1 / scale);
           parts.move(h);
         });
       }}},
      {"scaled as if the last step were a frame",
       "it looks as if the impulses were scaled by 1 / count, as if they were of a step of `dt`. They are of one of "
       "`before` seconds.",
       {[](Parts& parts, Real dt, int count, Real) {
         loop(dt, count, dt, [&](Real h, Real scale) {
           parts.add_gravity(h);
           parts.detect();
           parts.solve(h, scale);
           parts.move(h);
         });
       }}},
      {"nothing remembered",
       "it looks as if every substep started from impulses of 0. One sweep is not enough then; substeps share their "
       "work only by what they remember.",
       {[](Parts& parts, Real dt, int count, Real) { always_scaled_by(0, parts, dt, count); }}},
      {"dt of the frame in b",
       "it looks as if b were made with the frame's dt. The push-out is to undo the part β in one step, and the step "
       "is a substep now.",
       {[](Parts& parts, Real dt, int count, Real before) {
         loop(dt, count, before, [&](Real h, Real scale) {
           parts.add_gravity(h);
           parts.detect();
           parts.solve(dt, scale);
           parts.move(h);
         });
       }}},
      {"detected once a frame",
       "it looks as if contacts were detected once, before the first substep. A ball that arrives later meets nothing, "
       "and one that is pushed out is pushed as if it were still where it was.",
       {[](Parts& parts, Real dt, int count, Real before) {
         parts.detect();
         loop(dt, count, before, [&](Real h, Real scale) {
           parts.add_gravity(h);
           parts.solve(h, scale);
           parts.move(h);
         });
       }}},
      {"moved by dt in each substep",
       "it looks as if each substep moved the bodies by the time of the whole frame.",
       {[](Parts& parts, Real dt, int count, Real before) {
         loop(dt, count, before, [&](Real h, Real scale) {
           parts.add_gravity(h);
           parts.detect();
           parts.solve(h, scale);
           parts.move(dt);
         });
       }}},
      {"moved once a frame",
       "it looks as if the bodies were moved once, after the last substep. Then all substeps see the same positions: "
       "they are sweeps of one step, and no more.",
       {[](Parts& parts, Real dt, int count, Real before) {
         loop(dt, count, before, [&](Real h, Real scale) {
           parts.add_gravity(h);
           parts.detect();
           parts.solve(h, scale);
         });
         parts.move(dt);
       }}},
      {"steps of dt",
       "it looks as if each substep were as long as the frame. `count` of them make up `dt`.",
       {[](Parts& parts, Real dt, int count, Real before) {
         for (int i = 0; i < count; ++i) {
           parts.add_gravity(dt);
           parts.detect();
           parts.solve(dt, dt / before);
           before = dt;
           parts.move(dt);
         }
       }}},
      {"gravity after the solver",
       "it looks as if gravity were added when the solver was done. Then every body moves on with the g h that nothing "
       "has held.",
       {[](Parts& parts, Real dt, int count, Real before) {
         loop(dt, count, before, [&](Real h, Real scale) {
           parts.detect();
           parts.solve(h, scale);
           parts.add_gravity(h);
           parts.move(h);
         });
       }}},
      {"moved before the solver",
       "it looks as if the bodies were moved before the solver had changed their velocities. The order is gravity, "
       "solver, move.",
       {[](Parts& parts, Real dt, int count, Real before) {
         loop(dt, count, before, [&](Real h, Real scale) {
           parts.add_gravity(h);
           parts.move(h);
           parts.detect();
           parts.solve(h, scale);
         });
       }}},
  };
}

}  // namespace

Numbers play(std::size_t check, Random& random, const Answer& answer) {
  return checks()[check].play(random, answer);
}

Exercise exercise() {
  return exercise_of<Answer>(
      "the loop of substeps",
      {"All four parts belong into the loop: gravity, contacts, solver, move. Each is for h = dt / count seconds.",
       "The impulses that a substep starts from are of the one before: scale = h / length of that one.",
       "The first substep's scale is h / before. All others follow one of their own length: set before = h in the "
       "loop."},
      checks(), {right}, mistakes());
}

}  // namespace pushback::exercise_11
