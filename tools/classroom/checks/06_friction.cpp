#include "pushback/chapters/06_friction/exercise/asked.h"
#include "pushback/chapters/06_friction/friction.h"
#include "pushback/common/exercise/shown.h"

namespace pushback::exercise_06 {

namespace {

using Sliding = Solver<Clamping, AnyEffect>;

/// `body` touches a plane in the one point `height` below its centre, and arrives. Such a contact's rows do not disturb each
/// other: one sweep is exact.
void touch(World& world, const Body& body, Real height, const Vec3& velocity, Real mu,
           const Vec3& normal = Vec3::UnitY()) {
  constexpr Real of_ground = Real(0.8);
  if (world.bodies.empty()) world.add(half_space(normal).rough(of_ground));
  Body placed = body;
  const Vec3 point(2 * static_cast<Real>(world.bodies.size() - 1), 0, 0);  // beside the one before
  const int index = world.add(placed.at(point + height * normal).moving(velocity).rough(mu * mu / of_ground));
  world.contacts.push_back(
      {.point = point, .normal = normal, .friction = mu, .id = {0, static_cast<std::uint32_t>(index), 0}});
}
Body ball(Random& random) {
  const Real radius = random.between(Real(0.2), Real(0.5)), mass = random.between(5, 20);
  return sphere(radius, mass);
}
void touch(World& world, const Body& ball, const Vec3& velocity, Real mu) {
  touch(world, ball, std::get<Sphere>(ball.shape).radius, velocity, mu);
}

Real random_step(Random& random) {
  return 1 / random.between(50, 240);
}

void solve(World& world, Random& random, int sweeps, const Answer& answer,
           const std::vector<std::size_t>& quantities = {}) {
  auto solver = with_effect<Sliding>(answer.friction);
  solver.solve(world, random_step(random), sweeps);
  show(world, quantities);
}

/// A ball too fast for its friction: what it loses of its velocity in a step of four sweeps, m/s.
Vec3 lost_by_ball(Random& random, const Vec3& heading, const Answer& answer,
                  const std::vector<std::size_t>& quantities) {
  const Real speed = random.between(30, 40), arrival = random.between(1, 2), mu = random.between(Real(0.4), Real(0.6));
  World world;
  const Vec3 velocity = speed * heading - arrival * Vec3::UnitY();
  touch(world, ball(random), velocity, mu);
  solve(world, random, 4, answer, quantities);
  return velocity - world.bodies[1].velocity;
}

/// A box on two feet that are so near to each other that what brakes one brakes both: the first has to take some of its friction
/// back. How fast the faster of them slips on, m/s.
Real slip_of_two_feet(Random& random, const Answer& answer) {
  const Real wide = random.between(Real(0.4), Real(0.6)), foot = wide * random.between(Real(0.2), Real(0.3));
  const Real speed = random.between(1, 2), mu = random.between(2, 3);  // no bound holds it back
  World world;
  touch(world, box({wide, wide, wide}, random.between(50, 150)), wide, {speed, -6 * speed, speed}, mu);
  world.contacts.push_back(world.contacts[0]);
  world.contacts[0].point = {-foot, 0, 0};
  world.contacts[1].point = {foot, 0, 0};
  world.contacts[1].id.feature = 1;
  solve(world, random, 300, answer);
  Real fastest = 0;
  for (const Contact& at : world.contacts) {
    const Vec3 slip = world.bodies[1].velocity_at(at.point);
    fastest = std::max(fastest, std::hypot(slip.x(), slip.z()));
  }
  return fastest;
}

std::vector<Check<Answer>> checks() {
  return {
      {"a ball that is pressed on hard enough ends rolling",
       1,
       {{"your ball, which should end rolling, goes on along x with", "m/s", 1e-6},
        {"your ball, which should end rolling, goes on along z with", "m/s", 1e-6}},
       [](Random& random, const Answer& answer) -> Numbers {
         const Real speed = random.between(1, 2), across = random.between(Real(0.4), Real(0.8));
         const Real mu = random.between(Real(0.5), Real(0.8));
         World world;
         touch(world, ball(random), {speed, -3 * speed, across * speed}, mu);
         solve(world, random, 3, answer);
         return {world.bodies[1].velocity.x(), world.bodies[1].velocity.z()};
       }},
      {"a box that stands on one foot: the foot sticks, whichever way it slid",
       2,
       {{"the foot of your box slips on along x with", "m/s", 1e-6},
        {"the foot of your box slips on along z with", "m/s", 1e-6},
        {"your box goes on with", "m/s", 1e-6}},
       [](Random& random, const Answer& answer) -> Numbers {
         const Real speed = random.between(1, 2), across = random.between(Real(0.4), Real(0.8));
         const Real wide = random.between(Real(0.5), Real(0.7)), high = random.between(Real(0.4), Real(0.6)),
                    narrow = random.between(Real(0.15), Real(0.25)), mu = random.between(Real(0.5), Real(0.8));
         World world;
         touch(world, box({wide, high, narrow}, random.between(50, 150)), high, {speed, -3 * speed, across * speed},
               mu);
         solve(world, random, 1, answer);
         const Body& box = world.bodies[1];
         const Vec3 slip = box.velocity_at(Vec3::Zero());
         return {slip.x(), slip.z(), box.velocity.norm()};
       }},
      {"a ball that is too fast slides on, and loses μ Σλn / m",
       2,
       {{"your ball, which slides to the right, is braked by", "m/s", 1e-6},
        {"your ball, which slides to the left, is braked by", "m/s", 1e-6},
        {"your ball, which slides aslant, is braked along x by", "m/s", 1e-6},
        {"your ball, which slides aslant, is braked along z by", "m/s", 1e-6}},
       [](Random& random, const Answer& answer) -> Numbers {
         const Real right = lost_by_ball(random, Vec3::UnitX(), answer, {0}).x();
         const Real left = -lost_by_ball(random, -Vec3::UnitX(), answer, {1}).x();
         const Vec3 aslant = lost_by_ball(random, {Real(0.8), 0, Real(0.6)}, answer, {2, 3});
         return {right, left, aslant.x(), aslant.z()};
       }},
      {"a ball slips down a slope, g (sin θ − μ cos θ) h faster each step",
       1,
       {{"your ball, which slips down a slope, starts with", "m/s", 1e-6},
        {"your ball, which crosses a slope, is braked along the first tangent by", "m/s", 1e-6},
        {"your ball, which crosses a slope, is braked along the second tangent by", "m/s", 1e-6}},
       [](Random& random, const Answer& answer) -> Numbers {
         const Real theta = random.between(Real(0.6), Real(0.8)), h = random_step(random);
         const Real mu = random.between(Real(0.5), Real(0.8)) * Real(2) / 7 * std::tan(theta);  // it rolls from 1 on
         const Body body = ball(random);
         World world;
         touch(world, body, std::get<Sphere>(body.shape).radius, h * world.gravity, mu,
               {-std::sin(theta), std::cos(theta), 0});
         with_effect<Sliding>(answer.friction).solve(world, h, 4);
         show(world, {0});
         const Real slips = -world.bodies[1].velocity.dot(Vec3(std::cos(theta), std::sin(theta), 0));
         const Real lean = random.between(Real(0.4), Real(0.6)), aside = random.between(Real(0.2), Real(0.3));
         const Vec3 normal = Vec3(lean, 1, aside).normalized();
         const auto [tangent1, tangent2] = tangents_of(normal);
         const Real speed = random.between(30, 40), arrival = random.between(1, 2);
         const Vec3 crossing = speed * tangent1 - Real(0.7) * speed * tangent2 - arrival * normal;
         World other;
         touch(other, body, std::get<Sphere>(body.shape).radius, crossing, random.between(Real(0.4), Real(0.6)),
               normal);
         solve(other, random, 4, answer, {1, 2});
         const Vec3 lost = crossing - other.bodies[1].velocity;
         return {slips, lost.dot(tangent1), -lost.dot(tangent2)};
       }},
      {"of two balls, each is braked by its own push on the ground",
       1,
       {{"your first ball, which is pressed on less, is braked along x by", "m/s", 1e-6},
        {"your first ball, which is pressed on less, is braked along z by", "m/s", 1e-6},
        {"your second ball, which is pressed on more, is braked along x by", "m/s", 1e-6},
        {"your second ball, which is pressed on more, is braked along z by", "m/s", 1e-6}},
       [](Random& random, const Answer& answer) -> Numbers {
         World world;
         std::vector<Vec3> velocity;
         for (const Real least : {Real(1), Real(2)}) {
           const Real speed = random.between(30, 40), arrival = random.between(least, least + Real(0.5));
           const Real mu = random.between(Real(0.4), Real(0.6));
           velocity.emplace_back(speed, -arrival, speed / 2);
           touch(world, ball(random), velocity.back(), mu);
         }
         solve(world, random, 4, answer);
         const Vec3 first = velocity[0] - world.bodies[1].velocity, second = velocity[1] - world.bodies[2].velocity;
         return {first.x(), first.z(), second.x(), second.z()};
       }},
      {"a box that comes down on a corner: friction and push act on each other, and end in agreement",
       2,
       {{"your box, which slides on its rear corner, is braked along x by", "m/s", 1e-6},
        {"your box, which slides on its rear corner, is braked along z by", "m/s", 1e-6},
        {"your box, which slides on its front corner, is braked along x by", "m/s", 1e-6},
        {"your box, which slides on its front corner, is braked along z by", "m/s", 1e-6},
        {"your box, which stands on two feet that should stick, slips on with", "m/s", 1e-6}},
       [](Random& random, const Answer& answer) -> Numbers {
         Numbers braked;
         for (const Real forward : {Real(1), Real(-1)}) {  // where its centre is
           const Real wide = random.between(Real(0.4), Real(0.6)), high = random.between(Real(0.4), Real(0.6));
           const Real speed = random.between(30, 40), arrival = random.between(1, 2);
           const Real mu = random.between(Real(0.3), Real(0.4));
           const Vec3 velocity(speed, -arrival, speed / 2);
           World world;
           touch(world, box({wide, high, wide}, random.between(50, 150)), high, velocity, mu);
           world.bodies[1].position += forward * Vec3(wide, 0, wide / 2);
           solve(world, random, 100, answer, {braked.size(), braked.size() + 1});
           const Vec3 lost = velocity - world.bodies[1].velocity;
           braked.insert(braked.end(), {lost.x(), lost.z()});
         }
         braked.push_back(slip_of_two_feet(random, answer));
         return braked;
       }},
  };
}

/// A mistake is what it does with the two tangents of a contact.
template <class Solve>
struct Mistaken : Friction {
  Solve solve;
  void sweep(StepContext& step) {
    for (std::size_t i = first_; i < step.rows.size(); i += 2) solve(step, step.rows[i], step.rows[i + 1]);
  }
};
template <class Solve>
Answer mistaken(Solve solve) {
  return {Mistaken<Solve>{{}, solve}};
}

void within(Row& row, Real total, Real lo, Real hi) {
  row.lo = lo;
  row.hi = hi;
  row.reach(total);
}
void within(Row& row, Real bound) {
  within(row, row.wanted(), -bound, bound);
}
Real bound_of(const StepContext& step, const Row& tangent) {
  return step.contacts[tangent.owner].friction * step.rows[tangent.owner].impulse;
}

/// ... with each of them, whatever the other.
template <class Solve>
Answer each_mistaken(Solve solve) {
  return mistaken([solve](StepContext& step, Row& tangent1, Row& tangent2) {
    for (Row* tangent : {&tangent1, &tangent2}) solve(step, *tangent, bound_of(step, *tangent));
  });
}

constexpr Real inf = std::numeric_limits<Real>::infinity();

/// Which of the pushes of a normal bounds its tangents: in all that it has given before this sweep, what it gives in this
/// one, and what it gave in the first.
struct ByPush : Friction {
  Real (*push)(Real before, Real now, Real first);
  std::vector<Real> before = {}, first = {};
  void build(StepContext& step) {
    Friction::build(step);
    before.assign(step.contacts.size(), 0);
    first.clear();
  }
  void sweep(StepContext& step) {
    for (std::size_t i = first.size(); i < step.contacts.size(); ++i) first.push_back(step.rows[i].impulse);
    for (std::size_t k = first_; k < step.rows.size(); ++k) {
      const std::size_t i = step.rows[k].owner;
      within(step.rows[k], step.contacts[i].friction * push(before[i], step.rows[i].impulse - before[i], first[i]));
    }
    for (std::size_t i = 0; i < before.size(); ++i) before[i] = step.rows[i].impulse;
  }
};
/// Along which tangents its rows lie.
struct Along : Friction {
  std::pair<Vec3, Vec3> (*tangents)(const Vec3& normal);
  void build(StepContext& step) {
    Friction::build(step);
    for (std::size_t k = first_; k < step.rows.size(); k += 2) {
      const Contact& at = step.contacts[step.rows[k].owner];
      const auto [a, b] = step.world.bodies_of(at);
      const auto [tangent1, tangent2] = tangents(at.normal);
      for (const bool one : {true, false})
        step.rows[one ? k : k + 1].Jacobian::operator=(Jacobian::along(one ? tangent1 : tangent2, a, b, at.point));
      for (std::size_t row : {k, k + 1}) {
        Row& tangent = step.rows[row];
        tangent.weigh();
        tangent.effective_mass = 1 / (tangent.n.dot(tangent.dvb - tangent.dva) + tangent.rb_n.dot(tangent.dwb) -
                                      tangent.ra_n.dot(tangent.dwa));
      }
    }
  }
};

std::vector<Mistake<Answer>> mistakes() {
  const std::string one_k =
      "it looks as if one effective mass served both tangents. A long box turns more easily about its length than "
      "across it, so its foot gives way more easily along one tangent: each row has its own K.";
  const std::string same_twice =
      "it looks as if both rows of a contact lay along the same tangent: it brakes twice there, and not at all along "
      "the other.";
  return {
      {"μ m g",
       "it looks as if the bound were μ m g. What bounds friction is the push on this contact: on a slope it is less "
       "than the weight, in an impact far more. It is Σλn, of the normal's row.",
       each_mistaken([](StepContext& step, Row& tangent, Real) {
         within(tangent, step.contacts[tangent.owner].friction / tangent.b->inverse_mass * World::g * step.dt);
       })},
      {"each correction clamped",
       "it looks as if each correction were clamped, not their sum, or the sum began at 0 in each sweep. Every sweep "
       "then brakes by the full bound once more.",
       each_mistaken([](StepContext&, Row& tangent, Real bound) {
         const Real lambda = std::clamp(tangent.wanted() - tangent.impulse, -bound, bound);
         tangent.reach(tangent.impulse + lambda);
       })},
      {"one-sided",
       "it looks as if the sum of a tangent could not be negative. A normal only pushes; friction acts both ways along "
       "its tangent, from -μ Σλn to μ Σλn.",
       each_mistaken([](StepContext&, Row& tangent, Real bound) { within(tangent, tangent.wanted(), 0, bound); })},
      {"one-sided",
       "it looks as if only one end of the interval were bounded. Friction that acts against the tangent is no "
       "stronger than friction along it: from -μ Σλn to μ Σλn.",
       each_mistaken([](StepContext&, Row& tangent, Real bound) { within(tangent, tangent.wanted(), -inf, bound); })},
      {"one K for both", one_k, mistaken([](StepContext& step, Row& tangent1, Row& tangent2) {
         for (Row* tangent : {&tangent1, &tangent2}) {
           const Real bound = bound_of(step, *tangent);
           within(*tangent, tangent->impulse - tangent1.effective_mass * tangent->speed(), -bound, bound);
         }
       })},
      {"one K for both", one_k, mistaken([](StepContext& step, Row& tangent1, Row& tangent2) {
         for (Row* tangent : {&tangent1, &tangent2}) {
           const Real bound = bound_of(step, *tangent);
           within(*tangent, tangent->impulse - tangent2.effective_mass * tangent->speed(), -bound, bound);
         }
       })},
      {"the normal's K",
       "it looks as if the tangents were solved with the normal's effective mass, or as if nothing turned. Friction "
       "turns the body, so along a tangent the contact point gives way more easily: each row has its own K.",
       each_mistaken([](StepContext& step, Row& tangent, Real bound) {
         within(tangent, tangent.impulse - step.rows[tangent.owner].effective_mass * tangent.speed(), -bound, bound);
       })},
      {"no bound",
       "it looks as if nothing bounded the friction. What is not pressed on cannot be held: the sum stays within μ "
       "Σλn.",
       each_mistaken([](StepContext&, Row& tangent, Real) { tangent.solve(); })},
      {"μ forgotten", "it looks as if the bound were Σλn. Friction is at most the part μ of the push.",
       each_mistaken([](StepContext& step, Row& tangent, Real) { within(tangent, step.rows[tangent.owner].impulse); })},
      {"the μ of one body",
       "it looks as if the μ were that of one body. How rough a contact is depends on both: step.contacts[i].friction.",
       each_mistaken([](StepContext& step, Row& tangent, Real) {
         within(tangent, tangent.a->friction * step.rows[tangent.owner].impulse);
       })},
      {"the μ of one body",
       "it looks as if the μ were that of one body. How rough a contact is depends on both: step.contacts[i].friction.",
       each_mistaken([](StepContext& step, Row& tangent, Real) {
         within(tangent, tangent.b->friction * step.rows[tangent.owner].impulse);
       })},
      {"times h", "it looks as if the bound were multiplied by h. Σλn is an impulse already, N s, and so is the bound.",
       each_mistaken([](StepContext& step, Row& tangent, Real bound) { within(tangent, step.dt * bound); })},
      {"sign", "it looks as if friction pushed along with the slip. The impulse that makes J V = 0 is -J V / K.",
       each_mistaken([](StepContext&, Row& tangent, Real bound) {
         within(tangent, tangent.impulse + tangent.effective_mass * tangent.speed(), -bound, bound);
       })},
      {"one tangent",
       "it looks as if only one tangent were solved. A plane has two directions: along the other nothing brakes.",
       mistaken([](StepContext& step, Row& tangent1, Row&) { within(tangent1, bound_of(step, tangent1)); })},
      {"one tangent",
       "it looks as if only one tangent were solved. A plane has two directions: along the other nothing brakes.",
       mistaken([](StepContext& step, Row&, Row& tangent2) { within(tangent2, bound_of(step, tangent2)); })},
      {"the same tangent twice", same_twice, mistaken([](StepContext& step, Row& tangent1, Row& tangent2) {
         tangent2.place(tangent1);
         for (Row* tangent : {&tangent1, &tangent2}) within(*tangent, bound_of(step, *tangent));
       })},
      {"the same tangent twice", same_twice, mistaken([](StepContext& step, Row& tangent1, Row& tangent2) {
         tangent1.place(tangent2);
         for (Row* tangent : {&tangent1, &tangent2}) within(*tangent, bound_of(step, *tangent));
       })},
      {"tangents of no unit length",
       "it looks as if a tangent were no unit vector, or not at a right angle to the other. The bound is that of an "
       "impulse along a unit vector: along a shorter one the same Σλt brakes less. tangents_of gives two unit vectors.",
       {Along{{},
              [](const Vec3& n) {
                const Vec3 one = n.cross(Vec3::UnitX());
                return std::pair<Vec3, Vec3>(one, n.cross(one));
              }}}},
      {"tangents of no unit length",
       "it looks as if a tangent were no unit vector, or not at a right angle to the other. The bound is that of an "
       "impulse along a unit vector: along a shorter one the same Σλt brakes less. tangents_of gives two unit vectors.",
       {Along{{},
              [](const Vec3& n) {
                int flattest = 0;
                n.cwiseAbs().minCoeff(&flattest);
                const Vec3 axis = Vec3::Unit(flattest), one = axis - n.dot(axis) * n;
                return std::pair<Vec3, Vec3>(one, n.cross(one));
              }}}},
      {"along the world's axes",
       "it looks as if the rows lay along x and z of the world. On a slope these are no tangents: friction then pushes "
       "into the ground or lifts off it. The tangents are those of the contact's own normal.",
       {Along{{}, [](const Vec3&) { return std::pair<Vec3, Vec3>(Vec3::UnitX(), Vec3::UnitZ()); }}}},
      {"other tangents",
       "it looks as if the rows lay along other tangents than those of tangents_of. Each has the bound for itself, so "
       "the pyramid turns with them, and friction with the pyramid.",
       {Along{{},
              [](const Vec3& n) {
                const Vec3 one = n.cross(Vec3::UnitX()).normalized();
                return std::pair<Vec3, Vec3>(one, n.cross(one));
              }}}},
      {"the push of this sweep alone",
       "it looks as if the bound came from what the normal has added in this sweep alone. Σλn is its sum over the "
       "sweeps of this step: once the normal adds nothing more, a bound of its change is 0, and friction is taken "
       "back.",
       {ByPush{{}, [](Real, Real now, Real) { return now; }}}},
      {"the push of the sweep before",
       "it looks as if the bound came from the sum that the normal had reached one sweep before. In the first sweep "
       "that is 0, and nothing brakes: take the sum that it has reached in this very sweep, after it was solved.",
       {ByPush{{}, [](Real before, Real, Real) { return before; }}}},
      {"the push of the first sweep",
       "it looks as if the bound stayed as it was in the first sweep. Friction turns the body, and the push of the "
       "normal changes with that: the bound is made anew in each sweep, of Σλn as it is now.",
       {ByPush{{}, [](Real, Real, Real first) { return first; }}}},
      {"the largest push so far",
       "it looks as if the bound could only grow. Where the normal takes back some of its push, friction has to "
       "follow: the bound is that of Σλn as it is now.",
       {ByPush{{}, [](Real before, Real now, Real first) { return std::max(first, before + now); }}}},
      {"hi for lo",
       "it looks as if lo and hi were the same, or swapped: the sum then sits at one end of the interval, whichever "
       "way the body slips. Friction is anything from -μ Σλn to μ Σλn.",
       each_mistaken([](StepContext&, Row& tangent, Real bound) { within(tangent, tangent.wanted(), bound, bound); })},
      {"hi for lo",
       "it looks as if lo and hi were the same, or swapped: the sum then sits at one end of the interval, whichever "
       "way the body slips. Friction is anything from -μ Σλn to μ Σλn.",
       each_mistaken([](StepContext&, Row& tangent, Real bound) { within(tangent, tangent.wanted(), bound, -bound); })},
      {"the 1-norm",
       "it looks as if both tangents together had the bound, as |Σλ1| + |Σλ2|. Here each tangent has the full bound "
       "for itself.",
       mistaken([](StepContext& step, Row& tangent1, Row& tangent2) {
         const Real bound = bound_of(step, tangent1), wanted1 = tangent1.wanted(), wanted2 = tangent2.wanted();
         const Real scale = std::min(Real(1), bound / (std::abs(wanted1) + std::abs(wanted2)));
         tangent1.reach(scale * wanted1);
         tangent2.reach(scale * wanted2);
       })},
      {"the mean of both μ",
       "it looks as if μ were the mean of those of the bodies. How rough a contact is depends on both in another way: "
       "step.contacts[i].friction is the μ of the pair.",
       each_mistaken([](StepContext& step, Row& tangent, Real) {
         within(tangent, (tangent.a->friction + tangent.b->friction) / 2 * step.rows[tangent.owner].impulse);
       })},
      {"the first contact alone",
       "it looks as if only the first contact had friction. Each contact has two tangents, and all of them are solved "
       "in each sweep.",
       mistaken([](StepContext& step, Row& tangent1, Row& tangent2) {
         if (tangent1.owner > 0) return;
         for (Row* tangent : {&tangent1, &tangent2}) within(*tangent, bound_of(step, *tangent));
       })},
      {"the push of the first contact",
       "it looks as if all tangents were bounded by the first contact's push. Each contact is pressed on by itself: "
       "the last argument of a new row is the index of its contact, and rows[owner] then its normal's row.",
       each_mistaken([](StepContext& step, Row& tangent, Real) {
         within(tangent, step.contacts[0].friction * step.rows[0].impulse);
       })},
      {"the push of the first contact",
       "it looks as if all tangents were bounded by the first contact's push. Each contact is pressed on by itself: "
       "the last argument of a new row is the index of its contact, and rows[owner] then its normal's row.",
       each_mistaken([](StepContext& step, Row& tangent, Real) {
         within(tangent, step.contacts[tangent.owner].friction * step.rows[0].impulse);
       })},
      {"the push of another row",
       "it looks as if the bound came from the wrong row. The k-th tangent's row is not of the k-th contact: the "
       "normal's row is step.rows[tangent.owner].",
       each_mistaken([](StepContext& step, Row& tangent, Real) {
         const auto k = static_cast<std::size_t>(&tangent - step.rows.data()) - step.contacts.size();
         within(tangent, step.contacts[tangent.owner].friction * step.rows[k].impulse);
       })},
      {"a disc",
       "it looks as if both tangents together were bounded by a disc. That is nearer to Coulomb's law, and chapter 08 "
       "does it. Here each tangent has the full bound for itself.",
       mistaken([](StepContext& step, Row& tangent1, Row& tangent2) {
         const Real bound = bound_of(step, tangent1), wanted1 = tangent1.wanted(), wanted2 = tangent2.wanted();
         const Real scale = std::min(Real(1), bound / std::hypot(wanted1, wanted2));
         tangent1.reach(scale * wanted1);
         tangent2.reach(scale * wanted2);
       })},
      {"never taken back",
       "it looks as if friction could only grow. Two feet of one box brake each other too: what the first has given "
       "may be too much once the second has, and then it slips the other way, and has to take some back.",
       each_mistaken([](StepContext&, Row& tangent, Real bound) {
         if (tangent.impulse * tangent.speed() <= 0) within(tangent, bound);
       })},
      {"no friction",
       "it looks as if nothing braked. Rows that are made and never solved do nothing. And a bound that is computed in "
       "build is 0, as no normal has pushed yet; so is one of step.contacts[i].impulse, which is known after the step.",
       each_mistaken([](StepContext&, Row&, Real) {})},
  };
}

}  // namespace

Numbers play(std::size_t check, Random& random, const Answer& answer) {
  return checks()[check].play(random, answer);
}

Exercise exercise() {
  return exercise_of<Answer>(
      "two tangent rows and their bound",
      {"build: for each contact, tangents_of its normal, and one row along each. Do the new rows come after all "
       "normals? Then you can find those of contact i again.",
       "sweep: a tangent's row wants J V = 0, so the sum that it wants is impulse - effective_mass * speed().",
       "sweep: the bound is contact.friction times the impulse of the contact's normal row. Set lo to minus the bound "
       "and hi to the bound, and reach the wanted sum."},
      checks(), {Friction{}}, mistakes());
}

}  // namespace pushback::exercise_06
