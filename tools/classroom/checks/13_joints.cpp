#include "pushback/chapters/13_joints/exercise/asked.h"
#include "pushback/chapters/13_joints/joints.h"
#include "pushback/common/world/measure.h"

namespace pushback::exercise_13 {

namespace {

/// Two bodies, the second on a rail of the first.
struct Railed {
  World world;
  RoundRail rail;

  Railed(Random& random, Body a, Body b, const Vec3& slider, const Answer& answer) {
    a.position = random.vector(1);
    for (Body* body : {&a, &b}) body->orientation = random.orientation();
    rail = {random.vector(Real(0.5)), random.direction(), random.between(Real(0.5), Real(0.8)), slider};
    const Vec3 around = tangents_of(rail.axis).tangent1;
    b.position = point_of(a, rail.centre + rail.radius * around) - b.orientation * slider;
    world.gravity.setZero();
    world.add(a);
    world.add(b);
    world.joints.push_back({"your slider", 0, 1,
                            [its = rail, answer](const Body& first, const Body& second, const TimeStep&,
                                                 Equations& equations) { answer.ask(its, first, second, equations); }});
  }
  Body& a() { return world.bodies[0]; }
  Body& b() { return world.bodies[1]; }
  Vec3 slider() { return point_of(b(), rail.slider); }
  Vec3 axis() { return a().orientation * rail.axis; }
  Real off_the_plane() { return axis().dot(slider() - point_of(a(), rail.centre)); }
  Vec3 across() {
    const Vec3 d = slider() - point_of(a(), rail.centre);
    return d - axis().dot(d) * axis();
  }
  /// The slider's position seen from the rail: outwards, out of its plane, along it.
  Vec3 speeds() {
    const Vec3 v = b().velocity_at(slider()) - a().velocity_at(slider()), out = across().normalized();
    return {v.dot(out), v.dot(axis()), v.dot(axis().cross(out))};
  }
  Vec3 angular_momentum() const {
    Vec3 sum = Vec3::Zero();
    for (const Body& body : world.bodies)
      sum += spin_momentum(body) + body.position.cross(body.velocity) / body.inverse_mass;
    return sum;
  }
};

Body random_box(Random& random) {
  const Real x = random.between(Real(0.2), Real(0.4)), y = random.between(Real(0.2), Real(0.4));
  return box({x, y, Real(0.3)}, random.between(5, 20));
}
Railed two_boxes(Random& random, const Answer& answer) {
  const Body a = random_box(random), b = random_box(random);
  const Real arm = random.between(Real(0.3), Real(0.5));
  return {random, a, b, arm * random.direction(), answer};
}

void right(const RoundRail& rail, const Body& a, const Body& b, Equations& rows) {
  const Vec3 axis = a.orientation * rail.axis, slider = point_of(b, rail.slider);
  const Vec3 d = slider - point_of(a, rail.centre), across = d - d.dot(axis) * axis;
  rows.push_back({.jacobian = Jacobian::along(axis, a, b, slider), .error = d.dot(axis)});
  rows.push_back(
      {.jacobian = Jacobian::along(across.normalized(), a, b, slider), .error = across.norm() - rail.radius});
}

}  // namespace

std::vector<Check<Answer>> checks_of(const Answer& /*any*/) {
  return {
      {"a ball stays on a fixed rail after a single sweep, and keeps its speed along it", 2,
       [](Random& random, const Answer& answer) -> std::vector<Reading> {
         const Body ball = sphere(Real(0.1), random.between(2, 10));
         Railed railed(random, random_box(random).fixed(), ball, Vec3::Zero(), answer);
         const Vec3 out = railed.across().normalized(), axis = railed.axis();
         const Real outwards = random.between(1, 3), off = random.between(1, 3), along = random.between(1, 3);
         railed.b().velocity = outwards * out + off * axis + along * axis.cross(out);
         Solver<Joints> solver;
         solver.solve(railed.world, Real(0.02), 1);
         return {{"your ball leaves the rail at", railed.speeds().head<2>().norm(), "m/s"},
                 {"along the rail your ball moves at", railed.speeds().z(), "m/s"}};
       },
       "the rail holds the ball in two directions: along the axis m, and straight away from the axis. Each n is a unit "
       "vector. The rail gives no impulse along itself."},
      {"the slider of a box stays on the rail of another box, and angular momentum is conserved", 2,
       [](Random& random, const Answer& answer) -> std::vector<Reading> {
         Railed railed = two_boxes(random, answer);
         for (Body& body : railed.world.bodies) {
           body.velocity = random.vector(3);
           body.angular_velocity = random.vector(3);
         }
         const Vec3 before = railed.angular_momentum();
         Solver<Joints> solver;
         solver.solve(railed.world, Real(0.02), 2000);
         return {{"seen from the rail, your slider leaves it at", railed.speeds().head<2>().norm(), "m/s"},
                 {"the angular momentum of both boxes together changes by", (railed.angular_momentum() - before).norm(),
                  "N m s"},
                 {"seen from the rail, your slider moves along it at", railed.speeds().z(), "m/s"}};
       },
       "the force acts on both bodies at P, so both arms end there, and the rail rotates with A. Two equal and "
       "opposite forces at one point have no total torque."},
      {"a slider that is off its rail comes back by the fraction β in each step", 2,
       [](Random& random, const Answer& answer) -> std::vector<Reading> {
         Railed railed = two_boxes(random, answer);
         railed.b().position += random.between(Real(0.01), Real(0.015)) * railed.axis() +
                                random.between(Real(0.01), Real(0.015)) * railed.across().normalized();
         Solver<Joints> solver;
         solver.beta = random.between(Real(0.3), Real(0.6));
         railed.world.step(solver, Real(0.02), 2000);
         return {{"after a step the distance of your slider from the plane of its rail is",
                  1000 * railed.off_the_plane(), "mm", 0.3},
                 {"after a step your slider is too far from the middle of its rail by",
                  1000 * (railed.across().norm() - railed.rail.radius), "mm", 0.3}};
       },
       "C₁ = m · d and C₂ = ρ - R are signed lengths, and J V is how fast each grows. Each step then removes the "
       "fraction β, by forces that act on both bodies at P."},
  };
}

Exercise exercise() {
  return exercise_of("a slider on a round rail",
                     {"Use a frame that moves with A. There m and Q are fixed, and C₁ and C₂ depend only on the "
                      "position of P. In which direction does each grow by one metre per metre?",
                      "n = m for the plane, and n = (d - (m · d) m) / ρ for the ring. C' is n times the velocity of P "
                      "relative to the point of A at the same place.",
                      "Both arms end at P: r_A = P - a.position, r_B = P - b.position."},
                     Answer{right});
}

}  // namespace pushback::exercise_13
