/// A contact whose three rows are built once and solved in many substeps.
///
///   C = C_0 + J dX,   dX = (dx_A, dtheta_A, dx_B, dtheta_B)        displacement of each body since C_0 was measured
///
/// J stays, and with it K and M^-1 J^T, until the bodies have moved past each other. Then the rows are rebuilt for the current point
/// of contact. The page of this chapter describes the resulting error.
#pragma once

#include "pushback/chapters/08_friction_cone/friction_cone.h"
#include "pushback/chapters/12_soft_contacts/carry.h"
#include "pushback/chapters/21_detected_once/bounce.h"
#include "pushback/engine/substeps/substepping.h"

namespace pushback {

/// A body with contacts, while contacts are kept.
struct KeptBody {
  Body* body;
  Vec3 displacement = Vec3::Zero(), rotation = Vec3::Zero();  ///< since detection, the sum of h v, m, and of h w, rad
  Vec3 impulse_velocity = Vec3::Zero(),
       impulse_angular_velocity = Vec3::Zero();  ///< changes of v (m/s) and w (rad/s) by the contacts

  void add_velocity(const Vec3& dv, const Vec3& dw) {
    impulse_velocity += dv;
    impulse_angular_velocity += dw;
  }
};

struct KeptContact {
  Row normal, tangent1, tangent2;
  Real found;                  // C_0, m
  Real friction, restitution;  // mu, e
  Real step_size;              // 1 / k of both tangents (chapter 08), kg
  std::size_t a = 0, b = 0;    // indices of its bodies in the solver's list
  Real softness = 0;           // gamma, 1/kg
  Real mass = 0;               // 1 / (K + gamma), kg
  Real bounce = 0;             // minus the speed after a bounce in this substep, m/s; 0: no bounce

  /// The contact with this index in the world. `body_a`, `body_b`: indices in the solver's list.
  KeptContact(World& world, std::size_t index, std::size_t body_a, std::size_t body_b)
      : KeptContact(world, world.contacts[index], tangents_of(world.contacts[index].normal), index) {
    a = body_a;
    b = body_b;
  }

  /// C, m.
  Real separation(const std::vector<KeptBody>& bodies) const {
    const KeptBody &moved_a = bodies[a], &moved_b = bodies[b];
    return found + (normal.n.dot(moved_b.displacement - moved_a.displacement) +
                    (normal.rb_n.dot(moved_b.rotation) - normal.ra_n.dot(moved_a.rotation)));
  }
  /// Gives both bodies one common point again (chapter 12), because otherwise their impulses would rotate the pair. If their
  /// relative velocity is below `carried_from`, m/s, the rows stay.
  void carry(std::vector<KeptBody>& bodies, Real carried_from) {
    if ((normal.b->velocity - normal.a->velocity).squaredNorm() < carried_from * carried_from) return;
    const Vec3 apart = bodies[b].displacement - bodies[a].displacement;
    const Real C = separation(bodies);
    apply_impulses(bodies, -1);
    for (Row* row : {&normal, &tangent1, &tangent2}) pushback::carry(*row, apart - carried_);
    step_size = 1 / TangentBlock(tangent1, tangent2).larger_eigenvalue();
    apply_impulses(bodies, 1);
    carried_ = apart;
    found += C - separation(bodies);  // the separation stays
  }
  /// Sets the target velocity of the normal row for this substep, before the bodies move. A contact that is apart may close its
  /// gap, JV + C/h >= 0. A bouncing contact that would arrive in this substep bounces now. A contact that overlaps is a spring.
  void prepare_substep(const std::vector<KeptBody>& bodies, const PushOut& push_out, Real h) {
    const Real C = separation(bodies), approach = restitution > 0 ? speed_before() : 0;
    const Real wanted = push_out.rate * C;
    bounce = 0;
    if (approach < -push_out.threshold && C + h * approach < 0) {
      const Bounce back(restitution, C, -approach, approach - normal.speed(), h);
      bounce = -back.speed;
      set_equation(-back.way / h, 0);
    } else if (C > 0) set_equation(restitution > 0 && C > h * push_out.threshold ? free : C / h, 0);
    else if (wanted < -push_out.fastest) set_equation(-push_out.fastest, 0);
    else set_equation(wanted, push_out.gamma_by_K);
  }
  /// After the bodies have moved: removes the push-out (chapter 12). A contact that was apart keeps its bias C/h, because the
  /// current C would stop it before it arrives, and it would not bounce.
  void relax() { set_equation(bounce < 0 ? bounce : std::max(normal.bias, Real(0)), 0); }
  /// Returns the change of the speed along the normal, m/s.
  Real solve_normal() {
    const Real before = normal.impulse;
    normal.reach(before - mass * (normal.speed() + (normal.bias + softness * before)));
    return std::abs(normal.impulse - before) / normal.effective_mass;
  }
  /// As FrictionCone, chapter 08.
  void solve_friction() {
    const auto [total1, total2] = in_disc();  // both read before either acts
    tangent1.reach(total1);
    tangent2.reach(total2);
  }
  /// After the last sweep of a substep.
  void add_up() { sum_ += Vec3(normal.impulse, tangent1.impulse, tangent2.impulse); }
  /// The impulse on B over the substeps so far, N s.
  Vec3 sum() const { return sum_.x() * normal.n + sum_.y() * tangent1.n + sum_.z() * tangent2.n; }
  /// The impulse on B in this substep, N s.
  Vec3 impulse() const {
    return normal.impulse * normal.n + tangent1.impulse * tangent1.n + tangent2.impulse * tangent2.n;
  }
  /// The residual, m/s, which is the change that another sweep would make to the speed along one of its rows.
  Real error() const {
    const Real wanted = normal.impulse - mass * (normal.speed() + (normal.bias + softness * normal.impulse));
    const Real pushed = std::abs(std::max(wanted, normal.lo) - normal.impulse) / normal.effective_mass;
    if (friction == 0) return pushed;
    const auto [total1, total2] = in_disc();
    return std::max(pushed, std::hypot(total1 - tangent1.impulse, total2 - tangent2.impulse) / step_size);
  }
  /// Sets the initial impulses (chapter 07). The solver applies them to the bodies at the start of each substep.
  void guess(const Vec3& impulse_before) {
    const Vec3 within = clamped_to_cone(impulse_before, normal.n, friction);
    normal.impulse = within.dot(normal.n);
    if (friction == 0) return;
    tangent1.impulse = within.dot(tangent1.n);
    tangent2.impulse = within.dot(tangent2.n);
  }
  /// Adds the velocity changes by this contact's impulses, multiplied by `times`, to `impulse_velocity` of both bodies.
  void apply_impulses(std::vector<KeptBody>& bodies, Real times) const {
    for (const Row* row : {&normal, &tangent1, &tangent2}) {
      const Real impulse = times * row->impulse;
      bodies[a].add_velocity(impulse * row->dva, impulse * row->dwa);
      bodies[b].add_velocity(impulse * row->dvb, impulse * row->dwb);
    }
  }
  /// Saves the initial impulses of a substep, before its sweeps.
  void save_impulses() { start_ = {normal.impulse, tangent1.impulse, tangent2.impulse}; }
  /// Restores the saved impulses, from which the next substep starts.
  void restore(std::vector<KeptBody>& bodies) {
    apply_impulses(bodies, -1);
    normal.impulse = start_.x(), tangent1.impulse = start_.y(), tangent2.impulse = start_.z();
    apply_impulses(bodies, 1);
  }

