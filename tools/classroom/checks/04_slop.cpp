#include "pushback/chapters/02_clamping/clamping.h"
#include "pushback/chapters/04_slop/exercise/asked.h"
#include "pushback/common/exercise/shown.h"

namespace pushback::exercise_04 {

namespace {

struct Margin : Effect {
  Answer answer{};
  Real beta = Real(0.2), slop = Real(0.005);
  void build(StepContext& step) {
    for (Row& row : step.rows) answer.set_bias(row, beta, slop, step.dt);
  }
};

/// What a step has to do with, made of random numbers.
struct Setting {
  Real h, beta, slop, gap;  // s, 1, m, m
  explicit Setting(Random& random)
      : h(1 / random.between(20, 60)),
        beta(random.between(Real(0.1), Real(0.25))),
        slop(random.between(Real(0.003), Real(0.006))),
        gap(random.between(Real(0.002), Real(0.008))) {}

  void solve(World& world, const Answer& answer, int sweeps, const std::vector<std::size_t>& quantities = {}) const {
    Solver<Clamping, Margin> solver;
    static_cast<Margin&>(solver) = {{}, answer, beta, slop};
    solver.solve(world, h, sweeps);
    show(world, quantities);
  }
  /// A ball without weight, so far above the ground (m) and so fast upwards (m/s): its speed after the step's solver.
  Real ball(Real separation, Real speed, const Answer& answer, const std::vector<std::size_t>& quantities = {}) const {
    World world;
    world.add(ground());
    world.add(sphere(Real(0.3), 10).at({0, Real(0.3) + separation, 0}).moving({0, speed, 0}));
    world.contacts = {{.normal = {0, 1, 0}, .depth = -separation, .id = {0, 1, 0}}};
    solve(world, answer, 1, quantities);
    return world.bodies[1].velocity.y();
  }
};

std::vector<Check<Answer>> checks() {
  return {
      {"what does not reach the ground in this step goes its way",
       2,
       {{"your ball, which will not reach the ground in this step, goes on with", "m/s", 1e-6},
        {"your ball, which is above the ground and leaving, goes on with", "m/s", 1e-6}},
       [](Random& random, const Answer& answer) -> Numbers {
         const Setting at(random);
         const Real just_reaches = at.gap / at.h;
         return {at.ball(at.gap, -just_reaches * random.between(Real(0.4), Real(0.8)), answer, {0}),
                 at.ball(at.gap, just_reaches * random.between(Real(0.1), Real(0.5)), answer, {1})};
       }},
      {"what would pass the surface in this step ends on it",
       2,
       {{"your fast ball moves on with", "m/s", 1e-6},
        {"after the step your fast ball is above the ground by", "mm", 1e-6}},
       [](Random& random, const Answer& answer) -> Numbers {
         const Setting at(random);
         const Real speed = at.ball(at.gap, -at.gap / at.h * random.between(4, 8), answer);
         return {speed, 1000 * (at.gap + at.h * speed)};
       }},
      {"what overlaps stays where it is up to the slop, and comes up at β (d − slop) / h beyond",
       2,
       {{"your deep ball comes up with", "m/s", 1e-6},
        {"your ball, which is less deep than the slop and sinking, moves on with", "m/s", 1e-6}},
       [](Random& random, const Answer& answer) -> Numbers {
         const Setting at(random);
         const Real deep = at.slop * random.between(2, 4), shallow = at.slop * random.between(Real(0.3), Real(0.7));
         return {at.ball(-deep, 0, answer, {0}), at.ball(-shallow, -random.between(2, 3), answer, {1})};
       }},
      {"a box that touches with one edge comes down on the other",
       1,
       {{"your box, which has touched with one edge, turns with", "rad/s", 1e-6},
        {"after the step its other edge is above the ground by", "mm", 1e-5}},
       [](Random& random, const Answer& answer) -> Numbers {
         const Setting at(random);
         const Real half = random.between(Real(0.3), Real(0.5));
         World world;
         world.add(ground());
         world.add(box(Vec3::Constant(half), random.between(50, 150))
                       .at({0, half, 0})
                       .moving({0, -at.gap / at.h * random.between(2, 3), 0}));
         const Vec3 up{0, 1, 0};
         world.contacts = {{.point = {-half, 0, 0}, .normal = up, .depth = -at.gap, .id = {0, 1, 0}},
                           {.point = {half, 0, 0}, .normal = up, .depth = 0, .id = {0, 1, 1}}};
         at.solve(world, answer, 100);
         return {world.bodies[1].angular_velocity.z(),
                 1000 * (at.gap + at.h * separating_speed(world, world.contacts[0]))};
       }},
  };
}

Real of_chapter_04(Real c, Real beta, Real slop, Real h) {
  return beta / h * std::min(Real(0), c + slop);
}

void right(Row& row, Real beta, Real slop, Real h) {
  const Real c = row.separation;
  row.bias = c > 0 ? c / h : of_chapter_04(c, beta, slop, h);
}

std::vector<Mistake<Answer>> mistakes() {
  const std::string hovers =
      "it looks as if b were 0 while the bodies are apart. J V + b >= 0 with b = 0 forbids every approach: the body "
      "stops in mid-air. A positive b lets it come nearer.";
  const std::string slop_on_gap =
      "it looks as if the slop were added to the gap. The body then passes the surface and stops as deep as the slop: "
      "of bodies that are apart, nothing is to be left.";
  return {
      {"stops in mid-air", hovers, {[](Row& row, Real beta, Real slop, Real h) {
         row.bias = of_chapter_04(row.separation, beta, slop, h);
       }}},
      {"the part β of the gap",
       "it looks as if the bodies might close the part β of the gap only. β is to take an overlap away gently; an "
       "approach through air needs no gentleness, and it would slow down everything that comes near.",
       {[](Row& row, Real beta, Real slop, Real h) {
         const Real c = row.separation;
         row.bias = c > 0 ? beta / h * c : of_chapter_04(c, beta, slop, h);
       }}},
      {"1/h forgotten",
       "it looks as if 1/h were forgotten. C is a distance. To close it within one step, the speed is C / h.",
       {[](Row& row, Real beta, Real slop, Real h) {
         const Real c = row.separation;
         row.bias = c > 0 ? c : of_chapter_04(c, beta, slop, h);
       }}},
      {"a push on points that are apart",
       "it looks as if points that are apart were pushed farther apart. b is minus the separating speed: with b > 0 "
       "the bodies may approach with b.",
       {[](Row& row, Real beta, Real slop, Real h) {
         const Real c = row.separation;
         row.bias = c > 0 ? -c / h : of_chapter_04(c, beta, slop, h);
       }}},
      {"slop on the gap", slop_on_gap, {[](Row& row, Real beta, Real slop, Real h) {
         const Real c = row.separation;
         row.bias = c > 0 ? (c + slop) / h : of_chapter_04(c, beta, slop, h);
       }}},
      {"slop on the gap", slop_on_gap, {[](Row& row, Real beta, Real slop, Real h) {
         const Real c = row.separation + slop;
         row.bias = c > 0 ? c / h : beta / h * c;
       }}},
      {"let through",
       "it looks as if the row of a point that is apart did nothing. The body passes the surface within this step, and "
       "the next finds it deep in the ground.",
       {[](Row& row, Real beta, Real slop, Real h) {
         row.bias = of_chapter_04(row.separation, beta, slop, h);
         if (row.separation > 0) row.hi = 0;
       }}},
      {"min left out",
       "it looks as if it were β/h (C + slop) everywhere. Where C + slop is positive, this lets a body sink as deep as "
       "the slop, and slows it down where it is apart.",
       {[](Row& row, Real beta, Real slop, Real h) { row.bias = beta / h * (row.separation + slop); }}},
      {"the whole overlap at once",
       "it looks as if β were forgotten. A gap may be closed within one step; an overlap is to go by the part β a "
       "step, or it throws the body out.",
       {[](Row& row, Real, Real slop, Real h) {
         const Real c = row.separation;
         row.bias = c > 0 ? c / h : std::min(Real(0), c + slop) / h;
       }}},
      {"no slop",
       "it looks as if there were no slop. The margin keeps points that are apart; an overlap up to the slop still is "
       "to be left alone.",
       {[](Row& row, Real beta, Real, Real h) {
         const Real c = row.separation;
         row.bias = c > 0 ? c / h : beta / h * c;
       }}},
      {"dead zone",
       "it looks as if the slop were a dead zone: nothing up to it, all of the overlap beyond. What counts is how much "
       "deeper it is, C + slop.",
       {[](Row& row, Real beta, Real slop, Real h) {
         const Real c = row.separation;
         row.bias = c > 0 ? c / h : c < -slop ? beta / h * c : 0;
       }}},
      {"1/h forgotten in the overlap",
       "it looks as if 1/h were forgotten where bodies overlap. C is a distance; to take the part β of it away in one "
       "step, the speed is β C / h.",
       {[](Row& row, Real beta, Real slop, Real h) {
         const Real c = row.separation;
         row.bias = c > 0 ? c / h : beta * std::min(Real(0), c + slop);
       }}},
      {"slop taken off the gap",
       "it looks as if the slop were taken off the gap. The body then stops above the surface, or is pushed away from "
       "it: of bodies that are apart, the whole gap may be closed.",
       {[](Row& row, Real beta, Real slop, Real h) {
         const Real c = row.separation;
         row.bias = c > 0 ? (c - slop) / h : of_chapter_04(c, beta, slop, h);
       }}},
      {"sign of the slop",
       "it looks as if the slop had the wrong sign. C is negative where bodies overlap, so C + slop is the lesser "
       "overlap, and what is less deep than the slop is left alone.",
       {[](Row& row, Real beta, Real slop, Real h) {
         const Real c = row.separation;
         row.bias = c > 0 ? c / h : beta / h * std::min(Real(0), c - slop);
       }}},
      {"shallow ones pushed out",
       "it looks as if an overlap less than the slop were closed as a gap is, within one step. C is negative there: C "
       "/ h throws the body out. Up to the slop, an overlap is left alone.",
       {[](Row& row, Real beta, Real slop, Real h) {
         const Real c = row.separation;
         row.bias = c > -slop ? c / h : beta / h * (c + slop);
       }}},
      {"it pulls",
       "it looks as if the row pulled. A body that leaves, or is too slow to reach the surface, feels nothing: a "
       "contact only pushes, and its sum is not below 0.",
       {[](Row& row, Real beta, Real slop, Real h) {
         right(row, beta, slop, h);
         row.lo = -std::numeric_limits<Real>::infinity();
       }}},
      {"overlap left in",
       "it looks as if b were 0 at every overlap. What is deeper than the slop is to come up.",
       {[](Row& row, Real, Real, Real h) { row.bias = std::max(Real(0), row.separation / h); }}},
  };
}

}  // namespace

Numbers play(std::size_t check, Random& random, const Answer& answer) {
  return checks()[check].play(random, answer);
}

Exercise exercise() {
  return exercise_of<Answer>(
      "a margin that keeps points which are still apart",
      {"J V >= -b: with b = 0 the bodies may not come nearer at all. Which b allows an approach, a positive or a "
       "negative one?",
       "A body that is C above the ground and comes with the speed v is at C - h v after the step. Which v brings it "
       "to 0?",
       "That is two cases. The first has neither β nor the slop in it, the second is the bias of chapter 04."},
      checks(), {right}, mistakes());
}

}  // namespace pushback::exercise_04
