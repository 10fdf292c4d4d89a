#include "pushback/tools/measure/study/further_motions.h"

#include <cmath>

#include "pushback/chapters/19_accuracy_and_time/truth.h"

namespace pushback::further {

namespace {

/// An impulse: the velocity of a body's centre of mass changes.
struct Kick {
  double time;               // s, since the motion began
  std::size_t body;          // by its index in the motion's world
  Eigen::Vector3d velocity;  // m/s, world axes: by how much it changes
};

/// Where the bodies that `fill` makes are after 1, 2 ... frames, if nothing but gravity and these kicks changes their velocities:
///
///   x(t) = x + v t + g t^2 / 2 + sum of dv_k (t - t_k)    over the kicks with t_k < t; without g where nothing moves the body
std::vector<Places> places_of_kicked(const std::function<void(World&)>& fill, const std::vector<Kick>& kicks,
                                     int frames) {
  World begin;
  fill(begin);
  std::vector<Places> found;
  for (int frame = 1; frame <= frames; ++frame) {
    const double t = static_cast<double>(frame) / frames_per_second;
    Places places;
    for (const Body& body : begin.bodies) {
      places.emplace_back(body.position.cast<double>());
      if (!body.movable()) continue;
      places.back() += t * body.velocity.cast<double>();
      if (!begin.gravity.isZero(0)) places.back().y() -= truth::g * t * t / 2;  // g in double, also where Real is float
    }
    for (const Kick& kick : kicks)
      if (kick.time < t) places[kick.body] += (t - kick.time) * kick.velocity;
    found.push_back(places);
  }
  return found;
}

/// m, along x, in double whatever Real is.
std::vector<double> places_in_row() {
  std::vector<double> places{0};
  for (const Real gap : Gaps::gaps)
    places.push_back(places.back() + 2 * static_cast<double>(Gaps::radius) + static_cast<double>(gap));
  return places;
}

}  // namespace

void Gaps::operator()(World& world) const {
  world.gravity.setZero();
  const std::vector<double> places = places_in_row();
  for (std::size_t i = 0; i < masses.size(); ++i)
    world.add(sphere(radius, masses[i])
                  .at({static_cast<Real>(places[i]), 0, 0})
                  .moving({i == 0 ? speed : 0, 0, 0})
                  .rough(0)
                  .bouncy(e));
}

std::vector<Places> Gaps::truth(int frames) const {
  std::vector<double> x = places_in_row(), v(x.size()), m(masses.begin(), masses.end());
  v[0] = static_cast<double>(speed);
  std::vector<Kick> kicks;
  for (double now = 0;;) {
    double wait = static_cast<double>(frames) / frames_per_second - now;
    std::size_t first = x.size();
    for (std::size_t i = 0; i + 1 < x.size(); ++i) {
      if (v[i] <= v[i + 1]) continue;  // also the two that have just met
      const double meets = (x[i + 1] - x[i] - 2 * static_cast<double>(radius)) / (v[i] - v[i + 1]);
      if (meets >= wait) continue;
      wait = meets;
      first = i;
    }
    if (first == x.size()) return places_of_kicked(*this, kicks, frames);
    for (std::size_t i = 0; i < x.size(); ++i) x[i] += wait * v[i];
    now += wait;
    const std::size_t next = first + 1;
    const double impulse =
        (1 + static_cast<double>(e)) * m[first] * m[next] / (m[first] + m[next]) * (v[first] - v[next]);
    for (const auto& [ball, change] : {std::pair{first, -impulse / m[first]}, {next, impulse / m[next]}}) {
      v[ball] += change;
      kicks.push_back({now, ball, change * Eigen::Vector3d::UnitX()});
    }
  }
}

void Superball::operator()(World& world) const {
  world.add(ground().rough(mu).bouncy(e));
  world.add(half_space(-Vec3::UnitY()).at({0, apart, 0}).rough(mu).bouncy(e));
  world.add(sphere(radius, 1)
                .at({0, static_cast<Real>(height), 0})
                .moving(velocity().cast<Real>())
                .spinning(spin().cast<Real>())
                .rough(mu)
                .bouncy(e));
}

std::vector<Places> Superball::truth(int frames) const {
  const auto r = static_cast<double>(radius), room = static_cast<double>(apart) - 2 * r, g = truth::g;
  const double until = static_cast<double>(frames) / frames_per_second;
  Eigen::Vector3d v = velocity(), w = spin();
  std::vector<Kick> kicks;
  double now = 0, above_floor = height - r;
  while (true) {
    const double to_ceiling = room - above_floor;
    const bool ceiling = v.y() > 0 && v.y() * v.y() > 2 * g * to_ceiling;
    const double flies = ceiling ? 2 * to_ceiling / (v.y() + std::sqrt(v.y() * v.y() - 2 * g * to_ceiling))
                                 : (v.y() + std::sqrt(v.y() * v.y() + 2 * g * above_floor)) / g;
    if (now + flies >= until) return places_of_kicked(*this, kicks, frames);
    now += flies;
    v.y() -= g * flies;
    above_floor = ceiling ? room : 0;
    const Eigen::Vector3d out = (ceiling ? -1 : 1) * Eigen::Vector3d::UnitY(), arm = -r * out;
    Eigen::Vector3d slip = v + w.cross(arm);
    slip.y() = 0;
    const double normal = (1 + static_cast<double>(e)) * std::abs(v.y()), ends_slip = 2 * slip.norm() / 7;
    const Eigen::Vector3d rub = -std::min(static_cast<double>(mu) * normal, ends_slip) * slip.normalized();
    kicks.push_back({now, 2, normal * out + rub});
    v += kicks.back().velocity;
    w += 5 / (2 * r * r) * arm.cross(rub);  // I / m = 2/5 r^2
  }
}

void Conveyor::operator()(World& world) const {
  world.add(ground().rough(mu).conveying(belt()));
  world.add(box({Real(0.5), Real(0.2), Real(0.5)}, 100).at({0, Real(0.2), 0}).moving(velocity()).rough(mu));
}

std::vector<Places> Conveyor::truth(int frames) const {
  World world;
  (*this)(world);
  const Eigen::Vector3d carried = belt().cast<double>(), slip = velocity().cast<double>() - carried;
  std::vector<Places> found;
  for (int frame = 1; frame <= frames; ++frame) {
    const double t = static_cast<double>(frame) / frames_per_second;
    Places places;
    for (const Body& body : world.bodies) places.emplace_back(body.position.cast<double>());
    places.back() +=
        t * carried + truth::way_of_sliding(slip.norm(), static_cast<double>(mu) * truth::g, t) * slip.normalized();
    found.push_back(places);
  }
  return found;
}

namespace {

/// m, c: from a jaw's edge to its centre, half a diagonal of its square.
const Real to_edge = std::sqrt(Real(2)) * Grasp::half_side;

/// Where the bodies are after each of so many frames if they stay where `fill` puts them.
std::vector<Places> staying(const std::function<void(World&)>& fill, int frames) {
  World world;
  fill(world);
  Places places;
  for (const Body& body : world.bodies) places.emplace_back(body.position.cast<double>());
  return std::vector<Places>(static_cast<std::size_t>(frames), places);
}

}  // namespace

Real Grasp::friction_needed() const {
  return load * height / (2 * jaw * (out + to_edge) + load * out);
}

void Grasp::operator()(World& world) const {
  world.add(ground().at({0, -to_floor, 0}).rough(mu));
  for (const Real side : {Real(-1), Real(1)})
    world.add(box({half_side, half_side, Real(0.1)}, jaw)
                  .turned(pi / 4, Vec3::UnitZ())
                  .at({side * (half + to_edge), -height, 0})
                  .rough(mu));
  world.add(box({half, half, Real(0.15)}, load).at({0, -height - contact_at, 0}).rough(mu));
}

std::vector<Pin> Grasp::pins() const {
  return {{the_world, 1, {out - half, 0, 0}}, {the_world, 2, {half - out, 0, 0}}};
}

std::vector<Places> Grasp::truth(int frames) const {
  return staying(*this, frames);
}

void PileOfHulls::operator()(World& world) const {
  constexpr Real uncut = half_width - cut;
  std::vector<Vec3> corners;
  for (const Real y : {-high / 2, high / 2})
    for (const Real x : {Real(-1), Real(1)})
      for (const Real z : {Real(-1), Real(1)}) {
        corners.push_back({x * half_width, y, z * uncut});
        corners.push_back({x * uncut, y, z * half_width});
      }
  const Body block = hull(corners, mass);  // all share its solid
  world.add(ground());
  for (int layer = 0; layer < base; ++layer) {
    const int across = base - layer;
    const Real first = -static_cast<Real>(across - 1) / 2;
    for (int i = 0; i < across * across; ++i) {
      const int row = i / across, column = i % across;
      const Vec3 place{(first + static_cast<Real>(column)) * apart, (static_cast<Real>(layer) + Real(0.5)) * high,
                       (first + static_cast<Real>(row)) * apart};
      world.add(Body(block).at(place));
    }
  }
}

std::vector<Places> PileOfHulls::truth(int frames) const {
  return staying(*this, frames);
}

Eigen::Matrix3d RollingBall::inertia_about_contact(const Eigen::Quaterniond& turned) const {
  const Eigen::Matrix3d R = turned.toRotationMatrix();
  Eigen::Matrix3d about = R * inertia.asDiagonal() * R.transpose();
  about.diagonal() += mass * radius * radius * Eigen::Vector3d(1, 0, 1);  // n = (0, 1, 0)
  return about;
}

Eigen::Vector3d RollingBall::momentum() const {
  return inertia_about_contact(orientation) * spin;
}

RollingBall RollingBall::after(double seconds, int steps) const {
  using Vector4 = Eigen::Vector4d;
  const Eigen::Vector3d K = momentum();
  const double h = seconds / steps;
  const auto spin_at = [&](const Vector4& coefficients) {
    const Eigen::Quaterniond q(coefficients.normalized().eval());
    return Eigen::Vector3d(inertia_about_contact(q).llt().solve(K));
  };
  struct Rate {
    Vector4 turning;  // q'
    Eigen::Vector3d moving;
  };
  const auto rate_at = [&](const Vector4& q) {
    const Eigen::Vector3d w = spin_at(q);
    const Eigen::Quaterniond turning = Eigen::Quaterniond(0, w.x(), w.y(), w.z()) * Eigen::Quaterniond(q);
    return Rate{turning.coeffs() / 2, radius * w.cross(Eigen::Vector3d::UnitY())};
  };
  RollingBall ball = *this;
  for (int i = 0; i < steps; ++i) {
    const Vector4 q = ball.orientation.coeffs();
    const Rate a = rate_at(q), b = rate_at(q + h / 2 * a.turning), c = rate_at(q + h / 2 * b.turning),
               d = rate_at(q + h * c.turning);
    ball.centre += h / 6 * (a.moving + 2 * b.moving + 2 * c.moving + d.moving);
    ball.orientation.coeffs() = q + h / 6 * (a.turning + 2 * b.turning + 2 * c.turning + d.turning);
    ball.orientation.normalize();
  }
  ball.spin = spin_at(ball.orientation.coeffs());
  return ball;
}

void Chaplygin::operator()(World& world) const {
  const RollingBall given = ball();
  world.add(ground().rough(mu));
  Body rolls = sphere(radius, mass);
  rolls.principal_inverse_inertia = given.inertia.cwiseInverse().cast<Real>();
  world.add(rolls.oriented(given.orientation.cast<Real>())
                .at(given.centre.cast<Real>())
                .moving(given.velocity().cast<Real>())
                .spinning(given.spin.cast<Real>())
                .rough(mu));
}

RollingBall Chaplygin::ball() {
  return {.radius = static_cast<double>(radius),
          .mass = static_cast<double>(mass),
          .inertia = {0.5, 0.9, 1.3},
          .orientation = Eigen::Quaterniond(Eigen::AngleAxisd(0.5, Eigen::Vector3d(1, 2, 3).normalized())),
          .centre = {0, static_cast<double>(radius), 0},
          .spin = {0.5, 5, -2.5}};
}

std::vector<Places> Chaplygin::truth(int frames) const {
  RollingBall rolls = ball();
  std::vector<Places> found;
  for (int frame = 1; frame <= frames; ++frame) {
    rolls = rolls.after(1.0 / frames_per_second, steps_in_a_frame);
    found.push_back({Eigen::Vector3d::Zero(), rolls.centre});
  }
  return found;
}

}  // namespace pushback::further
