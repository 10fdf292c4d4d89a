/// 13 and 14: joints of one equation each, as no order of rows changes what comes of them; and a pair that mirrors itself.
#include "pushback/chapters/13_joints/distance.h"
#include "pushback/tools/classroom/mine/scenes.h"
#include "pushback/tools/classroom/mine/touching.h"

namespace pushback {

using namespace touching;

namespace {

/// What an equation has beside its Jacobian; `error` is added to what the bodies' places say.
struct Wanted {
  Real error = 0, bias = 0, softness = 0;
  Real force = std::numeric_limits<Real>::infinity();  // the most, N
  bool between_turns = false;
};

/// Two bodies of any shape, of which one equation holds a point of one to a point of the other along n; or a turn about n.
struct Joined : Touching {
  Vec3 n, momentum_before, angular_before;

  Joined(Random& random, const Wanted& wanted) : Touching(random), n(random.direction()) {
    h = 1 / random.between(500, 2000);
    for (const int side : {-1, 1}) {
      Body body = lump(random);
      const Vec3 place = static_cast<Real>(side) * Vec3(random.between(Real(0.5), 1), 0, 0) + random.vector(Real(0.3));
      world.add(body.at(place).moving(random.vector(2)).spinning(random.vector(2)));
    }
    add_joint(0, 1, wanted);
    begin();
    momentum_before = momentum(world);
    angular_before = angular_momentum(world);
  }
  void add_joint(int a, int b, const Wanted& wanted) {
    const Vec3 on_a = point_on(world.body(a), Vec3::Zero()), on_b = point_on(world.body(b), Vec3::Zero());
    const Vec3 along = n;
    world.joints.push_back(
        {"an equation", a, b, [=](const Body& first, const Body& second, const TimeStep&, Equations& to) {
           const Vec3 p_a = point_of(first, on_a), p_b = point_of(second, on_b);
           Equation made;
           made.jacobian =
               wanted.between_turns ? Jacobian::about(along) : Jacobian::along(along, first, p_a, second, p_b);
           made.error = wanted.error;
           if (!wanted.between_turns) made.error += (p_b - p_a).dot(along);
           made.bias = wanted.bias;
           made.softness = wanted.softness;
           made.lo = -wanted.force;
           made.hi = wanted.force;
           to.push_back(made);
         }});
  }
  /// J V of a joint, m/s or rad/s.
  Real along(std::size_t joint = 0) const {
    const Joint& its = world.joints[joint];
    Equations asked;
    its.ask(world.body(its.a), world.body(its.b), {world.time, h}, asked);
    const Jacobian& j = asked[0].jacobian;
    const Body &a = world.body(its.a), &b = world.body(its.b);
    return j.n.dot(b.velocity - a.velocity) + j.rb_n.dot(b.angular_velocity) - j.ra_n.dot(a.angular_velocity);
  }
  Real remembered() const { return world.joints[0].last_impulses.empty() ? 0 : world.joints[0].last_impulses[0]; }
};

const std::vector<Quantity> of_what_is_joined{
    {"along their joint, your bodies move with", "m/s or rad/s", exact},
    {"your joint changes the momentum of both bodies together by", "N s", exact},
    {"your impulses change the angular momentum of both bodies together by", "N m s", exact},
    {"your first body leaves with", "m/s", exact},
    {"your second body leaves with", "m/s", exact},
    {"your first body turns with", "rad/s", exact},
    {"your second body turns with", "rad/s", exact}};
const std::vector<Quantity> of_a_joint_with_memory =
    with(of_what_is_joined, {{"your joint remembers an impulse of", "N s", exact}});

Numbers numbers_of(const Joined& joined, bool remembers) {
  const auto& bodies = joined.world.bodies;
  Numbers numbers{joined.along(),
                  (momentum(joined.world) - joined.momentum_before).norm(),
                  (angular_momentum(joined.world) - joined.angular_before).norm(),
                  bodies[0].velocity.norm(),
                  bodies[1].velocity.norm(),
                  bodies[0].angular_velocity.norm(),
                  bodies[1].angular_velocity.norm()};
  if (remembers) numbers.push_back(joined.remembered());
  return numbers;
}

/// A step of two bodies that are joined; each number is drawn.
struct Joining {
  bool open = false;  ///< there is a gap
  Range bias = {};
  bool soft = false;
  bool weak = false;  ///< its force has a limit
  bool between_turns = false;
  bool moves = false;      ///< the bodies move in the step, and the solver may change what it did
  bool remembers = false;  ///< what the joint remembers is a number, too

