#include "pushback/tools/classroom/mine/slips.h"

#include <cmath>
#include <limits>

namespace pushback {

namespace {

constexpr Real inf = std::numeric_limits<Real>::infinity();

struct Line {  // a row, as the plain loops have it
  std::size_t contact;
  Body *a, *b;
  Vec3 n, ra_n, rb_n;
  Vec3 dva, dwa, dvb, dwb;
  Real effective_mass;
  Real bias = 0;
  Real impulse = 0, last = 0;
};

class LoopWithSlip : public StepSolver {
 public:
  LoopWithSlip(int chapter, Slip slip) : chapter_(chapter), slip_(slip) {}

  void solve(World& world, Real dt, int sweeps) override {
    if (is(Slip::nothing_done)) return;
    if (chapter_ == 0) return once(world);
    if (is(Slip::one_sweep)) sweeps = std::min(sweeps, 1);
    if (is(Slip::guess_before_bias)) {  // all rows, the guess, and only then the bias
      build(world, dt, false);
      warm_start(world, dt);
      for (Line& row : normals_) row.bias = bias_of(world, world.contacts[row.contact], dt);
    } else {
      build(world, dt, true);
      warm_start(world, dt);
    }
    for (int sweep = 0; sweep < sweeps; ++sweep) {
      if (is(Slip::friction_first)) rub(world);
      push(world, dt, sweep);
      if (!is(Slip::friction_first)) rub(world);
    }
    keep(world);
  }

 private:
  bool is(Slip slip) const { return slip_ == slip; }

  Line line_of(World& world, std::size_t contact, const Vec3& n) const {
    const Contact& c = world.contacts[contact];
    const auto [a, b] = world.bodies_of(c);
    const Vec3 ra = is(Slip::arm_from_origin) ? c.point : Vec3(c.point - a.position);
    const Vec3 rb = is(Slip::arm_from_origin) ? c.point : Vec3(c.point - b.position);
    Line row;
    row.contact = contact;
    row.a = &a;
    row.b = &b;
    row.n = n;
    row.ra_n = is(Slip::arm_crossed) ? n.cross(ra) : ra.cross(n);
    row.rb_n = is(Slip::arm_crossed) ? n.cross(rb) : rb.cross(n);
    const auto inertia = [&](const Body& body) -> Mat3 {
      return is(Slip::inertia_of_body_axes) ? Mat3(body.principal_inverse_inertia.asDiagonal()) : body.inverse_inertia;
    };
    row.dva = -a.inverse_mass * n;
    row.dwa = -inertia(a) * row.ra_n;
    row.dvb = b.inverse_mass * n;
    row.dwb = inertia(b) * row.rb_n;
    const Real linear = a.inverse_mass + b.inverse_mass;
    const Real angular = row.rb_n.dot(row.dwb) - row.ra_n.dot(row.dwa);
    row.effective_mass = 1 / (linear + angular);
    if (is(Slip::k_without_arms)) row.effective_mass = 1 / linear;
    if (is(Slip::k_not_inverted)) row.effective_mass = linear + angular;
    if (is(Slip::k_of_upper)) row.effective_mass = 1 / (b.inverse_mass + row.rb_n.dot(row.dwb));
    if (is(Slip::against_itself)) row.effective_mass = -row.effective_mass;
    if (is(Slip::same_direction)) {
      row.dva = -row.dva;
      row.dwa = -row.dwa;
    }
    if (is(Slip::only_upper)) row.dva = row.dwa = Vec3::Zero();
    if (is(Slip::no_spin)) row.dwa = row.dwb = Vec3::Zero();
    return row;
  }

  Real speed(const Line& row) const {
    const Real linear = row.n.dot(row.b->velocity - row.a->velocity);
    if (is(Slip::spin_unread)) return linear;
    // As the plain loops have it: arm times normal, whichever way round the arm itself was crossed.
    return linear + (row.rb_n.dot(row.b->angular_velocity) - row.ra_n.dot(row.a->angular_velocity));
  }

  static void give(Line& row, Real lambda) {
    row.a->velocity += lambda * row.dva;
    row.a->angular_velocity += lambda * row.dwa;
    row.b->velocity += lambda * row.dvb;
    row.b->angular_velocity += lambda * row.dwb;
  }

