/// Every chapter's numbers, worked out on paper beside it.
#include "pushback/chapters/00_naive_impulses/naive.h"
#include "pushback/chapters/05_restitution/mistakes.h"
#include "pushback/chapters/07_warm_start/full_solver.h"
#include "pushback/common/world/measure.h"
#include "pushback/common/world/situations.h"
#include "tests/support/catch.h"
#include "tests/support/touching.h"

using namespace pushback;

namespace {

constexpr Real eps = std::numeric_limits<Real>::epsilon();
constexpr Real g = Real(9.81);
constexpr Real h = Real(1) / 60;

/// One contact alone needs one sweep. A face on the ground has four, which need a few more to agree.
constexpr int one_sweep = 1, enough_sweeps = 200;
/// What may be off, relatively or in m and m/s: the rounding of some hundred steps with as many sweeps. In double it
/// stays below 1e-12; the formulas would have to be wrong in the tenth digit to go unnoticed.
constexpr Real tiny = std::numeric_limits<Real>::digits > 24 ? Real(1e-9) : Real(2e-4);

/// A ball that is `depth` deep in the ground. Its one contact is a row on its own: no sweeps to wait for.
Body& ball_on_ground(World& world, Real depth, Real radius = Real(0.3)) {
  world.add(ground());
  world.add(sphere(radius, 10).at({0, radius - depth, 0}));
  return world.bodies[1];
}
/// A box likewise: four contacts with the same depth.
Body& box_on_ground(World& world, Real depth) {
  world.add(ground());
  world.add(box(Vec3::Constant(Real(0.5)), 100).at({0, Real(0.5) - depth, 0}));
  return world.bodies[1];
}
Real ball_depth(const World& world, Real radius = Real(0.3)) {
  return radius - world.bodies[1].position.y();
}

template <class ContactSolver>
Real largest_error(const ContactSolver& solver) {
  Real largest = 0;
  for (const Row& row : solver.rows()) largest = std::max(largest, row.error());
  return largest;
}

}  // namespace

// ---- 00 -----------------------------------------------------------------------------------------------------------

namespace {

/// Two spinning bodies, each within reach of one point, that approach there.
struct Collision : RandomPair {
  Collision(Random& random, Real e) : RandomPair(random) {
    if (speed() > 0) contact.normal = -contact.normal;
    contact.restitution = e;
  }
  Real speed() const { return separating_speed(world, contact); }
  Real K() { return 1 / row(contact.normal).effective_mass; }
  /// The parts of the separating speed that come from the velocities and from the spins.
  Real linear_part() const { return (world.bodies[1].velocity - world.bodies[0].velocity).dot(contact.normal); }
  Real spin_part() const { return speed() - linear_part(); }
};

}  // namespace

TEST_CASE("00: the pairwise impulse with e = 1 keeps energy and momenta, spinning bodies too") {
  Random random(1);
  for (int i = 0; i < 500; ++i) {
    Collision hit(random, 1);
    const Real energy = kinetic_energy(hit.world);
    const Vec3 p = momentum(hit.world), l = angular_momentum(hit.world);
    const Real approach = hit.speed();
    const Real f = pair_impulse(hit.world, hit.contact);
    apply_impulse(hit.world, hit.contact, f);
    // The energies that change hands are f v: as large as the energies themselves.
    REQUIRE(std::abs(kinetic_energy(hit.world) - energy) <= 1000 * eps * (energy + std::abs(f * approach)));
    const Real size = 40 * f + 100 * 1100;  // N s: what was exchanged, and m v of the heaviest
    REQUIRE((momentum(hit.world) - p).norm() <= 16 * eps * size);
    REQUIRE((angular_momentum(hit.world) - l).norm() <= 64 * eps * size);
    REQUIRE(hit.speed() == Approx(-approach).epsilon(tiny));
  }
}

TEST_CASE("00: it parts the bodies e times as fast as they met, and loses (1 - e^2) s^2 / 2K") {
  Random random(2);
  for (int i = 0; i < 500; ++i) {
    const Real e = random.between(0, 1);
    Collision hit(random, e);
    const Real energy = kinetic_energy(hit.world), s = hit.speed();
    apply_impulse(hit.world, hit.contact, pair_impulse(hit.world, hit.contact));
    REQUIRE(std::abs(hit.speed() + e * s) <= tiny * std::abs(s) + 1e4 * eps);
    REQUIRE(std::abs(energy - kinetic_energy(hit.world) - (1 - e * e) * s * s / (2 * hit.K())) <= 1e3 * eps * energy);
    REQUIRE(pair_impulse(hit.world, hit.contact) == 0);  // they part: no more impulse
  }
}

