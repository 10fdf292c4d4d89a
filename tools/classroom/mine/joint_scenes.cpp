/// 13 and 14: joints of one equation each, so that the order of rows does not matter, and a pair that mirrors itself.
#include "pushback/chapters/13_joints/distance.h"
#include "pushback/tools/classroom/mine/scenes.h"
#include "pushback/tools/classroom/mine/touching.h"

namespace pushback {

using namespace touching;

namespace {

Real remembered_by(const Joint& joint) {
  return joint.last_impulses.empty() ? 0 : joint.last_impulses[0];
}

/// Two pairs of bodies of any shape. One equation holds a point of one to a point of the other along n, or a rotation about n.
struct Joined : Touching {
  Vec3 momentum_before, angular_before;
  explicit Joined(Random& random) : Touching(random) {
    h = 1 / random.between(500, 2000);
    for (const Real x : {Real(-0.75), Real(0.75), Real(-0.75), Real(0.75)}) {
      Body body = lump(random);
      const Vec3 place = Vec3(x, 0, 0) + random.vector(Real(0.5));
      world.add(body.at(place).moving(random.vector(2)).spinning(random.vector(2)));
    }
    begin();
    momentum_before = momentum(world);
    angular_before = angular_momentum(world);
  }
  /// `wanted`: the equation without its Jacobian. Its error is added to the one of the bodies' places.
  void add_joint(int a, int b, const Vec3& along, const Equation& wanted, bool between_turns) {
    const Vec3 on_a = point_on(world.body(a), Vec3::Zero()), on_b = point_on(world.body(b), Vec3::Zero());
    world.joints.push_back(
        {"an equation", a, b, [=](const Body& first, const Body& second, const TimeStep&, Equations& to) {
           const Vec3 p_a = point_of(first, on_a), p_b = point_of(second, on_b);
           Equation made = wanted;
           made.jacobian = between_turns ? Jacobian::about(along) : Jacobian::along(along, first, p_a, second, p_b);
           if (!between_turns) made.error += (p_b - p_a).dot(along);
           to.push_back(made);
         }});
  }
  /// J V of a joint, m/s or rad/s.
  Real along(const Joint& joint) const {
    Equations asked;
    const Body &a = world.body(joint.a), &b = world.body(joint.b);
    joint.ask(a, b, {world.time, h}, asked);
    const Jacobian& j = asked[0].jacobian;
    return j.n.dot(b.velocity - a.velocity) + j.rb_n.dot(b.angular_velocity) - j.ra_n.dot(a.angular_velocity);
  }
};

/// A step of joined bodies with random numbers.
struct Joining {
  bool open = false;  ///< there is a gap
  Range bias = {};
  bool soft = false;
  bool weak = false;  ///< its force has a limit
  bool between_turns = false;
  bool moves = false;      ///< the bodies move in the step, and the solver may change what it did
  bool remembers = false;  ///< the joint's stored impulse is measured, too
  bool again = false;      ///< a second step, without a sweep, is measured

