#include "pushback/chapters/02_clamping/clamping.h"
#include "pushback/chapters/07_warm_start/exercise/asked.h"

namespace pushback::exercise_07 {

namespace {

struct Starting : Effect {
  Answer answer{};
  Memory memory = {};
  void start(StepContext& step) {
    for (Row& row : step.rows) row.reach(answer.guess(memory, step.contacts[row.owner].id, step.dt).dot(row.n));
  }
};

/// Three balls on the ground, and the memory of a solver. Their contact forces are invented, another one in each stored step.
struct Balls {
  World world;
  Answer answer;
  Memory memory = {};

  Balls(Random& random, const Answer& its_answer) : answer(its_answer) {
    world.add(ground());
    for (const Real x : {-2, 0, 2}) {
      const Real radius = random.between(Real(0.2), Real(0.5)), mass = random.between(5, 20);
      world.add(sphere(radius, mass).at({x, radius, 0}));
    }
  }
  /// Bears the part `part` of B's weight in a step of dt: right below it, or to the left (feature 1) or the right (2).
  Contact bearing(const ContactId& id, Real part, Real dt) const {
    const Real aside = id.feature == 0 ? 0 : id.feature == 1 ? Real(-0.1) : Real(0.1);
    return {.point = Vec3(world.bodies[id.body_b].position.x() + aside, 0, 0),
            .normal = Vec3::UnitY(),
            .id = id,
            .impulse = part / world.bodies[id.body_b].inverse_mass * dt * World::g * Vec3::UnitY()};
  }
  void keep(const std::vector<ContactId>& ids, Real part, Real dt) {
    Contacts contacts;
    for (const ContactId& id : ids) contacts.push_back(bearing(id, part, dt));
    answer.keep(memory, contacts, dt);
  }
  void nothing_touches(int steps, Real dt) {
    for (int step = 0; step < steps; ++step) keep({}, 0, dt);
  }
  /// m/s, upwards, of each ball, after gravity of this step and the memory's guess.
  Numbers started(const std::vector<ContactId>& ids, Real dt) {
    world.contacts.clear();
    for (const ContactId& id : ids) world.contacts.push_back(bearing(id, 0, dt));
    for (Body& body : world.bodies)
      if (body.movable()) body.velocity = dt * world.gravity;
    Solver<Clamping, Starting> solver;
    static_cast<Starting&>(solver) = {{}, answer, memory};
    solver.solve(world, dt, 0);
    Numbers speeds;
    for (std::size_t ball = 1; ball <= 3; ++ball) speeds.push_back(world.bodies[ball].velocity.y());
    return speeds;
  }
};

constexpr ContactId first{0, 1, 0}, second{0, 2, 0}, left{0, 3, 1}, right{0, 3, 2};

Real some_part(Random& random) {
  return random.between(Real(0.5), Real(0.8));
}

Vec3 guess(const Memory& memory, const ContactId& id, Real dt) {
  for (const Remembered& one : memory)
    if (one.id == id) return dt / one.dt * one.impulse;
  return Vec3::Zero();
}
void keep(Memory& memory, const Contacts& contacts, Real dt) {
  for (Remembered& one : memory) one.age += dt;
  for (const Contact& contact : contacts) {
    std::erase_if(memory, [&](const Remembered& one) { return one.id == contact.id; });
    memory.push_back({contact.id, contact.impulse, dt, 0});
  }
  std::erase_if(memory, [](const Remembered& one) { return one.age > lasts; });
}
void put_elsewhere(Memory& memory, std::uint32_t body) {
  std::erase_if(memory, [&](const Remembered& one) { return one.id.body_a == body || one.id.body_b == body; });
}

}  // namespace

std::vector<Check<Answer>> checks_of(const Answer& /*any*/) {
  return {
      {"the latest force on a ball holds it in the next step, however long that step is", 2,
       [](Random& random, const Answer& answer) -> std::vector<Reading> {
         Balls balls(random, answer);
         const Real h = random.between(Real(0.01), Real(0.015)), ratio = random.between(Real(0.3), Real(0.6));
         balls.keep({first}, random.between(Real(0.2), Real(0.4)), 2 * h);
         const Real part = some_part(random);
         balls.answer.keep(
             balls.memory,
             {balls.bearing(first, part, h), balls.bearing(left, part / 4, h), balls.bearing(right, part / 2, h)}, h);
         const Numbers speeds = balls.started({first, second, left, right}, ratio * h);
         return {{"in a step of another length your ball starts at", speeds[0], "m/s"},
                 {"your ball that touches for the first time starts at", speeds[1], "m/s"},
                 {"your ball that touches at two points starts at", speeds[2], "m/s"},
                 {"your ball that touches at two points starts to rotate at",
                  balls.world.bodies[3].angular_velocity.z(), "rad/s"}};
       },
       "a point starts with its force from the latest step in which it touched. The impulse is this force times the "
       "new h. The whole id identifies the point."},
      {"a point that is lost for a few steps gets its force back", 2,
       [](Random& random, const Answer& answer) -> std::vector<Reading> {
         Balls balls(random, answer), quick = balls;
         for (int step = 0; step < 4; ++step)
           balls.keep({first}, some_part(random), random.between(Real(0.0205), Real(0.0245)));
         balls.nothing_touches(3, random.between(Real(0.0175), Real(0.019)));
         quick.keep({first}, some_part(random), Real(0.002));
         quick.nothing_touches(27, random.between(Real(0.00195), Real(0.0021)));
         return {{"your ball, whose contact was lost for a while, starts at", balls.started({first}, Real(0.008))[0],
                  "m/s"},
                 {"your ball, whose contact was lost for many short steps, starts at",
                  quick.started({first}, Real(0.002))[0], "m/s"}};
       },
       "a point is remembered for 0.1 s after it last touched, with the force of that step. Its age is in seconds, and "
       "grows by the dt of each later step."},
      {"a point that is lost for a long time is forgotten", 1,
       [](Random& random, const Answer& answer) -> std::vector<Reading> {
         Balls balls(random, answer), slow = balls;
         balls.keep({first}, some_part(random), random.between(Real(0.015), Real(0.02)));
         balls.nothing_touches(8, random.between(Real(0.0175), Real(0.0235)));
         slow.keep({first}, some_part(random), Real(0.002));
         slow.nothing_touches(5, random.between(Real(0.043), Real(0.045)));
         return {{"your ball, which was in the air for a long time, starts at",
                  balls.started({first}, random.between(Real(0.005), Real(0.01)))[0], "m/s"},
                 {"your ball, which was in the air for a few long steps, starts at",
                  slow.started({first}, random.between(Real(0.03), Real(0.04)))[0], "m/s"}};
       },
       "a point is forgotten 0.1 s after it last touched. An older impulse no longer supports anything and would only "
       "kick the body."},
      {"a body that is moved elsewhere loses its impulses, and other bodies keep theirs", 2,
       [](Random& random, const Answer& answer) -> std::vector<Reading> {
         Balls balls(random, answer);
         const std::vector<ContactId> ids{first, second, {2, 3, 0}};
         const Real h = random.between(Real(0.01), Real(0.02));
         balls.keep(ids, some_part(random), h);
         balls.answer.put_elsewhere(balls.memory, 2);
         const Numbers speeds = balls.started(ids, random.between(Real(0.5), Real(0.9)) * h);
         return {{"your ball that has not been moved starts at", speeds[0], "m/s"},
                 {"your ball that has been moved elsewhere starts at", speeds[1], "m/s"},
                 {"your ball that lay on the moved one starts at", speeds[2], "m/s"}};
       },
       "the impulses held the body where it was. Forget only the points where the body is A or B."},
  };
}

Exercise exercise() {
  return exercise_of("a memory for steps of changing length, and for bodies that are put elsewhere",
                     {"guess: find the entry with this id. Its force was impulse / dt, with the dt of that entry.",
                      "keep works in this order. First add dt to the age of all entries. Then replace the entries of "
                      "all touching points, with age 0. Finally erase entries older than `lasts`.",
                      "put_elsewhere: erase an entry if one.id.body_a or one.id.body_b is the body."},
                     Answer{guess, keep, put_elsewhere});
}

}  // namespace pushback::exercise_07
