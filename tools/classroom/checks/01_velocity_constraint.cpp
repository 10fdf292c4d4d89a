#include "pushback/chapters/01_velocity_constraint/exercise/asked.h"
#include "pushback/common/bodies/random.h"
#include "pushback/common/exercise/shown.h"
#include "pushback/common/world/measure.h"

namespace pushback::exercise_01 {

namespace {

/// A body whose ring is caught by a rail.
struct Ride {
  Body body;
  Vec3 ring, rail;
  Vec3 rails_velocity = Vec3::Zero();

  void play(const Answer& answer, const std::vector<std::size_t>& quantities = {}) {
    answer.hold(body, ring, rail, rails_velocity, 24);
    show(with_rail(), quantities);
  }
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

 private:
  /// Only to be seen.
  World with_rail() const {
    World world;
    world.add(body);
    const auto line = [from = Vec3(ring - rail), to = Vec3(ring + rail)](const Body&, const Body&) {
      return std::vector<Vec3>{from, to};
    };
    world.joints.push_back({.name = "a ring on a rail", .a = the_world, .b = 0, .ask = {}, .line = line});
    return world;
  }
};

Ride ball(Random& random) {
  Body made = sphere(random.between(Real(0.2), Real(0.4)), random.between(5, 20)).moving(random.vector(4));
  return {made, Vec3::Zero(), random.direction()};
}

/// Somewhere. The ring is beside its centre, along the bar and a little across it.
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

std::vector<Check<Answer>> checks() {
  return {
      {"a ball with the ring at its centre keeps its speed along the rail, and no other",
       1,
       {{"your ball leaves the rail with", "m/s", 1e-6},
        {"your ball goes along the rail with", "m/s", 1e-5},
        {"your ball, sent the other way, leaves the rail with", "m/s", 1e-6}},
       [](Random& random, const Answer& answer) -> Numbers {
         Ride ride = ball(random), back = ride;
         back.body.velocity *= -1;
         ride.play(answer, {0, 1});
         back.play(answer, {2});
         return {ride.leaves(), ride.along(), back.leaves()};
       }},
      {"the ring of a bar stays on the rail, and the bar swings",
       2,
       {{"the ring of your bar leaves the rail with", "m/s", 1e-6},
        {"the centre of your bar goes along the rail with", "m/s", 1e-5},
        {"the angular momentum of your bar about its ring has changed by", "N m s", 1e-5}},
       [](Random& random, const Answer& answer) -> Numbers {
         Ride ride = bar(random, false);
         const Vec3 before = ride.angular_momentum();
         ride.play(answer);
         return {ride.leaves(), ride.along(), (ride.angular_momentum() - before).norm()};
       }},
      {"the same holds for a bar that lies askew",
       1,
       {{"the ring of your bar, which lies askew, leaves the rail with", "m/s", 1e-6},
        {"the angular momentum of your bar, which lies askew, has changed about its ring by", "N m s", 1e-5},
        {"your bar, which lies askew, turns with", "rad/s", 1e-5}},
       [](Random& random, const Answer& answer) -> Numbers {
         Ride ride = bar(random, true);
         const Vec3 before = ride.angular_momentum();
         ride.play(answer);
         return {ride.leaves(), (ride.angular_momentum() - before).norm(), ride.body.angular_velocity.norm()};
       }},
      {"a rail that moves takes the ring along, but not along itself",
       2,
       {{"the ring of your bar leaves the moving rail with", "m/s", 1e-6},
        {"the centre of your bar goes along the moving rail with", "m/s", 1e-5},
        {"your bar on the moving rail turns with", "rad/s", 1e-5}},
       [](Random& random, const Answer& answer) -> Numbers {
         Ride ride = bar(random, true);
         ride.rails_velocity = random.vector(4);
         ride.play(answer);
         return {ride.leaves(), ride.along(), ride.body.angular_velocity.norm()};
       }},
  };
}

/// One row of a body alone, as it stands in the solution; a mistake changes it.
struct RailRow {
  Body& body;
  Vec3 n, r_n;  // J
  Vec3 dv, dw;  // M^-1 J^T
  Real K, b;
  Real speed;  // J V

