/// Bodies that touch where a check needs them, for the scenes of several chapters.
#pragma once

#include <fmt/format.h>

#include <algorithm>

#include "pushback/common/world/measure.h"
#include "pushback/tools/classroom/mine/scenes.h"

namespace pushback::touching {

inline constexpr double exact = 1e-6;    // m/s, rad/s, N s ...: see scenes.h
inline constexpr int to_the_end = 2000;  // sweeps, after which a pile has converged

/// A number is drawn between these two.
struct Range {
  double from = 0, to = 0;
  Real draw(Random& random) const { return random.between(static_cast<Real>(from), static_cast<Real>(to)); }
};
inline constexpr Range fast{-6, -2}, slow{-0.05, -0.01};  // m/s, at which points part: they meet

inline int few(Random& random) {
  return 1 + static_cast<int>(random.below(4));
}

/// Contacts that are made by hand, solved as World::step would have them solved.
struct Touching {
  World world;
  Real h;

  explicit Touching(Random& random) : h(1 / random.between(50, 240)) { world.gravity.setZero(); }

  Contact& touch(std::uint32_t a, std::uint32_t b, const Vec3& point, const Vec3& normal, std::uint32_t feature = 0) {
    world.contacts.push_back({.point = point, .normal = normal, .id = {a, b, feature}});
    return world.contacts.back();
  }
  /// The velocities are those with which the step begins.
  void begin() {
    for (Body& body : world.bodies) keep_velocity(body);
  }
  /// Velocities that random impulses, one a contact, bring to rest.
  void throw_at_contacts(Random& random) {
    for (const Contact& c : world.contacts) {
      const auto [a, b] = world.bodies_of(c);
      const Vec3 impulse = random.between(1, 5) * c.normal;
      a.velocity += a.inverse_mass * impulse;
      a.angular_velocity += a.inverse_inertia * (c.point - a.position).cross(impulse);
      b.velocity -= b.inverse_mass * impulse;
      b.angular_velocity -= b.inverse_inertia * (c.point - b.position).cross(impulse);
    }
    begin();
  }
  /// With `moves` it is a whole substep, in which the bodies move and the solver may change its impulses.
  void solve(StepSolver& solver, int sweeps, bool moves = false) {
    solver.check(world, h);
    solver.after_detection(world, h);
    solver.solve(world, h, sweeps);
    if (moves) {
      for (Body& body : world.bodies) move(body, h);
      world.time += h;
      solver.after_move(world, h);
    }
    solver.end_detection(world);
  }
  /// The next step, of which these contacts are found.
  void next(Real its_h, Contacts found) {
    world.contacts_before = std::move(world.contacts);
    world.contacts = std::move(found);
    world.dt_before = h;
    h = its_h;
  }
  /// How fast a contact's points part, and slip, m/s.
  Real parting(const Contact& c) const { return separating_speed(world, c); }
  Vec3 slip(const Contact& c) const {
    const Vec3 speed = world.bodies[c.id.body_b].velocity_at(c.point) - world.bodies[c.id.body_a].velocity_at(c.point);
    return speed - speed.dot(c.normal) * c.normal;
  }
};

/// A body that tumbles, because its inertia differs from axis to axis.
inline Body lump(Random& random) {
  const Real x = random.between(Real(0.3), Real(0.8)), y = random.between(Real(0.3), Real(0.8)),
             z = random.between(Real(0.3), Real(0.8));
  Body body = box({x, y, z}, random.over_decades(1, 10));
  return body.oriented(random.orientation());
}

/// Two bodies that touch in one point, and that can both move.
struct Pair : Touching {
  Vec3 momentum_before, angular_before;

