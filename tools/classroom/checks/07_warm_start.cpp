#include "pushback/chapters/07_warm_start/exercise/asked.h"
#include "pushback/chapters/07_warm_start/warm_start.h"
#include "pushback/common/exercise/shown.h"

namespace pushback::exercise_07 {

namespace {

using Warm = Solver<Clamping, Friction, AnyEffect>;

/// Balls that touch the ground, and what their contacts did one step before.
struct Balls {
  World world;
  Real h;

  explicit Balls(Random& random) : h(1 / random.between(50, 240)) {
    world.add(ground());
    world.dt_before = h;
  }
  /// A ball that gravity has just pulled for this step. Returns its weight for the step, N s.
  Real add(Random& random) {
    const Real radius = random.between(Real(0.2), Real(0.5)), mass = random.between(5, 20);
    const Vec3 place = place_of(static_cast<std::uint32_t>(world.bodies.size()));
    world.add(sphere(radius, mass).at(place + radius * Vec3::UnitY()).moving(h * world.gravity));
    return mass * World::g * h;
  }
  static Vec3 place_of(std::uint32_t ball) { return {2 * static_cast<Real>(ball - 1), 0, 0}; }
  static Contact of(std::uint32_t ball, const Vec3& impulse, std::uint32_t feature = 0) {
    return {.point = place_of(ball),
            .normal = Vec3::UnitY(),
            .friction = Real(0.5),
            .id = {0, ball, feature},
            .impulse = impulse};
  }
  void touches(std::uint32_t ball, std::uint32_t feature = 0) {
    world.contacts.push_back(of(ball, Vec3::Zero(), feature));
  }
  void touched(std::uint32_t ball, const Vec3& impulse, std::uint32_t feature = 0) {
    world.contacts_before.push_back(of(ball, impulse, feature));
  }
  void solve(const Answer& answer, int sweeps, const std::vector<std::size_t>& quantities = {}) {
    with_effect<Warm>(answer.warm_start).solve(world, h, sweeps);
    show(world, quantities);
  }
  Vec3 velocity(std::size_t ball) const { return world.bodies[ball].velocity; }
};

std::vector<Check<Answer>> checks() {
  return {
      {"a guess that is too large is taken back, and nothing more",
       1,
       {{"your ball, which rested and now is thrown upwards, leaves with", "m/s", 1e-6},
        {"your ball, which should stay at rest, moves with", "m/s", 1e-6},
        {"the row of your ball at rest ends the step with", "N s", 1e-4}},
       [](Random& random, const Answer& answer) -> Numbers {
         Balls balls(random);
         const Real part = random.between(Real(1.2), Real(1.6)), upwards = random.between(Real(0.4), Real(0.8));
         for (const std::uint32_t ball : {1u, 2u}) {
           balls.touched(ball, part * balls.add(random) * Vec3::UnitY());
           balls.touches(ball);
         }
         balls.world.bodies[2].velocity *= -upwards;
         balls.solve(answer, 1);
         return {balls.velocity(2).y(), balls.velocity(1).y(), balls.world.contacts[0].impulse.y()};
       }},
      {"before the first sweep the ball already has what its contact had",
       1,
       {{"before the first sweep your ball moves with", "m/s", 1e-6},
        {"before the first sweep its row has", "N s", 1e-4}},
       [](Random& random, const Answer& answer) -> Numbers {
         Balls balls(random);
         const Real weight = balls.add(random), part = random.between(Real(0.5), Real(0.8));
         balls.touches(1);
         balls.touched(1, part * weight * Vec3::UnitY());
         balls.solve(answer, 0);
         return {balls.velocity(1).y(), balls.world.contacts[0].impulse.y()};
       }},
      {"each contact has what was its own, though others have come and gone",
       2,
       {{"before the first sweep your first ball, whose neighbour is gone, moves with", "m/s", 1e-6},
        {"before the first sweep your second ball, which touches for the first time, moves with", "m/s", 1e-6},
        {"before the first sweep your third ball, which touched before, moves with", "m/s", 1e-6}},
       [](Random& random, const Answer& answer) -> Numbers {
         Balls balls(random);
         Numbers weight;
         while (weight.size() < 4) weight.push_back(balls.add(random));
         const Real part = random.between(Real(0.5), Real(0.8));
         // Bodies 1 to 4. Body 1 has left, body 3 is new.
         for (const std::uint32_t ball : {1u, 2u, 4u}) balls.touched(ball, part * weight[ball - 1] * Vec3::UnitY());
         for (const std::uint32_t ball : {2u, 3u, 4u}) balls.touches(ball);
         balls.solve(answer, 0);
         return {balls.velocity(2).y(), balls.velocity(3).y(), balls.velocity(4).y()};
       }},
      {"two points of the same two bodies are not mixed up",
       1,
       {{"before the first sweep your upper box moves with", "m/s", 1e-6},
        {"before the first sweep your upper box turns with", "rad/s", 1e-6},
        {"before the first sweep your lower box, on which it lies, moves with", "m/s", 1e-6},
        {"before the first sweep your lower box, on which it lies, turns with", "rad/s", 1e-6}},
       [](Random& random, const Answer& answer) -> Numbers {
         Balls balls(random);
         const Real half = random.between(Real(0.3), Real(0.5)), mass = random.between(50, 150);
         for (const Real height : {half, 3 * half})
           balls.world.add(box(Vec3::Constant(half), mass).at({0, height, 0}).moving(balls.h * balls.world.gravity));
         const Real weight = mass * World::g * balls.h, left = random.between(Real(0.1), Real(0.2)) * weight;
         for (const std::uint32_t corner : {0u, 1u}) {
           const Vec3 point(corner == 0 ? -half : half, 2 * half, 0);
           Contact old = Balls::of(2, (corner == 0 ? left : 3 * left) * Vec3::UnitY(), corner);
           old.id.body_a = 1;
           old.point = Vec3(-point.x(), point.y(), 0);  // the box has turned since: only the id says which is which
           balls.world.contacts_before.push_back(old);
           Contact now = Balls::of(2, Vec3::Zero(), corner);
           now.id.body_a = 1;
           now.point = point;
           balls.world.contacts.push_back(now);
         }
         balls.solve(answer, 0);
         return {balls.velocity(2).y(), balls.world.bodies[2].angular_velocity.z(), balls.velocity(1).y(),
                 balls.world.bodies[1].angular_velocity.z()};
       }},
      {"a force stays the same when the step gets shorter or longer",
       2,
       {{"in a step that is shorter your ball, which should stay at rest, starts with", "m/s", 1e-6},
        {"in a step that is longer your ball, which should stay at rest, starts with", "m/s", 1e-6},
        {"in the shorter step its row starts with", "N s", 1e-4}},
       [](Random& random, const Answer& answer) -> Numbers {
         Numbers numbers;
         Real guess = 0;
         for (const bool longer : {false, true}) {
           Balls balls(random);
           const Real weight = balls.add(random), ratio = random.between(Real(0.3), Real(0.6));  // h_new / h_old
           balls.world.dt_before = longer ? ratio * balls.h : balls.h / ratio;
           balls.touches(1);
           balls.touched(1, weight * balls.world.dt_before / balls.h * Vec3::UnitY());
           if (longer) balls.solve(answer, 0, {1});
           else balls.solve(answer, 0, {0, 2});
           numbers.push_back(balls.velocity(1).y());
           if (!longer) guess = balls.world.contacts[0].impulse.y();
         }
         numbers.push_back(guess);
         return numbers;
       }},
      {"the impulse is a vector: where the normal has turned, each row takes its part",
       2,
       {{"before the first sweep your ball, whose contact has turned, moves along x with", "m/s", 1e-6},
        {"before the first sweep your ball, whose contact has turned, moves along y with", "m/s", 1e-6},
        {"before the first sweep your ball, whose contact has turned, moves along z with", "m/s", 1e-6},
        {"before the first sweep your second ball, whose contact has turned, moves along x with", "m/s", 1e-6},
        {"before the first sweep your second ball, whose contact has turned, moves along z with", "m/s", 1e-6}},
       [](Random& random, const Answer& answer) -> Numbers {
         Balls balls(random);
         for (const std::uint32_t ball : {1u, 2u}) {
           const Real weight = balls.add(random), side = ball == 1 ? 1 : -1;
           const Real along = random.between(Real(0.1), Real(0.2)), across = random.between(Real(0.1), Real(0.2));
           balls.touched(ball, weight * Vec3(along, Real(0.8), side * across));
           balls.touches(ball);
           const Real lean = random.between(Real(0.3), Real(0.4)), aside = random.between(Real(0.1), Real(0.2));
           balls.world.contacts.back().normal = Vec3(side * lean, 1, aside).normalized();
         }
         balls.solve(answer, 0);
         return {balls.velocity(1).x(), balls.velocity(1).y(), balls.velocity(1).z(), balls.velocity(2).x(),
                 balls.velocity(2).z()};
       }},
  };
}

/// A mistake is what it does with a row, whose contact was there one step before.
template <class Start>
struct Mistaken : Effect {
  Start start_row;
  void start(StepContext& step) {
    for (Row& row : step.rows)
      for (const Contact& old : step.world.contacts_before)
        if (old.id == step.contacts[row.owner].id) start_row(step, row, old);
  }
};
template <class Start>
Answer mistaken(Start start_row) {
  return {Mistaken<Start>{{}, start_row}};
}
/// ... which of the old contacts it takes for a row's; null: none.
template <class Find>
struct Mismatched : Effect {
  Find find;
  void start(StepContext& step) {
    const Real scale = step.world.impulse_scale(step.dt);
    for (Row& row : step.rows)
      if (const Contact* old = find(step, row.owner)) row.reach(scale * old->impulse.dot(row.n));
  }
};
template <class Find>
Answer mismatched(Find find) {
  return {Mismatched<Find>{{}, find}};
}

Real guess_of(const StepContext& step, const Row& row, const Contact& old) {
  return step.world.impulse_scale(step.dt) * old.impulse.dot(row.n);
}

bool same_bodies(const ContactId& one, const ContactId& other) {
  return one.body_a == other.body_a && one.body_b == other.body_b;
}

/// Takes the k-th row for one of contact k modulo their count.
struct Miscounted : Effect {
  void start(StepContext& step) {
    for (std::size_t k = 0; k < step.rows.size(); ++k)
      for (const Contact& old : step.world.contacts_before)
        if (old.id == step.contacts[k % step.contacts.size()].id) step.rows[k].reach(guess_of(step, step.rows[k], old));
  }
};

std::vector<Mistake<Answer>> mistakes() {
  const std::string by_index =
      "it looks as if contacts were matched by their place in the list. When one goes, all after it move up and take "
      "the impulse of a neighbour: match by id.";
  const std::string by_bodies =
      "it looks as if only the bodies were compared. Two bodies may touch in several points, each with a load of its "
      "own: compare the whole id.";
  const std::string twice =
      "it looks as if the guess were applied twice. Σλ and what the bodies have felt have to be the same: row.reach "
      "does both, once.";
  return {
      {"by index", by_index, mismatched([](const StepContext& step, std::size_t i) {
         const Contacts& before = step.world.contacts_before;
         return i < before.size() ? &before[i] : nullptr;
       })},
      {"by bodies", by_bodies, mismatched([](const StepContext& step, std::size_t i) {
         const Contact* found = nullptr;
         for (const Contact& old : step.world.contacts_before)
           if (!found && same_bodies(old.id, step.contacts[i].id)) found = &old;
         return found;
       })},
      {"by bodies", by_bodies, mismatched([](const StepContext& step, std::size_t i) {
         const Contact* found = nullptr;
         for (const Contact& old : step.world.contacts_before)
           if (same_bodies(old.id, step.contacts[i].id)) found = &old;
         return found;
       })},
      {"by the nearest point",
       "it looks as if the old contact were looked for by its place. Bodies move, and points with them: only the id "
       "says which of the old ones it is.",
       mismatched([](const StepContext& step, std::size_t i) {
         const Contact* found = nullptr;
         const auto far = [&](const Contact& old) { return (old.point - step.contacts[i].point).norm(); };
         for (const Contact& old : step.world.contacts_before)
           if (same_bodies(old.id, step.contacts[i].id) && (!found || far(old) < far(*found))) found = &old;
         return found;
       })},
      {"by the feature alone",
       "it looks as if only the feature were compared. Features are numbered anew for each pair of bodies: compare the "
       "whole id.",
       mismatched([](const StepContext& step, std::size_t i) {
         const Contact* found = nullptr;
         for (const Contact& old : step.world.contacts_before)
           if (!found && old.id.feature == step.contacts[i].id.feature) found = &old;
         return found;
       })},
      {"turning left out",
       "it looks as if the guess had moved the bodies and not turned them. An impulse beside a body's centre turns it, "
       "too: row.apply, or row.reach, does both.",
       mistaken([](StepContext& step, Row& row, const Contact& old) {
         row.impulse = guess_of(step, row, old);
         row.a->velocity += row.impulse * row.dva;
         row.b->velocity += row.impulse * row.dvb;
       })},
      {"A along with B",
       "it looks as if the guess had moved A the same way as B. What pushes B pushes A back: row.apply, or row.reach, "
       "does both.",
       mistaken([](StepContext& step, Row& row, const Contact& old) {
         row.impulse = guess_of(step, row, old);
         row.a->velocity -= row.impulse * row.dva;
         row.a->angular_velocity -= row.impulse * row.dwa;
         row.b->velocity += row.impulse * row.dvb;
         row.b->angular_velocity += row.impulse * row.dwb;
       })},
      {"the contact of another row",
       "it looks as if a tangent took the impulse of another contact. The k-th row is not of the k-th contact: each "
       "has two tangents, and row.owner says whose it is.",
       {Miscounted{}}},
      {"no negative guess",
       "it looks as if a guess were never negative. A normal only pushes, but friction acts both ways: the sum of a "
       "tangent may be less than 0.",
       mistaken([](StepContext& step, Row& row, const Contact& old) {
         row.reach(std::max(Real(0), guess_of(step, row, old)));
       })},
      {"the normal for all rows",
       "it looks as if each row took the part along its contact's normal. A tangent takes the part along its own "
       "direction: row.n.",
       mistaken([](StepContext& step, Row& row, const Contact& old) {
         row.reach(step.world.impulse_scale(step.dt) * old.impulse.dot(step.contacts[row.owner].normal));
       })},
      {"applied to B alone",
       "it looks as if only B had felt the guess. An impulse acts on both bodies: row.apply, or row.reach, moves A the "
       "other way.",
       mistaken([](StepContext& step, Row& row, const Contact& old) {
         row.impulse = guess_of(step, row, old);
         row.b->velocity += row.impulse * row.dvb;
         row.b->angular_velocity += row.impulse * row.dwb;
       })},
      {"stored and not applied",
       "it looks as if the guess were written into Σλ, and no body felt it. The first sweep then takes back a push "
       "that never was: it holds what wants to leave. Σλ is by definition what has acted.",
       mistaken([](StepContext& step, Row& row, const Contact& old) { row.impulse = guess_of(step, row, old); })},
      {"applied and not stored",
       "it looks as if the bodies got the guess, and Σλ stayed 0. A guess that is too large then can never be taken "
       "back: it is not in the sum that is clamped.",
       mistaken([](StepContext& step, Row& row, const Contact& old) { row.apply(guess_of(step, row, old)); })},
      {"applied twice", twice, mistaken([](StepContext& step, Row& row, const Contact& old) {
         row.apply(guess_of(step, row, old));
         row.reach(guess_of(step, row, old));
       })},
      {"applied twice", twice,
       mistaken([](StepContext& step, Row& row, const Contact& old) { row.reach(2 * guess_of(step, row, old)); })},
      {"no rescaling",
       "it looks as if the old impulse were taken as it was. What stays is the force; an impulse is h times that, so "
       "it is to be multiplied by h_new / h_old.",
       mistaken([](StepContext&, Row& row, const Contact& old) { row.reach(old.impulse.dot(row.n)); })},
      {"rescaled the wrong way",
       "it looks as if the impulse were multiplied by h_old / h_new. In a shorter step the same force gives less "
       "impulse.",
       mistaken([](StepContext& step, Row& row, const Contact& old) {
         row.reach(step.world.dt_before / step.dt * old.impulse.dot(row.n));
       })},
      {"normals only",
       "it looks as if only the normals remembered. The tangents' rows stand behind the normals in step.rows, and "
       "friction holds from step to step, too.",
       mistaken([](StepContext& step, Row& row, const Contact& old) {
         if (&row < step.rows.data() + step.contacts.size()) row.reach(guess_of(step, row, old));
       })},
      {"the length of P",
       "it looks as if a row took the length of the old impulse. A row takes the part of it along its own direction: P "
       "· n.",
       mistaken([](StepContext& step, Row& row, const Contact& old) {
         row.reach(step.world.impulse_scale(step.dt) * old.impulse.norm());
       })},
      {"the length of P",
       "it looks as if the normal's row took the whole length of the old impulse. It takes the part along its normal, "
       "P · n, and the tangents take theirs.",
       mistaken([](StepContext& step, Row& row, const Contact& old) {
         if (&row < step.rows.data() + step.contacts.size())
           row.reach(step.world.impulse_scale(step.dt) * old.impulse.norm());
       })},
      {"the old directions",
       "it looks as if the old impulse were projected on the old normal. The row pushes along the new one: row.n.",
       mistaken([](StepContext& step, Row& row, const Contact& old) {
         const auto [tangent1, tangent2] = tangents_of(old.normal);
         const std::size_t k = static_cast<std::size_t>(&row - step.rows.data()), count = step.contacts.size();
         const Vec3 direction = k < count ? old.normal : (k - count) % 2 == 0 ? tangent1 : tangent2;
         row.reach(step.world.impulse_scale(step.dt) * old.impulse.dot(direction));
       })},
      {"the old directions",
       "it looks as if each row took the part along the old normal. A row takes the part along its own direction: "
       "row.n.",
       mistaken([](StepContext& step, Row& row, const Contact& old) {
         row.reach(step.world.impulse_scale(step.dt) * old.impulse.dot(old.normal));
       })},
      {"the sign of P",
       "it looks as if the bodies were pulled together. P acted on B, along the normal from A to B: the row's sum is P "
       "· n, with this sign.",
       mistaken([](StepContext& step, Row& row, const Contact& old) {
         row.impulse = -guess_of(step, row, old);
         row.apply(row.impulse);
       })},
      {"the sign of P",
       "it looks as if the guess had the wrong sign, and the limits of the normal kept the worst away. P acted on B, "
       "along the normal from A to B: the row's sum is P · n, with this sign.",
       mistaken([](StepContext& step, Row& row, const Contact& old) { row.reach(-guess_of(step, row, old)); })},
      {"nothing remembered",
       "it looks as if the step began at zero. In step.contacts the impulses of this step are not known yet: the old "
       "ones are in step.world.contacts_before.",
       mistaken([](StepContext&, Row&, const Contact&) {})},
  };
}

}  // namespace

Numbers play(std::size_t check, Random& random, const Answer& answer) {
  return checks()[check].play(random, answer);
}

Exercise exercise() {
  return exercise_of<Answer>(
      "match two lists by id, rescale, project, apply",
      {"For each row, look through step.world.contacts_before for the contact with the id of step.contacts[row.owner]. "
       "If there is none, the row starts from 0.",
       "What stays from step to step is a force. Multiply the old impulse by step.dt / step.world.dt_before.",
       "A row takes the part along its own direction, P · n: row.reach(scale * old.impulse.dot(row.n))."},
      checks(), {WarmStart{}}, mistakes());
}

}  // namespace pushback::exercise_07