  static void reach(Line& row, Real total, Real lo, Real hi) {
    if (total < lo || total > hi) total = total < lo ? lo : hi;
    const Real lambda = total - row.impulse;
    row.impulse = total;
    row.last = lambda;
    give(row, lambda);
  }

  void once(World& world) {
    for (std::size_t i = 0; i < world.contacts.size(); ++i) {
      Contact& c = world.contacts[i];
      Line row = line_of(world, i, c.normal);
      const Real v = speed(row), e = is(Slip::no_bounce) ? 0 : c.restitution;
      if (v < 0 || is(Slip::bounces_when_leaving)) {
        const Real lambda = -(1 + e) * row.effective_mass * v;
        give(row, lambda);
        if (!is(Slip::impulse_not_kept)) c.impulse += lambda * row.n;
      }
      if (is(Slip::not_moved_apart)) continue;
      Real share_a = row.a->inverse_mass, share_b = row.b->inverse_mass;
      if (is(Slip::moved_alike)) share_a = share_b = 1;
      if (is(Slip::heavier_further)) std::swap(share_a, share_b);
      const Vec3 way = c.depth / (share_a + share_b) * c.normal;
      row.a->position -= share_a * way;
      row.b->position += share_b * way;
    }
  }

  Real bias_of(const World& world, const Contact& c, Real dt) const {
    if (chapter_ < 3) return 0;
    Real bias = chapter_ < 4 ? bias_of_depth(c, dt) : bias_beyond_slop(c, dt);
    if (is(Slip::sign_of_bias)) bias = -bias;
    if (is(Slip::depth_halved)) bias /= 2;
    if (chapter_ < 5) return bias;
    const auto [a, b] = world.bodies_of(c);
    const Vec3 ra = c.point - a.position, rb = c.point - b.position;
    Vec3 va = a.velocity_before + a.angular_velocity_before.cross(ra);
    Vec3 vb = b.velocity_before + b.angular_velocity_before.cross(rb);
    if (is(Slip::velocity_now)) {
      va = a.velocity + a.angular_velocity.cross(ra);
      vb = b.velocity + b.angular_velocity.cross(rb);
    }
    if (is(Slip::guess_before_bias)) {  // this step's gravity is taken off again, and the guess is in it
      const auto without_gravity = [&](const Body& body) {
        return body.movable() ? Vec3(body.velocity - dt * world.gravity) : body.velocity;
      };
      va = without_gravity(a) + a.angular_velocity.cross(ra);
      vb = without_gravity(b) + b.angular_velocity.cross(rb);
    }
    if (is(Slip::spin_not_bounced)) {
      va = a.velocity_before;
      vb = b.velocity_before;
    }
    const Real approach = (vb - va).dot(c.normal);
    Real bounce = c.restitution * approach;
    if (is(Slip::one_more)) bounce = (1 + c.restitution) * approach;
    const bool fast = is(Slip::no_threshold)       ? true
                      : is(Slip::threshold_turned) ? approach > -threshold
                                                   : approach < -threshold;
    if (!fast) return bias;
    if (is(Slip::bounce_added)) return bias + bounce;
    if (is(Slip::max_for_min)) return std::max(bias, bounce);
    if (is(Slip::bounce_alone)) return bounce;
    return std::min(bias, bounce);
  }

