#include "pushback/chapters/13_joints/exercise/asked.h"
#include "pushback/chapters/13_joints/hinge.h"
#include "pushback/chapters/13_joints/joints.h"
#include "pushback/common/exercise/shown.h"

namespace pushback::exercise_13 {

namespace {

bool of_the_point(const Equation& row) {
  return !row.jacobian.n.isZero(0);
}

/// Two boxes that move, on the answer's hinge, and have turned with it since it was made.
struct Hinged {
  World world;
  Vec3 on_a, on_b, axis_a, axis_b;  // the pin, body axes
  Vec3 aside;                       // across the axis, A's axes: half way between the two directions of the rows

  Hinged(Random& random, const Answer& answer) {
    const Vec3 anchor = random.vector(1), axis = random.direction();
    for (int i = 0; i < 2; ++i) {
      const Real x = random.between(Real(0.2), Real(0.4)), y = random.between(Real(0.2), Real(0.4));
      const Real mass = random.between(5, 20);
      Body body = box({x, y, Real(0.3)}, mass).at(anchor + Real(0.6) * random.direction());
      body.orientation = random.orientation();
      body.velocity = random.vector(3);
      body.angular_velocity = random.vector(3);
      world.add(body);
    }
    on_a = point_on(a(), anchor), on_b = point_on(b(), anchor);
    axis_a = a().orientation.conjugate() * axis, axis_b = b().orientation.conjugate() * axis;
    const Tangents across = tangents_of(axis);
    aside = a().orientation.conjugate() * (across.tangent1 + across.tangent2).normalized();
    world.gravity.setZero();
    world.joints.push_back(answer.hinge(world, 0, 1, anchor, axis));
    const Quat turn = random.orientation();
    const Vec3 shift = random.vector(1);
    for (Body& body : world.bodies) {
      body.position = turn * body.position + shift;
      body.orientation = turn * body.orientation;
      body.refresh_inertia();
    }
  }
  Body& a() { return world.bodies[0]; }
  Body& b() { return world.bodies[1]; }
  Vec3 pin_of_a() { return point_of(a(), on_a); }
  Vec3 pin_of_b() { return point_of(b(), on_b); }
  Vec3 axis() { return a().orientation * axis_a; }
  Vec3 angular_momentum() const {
    Vec3 sum = Vec3::Zero();
    for (const Body& body : world.bodies)
      sum += body.inverse_inertia.inverse() * body.angular_velocity +
             body.position.cross(body.velocity) / body.inverse_mass;
    return sum;
  }
  /// Only the rows of the point, or only the others, to the end.
  void solve_rows(bool point) {
    Equations equations;
    world.joints[0].ask(a(), b(), {0, Real(0.02)}, equations);
    JointRows rows;
    for (const Equation& equation : equations) {
      if (of_the_point(equation) != point) continue;
      rows.emplace_back(a(), b(), equation.jacobian, 0, equation.softness);
      rows.back().bias = 10 * equation.error;
    }
    for (int sweep = 0; sweep < 2000; ++sweep)
      for (JointRow& row : rows) row.solve();
    show(world);
  }
};

std::vector<Check<Answer>> checks() {
  return {
      {"the rows of the point keep it together, and conserve angular momentum",
       2,
       {{"the two points of your hinge part with", "m/s", 1e-6},
        {"the angular momentum of both boxes together changes by", "N m s", 1e-6},
        {"your box B leaves with", "m/s", 1e-6}},
       [](Random& random, const Answer& answer) -> Numbers {
         Hinged hinged(random, answer);
         const Vec3 before = hinged.angular_momentum();
         hinged.solve_rows(true);
         const Vec3 parts = hinged.b().velocity_at(hinged.pin_of_b()) - hinged.a().velocity_at(hinged.pin_of_a());
         return {parts.norm(), (hinged.angular_momentum() - before).norm(), hinged.b().velocity.norm()};
       }},
      {"the rows of the axis keep it straight, and let the hinge turn about it",
       2,
       {{"the axis of your hinge bends with", "rad/s", 1e-6}, {"about its axis your hinge turns with", "rad/s", 1e-6}},
       [](Random& random, const Answer& answer) -> Numbers {
         Hinged hinged(random, answer);
         hinged.solve_rows(false);
         const Vec3 turns = hinged.b().angular_velocity - hinged.a().angular_velocity, axis = hinged.axis();
         return {axis.cross(turns).norm(), axis.dot(turns)};
       }},
      {"a hinge that is off comes back by the part β in a step",
       2,
       {{"after a step the two points of your hinge are apart by", "mm", 0.05},
        {"after a step the two axes of your hinge lean apart by", "mrad", 0.05}},
       [](Random& random, const Answer& answer) -> Numbers {
         Hinged hinged(random, answer);
         for (Body& body : hinged.world.bodies) body.moving(Vec3::Zero()).spinning(Vec3::Zero());
         const Real lean = random.between(Real(0.005), Real(0.008)), gap = random.between(Real(0.005), Real(0.008));
         const Vec3 pin = hinged.pin_of_b();
         hinged.b().turned(lean, hinged.a().orientation * hinged.aside);
         hinged.b().position += pin - hinged.pin_of_b() + gap * random.direction();
         Solver<Joints> solver;
         solver.beta = random.between(Real(0.3), Real(0.6));
         hinged.world.step(solver, Real(0.02), 2000);
         show(hinged.world);
         return {1000 * (hinged.pin_of_b() - hinged.pin_of_a()).norm(),
                 1000 * hinged.axis().cross(hinged.b().orientation * hinged.axis_b).norm()};
       }},
  };
}

/// What the right hinge asks of bodies that stand like this: three rows of the point, two of the axis.
using Asking = std::function<Equations(const Body& a, const Body& b)>;
/// The five rows in their place. `made`: the bodies as they stood when the hinge was made.
using Asked =
    std::function<Equations(const Asking& ask, const Body& a, const Body& b, const std::array<Body, 2>& made)>;

Answer mistaken(const Asked& asked) {
  return {[asked](const World& world, int a, int b, const Vec3& anchor, const Vec3& axis) {
    Joint joint = hinge(world, a, b, anchor, axis);
    const auto ask = [right = joint.ask](const Body& first, const Body& second) {
      Equations equations;
      right(first, second, {}, equations);
      return equations;
    };
    const std::array<Body, 2> made{body_of(world, a), body_of(world, b)};
    joint.ask = [=](const Body& first, const Body& second, const TimeStep&, Equations& equations) {
      for (const Equation& row : asked(ask, first, second, made)) equations.push_back(row);
    };
    return joint;
  }};
}

/// Each row by itself.
Answer changed(const std::function<void(Equation& row, const Body& a, const Body& b)>& change) {
  return mistaken([change](const Asking& ask, const Body& a, const Body& b, const auto&) {
    Equations rows = ask(a, b);
    for (Equation& row : rows) change(row, a, b);
    return rows;
  });
}

/// The rows of the point by one, those of the axis by another.
Equations together(const Equations& point, const Equations& axis) {
  Equations rows(point.begin(), point.begin() + 3);
  rows.insert(rows.end(), axis.begin() + 3, axis.end());
  return rows;
}

Body not_turned(Body body) {
  body.orientation.setIdentity();
  return body;
}

std::vector<Mistake<Answer>> mistakes() {
  const std::string arm =
      "it looks as if r_A × n had the wrong sign. The minus of J = [-n, -r_A × n, n, r_B × n] is in the row already: "
      "with a second one the force of the row turns A the wrong way round.";
  const std::string side =
      "it looks as if the axis had a minus in A's place. Then the row stops ω_B + ω_A: both bodies are made to turn "
      "against each other, where they should turn together.";
  const std::string carried =
      "it looks as if the point stayed in axes that do not turn. It is fixed to its body, and goes round with it: "
      "point_of(first, on_a) is where it stands now.";
  const std::string in_world =
      "it looks as if the axis stood in world axes. s₁ and s₂ turn with A and u turns with B: as soon as the bodies "
      "have turned, an axis that has not is the axis of another hinge.";
  const std::string one =
      "it looks as if there were only one direction across the axis. One row stops the bending about one axis: what is "
      "left is a universal joint, with two ways to turn.";
  const std::string away =
      "it looks as if C had the wrong sign against J. J V has to be how fast C grows: otherwise the feedback drives "
      "the bodies farther off. C is that of P_B - P_A, and the axis is u × s, in this order.";
  const std::string about =
      "it looks as if a row turned about s. The angle between s and u changes about the axis that is perpendicular to "
      "both, u × s.";
  const std::string held =
      "it looks as if the turn about the hinge's own axis were stopped. This turn is the one freedom that a hinge "
      "leaves.";
  return {
      {"sign of r_A × n", arm, changed([](Equation& row, const Body&, const Body&) {
         if (of_the_point(row)) row.jacobian.ra_n *= -1;
       })},
      {"sign of r_A × n", arm, changed([](Equation& row, const Body&, const Body&) { row.jacobian.ra_n *= -1; })},
      {"n × r",
       "it looks as if the arms were n × r. The turn ω moves the point by ω × r, and n · (ω × r) = (r × n) · ω.",
       changed([](Equation& row, const Body&, const Body&) {
         if (!of_the_point(row)) return;
         row.jacobian.ra_n *= -1;
         row.jacobian.rb_n *= -1;
       })},
      {"arms exchanged", "it looks as if A had the arm of B, and B that of A.",
       changed([](Equation& row, const Body&, const Body&) { std::swap(row.jacobian.ra_n, row.jacobian.rb_n); })},
      {"arms from the origin",
       "it looks as if r went from the origin of the world to the point. An arm begins at the centre of mass of its "
       "body.",
       changed([](Equation& row, const Body& a, const Body& b) {
         row.jacobian.ra_n += a.position.cross(row.jacobian.n);
         row.jacobian.rb_n += b.position.cross(row.jacobian.n);
       })},
      {"no arms",
       "it looks as if the rows of the point knew nothing of turns. They then hold the centres of mass together, and "
       "not the points.",
       changed([](Equation& row, const Body&, const Body&) {
         if (of_the_point(row)) row.jacobian.ra_n = row.jacobian.rb_n = Vec3::Zero();
       })},
      {"the point not carried", carried, mistaken([](const Asking& ask, const Body& a, const Body& b, const auto&) {
         return together(ask(not_turned(a), not_turned(b)), ask(a, b));
       })},
      {"the point not carried", carried,
       mistaken([](const Asking& ask, const Body& a, const Body& b, const auto& made) {
         Equations rows = ask(a, b);  // where it was when the hinge was made, in the world
         const Equations then = ask(made[0], made[1]);
         for (std::size_t i = 0; i < 3; ++i) {
           rows[i].jacobian = then[i].jacobian;
           rows[i].jacobian.ra_n += (made[0].position - a.position).cross(rows[i].jacobian.n);
           rows[i].jacobian.rb_n += (made[1].position - b.position).cross(rows[i].jacobian.n);
           rows[i].error = 0;
         }
         return rows;
       })},
      {"sign of A's axis", side, changed([](Equation& row, const Body&, const Body&) {
         if (!of_the_point(row)) row.jacobian.ra_n *= -1;
       })},
      {"the axis in world axes", in_world, mistaken([](const Asking& ask, const Body& a, const Body& b, const auto&) {
         return together(ask(a, b), ask(not_turned(a), not_turned(b)));
       })},
      {"the axis in world axes", in_world, mistaken([](const Asking& ask, const Body& a, const Body& b, const auto&) {
         return together(ask(a, b), ask(not_turned(a), b));
       })},
      {"the axis in world axes", in_world, mistaken([](const Asking& ask, const Body& a, const Body& b, const auto&) {
         return together(ask(a, b), ask(a, not_turned(b)));
       })},
      {"the axis in world axes", in_world,
       mistaken([](const Asking& ask, const Body& a, const Body& b, const auto& made) {
         return together(ask(a, b), ask(a, made[1]));
       })},
      {"the axis in world axes", in_world,
       mistaken([](const Asking& ask, const Body& a, const Body& b, const auto& made) {
         return together(ask(a, b), ask(made[0], made[1]));
       })},
      {"one direction across", one, mistaken([](const Asking& ask, const Body& a, const Body& b, const auto&) {
         Equations rows = ask(a, b);
         rows[4] = rows[3];
         return rows;
       })},
      {"one direction across", one, mistaken([](const Asking& ask, const Body& a, const Body& b, const auto&) {
         Equations rows = ask(a, b);
         rows[3] = rows[4];
         return rows;
       })},
      {"about s", about, mistaken([](const Asking& ask, const Body& a, const Body& b, const auto&) {
         Equations rows = ask(a, b);
         const Vec3 k1 = rows[3].jacobian.rb_n, k2 = rows[4].jacobian.rb_n;
         rows[3].jacobian = Jacobian::about(-k2);  // s1 = -u × s2
         rows[4].jacobian = Jacobian::about(k1);
         return rows;
       })},
      {"its own axis held", held, mistaken([](const Asking& ask, const Body& a, const Body& b, const auto&) {
         Equations rows = ask(a, b);
         const Vec3 u = rows[3].jacobian.rb_n.cross(rows[4].jacobian.rb_n);
         rows[3].jacobian = rows[4].jacobian = Jacobian::about(u);
         return rows;
       })},
      {"its own axis held", held, mistaken([](const Asking& ask, const Body& a, const Body& b, const auto&) {
         Equations rows = ask(a, b);
         rows.push_back({.jacobian = Jacobian::about(rows[3].jacobian.rb_n.cross(rows[4].jacobian.rb_n))});
         return rows;
       })},
      {"a force from a turn",
       "it looks as if the rows of the axis had an n. They are between turns, so n is 0: otherwise they also push the "
       "bodies apart.",
       changed([](Equation& row, const Body&, const Body&) {
         if (!of_the_point(row)) row.jacobian.n = row.jacobian.rb_n;
       })},
      {"C forgotten",
       "it looks as if C were 0. The rows then keep the hinge from coming off any farther, but the error stays.",
       changed([](Equation& row, const Body&, const Body&) { row.error = 0; })},
      {"sign of C", away, changed([](Equation& row, const Body&, const Body&) { row.error *= -1; })},
      {"sign of C", away, changed([](Equation& row, const Body&, const Body&) {
         if (of_the_point(row)) row.error *= -1;
       })},
      {"sign of C", away, changed([](Equation& row, const Body&, const Body&) {
         if (!of_the_point(row)) row.error *= -1;
       })},
  };
}

}  // namespace

Numbers play(std::size_t check, Random& random, const Answer& answer) {
  return checks()[check].play(random, answer);
}

Exercise exercise() {
  return exercise_of<Answer>(
      "a hinge",
      {"Begin with the point: P_A = point_of(first, on_a), r_A = P_A - first.position, and so for B. For each axis n "
       "of the world, ra_n = r_A × n (r_a.cross(n)), and C is P_B - P_A along n.",
       "The axis: turn s1 and s2 with first.orientation, u with second.orientation. A row between turns has n = 0, and "
       "the same axis k = u × s / |u × s| in ra_n and rb_n.",
       "C of such a row: std::atan2(s.dot(u), u.cross(s).norm())."},
      checks(), {hinge}, mistakes());
}

}  // namespace pushback::exercise_13