  /// Their points separate at `speed`, m/s, or approach if it is negative.
  Pair(Random& random, Real speed, bool spheres) : Touching(random) {
    const Vec3 point = random.vector(1), normal = random.direction();
    for (const int side : {-1, 1}) {
      const Real away = random.between(Real(0.3), Real(0.8));
      Body body = spheres ? sphere(away, random.over_decades(1, 10)) : lump(random);
      Vec3 place = point + static_cast<Real>(side) * away * normal;
      if (!spheres) place += random.vector(Real(0.3));
      body.at(place).moving(random.vector(2));
      if (!spheres) body.spinning(random.vector(2));
      world.add(body);
    }
    touch(0, 1, point, normal, static_cast<std::uint32_t>(random.below(5)));
    meet(speed);
  }
  Contact& contact() { return world.contacts[0]; }
  /// As above, but the velocities across the normal stay.
  void meet(Real speed) {
    world.bodies[1].velocity += (speed - parting(contact())) * contact().normal;
    begin();
    momentum_before = momentum(world);
    angular_before = angular_momentum(world);
  }
  /// From now on B falls onto A, which nothing moves. Gravity of this step is already in B's velocity.
  void fall(Random& random) {
    const Real speed = parting(contact());
    world.bodies[0].fixed().moving(Vec3::Zero()).spinning(Vec3::Zero());
    meet(speed);
    world.gravity = -random.between(5, 15) * contact().normal;
    integrate_velocity(world.bodies[1], world.gravity, h);
  }
};

/// One step of two bodies that touch in one point, with random numbers.
struct Meeting {
  Range speed;  ///< m/s, at which their points part
  Range depth = {}, restitution = {}, friction = {};
  Range slip = {};          ///< m/s, along the surface
  Range rate = {50, 240};   ///< 1/s, of the steps
  Range sweeps = {1, 4.9};  ///< rounded down
  bool balls = false;
  bool along_a_tangent = false;  ///< they slip along a tangent, otherwise in any direction
  bool falls = false;            ///< upon a body that nothing moves, and gravity has acted in this step already
  bool moves = false;            ///< the bodies move in the step, and the solver may change what it did

  Pair pair(Random& random) const {
    Pair made(random, speed.draw(random), balls);
    made.h = 1 / rate.draw(random);
    Contact& c = made.contact();
    c.depth = depth.draw(random);
    c.restitution = restitution.draw(random);
    c.friction = friction.draw(random);
    if (slip.to > 0) {
      const auto [tangent, other] = tangents_of(c.normal);
      const Vec3 aside = along_a_tangent ? (random.below(2) == 0 ? tangent : other)
                                         : Vec3(random.direction().cross(c.normal).normalized());
      made.world.bodies[1].velocity += (random.below(2) == 0 ? 1 : -1) * slip.draw(random) * aside - made.slip(c);
      made.meet(made.parting(c));
    }
    if (falls) made.fall(random);
    return made;
  }
  std::vector<Quantity> quantities() const {
    std::vector<Quantity> all{{"the contact points of your bodies separate at", "m/s", exact},
                              {"your lower body leaves at", "m/s", exact},
                              {"your upper body leaves at", "m/s", exact},
                              {"your lower body rotates at", "rad/s", exact},
                              {"your upper body rotates at", "rad/s", exact},
                              {"the normal impulse that your contact stores is", "N s", exact}};
    if (friction.to > 0) {
      all.push_back({"the tangential impulse that your contact stores is", "N s", exact});
      all.push_back({"the contact points of your bodies slip along the surface at", "m/s", exact});
    }
    if (!falls) {
      all.push_back({"your impulses change the momentum of both bodies together by", "N s", exact});
      all.push_back({"your impulses change the angular momentum of both bodies together by", "N m s", exact});
    }
    return all;
  }
  Numbers solve(Pair& made, Random& random, StepSolver& solver) const {
    Contact c = made.contact();
    made.solve(solver, static_cast<int>(sweeps.draw(random)), moves);
    if (made.world.contacts.empty()) c.impulse.setZero();  // a solver may leave it out
    else c = made.contact();
    const Body &a = made.world.bodies[0], &b = made.world.bodies[1];
    const Real pushed = c.impulse.dot(c.normal);
    Numbers numbers{made.parting(c),           a.velocity.norm(),         b.velocity.norm(),
                    a.angular_velocity.norm(), b.angular_velocity.norm(), pushed};
    if (friction.to > 0) numbers.insert(numbers.end(), {(c.impulse - pushed * c.normal).norm(), made.slip(c).norm()});
    if (!falls)
      numbers.insert(numbers.end(), {(momentum(made.world) - made.momentum_before).norm(),
                                     (angular_momentum(made.world) - made.angular_before).norm()});
    return numbers;
  }
  Numbers operator()(Random& random, const WholeSolver& answer) const {
    Pair made = pair(random);
    return solve(made, random, *answer.make());
  }
};

/// A step before, from which the one that is looked at has an initial guess.
struct After {
  Meeting before, now;
  std::vector<Quantity> quantities() const { return before.quantities(); }
  Numbers operator()(Random& random, const WholeSolver& answer) const {
    Pair pair = before.pair(random);
    const auto solver = answer.make();
    before.solve(pair, random, *solver);
    pair.next(pair.h * random.between(Real(0.5), Real(1.5)), pair.world.contacts);
    pair.contact().restitution = now.restitution.draw(random);
    pair.contact().depth = now.depth.draw(random);
    pair.meet(now.speed.draw(random));
    if (before.falls) integrate_velocity(pair.world.bodies[1], pair.world.gravity, pair.h);
    Meeting measured = before;
    measured.sweeps = now.sweeps;
    return measured.solve(pair, random, *solver);
  }
};

/// Three boxes on the ground and on each other, which touch in six points.
struct Pile : Touching {
  Contacts found;  ///< as detected: a solver may leave out those that did not touch