  Real bias_of_depth(const Contact& c, Real dt) const {
    Real separation = std::min(Real(0), -c.depth);
    if (is(Slip::gap_pushed)) separation = -std::abs(c.depth);
    if (is(Slip::gap_let_in)) separation = -c.depth;
    return scaled(separation, dt);
  }
  Real scaled(Real separation, Real dt) const {
    if (is(Slip::no_one_over_h)) return beta * separation;
    if (is(Slip::h_for_one_over_h)) return beta * dt * separation;
    if (is(Slip::no_beta)) return separation / dt;
    return beta / dt * separation;
  }
  Real bias_beyond_slop(const Contact& c, Real dt) const {
    Real separation = std::min(Real(0), -c.depth + slop);
    if (is(Slip::gap_pushed)) separation = std::min(Real(0), -std::abs(c.depth) + slop);
    if (is(Slip::gap_let_in)) separation = c.depth > 0 ? separation : -c.depth;
    if (is(Slip::slop_added)) separation = std::min(Real(0), -c.depth - slop);
    if (is(Slip::shallow_held)) separation = -c.depth + slop;
    if (is(Slip::slop_all_or_nothing)) separation = c.depth > slop ? -c.depth : 0;
    if (is(Slip::slop_in_millimetres)) separation = std::min(Real(0), -c.depth + 1000 * slop);
    if (is(Slip::min_before_slop)) separation = std::min(Real(0), -c.depth) + slop;
    if (is(Slip::slop_outside)) return std::min(Real(0), scaled(-c.depth, dt) + slop);
    return scaled(separation, dt);
  }

  void build(World& world, Real dt, bool with_bias) {
    if (!is(Slip::rows_not_cleared)) {
      normals_.clear();
      tangents_.clear();
    }
    for (std::size_t i = 0; i < world.contacts.size(); ++i) {
      const Contact& c = world.contacts[i];
      normals_.push_back(line_of(world, i, c.normal));
      if (with_bias) normals_.back().bias = bias_of(world, c, dt);
      if (chapter_ < 6 || c.friction == 0) continue;
      const auto [tangent1, tangent2] = tangents_of(c.normal);
      tangents_.push_back(line_of(world, i, tangent1));
      tangents_.push_back(line_of(world, i, is(Slip::one_tangent) ? tangent1 : tangent2));
      if (chapter_ >= 8 && !is(Slip::each_its_own)) step_alike(tangents_.end()[-2], tangents_.back());
    }
  }

  void step_alike(Line& one, Line& two) const {
    const Real k11 = 1 / one.effective_mass, k22 = 1 / two.effective_mass;
    Real k12 = two.n.dot(one.dvb - one.dva) + two.rb_n.dot(one.dwb) - two.ra_n.dot(one.dwa);
    if (is(Slip::no_k12)) k12 = 0;
    const Real half = (k11 + k22) / 2, off = std::hypot((k11 - k22) / 2, k12);
    one.effective_mass = two.effective_mass = 1 / (is(Slip::smaller_k) ? half - off : half + off);
  }

  void warm_start(World& world, Real dt) {
    if (chapter_ < 7) return;
    Contacts& contacts = world.contacts;
    Real scale = world.impulse_scale(dt);
    if (is(Slip::no_scale)) scale = 1;
    if (is(Slip::scale_turned)) scale = world.dt_before / dt;
    const Contacts& before = is(Slip::step_before_last) ? two_before_ : world.contacts_before;
    for (std::size_t i = 0; i < contacts.size(); ++i) {
      contacts[i].impulse.setZero();
      if (is(Slip::by_place)) {
        if (i < before.size()) contacts[i].impulse = scale * before[i].impulse;
        continue;
      }
      for (const Contact& old : before)
        if (old.id == contacts[i].id) contacts[i].impulse = scale * old.impulse;
    }
    two_before_ = world.contacts_before;
    if (is(Slip::stored_not_applied)) {
      for (Line& row : normals_) row.impulse = std::max(Real(0), contacts[row.contact].impulse.dot(row.n));
      for (Line& row : tangents_) row.impulse = contacts[row.contact].impulse.dot(row.n);
      return;
    }
    for (Line& row : normals_)
      guess(row,
            is(Slip::guess_as_length) ? contacts[row.contact].impulse.norm() : contacts[row.contact].impulse.dot(row.n),
            0);
    if (is(Slip::tangents_cold)) return;
    for (Line& row : tangents_) guess(row, contacts[row.contact].impulse.dot(row.n), -inf);
  }
  void guess(Line& row, Real total, Real lo) const {
    reach(row, total, lo, inf);
    if (is(Slip::applied_twice)) give(row, row.impulse);
    if (is(Slip::applied_not_stored)) row.impulse = 0;
  }