 private:
  /// With this bias a row has no effect, m/s. A body with restitution that other contacts accelerate towards another body within this
  /// substep bounces in the next one. The bias C/h would stop it instead.
  static constexpr Real free = Real(1e9);

  Vec3 carried_ = Vec3::Zero();  // displacement of B relative to A, m, when the rows were placed
  Vec3 sum_ = Vec3::Zero();      // impulses along the normal and both tangents, N s, over the substeps so far
  Vec3 start_;                   // the same at the start of the substep, N s

  KeptContact(World& world, const Contact& at, const Tangents& tangents, std::size_t index)
      : normal(world, at, at.normal, index),
        tangent1(world, at, tangents.tangent1, index),
        tangent2(world, at, tangents.tangent2, index),
        found(-at.depth),
        friction(at.friction),
        restitution(at.restitution),
        step_size(1 / TangentBlock(tangent1, tangent2).larger_eigenvalue()) {
    normal.lo = 0;
  }
  /// Sets the equation of the normal row: J V + b + gamma lambda = 0.
  void set_equation(Real bias, Real gamma_by_K) {
    normal.bias = bias;
    softness = gamma_by_K / normal.effective_mass;
    mass = normal.effective_mass / (1 + gamma_by_K);
  }
  /// The new accumulated impulses of both tangents, N s.
  std::pair<Real, Real> in_disc() const {
    Real total1 = tangent1.impulse - step_size * tangent1.speed(),
         total2 = tangent2.impulse - step_size * tangent2.speed();
    const Real radius = friction * normal.impulse, squared = total1 * total1 + total2 * total2;
    if (squared > radius * radius) [[unlikely]] {
      const Real kept = radius / std::sqrt(squared);
      total1 *= kept;
      total2 *= kept;
    }
    return {total1, total2};
  }
  /// J V at the start of the substep, before its gravity, m/s.
  Real speed_before() const {
    const Body &first = *normal.a, &second = *normal.b;
    return normal.n.dot(second.velocity_before - first.velocity_before) +
           (normal.rb_n.dot(second.angular_velocity_before) - normal.ra_n.dot(first.angular_velocity_before));
  }
};

}  // namespace pushback