  explicit Pile(Random& random) : Touching(random) {
    world.add(ground());
    const Vec3 places[] = {{-1, 1, 0}, {1, 1, 0}, {0, Real(2.2), 0}};
    for (const Vec3& place : places) {
      Body body = lump(random);
      world.add(body.at(place + random.vector(Real(0.1))).moving(random.vector(3)).spinning(random.vector(3)));
    }
    const auto near = [&](std::uint32_t a, std::uint32_t b, const Vec3& point, const Vec3& normal,
                          std::uint32_t feature = 0) {
      const Vec3 off = random.vector(Real(0.15)), tilt = random.vector(Real(0.2));
      touch(a, b, point + off, (normal + tilt).normalized(), feature);
    };
    near(0, 1, {-1, Real(0.3), 0}, Vec3::UnitY());
    near(0, 2, {1, Real(0.3), 0}, Vec3::UnitY());
    near(1, 2, {0, 1, Real(-0.6)}, Vec3::UnitX(), 2);
    near(1, 2, {0, 1, Real(0.6)}, Vec3::UnitX(), 5);
    near(1, 3, {Real(-0.5), Real(1.6), Real(-0.2)}, Vec3(Real(0.5), 1, 0));
    near(2, 3, {Real(0.5), Real(1.6), Real(0.2)}, Vec3(Real(-0.5), 1, 0));
    found = world.contacts;
    begin();
  }
  Numbers numbers() const {
    Numbers numbers;
    for (std::size_t i = 1; i <= 3; ++i)
      numbers.insert(numbers.end(), {world.bodies[i].velocity.norm(), world.bodies[i].angular_velocity.norm()});
    for (const Contact& c : found) {
      const auto its = std::find_if(world.contacts.begin(), world.contacts.end(),
                                    [&](const Contact& one) { return one.id == c.id; });
      numbers.push_back(its == world.contacts.end() ? 0 : its->impulse.norm());
    }
    return numbers;
  }
};

inline MeasuredScene of_a_pile(MeasuredScene::Play play) {
  std::vector<Quantity> all;
  for (const int box : {1, 2, 3}) {
    all.push_back({fmt::format("box {} of your pile moves at", box), "m/s", exact});
    all.push_back({fmt::format("box {} of your pile rotates at", box), "rad/s", exact});
  }
  for (const int contact : {1, 2, 3, 4, 5, 6})
    all.push_back({fmt::format("the impulse that contact {} of your pile stores is", contact), "N s", exact});
  return {all, std::move(play)};
}

/// Each of seven points carries another load in the first step. Then the bodies slide on, so far that a point stands where another
/// one stood. Point 1 of each on the ground is gone, and a new one is there. One normal has turned round, so that its old push
/// would pull. Two bodies touch the ground in three points each, and each other in one; features are 1, 2 and 3 for both, and 2. No
/// row follows from the others, so no order of rows changes an impulse. The points are a nanometre apart, because 21 makes those
/// soft that have no gap.
struct EachPointStarts {
  std::vector<Quantity> quantities() const {
    std::vector<Quantity> all;
    for (int point = 1; point <= 7; ++point)
      all.push_back(
          {fmt::format("after a step without a sweep, the separation speed at point {} is", point), "m/s", exact});
    return all;
  }
  Numbers operator()(Random& random, const WholeSolver& answer) const {
    Touching points(random);
    World& world = points.world;
    world.add(ground());
    for (const int side : {-1, 1}) {
      Body body = lump(random);
      world.add(body.at(Vec3(static_cast<Real>(side), 1, 0) + random.vector(Real(0.1))));
    }
    for (const std::uint32_t body : {1u, 2u}) {
      const Vec3 normal = (Vec3::UnitY() + random.vector(Real(0.2))).normalized();
      const auto [tangent1, tangent2] = tangents_of(normal);
      for (const std::uint32_t feature : {1u, 2u, 3u}) {
        const Real angle = static_cast<Real>(feature) * 2 * pi / 3;
        const Vec3 off = Real(0.5) * (std::cos(angle) * tangent1 + std::sin(angle) * tangent2);
        const Vec3 below = world.bodies[body].position - Real(0.7) * normal;
        points.touch(0, body, below + off + random.vector(Real(0.1)), normal, feature);
      }
    }
    points.touch(1, 2, Vec3(0, 1, 0) + random.vector(Real(0.1)), Vec3::UnitX(), 2);
    for (Contact& c : world.contacts) c.depth = Real(-1e-9);
    points.throw_at_contacts(random);
    Contacts found = world.contacts;
    const auto solver = answer.make();
    points.solve(*solver, to_the_end, true);
    const Vec3 way = found[2].point - found[1].point;
    for (Contact& c : found) {
      c.point += way;
      if (c.id.feature == 1) c.id.feature = 0;
    }
    found[5].normal = -found[5].normal;
    for (Body& body : world.bodies)
      if (body.movable()) body.position += way;
    points.next(points.h * random.between(Real(0.5), Real(1.5)), found);
    points.begin();
    points.solve(*solver, 0);
    Numbers numbers;
    for (const Contact& c : found) numbers.push_back(points.parting(c));
    return numbers;
  }
};

/// A beam that lands on two points, as far left as right of its middle.
struct Landing {
  Range reach;                        ///< m, of both points
  Range spin = {}, restitution = {};  ///< spin: as a fraction of the spin at which one end would not fall
  Range sweeps = {1, 4.9};
  double tolerance = exact;
  std::vector<Quantity> quantities() const {
    return {{"your beam moves upwards at", "m/s", tolerance}, {"your beam rotates at", "rad/s", tolerance}};
  }
  Numbers operator()(Random& random, const WholeSolver& answer) const {
    Touching made(random);
    const Real away = reach.draw(random), speed = random.between(1, 4), e = restitution.draw(random);
    const Real turns = (random.below(2) == 0 ? 1 : -1) * spin.draw(random) * speed / away;
    made.world.add(ground());
    Body beam = box({1, Real(0.1), Real(0.2)}, random.over_decades(1, 10));
    made.world.add(beam.at({0, Real(0.1), 0}).moving({0, -speed, 0}).spinning({0, 0, turns}));
    made.touch(0, 1, {-away, 0, 0}, Vec3::UnitY(), 0).restitution = e;
    made.touch(0, 1, {away, 0, 0}, Vec3::UnitY(), 1).restitution = e;
    made.begin();
    made.solve(*answer.make(), static_cast<int>(sweeps.draw(random)));
    const Body& body = made.world.bodies[1];
    return {body.velocity.y(), std::abs(body.angular_velocity.z())};
  }
};

}  // namespace pushback::touching