TEST_CASE("00: the lecture's formula, with (1 + e) on the velocities alone, keeps no energy") {
  // As printed the spins have the opposite sign as well; `sign` = 1 reads that as a slip of the pen.
  for (const int sign : {-1, 1}) {
    Random random(3);
    int wrong = 0;
    for (int i = 0; i < 500; ++i) {
      Collision hit(random, 1);
      const Real energy = kinetic_energy(hit.world), s = hit.speed();
      const Real f = -(2 * hit.linear_part() + static_cast<Real>(sign) * hit.spin_part()) / hit.K();
      const Real change = f * s + f * f * hit.K() / 2;  // of the energy, by any impulse f: 0 for f = -2 s / K
      apply_impulse(hit.world, hit.contact, f);
      REQUIRE(std::abs(kinetic_energy(hit.world) - energy - change) <= 1e4 * eps * (energy + std::abs(f * s)));
      wrong += std::abs(change) > Real(0.01) * std::abs(f * s) ? 1 : 0;
    }
    CHECK(wrong > 450);
  }
}

TEST_CASE("00: pushing apart ends the overlap and leaves the common centre of mass where it was") {
  Random random(4);
  for (int i = 0; i < 200; ++i) {
    Collision hit(random, 0);
    const Body &a = hit.world.bodies[0], &b = hit.world.bodies[1];
    const auto moment = [&]() -> Vec3 { return a.position / a.inverse_mass + b.position / b.inverse_mass; };
    const Vec3 before = moment();
    const Real gap = (b.position - a.position).dot(hit.contact.normal);
    push_apart(hit.world, hit.contact);
    REQUIRE((moment() - before).norm() <= 16 * eps * 4000);
    REQUIRE(std::abs((b.position - a.position).dot(hit.contact.normal) - gap - hit.contact.depth) <= 32 * eps);
  }
}

TEST_CASE("00: in a stack, boxes that are pushed apart by hand change places") {
  World world;
  stack(world, 5);
  NaiveAveraged solver;
  for (int step = 0; step < 60; ++step) world.step(solver, h, 10);
  CHECK(world.bodies[1].position.y() >
        world.bodies[5].position.y() + 4);  // the lowest on top, the topmost at the bottom
  for (const Body& body : world.bodies) CHECK(std::hypot(body.position.x(), body.position.z()) < Real(0.5));
}

// ---- 01 -----------------------------------------------------------------------------------------------------------

TEST_CASE("01: after the solve J V = 0, and the overlap stays as it was") {
  World world;
  Body& ball = ball_on_ground(world, Real(0.02)).moving({0, -3, 0});
  Solver<> solver;
  for (int step = 0; step < 600; ++step) {
    world.step(solver, h, one_sweep);
    REQUIRE(largest_error(solver) <= 16 * eps * 3);
    REQUIRE(std::abs(ball.velocity.y()) <= 16 * eps * 3);
  }
  CHECK(std::abs(ball_depth(world) - Real(0.02)) <= 600 * eps);
}

TEST_CASE(
    "01: what one sweep leaves depends on where the points are: at the edge of the slab, or at the box's corners") {
  const auto left_by_one_sweep = [](Real half_depth) {
    World world;
    world.add(box({4, Real(0.25), half_depth}, 1).fixed().at({0, Real(-0.25), 0}));
    world.add(box(Vec3::Constant(Real(0.5)), 100).at({0, Real(1.54), 0}));
    Solver<> solver;
    Real most = 0;
    for (int step = 0; step < 60; ++step) {
      world.step(solver, h, one_sweep);
      most = std::max(most, largest_error(solver));
    }
    return most;
  };
  CHECK(left_by_one_sweep(Real(0.47)) == Approx(1.03).margin(0.005));  // m/s
  CHECK(left_by_one_sweep(Real(0.6)) == Approx(1.44).margin(0.005));
}

TEST_CASE("01: it also pulls: a ball that leaves is held back") {
  World world;
  Body& ball = ball_on_ground(world, Real(0.01)).moving({0, 5, 0});
  Solver<> solver;
  world.step(solver, h, one_sweep);
  CHECK(std::abs(ball.velocity.y()) <= 16 * eps * 5);
  CHECK(world.contacts[0].impulse.y() == Approx(-(5 - g * h) * 10).epsilon(64 * eps));
}

// ---- 02 -----------------------------------------------------------------------------------------------------------

namespace {

/// The column of chapters/02_clamping/scenes.h: fastest way up after its flat landing.
template <class ContactSolver>
Real rebound_of_column(int sweeps) {
  World world;
  world.add(ground());
  world.add(box({Real(0.25), Real(0.8), Real(0.25)}, 100).at({0, Real(1.3), 0}));
  ContactSolver solver;
  Real fastest = 0;
  for (int step = 0; step < 72; ++step) {
    world.step(solver, h, sweeps);
    fastest = std::max(fastest, world.bodies[1].velocity.y());
  }
  return fastest;
}

}  // namespace

