#include "pushback/tools/classroom/mine/below_scenes.h"

#include <algorithm>
#include <set>

#include "pushback/common/world/measure.h"

namespace pushback {

namespace {

constexpr double exact = 1e-6;

Vec3 size(Random& random) {
  const Real x = random.between(Real(0.3), 1), y = random.between(Real(0.3), 1), z = random.between(Real(0.3), 1);
  return {x, y, z};
}

/// Made as the pages say, whatever the answer's `box` does: each check asks for one thing.
OwnBody box_of(const Vec3& half, Real mass) {
  const Vec3 squared = half.cwiseProduct(half);
  OwnBody made{.half = half,
               .inverse_inertia = {},
               .inverse_mass = 1 / mass,
               .position = Vec3::Zero(),
               .orientation = Quat::Identity(),
               .velocity = Vec3::Zero(),
               .angular_velocity = Vec3::Zero()};
  for (int i = 0; i < 3; ++i) made.inverse_inertia[i] = 3 / (mass * (squared.sum() - squared[i]));
  return made;
}

OwnBody tumbling(Random& random) {
  OwnBody made = box_of(size(random), random.over_decades(1, 10));
  made.position = random.vector(2);
  made.orientation = random.orientation();
  made.velocity = random.vector(3);
  made.angular_velocity = random.vector(3);
  return made;
}

/// Nothing moves it.
OwnBody held(OwnBody body) {
  body.inverse_mass = 0;
  body.inverse_inertia.setZero();
  body.velocity.setZero();
  body.angular_velocity.setZero();
  return body;
}

Mat3 axes(const OwnBody& body) {
  return body.orientation.toRotationMatrix();
}
Vec3 angular_momentum(const OwnBody& body) {
  return axes(body) * (axes(body).transpose() * body.angular_velocity).cwiseQuotient(body.inverse_inertia);
}
Real spin_energy(const OwnBody& body) {
  return body.angular_velocity.dot(angular_momentum(body)) / 2;
}

// ---- a body and its step ---------------------------------------------------------------------------------------------

Numbers is_made(Random& random, const OwnBodies& answer) {
  const Vec3 half = size(random);
  const OwnBody body = answer.box(half, random.over_decades(1, 10));
  return {body.inverse_mass, body.inverse_inertia.x(), body.inverse_inertia.y(), body.inverse_inertia.z()};
}

Numbers is_pushed(Random& random, const OwnBodies& answer) {
  OwnBody body = tumbling(random);
  body.velocity.setZero();
  body.angular_velocity.setZero();
  OwnBody fixed = held(body);
  const Vec3 impulse = random.between(1, 5) * random.direction(), arm = random.vector(1);
  answer.push(body, impulse, body.position + arm);
  answer.push(fixed, impulse, fixed.position + arm);
  const Vec3 at_point = body.velocity + body.angular_velocity.cross(arm);
  return {body.velocity.norm(), body.angular_velocity.norm(), at_point.dot(impulse.normalized()),
          fixed.velocity.norm() + fixed.angular_velocity.norm()};
}

Numbers falls(Random& random, const OwnBodies& answer) {
  const Vec3 gravity = random.between(5, 15) * random.direction();
  const Real h = 1 / random.between(30, 90);
  OwnBody body = box_of(size(random), random.over_decades(1, 10)), fixed = held(body);
  for (int step = 0; step < 20; ++step) {
    for (OwnBody* each : {&body, &fixed}) {
      answer.accelerate(*each, gravity, h);
      answer.move(*each, h);
    }
  }
  const Vec3 down = gravity.normalized();
  return {body.velocity.dot(down), body.position.dot(down), fixed.position.norm() + fixed.velocity.norm()};
}

/// A long and flat box that spins about the axis that no box spins about for long.
OwnBody thrown(Random& random) {
  OwnBody body = box_of({Real(0.9), Real(0.15), Real(0.45)}, random.over_decades(1, 10));
  body.orientation = random.orientation();
  const Real fast = random.between(4, 6);
  body.angular_velocity = axes(body) * (Vec3(1, 1, fast) + random.vector(Real(0.5)));
  return body;
}

Numbers turns_once(Random& random, const OwnBodies& answer) {
  OwnBody body = thrown(random);
  answer.move(body, 1 / random.between(30, 60));
  return {body.orientation.norm()};
}

Numbers spins(Random& random, const OwnBodies& answer) {
  OwnBody body = thrown(random);
  const OwnBody before = body;
  const Real h = 1 / random.between(80, 120);
  for (int step = 0; step < 100; ++step) answer.move(body, h);
  const Real turned = std::clamp<Real>(axes(body).col(0).dot(axes(before).col(0)), -1, 1);
  return {std::acos(turned) * 180 / pi,
          100 * (angular_momentum(body) - angular_momentum(before)).norm() / angular_momentum(before).norm(),
          100 * (spin_energy(body) / spin_energy(before) - 1)};
}

// ---- where two bodies touch ------------------------------------------------------------------------------------------

Real deepest(const OwnTouches& touches) {
  Real depth = 0;
  for (const OwnTouch& one : touches) depth = std::max(depth, one.depth);
  return depth;
}

/// How many, the depth, how far the normal leads along `way`, and where along it, and away from it, the first point is.
Numbers one_touch(const OwnTouches& touches, const Vec3& way, const Vec3& from) {
  if (touches.empty()) return {0, 0, 0, 0, 0};
  const Vec3 to_point = touches[0].point - from;
  return {static_cast<Real>(touches.size()), touches[0].depth, touches[0].normal.dot(way), to_point.dot(way),
          (to_point - to_point.dot(way) * way).norm()};
}

std::vector<Quantity> of_one_touch(const std::string& who) {
  return {{"the points at which " + who + " touch number", "", 0.5},
          {"they are as deep as", "m", exact},
          {"your normal has, along the way from A to B, a length of", "", exact},
          {"along the normal, your point is off the reference by", "m", exact},
          {"across the normal, your point is off the reference by", "m", exact}};
}

Numbers ball_lies(Random& random, const OwnBodies& answer) {
  const Vec3 normal = random.direction();
  const Real offset = random.between(-1, 1), radius = random.between(Real(0.3), 1),
             depth = random.between(Real(0.05), Real(0.2));
  const Vec3 on_plane = offset * normal + normal.cross(random.vector(2));
  Numbers numbers =
      one_touch(answer.plane_and_ball(normal, offset, on_plane + (radius - depth) * normal, radius), normal, on_plane);
  const Vec3 apart = on_plane + (radius + depth) * normal;
  numbers.push_back(static_cast<Real>(answer.plane_and_ball(normal, offset, apart, radius).size()));
  return numbers;
}

Numbers balls_meet(Random& random, const OwnBodies& answer) {
  const Vec3 way = random.direction(), a = random.vector(2);
  const Real radius_a = random.between(Real(0.3), 1), radius_b = random.between(Real(0.3), 1),
             depth = random.between(Real(0.05), Real(0.2));
  const auto at = [&](Real distance) { return answer.balls(a, radius_a, a + distance * way, radius_b); };
  Numbers numbers = one_touch(at(radius_a + radius_b - depth), way, a + (radius_a - depth / 2) * way);
  numbers.push_back(static_cast<Real>(at(radius_a + radius_b + depth).size()));
  return numbers;
}

Numbers box_lies(Random& random, const OwnBodies& answer) {
  OwnBody body = tumbling(random);
  const Vec3 normal = random.direction();
  const Real reach = (axes(body).transpose() * normal).cwiseAbs().dot(body.half);
  const OwnTouches touches =
      answer.plane_and_box(normal, body.position.dot(normal) - random.between(Real(0.3), Real(0.9)) * reach, body);
  Real sum = 0, along = 0;
  for (const OwnTouch& one : touches) {
    sum += one.depth;
    along += one.normal.dot(normal);
  }
  return {static_cast<Real>(touches.size()), deepest(touches), sum, along};
}

/// B stands on A, a little tilted and turned, with one side over A's edge: a face of A is where they overlap least.
struct Stands {
  OwnBody a, b;
  Vec3 up;