  std::vector<Quantity> quantities() const {
    std::vector<Quantity> all;
    for (const char* joint : {"first", "second"}) {
      all.push_back({fmt::format("along your {} joint, its bodies move at", joint), "m/s or rad/s", exact});
      all.push_back({fmt::format("the first body of your {} joint leaves at", joint), "m/s", exact});
      all.push_back({fmt::format("the second body of your {} joint rotates at", joint), "rad/s", exact});
      if (remembers) all.push_back({fmt::format("the impulse that your {} joint stores is", joint), "N s", exact});
    }
    all.push_back({"your joints change the momentum of all bodies together by", "N s", exact});
    all.push_back({"your joints change the angular momentum of all bodies together by", "N m s", exact});
    return all;
  }
  Numbers operator()(Random& random, const WholeSolver& answer) const {
    Joined joined(random);
    World& world = joined.world;
    for (const int body : {0, 2}) {
      Equation wanted{};
      if (open) wanted.error = (random.below(2) == 0 ? 1 : -1) * random.between(Real(0.005), Real(0.02));
      wanted.bias = bias.draw(random);
      if (soft) wanted.softness = random.over_decades(Real(0.05), 1);
      if (weak) wanted.hi = random.between(Real(0.1), Real(0.3));
      if (weak) wanted.lo = -wanted.hi;
      joined.add_joint(body, body + 1, random.direction(), wanted, between_turns);
    }
    const auto solver = answer.make();
    joined.solve(*solver, 1 + few(random), moves);
    if (again) {
      joined.next(joined.h * random.between(Real(0.4), Real(0.9)), {});
      joined.begin();
      joined.solve(*solver, 0);
    }
    Numbers numbers;
    for (const Joint& joint : world.joints) {
      numbers.insert(numbers.end(), {joined.along(joint), world.body(joint.a).velocity.norm(),
                                     world.body(joint.b).angular_velocity.norm()});
      if (remembers) numbers.push_back(remembered_by(joint));
    }
    numbers.push_back((momentum(world) - joined.momentum_before).norm());
    numbers.push_back((angular_momentum(world) - joined.angular_before).norm());
    return numbers;
  }
};

/// A ball on a rod, from the side. Both ends of the rod stay in place, or the ball has to follow.
struct Pendulum {
  std::vector<Quantity> quantities() const {
    return {{"whether your solver supports joints (1 or 0) is", "", 0.5},
            {"the distance of your ball from the fixed end of its rod is", "mm", exact},
            {"your ball swings at", "m/s", exact}};
  }
  Numbers operator()(Random& random, const WholeSolver& answer) const {
    const auto solver = answer.make();
    if (!solver->supports_joints()) return {0, 0, 0};
    World world;
    Body ball = sphere(Real(0.2), random.over_decades(1, 10));
    world.add(ball.at({random.between(Real(0.7), 1), random.between(Real(-0.5), Real(0.5)), 0}));
    world.joints.push_back(distance(world, the_world, Vec3::Zero(), 0, world.bodies[0].position));
    for (int step = 0; step < 12; ++step) world.step(*solver, Real(1) / 60);
    const Body& now = world.bodies[0];
    return {1, 1000 * now.position.norm(), now.velocity.norm()};
  }
};

/// A light ball between two heavy ones, held by a rod on either side and thrown across. Each rod disturbs the other.
/// The picture is its own mirror image, so it does not matter which rod is solved first.
struct Sling {
  Range error = {};
  bool moves = false;
  std::vector<Quantity> quantities() const {
    return {{"between two rods, your light ball moves at", "m/s", exact},
            {"of your two rods, the larger stored impulse is", "N s", exact},
            {"of your two rods, the smaller stored impulse is", "N s", exact}};
  }
  Numbers operator()(Random& random, const WholeSolver& answer) const {
    Touching sling(random);
    World& world = sling.world;
    sling.h = 1 / random.between(500, 2000);
    const Real heavy = random.over_decades(1, 10), high = random.between(Real(0.1), Real(0.3));
    for (const Real x : {Real(-1), Real(1)}) {
      Body end = sphere(Real(0.2), heavy);
      world.add(end.at({x, high, 0}));
    }
    Body middle = sphere(Real(0.2), random.between(Real(0.2), Real(0.3)) * heavy);
    world.add(middle.moving({0, -random.between(2, 5), 0}));
    const Real length = std::hypot(Real(1), high) - error.draw(random);
    for (const int end : {0, 1})
      world.joints.push_back(distance(world, end, world.body(end).position, 2, Vec3::Zero(), length));
    sling.begin();
    sling.solve(*answer.make(), 1, moves);
    const Real one = std::abs(remembered_by(world.joints[0])), other = std::abs(remembered_by(world.joints[1]));
    return {world.bodies[2].velocity.norm(), std::max(one, other), std::min(one, other)};
  }
};

}  // namespace

std::vector<CheckOfChapter> checks_of_joints() {
  return {
      {13, "a joint holds two bodies, whether it pulls or pushes", Joining{}},
      {13, "a gap closes, because b is the equation's own bias plus β/h C", Joining{.open = true, .bias = {0.2, 1}}},
      {13, "an equation between two rotations", Joining{.open = true, .between_turns = true}},
      {13, "a soft equation gives way", Joining{.open = true, .soft = true}},
      {13, "no joint exceeds its limits", Joining{.open = true, .weak = true}},
      {13,
       "the speed that closed a gap disappears once the bodies have moved",
       Joining{.open = true, .bias = {0.2, 1}, .moves = true},
       {14}},
      {13, "the speed that a spring has added remains", Joining{.open = true, .soft = true, .moves = true}},
      {13, "a ball swings on a rod", Pendulum{}, {14}},
      {14, "without a sweep, a joint starts with its stored impulse, scaled with h",
       Joining{.moves = true, .remembers = true, .again = true}},
      {14, "an impulse that closes a gap is not stored", Joining{.open = true, .remembers = true}},
      {14, "the whole impulse of a spring is stored", Joining{.open = true, .soft = true, .remembers = true}},
      {14, "the impulse that has closed the gap is removed again",
       Joining{.open = true, .moves = true, .remembers = true}},
      {14, "two rods are solved 20 times per sweep", Sling{}},
      {14, "and 20 times more to close a gap", Sling{.error = {0.01, 0.03}}},
      {14, "and the last sweep starts from the stored impulses", Sling{.error = {0.01, 0.03}, .moves = true}},
      {14, "a ball swings on a rod that remembers its impulse", Pendulum{}},
  };
}

}  // namespace pushback
