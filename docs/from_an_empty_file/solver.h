/// The solver of chapter 07 on the bodies of these pages: as mine/solver.h, beside body.h, it passes ./course mine 07.
#pragma once

#include <algorithm>
#include <vector>

#include "body.h"
#include "pushback/common/world/step_solver.h"

namespace mine {

using namespace empty_file;

class MySolver : public pushback::StepSolver {
 public:
  void solve(pushback::World& world, pushback::Real h, int sweeps) override {
    bodies_.clear();
    for (const pushback::Body& body : world.bodies) bodies_.push_back(own(body));
    normals_.clear();
    tangents_.clear();
    auto old = world.contacts_before.begin();
    for (pushback::Contact& c : world.contacts) {
      // The impulse of the same point one step before; both lists ascend by id.
      while (old != world.contacts_before.end() && old->id < c.id) ++old;
      c.impulse.setZero();
      if (old != world.contacts_before.end() && old->id == c.id) c.impulse = world.impulse_scale(h) * old->impulse;
      normals_.push_back(row_of(c, c.normal));
      // b = min(beta / h C, e v_n)
      const auto [a, b] = world.bodies_of(c);
      const Vec3 va = a.velocity_before + a.angular_velocity_before.cross(c.point - a.position);
      const Vec3 vb = b.velocity_before + b.angular_velocity_before.cross(c.point - b.position);
      const double approach = (vb - va).dot(c.normal);
      Row& normal = normals_.back();
      normal.bias = std::min(0., 0.2 / h * (0.005 - c.depth));
      if (approach < -0.1) normal.bias = std::min(normal.bias, c.restitution * approach);
      const auto [t1, t2] = pushback::tangents_of(c.normal);
      for (const Vec3& t : {t1, t2}) tangents_.push_back(row_of(c, t));
    }
    for (Row& row : normals_) reach(row, std::max(0., row.contact->impulse.dot(row.n)));
    for (Row& row : tangents_) reach(row, row.contact->impulse.dot(row.n));
    for (int sweep = 0; sweep < sweeps; ++sweep) {
      for (Row& row : normals_) reach(row, std::max(0., solved(row)));
      for (std::size_t t = 0; t < tangents_.size(); ++t) {
        const double bound = tangents_[t].contact->friction * normals_[t / 2].impulse;
        reach(tangents_[t], std::clamp(solved(tangents_[t]), -bound, bound));
      }
    }
    for (pushback::Contact& c : world.contacts) c.impulse.setZero();
    for (std::vector<Row>* rows : {&normals_, &tangents_})
      for (const Row& row : *rows) row.contact->impulse += row.impulse * row.n;
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
      world.bodies[i].velocity = bodies_[i].velocity;
      world.bodies[i].angular_velocity = bodies_[i].angular_velocity;
    }
  }

 private:
  struct Row {
    pushback::Contact* contact;
    Body *a, *b;
    Vec3 n;                 // unit, world axes
    double effective_mass;  // 1 / K, kg
    double bias = 0;        // m/s
    double impulse = 0;     // sum(lambda), N s
  };

  /// The same body, as page 1 has it.
  static Body own(const pushback::Body& body) {
    Body made;
    made.inverse_mass = body.inverse_mass;
    made.inverse_inertia = body.principal_inverse_inertia;
    made.position = body.position;
    made.orientation = body.orientation;
    made.velocity = body.velocity;
    made.angular_velocity = body.angular_velocity;
    return made;
  }
  Row row_of(pushback::Contact& c, const Vec3& n) {
    Row row{&c, &bodies_[c.id.body_a], &bodies_[c.id.body_b], n, 0};
    double k = 0;
    for (const Body* body : {row.a, row.b}) {
      const Vec3 rn = (c.point - body->position).cross(n);
      k += body->inverse_mass + rn.dot(world_inverse_inertia(*body) * rn);
    }
    row.effective_mass = 1 / k;
    return row;
  }
  /// sum(lambda) with which this row alone would be solved.
  static double solved(const Row& row) {
    const auto velocity = [&](const Body& body) -> Vec3 {
      return body.velocity + body.angular_velocity.cross(row.contact->point - body.position);
    };
    return row.impulse - row.effective_mass * (row.n.dot(velocity(*row.b) - velocity(*row.a)) + row.bias);
  }
  /// Page 1's push is all that changes a velocity.
  static void reach(Row& row, double total) {
    const Vec3 impulse = (total - row.impulse) * row.n;
    push(*row.a, -impulse, row.contact->point);
    push(*row.b, impulse, row.contact->point);
    row.impulse = total;
  }

  std::vector<Body> bodies_;
  std::vector<Row> normals_, tangents_;
};

}  // namespace mine
