#include "pushback/chapters/19_accuracy_and_time/truth.h"

#include <Eigen/Cholesky>
#include <cmath>

namespace pushback::truth {

namespace {
constexpr double lies_below = 1e-12;  // m/s
}

double height_of_bouncing(double height, double e, double t) {
  const double fall = std::sqrt(2 * height / g);
  if (t < fall) return height - g * t * t / 2;
  double since = t - fall, speed = e * g * fall;
  while (since > 2 * speed / g) {
    if (speed < lies_below) return 0;  // for e below 1 there are infinitely many hits in a finite time
    since -= 2 * speed / g;
    speed *= e;
  }
  return speed * since - g * since * since / 2;
}

double way_of_sliding(double speed, double deceleration, double t) {
  const double until = std::min(t, speed / deceleration);
  return speed * until - deceleration * until * until / 2;
}

double way_of_rolling(double speed, double mu, double t) {
  const double slides = 2 * speed / (7 * mu * g), until = std::min(t, slides);
  return way_of_sliding(speed, mu * g, until) + 5 * speed / 7 * (t - until);
}

namespace {

using Angles = Eigen::VectorXd;

class Hangings {
 public:
  explicit Hangings(const std::vector<Hanging>& bodies)
      : bodies_(bodies), mass_(Eigen::MatrixXd::Zero(size(), size())), weight_(Angles::Zero(size())) {
    for (Eigen::Index b = 0; b < size(); ++b) {
      for (Eigen::Index i = 0; i <= b; ++i) {
        weight_[i] += at(b).mass * arm(b, i);
        for (Eigen::Index j = 0; j <= b; ++j) mass_(i, j) += at(b).mass * arm(b, i) * arm(b, j);
      }
      mass_(b, b) += at(b).inertia;
    }
  }
  Eigen::Index size() const { return std::ssize(bodies_); }

  Eigen::MatrixXd mass(const Angles& angle) const {
    Eigen::MatrixXd m = mass_;
    for (Eigen::Index i = 0; i < size(); ++i)
      for (Eigen::Index j = 0; j < size(); ++j) m(i, j) *= std::cos(angle[i] - angle[j]);
    return m;
  }
  Angles acceleration(const Angles& angle, const Angles& speed) const {
    Angles force = -g * (weight_.array() * angle.array().sin()).matrix();
    for (Eigen::Index i = 0; i < size(); ++i)
      for (Eigen::Index j = 0; j < size(); ++j)
        force[i] -= mass_(i, j) * std::sin(angle[i] - angle[j]) * speed[j] * speed[j];
    return mass(angle).llt().solve(force);
  }
  /// One step of the fourth-order Runge-Kutta method.
  void step(Angles& a, Angles& w, double h) const {
    const Angles k1 = acceleration(a, w), w2 = w + h / 2 * k1;
    const Angles k2 = acceleration(a + h / 2 * w, w2), w3 = w + h / 2 * k2;
    const Angles k3 = acceleration(a + h / 2 * w2, w3), w4 = w + h * k3;
    const Angles k4 = acceleration(a + h * w3, w4);
    a += h / 6 * (w + 2 * w2 + 2 * w3 + w4);
    w += h / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
  }
  /// d, m; and its derivative with respect to each angle, m/rad.
  double to_wall(const Angles& angle, const Wall& wall) const {
    return wall.x - wall.radius - places(angle).back().x();
  }
  Angles to_wall_by_angle(const Angles& angle) const {
    Angles by(size());
    for (Eigen::Index i = 0; i < size(); ++i) by[i] = -arm(size() - 1, i) * std::cos(angle[i]);
    return by;
  }
  /// The same, with an impact if the ball reaches the wall.
  void step_beside(const Wall& wall, Angles& a, Angles& w, double h) const {
    const Angles a_before = a, w_before = w;
    const auto go = [&](double t) {
      a = a_before;
      w = w_before;
      step(a, w, t);
      return to_wall(a, wall);
    };
    if (go(h) > 0) return;
    double free = 0, touches = h;
    for (int i = 0; i < 60; ++i) {
      const double middle = (free + touches) / 2;
      (go(middle) > 0 ? free : touches) = middle;
    }
    go(free);
    const Angles by_angle = to_wall_by_angle(a), moved = mass(a).llt().solve(by_angle);
    w -= (1 + wall.e) * by_angle.dot(w) / by_angle.dot(moved) * moved;
    step(a, w, h - free);
  }
  Places places(const Angles& angle) const {
    Places found;
    Eigen::Vector3d pin = Eigen::Vector3d::Zero();
    for (Eigen::Index i = 0; i < size(); ++i) {
      const Eigen::Vector3d down(std::sin(angle[i]), -std::cos(angle[i]), 0);
      found.emplace_back(pin + at(i).to_centre * down);
      pin += at(i).to_next * down;
    }
    return found;
  }

