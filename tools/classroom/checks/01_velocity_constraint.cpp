#include "pushback/chapters/00_naive_impulses/exercise/touching.h"
#include "pushback/chapters/01_velocity_constraint/exercise/asked.h"
#include "pushback/chapters/01_velocity_constraint/solver.h"
#include "pushback/common/exercise/shown.h"

namespace pushback::exercise_01 {

namespace {

using exercise_00::TwoBalls;
using exercise_00::TwoBars;
using Spin = TwoBars::Spin;
using Axes = TwoBars::Axes;

constexpr Real e = Real(0.5);  // no row of this chapter asks for it

void solve(World& world, int sweeps, const Answer& answer) {
  answer.solve(world, sweeps);
  show(world);
}

std::vector<Check<Answer>> checks() {
  return {
      {"two balls that meet head on go on together",
       1,
       {{"your ball A goes on with", "m/s", 1e-6}, {"your ball B goes on with", "m/s", 1e-6}},
       [](Random& random, const Answer& answer) -> Numbers {
         TwoBalls balls(random, -random.between(3, 5), e);
         solve(balls.world, 1, answer);
         return {balls.along_n(0), balls.along_n(1)};
       }},
      {"balls that were leaving go on together, too: JV = 0 holds them",
       1,
       {{"your ball A, which was leaving B, goes on with", "m/s", 1e-6}},
       [](Random& random, const Answer& answer) -> Numbers {
         TwoBalls balls(random, random.between(3, 5), e);
         solve(balls.world, 1, answer);
         return {balls.along_n(0)};
       }},
      {"points on the ends of two bars keep their distance, and the bars turn",
       2,
       {{"the points of your bars separate with", "m/s", 1e-6},
        {"your bar A turns with", "rad/s", 1e-6},
        {"your bar B turns with", "rad/s", 1e-6}},
       [](Random& random, const Answer& answer) -> Numbers {
         TwoBars bars(random, -random.between(3, 5), e, Spin::some);
         solve(bars.world, 1, answer);
         return {bars.separates(), bars.spin(0), bars.spin(1)};
       }},
      {"the same holds for bars that lie askew",
       1,
       {{"the points of your bars, which lie askew, separate with", "m/s", 1e-6},
        {"your bar A, which lies askew, turns with", "rad/s", 1e-6},
        {"your bar B, which lies askew, turns with", "rad/s", 1e-6}},
       [](Random& random, const Answer& answer) -> Numbers {
         TwoBars bars(random, -random.between(3, 5), e, Spin::some, Axes::turned);
         solve(bars.world, 1, answer);
         return {bars.separates(), bars.spin(0), bars.spin(1)};
       }},
      {"a column that lands on its four corners stops within twenty sweeps",
       2,
       {{"after twenty sweeps your column moves up with", "m/s", 1e-6},
        {"your column turns with", "rad/s", 1e-6},
        {"your column slides on with", "m/s", 1e-6}},
       [](Random& random, const Answer& answer) -> Numbers {
         World world;
         const Real width = random.between(Real(0.26), Real(0.28)), height = random.between(Real(0.7), Real(0.75));
         world.add(ground());
         world.add(box({width, height, width}, random.between(50, 150))
                       .at({0, height - Real(0.001), 0})
                       .moving({random.between(1, 2), -random.between(2, 4), 0})
                       .bouncy(e));
         world.find_contacts();
         solve(world, 20, answer);
         const Body& column = world.bodies[1];
         return {column.velocity.y(), column.angular_velocity.norm(), column.velocity.x()};
       }},
  };
}

/// What a mistake makes of a row in one visit.
template <class Visit>
Answer visiting(Visit visit) {
  return {[visit](World& world, int sweeps) {
    for (int sweep = 0; sweep < sweeps; ++sweep) {
      for (std::size_t i = 0; i < world.contacts.size(); ++i) {
        Row row(world, world.contacts[i], world.contacts[i].normal, i);
        visit(row);
      }
    }
  }};
}

/// What would make J V = 0 if it were `speed`.
void stop(Row& row, Real speed) {
  row.apply(-row.effective_mass * speed);
}

Mat3 in_body_axes(const Body& body) {
  return body.principal_inverse_inertia.asDiagonal();
}

void right(World& world, int sweeps) {
  Solver<> solver;
  solver.solve(world, 1, sweeps);
}

std::vector<Mistake<Answer>> mistakes() {
  const std::string order =
      "it looks as if the torque were n × r, or the speed of a point r × ω. It is r × n and ω × r: an impulse on the "
      "left of the centre, upwards, turns a body clockwise.";
  const std::string arm =
      "it looks as if A's arm had the wrong sign. r_A leads from A's centre of mass to the point, and in J it stands "
      "with a minus, as A's n does: A's motion is subtracted, and A gets the opposite impulse.";
  const std::string axes =
      "it looks as if the inertia were that of body axes. Once a body is turned, its moments are about other axes than "
      "those of the world: inverse_inertia is turned already, principal_inverse_inertia is not.";
  const std::string held =
      "it looks as if your contact only pushed. That is what a contact should do, and chapter 02 makes it so. Here the "
      "row is an equality, JV = 0: it also pulls, and λ may be negative.";
  const std::string old =
      "it looks as if each row used the velocities of before the sweep. Four rows then push against the same fall, "
      "each as if it were alone. A row has to see what those before it have done.";
  const std::string one_turns =
      "it looks as if K had the turn of one body alone. The impulse turns both, and each makes the point give way more "
      "easily: (r × n) · I⁻¹ (r × n) of A and of B.";
  const std::string one_in_K =
      "it looks as if K knew one of the bodies alone. The impulse moves both of them: K = J M⁻¹ Jᵀ has four parts.";
  const std::string one_in_J =
      "it looks as if J had one of the bodies alone. Both points may move: J V is the speed of B's minus that of A's.";
  const std::string one_spin =
      "it looks as if the spin of one body were left out of J V. Its point moves by it, too: -(r_A × n) · ω_A + (r_B × "
      "n) · ω_B.";
  const std::string one_moved =
      "it looks as if one body alone had felt the impulse, so that momentum came out of nothing. M⁻¹ Jᵀ λ changes the "
      "velocities of both.";
  const std::string one_turned =
      "it looks as if the impulse turned one body alone. It acts beside the centre of mass of both: each gets the "
      "moment of its own arm.";
  const std::string inertia_of =
      "it looks as if one body had the inertia of the other. Each resists its turn by its own: I_A⁻¹ with r_A × n, "
      "I_B⁻¹ with r_B × n.";
  const std::string some =
      "it looks as if some contacts were left out. All four corners carry the column: in each sweep, each has its "
      "turn.";
  const auto weighed = [](Row& row, Real K) { row.effective_mass = 1 / K; };
  const auto turn = [](const Body& body, const Mat3& inverse_inertia, const Vec3& lever) {
    return body.movable() ? lever.dot(inverse_inertia * lever) : Real(0);
  };
  const auto turned = [weighed](Row& row, const Body& of_a, const Body& of_b) {
    row.dwa = -(of_a.inverse_inertia * row.ra_n);
    row.dwb = of_b.inverse_inertia * row.rb_n;
    weighed(row, row.a->inverse_mass + row.b->inverse_mass + row.ra_n.dot(of_a.inverse_inertia * row.ra_n) +
                     row.rb_n.dot(of_b.inverse_inertia * row.rb_n));
  };
  const auto first_contacts = [](std::size_t most) {
    return Answer{[most](World& world, int sweeps) {
      for (int sweep = 0; sweep < sweeps; ++sweep) {
        for (std::size_t i = 0; i < std::min(most, world.contacts.size()); ++i)
          Row(world, world.contacts[i], world.contacts[i].normal, i).solve();
      }
    }};
  };
  return {
      {"K without the turn of one body", one_turns, visiting([weighed, turn](Row& row) {
         weighed(row, row.a->inverse_mass + row.b->inverse_mass + turn(*row.a, row.a->inverse_inertia, row.ra_n));
         row.solve();
       })},
      {"K without the turn of one body", one_turns, visiting([weighed, turn](Row& row) {
         weighed(row, row.a->inverse_mass + row.b->inverse_mass + turn(*row.b, row.b->inverse_inertia, row.rb_n));
         row.solve();
       })},
      {"K of one body", one_in_K, visiting([weighed](Row& row) {
         weighed(row, row.a->inverse_mass + row.ra_n.dot(row.a->inverse_inertia * row.ra_n));
         row.solve();
       })},
      {"K of one body", one_in_K, visiting([weighed](Row& row) {
         weighed(row, row.b->inverse_mass + row.rb_n.dot(row.b->inverse_inertia * row.rb_n));
         row.solve();
       })},
      {"one body's inertia for both", inertia_of, visiting([weighed](Row& row) {
         weighed(row, row.a->inverse_mass + row.b->inverse_mass + row.ra_n.dot(row.a->inverse_inertia * row.ra_n) +
                          row.rb_n.dot(row.a->inverse_inertia * row.rb_n));
         row.solve();
       })},
      {"one body's inertia for both", inertia_of, visiting([weighed](Row& row) {
         weighed(row, row.a->inverse_mass + row.b->inverse_mass + row.ra_n.dot(row.b->inverse_inertia * row.ra_n) +
                          row.rb_n.dot(row.b->inverse_inertia * row.rb_n));
         row.solve();
       })},
      {"one body's inertia for both", inertia_of, visiting([turned](Row& row) {
         turned(row, *row.a, *row.a);
         row.solve();
       })},
      {"one body's inertia for both", inertia_of, visiting([turned](Row& row) {
         turned(row, *row.b, *row.b);
         row.solve();
       })},
      {"J of one body", one_in_J,
       visiting([](Row& row) { stop(row, -row.n.dot(row.a->velocity) - row.ra_n.dot(row.a->angular_velocity)); })},
      {"J of one body", one_in_J,
       visiting([](Row& row) { stop(row, row.n.dot(row.b->velocity) + row.rb_n.dot(row.b->angular_velocity)); })},
      {"J of one body", one_in_J, visiting([weighed](Row& row) {
         weighed(row, row.a->inverse_mass + row.ra_n.dot(row.a->inverse_inertia * row.ra_n));
         row.dvb = row.dwb = Vec3::Zero();
         stop(row, -row.n.dot(row.a->velocity) - row.ra_n.dot(row.a->angular_velocity));
       })},
      {"J of one body", one_in_J, visiting([weighed](Row& row) {
         weighed(row, row.b->inverse_mass + row.rb_n.dot(row.b->inverse_inertia * row.rb_n));
         row.dva = row.dwa = Vec3::Zero();
         stop(row, row.n.dot(row.b->velocity) + row.rb_n.dot(row.b->angular_velocity));
       })},
      {"one body's spin left out", one_spin,
       visiting([](Row& row) { stop(row, row.speed() + row.ra_n.dot(row.a->angular_velocity)); })},
      {"one body's spin left out", one_spin,
       visiting([](Row& row) { stop(row, row.speed() - row.rb_n.dot(row.b->angular_velocity)); })},
      {"one body moved", one_moved, visiting([](Row& row) {
         row.dva = row.dwa = Vec3::Zero();
         stop(row, row.speed());
       })},
      {"one body moved", one_moved, visiting([](Row& row) {
         row.dvb = row.dwb = Vec3::Zero();
         stop(row, row.speed());
       })},
      {"one body turned", one_turned, visiting([](Row& row) {
         row.dwa.setZero();
         stop(row, row.speed());
       })},
      {"one body turned", one_turned, visiting([](Row& row) {
         row.dwb.setZero();
         stop(row, row.speed());
       })},
      {"contacts left out", some, first_contacts(1)},
      {"contacts left out", some, first_contacts(2)},
      {"contacts left out", some, first_contacts(3)},
      {"not applied", "it looks as if no velocity changed. V += M⁻¹ Jᵀ λ, for both bodies.", visiting([](Row&) {})},
      {"sign of λ", "it looks as if λ had the wrong sign. It has to undo JV, so λ = -JV / K.",
       visiting([](Row& row) { stop(row, -row.speed()); })},
      {"multiplied by K",
       "it looks as if JV were multiplied by K, or by the masses' inverses. K is the speed that a newton second makes; "
       "divide by it.",
       visiting([](Row& row) { row.apply(-row.speed() / row.effective_mass); })},
      {"both pushed the same way",
       "it looks as if A and B got the same impulse. The first half of J has a minus: what B gains in momentum, A "
       "loses.",
       visiting([](Row& row) {
         row.dva = -row.dva;
         row.dwa = -row.dwa;
         stop(row, row.speed());
       })},
      {"a bounce",
       "it looks as if e were in it. Here b = 0: the points are to keep their distance. Bounces come in chapter 05.",
       visiting([](Row& row) { stop(row, (1 + e) * row.speed()); })},
      {"only a push", held, visiting([](Row& row) { stop(row, std::min(Real(0), row.speed())); })},
      {"only a push", held, {[](World& world, int sweeps) {
         Rows rows;
         for (std::size_t i = 0; i < world.contacts.size(); ++i) {
           rows.emplace_back(world, world.contacts[i], world.contacts[i].normal, i);
           rows.back().lo = 0;
         }
         for (int sweep = 0; sweep < sweeps; ++sweep)
           for (Row& row : rows) row.solve();
       }}},
      {"n × r for r × n", order, visiting([](Row& row) {
         row.ra_n = -row.ra_n;
         row.rb_n = -row.rb_n;
         row.weigh();
         row.solve();
       })},
      {"n × r for r × n", order, visiting([](Row& row) {
         const Real speed = row.speed();
         row.dwa = -row.dwa;
         row.dwb = -row.dwb;
         stop(row, speed);
       })},
      {"n × r for r × n", order, visiting([](Row& row) {
         row.ra_n = -row.ra_n;
         row.rb_n = -row.rb_n;
         stop(row, row.speed());
       })},
      {"sign of A's arm", arm, visiting([](Row& row) {
         row.ra_n = -row.ra_n;
         row.weigh();
         row.solve();
       })},
      {"sign of A's arm", arm, visiting([](Row& row) {
         row.ra_n = -row.ra_n;
         stop(row, row.speed());
       })},
      {"sign of A's arm", arm, visiting([](Row& row) {
         row.dwa = -row.dwa;
         stop(row, row.speed());
       })},
      {"speed of the centres",
       "it looks as if JV were the speed of the centres. It is that of the points: the spins are in V, and (r × n) in "
       "J.",
       visiting([](Row& row) { stop(row, row.n.dot(row.b->velocity - row.a->velocity)); })},
      {"K of the masses alone",
       "it looks as if K had only the masses in it. An impulse beside the centre turns the body as well, and the point "
       "gives way more easily than the mass says: (r × n) · I⁻¹ (r × n), for each body.",
       visiting([](Row& row) {
         row.effective_mass = 1 / (row.a->inverse_mass + row.b->inverse_mass);
         row.solve();
       })},
      {"no turn",
       "it looks as if the impulse changed no spin. It acts at the point, not at the centre: ω changes by I⁻¹ (r × n) "
       "λ.",
       visiting([](Row& row) {
         row.dwa.setZero();
         row.dwb.setZero();
         row.solve();
       })},
      {"inertia not turned", axes, visiting([](Row& row) {
         row.dwa = -in_body_axes(*row.a) * row.ra_n;
         row.dwb = in_body_axes(*row.b) * row.rb_n;
         row.solve();
       })},
      {"inertia not turned", axes, visiting([](Row& row) {
         const Mat3 a = in_body_axes(*row.a), b = in_body_axes(*row.b);
         row.effective_mass =
             1 / (row.a->inverse_mass + row.b->inverse_mass + row.ra_n.dot(a * row.ra_n) + row.rb_n.dot(b * row.rb_n));
         row.solve();
       })},
      {"inertia not turned", axes, visiting([](Row& row) {
         row.dwa = -in_body_axes(*row.a) * row.ra_n;
         row.dwb = in_body_axes(*row.b) * row.rb_n;
         row.effective_mass =
             1 / (row.a->inverse_mass + row.b->inverse_mass + row.rb_n.dot(row.dwb) - row.ra_n.dot(row.dwa));
         row.solve();
       })},
      {"velocities of before the sweep", old, {[](World& world, int sweeps) {
         for (int sweep = 0; sweep < sweeps; ++sweep) {
           std::vector<Real> speeds;
           for (const Contact& contact : world.contacts) speeds.push_back(separating_speed(world, contact));
           for (std::size_t i = 0; i < speeds.size(); ++i) {
             Row row(world, world.contacts[i], world.contacts[i].normal, i);
             stop(row, speeds[i]);
           }
         }
       }}},
      {"velocities of before the step",
       "it looks as if JV were computed once, before the first sweep. Then every sweep pushes against the same fall "
       "again. JV is computed anew before each impulse.",
       {[](World& world, int sweeps) {
         std::vector<Real> speeds;
         for (const Contact& contact : world.contacts) speeds.push_back(separating_speed(world, contact));
         for (int sweep = 0; sweep < sweeps; ++sweep) {
           for (std::size_t i = 0; i < speeds.size(); ++i) {
             Row row(world, world.contacts[i], world.contacts[i].normal, i);
             stop(row, speeds[i]);
           }
         }
       }}},
      {"one sweep",
       "it looks as if the rows were solved once. Each row disturbs those before it, less in each sweep: go over all "
       "rows `sweeps` times.",
       {[](World& world, int) { right(world, 1); }}},
  };
}

}  // namespace

Numbers play(std::size_t check, Random& random, const Answer& answer) {
  return checks()[check].play(random, answer);
}

Exercise exercise() {
  return exercise_of<Answer>(
      "a row, its J and K, and how an impulse is applied",
      {"J V is the speed at which the point of B moves away from that of A: n · (v_B - v_A) + (r_B × n) · ω_B - (r_A × "
       "n) · ω_A, with r from each centre of mass to the point.",
       "K is the change of J V by an impulse of 1 N s: 1/m_A + 1/m_B + (r_A × n) · I_A⁻¹ (r_A × n) + (r_B × n) · I_B⁻¹ "
       "(r_B × n). Then λ = -J V / K.",
       "v_B += λ n / m_B, ω_B += I_B⁻¹ (r_B × n) λ; on A the same with a minus. Do it at once, before the next row."},
      checks(), {right}, mistakes());
}

}  // namespace pushback::exercise_01
