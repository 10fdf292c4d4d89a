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

/// Balls on the ground, and the memory of a solver. What held them is made up: in each step that is kept another force.
struct Balls {
  World world;
  Answer answer;
  Memory memory = {};

  Balls(Random& random, std::size_t count, const Answer& its_answer) : answer(its_answer) {
    world.add(ground());
    for (std::size_t i = 0; i < count; ++i) {
      const Real radius = random.between(Real(0.2), Real(0.5)), mass = random.between(5, 20);
      world.add(sphere(radius, mass).at({2 * static_cast<Real>(i) - 4, radius, 0}));  // the third at 0
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
  /// The left point has borne one part, the right one another.
  void keep_two(const ContactId& left, Real part_left, const ContactId& right, Real part_right, Real dt) {
    answer.keep(memory, {bearing(left, part_left, dt), bearing(right, part_right, dt)}, dt);
  }
  /// m/s, upwards, of each ball: gravity has pulled in this step, and the memory has answered.
  Numbers started(const std::vector<ContactId>& ids, Real dt) {
    world.contacts.clear();
    for (const ContactId& id : ids) world.contacts.push_back(bearing(id, 0, dt));
    for (Body& body : world.bodies) {
      if (body.movable()) body.velocity = dt * world.gravity;
      body.angular_velocity.setZero();
    }
    Solver<Clamping, Starting> solver;
    static_cast<Starting&>(solver) = {{}, answer, memory};
    solver.solve(world, dt, 0);
    Numbers speeds;
    for (const Body& body : world.bodies)
      if (body.movable()) speeds.push_back(body.velocity.y());
    return speeds;
  }
};

constexpr ContactId first{0, 1, 0}, second{0, 2, 0}, left{0, 3, 1}, right{0, 3, 2};

std::vector<Check<Answer>> checks() {
  return {
      {"the latest force of a ball holds it in the next step, however long",
       2,
       {{"in a step that is shorter your ball starts with", "m/s", 1e-6},
        {"in a step that is longer your ball starts with", "m/s", 1e-6},
        {"your ball that touches for the first time starts with", "m/s", 1e-6},
        {"your ball that touches in two points starts with", "m/s", 1e-6},
        {"your ball that touches in two points starts to turn with", "rad/s", 1e-6}},
       [](Random& random, const Answer& answer) -> Numbers {
         Balls balls(random, 3, answer);
         const Real before = random.between(Real(0.2), Real(0.4)), latest = random.between(Real(0.6), Real(0.8));
         const Real h = random.between(Real(0.01), Real(0.015)), ratio = random.between(Real(0.3), Real(0.6));
         balls.keep({first}, before, 2 * h);
         balls.keep({first}, latest, h);
         const Numbers shorter = balls.started({first, second}, ratio * h);
         const Real longer = balls.started({first, second}, h / ratio)[0];
         const Real part_left = random.between(Real(0.1), Real(0.2)), part_right = random.between(Real(0.4), Real(0.6));
         balls.keep_two(left, part_left, right, part_right, h);
         const Real in_two = balls.started({left, right}, ratio * h)[2];
         return {shorter[0], longer, shorter[1], in_two, balls.world.bodies[3].angular_velocity.z()};
       },
       "a point starts with the force that it had in the latest step in which it touched. The impulse is that force "
       "times the new h, and the whole id says which point it is."},
      {"a point that is lost for a few steps comes back with its force",
       2,
       {{"your ball, whose contact was lost right after it first touched, starts with", "m/s", 1e-6},
        {"your ball, whose contact was lost after a while, starts with", "m/s", 1e-6},
        {"your ball, whose contact was lost for many short steps, starts with", "m/s", 1e-6}},
       [](Random& random, const Answer& answer) -> Numbers {
         Balls balls(random, 2, answer);
         const Real part = random.between(Real(0.5), Real(0.8));
         balls.keep({second}, part, random.between(Real(0.0205), Real(0.0245)));
         balls.keep({}, 0, random.between(Real(0.015), Real(0.018)));
         const Real early = balls.started({second}, random.between(Real(0.005), Real(0.01)))[1];
         for (int step = 0; step < 4; ++step) {
           const Real more = random.between(Real(0.1), Real(0.2)) * static_cast<Real>(1 + step);
           balls.keep({first}, more, random.between(Real(0.0205), Real(0.0245)));
         }
         for (int step = 0; step < 3; ++step) balls.keep({}, 0, random.between(Real(0.0175), Real(0.019)));
         const Real late = balls.started({first}, random.between(Real(0.005), Real(0.01)))[0];
         Balls quick(random, 1, answer);
         quick.keep({first}, random.between(Real(0.5), Real(0.8)), Real(0.002));
         for (int step = 0; step < 27; ++step) quick.keep({}, 0, random.between(Real(0.00195), Real(0.0021)));
         return {early, late, quick.started({first}, Real(0.002))[0]};
       },
       "a point is remembered for 0.1 s after it last touched, with the force of that step. Its age is in seconds, and "
       "grows by the dt of each step that goes by."},
      {"a point that is lost for long is forgotten",
       1,
       {{"your ball, which was up and away for long, starts with", "m/s", 1e-6},
        {"your ball, which was up and away for a few long steps, starts with", "m/s", 1e-6}},
       [](Random& random, const Answer& answer) -> Numbers {
         Balls balls(random, 1, answer);
         const Real part = random.between(Real(0.5), Real(0.8));
         balls.keep({first}, part, random.between(Real(0.015), Real(0.02)));
         for (int step = 0; step < 8; ++step) balls.keep({}, 0, random.between(Real(0.0175), Real(0.0235)));
         const Real many = balls.started({first}, random.between(Real(0.005), Real(0.01)))[0];
         Balls slow(random, 1, answer);
         slow.keep({first}, random.between(Real(0.5), Real(0.8)), Real(0.002));
         for (int step = 0; step < 5; ++step) slow.keep({}, 0, random.between(Real(0.043), Real(0.045)));
         return {many, slow.started({first}, random.between(Real(0.03), Real(0.04)))[0]};
       },
       "0.1 s after it last touched, a point is forgotten. Whatever lay there has gone, and its impulse would be a "
       "kick from the past."},
      {"a body that is put elsewhere leaves its impulses behind, and nobody else does",
       2,
       {{"your ball that has not been moved starts with", "m/s", 1e-6},
        {"your ball that has been put elsewhere starts with", "m/s", 1e-6},
        {"your ball that lay on it starts with", "m/s", 1e-6}},
       [](Random& random, const Answer& answer) -> Numbers {
         Balls balls(random, 3, answer);
         const std::vector<ContactId> ids{first, second, {2, 3, 0}};
         const Real h = random.between(Real(0.01), Real(0.02));
         balls.keep(ids, random.between(Real(0.5), Real(0.8)), h);
         answer.put_elsewhere(balls.memory, 2);
         return balls.started(ids, random.between(Real(0.5), Real(0.9)) * h);
       },
       "its impulses held the body where it was. All points in which it is A or B are forgotten, and no others."},
  };
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

Numbers play(std::size_t check, Random& random, const Answer& answer) {
  return checks()[check].play(random, answer);
}

Exercise exercise() {
  return exercise_of<Answer>(
      "a memory for steps of changing length, and for bodies that are put elsewhere",
      {"guess: find the entry with this id. Its force was impulse / dt, with the dt of that entry.",
       "keep, in this order: all entries grow older by dt; the points that touch are entered anew, with age 0, and "
       "their older entries go; who is older than `lasts` goes.",
       "put_elsewhere: an entry goes if one.id.body_a or one.id.body_b is the body."},
      checks(), {guess, keep, put_elsewhere});
}

}  // namespace pushback::exercise_07
