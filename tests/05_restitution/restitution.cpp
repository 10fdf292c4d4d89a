/// How high a ball bounces, and three ways to get it wrong.
#include "pushback/chapters/05_restitution/restitution.h"
#include "pushback/chapters/05_restitution/mistakes.h"
#include "tests/support/catch.h"
#include "tests/support/on_ground.h"

using namespace pushback;

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
    if (!highest.empty() && highest.back() == 0) highest.back() = -depth_of(world.bodies[1]) - dt * ball.velocity.y();
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
