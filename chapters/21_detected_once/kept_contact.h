/// A contact whose three rows are made once, and solved in many substeps.
///
///   C = C_0 + J dX,   dX = (dx_A, dtheta_A, dx_B, dtheta_B)        what each body has moved since C_0 was known
///
/// J stays, and with it K and M^-1 J^T, until the bodies have moved past each other: then the rows are made anew where they touch by
/// now. What that neglects is said in the page of this chapter.
#pragma once

#include "pushback/chapters/08_friction_cone/friction_cone.h"
#include "pushback/chapters/12_soft_contacts/carry.h"
#include "pushback/chapters/21_detected_once/bounce.h"
#include "pushback/engine/substeps/substepping_solver.h"

namespace pushback {

/// A body that touches something, while contacts are kept.
struct KeptBody {
  Body* body;
  Vec3 way = Vec3::Zero(), turn = Vec3::Zero();             ///< since detection: sum of h v, m, and of h w, rad
  Vec3 given = Vec3::Zero(), given_turning = Vec3::Zero();  ///< by its contacts' impulses: to v, m/s; to w, rad/s

  void gets(const Vec3& dv, const Vec3& dw) {
    given += dv;
    given_turning += dw;
  }
};

struct KeptContact {
  Row normal, tangent1, tangent2;
  Real found;                  // C_0, m
  Real friction, restitution;  // mu, e
  Real step_size;              // 1 / k of both tangents (chapter 08), kg
  std::size_t a = 0, b = 0;    // its bodies, in the solver's list
  Real softness = 0;           // gamma, 1/kg
  Real mass = 0;               // 1 / (K + gamma), kg
  Real bounce = 0;             // minus its speed once it has bounced in this substep, m/s; 0: it does not bounce

  /// Of the contact with this index.
  KeptContact(World& world, std::size_t index, std::size_t body_a, std::size_t body_b)
      : KeptContact(world, world.contacts[index], tangents_of(world.contacts[index].normal), index) {
    a = body_a;
    b = body_b;
  }