  void push(World& world, Real dt, int sweep) {
    std::vector<Real> read;
    if (is(Slip::speeds_read_first))
      for (const Line& row : normals_) read.push_back(speed(row));
    for (std::size_t i = 0; i < normals_.size(); ++i) {
      Line& row = normals_[i];
      if (is(Slip::bounce_reread) && chapter_ >= 5) {
        const Contact& c = world.contacts[row.contact];
        const Real now = separating_speed(world, c);
        row.bias = std::min(bias_beyond_slop(c, dt), now < -threshold ? c.restitution * now : 0);
      }
      const Real v = read.empty() ? speed(row) : read[i];
      Real lambda = -row.effective_mass * (v + (is(Slip::bias_once) && sweep > 0 ? 0 : row.bias));
      if (is(Slip::bias_not_divided)) lambda = -row.effective_mass * v - row.bias;
      push(row, lambda);
    }
  }

  void push(Line& row, Real lambda) const {
    if (chapter_ < 2) {
      if (is(Slip::already_let_go)) return reach(row, row.impulse + lambda, 0, inf);
      return reach(row, row.impulse + lambda, -inf, inf);
    }
    switch (slip_) {
      case Slip::each_clamped:
        return reach(row, row.impulse + std::max(Real(0), lambda), 0, inf);
      case Slip::pulls_only:
        return reach(row, row.impulse + lambda, -inf, 0);
      case Slip::size_of_sum:
        return reach(row, std::abs(row.impulse + lambda), 0, inf);
      case Slip::no_clamp:
      case Slip::clamped_at_the_end:
        return reach(row, row.impulse + lambda, -inf, inf);
      case Slip::sum_clamped_alone:
        give(row, lambda);
        row.impulse = std::max(Real(0), row.impulse + lambda);
        return;
      case Slip::difference_forgotten:
        row.impulse = std::max(Real(0), row.impulse + lambda);
        give(row, row.impulse);
        return;
      default:
        return reach(row, row.impulse + lambda, 0, inf);
    }
  }

  Real bound_of(const World& world, const Line& row, std::size_t place) const {
    const Real mu = world.contacts[row.contact].friction;
    const Line& normal = normals_[is(Slip::bound_by_place) ? place / 2 : row.contact];
    const Real push = is(Slip::bound_of_last) ? std::abs(normal.last) : normal.impulse;
    return (is(Slip::no_mu) ? 1 : is(Slip::mu_squared) ? mu * mu : mu) * push;
  }
  Real slip_of(const Line& row) const {
    if (is(Slip::slip_without_spin)) return row.n.dot(row.b->velocity - row.a->velocity);
    if (is(Slip::friction_speeds_up)) return -speed(row);
    return speed(row);
  }

  void rub(World& world) {
    if (chapter_ >= 8 && !is(Slip::square)) return rub_in_disc(world);
    for (std::size_t t = 0; t < tangents_.size(); ++t) {
      Line& row = tangents_[t];
      const Real bound = bound_of(world, row, t);
      const Real lambda = -row.effective_mass * slip_of(row);
      if (is(Slip::friction_not_summed)) reach(row, row.impulse + std::clamp(lambda, -bound, bound), -inf, inf);
      else reach(row, row.impulse + lambda, is(Slip::one_sided) ? -inf : -bound, bound);
    }
  }
  void rub_in_disc(World& world) {
    for (std::size_t t = 0; t + 1 < tangents_.size(); t += 2) {
      Line &one = tangents_[t], &two = tangents_[t + 1];
      Real bound = bound_of(world, one, t);
      if (is(Slip::half_disc)) bound /= std::sqrt(Real(2));
      Real total1 = one.impulse - one.effective_mass * slip_of(one);
      if (is(Slip::second_late)) reach(one, total1, -inf, inf);
      Real total2 = two.impulse - two.effective_mass * slip_of(two);
      if (is(Slip::each_step_bounded)) {
        Real step1 = total1 - one.impulse, step2 = total2 - two.impulse;
        const Real size = std::hypot(step1, step2);
        if (size > bound) step1 *= bound / size, step2 *= bound / size;
        total1 = one.impulse + step1;
        total2 = two.impulse + step2;
      } else if (is(Slip::one_sided)) {
        total1 = std::min(total1, bound);
        total2 = std::min(total2, bound);
      } else {
        const Real squared = total1 * total1 + total2 * total2;
        if (squared > bound * bound) {
          Real kept = bound / std::sqrt(squared);
          if (is(Slip::factor_squared)) kept *= kept;
          total1 *= kept;
          total2 *= kept;
        }
      }
      reach(one, total1, -inf, inf);
      reach(two, total2, -inf, inf);
    }
  }

