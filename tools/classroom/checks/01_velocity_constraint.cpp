#include "pushback/chapters/01_velocity_constraint/exercise/asked.h"
#include "pushback/common/world/measure.h"

namespace pushback::exercise_01 {

namespace {

/// A body whose ring is caught by a rail.
struct Ride {
  Body body;
  Vec3 ring, rail;
  Vec3 rails_velocity = Vec3::Zero();

  void play(const Answer& answer) { answer.hold(body, ring, rail, rails_velocity, 24); }
  /// m/s, of the ring across the rail.
  Real leaves() const {
    const Vec3 velocity = body.velocity_at(ring) - rails_velocity;
    return (velocity - rail.dot(velocity) * rail).norm();
  }
  Real along() const { return rail.dot(body.velocity); }  ///< m/s, of the centre of mass
  /// N m s, about the place where the ring is.
  Vec3 angular_momentum() const {
    return spin_momentum(body) + (body.position - ring).cross(body.velocity / body.inverse_mass);
  }
};

Ride ball(Random& random) {
  const Real mass = random.between(5, 20);
  Body made = sphere(random.between(Real(0.2), Real(0.4)), mass).moving(random.vector(4));
  return {made, Vec3::Zero(), random.direction()};
}

/// A bar somewhere. The ring is off its centre, along the bar and a little across it.
Ride bar(Random& random, bool askew) {
  const Vec3 half{random.between(Real(0.5), Real(0.8)), random.between(Real(0.2), Real(0.25)),
                  random.between(Real(0.26), Real(0.3))};
  const Vec3 ring{half.x() * random.between(Real(0.5), Real(0.65)), random.between(Real(0.05), Real(0.15)),
                  random.between(Real(0.05), Real(0.15))};
  Body made = box(half, random.between(5, 20)).moving(random.vector(4)).spinning(random.vector(3));
  if (askew) made.orientation = random.orientation();
  made.refresh_inertia();
  made.position = random.vector(1);
  return {made, made.position + made.orientation * ring, random.direction()};
}

void right(Body& body, const Vec3& ring, const Vec3& rail, const Vec3& rails_velocity, int sweeps) {
  const auto [t1, t2] = tangents_of(rail);
  for (int sweep = 0; sweep < sweeps; ++sweep) {
    for (const Vec3& n : {t1, t2}) {
      const Vec3 r_n = (ring - body.position).cross(n), turn = body.inverse_inertia * r_n;
      const Real speed = n.dot(body.velocity) + r_n.dot(body.angular_velocity), K = body.inverse_mass + r_n.dot(turn);
      const Real lambda = (n.dot(rails_velocity) - speed) / K;
      body.velocity += lambda * body.inverse_mass * n;
      body.angular_velocity += lambda * turn;
    }
  }
}

}  // namespace

std::vector<Check<Answer>> checks_of(const Answer& /*any*/) {
  return {
      {"a ball with the ring at its centre keeps only its speed along the rail", 1,
       [](Random& random, const Answer& answer) -> std::vector<Reading> {
         Ride ride = ball(random);
         ride.play(answer);
         return {{"your ball leaves the rail at", ride.leaves(), "m/s"},
                 {"your ball moves along the rail at", ride.along(), "m/s", 1e-5}};
       },
       "the rail blocks both directions at right angles to it, and holds the ring from both sides. It gives no impulse "
       "along itself."},
      {"the ring of a bar stays on the rail, and the bar swings", 2,
       [](Random& random, const Answer& answer) -> std::vector<Reading> {
         Ride ride = bar(random, false);
         const Vec3 before = ride.angular_momentum();
         ride.play(answer);
         return {{"the ring of your bar leaves the rail at", ride.leaves(), "m/s"},
                 {"the centre of your bar moves along the rail at", ride.along(), "m/s", 1e-5},
                 {"the angular momentum of your bar about its ring has changed by",
                  (ride.angular_momentum() - before).norm(), "N m s", 1e-5}};
       },
       "the rail holds the ring, not the centre of mass. J V is the speed of the ring, from v + ω × r, and the impulse "
       "changes ω by I⁻¹ (r × n). Each row disturbs the other, so solve them in turn, again and again."},
      {"the same is true for a bar that lies askew", 1,
       [](Random& random, const Answer& answer) -> std::vector<Reading> {
         Ride ride = bar(random, true);
         ride.play(answer);
         return {{"the ring of your bar, which lies askew, leaves the rail at", ride.leaves(), "m/s"},
                 {"your bar, which lies askew, rotates at", ride.body.angular_velocity.norm(), "rad/s", 1e-5}};
       },
       "use the inertia in world axes, inverse_inertia, because the bar lies askew. r points from its centre of mass "
       "to the ring."},
      {"a moving rail carries the ring along, but not in the direction of the rail", 2,
       [](Random& random, const Answer& answer) -> std::vector<Reading> {
         Ride ride = bar(random, true);
         ride.rails_velocity = random.vector(4);
         ride.play(answer);
         return {{"the ring of your bar leaves the moving rail at", ride.leaves(), "m/s"},
                 {"the centre of your bar moves along the moving rail at", ride.along(), "m/s", 1e-5},
                 {"your bar on the moving rail rotates at", ride.body.angular_velocity.norm(), "rad/s", 1e-5}};
       },
       "across the rail, the ring must move as fast as the rail does, so b = -n · u. Along the rail there is no "
       "friction, so the rail's velocity has no effect."},
  };
}

Exercise exercise() {
  return exercise_of(
      "a body on a rail",
      {"There are two rows, one for each direction n at right angles to the rail. tangents_of(rail) returns both. J V "
       "is the speed of the ring along n, n · v + (r × n) · ω.",
       "K = 1/m + (r × n) · I⁻¹ (r × n), with r from the centre of mass to the ring. K contains nothing of the rail.",
       "The ring must move along n as fast as the rail, at n · u. The row makes J V = -b, so b = -n · u. Compute J V "
       "again before each impulse."},
      Answer{right});
}

}  // namespace pushback::exercise_01