TEST_CASE("02: clamping each correction leaves a rebound, clamping their sum does not") {
  for (const int sweeps : {10, 50, 200}) {
    const Real each = rebound_of_column<Solver<ClampingEachCorrection>>(sweeps);
    const Real sum = rebound_of_column<Solver<Clamping>>(sweeps);
    INFO(sweeps << " sweeps: each correction " << each << " m/s, their sum " << sum << " m/s");
    CHECK(each > Real(0.1));  // however many sweeps: what was pushed too far is never taken back
    CHECK(sum < each / 5);
    if (sweeps == 200) CHECK(sum < tiny);
  }
}

TEST_CASE("02: a contact lets go of what leaves") {
  World world;
  Body& ball = ball_on_ground(world, Real(0.01)).moving({0, 5, 0});
  Solver<Clamping> solver;
  world.step(solver, h, one_sweep);
  CHECK(ball.velocity.y() == 5 - h * g);
  CHECK(world.contacts[0].impulse.isZero(0));
}

// ---- 03 -----------------------------------------------------------------------------------------------------------

TEST_CASE("03: a bilateral row: d_k = d_0 (1 - beta)^k") {
  const Real d0 = Real(0.06);
  for (const Real beta : {Real(0.05), Real(0.1), Real(0.2), Real(0.5), Real(0.9)}) {
    for (const bool with_gravity : {false, true}) {
      World ball, four;
      ball_on_ground(ball, d0);
      box_on_ground(four, d0);
      if (!with_gravity) ball.gravity = four.gravity = Vec3::Zero();
      Solver<Baumgarte> one, several;
      one.beta = several.beta = beta;
      Real d = d0;
      for (int k = 1; k <= 20; ++k) {
        ball.step(one, h, one_sweep);
        four.step(several, h, enough_sweeps);
        d *= 1 - beta;
        // The depth is a difference of heights of about 1 m: it has their rounding.
        REQUIRE(std::abs(ball_depth(ball) - d) <= tiny * d + 64 * eps);
        REQUIRE(std::abs(Real(0.5) - four.bodies[1].position.y() - d) <= tiny * d + 256 * eps);
      }
    }
  }
}

TEST_CASE("03: for small steps that is d_0 exp(-beta t / h), off by beta / 2 of t / (h / beta)") {
  for (const Real beta : {Real(0.02), Real(0.01), Real(0.005)}) {
    World world;
    world.gravity.setZero();
    ball_on_ground(world, Real(0.06));
    Solver<Baumgarte> solver;
    solver.beta = beta;
    const int steps = static_cast<int>(std::lround(1 / beta));
    for (int k = 0; k < steps; ++k) world.step(solver, h, one_sweep);
    // (1 - beta)^(1 / beta) = exp(-1) (1 - beta/2 - 5 beta^2 / 24 ...): of first order.
    const Real off = 1 - ball_depth(world) / (Real(0.06) * std::exp(Real(-1)));
    CHECK(std::abs(off - beta / 2) < beta * beta / 2);
  }
}

TEST_CASE("03: a contact without gravity leaves at beta d_0 / h, and d_k = d_0 (1 - k beta)") {
  const Real d0 = Real(0.06);
  for (const Real beta : {Real(0.1), Real(0.2), Real(0.5), Real(1)}) {
    World world;
    Body& ball = ball_on_ground(world, d0);
    world.gravity.setZero();
    Solver<Clamping, Baumgarte> solver;
    solver.beta = beta;
    for (int k = 1; k <= 20; ++k) {
      world.step(solver, h, one_sweep);
      REQUIRE(ball.velocity.y() == Approx(beta * d0 / h).epsilon(64 * eps));
      REQUIRE(std::abs(ball_depth(world) - d0 * (1 - static_cast<Real>(k) * beta)) <= 64 * eps);
    }
    const Real fed_in = 10 * std::pow(beta * d0 / h, Real(2)) / 2;  // J: the speed is the energy
    CHECK(kinetic_energy(world) == Approx(fed_in).epsilon(128 * eps));
  }
}