 private:
  const Hanging& at(Eigen::Index i) const { return bodies_[static_cast<std::size_t>(i)]; }
  /// The lever arm of angle i for body b, m/rad.
  double arm(Eigen::Index b, Eigen::Index i) const { return i == b ? at(b).to_centre : at(i).to_next; }

  std::vector<Hanging> bodies_;
  Eigen::MatrixXd mass_;  // M, kg m^2
  Angles weight_;         // G, kg m
};

}  // namespace

std::vector<Places> places_of_hanging(const std::vector<Hanging>& bodies, double angle, int frames,
                                      const std::optional<Wall>& wall) {
  constexpr int steps = 256;  // in a frame
  constexpr double h = 1.0 / (frames_per_second * steps);
  const Hangings hanging(bodies);
  Angles a = Angles::Constant(hanging.size(), angle), w = Angles::Zero(hanging.size());
  std::vector<Places> found;
  for (int frame = 0; frame < frames; ++frame) {
    for (int step = 0; step < steps; ++step) {
      if (wall) hanging.step_beside(*wall, a, w, h);
      else hanging.step(a, w, h);
    }
    found.push_back(hanging.places(a));
  }
  return found;
}

namespace {

constexpr double at_rest = 1e-12;  // m^2/s: with e = 0, rounding would otherwise cause collisions without end

/// The time until two balls touch, s; infinite if they never do, or if they separate.
double time_to_touch(const Eigen::Vector3d& apart, const Eigen::Vector3d& closing, double distance) {
  const double approach = apart.dot(closing), gap = apart.squaredNorm() - distance * distance;
  const double root = approach * approach - closing.squaredNorm() * gap;
  if (approach >= -at_rest || root < 0) return std::numeric_limits<double>::infinity();
  return std::max(0.0, gap / (std::sqrt(root) - approach));
}

}  // namespace

std::vector<Places> places_of_colliding(Places at, Places velocities, double radius, double e, int frames) {
  std::vector<Places> found;
  for (int frame = 0; frame < frames; ++frame) {
    double left = 1.0 / frames_per_second;
    while (left > 0) {
      double next = left;
      std::size_t first = 0, second = 0;  // equal: no collision
      for (std::size_t i = 0; i < at.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) {
          const double touch = time_to_touch(at[i] - at[j], velocities[i] - velocities[j], 2 * radius);
          if (touch >= next) continue;
          next = touch;
          first = j;
          second = i;
        }
      }
      for (std::size_t i = 0; i < at.size(); ++i) at[i] += next * velocities[i];
      left -= next;
      if (first == second) break;
      const Eigen::Vector3d n = (at[second] - at[first]).normalized();
      const Eigen::Vector3d impact = (1 + e) / 2 * n.dot(velocities[first] - velocities[second]) * n;
      velocities[first] -= impact;
      velocities[second] += impact;
    }
    found.push_back(at);
  }
  return found;
}

}  // namespace pushback::truth
