#include "pushback/chapters/00_naive_impulses/exercise/asked.h"
#include "pushback/chapters/00_naive_impulses/naive.h"
#include "pushback/common/exercise/shown.h"
#include "pushback/common/world/measure.h"

namespace pushback::exercise_00 {

namespace {

enum class Pivot { on_the_axis, beside_it };

/// A bat and a ball that touch.
struct Game {
  World world;
  Vec3 pivot;            ///< m
  Real sweet_spot, tip;  ///< m from the pivot, along the bat

  /// The ball moves along n, away from the bat, at `leaving`, m/s; towards the bat where that is negative.
  Game(Random& random, Real leaving, Real restitution, Real swing = 0, Pivot where = Pivot::on_the_axis) {
    world.gravity.setZero();
    const Vec3 half{random.between(Real(0.4), Real(0.5)), random.between(Real(0.02), Real(0.03)),
                    random.between(Real(0.04), Real(0.06))};
    const Quat turn = random.orientation();
    n_ = turn * Vec3::UnitY();
    along_ = turn * Vec3::UnitX();
    thick_ = half.y();
    pivot = random.vector(1);
    if (where == Pivot::beside_it)
      aside_ = turn * Vec3(0, random.between(Real(0.05), Real(0.1)), random.between(Real(0.1), Real(0.15)));
    const Real centre = half.x() * random.between(Real(0.8), Real(0.95));
    tip = centre + half.x();
    sweet_spot = centre + (half.x() * half.x() + half.y() * half.y()) / (3 * centre);
    Body bat = box(half, random.between(Real(0.6), Real(1.2))).at(pivot + centre * along_ + aside_);
    bat.orientation = turn;
    bat.spinning(turn * Vec3(random.between(-1, 1), random.between(-1, 1), swing));
    if (swing == 0) bat.angular_velocity.setZero();
    bat.moving(bat.angular_velocity.cross(bat.position - pivot));
    world.add(bat);
    world.bodies[0].refresh_inertia();
    const auto pin = [middle = pivot, half_length = Vec3(turn * Vec3(0, 0, Real(0.15)))](const Body&, const Body&) {
      return std::vector<Vec3>{middle - half_length, middle + half_length};
    };
    world.joints.push_back({.name = "a pivot", .a = the_world, .b = 0, .ask = {}, .line = pin});  // only to be seen
    const Vec3 sideways = random.vector(1);
    world.add(sphere(radius, random.between(Real(0.15), Real(0.4)))
                  .moving(sideways + (leaving - n_.dot(sideways)) * n_)
                  .spinning(random.vector(5)));
    world.contacts = {{.normal = n_, .restitution = restitution, .id = {0, 1, 0}}};
    touch_at(tip * random.between(Real(0.75), Real(0.95)));
  }

  void touch_at(Real from_the_pivot) {
    world.contacts[0].point = pivot + from_the_pivot * along_ + aside_ + thick_ * n_;
    world.bodies[1].position = world.contacts[0].point + radius * n_;
  }
  /// The impulse that the hand had to give, N s.
  Real play(const Answer& answer, const std::vector<std::size_t>& quantities = {}) {
    const Vec3 before = momentum(world);
    answer.hit(world.bodies[0], pivot, world.bodies[1], world.contacts[0]);
    show(world, quantities);
    return (momentum(world) - before).norm();
  }
  Real pivots_speed() const { return world.bodies[0].velocity_at(pivot).norm(); }
  Real spin() const { return world.bodies[0].angular_velocity.norm(); }
  Real separates() const { return separating_speed(world, world.contacts[0]); }