  Wanted wanted(Random& random) const {
    Wanted made;
    if (open) made.error = (random.below(2) == 0 ? 1 : -1) * random.between(Real(0.005), Real(0.02));
    made.bias = bias.draw(random);
    if (soft) made.softness = random.over_decades(Real(0.05), 1);
    if (weak) made.force = random.between(Real(0.1), Real(0.3));
    made.between_turns = between_turns;
    return made;
  }
  Numbers operator()(Random& random, const WholeSolver& answer) const {
    Joined joined(random, wanted(random));
    const auto solver = answer.make();
    if (moves) joined.substep(*solver, few(random));
    else joined.solve(*solver, 1 + few(random));
    return numbers_of(joined, remembers);
  }
};

/// A ball on a rod, from the side; both ends of the rod stay where they are, or the ball is to follow.
Numbers pendulum(Random& random, const WholeSolver& answer) {
  const auto solver = answer.make();
  if (!solver->holds_joints()) return {0, 0, 0};
  World world;
  Body ball = sphere(Real(0.2), random.over_decades(1, 10));
  world.add(ball.at({random.between(Real(0.7), 1), random.between(Real(-0.5), Real(0.5)), 0}));
  world.joints.push_back(distance(world, the_world, Vec3::Zero(), 0, world.bodies[0].position));
  for (int step = 0; step < 12; ++step) world.step(*solver, Real(1) / 60);
  const Body& now = world.bodies[0];
  return {1, 1000 * now.position.norm(), now.velocity.norm()};
}

/// A light ball between two heavy ones, held by a rod on either side, and thrown across: each rod spoils what the other has
/// done. The picture is its own mirror image, so it does not matter which rod is solved first.
struct Sling : Touching {
  explicit Sling(Random& random, Real error) : Touching(random) {
    h = 1 / random.between(500, 2000);
    const Real heavy = random.over_decades(1, 10), high = random.between(Real(0.1), Real(0.3));
    const Real light = random.between(Real(0.2), Real(0.3)) * heavy;
    for (const Real x : {Real(-1), Real(1)}) {
      Body end = sphere(Real(0.2), heavy);
      world.add(end.at({x, high, 0}));
    }
    Body middle = sphere(Real(0.2), light);
    world.add(middle.moving({0, -random.between(2, 5), 0}));
    const Real length = std::hypot(Real(1), high) - error;
    for (const int end : {0, 1})
      world.joints.push_back(
          distance(world, end, world.bodies[static_cast<std::size_t>(end)].position, 2, Vec3::Zero(), length));
    begin();
  }
  Numbers numbers() const {
    const auto impulse = [this](std::size_t joint) {
      const auto& kept = world.joints[joint].last_impulses;
      return kept.empty() ? 0 : kept[0];
    };

    const Real one = std::abs(impulse(0)), other = std::abs(impulse(1));
    return {world.bodies[2].velocity.norm(), std::max(one, other), std::min(one, other)};
  }
};

auto slung(const Range& error, bool moves) {
  return [=](Random& random, const WholeSolver& answer) {
    Sling sling(random, error.draw(random));
    if (moves) sling.substep(*answer.make(), 1);
    else sling.solve(*answer.make(), 1);
    return sling.numbers();
  };
}

}  // namespace

std::vector<CheckOfChapter> checks_of_joints() {
  const std::vector<Quantity> of_a_sling{{"between two rods, your light ball moves with", "m/s", exact},
                                         {"of your two rods, the one that bears more remembers", "N s", exact},
                                         {"the one that bears less remembers", "N s", exact}};
  const std::vector<Quantity> of_a_pendulum{{"that it holds joints, 1 or 0, your solver says with", "", 0.5},
                                            {"from where its rod hangs, your ball is by", "mm", exact},
                                            {"your ball swings with", "m/s", exact}};
  return {
      {13, "a joint holds two bodies, whether it pulls or pushes", of_what_is_joined, Joining{}},
      {13, "a gap closes: b is the equation's own and β/h C", of_what_is_joined,
       Joining{.open = true, .bias = {0.2, 1}}},
      {13, "an equation between two turns", of_what_is_joined, Joining{.open = true, .between_turns = true}},
      {13, "a soft equation gives way", of_what_is_joined, Joining{.open = true, .soft = true}},
      {13, "no joint is stronger than its limits", of_what_is_joined, Joining{.open = true, .weak = true}},
      {13,
       "once bodies have moved, the speed that closed the gap is gone",
       of_what_is_joined,
       Joining{.open = true, .bias = {0.2, 1}, .moves = true},
       {14}},
      {13, "and what a spring has added is not", of_what_is_joined, Joining{.open = true, .soft = true, .moves = true}},
      {13,
       "every joint is solved",
       {{"along the first of two joints, your bodies move with", "m/s", exact},
        {"along the second one, with", "m/s", exact}},
       [](Random& random, const WholeSolver& answer) -> Numbers {
         Joined joined(random, Joining{.open = true}.wanted(random));
         for (int i = 0; i < 2; ++i) {
           Body body = lump(random);
           joined.world.add(body.at(random.vector(1)).moving(random.vector(2)));
         }
         joined.add_joint(2, 3, Joining{.bias = {0.2, 1}}.wanted(random));
         joined.begin();
         joined.solve(*answer.make(), few(random));
         return {joined.along(0), joined.along(1)};
       }},
      {13, "a ball swings on a rod", of_a_pendulum, pendulum, {14}},
      {14, "without a sweep, a joint begins with what it had, to the scale of h", of_a_joint_with_memory,
       [](Random& random, const WholeSolver& answer) -> Numbers {
         Joined joined(random, {});
         const auto solver = answer.make();
         joined.substep(*solver, few(random));
         joined.next(joined.h * random.between(Real(0.4), Real(0.9)), {});
         joined.begin();
         joined.solve(*solver, 0);
         return numbers_of(joined, true);
       }},
      {14, "an impulse that closes a gap is not remembered", of_a_joint_with_memory,
       Joining{.open = true, .remembers = true}},
      {14, "a spring's impulse is remembered whole", of_a_joint_with_memory,
       Joining{.open = true, .soft = true, .remembers = true}},
      {14, "the impulse that has closed the gap is taken back", of_a_joint_with_memory,
       Joining{.open = true, .moves = true, .remembers = true}},
      {14, "two rods are solved 20 times in a sweep", of_a_sling, slung({}, false)},
      {14, "and as often if they close a gap", of_a_sling, slung({0.01, 0.03}, false)},
      {14, "and begin the last sweep from what is remembered", of_a_sling, slung({0.01, 0.03}, true)},
      {14, "a ball swings on a rod that remembers its impulse", of_a_pendulum, pendulum},
  };
}

}  // namespace pushback