  explicit Stands(Random& random) {
    a = box_of({1, Real(0.5), 1}, 1);
    a.orientation = random.orientation();
    a.position = random.vector(2);
    b = box_of({Real(0.6), Real(0.6), Real(0.6)}, 1);
    up = axes(a).col(1);
    const Vec3 over = axes(a).col(0), along = axes(a).col(2);
    const Real tilt = random.between(Real(0.01), Real(0.04)), turn = random.between(Real(0.1), Real(0.3));
    b.orientation = Quat(Eigen::AngleAxis<Real>(tilt, along)) * Quat(Eigen::AngleAxis<Real>(turn, up)) * a.orientation;
    const Real reach = (axes(b).transpose() * up).cwiseAbs().dot(b.half);
    b.position = a.position + (a.half.y() + reach - Real(0.12)) * up + random.between(Real(0.75), Real(0.85)) * over +
                 random.between(Real(-0.1), Real(0.1)) * along;
  }
};

Numbers box_stands(Random& random, const OwnBodies& answer) {
  const Stands scene(random);
  const OwnTouches touches = answer.boxes(scene.a, scene.b);
  Real along = 0, outside = 0, from_middle = 0;
  const Vec3 surface = scene.a.position + scene.a.half.y() * scene.up;
  for (const OwnTouch& one : touches) {
    along += one.normal.dot(scene.up) / static_cast<Real>(touches.size());
    const Vec3 at = (axes(scene.a).transpose() * (one.point - scene.a.position)).cwiseAbs() - scene.a.half;
    outside = std::max({outside, at.x(), at.z()});
    from_middle = std::max(from_middle, std::abs((one.point - surface).dot(scene.up) + one.depth / 2));
  }
  OwnBody apart = scene.b;
  apart.position += Real(0.2) * scene.up;
  return {static_cast<Real>(touches.size()),
          deepest(touches),
          along,
          outside,
          from_middle,
          static_cast<Real>(answer.boxes(scene.a, apart).size())};
}

Numbers faces_overlap(Random& random, const OwnBodies& answer) {
  const Stands scene(random);
  const OwnTouches axis = answer.least_overlap(scene.a, scene.b), turned = answer.least_overlap(scene.b, scene.a);
  OwnBody apart = scene.b;
  apart.position += Real(0.2) * scene.up;
  const auto along = [&](const OwnTouches& all) { return all.empty() ? 0 : all[0].normal.dot(scene.up); };
  return {deepest(axis), along(axis), along(turned), static_cast<Real>(answer.least_overlap(scene.a, apart).size())};
}

/// An edge of B across an edge of A.
struct Cross {
  OwnBody a, b;
  Vec3 up;
  Real reach_a, depth;