TEST_CASE("03: under gravity a contact follows d_0 (1 - beta)^k as long as d <= g h^2 / beta^2, and no longer") {
  for (const Real beta : {Real(0.2), Real(0.5), Real(1)}) {
    const Real limit = g * h * h / (beta * beta);  // 68 mm and 2.7 mm
    if (beta == Real(0.2)) CHECK(limit == Approx(0.068).epsilon(0.01));
    if (beta == Real(1)) CHECK(limit == Approx(0.0027).epsilon(0.02));
    for (const Real part : {Real(0.5), Real(0.99), Real(1.01), Real(2)}) {
      const Real d0 = part * limit;
      World world;
      ball_on_ground(world, d0);
      Solver<Clamping, Baumgarte> solver;
      solver.beta = beta;
      world.step(solver, h, one_sweep);
      REQUIRE(std::abs(ball_depth(world) - d0 * (1 - beta)) <= tiny * d0);
      // In the second step gravity takes g h off the speed; if more than that is too much, the contact lets go.
      world.step(solver, h, one_sweep);
      const Real exponential = d0 * (1 - beta) * (1 - beta);
      const Real overshoot = std::max(Real(0), beta * beta * d0 - g * h * h);
      INFO("beta " << beta << ", " << part << " of the limit");
      CHECK(std::abs(ball_depth(world) - (exponential - overshoot)) <= tiny * d0 + 64 * eps);
      if (part > 1) {
        CHECK(world.contacts.at(0).impulse.isZero(0));
        continue;
      }
      for (int k = 3; k <= 20; ++k) {
        world.step(solver, h, one_sweep);
        REQUIRE(std::abs(ball_depth(world) - d0 * std::pow(1 - beta, static_cast<Real>(k))) <= tiny * d0 + 64 * eps);
      }
    }
  }
}

TEST_CASE("03: beta / h makes the correction depend on the step: four quarter steps are not one step") {
  const Real d0 = Real(0.06), beta = Real(0.2);
  World one, four;
  for (World* world : {&one, &four}) {
    world->gravity.setZero();
    ball_on_ground(*world, d0);
  }
  Solver<Baumgarte> solver, quarters;
  one.step(solver, h, one_sweep);
  for (int i = 0; i < 4; ++i) four.step(quarters, h / 4, one_sweep);
  CHECK(ball_depth(one) == Approx(d0 * (1 - beta)).epsilon(tiny));
  CHECK(ball_depth(four) == Approx(d0 * std::pow(1 - beta, Real(4))).epsilon(tiny));
}

// ---- 04 -----------------------------------------------------------------------------------------------------------

TEST_CASE("04: deeper than the slop comes up to the slop, at the same rate") {
  for (const Real slop : {Real(0.001), Real(0.005), Real(0.02)}) {
    for (const bool contact : {false, true}) {
      const Real beta = Real(0.2), d0 = slop + Real(0.04);  // within g h^2 / beta^2: a contact follows too
      World world;
      ball_on_ground(world, d0);
      Solver<Baumgarte, Slop> equality;
      Solver<Clamping, Baumgarte, Slop> pushing;
      equality.slop = pushing.slop = slop;
      Real over = d0 - slop;
      for (int k = 1; k <= 200; ++k) {
        if (contact) world.step(pushing, h, one_sweep);
        else world.step(equality, h, one_sweep);
        over *= 1 - beta;
        REQUIRE(std::abs(ball_depth(world) - slop - over) <= tiny * over + 200 * eps);
      }
      CHECK(std::abs(ball_depth(world) - slop) <= 200 * eps);
    }
  }
}

TEST_CASE("04: shallower than the slop is left where it is, and without slop it is not") {
  for (const Real part : {Real(0), Real(0.2), Real(0.9), Real(1)}) {
    World world;
    Solver<Clamping, Baumgarte, Slop> solver;
    ball_on_ground(world, part * solver.slop);
    for (int k = 0; k < 600; ++k) {
      world.step(solver, h, one_sweep);
      REQUIRE(world.contacts.size() == 1);  // not lost for a single step
    }
    CHECK(std::abs(ball_depth(world) - part * solver.slop) <= 600 * eps);
  }
  World world;
  Solver<Clamping, Baumgarte> without;
  ball_on_ground(world, Real(0.0045));
  for (int k = 0; k < 600; ++k) world.step(without, h, one_sweep);
  CHECK(ball_depth(world) < Real(1e-5));
}

// ---- 05 -----------------------------------------------------------------------------------------------------------

namespace {

using Bouncing = Solver<Clamping, Baumgarte, Restitution>;

/// Heights of the first apexes of a ball with radius 0.3 m dropped by `drop`, m above where it rests.
template <class ContactSolver>
std::vector<Real> apexes(ContactSolver solver, Real e, Real drop, Real dt, std::size_t count) {
  World world;
  Body& ball = ball_on_ground(world, -drop).bouncy(e);
  std::vector<Real> highest;
  bool rising = false;
  for (int step = 0; step < 100000 && highest.size() < count; ++step) {
    world.step(solver, dt, one_sweep);
    const bool rises = ball.velocity.y() > 0;
    if (rising && !rises) highest.push_back(0);
    rising = rises;
    // The height before this step is the highest one, if the ball just began to fall.
    if (!highest.empty() && highest.back() == 0) highest.back() = -ball_depth(world) - dt * ball.velocity.y();
  }
  highest.resize(count, 0);  // a ball that does not bounce
  return highest;
}

/// Root mean square over many drops of how far the k-th apexes are from e^2k h0: where within a step the ball meets the
/// ground is a matter of luck.
Real apex_error(Real e, std::size_t bounces, Real dt) {
  Real sum = 0;
  constexpr int drops = 40;
  for (int i = 0; i < drops; ++i) {
    const Real drop = 2 + static_cast<Real>(i) * Real(0.0037);
    const Real should = std::pow(e, static_cast<Real>(2 * bounces)) * drop;
    const Real apex = apexes(Bouncing{}, e, drop, dt, bounces).back();
    sum += (apex - should) * (apex - should);
  }
  return std::sqrt(sum / drops);
}

}  // namespace

