#include "pushback/tools/classroom/mine/scenes.h"

#include <fmt/format.h>

#include "pushback/common/basics/input.h"
#include "pushback/common/world/situations.h"
#include "pushback/tools/classroom/mine/touching.h"

namespace pushback {

using namespace touching;

namespace {

// ---- 00 to 02 --------------------------------------------------------------------------------------------------------

Numbers meets(Random& random, const WholeSolver& answer) {
  Pair pair(random, meeting(random));
  return solved(pair, answer, 1);
}

Numbers bounces(Random& random, const WholeSolver& answer) {
  Pair pair(random, meeting(random));
  pair.contact().restitution = random.between(Real(0.2), Real(0.9));
  Pair leaving(random, random.between(1, 3));
  Numbers numbers = solved(pair, answer, 1);
  numbers.push_back(solved(leaving, answer, 1)[0]);
  return numbers;
}

Numbers moved_apart(Random& random, const WholeSolver& answer) {
  Pair pair(random, random.between(1, 3));
  pair.contact().depth = random.between(Real(0.01), Real(0.1));
  const Vec3 lower = pair.world.bodies[0].position, upper = pair.world.bodies[1].position;
  solved(pair, answer, 1);
  const Vec3 normal = pair.contact().normal;
  return {-1000 * (pair.world.bodies[0].position - lower).dot(normal),
          1000 * (pair.world.bodies[1].position - upper).dot(normal)};
}

/// The same solver twice: in the second step nothing of the first is left, and the bodies touch elsewhere.
Numbers pile_stops(Random& random, const WholeSolver& answer) {
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
}

Numbers wide_beam(Random& random, const WholeSolver& answer) {
  Beam beam(random, random.between(Real(0.7), Real(0.9)), random.between(1, 4));
  beam.solve(*answer.make(), few(random));
  return numbers_of(beam);
}

Numbers held_back(Random& random, const WholeSolver& answer) {
  Pair pair(random, random.between(1, 3));
  return solved(pair, answer, few(random));
}

Numbers let_go(Random& random, const WholeSolver& answer) {
  Pair pair(random, random.between(1, 3));
  return solved(pair, answer, few(random));
}

Numbers narrow_beam(Random& random, const WholeSolver& answer) {
  Beam beam(random, random.between(Real(0.25), Real(0.4)), random.between(1, 4));
  beam.solve(*answer.make(), 1 + few(random));
  return numbers_of(beam);
}

/// One end meets the ground hard and the other lightly, which then goes up: whatever it was pushed with is taken back.
Numbers tipping_beam(Random& random, const WholeSolver& answer) {
  const Real reach = random.between(Real(0.25), Real(0.4)), speed = random.between(1, 4);
  const Real side = random.below(2) == 0 ? 1 : -1;
  Beam beam(random, reach, speed, side * random.between(Real(0.8), Real(0.9)) * speed / reach);
  beam.solve(*answer.make(), 60);
  return numbers_of(beam);
}

Numbers pile_of_any_velocities(Random& random, const WholeSolver& answer) {
  Pile pile(random);
  for (std::size_t i = 1; i < pile.world.bodies.size(); ++i)
    pile.world.bodies[i].moving(random.vector(3)).spinning(random.vector(3));
  pile.begin();
  pile.solve(*answer.make(), to_the_end);
  return numbers_of(pile);
}

// ---- 03 to 05 --------------------------------------------------------------------------------------------------------

Numbers deep(Random& random, const WholeSolver& answer) {
  Pair pair(random, slow(random));
  pair.h = long_step(random);
  pair.contact().depth = random.between(Real(0.01), Real(0.05));
  return solved(pair, answer, 1 + few(random));  // a bias of the first sweep alone is taken away by the second
}

Numbers deeper(Random& random, const WholeSolver& answer) {
  Pair pair(random, slow(random));
  pair.h = long_step(random);
  Pair other = pair;
  pair.contact().depth = random.between(Real(0.01), Real(0.03));
  other.contact().depth = pair.contact().depth + Real(0.01);
  const Real less = solved(pair, answer, 1)[0], more = solved(other, answer, 1)[0];  // whatever later sweeps see
  return {more - less};
}

Numbers apart(Random& random, const WholeSolver& answer) {
  Pair meets(random, -random.between(Real(0.05), Real(0.09))), leaves(random, random.between(Real(0.01), Real(0.05)));
  meets.h = leaves.h = long_step(random);
  meets.contact().depth = leaves.contact().depth = -random.between(Real(0.002), Real(0.02));
  const int sweeps = few(random);
  return {solved(meets, answer, sweeps)[0], solved(leaves, answer, sweeps)[0]};
}

Numbers shallow(Random& random, const WholeSolver& answer) {
  Pair pair(random, slow(random));
  pair.contact().depth = random.between(Real(0.001), Real(0.0045));
  return solved(pair, answer, few(random));
}

Numbers bounces_back(Random& random, const WholeSolver& answer) {
  Falling pair(random, meeting(random));
  pair.contact().restitution = random.between(Real(0.2), Real(0.9));
  pair.solve(*answer.make(), few(random));
  Numbers numbers = numbers_of_fall(pair);
  Falling slower(random, -random.between(Real(0.11), Real(0.15)));
  slower.contact().restitution = pair.contact().restitution;
  numbers.push_back(solved(slower, answer, few(random))[0]);
  return numbers;
}

Numbers too_slow(Random& random, const WholeSolver& answer) {
  Falling pair(random, -random.between(Real(0.02), Real(0.09)));
  pair.contact().restitution = random.between(Real(0.5), Real(0.9));
  Falling leaving(random, random.between(Real(0.02), Real(0.05)));
  leaving.contact().restitution = pair.contact().restitution;
  const int sweeps = few(random);
  return {solved(pair, answer, sweeps)[0], solved(leaving, answer, sweeps)[0]};
}

/// Deep, and fast: whichever asks for the higher speed.
Numbers deep_and_fast(Random& random, const WholeSolver& answer) {
  Falling fast(random, meeting(random)), deep(random, -random.between(Real(0.2), Real(0.4)));
  fast.contact().restitution = deep.contact().restitution = random.between(Real(0.4), Real(0.9));
  fast.contact().depth = random.between(Real(0.007), Real(0.01));
  deep.contact().depth = random.between(Real(0.1), Real(0.2));
  const int sweeps = few(random);
  return {solved(fast, answer, sweeps)[0], solved(deep, answer, sweeps)[0]};
}

Numbers pile_of_all(Random& random, const WholeSolver& answer) {
  Pile pile(random);
  for (std::size_t i = 1; i < pile.world.bodies.size(); ++i)
    pile.world.bodies[i].moving(random.vector(3)).spinning(random.vector(3));
  pile.begin();
  for (Contact& c : pile.world.contacts) {
    c.depth = random.between(Real(-0.01), Real(0.02));
    c.restitution = random.between(0, Real(0.8));
  }
  pile.solve(*answer.make(), to_the_end);
  return numbers_of(pile);
}

// ---- 06 and 08 -------------------------------------------------------------------------------------------------------

/// Two balls, which slide on each other along one of the tangents. A ball's points along its surface are alike in every
/// direction, and its normal has nothing to do with them: one sweep solves it.
struct Balls : Pair {
  Balls(Random& random, Real speed_of_slip) : Pair(random, meeting(random), true) {
    const auto [tangent1, tangent2] = tangents_of(contact().normal);
    const Vec3 along = random.below(2) == 0 ? tangent1 : tangent2;
    slide((random.below(2) == 0 ? speed_of_slip : -speed_of_slip) * along);
  }
};

std::vector<Quantity> of_what_rubs() {
  std::vector<Quantity> all = of_a_pair;
  all.push_back({"your contact keeps an impulse along the surface of", "N s", exact});
  all.push_back({"along the surface, the points at which your bodies touch slip with", "m/s", exact});
  return all;
}

Numbers with_friction(Numbers numbers, const Pair& pair) {
  numbers.push_back(pair.rubbed());
  numbers.push_back(pair.slip().norm());
  return numbers;
}

Numbers balls_slide(Random& random, const WholeSolver& answer) {
  Balls balls(random, random.between(8, 12));
  balls.contact().friction = random.between(Real(0.1), Real(0.4));
  const Numbers numbers = solved(balls, answer, 1);
  return with_friction(numbers, balls);
}

Numbers balls_stick(Random& random, const WholeSolver& answer) {
  Balls balls(random, random.between(Real(0.1), Real(0.4)));
  balls.contact().friction = random.between(Real(0.6), Real(0.9));
  const Numbers numbers = solved(balls, answer, few(random));
  return with_friction(numbers, balls);
}

/// A body of any shape, which friction holds.
Numbers lumps_stick(Random& random, const WholeSolver& answer) {
  Pair pair(random, meeting(random));
  pair.slide(Real(0.3) * random.vector(1).cross(pair.contact().normal));
  pair.contact().friction = 10;
  const Numbers numbers = solved(pair, answer, 400);
  return with_friction(numbers, pair);
}

/// Several pairs of balls in one world, some smooth and some rough.
struct ManyBalls : Touching {
  explicit ManyBalls(Random& random) : Touching(random) {
    const std::size_t smooth = random.below(3);
    for (std::uint32_t pair = 0; pair < 4; ++pair) {
      const Balls balls(random, random.between(8, 12));
      const Vec3 off(10 * static_cast<Real>(pair), 0, 0);
      for (Body body : balls.world.bodies) world.add(body.at(body.position + off));
      const Contact& c = balls.world.contacts[0];
      touch(2 * pair, 2 * pair + 1, c.point + off, c.normal, c.id.feature).friction =
          pair == smooth ? 0 : random.between(Real(0.1), Real(0.4));
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

Numbers many_slide(Random& random, const WholeSolver& answer) {
  ManyBalls balls(random);
  balls.solve(*answer.make(), 1 + few(random));
  return numbers_of(balls, balls.world.contacts);
}

/// Balls that slide in any direction.
Numbers any_direction(Random& random, const WholeSolver& answer) {
  Pair pair(random, meeting(random), true);
  pair.slide(random.between(8, 12) * random.direction().cross(pair.contact().normal).normalized());
  pair.contact().friction = random.between(Real(0.1), Real(0.4));
  const Vec3 before = pair.slip();
  Numbers numbers = with_friction(solved(pair, answer, 1), pair);
  const Vec3 rub = pair.contact().impulse - pair.pushed() * pair.contact().normal;
  numbers.push_back(std::atan2(rub.cross(before).norm(), -rub.dot(before)) * 180 / pi);
  return numbers;
}

/// Bodies of any shape, of which the two tangents know each other.
Numbers lumps_slide(Random& random, const WholeSolver& answer) {
  Pair pair(random, meeting(random));
  pair.slide(random.between(1, 6) * random.direction().cross(pair.contact().normal).normalized());
  pair.contact().friction = random.between(Real(0.2), Real(0.8));
  const Numbers numbers = solved(pair, answer, few(random));
  return with_friction(numbers, pair);
}

// ---- 07 --------------------------------------------------------------------------------------------------------------

/// Makes the pair rub, and slide with its tangents (`sign` 1) or against them (-1).
void rub(ManyBalls& balls, Contact& c, Real sign) {
  const auto [a, b] = balls.world.bodies_of(c);
  Vec3 slip = b.velocity_at(c.point) - a.velocity_at(c.point);
  slip -= slip.dot(c.normal) * c.normal;
  const auto [tangent1, tangent2] = tangents_of(c.normal);
  if (sign * slip.dot(tangent1 + tangent2) < 0) b.velocity -= 2 * slip;
  if (c.friction == 0) c.friction = Real(0.25);
}

/// A first step of four pairs that touch; in the second, without a sweep, one is gone and another one is new; in the third
/// that one is back. Of the two that are there all the time one has a positive impulse along its tangent, one a negative one.
Numbers remembered(Random& random, const WholeSolver& answer) {
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

/// What was too much as a guess is taken back: in the second step the bodies leave by themselves.
Numbers guess_taken_back(Random& random, const WholeSolver& answer) {
  Pair pair(random, meeting(random));
  const auto solver = answer.make();
  pair.solve(*solver, few(random));
  pair.next(pair.h * random.between(Real(0.5), Real(1.5)), pair.world.contacts);
  pair.world.bodies[1].velocity += random.vector(1);
  pair.meet(random.between(Real(0.5), 2));
  pair.solve(*solver, few(random));
  return numbers_of(pair);
}

/// A bounce in a step that begins with a guess.
Numbers bounce_after_guess(Random& random, const WholeSolver& answer) {
  Pair pair(random, meeting(random));
  const auto solver = answer.make();
  pair.solve(*solver, few(random));
  pair.next(pair.h * random.between(Real(0.5), Real(1.5)), pair.world.contacts);
  pair.contact().restitution = random.between(Real(0.3), Real(0.9));
  pair.meet(meeting(random));
  pair.solve(*solver, few(random));
  return numbers_of(pair);
}

/// How many boxes of a stack are no longer where they were, to a fifth of their side. Which way it falls is chaos; whether it
/// does is not.
Numbers stack_stands(Random& random, const WholeSolver& answer) {
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
}

std::vector<CheckOfChapter> made() {
  const std::vector<Quantity> after_a_bounce = [] {
    std::vector<Quantity> all = of_a_pair;
    all.push_back({"two other bodies, which were leaving each other, part with", "m/s", exact});
    return all;
  }();
  const std::vector<Quantity> in_any_direction = [] {
    std::vector<Quantity> all = of_what_rubs();
    all.push_back({"your friction points away from the direction against the slip by", "°", 1e-4});
    return all;
  }();
  std::vector<Quantity> of_two_falls = of_a_fall;
  of_two_falls.push_back({"bodies that met just fast enough to bounce part with", "m/s", exact});
  const Quantity meets_apart{"bodies that are still apart and meet, part with", "m/s", exact};
  const Quantity leaves_apart{"bodies that are still apart and leave, part with", "m/s", exact};
  const std::vector<int> all{};
  std::vector<CheckOfChapter> made{
      {0, all, {"two bodies that meet no longer do", 1, of_a_pair, meets}},
      {0, {1}, {"they bounce, e times as fast", 1, after_a_bounce, bounces}},
      {0,
       {1},
       {"bodies that overlap are moved apart, the lighter one further",
        1,
        {{"your lower body is moved by", "mm", exact}, {"your upper body is moved by", "mm", exact}},
        moved_apart}},
      {1, all, {"sweep after sweep, the points of a beam share the load", 1, of_a_beam, wide_beam}},
      {1, all, {"a pile of three boxes that all meet comes to rest, twice", 1, of_a_pile(), pile_stops}},
      {1, {2}, {"a row is an equation: bodies that leave are held back", 1, of_a_pair, held_back}},
      {2, all, {"bodies that leave are let go", 1, of_a_pair, let_go}},
      {2, all, {"a beam that lands flat does not bounce", 1, of_a_beam, narrow_beam}},
      {2, all, {"a push that was too much is taken back", 1, of_a_beam, tipping_beam}},
      {2, all, {"a pile with any velocities", 1, of_a_pile(), pile_of_any_velocities}},
      {3, {4}, {"bodies that are too deep part with β d / h", 1, of_a_pair, deep}},
      {3,
       {10, 12},
       {"10 mm more of depth are β/h times 10 mm more of speed",
        1,
        {{"for 10 mm more of depth, your bodies part faster by", "m/s", exact}},
        deeper}},
      {3, all, {"bodies that are still apart are neither pushed nor let in", 1, {meets_apart, leaves_apart}, apart}},
      {4, {12}, {"bodies that are less deep than the slop are left alone", 1, of_a_pair, shallow}},
      {4, {10, 12}, {"bodies that are deeper part with β (d − slop) / h", 1, of_a_pair, deep}},
      {5, {9}, {"bodies part e times as fast as they met before this step's gravity", 1, of_two_falls, bounces_back}},
      {5,
       all,
       {"who meets too slowly, or leaves, does not bounce",
        1,
        {{"bodies that met too slowly to bounce part with", "m/s", exact},
         {"bodies that were leaving, before gravity, part with", "m/s", exact}},
        too_slow}},
      {5,
       {9, 10, 12},
       {"bounce and depth: the one that asks for more speed",
        1,
        {{"bodies that meet fast and are a little deep part with", "m/s", exact},
         {"bodies that meet slowly and are deep part with", "m/s", exact}},
        deep_and_fast}},
      {5, {9, 10, 12}, {"a pile with any velocities, depths and bounces", 1, of_a_pile(), pile_of_all}},
      {6, all, {"balls that slide lose μ times the push, no more", 1, of_what_rubs(), balls_slide}},
      {6, all, {"balls that friction can hold stick", 1, of_what_rubs(), balls_stick}},
      {6, all, {"bodies of any shape stick", 1, of_what_rubs(), lumps_stick}},
      {6, all, {"each contact rubs by its own push and its own μ", 1, of_many(), many_slide}},
      {7,
       all,
       {"without a sweep, bodies get what the same point had one step before, to the scale of h", 1,
        of_what_is_remembered(), remembered}},
      {7, all, {"of several points, each starts from its own impulse", 1, of_many_points(), each_point_starts}},
      {7, all, {"a guess that was too much is taken back", 1, of_a_pair, guess_taken_back}},
      {7, all, {"the guess changes no bounce", 1, of_a_pair, bounce_after_guess}},
      {7,
       {11},
       {"a stack of four to six stands for three seconds",
        1,
        {{"of the boxes of your stack, those that have left their place are", "", 0.5}},
        stack_stands}},
      {8, all, {"in every direction, friction points against the slip", 1, in_any_direction, any_direction}},
      {8, all, {"bodies of any shape slide as the cone says", 1, of_what_rubs(), lumps_slide}},
  };
  // 21 tells its impulses in `done`, once the bodies have moved: these scenes end with `solve`.
  for (CheckOfChapter& before : made) before.ends.push_back(21);
  for (const auto& later : {checks_of_impacts(), checks_of_corrections(), checks_of_substeps(), checks_of_joints(),
                            checks_of_detected_once()})
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
  return checks_of_chapters()[check].check.play(random, answer);
}

}  // namespace pushback