  explicit Cross(Random& random) {
    const Quat frame = random.orientation();
    const auto about = [](Real angle, const Vec3& axis) { return Quat(Eigen::AngleAxis<Real>(angle, axis)); };
    const auto turn = [&] { return pi / 4 + random.between(Real(-0.1), Real(0.1)); };
    a = box_of({1, Real(0.4), Real(0.4)}, 1);
    b = box_of({Real(0.4), Real(0.4), 1}, 1);
    a.orientation = frame * about(turn(), Vec3::UnitX());
    b.orientation = frame * about(turn(), Vec3::UnitZ());
    up = frame * Vec3::UnitY();
    const auto reach = [&](const OwnBody& body) { return (axes(body).transpose() * up).cwiseAbs().dot(body.half); };
    reach_a = reach(a);
    depth = random.between(Real(0.02), Real(0.08));
    const Real along = random.between(Real(-0.3), Real(0.3)), across = random.between(Real(-0.3), Real(0.3));
    b.position = (reach_a + reach(b) - depth) * up + frame * Vec3(along, 0, across);
  }
};

Numbers edges_cross(Random& random, const OwnBodies& answer) {
  const Cross scene(random);
  Numbers numbers = one_touch(answer.edges(scene.a, scene.b), scene.up, (scene.reach_a - scene.depth / 2) * scene.up);
  OwnBody apart = scene.b;
  apart.position += Real(0.12) * scene.up;
  numbers.push_back(static_cast<Real>(answer.least_overlap(scene.a, apart).size()));
  return numbers;
}

// ---- what a contact is called ----------------------------------------------------------------------------------------

std::set<int> names(const OwnTouches& touches) {
  std::set<int> all;
  for (const OwnTouch& one : touches) all.insert(one.name);
  return all;
}
Real in_both(const OwnTouches& before, const OwnTouches& now) {
  const std::set<int> old = names(before), all = names(now);
  return static_cast<Real>(std::count_if(all.begin(), all.end(), [&](int name) { return old.contains(name); }));
}

Numbers names_differ(Random& random, const OwnBodies& answer) {
  Real points = 0, different = 0;
  for (int pair = 0; pair < 10; ++pair) {
    const Stands scene(random);
    const OwnTouches touches = answer.boxes(scene.a, scene.b);
    points += static_cast<Real>(touches.size());
    different += static_cast<Real>(names(touches).size());
  }
  return {points - different};
}

Numbers names_stay(Random& random, const OwnBodies& answer) {
  Real lost = 0;
  for (int pair = 0; pair < 10; ++pair) {
    Stands scene(random);
    const OwnTouches before = answer.boxes(scene.a, scene.b);
    scene.b.position += random.vector(Real(1e-5));
    const OwnTouches now = answer.boxes(scene.a, scene.b);
    lost += static_cast<Real>(names(now).size()) - in_both(before, now);
  }
  return {lost};
}

/// Of a cube that is level, over the edge and then not; and of one that has rolled on by a quarter of a turn.
Numbers names_change(Random& random, const OwnBodies& answer) {
  OwnBody a = box_of({2, Real(0.5), 2}, 1), b = box_of({Real(0.5), Real(0.5), Real(0.5)}, 1);
  const Quat frame = random.orientation();
  const auto about = [](Real angle, const Vec3& axis) { return Quat(Eigen::AngleAxis<Real>(angle, axis)); };
  const Real turn = random.between(Real(0.1), Real(0.2)), z = random.between(-1, 1);
  const auto touches = [&](Real x, Real rolled) {
    OwnBody under = a, on = b;
    under.orientation = frame;
    on.orientation = frame * about(turn, Vec3::UnitY()) * about(rolled, Vec3::UnitZ());
    on.position = frame * Vec3(x, Real(0.99), z);
    return answer.boxes(under, on);
  };
  const OwnTouches whole = touches(1, 0);
  return {in_both(whole, touches(2, 0)), in_both(whole, touches(1, pi / 2))};
}

/// The solver of chapter 07, on the answer's bodies and its contacts: a push and two tangents at each point, ten sweeps, b for
/// what is deeper than 5 mm.
struct Engine {
  struct Pair {
    std::size_t a, b;
    OwnTouches points;
    std::vector<Vec3> impulses;  // N s, on B
  };
  const OwnBodies& answer;
  std::vector<OwnBody> bodies;
  std::vector<Pair> pairs = {};