 private:
  static constexpr Real radius = Real(0.04);
  Vec3 n_, along_, aside_ = Vec3::Zero();  // the last: from the axis through the pivot to the bat's own
  Real thick_;
};

std::vector<Check<Answer>> checks() {
  return {
      {"a ball rebounds from a bat at rest, and the pivot stays where it is",
       2,
       {{"the pivot of your bat moves with", "m/s", 1e-8},
        {"your ball separates from the bat with", "m/s", 1e-6},
        {"your bat turns with", "rad/s", 1e-6}},
       [](Random& random, const Answer& answer) -> Numbers {
         const Real e = random.between(Real(0.3), Real(0.8));
         Game game(random, -random.between(6, 9), e);
         game.play(answer);
         return {game.pivots_speed(), game.separates(), game.spin()};
       }},
      {"at e = 1 a bat that swings and its ball keep their energy",
       2,
       {{"your ball, met by a bat that swings, separates from it with", "m/s", 1e-6},
        {"the energy of both has grown by", "J", 1e-5},
        {"the energy of a ball and a bat whose pivot is beside its axis has grown by", "J", 1e-5},
        {"your bat, whose pivot is beside its axis, turns with", "rad/s", 1e-6}},
       [](Random& random, const Answer& answer) -> Numbers {
         Game game(random, -random.between(6, 9), 1, random.between(5, 8));
         const Real before = kinetic_energy(game.world);
         game.play(answer, {0, 1});
         Game crooked(random, -random.between(6, 9), 1, random.between(5, 8), Pivot::beside_it);
         const Real crooked_before = kinetic_energy(crooked.world);
         crooked.play(answer, {2, 3});
         return {game.separates(), kinetic_energy(game.world) - before, kinetic_energy(crooked.world) - crooked_before,
                 crooked.spin()};
       }},
      {"a hand at the pivot feels nothing of a ball at the sweet spot, and much of one at the tip",
       2,
       {{"of a ball at the sweet spot the hand feels", "N s", 1e-6},
        {"of a ball at the tip the hand feels", "N s", 1e-6}},
       [](Random& random, const Answer& answer) -> Numbers {
         const Real e = random.between(Real(0.3), Real(0.8));
         Game game(random, -random.between(6, 9), e);
         Game other = game;
         game.touch_at(game.sweet_spot);
         other.touch_at(other.tip);
         const Real at_the_sweet_spot = game.play(answer, {0});
         return {at_the_sweet_spot, other.play(answer, {1})};
       }},
      {"a ball that flies away by itself is let go",
       1,
       {{"your ball, which was flying away by itself, separates from the bat with", "m/s", 1e-6}},
       [](Random& random, const Answer& answer) -> Numbers {
         const Real e = random.between(Real(0.3), Real(0.8));
         Game game(random, random.between(30, 40), e, random.between(5, 8));
         game.play(answer);
         return {game.separates()};
       }},
  };
}

/// The terms of the solution; a mistake changes one of them.
struct Terms {
  Vec3 d, r;         // m, from the pivot: to the centre of mass, to the point
  Vec3 arm;          // m, of the impulse
  Mat3 inertia;      // kg m^2, of the bat
  Real speed;        // m/s, v_n
  Real masses;       // 1/kg, the part of K that turns nothing
  Real gained = -1;  // how often the bat's turn gets the moment of f n
  Vec3 velocity;     // m/s, of the bat's centre of mass as it was

  Terms(const Body& bat, const Vec3& pivot, const Body& ball, const Contact& c)
      : d(bat.position - pivot),
        r(c.point - pivot),
        arm(r),
        inertia(about_centre(bat) + steiner(bat, d)),
        speed(c.normal.dot(ball.velocity_at(c.point) - bat.velocity_at(c.point))),
        masses(ball.inverse_mass),
        velocity(bat.velocity) {}

