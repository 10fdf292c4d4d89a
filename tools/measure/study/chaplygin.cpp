#include "pushback/tools/measure/study/chaplygin.h"

namespace pushback::further {

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