  RailRow(Body& held, const Vec3& direction, const Vec3& r, const Vec3& rails_velocity)
      : body(held), n(direction), r_n(r.cross(direction)), b(-direction.dot(rails_velocity)) {
    weigh(held.inverse_inertia);
  }
  void weigh(const Mat3& inverse_inertia) {
    dv = body.inverse_mass * n;
    dw = inverse_inertia * r_n;
    K = body.inverse_mass + r_n.dot(dw);
    speed = n.dot(body.velocity) + r_n.dot(body.angular_velocity);
  }
  void solve() {
    const Real lambda = -(speed + b) / K;
    body.velocity += lambda * dv;
    body.angular_velocity += lambda * dw;
  }
};

enum class Directions { across, first, second, along, all };

std::vector<Vec3> directions_of(const Vec3& rail, Directions which) {
  const auto [t1, t2] = tangents_of(rail);
  switch (which) {
    case Directions::first:
      return {t1};
    case Directions::second:
      return {t2};
    case Directions::along:
      return {rail};
    case Directions::all:
      return {t1, t2, rail};
    default:
      return {t1, t2};
  }
}

template <class Change>
Answer changed(Change change, Directions which = Directions::across, int most = 24) {
  return {
      [change, which, most](Body& body, const Vec3& ring, const Vec3& rail, const Vec3& rails_velocity, int sweeps) {
        for (int sweep = 0; sweep < std::min(sweeps, most); ++sweep) {
          for (const Vec3& n : directions_of(rail, which)) {
            RailRow row(body, n, ring - body.position, rails_velocity);
            change(row);
            row.solve();
          }
        }
      }};
}

void nothing(RailRow&) {}

std::vector<Mistake<Answer>> mistakes() {
  const std::string few =
      "it looks as if one direction across the rail were still free. Two directions are at right angles to a rail; "
      "each needs a row.";
  const std::string order =
      "it looks as if the torque were n × r, or the speed of the ring r × ω. It is r × n and ω × r, with r from the "
      "centre of mass to the ring.";
  const std::string axes =
      "it looks as if the inertia were that of body axes. The bar lies askew: inverse_inertia is turned already, "
      "principal_inverse_inertia is not.";
  const std::string moment =
      "it looks as if what holds the ring turned nothing. It acts at the ring, so it has no moment about the ring, but "
      "it has one about the centre of mass.";
  const std::string along =
      "it looks as if the rail took the body along with it. There is no friction: only the part of u across the rail "
      "is felt.";
  return {
      {"r from the origin",
       "it looks as if r led from the origin of the world to the ring. An arm begins at the centre of mass.",
       changed([](RailRow& row) {
         row.r_n += row.body.position.cross(row.n);
         row.weigh(row.body.inverse_inertia);
       })},
      {"taken along by the rail",
       along,
       {[](Body& body, const Vec3& ring, const Vec3& rail, const Vec3& rails_velocity, int sweeps) {
         body.velocity += rail.dot(rails_velocity) * rail;
         changed(nothing).hold(body, ring, rail, rails_velocity, sweeps);
       }}},
      {"taken along by the rail",
       along,
       {[](Body& body, const Vec3& ring, const Vec3& rail, const Vec3& rails_velocity, int sweeps) {
         body.velocity -= rails_velocity;
         changed(nothing).hold(body, ring, rail, Vec3::Zero(), sweeps);
       }}},
      {"only a push",
       "it looks as if a row could only push. A ring is held from both sides: λ may be negative.",
       {[](Body& body, const Vec3& ring, const Vec3& rail, const Vec3& rails_velocity, int sweeps) {
         for (int sweep = 0; sweep < sweeps; ++sweep)
           for (const Vec3& n : directions_of(rail, Directions::across)) {
             RailRow row(body, n, ring - body.position, rails_velocity);
             if (row.speed + row.b < 0) row.solve();
           }
       }}},
      {"sign of λ", "it looks as if λ had the wrong sign. It has to undo J V + b: λ = -(J V + b) / K.",
       changed([](RailRow& row) { row.K = -row.K; })},
      {"multiplied by K",
       "it looks as if J V + b were multiplied by K. K is the speed that a newton second makes: divide by it.",
       changed([](RailRow& row) { row.K = 1 / row.K; })},
      {"held along the rail",
       "it looks as if the rail's own direction were the forbidden one. Along the rail the ring is free; n is at right "
       "angles to it.",
       changed(nothing, Directions::along)},
      {"held in all directions",
       "it looks as if the ring were nailed to its place. A rail without friction gives no impulse along itself.",
       changed(nothing, Directions::all)},
      {"one row only", few, changed(nothing, Directions::first)},
      {"one row only", few, changed(nothing, Directions::second)},
      {"the centre on the rail",
       "it looks as if the centre of mass were held, not the ring. J V is the speed of the ring, v + ω × r.",
       {[](Body& body, const Vec3&, const Vec3& rail, const Vec3& rails_velocity, int) {
         const Vec3 velocity = body.velocity - rails_velocity;
         body.velocity -= velocity - rail.dot(velocity) * rail;
       }}},
      {"the centre on the rail",
       "it looks as if JV had no ω in it. The rail holds the ring, not the centre of mass: its speed is that of v + ω "
       "× r.",
       changed([](RailRow& row) { row.speed = row.n.dot(row.body.velocity); })},
      {"no turn", moment, changed([](RailRow& row) {
         row.dw.setZero();
         row.K = row.body.inverse_mass;
       })},
      {"no turn", moment, changed([](RailRow& row) { row.dw.setZero(); })},
      {"K of the mass alone",
       "it looks as if K had only the mass in it. The ring also gives way because the bar turns: (r × n) · I⁻¹ (r × "
       "n). Without it each impulse is too large, and the next has more to undo.",
       changed([](RailRow& row) { row.K = row.body.inverse_mass; })},
      {"n × r for r × n", order, changed([](RailRow& row) {
         row.r_n = -row.r_n;
         row.weigh(row.body.inverse_inertia);
       })},
      {"n × r for r × n", order, changed([](RailRow& row) { row.dw = -row.dw; })},
      {"n × r for r × n", order, changed([](RailRow& row) {
         row.speed = row.n.dot(row.body.velocity) - row.r_n.dot(row.body.angular_velocity);
       })},
      {"velocities of before the first sweep",
       "it looks as if JV were computed once, before the first sweep. Then every sweep pushes against the same speed "
       "again. JV is computed anew before each impulse.",
       {[](Body& body, const Vec3& ring, const Vec3& rail, const Vec3& rails_velocity, int sweeps) {
         std::vector<RailRow> rows;
         for (const Vec3& n : directions_of(rail, Directions::across))
           rows.emplace_back(body, n, ring - body.position, rails_velocity);
         for (int sweep = 0; sweep < sweeps; ++sweep)
           for (RailRow& row : rows) row.solve();
       }}},
      {"one sweep",
       "it looks as if the rows were solved once. Where the ring is not at the centre of mass, the second row moves "
       "the ring along the first: solve them in turn, over and over.",
       changed(nothing, Directions::across, 1)},
      {"inertia not turned", axes,
       changed([](RailRow& row) { row.dw = Mat3(row.body.principal_inverse_inertia.asDiagonal()) * row.r_n; })},
      {"inertia not turned", axes,
       changed([](RailRow& row) { row.weigh(row.body.principal_inverse_inertia.asDiagonal()); })},
      {"b forgotten",
       "it looks as if the rail were at rest. The ring has to move across the rail as the rail does: b = -n · u, with "
       "the rail's velocity u.",
       changed([](RailRow& row) { row.b = 0; })},
      {"sign of b",
       "it looks as if b had the wrong sign. JV + b = 0 asks for the speed -b along n; the rail has n · u.",
       changed([](RailRow& row) { row.b = -row.b; })},
  };
}

}  // namespace

Numbers play(std::size_t check, Random& random, const Answer& answer) {
  return checks()[check].play(random, answer);
}

Exercise exercise() {
  return exercise_of<Answer>(
      "a body on a rail",
      {"Two rows: one for each direction n at right angles to the rail, which are the two of tangents_of(rail). J V is "
       "the speed of the ring along n, n · v + (r × n) · ω.",
       "K = 1/m + (r × n) · I⁻¹ (r × n), with r from the centre of mass to the ring. Nothing of the rail is in it.",
       "The ring is to have the rail's speed along n, n · u. The row makes J V = -b, so b = -n · u. Compute J V anew "
       "before each impulse."},
      checks(), changed(nothing), mistakes());
}

}  // namespace pushback::exercise_01
