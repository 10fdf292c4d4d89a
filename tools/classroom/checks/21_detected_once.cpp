#include "pushback/chapters/21_detected_once/exercise/asked.h"
#include "pushback/chapters/21_detected_once/kept_contact.h"
#include "pushback/common/exercise/shown.h"

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
      show(world);
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

std::vector<Check<Answer>> checks() {
  return {
      {"where bodies only shift, the separation is exact",
       1,
       {{"your separation, of two bodies that have shifted, is", "mm", 1e-6}},
       [](Random& random, const Answer& answer) -> Numbers {
         const Found found = some_contact(random);
         const Moved a{some_way(random), Vec3::Zero()}, b{some_way(random), Vec3::Zero()};
         return {1000 * answer.separation(found, a, b)};
       }},
      {"turns count along the normal with their arms",
       1,
       {{"your separation, of two bodies that have shifted and turned, is", "mm", 1e-6}},
       [](Random& random, const Answer& answer) -> Numbers {
         const Found found = some_contact(random);
         const Moved a{some_way(random), some_way(random)}, b{some_way(random), some_way(random)};
         return {1000 * answer.separation(found, a, b)};
       }},
      {"a ball that arrives within the step falls freely until then, and is met at the surface",
       2,
       {{"your ball, a substep before it arrives, falls with", "m/s", 1e-6},
        {"your ball, which has arrived, ends the step at a height of", "mm", 1e-6},
        {"where a gap is less than a millimetre and h half a second or more, your b is", "m/s", 1e-6}},
       [](Random& random, const Answer& answer) -> Numbers {
         const Real to_go = random.between(Real(3.3), Real(3.7)), fall = random.between(8, 10);
         Ball ball(random, to_go, fall);
         ball.substeps(3, answer);
         const Real before = -ball.speed();
         Numbers heights{ball.height()};
         for (int i = 3; i < 8; ++i) {
           ball.substeps(1, answer);
           heights.push_back(ball.height());
         }
         constexpr Real most = 1e6;                            // no row at all asks for infinity
         const Real h = random.between(Real(0.5), Real(0.7));  // in a short one C h is as good as 0
         const Real small = std::min(most, answer.bias(random.between(Real(0.0003), Real(0.0009)), ball.rate, h));
         return with_record({before, ball.height(), small}, heights);
       }},
      {"a ball that is too deep comes out by a part in each substep, and keeps no speed of it",
       1,
       {{"your ball, which was too deep, has after four substeps a height of", "mm", 1e-6},
        {"your ball, which was too deep, moves on with", "m/s", 1e-6},
        {"where a substep began with a gap and ends with an overlap, your b of the relaxing pass is", "m/s", 1e-6},
        {"where a substep began with an overlap and ends with a gap, your b of the relaxing pass is", "m/s", 1e-6}},
       [](Random& random, const Answer& answer) -> Numbers {
         Ball ball(random, 0, 0);
         ball.gap = -random.between(Real(0.01), Real(0.02));
         ball.world.bodies[1].position.y() = ball.radius + ball.gap;
         ball.world.gravity.setZero();
         ball.substeps(4, answer);
         const Real gap = random.between(1, 2), overlap = random.between(1, 2);
         return {ball.height(), ball.speed(), answer.relaxed_bias(gap, Real(-0.001), ball.h),
                 answer.relaxed_bias(-overlap, Real(0.001), ball.h)};
       }},
  };
}

/// The chapter's own contact, with these arms.
struct OfTheChapter {
  World world;
  std::vector<KeptBody> moved;

  OfTheChapter(const Found& found, const Moved& a, const Moved& b) {
    world.add(sphere(1, 1).at(-found.arm_a));
    world.add(sphere(1, 1).at(-found.arm_b));
    Contact contact;
    contact.normal = found.n;
    contact.depth = -found.C;
    contact.id = {0, 1, 0};
    world.contacts.push_back(contact);
    moved = {{&world.bodies[0], a.way, a.turn}, {&world.bodies[1], b.way, b.turn}};
  }
  KeptContact contact() { return {world, 0, 0, 1}; }
};

const Moved unmoved{Vec3::Zero(), Vec3::Zero()};

Real right_separation(const Found& found, const Moved& a, const Moved& b) {
  OfTheChapter here(found, a, b);
  return here.contact().separation(here.moved);
}
Real right_bias(Real C, Real rate, Real h) {
  constexpr Real any = std::numeric_limits<Real>::infinity();
  OfTheChapter here({Vec3::UnitY(), Vec3::Zero(), Vec3::Zero(), C}, unmoved, unmoved);
  KeptContact contact = here.contact();
  contact.prepare_substep(here.moved, {.rate = rate, .gamma_by_K = 0, .fastest = any, .threshold = any}, h);
  return contact.normal.bias;
}
Real right_relaxed_bias(Real bias, Real /*C*/, Real /*h*/) {
  OfTheChapter here({Vec3::UnitY(), Vec3::Zero(), Vec3::Zero(), 0}, unmoved, unmoved);
  KeptContact contact = here.contact();
  contact.normal.bias = bias;
  contact.relax();
  return contact.normal.bias;
}
constexpr Answer right{right_separation, right_bias, right_relaxed_bias};