  /// C, m.
  Real separation(const std::vector<KeptBody>& bodies) const {
    const KeptBody &moved_a = bodies[a], &moved_b = bodies[b];
    return found +
           (normal.n.dot(moved_b.way - moved_a.way) + (normal.rb_n.dot(moved_b.turn) - normal.ra_n.dot(moved_a.turn)));
  }
  /// One point for both bodies again (chapter 12), or their impulses would turn the pair. Where they pass each other
  /// slower than this, m/s, the rows stay.
  void carry(std::vector<KeptBody>& bodies, Real carried_from) {
    if ((normal.b->velocity - normal.a->velocity).squaredNorm() < carried_from * carried_from) return;
    const Vec3 apart = bodies[b].way - bodies[a].way;
    const Real C = separation(bodies);
    give(bodies, -1);
    for (Row* row : {&normal, &tangent1, &tangent2}) pushback::carry(*row, apart - carried_);
    step_size = 1 / TangentBlock(tangent1, tangent2).larger_eigenvalue();
    give(bodies, 1);
    carried_ = apart;
    found += C - separation(bodies);  // as near as they were
  }
  /// Before the bodies move: what the normal row asks for in this substep. A contact that is apart may close its gap,
  /// JV + C/h >= 0; one that would arrive in this substep, and bounces, bounces now; one that overlaps is a spring.
  void prepare_substep(const std::vector<KeptBody>& bodies, const PushOut& push_out, Real h) {
    const Real C = separation(bodies), approach = restitution > 0 ? speed_before() : 0;
    const Real wanted = push_out.rate * C;
    bounce = 0;
    if (approach < -push_out.threshold && C + h * approach < 0) {
      const Bounce back(restitution, C, -approach, approach - normal.speed(), h);
      bounce = -back.speed;
      ask(-back.way / h, 0);
    } else if (C > 0) ask(restitution > 0 && C > h * push_out.threshold ? free : C / h, 0);
    else if (wanted < -push_out.fastest) ask(-push_out.fastest, 0);
    else ask(wanted, push_out.gamma_by_K);
  }
  /// After the bodies have moved: no push-out any more (chapter 12). A contact that was apart keeps its bias C/h: with the C of
  /// now it would be stopped before it arrives, and would not bounce.
  void relax() { ask(bounce < 0 ? bounce : std::max(normal.bias, Real(0)), 0); }
  /// Returns by how much it changed the speed along the normal, m/s.
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
  /// N s, on B: over the substeps so far.
  Vec3 sum() const { return sum_.x() * normal.n + sum_.y() * tangent1.n + sum_.z() * tangent2.n; }
  /// N s, on B.
  Vec3 impulse() const {
    return normal.impulse * normal.n + tangent1.impulse * tangent1.n + tangent2.impulse * tangent2.n;
  }
  /// How far it is from being solved, m/s: by how much another sweep would change the speed along one of its rows.
  Real error() const {
    const Real wanted = normal.impulse - mass * (normal.speed() + (normal.bias + softness * normal.impulse));
    const Real pushed = std::abs(std::max(wanted, normal.lo) - normal.impulse) / normal.effective_mass;
    if (friction == 0) return pushed;
    const auto [total1, total2] = in_disc();
    return std::max(pushed, std::hypot(total1 - tangent1.impulse, total2 - tangent2.impulse) / step_size);
  }
  /// The impulses that it starts from (chapter 07). What they give its bodies, those get as each substep begins.
  void guess(const Vec3& impulse_before) {
    const Vec3 within = within_cone(impulse_before, normal.n, friction);
    normal.impulse = within.dot(normal.n);
    if (friction == 0) return;
    tangent1.impulse = within.dot(tangent1.n);
    tangent2.impulse = within.dot(tangent2.n);
  }
  /// Adds to both bodies' `given` what this contact's impulses give them, `times` over.
  void give(std::vector<KeptBody>& bodies, Real times) const {
    for (const Row* row : {&normal, &tangent1, &tangent2}) {
      const Real impulse = times * row->impulse;
      bodies[a].gets(impulse * row->dva, impulse * row->dwa);
      bodies[b].gets(impulse * row->dvb, impulse * row->dwb);
    }
  }
  /// Before the sweeps of a substep: the impulses from which it starts.
  void save_impulses() { start_ = {normal.impulse, tangent1.impulse, tangent2.impulse}; }
  /// The next substep starts from the same impulses.
  void restore(std::vector<KeptBody>& bodies) {
    give(bodies, -1);
    normal.impulse = start_.x(), tangent1.impulse = start_.y(), tangent2.impulse = start_.z();
    give(bodies, 1);
  }

 private:
  /// m/s: with such a bias a row does nothing. A bouncy body that is thrown at another within this substep bounces in the next one;
  /// with the bias C/h it would be stopped instead.
  static constexpr Real free = Real(1e9);

  Vec3 carried_ = Vec3::Zero();  // what B had moved past A, m, when the rows were placed
  Vec3 sum_ = Vec3::Zero();      // impulses along the normal and both tangents, N s, over the substeps so far
  Vec3 start_;                   // impulses along the normal and both tangents, N s

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
  /// J V + b + gamma lambda = 0.
  void ask(Real bias, Real gamma_by_K) {
    normal.bias = bias;
    softness = gamma_by_K / normal.effective_mass;
    mass = normal.effective_mass / (1 + gamma_by_K);
  }
  /// What both tangents' sums are to be, N s.
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
  /// J V as the substep began, m/s: before its gravity.
  Real speed_before() const {
    const Body &first = *normal.a, &second = *normal.b;
    return normal.n.dot(second.velocity_before - first.velocity_before) +
           (normal.rb_n.dot(second.angular_velocity_before) - normal.ra_n.dot(first.angular_velocity_before));
  }
};

}  // namespace pushback
