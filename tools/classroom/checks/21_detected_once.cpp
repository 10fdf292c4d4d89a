#include <optional>

#include "pushback/chapters/01_velocity_constraint/row.h"
#include "pushback/chapters/21_detected_once/exercise/asked.h"
#include "pushback/tools/classroom/checks/scenes.h"

namespace pushback::exercise_21 {

namespace {

Found some_contact(Random& random) {
  const Vec3 n = random.direction(), arm_a = random.vector(1), arm_b = random.vector(1);
  return {n, arm_a, arm_b, random.between(Real(-0.01), Real(0.02))};
}
Vec3 some_way(Random& random) {
  return random.between(Real(0.02), Real(0.04)) * random.direction();
}

/// A ball and the ground below it. The contact is detected once, the answers make it the row of a hard contact.
struct Ball {
  Real h;     ///< s
  Real rate;  ///< 1/s, of the push-out
  World world;
  Real radius, gap;
  Moved ground_moved{Vec3::Zero(), Vec3::Zero()}, ball_moved = ground_moved;
  std::optional<Row> row;

  Ball(Random& random, Real substeps_to_go, Real fall)
      : h(1 / random.between(400, 500)),
        rate(random.between(Real(0.1), Real(0.2)) / h),
        radius(random.between(Real(0.3), Real(0.5))),
        gap(substeps_to_go * h * fall) {
    world.add(ground());
    world.add(sphere(radius, random.between(5, 20)).at({0, radius + gap, 0}).moving({0, -fall, 0}));
    world.find_contacts({.least = 1});
    const Contact& contact = world.contacts[0];
    row.emplace(world, contact, contact.normal, 0).lo = 0;
  }
  Ball(const Ball&) = delete;  // `row` knows where the bodies are

  /// One after the other; each with its relaxing pass.
  void substeps(int count, const Answer& answer) {
    for (int i = 0; i < count; ++i) {
      for (Body& body : world.bodies) integrate_velocity(body, world.gravity, h);
      const Real asked = row->bias = answer.bias(separation(answer), rate, h);
      row->solve();
      world.move(h);
      ball_moved.way += h * world.bodies[1].velocity;
      row->bias = answer.relaxed_bias(asked, separation(answer), h);
      row->solve();
    }
  }
  Real speed() const { return world.bodies[1].velocity.y(); }
  /// mm
  Real height() const { return 1000 * (world.bodies[1].position.y() - radius); }

 private:
  Real separation(const Answer& answer) const {
    return answer.separation({row->n, {0, 0, 0}, {0, -radius, 0}, gap}, ground_moved, ball_moved);
  }
};

constexpr Answer right{[](const Found& found, const Moved& a, const Moved& b) -> Real {
                         const Vec3 of_a = a.way + a.turn.cross(found.arm_a), of_b = b.way + b.turn.cross(found.arm_b);
                         return found.C + found.n.dot(of_b - of_a);
                       },
                       [](Real C, Real rate, Real h) -> Real { return C > 0 ? C / h : rate * C; },
                       [](Real bias, Real /*C*/, Real /*h*/) -> Real { return std::max(bias, Real(0)); }};
}  // namespace

std::vector<Check<Answer>> checks_of(const Answer& /*any*/) {
  return {
      {"for bodies that only shift, the separation is exact", 1,
       [](Random& random, const Answer& answer) -> std::vector<Reading> {
         const Found found = some_contact(random);
         const Moved a{some_way(random), Vec3::Zero()}, b{some_way(random), Vec3::Zero()};
         return {{"your separation of two shifted bodies is", 1000 * answer.separation(found, a, b), "mm"}};
       },
       "C starts at found.C, and grows by the motion of B along n minus the motion of A."},
      {"rotations count along the normal, with their arms", 1,
       [](Random& random, const Answer& answer) -> std::vector<Reading> {
         const Found found = some_contact(random);
         const Moved a{some_way(random), some_way(random)}, b{some_way(random), some_way(random)};
         return {{"your separation of two shifted and rotated bodies is", 1000 * answer.separation(found, a, b), "mm"}};
       },
       "the rotation Δθ also moves the point at arm r by Δθ × r. Each of the two bodies has its own rotation and its "
       "own arm, and only the motion along n counts."},
      {"a ball that arrives within the step falls freely until then, and stops at the surface", 2,
       [](Random& random, const Answer& answer) -> std::vector<Reading> {
         const Real to_go = random.between(Real(3.3), Real(3.7)), fall = random.between(8, 10);
         Ball ball(random, to_go, fall);
         ball.substeps(3, answer);
         const Real before = -ball.speed();
         ball.substeps(5, answer);
         constexpr Real most = 1e6;                            // no row at all asks for infinity
         const Real h = random.between(Real(0.5), Real(0.7));  // in a short one C h is as good as 0
         const Real small = std::min(most, answer.bias(random.between(Real(0.0003), Real(0.0009)), ball.rate, h));
         return {{"one substep before it arrives, your ball falls at", before, "m/s"},
                 {"after the step, the height of your ball, which has arrived, is", ball.height(), "mm"},
                 {"with a gap of less than a millimetre and h of half a second or more, your b is", small, "m/s"}};
       },
       "bodies that are apart may close the whole gap C in this substep, at C/h. At a lower speed they are slowed in "
       "the air, and at a higher one they pass through the surface."},
      {"a ball that is too deep comes out by a fraction in each substep, and does not keep this speed", 1,
       [](Random& random, const Answer& answer) -> std::vector<Reading> {
         Ball ball(random, 0, 0);
         ball.gap = -random.between(Real(0.01), Real(0.02));
         ball.world.bodies[1].position.y() = ball.radius + ball.gap;
         ball.world.gravity.setZero();
         ball.substeps(4, answer);
         return {{"after four substeps, the height of your ball, which was too deep, is", ball.height(), "mm"},
                 {"your ball, which was too deep, continues at", ball.speed(), "m/s"},
                 {"if a substep begins with a gap and ends with an overlap, your b of the relaxing pass is",
                  answer.relaxed_bias(random.between(1, 2), Real(-0.001), ball.h), "m/s"}};
       },
       "an overlap is pushed out at rate · C, and the relaxing pass removes this speed again. It depends on the start "
       "of the substep: b < 0 becomes 0, and b > 0 stays."},
  };
}

Exercise exercise() {
  return rebuild_of("the separation of contacts that persist, and the target speeds of their rows",
                    {"The point of B has moved by b.way + b.turn × found.arm_b, and the point of A likewise. C grows "
                     "by the motion of B's point minus the motion of A's point, along found.n.",
                     "If C > 0, the bodies are apart and may close all of C in this substep: b = C/h. If they overlap, "
                     "they are pushed out: b = rate · C.",
                     "In the relaxing pass, a push-out b < 0 becomes 0, and b > 0 stays as it was."},
                    right);
}

}  // namespace pushback::exercise_21
