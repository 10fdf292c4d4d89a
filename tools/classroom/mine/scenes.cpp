/// Chapters 00 to 08.
#include "pushback/tools/classroom/mine/scenes.h"

#include "pushback/common/basics/input.h"
#include "pushback/common/world/situations.h"
#include "pushback/tools/classroom/mine/touching.h"

namespace pushback {

using namespace touching;

namespace {

constexpr Meeting balls_that_slide{
    .speed = fast, .friction = {0.1, 0.4}, .slip = {8, 12}, .sweeps = {1, 1}, .balls = true, .along_a_tangent = true};
constexpr Meeting deep{.speed = slow, .depth = {0.01, 0.05}, .rate = {2, 5}, .sweeps = {2, 5.9}};

/// So many sweeps that it has converged.
MeasuredScene pile_of_any_velocities(bool deep_and_bouncy) {
  return of_a_pile([=](Random& random, const WholeSolver& answer) {
    Pile pile(random);
    for (Contact& c : pile.world.contacts) {
      if (!deep_and_bouncy) continue;
      c.depth = random.between(Real(-0.01), Real(0.02));
      c.restitution = random.between(0, Real(0.8));
    }
    pile.solve(*answer.make(), to_the_end);
    return pile.numbers();
  });
}

/// The same solver twice. In the second step nothing of the first is left, and the bodies touch elsewhere.
Numbers pile_that_comes_to_rest(Random& random, const WholeSolver& answer) {
  Pile pile(random);
  const auto solver = answer.make();
  for (int step = 0; step < 2; ++step) {
    for (Body& body : pile.world.bodies) body.moving(Vec3::Zero()).spinning(Vec3::Zero());
    for (Contact& c : pile.world.contacts) c.point += random.vector(Real(0.05));
    pile.throw_at_contacts(random);
    if (step > 0) pile.next(pile.h, pile.world.contacts);
    pile.solve(*solver, to_the_end);
  }
  return pile.numbers();
}

Numbers moved_by_hand(Random& random, const WholeSolver& answer) {
  Pair pair = Meeting{.speed = {1, 3}, .depth = {0.01, 0.1}}.pair(random);
  const std::vector<Body> before = pair.world.bodies;
  pair.solve(*answer.make(), 1);
  const auto moved = [&](std::size_t body) {
    return 1000 * (pair.world.bodies[body].position - before[body].position).dot(pair.contact().normal);
  };
  return {-moved(0), moved(1)};
}

/// In one sweep, because the results of later ones differ.
Numbers for_more_depth(Random& random, const WholeSolver& answer) {
  Pair pair = deep.pair(random), deeper = pair;
  deeper.contact().depth += Real(0.01);
  pair.solve(*answer.make(), 1);
  deeper.solve(*answer.make(), 1);
  return {deeper.parting(deeper.contact()) - pair.parting(pair.contact())};
}

/// Four pairs of balls that slide in one world, of which one is smooth.
Numbers many_balls(Random& random, const WholeSolver& answer) {
  Touching balls(random);
  const std::size_t smooth = random.below(3);
  for (std::uint32_t pair = 0; pair < 4; ++pair) {
    const Pair made = balls_that_slide.pair(random);
    const Vec3 off(10 * static_cast<Real>(pair), 0, 0);
    for (Body body : made.world.bodies) balls.world.add(body.at(body.position + off));
    const Contact& c = made.world.contacts[0];
    balls.touch(2 * pair, 2 * pair + 1, c.point + off, c.normal).friction = pair == smooth ? 0 : c.friction;
  }
  balls.begin();
  balls.solve(*answer.make(), 1 + few(random));
  Numbers numbers;
  for (const Contact& c : balls.world.contacts) numbers.push_back(balls.slip(c).norm());
  return numbers;
}

/// The number of boxes of a stack that have moved by more than a fifth of their side. The direction of a fall is chaotic, but
/// not whether it happens.
Numbers stack_that_stands(Random& random, const WholeSolver& answer) {
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

std::vector<CheckOfChapter> checks_of_the_trunk() {
  std::vector<Quantity> of_many_balls;
  for (const char* pair : {"first", "second", "third", "fourth"})
    of_many_balls.push_back({fmt::format("of four pairs of balls, the {} pair slips at", pair), "m/s", exact});
  return {
      {0, "two bodies that collide stop approaching", Meeting{.speed = fast, .sweeps = {1, 1}}},
      {0,
       "they bounce, and separate e times as fast",
       Meeting{.speed = fast, .restitution = {0.2, 0.9}, .sweeps = {1, 1}},
       {1}},
      {0, "two bodies that separate get no impulse", Meeting{.speed = {1, 3}, .sweeps = {1, 1}}, {1}},
      {0,
       "overlapping bodies are moved apart, the lighter one further",
       {{{"your lower body is moved by", "mm", exact}, {"your upper body is moved by", "mm", exact}}, moved_by_hand},
       {1}},
      {1, "over several sweeps, the points of a beam share the load", Landing{.reach = {0.7, 0.9}}},
      {1, "a pile of three boxes that all touch comes to rest, twice", of_a_pile(pile_that_comes_to_rest)},
      {1, "a row is an equation, so it also holds back bodies that separate", Meeting{.speed = {1, 3}}, {2}},
      {2, "bodies that separate get no impulse", Meeting{.speed = {1, 3}}},
      {2, "a beam that lands flat does not bounce", Landing{.reach = {0.25, 0.4}, .sweeps = {2, 5.9}}},

      // One end meets the ground hard and the other lightly. The second end then goes up, so its impulse must be reduced again.
      {2, "a later sweep reduces an impulse that was too large",
       Landing{.reach = {0.25, 0.4}, .spin = {0.8, 0.9}, .sweeps = {60, 60}}},
      {2, "a pile with any velocities", pile_of_any_velocities(false)},
      {3, "bodies that are too deep separate at β d / h", deep, {4}},
      {3,
       "10 mm more depth give β/h times 10 mm more speed",
       {{{"for 10 mm more depth, the increase of your separation speed is", "m/s", exact}}, for_more_depth},
       {10, 12}},
      {3, "bodies that are still apart and approach are stopped early",
       Meeting{.speed = {-0.09, -0.05}, .depth = {-0.02, -0.002}, .rate = {2, 5}}},
      {3, "bodies that are still apart and separate are not pushed",
       Meeting{.speed = {0.01, 0.05}, .depth = {-0.02, -0.002}, .rate = {2, 5}}},
      {4, "bodies less deep than the slop are not pushed", Meeting{.speed = slow, .depth = {0.001, 0.0045}}, {12}},
      {4, "deeper bodies separate at β (d − slop) / h", deep, {10, 12}},
      {5,
       "bodies separate e times as fast as they met before this step's gravity",
       Meeting{.speed = fast, .restitution = {0.2, 0.9}, .falls = true},
       {9}},
      {5,
       "so do bodies that met just fast enough to bounce",
       Meeting{.speed = {-0.15, -0.11}, .restitution = {0.2, 0.9}, .falls = true},
       {9}},
      {5, "bodies that meet too slowly do not bounce",
       Meeting{.speed = {-0.09, -0.02}, .restitution = {0.5, 0.9}, .falls = true}},
      {5,
       "bounce and depth: fast bodies that are slightly deep bounce",
       Meeting{.speed = fast, .depth = {0.007, 0.01}, .restitution = {0.4, 0.9}, .falls = true},
       {9, 10, 12}},
      {5,
       "slow bodies that are deep are pushed out",
       Meeting{.speed = {-0.4, -0.2}, .depth = {0.1, 0.2}, .restitution = {0.4, 0.9}, .falls = true},
       {9, 10, 12}},
      {5, "a pile with any velocities, depths and bounces", pile_of_any_velocities(true), {9, 10, 12}},

      // A ball's points along its surface are alike in every direction and independent of its normal, so one sweep solves it.
      {6, "sliding balls lose exactly μ times the normal impulse", balls_that_slide},
      {6, "balls stick if friction can hold them",
       Meeting{.speed = fast, .friction = {0.6, 0.9}, .slip = {0.1, 0.4}, .balls = true, .along_a_tangent = true}},
      {6, "bodies of any shape stick",
       Meeting{.speed = fast, .friction = {10, 10}, .slip = {0.05, 0.3}, .sweeps = {400, 400}}},
      {6, "each contact's friction uses its own normal impulse and its own μ", {of_many_balls, many_balls}},
      {7, "without a sweep, bodies get the impulses of the previous step, scaled with h",
       After{balls_that_slide, {.speed = fast, .sweeps = {0, 0}}}},
      {7, "each of several points starts with its own impulse", EachPointStarts{}},
      {7, "later sweeps reduce a guess that was too large", After{{.speed = fast}, {.speed = {0.5, 2}}}},
      {7, "the guess does not change a bounce", After{{.speed = fast}, {.speed = fast, .restitution = {0.3, 0.9}}}},
      {7,
       "a stack of four to six boxes stands for three seconds",
       {{{"the number of boxes of your stack that have moved away is", "", 0.5}}, stack_that_stands},
       {11}},
      {8, "in every direction, friction is opposite to the slip",
       Meeting{.speed = fast, .friction = {0.1, 0.4}, .slip = {8, 12}, .sweeps = {1, 1}, .balls = true}},
      {8, "bodies of any shape slide as the friction cone requires",
       Meeting{.speed = fast, .friction = {0.2, 0.8}, .slip = {1, 6}}},
  };
}

std::vector<CheckOfChapter> made() {
  std::vector<CheckOfChapter> made = checks_of_the_trunk();
  // 21 reports its impulses in `end_detection`, after the bodies have moved, but these scenes end with `solve`.
  for (CheckOfChapter& before : made) before.ends.push_back(21);
  for (const auto& later : {checks_of_later_contacts(), checks_of_joints(), checks_of_detected_once()})
    made.insert(made.end(), later.begin(), later.end());
  return made;
}

}  // namespace

int predecessor(int chapter) {
  return chapter == 9 || chapter == 10 || chapter == 11 ? 8 : chapter == 21 ? 12 : chapter - 1;
}

const std::vector<CheckOfChapter>& checks_of_chapters() {
  static const std::vector<CheckOfChapter> all = made();
  return all;
}

Numbers play(std::size_t check, Random& random, const WholeSolver& answer) {
  return checks_of_chapters()[check].scene.play(random, answer);
}

}  // namespace pushback
