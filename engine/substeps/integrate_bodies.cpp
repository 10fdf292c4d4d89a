#include "pushback/engine/substeps/integrate_bodies.h"

#include "pushback/engine/substeps/lane_access.h"

namespace pushback {

namespace {

/// Collects bodies that rotate. Once there are eight of them, they are turned.
class TurningBodies {
 public:
  explicit TurningBodies(void (*pass)(EightRotations<Real>&, Real h)) : pass_(pass) {}
  void add(Body& body, Real h) {
    const Quat& q = body.orientation;
    numbers_.x.values[count_] = q.x(), numbers_.y.values[count_] = q.y(), numbers_.z.values[count_] = q.z();
    numbers_.s.values[count_] = q.w();
    write_lane(body.angular_velocity, numbers_.w, count_);
    write_lane(body.principal_inverse_inertia, numbers_.inverse_inertia, count_);
    bodies_[count_] = &body;
    if (++count_ == lanes_per_bundle) turn(h);
  }
  void turn(Real h) {
    pass_(numbers_, h);
    for (std::size_t i = 0; i < count_; ++i) {
      Body& body = *bodies_[i];
      if (numbers_.solved.values[i] == 0) {
        spin_freely(body, h);
        continue;
      }
      body.orientation = Quat(numbers_.s.values[i], numbers_.x.values[i], numbers_.y.values[i], numbers_.z.values[i]);
      body.angular_velocity = read_lane(numbers_.w, i);
    }
    count_ = 0;
  }

 private:
  void (*pass_)(EightRotations<Real>&, Real);
  EightRotations<Real> numbers_{};
  Body* bodies_[lanes_per_bundle];
  std::size_t count_ = 0;
};

}  // namespace

void integrate_bodies(std::span<Body> bodies, Real h, void (*turn)(EightRotations<Real>&, Real h)) {
  TurningBodies turning(turn);
  for (Body& body : bodies) {
    if (body.conveys) continue;
    body.position += h * body.velocity;
    if (body.angular_velocity == Vec3::Zero()) continue;
    if (body.movable()) turning.add(body, h);
    else spin_freely(body, h);
  }
  turning.turn(h);
}

}  // namespace pushback