TEST_CASE("05: the k-th apex is e^2k h0, with an error that shrinks as the step does") {
  for (const Real e : {Real(0.5), Real(0.8)}) {
    for (const std::size_t bounces : {1, 2, 3}) {
      const Real coarse = apex_error(e, bounces, h / 4), fine = apex_error(e, bounces, h / 16),
                 finest = apex_error(e, bounces, h / 64);
      INFO("e " << e << ", bounce " << bounces << ": " << coarse << " m, " << fine << " m, " << finest << " m");
      // First order: a quarter of the step, a quarter of the error.
      CHECK(coarse / fine > 3);
      CHECK(coarse / fine < 5);
      CHECK(fine / finest > 3);
      CHECK(fine / finest < 5);
    }
  }
}

TEST_CASE(
    "05: a bounce departs with e times the speed of approach, with the larger and in a pass of its own, not with the "
    "sum") {
  for (const Real e : {Real(0.5), Real(0.8), Real(1)}) {
    World right, apart, wrong;
    Body& ball = ball_on_ground(right, Real(-2)).bouncy(e);
    Body& in_own_pass = ball_on_ground(apart, Real(-2)).bouncy(e);
    Body& added = ball_on_ground(wrong, Real(-2)).bouncy(e);
    Bouncing larger;
    Solver<Clamping, Baumgarte, RestitutionApart> own_pass;
    Solver<Clamping, Baumgarte, RestitutionAdded> sum;
    for (int step = 0; step < 60 && ball.velocity.y() <= 0; ++step) {
      right.step(larger, h, one_sweep);
      apart.step(own_pass, h, one_sweep);
      wrong.step(sum, h, one_sweep);
    }
    const Real approach = ball.velocity_before.y(), d = right.contacts.at(0).depth;
    INFO("e " << e << ": approach " << -approach << " m/s, " << d << " m deep, larger " << ball.velocity.y()
              << " m/s, sum " << added.velocity.y() << " m/s");
    CHECK(ball.velocity.y() == Approx(-e * approach).epsilon(64 * eps));
    CHECK(in_own_pass.velocity.y() == Approx(-e * approach).epsilon(64 * eps));
    CHECK(added.velocity.y() == Approx(-e * approach + Real(0.2) * d / h).epsilon(64 * eps));
    CHECK(added.velocity.y() > ball.velocity.y() + Real(0.1));
  }
  // Over many drops, however deep the ball happens to get: with e = 0.5 it should not come back above a quarter.
  Real highest_larger = 0, highest_sum = 0;
  for (int i = 0; i < 40; ++i) {
    const Real drop = 2 + static_cast<Real>(i) * Real(0.0037);
    highest_larger = std::max(highest_larger, apexes(Bouncing{}, Real(0.5), drop, h, 1)[0] / drop);
    highest_sum =
        std::max(highest_sum, apexes(Solver<Clamping, Baumgarte, RestitutionAdded>{}, Real(0.5), drop, h, 1)[0] / drop);
  }
  INFO("highest apex, of the drop: larger " << highest_larger << ", sum " << highest_sum);
  CHECK(highest_larger < Real(0.26));
  CHECK(highest_sum > Real(0.28));
}

// The step that hits turns v into -v before the ball moves, so it goes back through the very points it came by.
TEST_CASE("05: with e = 1 ten bounces neither gain nor lose, unless this step's gravity is counted in") {
  for (const Real dt : {h, h / 4}) {
    for (const Real drop : {Real(0.7), Real(1.33), Real(2)}) {
      const std::vector<Real> fair = apexes(Bouncing{}, 1, drop, dt, 10);
      const std::vector<Real> unfair = apexes(Solver<Clamping, Baumgarte, RestitutionWithGravity>{}, 1, drop, dt, 10);
      INFO("apexes after a drop of " << drop << " m: " << fair.front() << " ... " << fair.back() << " m, with gravity "
                                     << unfair.front() << " ... " << unfair.back() << " m");
      // About 100 steps a bounce, each with the rounding of a height of 2 m and of a speed of 6 m/s.
      for (const Real apex : fair) CHECK(std::abs(apex - drop) <= 1e4 * eps);
      for (std::size_t k = 0; k < unfair.size(); ++k) {
        // Each bounce adds about g h to the speed, and u g h / g to the height.
        const Real speed = std::sqrt(2 * g * drop) + static_cast<Real>(k + 1) * g * dt;
        CHECK(unfair[k] > (speed * speed / (2 * g) + drop) / 2);
      }
    }
  }
}