Answer with_separation(Real (*separation)(const Found&, const Moved&, const Moved&)) {
  return {separation, right_bias, right_relaxed_bias};
}
Answer with_bias(Real (*bias)(Real, Real, Real)) {
  return {right_separation, bias, right_relaxed_bias};
}
Answer with_relaxed(Real (*relaxed)(Real, Real, Real)) {
  return {right_separation, right_bias, relaxed};
}

std::vector<Mistake<Answer>> mistakes() {
  return {
      {"the sign of A's part",
       "it looks as if what A has moved were added, not subtracted. n points from A to B: where A moves along n, the "
       "gap closes.",
       with_separation([](const Found& f, const Moved& a, const Moved& b) -> Real {
         return f.C + f.n.dot(b.way + a.way + b.turn.cross(f.arm_b) + a.turn.cross(f.arm_a));
       })},
      {"n turned round", "it looks as if n pointed from B to A. Where B moves along n, the bodies part, and C grows.",
       with_separation([](const Found& f, const Moved& a, const Moved& b) -> Real {
         return f.C - f.n.dot(b.way - a.way + b.turn.cross(f.arm_b) - a.turn.cross(f.arm_a));
       })},
      {"C_0 forgotten",
       "it looks as if C began at 0. The contact was detected at found.C, and what the bodies have moved comes on top.",
       with_separation([](const Found& f, const Moved& a, const Moved& b) -> Real {
         return f.n.dot(b.way - a.way + b.turn.cross(f.arm_b) - a.turn.cross(f.arm_a));
       })},
      {"C as it was detected",
       "it looks as if C were still the one that was detected. Between two detections it is you who keeps track of it.",
       with_separation([](const Found& f, const Moved&, const Moved&) -> Real { return f.C; })},
      {"the length of the way",
       "it looks as if the length of the way were taken. Only what lies along n changes the separation.",
       with_separation([](const Found& f, const Moved& a, const Moved& b) -> Real {
         return f.C + (b.way - a.way + b.turn.cross(f.arm_b) - a.turn.cross(f.arm_a)).norm();
       })},
      {"turns left out",
       "it looks as if turns were left out. The point at arm r of a body that has turned by Δθ has moved by Δθ × r, "
       "too.",
       with_separation(
           [](const Found& f, const Moved& a, const Moved& b) -> Real { return f.C + f.n.dot(b.way - a.way); })},
      {"r × Δθ",
       "it looks as if the product of turn and arm were the wrong way round. A point at arm r moves by Δθ × r, as its "
       "velocity is ω × r.",
       with_separation([](const Found& f, const Moved& a, const Moved& b) -> Real {
         return f.C + f.n.dot(b.way - a.way - b.turn.cross(f.arm_b) + a.turn.cross(f.arm_a));
       })},
      {"A's turn left out", "it looks as if A did not turn. Both bodies have a turn and an arm.",
       with_separation([](const Found& f, const Moved& a, const Moved& b) -> Real {
         return f.C + f.n.dot(b.way - a.way + b.turn.cross(f.arm_b));
       })},
      {"the arms exchanged", "it looks as if each turn were multiplied with the other body's arm.",
       with_separation([](const Found& f, const Moved& a, const Moved& b) -> Real {
         return f.C + f.n.dot(b.way - a.way + b.turn.cross(f.arm_a) - a.turn.cross(f.arm_b));
       })},
      {"stopped in the air",
       "it looks as if b were 0 for bodies that are still apart. JV ≥ 0 forbids them to come nearer at all. They may, "
       "by as much as they are apart: JV + C/h ≥ 0.",
       with_bias([](Real C, Real rate, Real) -> Real { return std::min(rate * C, Real(0)); })},
      {"braked in the air",
       "it looks as if bodies that are apart had the push-out's b. `rate` is for what overlaps: here it lets the ball "
       "come near by only a part of the gap in each substep.",
       with_bias([](Real C, Real rate, Real) -> Real { return rate * C; })},
      {"1/h forgotten", "it looks as if b were C. The gap may be closed within the substep, so at a speed of C/h.",
       with_bias([](Real C, Real rate, Real) -> Real { return C > 0 ? C : rate * C; })},
      {"no row while apart",
       "it looks as if nothing were asked for while the bodies are apart. Then the ball falls through the surface and "
       "is met only when it overlaps, up to h v deep.",
       with_bias(
           [](Real C, Real rate, Real) -> Real { return C > 0 ? std::numeric_limits<Real>::infinity() : rate * C; })},
      {"the sign of C/h",
       "it looks as if C/h had the wrong sign. JV ≥ C/h would throw the ball up; it may come down as fast as -C/h.",
       with_bias([](Real C, Real rate, Real h) -> Real { return C > 0 ? -C / h : rate * C; })},
      {"pushed out at once",
       "it looks as if b were C/h for what overlaps, too. That is all of the overlap in one substep; the push-out is "
       "to take its time: rate · C.",
       with_bias([](Real C, Real, Real h) -> Real { return C / h; })},
      {"no push-out",
       "it looks as if nothing were asked for where the bodies overlap, or b had the wrong sign there. C is negative "
       "then, and b = rate · C is, too: the row wants JV = -b.",
       with_bias([](Real C, Real, Real h) -> Real { return std::max(C / h, Real(0)); })},
      {"relaxed in the air",
       "it looks as if the relaxing pass asked for b = 0 of bodies that are apart. That stops them where they are. "
       "Only the push-out is to be removed.",
       with_relaxed([](Real, Real, Real) -> Real { return 0; })},
      {"the push-out kept",
       "it looks as if the relaxing pass kept the push-out. The body has moved by it; what is left of its speed is "
       "energy fed in.",
       with_relaxed([](Real bias, Real, Real) -> Real { return bias; })},
      {"relaxed by where the bodies are now",
       "it looks as if the relaxing pass asked whether the bodies are apart now. It goes by how the substep began: "
       "what was apart, b > 0, keeps its b, and a push-out, b < 0, becomes 0.",
       with_relaxed([](Real bias, Real C, Real) -> Real { return C < 0 ? 0 : bias; })},
      {"relaxed by where the bodies are now",
       "it looks as if the relaxing pass asked whether the bodies are apart now. It goes by how the substep began: "
       "what was apart, b > 0, keeps its b, and a push-out, b < 0, becomes 0.",
       with_relaxed([](Real bias, Real C, Real) -> Real { return C > 0 ? std::max(bias, Real(0)) : 0; })},
      {"the push-out turned round",
       "it looks as if the relaxing pass turned the push-out round. A b > 0 would let the bodies come nearer again: it "
       "is 0.",
       with_relaxed([](Real bias, Real, Real) -> Real { return std::abs(bias); })},
      {"one body's turn left out", "it looks as if one of the two bodies did not turn. Both have a turn and an arm.",
       with_separation([](const Found& f, const Moved& a, const Moved& b) -> Real {
         return f.C + f.n.dot(b.way - a.way - a.turn.cross(f.arm_a));
       })},
      {"one body alone",
       "it looks as if one of the two bodies had not moved. C grows by what B's point has moved along n more than A's.",
       with_separation([](const Found& f, const Moved&, const Moved& b) -> Real {
         return f.C + f.n.dot(b.way + b.turn.cross(f.arm_b));
       })},
      {"one body alone",
       "it looks as if one of the two bodies had not moved. C grows by what B's point has moved along n more than A's.",
       with_separation([](const Found& f, const Moved& a, const Moved&) -> Real {
         return f.C - f.n.dot(a.way + a.turn.cross(f.arm_a));
       })},
      {"one arm for both",
       "it looks as if both turns had the arm of one body. Each body turns about its own centre of mass.",
       with_separation([](const Found& f, const Moved& a, const Moved& b) -> Real {
         return f.C + f.n.dot(b.way - a.way + b.turn.cross(f.arm_a) - a.turn.cross(f.arm_a));
       })},
      {"one arm for both",
       "it looks as if both turns had the arm of one body. Each body turns about its own centre of mass.",
       with_separation([](const Found& f, const Moved& a, const Moved& b) -> Real {
         return f.C + f.n.dot(b.way - a.way + b.turn.cross(f.arm_b) - a.turn.cross(f.arm_b));
       })},
      {"h in the wrong place",
       "it looks as if h did not turn the gap into a speed. Bodies that may come nearer by C within h seconds may do "
       "so at C/h.",
       with_bias([](Real C, Real rate, Real h) -> Real { return C > 0 ? C * h : rate * C; })},
      {"relaxed with the gap of now",
       "it looks as if the relaxing pass asked for C/h of where the bodies are now. That already brakes for the next "
       "substep: the ball is slow before it has arrived. Keep the C/h with which this substep began.",
       with_relaxed([](Real, Real C, Real h) -> Real { return std::max(C / h, Real(0)); })},
  };
}

}  // namespace

Numbers play(std::size_t check, Random& random, const Answer& answer) {
  return checks()[check].play(random, answer);
}

Exercise exercise() {
  return rebuild_of<Answer>("the separation of contacts that stay, and what their rows ask for",
                            {"The point of B has moved by b.way + b.turn × found.arm_b, the point of A likewise. C "
                             "grows by what B's moved more than A's, along found.n.",
                             "What is apart, C > 0, may come nearer by all of C in this substep: b = C/h. What "
                             "overlaps is pushed out: b = rate · C.",
                             "In the relaxing pass a push-out, b < 0, becomes 0. A b > 0 stays as it was."},
                            checks(), right, mistakes(),
                            {{2, {"height of your ball", "mm", "substep after the third"}}});
}

}  // namespace pushback::exercise_21