  void step(Real h) {
    const std::vector<Pair> before = std::move(pairs);
    pairs.clear();
    for (std::size_t a = 0; a + 1 < bodies.size(); ++a)  // each stands on the one before
      if (const OwnTouches points = answer.boxes(bodies[a], bodies[a + 1]); !points.empty())
        pairs.push_back({a, a + 1, points, std::vector<Vec3>(points.size(), Vec3::Zero())});
    for (OwnBody& body : bodies) answer.accelerate(body, {0, Real(-9.81), 0}, h);
    for (Pair& pair : pairs)
      for (const Pair& old : before)
        if (old.a == pair.a) start(pair, old);
    for (int sweep = 0; sweep < 10; ++sweep)
      for (Pair& pair : pairs)
        for (std::size_t i = 0; i < pair.points.size(); ++i) solve(pair, i, h);
    for (OwnBody& body : bodies) answer.move(body, h);
  }
  void start(Pair& pair, const Pair& old) {
    for (std::size_t i = 0; i < pair.points.size(); ++i) {
      for (std::size_t k = 0; k < old.points.size(); ++k) {
        if (old.points[k].name != pair.points[i].name) continue;
        apply(pair, i, old.impulses[k]);
        break;
      }
    }
  }
  void apply(Pair& pair, std::size_t i, const Vec3& impulse) {
    pair.impulses[i] += impulse;
    answer.push(bodies[pair.a], -impulse, pair.points[i].point);
    answer.push(bodies[pair.b], impulse, pair.points[i].point);
  }
  void solve(Pair& pair, std::size_t i, Real h) {
    const OwnTouch& at = pair.points[i];
    const auto [t1, t2] = tangents_of(at.normal);
    along(pair, i, at.normal, std::min<Real>(0, Real(0.2) / h * (Real(0.005) - at.depth)), 0, Real(1e30));
    const Real bound = pair.impulses[i].dot(at.normal) / 2;
    for (const Vec3& t : {t1, t2}) along(pair, i, t, 0, -bound, bound);
  }
  void along(Pair& pair, std::size_t i, const Vec3& n, Real bias, Real lo, Real hi) {
    const Vec3& p = pair.points[i].point;
    Real k = 0, speed = 0;
    for (const auto& [index, sign] : {std::pair{pair.a, Real(-1)}, std::pair{pair.b, Real(1)}}) {
      const OwnBody& body = bodies[index];
      const Vec3 r = p - body.position, rn = axes(body).transpose() * r.cross(n);
      k += body.inverse_mass + rn.dot(body.inverse_inertia.cwiseProduct(rn));
      speed += sign * n.dot(body.velocity + body.angular_velocity.cross(r));
    }
    const Real total = pair.impulses[i].dot(n);
    apply(pair, i, (std::clamp(total - (speed + bias) / k, lo, hi) - total) * n);
  }
};

/// How many boxes of a stack are no longer within 0.3 m of their place after two seconds.
Numbers own_stack_stands(Random& random, const OwnBodies& answer) {
  const std::size_t count = 7 + random.below(3);
  Engine engine{answer, {held(box_of({5, Real(0.5), 5}, 1))}};
  engine.bodies[0].position.y() = Real(-0.5);
  for (std::size_t i = 0; i < count; ++i) {
    engine.bodies.push_back(box_of({Real(0.5), Real(0.5), Real(0.5)}, random.between(80, 120)));
    engine.bodies.back().position = {0, Real(0.5) + static_cast<Real>(i), 0};
  }
  const std::vector<OwnBody> before = engine.bodies;
  for (int step = 0; step < 240; ++step) engine.step(Real(1) / 120);
  Real gone = 0;
  for (std::size_t i = 0; i < before.size(); ++i)
    gone += !((engine.bodies[i].position - before[i].position).norm() < Real(0.3));
  return {gone};
}

std::vector<CheckOfPage> made() {
  const auto with = [](std::vector<Quantity> quantities, const Quantity& last) {
    quantities.push_back(last);
    return quantities;
  };
  return {
      {1,
       {"a box has its mass and its inertia",
        1,
        {{"your box has an inverse mass of", "1/kg", exact},
         {"your box has, about its first axis, an inverse inertia of", "1/(kg m²)", exact},
         {"about its second axis, of", "1/(kg m²)", exact},
         {"about its third axis, of", "1/(kg m²)", exact}},
        is_made}},
      {1,
       {"an impulse at a point changes v and ω",
        1,
        {{"after an impulse your box moves with", "m/s", exact},
         {"after an impulse your box turns with", "rad/s", exact},
         {"the point that was pushed moves along the impulse with", "m/s", exact},
         {"what nothing moves gets a velocity of", "m/s", exact}},
        is_pushed}},
      {1,
       {"it falls: first the velocity, then the place",
        1,
        {{"after twenty steps your box falls with", "m/s", exact},
         {"after twenty steps your box has fallen", "m", exact},
         {"what nothing moves has moved", "m", exact}},
        falls}},
      {1,
       {"a turn leaves the quaternion as long as it was",
        1,
        {{"after a step your quaternion has a length of", "", exact}},
        turns_once}},
      {1,
       {"free, it keeps its angular momentum and its energy",
        1,
        {{"your box's long axis has turned by", "°", 0.5},
         {"your box's angular momentum has changed by", "%", 1e-3},
         {"your box's energy of turning has changed by", "%", 0.5}},
        spins}},
      {2,
       {"a ball on a plane", 1,
        with(of_one_touch("plane and ball"),
             {"a ball that is apart from the plane touches at so many points:", "", 0.5}),
        ball_lies}},
      {2,
       {"two balls", 1, with(of_one_touch("two balls"), {"two balls that are apart touch at so many points:", "", 0.5}),
        balls_meet}},
      {2,
       {"the corners of a box below a plane",
        1,
        {{"the corners of your box below the plane number", "", 0.5},
         {"the deepest is as deep as", "m", exact},
         {"all together they are as deep as", "m", exact},
         {"along the plane's normal, your normals sum up to", "", exact}},
        box_lies}},
      {2,
       {"where a face overlaps least, its normal tells, from A to B",
        1,
        {{"where your boxes overlap least, they do by", "m", exact},
         {"your normal has, along the face of A, a length of", "", exact},
         {"with A and B exchanged, along that face, a length of", "", exact},
         {"boxes that are apart overlap in so many directions:", "", 0.5}},
        faces_overlap}},
      {2,
       {"an edge across an edge", 1,
        with(of_one_touch("two edges that cross"),
             {"two edges that are apart overlap in so many directions:", "", 0.5}),
        edges_cross}},
      {3,
       {"a box on another one, over its edge",
        1,
        {{"the points at which your boxes touch number", "", 0.5},
         {"the deepest is as deep as", "m", 2e-3},
         {"your normals have, along the face, a length of", "", exact},
         {"your points lie beside the lower box by", "m", exact},
         {"your points are off the middle between the surfaces by", "m", exact},
         {"boxes that are apart touch at so many points:", "", 0.5}},
        box_stands}},
      {3,
       {"each point of a pair has a name of its own",
        1,
        {{"of your points, those that share a name number", "", 0.5}},
        names_differ}},
      {3,
       {"a name stays while the same features meet",
        1,
        {{"after a move of 10 µm, the points without their old name number", "", 0.5}},
        names_stay}},
      {3,
       {"a name changes with the features",
        1,
        {{"over the edge of the table, your cube keeps so many of its names:", "", 0.5},
         {"on its next face, your cube keeps so many of its names:", "", 0.5}},
        names_change}},
      {3,
       {"a stack of seven to nine stands on your bodies and contacts",
        1,
        {{"of the boxes of your stack, those that have left their place are", "", 0.5}},
        own_stack_stands}},
  };
}

}  // namespace

const std::vector<CheckOfPage>& checks_of_pages() {
  static const std::vector<CheckOfPage> all = made();
  return all;
}

Numbers play(std::size_t check, Random& random, const OwnBodies& answer) {
  return checks_of_pages()[check].check.play(random, answer);
}

}  // namespace pushback