TEST_CASE("05: with this step's gravity counted in, a body at rest buzzes at about e g h / (1 - e)") {
  for (const Real e : {Real(0.5), Real(0.8), Real(0.9)}) {
    const Real fixed_point = e * g * h / (1 - e);
    // What arrives with that speed leaves with it.
    World exact;
    Body& ball = ball_on_ground(exact, 0).bouncy(e).moving({0, -fixed_point, 0});
    Solver<Clamping, Baumgarte, RestitutionWithGravity> counted_in;
    exact.step(counted_in, h, one_sweep);
    CHECK(ball.velocity.y() == Approx(fixed_point).epsilon(64 * eps));

    // What was at rest is driven there. A flight lasts a whole number of steps: it arrives with up to g h more or less.
    World driven, calm;
    Body& buzzing = ball_on_ground(driven, 0).bouncy(e);
    ball_on_ground(calm, 0).bouncy(e);
    Solver<Clamping, Baumgarte, RestitutionWithGravity> solver;
    Bouncing left_out;
    Real lowest = 1000, highest = 0;
    for (int step = 0; step < 1200; ++step) {
      driven.step(solver, h, one_sweep);
      calm.step(left_out, h, one_sweep);
      REQUIRE(std::abs(calm.bodies[1].velocity.y()) <= 16 * eps);  // with it left out, rest is rest
      const bool touches = !driven.contacts.empty() && driven.contacts[0].impulse.y() > 0;
      if (step < 600 || !touches) continue;
      lowest = std::min(lowest, buzzing.velocity.y());
      highest = std::max(highest, buzzing.velocity.y());
    }
    INFO("e " << e << ": departs with " << lowest << " to " << highest << " m/s, fixed point " << fixed_point
              << " m/s, g h " << g * h);
    CHECK(lowest > fixed_point - g * h);
    CHECK(highest < fixed_point + g * h);
  }
}

// ---- 06 -----------------------------------------------------------------------------------------------------------

namespace {

/// Without the warm start, so that every step is on its own.
using Rubbing = Solver<Clamping, Baumgarte, Slop, Restitution, Friction>;

/// A flat box on the ground with mu = `mu` between them, its sides along its way, sent off under `heading`.
void sliding_box(World& world, Real mu, Real speed, Real heading) {
  world.add(ground().rough(mu));
  const Vec3 way{std::cos(heading), 0, -std::sin(heading)};
  world.add(box({Real(0.2), Real(0.05), Real(0.2)}, 20)
                .turned(heading, Vec3::UnitY())
                .at({0, Real(0.04999), 0})
                .moving(speed * way)
                .rough(mu));
}

/// How far it gets.
Real stopping_distance(Real mu, Real speed, Real dt) {
  World world;
  sliding_box(world, mu, speed, 0);
  Rubbing solver;
  const int steps = static_cast<int>(speed / (mu * g * dt)) + 20;
  for (int step = 0; step < steps; ++step) world.step(solver, dt, enough_sweeps);
  CHECK(world.bodies[1].velocity.norm() < tiny);
  return world.bodies[1].position.x();
}

/// h times the sum of v0 - k mu g h as far as that is positive.
Real discrete_distance(Real mu, Real speed, Real dt) {
  Real way = 0;
  for (Real v = speed - mu * g * dt; v > 0; v -= mu * g * dt) way += dt * v;
  return way;
}

}  // namespace

TEST_CASE("06: a sliding box stops where the discrete sum says, v0 h / 2 short of v0^2 / (2 mu g)") {
  for (const Real mu : {Real(0.2), Real(0.5), Real(0.8)}) {
    for (const Real speed : {Real(3), Real(10)}) {
      for (const Real dt : {h, h / 2, h / 4}) {
        const Real way = stopping_distance(mu, speed, dt), sum = discrete_distance(mu, speed, dt),
                   smooth = speed * speed / (2 * mu * g);
        INFO("mu " << mu << ", v0 " << speed << ", dt " << dt << ": " << way << " m, sum " << sum << " m, v0^2/2 mu g "
                   << smooth << ", rel. " << (way - sum) / sum);
        CHECK(way == Approx(sum).epsilon(tiny));
        CHECK(std::abs(smooth - way - speed * dt / 2) <
              mu * g * dt * dt + tiny * smooth);  // O(h^2), from the last, shorter step
      }
    }
  }
  // 0.8 % short at 10 m/s, mu = 0.5, 1/60 s.
  CHECK(1 - discrete_distance(Real(0.5), 10, h) / (100 / g) == Approx(0.008).epsilon(0.05));
}