  static Mat3 about_centre(const Body& bat) { return bat.inverse_inertia.inverse(); }
  static Mat3 steiner(const Body& bat, const Vec3& d) {
    return (d.squaredNorm() * Mat3::Identity() - d * d.transpose()) / bat.inverse_mass;
  }
  /// The impulse, N s, applied to the ball and to the bat's turn. The bat's centre follows.
  Real apply(Body& bat, Body& ball, const Contact& c) const {
    const Vec3 arm_n = arm.cross(c.normal), turn = inertia.inverse() * arm_n;
    const Real f = -(1 + c.restitution) * speed / (masses + arm_n.dot(turn));
    ball.velocity += ball.inverse_mass * f * c.normal;
    bat.angular_velocity += gained * f * turn;
    bat.velocity = bat.angular_velocity.cross(d);
    return f;
  }
};

void right(Body& bat, const Vec3& pivot, Body& ball, const Contact& c) {
  const Terms terms(bat, pivot, ball, c);
  if (terms.speed < 0) terms.apply(bat, ball, c);
}

template <class Change>
Answer changed(Change change) {
  return {[change](Body& bat, const Vec3& pivot, Body& ball, const Contact& c) {
    Terms terms(bat, pivot, ball, c);
    change(terms, bat, ball, c);
    if (terms.speed < 0) terms.apply(bat, ball, c);
  }};
}

/// And then the velocity of the bat's centre is not that of the turn.
template <class Velocity>
Answer with_velocity(Velocity velocity) {
  return {[velocity](Body& bat, const Vec3& pivot, Body& ball, const Contact& c) {
    const Terms terms(bat, pivot, ball, c);
    if (terms.speed >= 0) return;
    const Vec3 impulse = terms.apply(bat, ball, c) * c.normal;
    bat.velocity = terms.velocity + velocity(bat, impulse);
  }};
}

/// As the chapter has it.
void of_free_bodies(Body& bat, Body& ball, Contact c) {
  World world;
  world.bodies = {bat, ball};
  c.id = {0, 1, 0};
  apply_impulse(world, c, pair_impulse(world, c));
  bat = world.bodies[0];
  ball = world.bodies[1];
}

std::vector<Mistake<Answer>> mistakes() {
  const std::string wall =
      "it looks as if the bat were as hard to turn as a wall. It gives way: K has the bat's turn about the pivot as "
      "well.";
  const std::string factor =
      "it looks as if the factor of the impulse were another than 1 + e. It takes v_n / K to stop the two, and e of it "
      "more to send them back.";
  const std::string from_the_origin =
      "it looks as if an arm led from the origin of the world. The bat turns about its pivot: d and r lead from there.";
  const std::string scalar =
      "it looks as if the bat were equally hard to turn about every axis. Its inertia is a matrix: by I_P⁻¹ (r × n) it "
      "also begins to turn about other axes than r × n.";
  const auto away = [](const Vec3& n, const Terms& t) { return Vec3(t.r.cross(n).normalized()); };
  return {
      {"d dᵀ forgotten",
       "it looks as if Steiner's term were m |d|² about every axis. About an axis along d the centre of mass does not "
       "move at all: the term is m (|d|² 1 - d dᵀ).",
       changed([](Terms& t, const Body& bat, const Body&, const Contact&) {
         t.inertia = Terms::about_centre(bat) + t.d.squaredNorm() / bat.inverse_mass * Mat3::Identity();
       })},
      {"sign of d dᵀ",
       "it looks as if d dᵀ were added. Along d the centre of mass has no arm, so this part is taken off: m (|d|² 1 - "
       "d dᵀ).",
       changed([](Terms& t, const Body& bat, const Body&, const Contact&) {
         t.inertia += 2 / bat.inverse_mass * t.d * t.d.transpose();
       })},
      {"one number for the inertia", scalar, changed([away](Terms& t, const Body&, const Body&, const Contact& c) {
         const Vec3 axis = away(c.normal, t);
         t.inertia = axis.dot(t.inertia * axis) * Mat3::Identity();
       })},
      {"one number for the inertia", scalar, changed([away](Terms& t, const Body&, const Body&, const Contact& c) {
         const Vec3 axis = away(c.normal, t);
         t.inertia = Mat3::Identity() / axis.dot(t.inertia.inverse() * axis);
       })},
      {"one number for the inertia", scalar, changed([](Terms& t, const Body&, const Body&, const Contact&) {
         t.inertia = t.inertia.trace() / 3 * Mat3::Identity();
       })},
      {"an arm from the origin", from_the_origin, changed([](Terms& t, const Body& bat, const Body&, const Contact&) {
         t.inertia = Terms::about_centre(bat) + Terms::steiner(bat, bat.position);
       })},
      {"an arm from the origin", from_the_origin, changed([](Terms& t, const Body& bat, const Body&, const Contact&) {
         t.inertia = Terms::about_centre(bat) + Terms::steiner(bat, bat.position);
         t.d = bat.position;
       })},
      {"an arm from the origin", from_the_origin,
       changed([](Terms& t, const Body& bat, const Body& ball, const Contact& c) {
         t.arm = c.point;
         t.speed = c.normal.dot(ball.velocity - bat.angular_velocity.cross(c.point));
       })},
      {"(1+e)²", factor,
       changed([](Terms& t, const Body&, const Body&, const Contact& c) { t.speed *= 1 + c.restitution; })},
      {"e left out", factor,
       changed([](Terms& t, const Body&, const Body&, const Contact& c) { t.speed /= 1 + c.restitution; })},
      {"e for 1+e", factor, changed([](Terms& t, const Body&, const Body&, const Contact& c) {
         t.speed *= c.restitution / (1 + c.restitution);
       })},
      {"one of the two pushed",
       "it looks as if one of bat and ball had felt nothing. The ball gets f n, and the bat the opposite, which turns "
       "it.",
       {[](Body& bat, const Vec3& pivot, Body& ball, const Contact& c) {
         const Body before = bat;
         right(bat, pivot, ball, c);
         bat.velocity = before.velocity;
         bat.angular_velocity = before.angular_velocity;
       }}},
      {"one of the two pushed",
       "it looks as if one of bat and ball had felt nothing. The ball gets f n, and the bat the opposite, which turns "
       "it.",
       {[](Body& bat, const Vec3& pivot, Body& ball, const Contact& c) {
         const Vec3 before = ball.velocity;
         right(bat, pivot, ball, c);
         ball.velocity = before;
       }}},
      {"pushed away once more",
       "it looks as if a ball that leaves by itself were pushed on, as by |v_n|. Where v_n is not negative there is no "
       "impulse.",
       {[](Body& bat, const Vec3& pivot, Body& ball, const Contact& c) {
         Terms terms(bat, pivot, ball, c);
         terms.speed = -std::abs(terms.speed);
         terms.apply(bat, ball, c);
       }}},
      {"a free bat",
       "it looks as if the bat were hit as a free body. Something holds its pivot, and gives an impulse as well. The "
       "bat can only turn about the pivot.",
       {[](Body& bat, const Vec3&, Body& ball, const Contact& c) { of_free_bodies(bat, ball, c); }}},
      {"a free bat, put back on its pivot",
       "it looks as if the bat were hit as a free body, and its centre of mass put right afterwards. The impulse at "
       "the pivot acts during the impact, and changes the turn as well.",
       {[](Body& bat, const Vec3& pivot, Body& ball, const Contact& c) {
         of_free_bodies(bat, ball, c);
         bat.velocity = bat.angular_velocity.cross(bat.position - pivot);
       }}},
      {"the centre of mass moved by f n / m",
       "it looks as if the bat's centre of mass moved by f n / m, as that of a free body. The impulse at the pivot "
       "moves it, too; it follows the turn, v = ω × d.",
       with_velocity([](const Body& bat, const Vec3& impulse) { return Vec3(-bat.inverse_mass * impulse); })},
      {"the centre of mass left behind",
       "it looks as if the bat's centre of mass kept its velocity while the bat began to turn. It is a point of the "
       "bat and follows the turn, v = ω × d.",
       with_velocity([](const Body&, const Vec3&) { return Vec3(Vec3::Zero()); })},
      {"the bat's mass in K",
       "it looks as if K had the bat's 1/m in it, too. The bat cannot give way as a whole, its pivot is held. It only "
       "turns, and its mass is in the inertia about the pivot.",
       changed([](Terms& t, const Body& bat, const Body&, const Contact&) { t.masses += bat.inverse_mass; })},
      {"Steiner's term forgotten",
       "it looks as if the inertia were that about the centre of mass. About the pivot the bat is harder to turn: its "
       "centre of mass has to move, too. Steiner's theorem.",
       changed([](Terms& t, const Body& bat, const Body&, const Contact&) { t.inertia = Terms::about_centre(bat); })},
      {"Steiner's term of the wrong arm",
       "it looks as if Steiner's term had the distance from the pivot to the ball. It has that to the centre of mass: "
       "this is the mass that moves along.",
       changed([](Terms& t, const Body& bat, const Body&, const Contact&) {
         t.inertia = Terms::about_centre(bat) + Terms::steiner(bat, t.r);
       })},
      {"the arm from the centre of mass",
       "it looks as if the arm r led from the centre of mass. The bat turns about the pivot, so its moments are about "
       "the pivot.",
       changed([](Terms& t, const Body&, const Body&, const Contact&) { t.arm = t.r - t.d; })},
      {"inertia in body axes",
       "it looks as if the inertia were that of body axes. The bat lies askew: inverse_inertia is turned already, "
       "principal_inverse_inertia is not.",
       changed([](Terms& t, const Body& bat, const Body&, const Contact&) {
         t.inertia = Mat3(bat.principal_inverse_inertia.cwiseInverse().asDiagonal()) + Terms::steiner(bat, t.d);
       })},
      {"a bat like a wall", wall, {[](Body& bat, const Vec3& pivot, Body& ball, const Contact& c) {
         const Real speed = Terms(bat, pivot, ball, c).speed;
         if (speed < 0) ball.velocity -= (1 + c.restitution) * speed * c.normal;
       }}},
      {"a bat like a wall", wall, {[](Body& bat, const Vec3& pivot, Body& ball, const Contact& c) {
         const Terms terms(bat, pivot, ball, c);
         if (terms.speed >= 0) return;
         const Vec3 velocity = ball.velocity - (1 + c.restitution) * terms.speed * c.normal;
         const Vec3 impulse = (velocity - ball.velocity) / ball.inverse_mass;
         ball.velocity = velocity;
         bat.angular_velocity -= terms.inertia.inverse() * terms.r.cross(impulse);
         bat.velocity = bat.angular_velocity.cross(terms.d);
       }}},
      {"turned the wrong way",
       "it looks as if the bat turned towards the ball. The ball gets f n, the bat the opposite.",
       changed([](Terms& t, const Body&, const Body&, const Contact&) { t.gained = 1; })},
      {"swing left out",
       "it looks as if the bat's own motion did not count. v_n is the speed at which the points separate, and that of "
       "the bat moves.",
       changed(
           [](Terms& t, const Body&, const Body& ball, const Contact& c) { t.speed = c.normal.dot(ball.velocity); })},
      {"swing about the centre of mass",
       "it looks as if the bat's point moved with ω × r, r from the centre of mass. The bat swings about its pivot.",
       changed([](Terms& t, const Body& bat, const Body& ball, const Contact& c) {
         t.speed = c.normal.dot(ball.velocity - bat.angular_velocity.cross(t.r - t.d));
       })},
      {"a leaving ball is held",
       "it looks as if the bat pulled at a ball that was leaving. Where v_n is not negative, there is no impulse.",
       {[](Body& bat, const Vec3& pivot, Body& ball, const Contact& c) {
         Terms(bat, pivot, ball, c).apply(bat, ball, c);
       }}},
  };
}

}  // namespace

Numbers play(std::size_t check, Random& random, const Answer& answer) {
  return checks()[check].play(random, answer);
}

Exercise exercise() {
  return exercise_of<Answer>(
      "a bat that turns about a pivot",
      {"The bat has no motion but its turn about the pivot. Its point r from the pivot moves with ω × r, and a newton "
       "second there changes ω by I_P⁻¹ (r × n), with the inertia I_P about the pivot.",
       "Steiner's theorem: I_P = I + m (|d|² 1 - d dᵀ), where I = bat.inverse_inertia.inverse() and d leads from the "
       "pivot to the centre of mass.",
       "So K has 1/m of the ball alone, and (r × n) · I_P⁻¹ (r × n) of the bat, with r from the pivot. The ball does "
       "not begin to spin: n leads to its centre. Last, bat.velocity = ω × d."},
      checks(), {right}, mistakes());
}

}  // namespace pushback::exercise_00
