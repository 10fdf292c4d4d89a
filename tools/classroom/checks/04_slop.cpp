#include "pushback/chapters/02_clamping/clamping.h"
#include "pushback/chapters/04_slop/exercise/asked.h"
#include "pushback/tools/classroom/checks/scenes.h"

namespace pushback::exercise_04 {

namespace {

struct Margin : Effect {
  Answer answer{};
  Real beta = Real(0.2), slop = Real(0.005);
  void build(StepContext& step) {
    for (Row& row : step.rows) answer.set_bias(row, beta, slop, step.dt);
  }
};

/// Random settings of a step.
struct Setting {
  Real h, beta, slop, gap;  // s, 1, m, m
  explicit Setting(Random& random)
      : h(1 / random.between(20, 60)),
        beta(random.between(Real(0.1), Real(0.25))),
        slop(random.between(Real(0.003), Real(0.006))),
        gap(random.between(Real(0.002), Real(0.008))) {}

  void solve(World& world, const Answer& answer, int sweeps) const {
    Solver<Clamping, Margin> solver;
    static_cast<Margin&>(solver) = {{}, answer, beta, slop};
    solver.solve(world, h, sweeps);
  }
  /// A ball without weight, so far above the ground (m) and so fast upwards (m/s). Returns its speed after the step's solver.
  Real ball(Real separation, Real speed, const Answer& answer) const {
    const Vec3 centre{0, Real(0.3) + separation, 0};
    World world = on_the_ground(sphere(Real(0.3), 10).at(centre).moving({0, speed, 0}), separation);
    solve(world, answer, 1);
    return world.bodies[1].velocity.y();
  }
};

void right(Row& row, Real beta, Real slop, Real h) {
  const Real c = row.separation;
  row.bias = c > 0 ? c / h : beta / h * std::min(Real(0), c + slop);
}

}  // namespace

std::vector<Check<Answer>> checks_of(const Answer& /*any*/) {
  return {
      {"a body that does not reach the ground in this step continues as before", 2,
       [](Random& random, const Answer& answer) -> std::vector<Reading> {
         const Setting at(random);
         const Real just_reaches = at.gap / at.h;
         return {{"your ball, which will not reach the ground in this step, continues at",
                  at.ball(at.gap, -just_reaches * random.between(Real(0.4), Real(0.8)), answer), "m/s"},
                 {"your ball, which is above the ground and leaving, continues at",
                  at.ball(at.gap, just_reaches * random.between(Real(0.1), Real(0.5)), answer), "m/s"}};
       },
       "a contact only pushes, and b = C/h lets a body close the whole gap in this step. A body that approaches more "
       "slowly, or leaves, gets no impulse."},
      {"a body that would pass through the surface in this step ends on it", 2,
       [](Random& random, const Answer& answer) -> std::vector<Reading> {
         const Setting at(random);
         return {
             {"your fast ball continues at", at.ball(at.gap, -at.gap / at.h * random.between(4, 8), answer), "m/s"}};
       },
       "a body may close the whole gap in this step, but no more. C is a distance and C/h a speed, without β and "
       "without the slop."},
      {"an overlap up to the slop stays, and a deeper body comes up at β (d − slop) / h", 2,
       [](Random& random, const Answer& answer) -> std::vector<Reading> {
         const Setting at(random);
         const Real deep = at.slop * random.between(2, 4), shallow = at.slop * random.between(Real(0.3), Real(0.7));
         return {{"your deep ball comes up at", at.ball(-deep, 0, answer), "m/s"},
                 {"your ball, which is sinking but less deep than the slop, continues at",
                  at.ball(-shallow, -random.between(2, 3), answer), "m/s"}};
       },
       "an overlap up to the slop neither grows nor is pushed out. From a deeper one, each step removes the fraction β "
       "of d - slop, at the speed β (d - slop) / h."},
      {"a box that touches with one edge comes down on the other edge", 1,
       [](Random& random, const Answer& answer) -> std::vector<Reading> {
         const Setting at(random);
         const Real half = random.between(Real(0.3), Real(0.5));
         Body box_above = box(Vec3::Constant(half), random.between(50, 150)).at({0, half, 0});
         World world = on_the_ground(box_above.moving({0, -at.gap / at.h * random.between(2, 3), 0}), at.gap);
         world.contacts[0].point = {-half, 0, 0};
         world.contacts.push_back({.point = {half, 0, 0}, .normal = Vec3::UnitY(), .id = {0, 1, 1}});
         at.solve(world, answer, 100);
         return {{"your box, which touches with one edge, rotates at", world.bodies[1].angular_velocity.z(), "rad/s"}};
       },
       "each corner has its own gap. One corner may close its gap in this step, while the other stays on the ground."},
  };
}

Exercise exercise() {
  return exercise_of(
      "a margin that keeps points which are still apart",
      {"The row makes J V >= -b. With b = 0 the bodies may not come nearer at all. Does a positive or a negative b "
       "allow an approach?",
       "A body at C above the ground that approaches at the speed v is at C - h v after the step. Which v brings it to "
       "0?",
       "So there are two cases. The first contains neither β nor the slop, and the second is the bias of chapter 04."},
      Answer{right});
}

}  // namespace pushback::exercise_04