TEST_CASE("06: a box slides down a slope only if tan(theta) > mu, with a = g (sin(theta) - mu cos(theta))") {
  for (const Real theta : {Real(0.2), Real(0.5), Real(0.8)}) {
    for (const Real part : {Real(0.1), Real(0.5), Real(0.9), Real(0.99), Real(1.01), Real(1.1), Real(2)}) {
      const Real mu = part * std::tan(theta);
      const Vec3 up{-std::sin(theta), std::cos(theta), 0}, down{-std::cos(theta), -std::sin(theta), 0};
      World world;
      world.add(half_space(up).rough(mu));
      world.add(
          box({Real(0.2), Real(0.05), Real(0.2)}, 20).turned(theta, Vec3::UnitZ()).at(Real(0.04999) * up).rough(mu));
      Rubbing solver;
      constexpr int steps = 120;
      for (int step = 0; step < steps; ++step) world.step(solver, h, enough_sweeps);
      const Real slid = world.bodies[1].position.dot(down), speed = world.bodies[1].velocity.dot(down);
      if (part < 1) {
        const Real a = g * (std::sin(theta) - mu * std::cos(theta));
        INFO("theta " << theta << ", mu " << part << " tan: rel. " << speed / (a * steps * h) - 1);
        CHECK(speed == Approx(a * steps * h).epsilon(tiny));
        CHECK(slid == Approx(a * h * h * steps * (steps + 1) / 2).epsilon(tiny));
      } else {
        INFO("theta " << theta << ", mu " << part << " tan: creeps " << slid << " m");
        CHECK(std::abs(slid) < tiny);  // m, in two seconds
      }
    }
  }
}

TEST_CASE("06: a ball thrown without spin ends rolling at 5/7 of its speed") {
  for (const Real mu : {Real(0.1), Real(0.5)}) {
    for (const Real v0 : {Real(1), Real(5)}) {
      World world;
      const Real radius = Real(0.3), depth = Real(1e-6);
      Body& ball = ball_on_ground(world, depth).rough(mu).moving({v0, 0, 0});
      world.bodies[0].rough(mu);
      Rubbing solver;
      const int rolls_after = static_cast<int>(std::ceil(2 * v0 / (7 * mu * g * h)));  // steps
      for (int step = 1; step <= rolls_after + 60; ++step) {
        const Real before = ball.velocity.x();
        world.step(solver, h, one_sweep);
        if (step < rolls_after) REQUIRE(before - ball.velocity.x() == Approx(mu * g * h).epsilon(tiny));  // slides
        if (step > rolls_after) REQUIRE(std::abs(before - ball.velocity.x()) < tiny);                     // rolls
      }
      // Friction pulls at the contact point, midway between the surfaces: half the depth above the ball's lowest.
      const Real arm = radius - depth / 2;
      CHECK(ball.velocity.x() == Approx(v0 / (1 + Real(0.4) * radius * radius / (arm * arm))).epsilon(tiny));
      CHECK(ball.velocity.x() == Approx(v0 * 5 / 7).epsilon(depth / radius));
      CHECK(std::abs(ball.velocity.x() + ball.angular_velocity.z() * arm) < tiny);
    }
  }
}

TEST_CASE("06: the pyramid brakes by mu g along a tangent and by root 2 of that under 45 degrees") {
  for (const Real mu : {Real(0.2), Real(0.5)}) {
    for (const Real heading : {Real(0), pi / 8, pi / 4, 3 * pi / 8, pi / 2}) {
      World world;
      sliding_box(world, mu, 5, heading);
      Rubbing solver;
      const Vec3 before = world.bodies[1].velocity;
      world.step(solver, h, enough_sweeps);
      const Vec3 braked = (before - world.bodies[1].velocity) / h;
      const bool along_a_tangent = heading == 0 || heading == pi / 2;
      const Real should = along_a_tangent ? mu * g : std::sqrt(Real(2)) * mu * g;
      INFO("mu " << mu << ", heading " << heading << ": rel. " << braked.norm() / should - 1);
      CHECK(braked.norm() == Approx(should).epsilon(tiny));
      // And its direction is a corner of the pyramid, whatever the heading: the way bends.
      if (!along_a_tangent) CHECK(std::abs(braked.x()) == Approx(std::abs(braked.z())).epsilon(tiny));
    }
  }
}

// ---- 07 -----------------------------------------------------------------------------------------------------------

namespace {

using Cold = Solver<Clamping, Baumgarte, Slop, Restitution, Friction>;

/// Mean of the largest error of a row in the last second of five, m/s.
template <class ContactSolver>
Real residual_of_stack(int boxes, int sweeps) {
  World world;
  stack(world, boxes);
  ContactSolver solver;
  Real sum = 0;
  for (int step = 0; step < 300; ++step) {
    world.step(solver, h, sweeps);
    if (step >= 240) sum += largest_error(solver) / 60;
  }
  return sum;
}

}  // namespace

