#include <tuple>

#include "pushback/chapters/00_naive_impulses/exercise/asked.h"
#include "pushback/chapters/00_naive_impulses/exercise/touching.h"
#include "pushback/chapters/00_naive_impulses/naive.h"
#include "pushback/common/exercise/shown.h"
#include "pushback/common/world/measure.h"

namespace pushback::exercise_00 {

namespace {

using Spin = TwoBars::Spin;
using Axes = TwoBars::Axes;

/// The ends separate (`way` = 1) or meet (-1) by their spins, and the centres the other way round, half as fast. The end of B
/// alone goes the other way than the ends do: what it does says nothing of the pair.
TwoBars spun_bars(Random& random, Real way, Real e) {
  TwoBars bars(random, 0, e, Spin::some, Axes::turned);
  if (way * bars.separates() < 0)
    for (Body& bar : bars.world.bodies) bar.angular_velocity *= -1;
  const Vec3 n = bars.contact().normal;
  bars.world.bodies[1].velocity -= bars.separates() / 2 * n;
  const Real end_of_b = n.dot(bars.world.bodies[1].velocity_at(bars.contact().point));
  const Vec3 both = -(bars.separates() / 2 + end_of_b) * n;
  for (Body& bar : bars.world.bodies) bar.velocity += both;
  return bars;
}

/// The impact of two bodies.
void meet(Touching& touching, const Answer& answer, const std::vector<std::size_t>& quantities = {}) {
  answer.impact(touching.world, touching.contact());
  show(touching.world, quantities);
}

std::vector<Check<Answer>> checks() {
  return {
      {"two balls that meet head on fly apart e times as fast as they met",
       1,
       {{"your ball A leaves with", "m/s", 1e-6}, {"your ball B leaves with", "m/s", 1e-6}},
       [](Random& random, const Answer& answer) -> Numbers {
         const Real e = random.between(Real(0.3), Real(0.8));
         TwoBalls balls(random, -random.between(3, 5), e);
         meet(balls, answer);
         return {balls.along_n(0), balls.along_n(1)};
       }},
      {"the ends of two bars separate e times as fast as they met, and the bars turn",
       1,
       {{"your bars separate with", "m/s", 1e-6},
        {"your bar A turns with", "rad/s", 1e-6},
        {"your bar B turns with", "rad/s", 1e-6}},
       [](Random& random, const Answer& answer) -> Numbers {
         const Real e = random.between(Real(0.3), Real(0.8));
         TwoBars bars(random, -random.between(3, 5), e);
         meet(bars, answer);
         return {bars.separates(), bars.spin(0), bars.spin(1)};
       }},
      {"at e = 1 bars that spin keep their energy",
       2,
       {{"your bars, which spin before they meet, separate with", "m/s", 1e-6},
        {"their energy has grown by", "J", 1e-6}},
       [](Random& random, const Answer& answer) -> Numbers {
         TwoBars bars(random, -random.between(3, 5), 1, Spin::some);
         const Real before = kinetic_energy(bars.world);
         meet(bars, answer);
         return {bars.separates(), kinetic_energy(bars.world) - before};
       }},
      {"the ends of bars that lie askew separate e times as fast as they met",
       1,
       {{"your bars, which lie askew, separate with", "m/s", 1e-6},
        {"your bar A, which lies askew, spins on with", "rad/s", 1e-6},
        {"your bar B, which lies askew, spins on with", "rad/s", 1e-6},
        {"your bars, whose ends meet though their centres part, separate with", "m/s", 1e-6}},
       [](Random& random, const Answer& answer) -> Numbers {
         const Real e = random.between(Real(0.3), Real(0.8));
         TwoBars bars(random, -random.between(3, 5), e, Spin::some, Axes::turned);
         meet(bars, answer, {0, 1, 2});
         TwoBars spun = spun_bars(random, -1, e);
         meet(spun, answer, {3});
         return {bars.separates(), bars.spin(0), bars.spin(1), spun.separates()};
       }},
      {"bodies that separate by themselves get no impulse",
       1,
       {{"your bars, which were separating by themselves, separate with", "m/s", 1e-6},
        {"your bars, whose ends part though their centres meet, separate with", "m/s", 1e-6}},
       [](Random& random, const Answer& answer) -> Numbers {
         const Real e = random.between(Real(0.3), Real(0.8));
         TwoBars bars(random, random.between(3, 5), e, Spin::some, Axes::turned);
         meet(bars, answer, {0});
         TwoBars spun = spun_bars(random, 1, e);
         meet(spun, answer, {1});
         return {bars.separates(), spun.separates()};
       }},
  };
}

void right(World& world, Contact& contact) {
  apply_impulse(world, contact, pair_impulse(world, contact));
}

/// The terms of the formula.
struct Terms {
  const Body &a, &b;
  Vec3 n, ra_n, rb_n;
  Real e, centres, spin_a, spin_b;  // m/s: the parts of v_n
  Real masses, turn_a, turn_b;      // 1/kg: the parts of K
  Real v_n() const { return centres + spin_a + spin_b; }
  Real K() const { return masses + turn_a + turn_b; }
  Real K(const Mat3& inverse_a, const Mat3& inverse_b) const {
    return masses + ra_n.dot(inverse_a * ra_n) + rb_n.dot(inverse_b * rb_n);
  }

