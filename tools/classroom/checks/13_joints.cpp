#include "pushback/chapters/13_joints/exercise/asked.h"
#include "pushback/chapters/13_joints/joints.h"
#include "pushback/common/exercise/shown.h"

namespace pushback::exercise_13 {

namespace {

/// From B's centre to its slider, from there to the rail, and around it.
std::vector<Vec3> line_of(const RoundRail& rail, const Body& a, const Body& b) {
  const Vec3 centre = point_of(a, rail.centre), axis = a.orientation * rail.axis, slider = point_of(b, rail.slider);
  const Vec3 d = slider - centre, out = (d - axis.dot(d) * axis).normalized(), aside = axis.cross(out);
  constexpr int pieces = 48;
  std::vector<Vec3> corners{b.position, slider};
  for (int i = 0; i <= pieces; ++i) {
    const Real angle = 2 * pi * static_cast<Real>(i) / pieces;
    corners.emplace_back(centre + rail.radius * (std::cos(angle) * out + std::sin(angle) * aside));
  }
  return corners;
}

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
    world.joints.push_back(
        {"your slider", 0, 1,
         [its = rail, answer](const Body& first, const Body& second, const TimeStep&, Equations& equations) {
           answer.ask(its, first, second, equations);
         },
         [its = rail](const Body& first, const Body& second) { return line_of(its, first, second); }});
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
  /// Of the slider, as seen from the rail.
  struct Speeds {
    Real outwards, out_of_the_plane, along;
  };
  Speeds speeds() {
    const Vec3 v = b().velocity_at(slider()) - a().velocity_at(slider()), out = across().normalized();
    return {v.dot(out), v.dot(axis()), v.dot(axis().cross(out))};
  }
  Vec3 angular_momentum() const {
    Vec3 sum = Vec3::Zero();
    for (const Body& body : world.bodies)
      sum += body.inverse_inertia.inverse() * body.angular_velocity +
             body.position.cross(body.velocity) / body.inverse_mass;
    return sum;
  }
};

Body random_box(Random& random) {
  const Real x = random.between(Real(0.2), Real(0.4)), y = random.between(Real(0.2), Real(0.4));
  return box({x, y, Real(0.3)}, random.between(5, 20));
}
Vec3 random_corner(Random& random) {
  return random.between(Real(0.3), Real(0.5)) * random.direction();
}

std::vector<Check<Answer>> checks() {
  return {
      {"a ball on a rail that does not move stays on it, after a single sweep, and slides on as it did",
       2,
       {{"your ball leaves the ring with", "m/s", 1e-6},
        {"your ball leaves the plane of the rail with", "m/s", 1e-6},
        {"along the rail your ball goes with", "m/s", 1e-6}},
       [](Random& random, const Answer& answer) -> Numbers {
         Railed railed(random, random_box(random).fixed(), sphere(Real(0.1), random.between(2, 10)), Vec3::Zero(),
                       answer);
         const Vec3 out = railed.across().normalized(), axis = railed.axis();
         const Real outwards = random.between(1, 3), off = random.between(1, 3), along = random.between(1, 3);
         railed.b().velocity = outwards * out + off * axis + along * axis.cross(out);
         Solver<Joints> solver;
         solver.solve(railed.world, Real(0.02), 1);
         show(railed.world);
         const auto [leaves, rises, slides] = railed.speeds();
         return {leaves, rises, slides};
       }},
      {"the slider of a box stays on the rail of another box, and angular momentum is conserved",
       2,
       {{"seen from the rail, your slider leaves it with", "m/s", 1e-6},
        {"the angular momentum of both boxes together changes by", "N m s", 1e-6},
        {"seen from the rail, your slider goes along it with", "m/s", 1e-6}},
       [](Random& random, const Answer& answer) -> Numbers {
         const Body a = random_box(random), b = random_box(random);
         Railed railed(random, a, b, random_corner(random), answer);
         for (Body& body : railed.world.bodies) {
           body.velocity = random.vector(3);
           body.angular_velocity = random.vector(3);
         }
         const Vec3 before = railed.angular_momentum();
         Solver<Joints> solver;
         solver.solve(railed.world, Real(0.02), 2000);
         show(railed.world);
         const auto [leaves, rises, slides] = railed.speeds();
         return {std::hypot(leaves, rises), (railed.angular_momentum() - before).norm(), slides};
       }},
      {"a slider that is off its rail comes back by the part β in a step",
       2,
       {{"after a step your slider is off the plane of its rail by", "mm", 0.3},
        {"after a step your slider is too far from the middle of its rail by", "mm", 0.3},
        {"after a step your slider, which was below the plane, is off it by", "mm", 0.3},
        {"while it comes back, the angular momentum of both boxes together changes by", "N m s", 1e-6}},
       [](Random& random, const Answer& answer) -> Numbers {
         const Body a = random_box(random), b = random_box(random);
         Railed railed(random, a, b, random_corner(random), answer);
         railed.b().position += random.between(Real(0.01), Real(0.015)) * railed.axis() +
                                random.between(Real(0.01), Real(0.015)) * railed.across().normalized();
         Solver<Joints> solver;
         solver.beta = random.between(Real(0.3), Real(0.6));
         Railed pushed = railed;  // by impulses alone: what turns in a step changes its inertia
         Solver<Joints> pushing = solver;
         pushing.solve(pushed.world, Real(0.02), 1);
         show(pushed.world, {3});
         const Real made = pushed.angular_momentum().norm();  // they were at rest
         railed.world.step(solver, Real(0.02), 2000);
         show(railed.world, {0, 1});
         const Body other_a = random_box(random), other_b = random_box(random);
         Railed below(random, other_a, other_b, random_corner(random), answer);
         below.b().position -= random.between(Real(0.01), Real(0.015)) * below.axis();
         below.world.step(solver, Real(0.02), 2000);
         show(below.world, {2});
         return {1000 * railed.off_the_plane(), 1000 * (railed.across().norm() - railed.rail.radius),
                 1000 * below.off_the_plane(), made};
       }},
  };
}

/// How the rail stands, and where the slider is, in world axes.
struct Seen {
  Vec3 middle, axis, slider;
  Seen(const RoundRail& rail, const Body& a, const Body& b)
      : middle(point_of(a, rail.centre)), axis(a.orientation * rail.axis), slider(point_of(b, rail.slider)) {}
};

/// The two rows of it.
void two_rows(const Seen& seen, Real radius, const Body& a, const Body& b, Equations& rows) {
  const Vec3 d = seen.slider - seen.middle;
  const Vec3 across = d - d.dot(seen.axis) * seen.axis;
  rows.push_back({.jacobian = Jacobian::along(seen.axis, a, b, seen.slider), .error = d.dot(seen.axis)});
  rows.push_back(
      {.jacobian = Jacobian::along(across.normalized(), a, b, seen.slider), .error = across.norm() - radius});
}

void right(const RoundRail& rail, const Body& a, const Body& b, Equations& rows) {
  two_rows(Seen(rail, a, b), rail.radius, a, b, rows);
}

std::vector<Mistake<Answer>> mistakes() {
  const std::string arm_to_q =
      "it looks as if A's arm ended at Q. As A turns, m turns with it, and the rail sweeps past the slider: A feels "
      "the force where it acts, at P. Two equal and opposite forces at two points make a torque out of nothing.";
  const std::string in_world =
      "it looks as if the rail did not turn with A. centre and axis are in A's axes: point_of(a, rail.centre) and "
      "a.orientation * rail.axis are where they are now.";
  const std::string unit =
      "it looks as if n of the ring were as long as the radius. A row takes n as a unit vector: it counts the masses "
      "once, and its J V as metres a second.";
  const std::string away =
      "it looks as if C had the wrong sign against J. J V has to be how fast C grows: otherwise the feedback drives "
      "the slider farther off.";
  const std::string held =
      "it looks as if a row held the slider along the rail. n is the direction in which C grows: m for the plane, "
      "straight away from the axis for the ring. Along the rail neither of the two grows.";
  const std::string arms =
      "it looks as if a row knew nothing of how a body turns. The force acts at P on both, so a turn of each moves the "
      "slider against the rail.";
  const std::string minus =
      "it looks as if r_A × n had the wrong sign. J = [-n, -r_A × n, n, r_B × n] has its minus in the row: ra_n is r_A "
      "× n.";
  return {
      {"A's arm to the middle", arm_to_q, {[](const RoundRail& rail, const Body& a, const Body& b, Equations& rows) {
         right(rail, a, b, rows);
         for (Equation& row : rows) row.jacobian.ra_n = (point_of(a, rail.centre) - a.position).cross(row.jacobian.n);
       }}},
      {"A's arm to the middle", arm_to_q, {[](const RoundRail& rail, const Body& a, const Body& b, Equations& rows) {
         right(rail, a, b, rows);  // seen only off the plane: on it n of the ring points from Q to P
         rows[1].jacobian.ra_n = (point_of(a, rail.centre) - a.position).cross(rows[1].jacobian.n);
       }}},
      {"A's arm to the middle", arm_to_q, {[](const RoundRail& rail, const Body& a, const Body& b, Equations& rows) {
         right(rail, a, b, rows);
         rows[0].jacobian.ra_n = (point_of(a, rail.centre) - a.position).cross(rows[0].jacobian.n);
       }}},
      {"C without a sign",
       "it looks as if C₁ were a distance from the plane, without a sign. On the other side of the plane the feedback "
       "then drives the slider farther off: C₁ = m · d may be negative.",
       {[](const RoundRail& rail, const Body& a, const Body& b, Equations& rows) {
         right(rail, a, b, rows);
         rows[0].error = std::abs(rows[0].error);
       }}},
      {"R forgotten",
       "it looks as if R were left out of C₂. The slider is on its rail at R from the axis: C₂ = ρ - R.",
       {[](const RoundRail& rail, const Body& a, const Body& b, Equations& rows) {
         right(rail, a, b, rows);
         rows[1].error += rail.radius;
       }}},
      {"C of squares",
       "it looks as if C₂ were ρ² - R². C' is n · v only where C is a length: with squares the feedback is 2R times as "
       "large.",
       {[](const RoundRail& rail, const Body& a, const Body& b, Equations& rows) {
         right(rail, a, b, rows);
         const Real length = rows[1].error + rail.radius;
         rows[1].error = length * length - rail.radius * rail.radius;
       }}},
      {"the rail in the world's axes",
       in_world,
       {[](const RoundRail& rail, const Body& a, const Body& b, Equations& rows) {
         Seen seen(rail, a, b);
         seen.axis = rail.axis;
         two_rows(seen, rail.radius, a, b, rows);
       }}},
      {"the rail in the world's axes",
       in_world,
       {[](const RoundRail& rail, const Body& a, const Body& b, Equations& rows) {
         Seen seen(rail, a, b);
         seen.middle = a.position + rail.centre;
         two_rows(seen, rail.radius, a, b, rows);
       }}},
      {"the rail in the world's axes",
       in_world,
       {[](const RoundRail& rail, const Body& a, const Body& b, Equations& rows) {
         Seen seen(rail, a, b);
         seen.middle = a.position + rail.centre;
         seen.axis = rail.axis;
         two_rows(seen, rail.radius, a, b, rows);
       }}},
      {"the rail about A's centre",
       "it looks as if the rail went round A's centre of mass. It goes round Q, which A carries elsewhere.",
       {[](const RoundRail& rail, const Body& a, const Body& b, Equations& rows) {
         Seen seen(rail, a, b);
         seen.middle = a.position;
         two_rows(seen, rail.radius, a, b, rows);
       }}},
      {"B's centre for the slider",
       "it looks as if B's centre of mass were on the rail. It is the point P which slides, and B turns about it.",
       {[](const RoundRail& rail, const Body& a, const Body& b, Equations& rows) {
         Seen seen(rail, a, b);
         seen.slider = b.position;
         two_rows(seen, rail.radius, a, b, rows);
       }}},
      {"n no unit vector", unit, {[](const RoundRail& rail, const Body& a, const Body& b, Equations& rows) {
         right(rail, a, b, rows);
         const Real length = rows[1].error + rail.radius;
         rows[1].jacobian = Jacobian::along(length * rows[1].jacobian.n, a, b, point_of(b, rail.slider));
       }}},
      {"n no unit vector", unit, {[](const RoundRail& rail, const Body& a, const Body& b, Equations& rows) {
         right(rail, a, b, rows);
         const Real length = rows[1].error + rail.radius;
         rows[1].jacobian = Jacobian::along(length * rows[1].jacobian.n, a, b, point_of(b, rail.slider));
         rows[1].error = (length * length - rail.radius * rail.radius) / 2;
       }}},
      {"no row for the plane",
       "it looks as if nothing kept the slider in the plane of its rail. The slider has two rows: C₁ and C₂.",
       {[](const RoundRail& rail, const Body& a, const Body& b, Equations& rows) {
         right(rail, a, b, rows);
         rows.erase(rows.begin());
       }}},
      {"no row for the ring",
       "it looks as if nothing kept the slider at R from the axis. The slider has two rows: C₁ and C₂.",
       {[](const RoundRail& rail, const Body& a, const Body& b, Equations& rows) {
         right(rail, a, b, rows);
         rows.pop_back();
       }}},
      {"held along the rail", held, {[](const RoundRail& rail, const Body& a, const Body& b, Equations& rows) {
         right(rail, a, b, rows);
         rows.push_back({.jacobian = Jacobian::along(rows[0].jacobian.n.cross(rows[1].jacobian.n), a, b,
                                                     point_of(b, rail.slider))});
       }}},
      {"held along the rail", held, {[](const RoundRail& rail, const Body& a, const Body& b, Equations& rows) {
         right(rail, a, b, rows);
         rows[1].jacobian =
             Jacobian::along(rows[0].jacobian.n.cross(rows[1].jacobian.n), a, b, point_of(b, rail.slider));
       }}},
      {"no arms", arms, {[](const RoundRail& rail, const Body& a, const Body& b, Equations& rows) {
         right(rail, a, b, rows);
         for (Equation& row : rows) row.jacobian.ra_n = Vec3::Zero();
       }}},
      {"no arms", arms, {[](const RoundRail& rail, const Body& a, const Body& b, Equations& rows) {
         right(rail, a, b, rows);
         for (Equation& row : rows) row.jacobian.rb_n = Vec3::Zero();
       }}},
      {"no arms", arms, {[](const RoundRail& rail, const Body& a, const Body& b, Equations& rows) {
         right(rail, a, b, rows);
         for (Equation& row : rows) row.jacobian.ra_n = row.jacobian.rb_n = Vec3::Zero();
       }}},
      {"sign of r_A × n", minus, {[](const RoundRail& rail, const Body& a, const Body& b, Equations& rows) {
         right(rail, a, b, rows);
         for (Equation& row : rows) row.jacobian.ra_n *= -1;
       }}},
      {"n × r",
       "it looks as if the arms were n × r. The turn ω moves the point by ω × r, and n · (ω × r) = (r × n) · ω.",
       {[](const RoundRail& rail, const Body& a, const Body& b, Equations& rows) {
         right(rail, a, b, rows);
         for (Equation& row : rows) {
           row.jacobian.ra_n *= -1;
           row.jacobian.rb_n *= -1;
         }
       }}},
      {"C forgotten",
       "it looks as if C were 0. The rows then keep the slider from leaving its rail any farther, but the error stays.",
       {[](const RoundRail& rail, const Body& a, const Body& b, Equations& rows) {
         right(rail, a, b, rows);
         for (Equation& row : rows) row.error = 0;
       }}},
      {"sign of C", away, {[](const RoundRail& rail, const Body& a, const Body& b, Equations& rows) {
         right(rail, a, b, rows);
         for (Equation& row : rows) row.error *= -1;
       }}},
      {"sign of C", away, {[](const RoundRail& rail, const Body& a, const Body& b, Equations& rows) {
         right(rail, a, b, rows);
         rows[0].error *= -1;
       }}},
      {"sign of C", away, {[](const RoundRail& rail, const Body& a, const Body& b, Equations& rows) {
         right(rail, a, b, rows);
         rows[1].error *= -1;
       }}},
  };
}

}  // namespace

Numbers play(std::size_t check, Random& random, const Answer& answer) {
  return checks()[check].play(random, answer);
}

Exercise exercise() {
  return exercise_of<Answer>("a slider on a round rail",
                             {"Go round with A: seen from there, m and Q stand still, and C₁ and C₂ depend on where P "
                              "is, on nothing else. In which direction does each grow by a metre a metre?",
                              "n = m for the plane; n = (d - (m · d) m) / ρ for the ring. C' is n times the speed of P "
                              "against the point of A that is at the same place now.",
                              "Both arms end at P: r_A = P - a.position, r_B = P - b.position."},
                             checks(), {right}, mistakes());
}

}  // namespace pushback::exercise_13
