#include "pushback/chapters/00_naive_impulses/exercise/asked.h"
#include "pushback/common/world/measure.h"

namespace pushback::exercise_00 {

namespace {

/// A bat and a ball that touch.
struct Game {
  World world;
  Vec3 pivot;            ///< m
  Real sweet_spot, tip;  ///< m from the pivot, along the bat

  /// The ball moves along n at `leaving`, m/s, away from the bat, or towards it if that is negative. `aside`, m: from the axis
  /// through the pivot to the bat's own.
  Game(Random& random, Real leaving, Real restitution, Real swing = 0, const Vec3& aside = Vec3::Zero()) {
    world.gravity.setZero();
    const Vec3 half{random.between(Real(0.4), Real(0.5)), random.between(Real(0.02), Real(0.03)),
                    random.between(Real(0.04), Real(0.06))};
    const Quat turn = random.orientation();
    n_ = turn * Vec3::UnitY();
    along_ = turn * Vec3::UnitX();
    thick_ = half.y();
    pivot = random.vector(1);
    aside_ = turn * aside;
    const Real centre = half.x() * random.between(Real(0.8), Real(0.95));
    tip = centre + half.x();
    sweet_spot = centre + (half.x() * half.x() + half.y() * half.y()) / (3 * centre);
    Body bat = box(half, random.between(Real(0.6), Real(1.2))).at(pivot + centre * along_ + aside_);
    bat.orientation = turn;
    const Real y = random.between(-1, 1), x = random.between(-1, 1);
    bat.spinning(turn * Vec3(x, y, swing));
    if (swing == 0) bat.angular_velocity.setZero();
    bat.moving(bat.angular_velocity.cross(bat.position - pivot));
    world.add(bat);
    world.bodies[0].refresh_inertia();
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
  Real play(const Answer& answer) {
    const Vec3 before = momentum(world);
    answer.hit(world.bodies[0], pivot, world.bodies[1], world.contacts[0]);
    return (momentum(world) - before).norm();
  }
  Real separates() const { return separating_speed(world, world.contacts[0]); }

 private:
  static constexpr Real radius = Real(0.04);
  Vec3 n_, along_, aside_;
  Real thick_;
};

void right(Body& bat, const Vec3& pivot, Body& ball, const Contact& c) {
  const Vec3 d = bat.position - pivot, r_n = (c.point - pivot).cross(c.normal);
  const Mat3 steiner = (d.squaredNorm() * Mat3::Identity() - d * d.transpose()) / bat.inverse_mass;
  const Vec3 turn = (bat.inverse_inertia.inverse() + steiner).inverse() * r_n;
  const Real speed = c.normal.dot(ball.velocity_at(c.point) - bat.velocity_at(c.point));
  if (speed >= 0) return;
  const Real f = -(1 + c.restitution) * speed / (ball.inverse_mass + r_n.dot(turn));
  ball.velocity += ball.inverse_mass * f * c.normal;
  bat.angular_velocity -= f * turn;
  bat.velocity = bat.angular_velocity.cross(d);
}

}  // namespace

std::vector<Check<Answer>> checks_of(const Answer& /*any*/) {
  return {
      {"a ball rebounds from a bat at rest, and the pivot stays where it is", 2,
       [](Random& random, const Answer& answer) -> std::vector<Reading> {
         const Real e = random.between(Real(0.3), Real(0.8));
         Game game(random, -random.between(6, 9), e);
         game.play(answer);
         return {{"the pivot of your bat moves at", game.world.bodies[0].velocity_at(game.pivot).norm(), "m/s", 1e-8},
                 {"your ball separates from the bat at", game.separates(), "m/s"}};
       },
       "the pivot is fixed, so the bat can only rotate about it. Use the inertia and the arm of the impulse about the "
       "pivot. The centre of mass follows the rotation: v = ω × d."},
      {"at e = 1 a swinging bat and its ball keep their energy", 2,
       [](Random& random, const Answer& answer) -> std::vector<Reading> {
         const Real z = random.between(Real(0.1), Real(0.15)), y = random.between(Real(0.05), Real(0.1)),
                    swing = random.between(5, 8);
         Game game(random, -random.between(6, 9), 1, swing, {0, y, z});
         const Real before = kinetic_energy(game.world);
         game.play(answer);
         return {{"your ball, hit by a swinging bat, separates from it at", game.separates(), "m/s"},
                 {"the kinetic energy of bat and ball has grown by", kinetic_energy(game.world) - before, "J", 1e-5},
                 {"your bat, whose pivot is off its axis, rotates at", game.world.bodies[0].angular_velocity.norm(),
                  "rad/s"}};
       },
       "K is the ball's 1/m plus the bat's rotation about its pivot, with the whole inertia matrix. v_n is the speed "
       "of the ball relative to the point of the bat that it hits."},
      {"a hand at the pivot feels nothing if the ball hits the sweet spot, and a lot if it hits the tip", 2,
       [](Random& random, const Answer& answer) -> std::vector<Reading> {
         const Real e = random.between(Real(0.3), Real(0.8));
         Game game(random, -random.between(6, 9), e);
         Game other = game;
         game.touch_at(game.sweet_spot);
         other.touch_at(other.tip);
         const Real at_the_sweet_spot = game.play(answer);
         return {{"for a ball at the sweet spot the hand feels", at_the_sweet_spot, "N s"},
                 {"for a ball at the tip the hand feels", other.play(answer), "N s"}};
       },
       "the hand gives the momentum that bat and ball gain together. At the sweet spot this is zero, because the "
       "centre of mass follows the rotation about the pivot."},
      {"a ball that already flies away gets no impulse", 1,
       [](Random& random, const Answer& answer) -> std::vector<Reading> {
         const Real swing = random.between(5, 8);
         Game game(random, random.between(30, 40), Real(0.5), swing);
         game.play(answer);
         return {{"your ball, which was already flying away, separates from the bat at", game.separates(), "m/s"}};
       },
       "if v_n is not negative, the ball is already leaving. Then there is no impulse: a bat neither holds the ball "
       "back nor pushes it again."},
  };
}

Exercise exercise() {
  return exercise_of(
      "a bat that turns about a pivot",
      {"The bat can only rotate about the pivot. A point at r from the pivot moves at ω × r, and an impulse of 1 N s "
       "along n at that point changes ω by I_P⁻¹ (r × n), where I_P is the inertia about the pivot.",
       "Steiner's theorem: I_P = I + m (|d|² 1 - d dᵀ), where I = bat.inverse_inertia.inverse() and d points from the "
       "pivot to the centre of mass.",
       "So K contains 1/m only for the ball. For the bat it contains (r × n) · I_P⁻¹ (r × n), with r from the pivot. "
       "The ball does not start to spin, because n points to its centre. Finally, bat.velocity = ω × d."},
      Answer{right});
}

}  // namespace pushback::exercise_00
