#include "pushback/tools/classroom/mine/scenes.h"

#include <fmt/format.h>

#include "pushback/common/basics/input.h"
#include "pushback/common/world/situations.h"
#include "pushback/tools/classroom/mine/touching.h"

namespace pushback {

using namespace touching;

namespace {

constexpr Meeting balls_that_slide{
    .speed = fast, .friction = {0.1, 0.4}, .slip = {8, 12}, .sweeps = {1, 1}, .balls = true, .along_a_tangent = true};
constexpr Meeting deep{.speed = slow, .depth = {0.01, 0.05}, .rate = {2, 5}, .sweeps = {2, 5.9}};

Numbers pile_of_any_velocities(Random& random, const WholeSolver& answer, bool deep_and_bouncy) {
  Pile pile(random);
  for (std::size_t i = 1; i < pile.world.bodies.size(); ++i)
    pile.world.bodies[i].moving(random.vector(3)).spinning(random.vector(3));
  pile.begin();
  for (Contact& c : pile.world.contacts) {
    if (!deep_and_bouncy) continue;
    c.depth = random.between(Real(-0.01), Real(0.02));
    c.restitution = random.between(0, Real(0.8));
  }
  pile.solve(*answer.make(), to_the_end);
  return numbers_of(pile);
}

/// Several pairs of balls in one world, some smooth and some rough.
struct ManyBalls : Touching {
  explicit ManyBalls(Random& random) : Touching(random) {
    const std::size_t smooth = random.below(3);
    for (std::uint32_t pair = 0; pair < 4; ++pair) {
      const Pair balls = balls_that_slide.pair(random);
      const Vec3 off(10 * static_cast<Real>(pair), 0, 0);
      for (Body body : balls.world.bodies) world.add(body.at(body.position + off));
      const Contact& c = balls.world.contacts[0];
      touch(2 * pair, 2 * pair + 1, c.point + off, c.normal, c.id.feature).friction =
          pair == smooth ? 0 : balls.world.contacts[0].friction;
    }
    begin();
  }
};

std::vector<Quantity> of_many() {
  std::vector<Quantity> all;
  for (const int pair : {1, 2, 3, 4}) {
    all.push_back({fmt::format("of four pairs of balls, pair {} parts with", pair), "m/s", exact});
    all.push_back({fmt::format("of four pairs of balls, pair {} slips with", pair), "m/s", exact});
  }
  return all;
}

Numbers numbers_of(const ManyBalls& balls, const Contacts& contacts) {
  Numbers numbers;
  for (const Contact& c : contacts) {
    const auto [a, b] = balls.world.bodies_of(c);
    const Vec3 speed = b.velocity_at(c.point) - a.velocity_at(c.point);
    numbers.push_back(speed.dot(c.normal));
    numbers.push_back((speed - speed.dot(c.normal) * c.normal).norm());
  }
  return numbers;
}

/// Makes the pair rub, and slide with its tangents (`sign` 1) or against them (-1).
void rub(ManyBalls& balls, Contact& c, Real sign) {
  const auto [a, b] = balls.world.bodies_of(c);
  Vec3 slip = b.velocity_at(c.point) - a.velocity_at(c.point);
  slip -= slip.dot(c.normal) * c.normal;
  const auto [tangent1, tangent2] = tangents_of(c.normal);
  if (sign * slip.dot(tangent1 + tangent2) < 0) b.velocity -= 2 * slip;
  if (c.friction == 0) c.friction = Real(0.25);
}

std::vector<Quantity> of_what_is_remembered() {
  std::vector<Quantity> all;
  for (const char* step : {"second", "third"}) {
    for (const int pair : {1, 2, 3, 4}) {
      for (const char* does : {"part", "slip"})
        all.push_back({fmt::format("after a {} step without a sweep, the balls of pair {} {} with", step, pair, does),
                       "m/s", exact});
    }
  }
  return all;
}

std::vector<CheckOfChapter> made() {
  std::vector<CheckOfChapter> made{
      {0, "two bodies that meet no longer do", of_a_pair, Meeting{.speed = fast, .sweeps = {1, 1}}},
      {0,
       "they bounce, e times as fast",
       with(of_a_pair, {{"two other bodies, which were leaving each other, part with", "m/s", exact}}),
       beside({.speed = fast, .restitution = {0.2, 0.9}, .sweeps = {1, 1}}, {.speed = {1, 3}, .sweeps = {1, 1}}),
       {1}},
      {0,
       "bodies that overlap are moved apart, the lighter one further",
       {{"your lower body is moved by", "mm", exact}, {"your upper body is moved by", "mm", exact}},
       [](Random& random, const WholeSolver& answer) -> Numbers {
         Pair pair = Meeting{.speed = {1, 3}, .depth = {0.01, 0.1}}.pair(random);
         const std::vector<Body> before = pair.world.bodies;
         pair.solve(*answer.make(), 1);
         const auto moved = [&](std::size_t body) {
           return 1000 * (pair.world.bodies[body].position - before[body].position).dot(pair.contact().normal);
         };
         return {-moved(0), moved(1)};
       },
       {1}},
      {1, "sweep after sweep, the points of a beam share the load", of_a_beam,
       [](Random& random, const WholeSolver& answer) -> Numbers {
         Beam beam(random, random.between(Real(0.7), Real(0.9)), random.between(1, 4));
         beam.solve(*answer.make(), few(random));
         return numbers_of(beam);
       }},

      // The same solver twice: in the second step nothing of the first is left, and the bodies touch elsewhere.
      {1, "a pile of three boxes that all meet comes to rest, twice", of_a_pile(),
       [](Random& random, const WholeSolver& answer) -> Numbers {
         Pile pile(random);
         const auto solver = answer.make();
         for (int step = 0; step < 2; ++step) {
           for (Contact& c : pile.world.contacts) c.point += random.vector(Real(0.05));
           Numbers impulses;
           for (std::size_t i = 0; i < pile.world.contacts.size(); ++i) impulses.push_back(random.between(1, 5));
           pile.thrown_by(impulses);
           if (step > 0) pile.next(pile.h, pile.world.contacts);
           pile.solve(*solver, to_the_end);
         }
         return numbers_of(pile);
       }},
      {1, "a row is an equation: bodies that leave are held back", of_a_pair, Meeting{.speed = {1, 3}}, {2}},
      {2, "bodies that leave are let go", of_a_pair, Meeting{.speed = {1, 3}}},
      {2, "a beam that lands flat does not bounce", of_a_beam,
       [](Random& random, const WholeSolver& answer) -> Numbers {
         Beam beam(random, random.between(Real(0.25), Real(0.4)), random.between(1, 4));
         beam.solve(*answer.make(), 1 + few(random));
         return numbers_of(beam);
       }},

      // One end meets the ground hard and the other lightly, which then goes up: whatever it was pushed with is taken back.
      {2, "a push that was too much is taken back", of_a_beam,
       [](Random& random, const WholeSolver& answer) -> Numbers {
         const Real reach = random.between(Real(0.25), Real(0.4)), speed = random.between(1, 4);
         const Real side = random.below(2) == 0 ? 1 : -1;
         Beam beam(random, reach, speed, side * random.between(Real(0.8), Real(0.9)) * speed / reach);
         beam.solve(*answer.make(), 60);
         return numbers_of(beam);
       }},
      {2, "a pile with any velocities", of_a_pile(),
       [](Random& random, const WholeSolver& answer) { return pile_of_any_velocities(random, answer, false); }},
      {3, "bodies that are too deep part with β d / h", of_a_pair, deep, {4}},

      // In one sweep: what later ones see is another matter.
      {3,
       "10 mm more of depth are β/h times 10 mm more of speed",
       {{"for 10 mm more of depth, your bodies part faster by", "m/s", exact}},
       [](Random& random, const WholeSolver& answer) -> Numbers {
         Pair pair = deep.pair(random), deeper = pair;
         deeper.contact().depth += Real(0.01);
         pair.solve(*answer.make(), 1);
         deeper.solve(*answer.make(), 1);
         return {deeper.parting() - pair.parting()};
       },
       {10, 12}},
      {3,
       "bodies that are still apart are neither pushed nor let in",
       {{"bodies that are still apart and meet, part with", "m/s", exact},
        {"bodies that are still apart and leave, part with", "m/s", exact}},
       partings({.speed = {-0.09, -0.05}, .depth = {-0.02, -0.002}, .rate = {2, 5}},
                {.speed = {0.01, 0.05}, .depth = {-0.02, -0.002}, .rate = {2, 5}})},
      {4,
       "bodies that are less deep than the slop are left alone",
       of_a_pair,
       Meeting{.speed = slow, .depth = {0.001, 0.0045}},
       {12}},
      {4, "bodies that are deeper part with β (d − slop) / h", of_a_pair, deep, {10, 12}},
      {5,
       "bodies part e times as fast as they met before this step's gravity",
       with(of_a_fall, {{"bodies that met just fast enough to bounce part with", "m/s", exact}}),
       beside({.speed = fast, .restitution = {0.2, 0.9}, .falls = true},
              {.speed = {-0.15, -0.11}, .restitution = {0.2, 0.9}, .falls = true}),
       {9}},
      {5,
       "bodies that meet too slowly, or leave, do not bounce",
       {{"bodies that met too slowly to bounce part with", "m/s", exact},
        {"bodies that were leaving, before gravity, part with", "m/s", exact}},
       partings({.speed = {-0.09, -0.02}, .restitution = {0.5, 0.9}, .falls = true},
                {.speed = {0.02, 0.05}, .restitution = {0.5, 0.9}, .falls = true})},
      {5,
       "bounce and depth: the one that gives more speed",
       {{"bodies that meet fast and are a little deep part with", "m/s", exact},
        {"bodies that meet slowly and are deep part with", "m/s", exact}},
       partings({.speed = fast, .depth = {0.007, 0.01}, .restitution = {0.4, 0.9}, .falls = true},
                {.speed = {-0.4, -0.2}, .depth = {0.1, 0.2}, .restitution = {0.4, 0.9}, .falls = true}),
       {9, 10, 12}},
      {5,
       "a pile with any velocities, depths and bounces",
       of_a_pile(),
       [](Random& random, const WholeSolver& answer) { return pile_of_any_velocities(random, answer, true); },
       {9, 10, 12}},

      // A ball's points along its surface are alike in every direction, and its normal has nothing to do with them: one sweep solves it.
      {6, "balls that slide lose μ times the push, no more", of_what_rubs, balls_that_slide},
      {6, "balls that friction can hold stick", of_what_rubs,
       Meeting{.speed = fast, .friction = {0.6, 0.9}, .slip = {0.1, 0.4}, .balls = true, .along_a_tangent = true}},
      {6, "bodies of any shape stick", of_what_rubs,
       Meeting{.speed = fast, .friction = {10, 10}, .slip = {0.05, 0.3}, .sweeps = {400, 400}}},
      {6, "each contact rubs by its own push and its own μ", of_many(),
       [](Random& random, const WholeSolver& answer) -> Numbers {
         ManyBalls balls(random);
         balls.solve(*answer.make(), 1 + few(random));
         return numbers_of(balls, balls.world.contacts);
       }},

      // A first step of four pairs that touch; in the second, without a sweep, one is gone and another one is new; in the third
      // that one is back. Of the two that are there all the time one has a positive impulse along its tangent, one a negative one.
      {7, "without a sweep, bodies get what the same point had one step before, to the scale of h",
       of_what_is_remembered(),
       [](Random& random, const WholeSolver& answer) -> Numbers {
         ManyBalls balls(random);
         const std::size_t late = random.below(2), early = 2 + random.below(2);
         rub(balls, balls.world.contacts[1 - late], -1);
         rub(balls, balls.world.contacts[5 - early], 1);
         balls.begin();
         Contacts all = balls.world.contacts, first = all, second = all, third = all;
         first.erase(first.begin() + static_cast<std::ptrdiff_t>(late));
         second.erase(second.begin() + static_cast<std::ptrdiff_t>(early));
         const auto solver = answer.make();
         balls.world.contacts = first;
         balls.solve(*solver, 2);
         balls.next(balls.h * random.between(Real(0.4), Real(0.9)), second);
         balls.begin();
         balls.solve(*solver, 0);
         Numbers numbers = numbers_of(balls, all);
         balls.next(balls.h * random.between(Real(1.2), Real(2)), third);
         balls.begin();
         balls.solve(*solver, 0);
         for (const Real number : numbers_of(balls, all)) numbers.push_back(number);
         return numbers;
       }},
      {7, "of several points, each starts from its own impulse", of_many_points(), each_point_starts},
      {7, "a guess that was too much is taken back", of_a_pair, after({.speed = fast}, {.speed = {0.5, 2}})},
      {7, "the guess changes no bounce", of_a_pair, after({.speed = fast}, {.speed = fast, .restitution = {0.3, 0.9}})},

      // How many boxes of a stack are no longer where they were, to a fifth of their side. Which way it falls is chaos; whether it
      // does is not.
      {7,
       "a stack of four to six stands for three seconds",
       {{"of the boxes of your stack, those that have left their place are", "", 0.5}},
       [](Random& random, const WholeSolver& answer) -> Numbers {
         World world;
         stack(world, 4 + static_cast<int>(random.below(3)));
         const std::vector<Body> before = world.bodies;
         const auto solver = answer.make();
         try {
           for (int step = 0; step < 180; ++step) world.step(*solver, Real(1) / 60, 10);
         } catch (const InvalidInput&) {  // a body has a velocity without bounds
           return {static_cast<Real>(before.size() - 1)};
         }
         Real gone = 0;
         for (std::size_t i = 0; i < before.size(); ++i)
           gone += !((world.bodies[i].position - before[i].position).norm() < Real(0.2));
         return {gone};
       },
       {11}},
      {8, "in every direction, friction points against the slip",
       with(of_what_rubs, {{"your friction points away from the direction against the slip by", "°", 1e-4}}),
       [](Random& random, const WholeSolver& answer) -> Numbers {
         Meeting sliding = balls_that_slide;
         sliding.along_a_tangent = false;
         Pair pair = sliding.pair(random);
         const Vec3 before = pair.slip();
         Numbers numbers = sliding.solve(pair, random, *answer.make());
         const Vec3 rub = pair.contact().impulse - pair.pushed() * pair.contact().normal;
         numbers.push_back(std::atan2(rub.cross(before).norm(), -rub.dot(before)) * 180 / pi);
         return numbers;
       }},
      {8, "bodies of any shape slide as the cone says", of_what_rubs,
       Meeting{.speed = fast, .friction = {0.2, 0.8}, .slip = {1, 6}}},
  };
  // 21 tells its impulses in `done`, once the bodies have moved: these scenes end with `solve`.
  for (CheckOfChapter& before : made) before.ends.push_back(21);
  for (const auto& later : {checks_of_later_contacts(), checks_of_joints(), checks_of_detected_once()})
    made.insert(made.end(), later.begin(), later.end());
  return made;
}

}  // namespace

int predecessor(int chapter) {
  return chapter == 9 || chapter == 10 || chapter == 11 ? 8 : chapter == 21 ? 14 : chapter - 1;
}

const std::vector<CheckOfChapter>& checks_of_chapters() {
  static const std::vector<CheckOfChapter> all = made();
  return all;
}

Numbers play(std::size_t check, Random& random, const WholeSolver& answer) {
  return checks_of_chapters()[check].play(random, answer);
}

}  // namespace pushback