  Terms(const World& world, const Contact& c) : Terms(world.bodies_of(c), c) {}

 private:
  Terms(const std::pair<const Body&, const Body&>& bodies, const Contact& c)
      : a(bodies.first),
        b(bodies.second),
        n(c.normal),
        ra_n((c.point - a.position).cross(c.normal)),
        rb_n((c.point - b.position).cross(c.normal)),
        e(c.restitution),
        centres(c.normal.dot(b.velocity - a.velocity)),
        spin_a(-a.angular_velocity.dot(ra_n)),
        spin_b(b.angular_velocity.dot(rb_n)),
        masses(a.inverse_mass + b.inverse_mass),
        turn_a(ra_n.dot(a.inverse_inertia * ra_n)),
        turn_b(rb_n.dot(b.inverse_inertia * rb_n)) {}
};

/// Another impulse, where the points approach.
template <class Impulse>
Answer with_impulse(Impulse impulse) {
  return {[impulse](World& world, Contact& c) {
    if (separating_speed(world, c) < 0) apply_impulse(world, c, impulse(Terms(world, c)));
  }};
}

/// The impulse of another pair than this one.
template <class Impulse>
Answer with_every_impulse(Impulse impulse) {
  return {[impulse](World& world, Contact& c) { apply_impulse(world, c, impulse(Terms(world, c))); }};
}

/// The right impulse, f n, applied in another way: to each body with its arm and with the sign that it has for it.
template <class Apply>
Answer applied(Apply apply) {
  return {[apply](World& world, Contact& c) {
    const Vec3 impulse = pair_impulse(world, c) * c.normal;
    const auto [a, b] = world.bodies_of(c);
    apply(a, c.point - a.position, impulse, Real(-1));
    apply(b, c.point - b.position, impulse, Real(1));
  }};
}

/// A and B turn as if they had these inertias.
template <class Inertias>
Answer turned_by(Inertias inertias) {
  return {[inertias](World& world, Contact& c) {
    const Vec3 impulse = pair_impulse(world, c) * c.normal;
    const auto [a, b] = world.bodies_of(c);
    const auto [of_a, of_b] = inertias(a.inverse_inertia, b.inverse_inertia);
    a.velocity -= a.inverse_mass * impulse;
    a.angular_velocity -= of_a * (c.point - a.position).cross(impulse);
    b.velocity += b.inverse_mass * impulse;
    b.angular_velocity += of_b * (c.point - b.position).cross(impulse);
  }};
}

/// The whole impact, as if they had these inertias.
template <class Inertias>
Answer with_inertias(Inertias inertias) {
  return {[inertias](World& world, Contact& c) {
    World other = world;
    const auto [a, b] = other.bodies_of(c);
    std::tie(a.inverse_inertia, b.inverse_inertia) = inertias(Mat3(a.inverse_inertia), Mat3(b.inverse_inertia));
    right(other, c);
    for (std::size_t i = 0; i < world.bodies.size(); ++i) {
      world.bodies[i].velocity = other.bodies[i].velocity;
      world.bodies[i].angular_velocity = other.bodies[i].angular_velocity;
    }
  }};
}

using Inertias = std::pair<Mat3, Mat3>;
Inertias both_of_a(const Mat3& a, const Mat3&) {
  return {a, a};
}
Inertias both_of_b(const Mat3&, const Mat3& b) {
  return {b, b};
}
Inertias exchanged(const Mat3& a, const Mat3& b) {
  return {b, a};
}

Mat3 in_body_axes(const Body& body) {
  return body.principal_inverse_inertia.asDiagonal();
}

std::vector<Mistake<Answer>> mistakes() {
  const std::string nothing =
      "it looks as if nothing were applied. v_B += f n / m_B, ω_B += I_B⁻¹ (r_B × f n), and on A the opposite.";
  const std::string linear =
      "it looks as if (1+e) multiplied the speed of the centres alone. It belongs to the speed of the points, all of "
      "v_n. Momentum is conserved whatever f is, so only the energy shows it.";
  const std::string spin =
      "it looks as if a spin counted with the wrong sign. A point r from the centre moves with v + ω × r; r × ω is the "
      "opposite. And A's velocity is subtracted, its spin as well.";
  const std::string axes =
      "it looks as if the inertia were that of body axes. Once a body is turned, its moments are about other axes than "
      "those of the world: inverse_inertia is turned already, principal_inverse_inertia is not.";
  const std::string turned_round =
      "it looks as if n, or the sign of v_n, were turned round. n leads from A to B, and v_n = n · (v of B - v of A) "
      "is negative where the two approach. Only then is there an impulse, and f is positive.";
  const std::string one_turns =
      "it looks as if K had the turn of one body alone. The impulse turns both, and each makes the point give way more "
      "easily: (r × n) · I⁻¹ (r × n) of A and of B.";
  const std::string one_in_K =
      "it looks as if K knew one of the bodies alone. The impulse moves both of them: K is the sum of 1/m and (r × n) "
      "· I⁻¹ (r × n) of A and of B.";
  const std::string one_in_v =
      "it looks as if v_n were the speed of one of the points. Both may move: v_n is that of B's point minus that of "
      "A's, along n.";
  const std::string one_pushed =
      "it looks as if one body alone had felt the impulse, so that momentum came out of nothing. B gets f n, and A the "
      "opposite.";
  const std::string one_turned =
      "it looks as if the impulse turned one body alone. It acts beside the centre of mass of both: each gets the "
      "moment r × f n of its own arm, A with a minus.";
  const std::string inertia_of =
      "it looks as if one body had the inertia of the other. Each resists its turn by its own: I_A⁻¹ with r_A × n, "
      "I_B⁻¹ with r_B × n.";
  return {
      {"not applied", nothing, {[](World&, Contact&) {}}},
      {"(1+e)²",
       "it looks as if (1+e) were there twice. Once gives them e times the speed at which they met: f = -(1+e) v_n / "
       "K.",
       with_impulse([](const Terms& t) { return -(1 + t.e) * (1 + t.e) * t.v_n() / t.K(); })},
      {"1-e",
       "it looks as if e were subtracted from 1. It takes one v_n / K to stop the two, and e of it more to send them "
       "back: 1 + e.",
       with_impulse([](const Terms& t) { return -(1 - t.e) * t.v_n() / t.K(); })},
      {"multiplied by K",
       "it looks as if v_n were multiplied by K. K is the speed that a newton second makes: divide by it.",
       with_impulse([](const Terms& t) { return -(1 + t.e) * t.v_n() * t.K(); })},
      {"K without the turn of one body", one_turns,
       with_impulse([](const Terms& t) { return -(1 + t.e) * t.v_n() / (t.masses + t.turn_a); })},
      {"K without the turn of one body", one_turns,
       with_impulse([](const Terms& t) { return -(1 + t.e) * t.v_n() / (t.masses + t.turn_b); })},
      {"K of one body", one_in_K,
       with_impulse([](const Terms& t) { return -(1 + t.e) * t.v_n() / (t.a.inverse_mass + t.turn_a); })},
      {"K of one body", one_in_K,
       with_impulse([](const Terms& t) { return -(1 + t.e) * t.v_n() / (t.b.inverse_mass + t.turn_b); })},
      {"one body's inertia for both", inertia_of, with_impulse([](const Terms& t) {
         return -(1 + t.e) * t.v_n() / t.K(t.a.inverse_inertia, t.a.inverse_inertia);
       })},
      {"one body's inertia for both", inertia_of, with_impulse([](const Terms& t) {
         return -(1 + t.e) * t.v_n() / t.K(t.b.inverse_inertia, t.b.inverse_inertia);
       })},
      {"one body's inertia for both", inertia_of, turned_by(both_of_a)},
      {"one body's inertia for both", inertia_of, turned_by(both_of_b)},
      {"one body's inertia for both", inertia_of, with_inertias(both_of_a)},
      {"one body's inertia for both", inertia_of, with_inertias(both_of_b)},
      {"inertias exchanged", inertia_of, with_inertias(exchanged)},
      {"v_n of one point", one_in_v, with_every_impulse([](const Terms& t) {
         const Real v_n = -t.a.velocity.dot(t.n) + t.spin_a;
         return v_n < 0 ? -(1 + t.e) * v_n / t.K() : 0;
       })},
      {"v_n of one point", one_in_v, with_every_impulse([](const Terms& t) {
         const Real v_n = t.b.velocity.dot(t.n) + t.spin_b;
         return v_n < 0 ? -(1 + t.e) * v_n / t.K() : 0;
       })},
      {"one body pushed", one_pushed, applied([](Body& body, const Vec3& r, const Vec3& impulse, Real sign) {
         if (sign < 0) return;
         body.velocity += body.inverse_mass * impulse;
         body.angular_velocity += body.inverse_inertia * r.cross(impulse);
       })},
      {"one body pushed", one_pushed, applied([](Body& body, const Vec3& r, const Vec3& impulse, Real sign) {
         if (sign > 0) return;
         body.velocity -= body.inverse_mass * impulse;
         body.angular_velocity -= body.inverse_inertia * r.cross(impulse);
       })},
      {"one body turned", one_turned, applied([](Body& body, const Vec3& r, const Vec3& impulse, Real sign) {
         body.velocity += sign * body.inverse_mass * impulse;
         if (sign > 0) body.angular_velocity += body.inverse_inertia * r.cross(impulse);
       })},
      {"one body turned", one_turned, applied([](Body& body, const Vec3& r, const Vec3& impulse, Real sign) {
         body.velocity += sign * body.inverse_mass * impulse;
         if (sign < 0) body.angular_velocity -= body.inverse_inertia * r.cross(impulse);
       })},
      {"the centres decide",
       "it looks as if the centres decided whether there is an impulse. The points touch: an impulse is needed where "
       "they approach, spins included, and none where they part.",
       with_every_impulse([](const Terms& t) { return t.centres < 0 ? -(1 + t.e) * t.v_n() / t.K() : 0; })},
      {"pushed apart once more",
       "it looks as if bodies that separate by themselves were pushed on, as by |v_n|. Where v_n is not negative there "
       "is no impulse.",
       with_every_impulse([](const Terms& t) { return (1 + t.e) * std::abs(t.v_n()) / t.K(); })},
      {"e left out",
       "it looks as if e were left out. 1/K stops the two; (1+e)/K makes them separate again, e times as fast as they "
       "met.",
       with_impulse([](const Terms& t) { return -t.v_n() / t.K(); })},
      {"e for 1+e",
       "it looks as if the impulse were e times the one that stops the two. It takes one to stop them, and e of it "
       "more to send them back: 1 + e.",
       with_impulse([](const Terms& t) { return -t.e * t.v_n() / t.K(); })},
      {"both pushed the same way",
       "it looks as if A and B got the same impulse. Action and reaction are opposite: what B gains in momentum, A "
       "loses.",
       applied([](Body& body, const Vec3& r, const Vec3& impulse, Real) {
         body.velocity += body.inverse_mass * impulse;
         body.angular_velocity += body.inverse_inertia * r.cross(impulse);
       })},
      {"both pushed the same way",
       "it looks as if the centres of A and B got the same impulse. Action and reaction are opposite: what B gains in "
       "momentum, A loses.",
       applied([](Body& body, const Vec3& r, const Vec3& impulse, Real sign) {
         body.velocity += body.inverse_mass * impulse;
         body.angular_velocity += sign * body.inverse_inertia * r.cross(impulse);
       })},
      {"K of the masses alone",
       "it looks as if K had only the masses in it. A body that is hit beside its centre also turns away, so at the "
       "point it gives way more easily than its mass says.",
       with_impulse([](const Terms& t) { return -(1 + t.e) * t.v_n() / t.masses; })},
      {"no turn",
       "it looks as if the impulse changed no spin. It acts at the point, not at the centre of mass: r × f n is its "
       "moment.",
       applied([](Body& body, const Vec3&, const Vec3& impulse, Real sign) {
         body.velocity += sign * body.inverse_mass * impulse;
       })},
      {"turned the wrong way",
       "it looks as if the impulse turned a body the wrong way. The moment is r × f n, not f n × r, and on A it is the "
       "opposite, as the impulse is.",
       applied([](Body& body, const Vec3& r, const Vec3& impulse, Real sign) {
         body.velocity += sign * body.inverse_mass * impulse;
         body.angular_velocity -= sign * body.inverse_inertia * r.cross(impulse);
       })},
      {"turned the wrong way",
       "it looks as if the impulse turned A the wrong way. A gets -f n, so its moment is the opposite, too.",
       applied([](Body& body, const Vec3& r, const Vec3& impulse, Real sign) {
         body.velocity += sign * body.inverse_mass * impulse;
         body.angular_velocity += body.inverse_inertia * r.cross(impulse);
       })},
      {"(1+e) on the linear part only", linear,
       with_impulse([](const Terms& t) { return -((1 + t.e) * t.centres + t.spin_a + t.spin_b) / t.K(); })},
      {"(1+e) on the linear part only", linear,
       with_impulse([](const Terms& t) { return (-(1 + t.e) * t.centres + t.spin_a + t.spin_b) / t.K(); })},
      {"sign of the spin", spin,
       with_impulse([](const Terms& t) { return -(1 + t.e) * (t.centres - t.spin_a - t.spin_b) / t.K(); })},
      {"sign of the spin", spin,
       with_impulse([](const Terms& t) { return -(1 + t.e) * (t.centres - t.spin_a + t.spin_b) / t.K(); })},
      {"spin left out",
       "it looks as if v_n were the speed of the centres. It is that of the points that touch: v + ω × r.",
       with_impulse([](const Terms& t) { return -(1 + t.e) * t.centres / t.K(); })},
      {"inertia in body axes", axes,
       with_impulse([](const Terms& t) { return -(1 + t.e) * t.v_n() / t.K(in_body_axes(t.a), in_body_axes(t.b)); })},
      {"inertia in body axes", axes, applied([](Body& body, const Vec3& r, const Vec3& impulse, Real sign) {
         body.velocity += sign * body.inverse_mass * impulse;
         body.angular_velocity += sign * in_body_axes(body) * r.cross(impulse);
       })},
      {"inertia in body axes", axes, {[](World& world, Contact& c) {
         World other = world;
         for (Body& body : other.bodies) body.inverse_inertia = in_body_axes(body);
         right(other, c);
         for (std::size_t i = 0; i < world.bodies.size(); ++i) {
           world.bodies[i].velocity = other.bodies[i].velocity;
           world.bodies[i].angular_velocity = other.bodies[i].angular_velocity;
         }
       }}},
      {"n turned round", turned_round, with_every_impulse([](const Terms& t) {
         return t.v_n() > 0 ? (1 + t.e) * t.v_n() / t.K() : 0;  // v_n = n . (v_A - v_B)
       })},
      {"n turned round", turned_round, with_every_impulse([](const Terms& t) {
         return t.v_n() > 0 ? -(1 + t.e) * t.v_n() / t.K() : 0;  // the test of its sign, or all of n
       })},
      {"n turned round", turned_round,
       with_impulse([](const Terms& t) { return (1 + t.e) * t.v_n() / t.K(); })},  // f = (1 + e) v_n / K
      {"n turned round", turned_round, with_every_impulse([](const Terms& t) { return (1 + t.e) * t.v_n() / t.K(); })},
      {"separating bodies are held",
       "it looks as if they got an impulse all the same. A contact cannot pull: where v_n is not negative, there is "
       "none.",
       with_every_impulse([](const Terms& t) { return -(1 + t.e) * t.v_n() / t.K(); })},
  };
}

}  // namespace

Numbers play(std::size_t check, Random& random, const Answer& answer) {
  return checks()[check].play(random, answer);
}

Exercise exercise() {
  return exercise_of<Answer>("the impulse of a pair",
                             {"A point that is r from a body's centre of mass moves with v + ω × r. v_n is how fast "
                              "the point of B moves away from that of A, along n.",
                              "K says by how much v_n grows for each newton second: 1/m for each body, and (r × n) · "
                              "I⁻¹ (r × n) for its turn.",
                              "f = -(1+e) v_n / K where v_n is negative, and none where it is not. Then v_B += f n / "
                              "m_B, ω_B += I_B⁻¹ (r_B × f n), and the same on A with -f."},
                             checks(), {right}, mistakes());
}

}  // namespace pushback::exercise_00
