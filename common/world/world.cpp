#include "pushback/common/world/world.h"

#include <Eigen/LU>
#include <algorithm>
#include <cassert>

#include "pushback/common/basics/input.h"
#include "pushback/common/collision/broad_phase.h"
#include "pushback/common/collision/collide.h"

namespace pushback {

int World::add(const Body& body) {
  Body checked = body;
  check(checked);
  checked.index = static_cast<int>(bodies.size());
  bodies.push_back(checked);
  return checked.index;
}

void check_step(Real dt, int sweeps, const Vec3& gravity) {
  constexpr Real longest = 1;  // s, because some solvers divide a step of any length into substeps of 0.5 ms
  if (!(dt > 0 && dt <= longest))
    throw InvalidInput(fmt::format("dt is {}: a number above 0 and up to {} s is needed", dt, longest));
  if (sweeps < 0) throw InvalidInput(fmt::format("sweeps is {}: a whole number, 0 or more, is needed", sweeps));
  require_finite("gravity", gravity);
}

namespace {

bool is_there(const World& world, int body) {
  return body >= 0 && std::size_t(body) < world.bodies.size() && !world.bodies[std::size_t(body)].removed;
}

}  // namespace

void World::remove(int body) {
  if (!is_there(*this, body))
    throw InvalidInput(fmt::format("body to remove is {}: the index of a body in the world is needed", body));
  Body empty;
  empty.index = body;
  empty.groups = empty.touches = 0;
  empty.removed = true;
  bodies[std::size_t(body)] = empty;
  std::erase_if(joints, [body](const Joint& joint) { return joint.a == body || joint.b == body; });
  std::erase_if(forces, [body](const Force& force) {
    return std::find(force.bodies.begin(), force.bodies.end(), body) != force.bodies.end();
  });
  for (Contacts* all : {&contacts, &contacts_before})
    std::erase_if(*all,
                  [id = std::uint32_t(body)](const Contact& at) { return at.id.body_a == id || at.id.body_b == id; });
}

void check_bodies_of(const Force& force, const World& world) {
  for (const int i : force.bodies)
    if (!is_there(world, i))
      throw InvalidInput(
          fmt::format("{} acts on body {}: of {} bodies, the first is 0", force.name, i, world.bodies.size()));
}

void check_bodies_of(const Joint& joint, const World& world) {
  for (const int i : {joint.a, joint.b})
    if (i != the_world && !is_there(world, i))
      throw InvalidInput(
          fmt::format("{} holds body {}: of {} bodies, the first is 0", joint.name, i, world.bodies.size()));
  if (joint.a == joint.b)
    throw InvalidInput(fmt::format("{} joins body {} to itself: two different ones are needed", joint.name, joint.a));
}

void check_places(const World& world) {
  for (std::size_t i = 0; i < world.bodies.size(); ++i)
    if (world.bodies[i].index != static_cast<int>(i))
      throw InvalidInput(
          fmt::format("index of the body at place {} of World::bodies is {}: {} is needed. World::add puts a body in, "
                      "World::remove takes it out",
                      i, world.bodies[i].index, i));
  for (const Force& force : world.forces) check_bodies_of(force, world);
  for (const Joint& joint : world.joints) check_bodies_of(joint, world);
}

void check_state(const Body& body) {
  const auto require = [&body](const char* what, const auto& value, bool finite) {
    if (!finite) require_finite(fmt::format("{} of body {}", what, body.index), value);
  };
  require("position", body.position, body.position.allFinite());
  require("velocity", body.velocity, body.velocity.allFinite());
  require("angular velocity", body.angular_velocity, body.angular_velocity.allFinite());
  require("force", body.force, body.force.allFinite());
  require("torque", body.torque, body.torque.allFinite());
  constexpr Real rounding = std::numeric_limits<Real>::digits > 24 ? Real(1e-9) : Real(1e-5);
  if (!(std::abs(body.orientation.squaredNorm() - 1) <= rounding))
    throw InvalidInput(
        fmt::format("length of the orientation of body {} is {}: 1 is needed, as Body::oriented makes it", body.index,
                    body.orientation.norm()));
}

void keep_velocity(Body& body) {
  body.velocity_before = body.velocity;
  body.angular_velocity_before = body.angular_velocity;
}

void integrate_velocity(Body& body, const Vec3& gravity, Real dt) {
  if (body.movable()) {
    body.velocity += dt * (gravity + body.inverse_mass * body.force);
    body.angular_velocity += dt * body.inverse_inertia * body.torque;
  }
  body.force.setZero();
  body.torque.setZero();
}

void integrate_position(Body& body, Real dt) {
  if (body.conveys) return;
  body.position += dt * body.velocity;
  if (body.angular_velocity != Vec3::Zero()) spin_freely(body, dt);
}

void move(Body& body, Real dt) {
  const bool turns = body.angular_velocity != Vec3::Zero();
  integrate_position(body, dt);
  if (turns) body.refresh_inertia();
}

void World::find_contacts(const Margin& margin, Workers& workers) {
  constexpr std::size_t least = 32;  // pairs
  contacts.clear();
  const JoinedPairs joined(joints);
  const std::vector<BodyPair> pairs = near_pairs(bodies, margin, workers);
  std::vector<Contacts> of_others(workers.parts(pairs.size(), least) - 1);
  workers.each(pairs.size(), least, [&](Part part) {
    Contacts& into = part.index == 0 ? contacts : of_others[part.index - 1];
    for (std::size_t i = part.begin; i < part.end; ++i) {
      const auto& [first, second] = pairs[i];
      const Body &a = bodies[static_cast<std::size_t>(first)], &b = bodies[static_cast<std::size_t>(second)];
      if (may_touch(a, b) && !joined.contain(first, second)) collide(a, b, into, margin);
    }
  });
  for (const Contacts& found : of_others) contacts.insert(contacts.end(), found.begin(), found.end());
  // Pairs arrive in ascending order, and so do the points of a pair, so nothing is left to sort.
  assert(
      std::is_sorted(contacts.begin(), contacts.end(), [](const Contact& p, const Contact& q) { return p.id < q.id; }));
}

void World::move(Real dt) {
  for (Body& body : bodies) pushback::move(body, dt);
  time += dt;
  dt_before = dt;
}

Real separating_speed(const World& world, const Contact& at) {
  const auto [a, b] = world.bodies_of(at);
  return (b.velocity_at(at.point) - a.velocity_at(at.point)).dot(at.normal);
}

bool tumbles(const Body& body) {
  const Vec3& inverse = body.principal_inverse_inertia;
  return inverse.minCoeff() > 0 && (inverse.x() != inverse.y() || inverse.y() != inverse.z());
}

namespace {

/// Turns the body about w, which stays constant.
void spin_exactly(Body& body, Real dt) {
  const Real spin = body.angular_velocity.norm();
  if (spin == 0) return;
  body.orientation = Quat(Eigen::AngleAxis<Real>(dt * spin, body.angular_velocity / spin)) * body.orientation;
  body.orientation.normalize();
}

/// q' = normalise(q + h/2 q (0, w)).   `spin`: w, body axes.
Quat turned(const Quat& q, const Vec3& spin, Real dt) {
  const Vec3 half = dt / 2 * spin;
  return (q * Quat(1, half.x(), half.y(), half.z())).normalized();
}

}  // namespace

void spin_evenly(Body& body, Real dt) {
  body.orientation = turned(body.orientation, body.orientation.conjugate() * body.angular_velocity, dt);
}

// The implicit midpoint rule for Euler's equation, in body axes, with the momentum p = I w:
//
//   p' - p = h (p_m x w_m),     p_m = (p + p') / 2,   w_m = I^-1 p_m
//
// keeps |p|^2 and the energy p . I^-1 p / 2 exactly, because both are quadratic. Turning the body by the same w_m,
// q' = normalise(q + h/2 q (0, w_m)), is a Cayley transform, which keeps L = R p constant in the world: R' p' = R p.
// The code therefore keeps L and computes the new w from it.
// Hairer, Lubich, Wanner, Geometric Numerical Integration, IV.1 and VII.5.
//
// Newton's method can fail if a body turns by several radians in a step. The body is then turned about L, as if it were
// symmetric, which keeps p and therefore the energy.
void spin_freely(Body& body, Real dt) {
  if (!body.movable()) return spin_exactly(body, dt);
  if (!tumbles(body)) return spin_evenly(body, dt);
  Quat& q = body.orientation;
  const Quat q_before = q;
  const Vec3& inverse = body.principal_inverse_inertia;
  const Vec3 inertia = inverse.cwiseInverse();
  const Vec3 p = inertia.cwiseProduct(q.conjugate() * body.angular_velocity);  // L, body axes
  const Vec3 momentum = q * p;                                                 // L, world axes
  Vec3 p_m = p;
  for (int i = 0; i < 8; ++i) {
    const Vec3 w_m = inverse.cwiseProduct(p_m);
    const Vec3 error = p_m - p - dt / 2 * p_m.cross(w_m);
    const Mat3 slope = Mat3::Identity() - dt / 2 * (skew(p_m) * inverse.asDiagonal() - skew(w_m));
    const Vec3 correction = slope.inverse() * error;
    if (!correction.allFinite()) break;
    p_m -= correction;
    if (correction.norm() <= std::numeric_limits<Real>::epsilon() * p.norm()) break;
  }
  q = turned(q, inverse.cwiseProduct(p_m), dt);
  const auto twice_energy = [&inverse](const Vec3& its_p) { return its_p.dot(inverse.cwiseProduct(its_p)); };
  constexpr Real rounding = Real(1e4) * std::numeric_limits<Real>::epsilon();
  const Real before = twice_energy(p), after = twice_energy(q.conjugate() * momentum);
  if (!(std::abs(after - before) <= rounding * before)) {
    const Real size = momentum.norm();
    q = Quat(Eigen::AngleAxis<Real>(dt * before / size, momentum / size)) * q_before;
    q.normalize();
  }
  body.angular_velocity = q * Vec3(inverse.cwiseProduct(q.conjugate() * momentum));
}

}  // namespace pushback