  void keep(World& world) {
    for (Contact& c : world.contacts) c.impulse.setZero();
    if (is(Slip::impulse_not_kept)) return;
    for (const Line& row : normals_) {
      Real kept = is(Slip::last_impulse_kept) ? row.last : row.impulse;
      if (is(Slip::clamped_at_the_end)) kept = std::max(Real(0), kept);
      world.contacts[row.contact].impulse += kept * row.n;
    }
    if (is(Slip::friction_not_kept)) return;
    for (const Line& row : tangents_) world.contacts[row.contact].impulse += row.impulse * row.n;
  }

  const Real beta = Real(0.2), slop = Real(0.005), threshold = Real(0.1);
  int chapter_;
  Slip slip_;
  std::vector<Line> normals_, tangents_;
  Contacts two_before_;
};

}  // namespace

WholeSolver loop_with(int chapter, Slip slip) {
  return {[=] { return std::make_unique<LoopWithSlip>(chapter, slip); }};
}

const std::vector<KnownSlip>& known_slips() {
  constexpr int all = 8;
  static const std::vector<KnownSlip> slips{
      {Slip::nothing_done, 0, all, "nothing done",
       "nothing has changed the bodies. Either nothing is written yet, or copies were changed: world.bodies_of(c) "
       "gives references, so write auto [a, b] = ... for it, and never Body a = ..."},
      {Slip::against_itself, 0, all, "sign of λ",
       "it looks as if the impulse had the wrong sign. It is to undo the speed of the points: λ = −J V / K."},
      {Slip::same_direction, 0, all, "both in one direction",
       "it looks as if both bodies got the impulse in the same direction. The normal points from A to B: B gets +λ n, "
       "A gets −λ n, and so do their spins."},
      {Slip::only_upper, 0, all, "A forgotten",
       "it looks as if only B got the impulse. Whatever B gets, A gets with the other sign."},
      {Slip::no_spin, 0, all, "spin forgotten",
       "it looks as if the impulse turned nothing. It acts at the point, not at the centre: w changes by I⁻¹ (r × λ "
       "n)."},
      {Slip::arm_crossed, 0, all, "n × r",
       "it looks as if the arm and the normal were crossed in the wrong order: it is r × n, with r from the centre to "
       "the point."},
      {Slip::arm_from_origin, 0, all, "arm from the origin",
       "it looks as if the arm began at the world's origin. It begins at the body's centre: r = point − position."},
      {Slip::inertia_of_body_axes, 0, all, "inertia in the body's axes",
       "it looks as if the inertia were that of the body's own axes. The velocities are in the world's: take "
       "inverse_inertia, which turns with the body."},
      {Slip::spin_unread, 0, all, "speed without spin",
       "it looks as if the speed at the point were read without the spins. A point moves with v + w × r."},
      {Slip::k_without_arms, 0, all, "K without arms",
       "it looks as if K were 1/m_A + 1/m_B alone. A body that turns gives way more easily: (r × n) · I⁻¹ (r × n) of "
       "each body belongs to K."},
      {Slip::k_not_inverted, 0, all, "K for 1/K",
       "it looks as if the speed were multiplied by K. K is the speed that an impulse of 1 N s makes, so λ is the "
       "speed divided by K."},
      {Slip::k_of_upper, 0, all, "K of B alone",
       "it looks as if K held one body only. Both give way: A and B each bring 1/m and an arm."},
      {Slip::impulse_not_kept, 0, all, "impulse not kept",
       "it looks as if the contact were told nothing. What was done to it belongs into its `impulse`: the sum along "
       "the normal, times n (and along the tangents, once there are any)."},
      {Slip::no_bounce, 0, 0, "e forgotten", "it looks as if e were forgotten: (1 + e) times what just stops them."},
      {Slip::bounces_when_leaving, 0, 0, "leaving ones hit",
       "it looks as if bodies got an impulse that are leaving each other already. They need none."},
      {Slip::not_moved_apart, 0, 0, "not moved apart",
       "it looks as if nothing moved them. Chapter 00 moves bodies that overlap by hand, along the normal."},
      {Slip::moved_alike, 0, 0, "moved alike",
       "it looks as if both were moved by as much. The lighter one is moved further: each by its 1/m."},
      {Slip::heavier_further, 0, 0, "heavier one further",
       "it looks as if the heavier one were moved further. Each is moved in proportion to its 1/m."},

      {Slip::one_sweep, 1, all, "one sweep",
       "it looks as if all rows were solved once only. Each row spoils its neighbours a little, so go over all of them "
       "`sweeps` times."},
      {Slip::speeds_read_first, 1, all, "all speeds read first",
       "it looks as if all speeds of a sweep were read before the first impulse. Each row is to see what the row "
       "before did: read J V where λ is made of it."},
      {Slip::last_impulse_kept, 1, all, "last λ kept",
       "it looks as if the contact kept what the last sweep gave. It got an impulse in every sweep: keep the sum."},
      {Slip::rows_not_cleared, 1, all, "rows of the step before",
       "it looks as if rows of the step before were still there. The solver lives on from step to step: clear its "
       "lists first."},
      {Slip::already_let_go, 1, 1, "clamped already",
       "it looks as if bodies that leave were let go. That is right, and comes in chapter 02; in this one a row is an "
       "equation, so that you see what it does: J V = 0, whichever sign λ has. (Done already? Go on with chapter 02.)"},

      {Slip::each_clamped, 2, all, "each λ clamped",
       "it looks as if each λ were clamped. A later sweep must be able to take back what was too much: add λ to the "
       "sum, clamp the sum, and apply by how much it has changed."},
      {Slip::pulls_only, 2, all, "sign of the clamp",
       "it looks as if contacts pulled and never pushed. The sum of λ is never less than 0: max(0, sum)."},
      {Slip::sum_clamped_alone, 2, all, "clamped λ not applied",
       "it looks as if the sum were clamped, and the bodies got λ all the same. They get what the sum gains: new sum − "
       "old sum."},
      {Slip::clamped_at_the_end, 2, all, "clamped at the end",
       "it looks as if only what is kept were clamped, and bodies are pulled before. Clamp in each row, before the "
       "bodies get anything."},
      {Slip::difference_forgotten, 2, all, "sum applied",
       "it looks as if the whole sum were applied in each sweep. The bodies have the old sum already: give them new "
       "sum − old sum."},
      {Slip::size_of_sum, 2, all, "absolute value",
       "it looks as if a negative sum became positive. A contact that would have to pull does nothing: max(0, sum), "
       "not its absolute value."},

      {Slip::no_clamp, 3, all, "clamp lost",
       "it looks as if nothing were clamped any more, as in chapter 01. The sum of λ along a normal is never less than "
       "0."},

      {Slip::no_one_over_h, 3, all, "1/h forgotten",
       "it looks as if 1/h were forgotten. β d is a distance; to cover it within one step, the speed is β d / h."},
      {Slip::h_for_one_over_h, 3, all, "h for 1/h",
       "it looks as if β d were multiplied by h. A distance divided by a time is a speed: β d / h."},
      {Slip::no_beta, 3, all, "β forgotten",
       "it looks as if β were forgotten. One step is to take away the part β = 0.2 of the overlap, not all of it."},
      {Slip::sign_of_bias, 3, all, "sign of b",
       "it looks as if b had the wrong sign. A row solves J V + b = 0, so b is minus the wanted speed: negative where "
       "bodies overlap."},
      {Slip::bias_not_divided, 3, all, "b beside 1/K",
       "it looks as if b were added to λ. It is a speed, as J V is: λ = −(J V + b) / K."},
      {Slip::bias_once, 3, all, "b in the first sweep",
       "it looks as if b counted in one sweep only; the next one takes the speed away again. b stays in the row in "
       "every sweep."},
      {Slip::gap_pushed, 3, all, "a push on points that are apart",
       "it looks as if points that are still apart were pushed, too. Where depth < 0 there is no overlap to undo: C = "
       "min(0, −depth)."},
      {Slip::gap_let_in, 3, all, "points let in",
       "it looks as if points that are still apart were let in. C = min(0, −depth): here, an approach is stopped as if "
       "they touched."},
      {Slip::depth_halved, 3, all, "half of the depth",
       "it looks as if each body were to take half of the depth. The row moves both against each other: the whole "
       "depth belongs into it, once."},

      {Slip::slop_added, 4, all, "sign of the slop",
       "it looks as if the slop were added to the depth. It is the part that is left: C = min(0, −depth + slop)."},
      {Slip::shallow_held, 4, all, "min forgotten",
       "it looks as if bodies that are less deep than the slop were let in. C is never more than 0: min(0, −depth + "
       "slop)."},
      {Slip::slop_all_or_nothing, 4, all, "all or nothing",
       "it looks as if all of the depth counted as soon as it is more than the slop. Only what is beyond the slop "
       "does, or bodies jump as they pass it."},
      {Slip::slop_in_millimetres, 4, all, "slop in mm",
       "it looks as if the slop were in millimetres, or far too large. Lengths are in metres: 0.005."},
      {Slip::slop_outside, 4, all, "slop beside β/h",
       "it looks as if the slop were taken off the speed. It is a length: take it off the depth, and β/h times the "
       "rest."},
      {Slip::min_before_slop, 4, all, "min before the slop",
       "it looks as if min came before the slop. Take the slop off first: min(0, −depth + slop)."},

      {Slip::velocity_now, 5, all, "velocity_before ignored",
       "it looks as if the bounce were made of the velocities as they are now. This step's gravity is in them already: "
       "take velocity_before and angular_velocity_before."},
      {Slip::no_threshold, 5, all, "threshold forgotten",
       "it looks as if everything bounced, however slow. Less than 0.1 m/s is no impact: nothing would come to rest."},
      {Slip::threshold_turned, 5, all, "sign of the threshold",
       "it looks as if slow ones bounced and fast ones did not. v_n is negative where they meet: bounce where v_n < "
       "−threshold."},
      {Slip::bounce_added, 5, all, "wishes added",
       "it looks as if bounce and push-out were added up. Each is a speed that is enough for its purpose: keep the "
       "lesser b."},
      {Slip::max_for_min, 5, all, "max for min",
       "it looks as if the greater b were kept. b is minus a speed: the lesser b asks for more."},
      {Slip::bounce_alone, 5, all, "b overwritten",
       "it looks as if the bounce took the place of the push-out. Keep the lesser of both b."},
      {Slip::one_more, 5, all, "1 + e",
       "it looks as if 1 + e stood in b. The row stops the approach by itself; b holds what is wanted after: e v_n."},
      {Slip::spin_not_bounced, 5, all, "bounce without spin",
       "it looks as if v_n were read at the centres. Points meet, not centres: v + w × r of each body, both from "
       "before."},
      {Slip::bounce_reread, 5, all, "bounce read in each sweep",
       "it looks as if v_n were read anew in each sweep. After the first one nothing meets any more: make b before the "
       "sweeps."},

      {Slip::friction_first, 6, all, "friction before its normal",
       "it looks as if friction came before its normal. Its bound is μ times the push, and in the first sweep there is "
       "none yet: solve the normals first."},
      {Slip::friction_not_summed, 6, 7, "each friction λ clamped",
       "it looks as if each λ of friction were clamped. What is bounded is the sum, as along the normal."},
      {Slip::one_sided, 6, all, "bound on one side",
       "it looks as if friction were bounded on one side only. It goes from −μ λ_n to μ λ_n."},
      {Slip::bound_of_last, 6, all, "bound of the last λ",
       "it looks as if the bound were made of the last λ of the normal. It is μ times the sum."},
      {Slip::bound_by_place, 6, all, "wrong normal",
       "it looks as if friction were bounded by the push of another contact. Smooth contacts have no tangents, so the "
       "places in the two lists differ: let each row say which contact it belongs to."},
      {Slip::one_tangent, 6, all, "one tangent twice",
       "it looks as if both rows of friction had the same tangent. A surface has two directions: tangents_of(normal) "
       "gives both."},
      {Slip::no_mu, 6, all, "μ forgotten",
       "it looks as if μ were forgotten: the bound is μ times the push, with the contact's own μ."},
      {Slip::mu_squared, 6, all, "μ twice", "it looks as if μ counted twice. c.friction is that of the pair already."},
      {Slip::slip_without_spin, 6, all, "slip without spin",
       "it looks as if the slip were read at the centres. A ball that rolls does not slip: v + w × r of each body, as "
       "along the normal."},
      {Slip::friction_not_kept, 6, all, "friction not kept",
       "it looks as if the contact kept its normal impulse alone. Add λ t of both tangents to c.impulse."},
      {Slip::friction_speeds_up, 6, all, "sign of friction",
       "it looks as if friction sped the slip up. It is a row like the normal: λ = −J V / K."},

      {Slip::no_scale, 7, all, "h not scaled",
       "it looks as if the impulse were taken as it was. Half as long a step has half the impulse: "
       "world.impulse_scale(dt)."},
      {Slip::scale_turned, 7, all, "scale turned round",
       "it looks as if the impulse were scaled by h before / h now. It is h now / h before: world.impulse_scale(dt)."},
      {Slip::by_place, 7, all, "matched by place",
       "it looks as if a contact started from what stood in its place in the list. Places change when a contact comes "
       "or goes: match by id."},
      {Slip::tangents_cold, 7, all, "friction not warmed",
       "it looks as if friction began from nothing. Its rows start from the same impulse: c.impulse · t."},
      {Slip::stored_not_applied, 7, all, "stored, not applied",
       "it looks as if the rows knew the guess and the bodies had not got it. A sum that begins at p means that p has "
       "been applied."},
      {Slip::applied_not_stored, 7, all, "applied, not stored",
       "it looks as if the bodies got the guess and the rows did not know. Begin the sums with it, or it cannot be "
       "taken back."},
      {Slip::applied_twice, 7, all, "applied twice", "it looks as if the bodies got the guess twice."},
      {Slip::step_before_last, 7, all, "the step before last",
       "it looks as if the guess were that of the step before last. world.contacts_before holds the step before this "
       "one; what you keep yourself is to be renewed in each step, also where contacts have gone."},
      {Slip::guess_as_length, 7, all, "length of the impulse",
       "it looks as if the normal's guess were the length of the whole impulse. It is the part along the normal: "
       "impulse · n."},
      {Slip::guess_before_bias, 7, all, "warm start before the bias",
       "it looks as if the bounce were read after the guess was applied. The guess changes the velocities: make b "
       "first, or of velocity_before."},

      {Slip::square, 8, all, "a square",
       "it looks as if each tangent had a bound of its own. Together they fill a square, which is too strong across "
       "its corners: bound the length of both, by a disc."},
      {Slip::second_late, 8, all, "second slip read late",
       "it looks as if the second slip were read after the first row had changed the bodies. Read both, then change."},
      {Slip::no_k12, 8, all, "k₁₂ forgotten",
       "it looks as if k₁₂ were forgotten. An impulse along one tangent also moves the point along the other one."},
      {Slip::smaller_k, 8, all, "the smaller k",
       "it looks as if the smaller eigenvalue were taken. The step is 1/k with the larger one, or it goes too far."},
      {Slip::each_its_own, 8, all, "each its own step",
       "it looks as if each tangent went by its own 1/K. With steps of two sizes friction is not against the slip: "
       "both take 1/k."},
      {Slip::each_step_bounded, 8, all, "each step in the disc",
       "it looks as if each step were kept within the disc. It is the sum that is."},
      {Slip::factor_squared, 8, all, "root forgotten",
       "it looks as if the sums were scaled by bound² / length². It is bound / length."},
      {Slip::half_disc, 8, all, "bound / √2",
       "it looks as if the bound were divided by √2. The disc has the radius μ λ_n itself."},
  };
  return slips;
}

}  // namespace pushback