TEST_CASE("07: started warm, the same residual in fewer sweeps") {
  std::vector<Real> cold, warm;
  for (const int sweeps : {3, 5, 10, 20, 40}) {
    cold.push_back(residual_of_stack<Cold>(5, sweeps));
    warm.push_back(residual_of_stack<FullSolver>(5, sweeps));
    INFO("5 boxes, " << sweeps << " sweeps: cold " << cold.back() << " m/s, warm " << warm.back() << " m/s");
    CHECK(warm.back() < cold.back() / 50);
  }
  CHECK(warm.front() < cold.back());  // 3 warm sweeps are worth more than 40 cold ones
  for (const int sweeps : {10, 20, 40}) {
    const Real ten_cold = residual_of_stack<Cold>(10, sweeps), ten_warm = residual_of_stack<FullSolver>(10, sweeps);
    INFO("10 boxes, " << sweeps << " sweeps: cold " << ten_cold << " m/s, warm " << ten_warm << " m/s");
    CHECK(ten_warm < ten_cold / 5);
  }
}

TEST_CASE("07: the first guess is scaled by dt_new / dt_old") {
  World world;
  Body& ball = ball_on_ground(world, Real(0.002));
  FullSolver solver;
  world.step(solver, h, one_sweep);
  // No sweeps at all from here on: what is left is the first guess, and it holds the ball through any change of step.
  for (const Real dt : {h, h / 4, h / 2, h * 2, h / 7, h}) {
    world.step(solver, dt, 0);
    REQUIRE(world.contacts.at(0).impulse.y() == Approx(10 * g * dt).epsilon(64 * eps));
    REQUIRE(std::abs(ball.velocity.y()) <= 64 * eps);
    REQUIRE(world.contacts[0].state != ContactState::fresh);
  }

  // A pile at rest does not notice either: its speeds stay what they are in steady steps.
  World pile;
  stack(pile, 5);
  FullSolver steady;
  for (int step = 0; step < 600; ++step) pile.step(steady, h, 20);
  const Real quiet = largest_speed(pile);
  for (const Real dt : {h / 4, h, h / 2, h}) {
    pile.step(steady, dt, 20);
    INFO("largest speed " << largest_speed(pile) << " m/s after " << quiet);
    CHECK(largest_speed(pile) < 10 * quiet);  // unscaled it would be some g h, 0.1 m/s
  }
}

TEST_CASE("07: what the contacts have forgotten starts from nothing, and what they know from there") {
  World world;
  ball_on_ground(world, Real(0.002));
  FullSolver solver;
  world.step(solver, h, one_sweep);
  world.step(solver, h, 0);
  CHECK(world.contacts.at(0).impulse.y() == Approx(10 * g * h).epsilon(64 * eps));
  world.contacts.clear();
  world.step(solver, h, 0);
  CHECK(world.contacts.at(0).impulse.isZero(0));
  CHECK(world.contacts[0].state == ContactState::fresh);
}

TEST_CASE("07: a contact that vanishes for one step comes back with nothing") {
  World world;
  Body& ball = ball_on_ground(world, Real(0.002));
  FullSolver solver;
  world.step(solver, h, one_sweep);
  const Vec3 place = ball.position;
  ball.at(place + Vec3(0, Real(0.1), 0));
  world.step(solver, h, one_sweep);
  REQUIRE(world.contacts.empty());
  ball.at(place).moving(Vec3::Zero());
  world.step(solver, h, 0);
  CHECK(world.contacts.at(0).impulse.isZero(0));
  CHECK(world.contacts[0].state == ContactState::fresh);
}

TEST_CASE("07: the impulse of each contact goes to the same contact, though others come and go") {
  // Three balls of different mass. The middle one leaves and returns; the outer ones keep what is theirs.
  World world;
  world.add(ground());
  for (int i = 0; i < 3; ++i)
    world.add(sphere(Real(0.3), static_cast<Real>(10 * (i + 1))).at({static_cast<Real>(i), Real(0.298), 0}));
  FullSolver solver;
  world.step(solver, h, one_sweep);
  world.bodies[2].at({1, 1, 0});
  world.step(solver, h, 0);
  REQUIRE(world.contacts.size() == 2);
  CHECK(world.contacts[0].impulse.y() == Approx(10 * g * h).epsilon(64 * eps));
  CHECK(world.contacts[1].impulse.y() == Approx(30 * g * h).epsilon(64 * eps));
  world.bodies[2].at({1, Real(0.298), 0}).moving(Vec3::Zero());
  world.step(solver, h, 0);
  REQUIRE(world.contacts.size() == 3);
  CHECK(world.contacts[0].impulse.y() == Approx(10 * g * h).epsilon(64 * eps));
  CHECK(world.contacts[1].impulse.isZero(0));
  CHECK(world.contacts[2].impulse.y() == Approx(30 * g * h).epsilon(64 * eps));
}
