#include "pushback/tools/measure/hard_cases/random_scene.h"

#include "pushback/common/basics/input.h"
#include "pushback/common/bodies/random.h"

namespace pushback {

namespace {

/// As often in one octave as in the next. By powers of 2, which are exact: exp and log differ from library to library.
Real over_octaves(Random& random, int low, int high) {
  const int octave = low + static_cast<int>(random.below(static_cast<std::size_t>(high - low)));
  return std::ldexp(random.between(1, 2), octave);
}

bool one_in(Random& random, std::size_t count) {
  return random.below(count) == 0;
}

/// Any orientation, without sine and cosine.
Quat any_orientation(Random& random) {
  const Vec3 axis = random.direction();
  const Real w = random.between(-1, 1);
  return Quat(w, axis.x(), axis.y(), axis.z()).normalized();
}

struct Sizes {
  int shortest, longest;   // m, powers of 2
  int lightest, heaviest;  // kg, powers of 2
};
constexpr Sizes ordinary{-4, 0, 0, 7};     // 6 cm to 1 m, 1 to 128 kg
constexpr Sizes extreme{-10, 6, -10, 20};  // 1 mm to 64 m, so up to 128 m across; 1 g to 1000 t

/// Of 4 to 12 points, now and then of fewer corners. Nearly flat and nearly straight ones are meant to be there; what
/// encloses no volume at all is refused by hull(), and drawn again.
Body random_hull(Random& random, const Vec3& size, Real mass) {
  for (;;) {
    std::vector<Vec3> points(4 + random.below(9));
    for (Vec3& point : points) point = size.cwiseProduct(random.vector(1));
    try {
      return hull(points, mass);
    } catch (const InvalidInput&) {
      continue;
    }
  }
}

Body random_body(Random& random, const Sizes& sizes) {
  const Real x = over_octaves(random, sizes.shortest, sizes.longest);
  const Real y = over_octaves(random, sizes.shortest, sizes.longest);
  const Real z = over_octaves(random, sizes.shortest, sizes.longest);
  const Real mass = over_octaves(random, sizes.lightest, sizes.heaviest);
  const std::size_t shape = random.below(4);
  Body body = shape == 0   ? sphere(x, mass)
              : shape == 1 ? box({x, y, z}, mass)
              : shape == 2 ? capsule(x, y, mass)
                           : random_hull(random, {x, y, z}, mass);
  body.orientation = any_orientation(random);
  return body;
}

void surface(Random& random, Body& body, Real roughest, Real bounciest) {
  body.friction = one_in(random, 4) ? 0 : random.between(0, roughest);
  body.restitution = one_in(random, 2) ? 0 : random.between(0, bounciest);
}

/// What one meets: things dropped onto the ground, from 4 m and less.
void heap(Random& random, World& world, int count) {
  world.add(ground());
  for (int i = 0; i < count; ++i) {
    Body body = random_body(random, ordinary);
    body.position = random.vector(1);  // a statement each: the order of a sum's terms is the compiler's choice
    body.position.y() += random.between(1, 4);
    body.velocity = random.vector(5);
    body.angular_velocity = random.vector(5);
    surface(random, body, 1, 1);
    world.add(body);
  }
}

/// Boxes that stand on each other, in one to four towers.
void towers(Random& random, World& world, int count) {
  world.add(ground());
  const std::size_t towers = 1 + random.below(4);
  std::vector<Real> tops(towers, 0);
  for (int i = 0; i < count; ++i) {
    const std::size_t tower = random.below(towers);
    const Real half = random.between(Real(0.1), Real(0.5));
    Body body = box({Real(0.5), half, Real(0.5)}, over_octaves(random, 0, 10));
    body.position = {Real(1.1) * static_cast<Real>(tower), tops[tower] + half, 0};
    tops[tower] += 2 * half;
    surface(random, body, 1, Real(0.5));
    world.add(body);
  }
}

/// Nothing is as it should be.
void chaos(Random& random, World& world, int count, bool isolated) {
  const Real spread = one_in(random, 4) ? 0 : over_octaves(random, -8, 7);  // 0: all centres in one place
  const Vec3 middle = one_in(random, 5) ? random.vector(over_octaves(random, 10, 24)) : Vec3(Vec3::Zero());
  const Sizes sizes = one_in(random, 3) ? ordinary : extreme;
  const Real fastest = one_in(random, 4) ? 0 : over_octaves(random, -4, 8);
  const Real spin = one_in(random, 4) ? 0 : over_octaves(random, -4, 9);
  for (int i = 0; i < count; ++i) {
    if (!isolated && one_in(random, 8)) {
      Body plane = half_space(random.direction());
      plane.position = middle + random.vector(spread);
      Vec3& normal = std::get<HalfSpace>(plane.shape).normal;
      if (normal.dot(middle - plane.position) < 0) normal = -normal;
      surface(random, plane, 10, 1);
      world.add(plane);
      continue;
    }
    Body body = random_body(random, sizes);
    if (one_in(random, 4))
      body.principal_inverse_inertia *= over_octaves(random, -10, 10);  // hollow, or all in the middle
    body.position = middle + random.vector(spread);
    body.velocity = fastest * random.direction();
    body.angular_velocity = spin * random.direction();
    surface(random, body, 10, 1);
    if (!isolated && one_in(random, 6)) body.fixed();
    if (one_in(random, 10) && !world.bodies.empty()) body.position = world.bodies.back().position;
    world.add(body);
  }
}

}  // namespace

RandomScene random_scene(std::uint64_t seed) {
  Random random(seed);
  RandomScene scene;
  const int count = 1 + static_cast<int>(random.below(one_in(random, 3) ? 20 : 8));
  switch (random.below(4)) {
    case 0:
      heap(random, scene.world, count);
      break;
    case 1:
      towers(random, scene.world, count);
      break;
    case 2:
      chaos(random, scene.world, count, false);
      break;
    default:
      chaos(random, scene.world, count, true);
      scene.isolated = true;
      scene.world.gravity.setZero();
  }
  if (one_in(random, 5)) scene.world.gravity.setZero();
  if (one_in(random, 10)) scene.world.gravity = scene.isolated ? Vec3(Vec3::Zero()) : random.vector(100);
  if (one_in(random, 4)) scene.dt = over_octaves(random, -17, -3);  // 8e-6 to 1/8 s
  return scene;
}

}  // namespace pushback
