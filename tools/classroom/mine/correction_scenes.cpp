/// 10: single steps of contacts that are made by hand, and how far they move the bodies.
#include "pushback/tools/classroom/mine/scenes.h"
#include "pushback/tools/classroom/mine/touching.h"

namespace pushback {

using namespace touching;

namespace {

/// How far A and B are from where `start` has them, mm, and turned, mrad.
Numbers displaced(const World& world, const std::vector<Body>& start) {
  Numbers numbers;
  for (std::size_t i = 0; i < 2; ++i) {
    numbers.push_back(1000 * (world.bodies[i].position - start[i].position).norm());
    numbers.push_back(1000 * world.bodies[i].orientation.angularDistance(start[i].orientation));
  }
  return numbers;
}

/// A step of a pair: how far its bodies are from where their velocities alone have brought them, and these velocities.
Numbers corrected(Pair& pair, const WholeSolver& answer, int sweeps) {
  std::vector<Body> alone = pair.world.bodies;
  pair.substep(*answer.make(), sweeps);
  for (std::size_t i = 0; i < 2; ++i) {
    alone[i].velocity = pair.world.bodies[i].velocity;
    alone[i].angular_velocity = pair.world.bodies[i].angular_velocity;
    move(alone[i], pair.h);
  }
  Numbers numbers = displaced(pair.world, alone);
  for (const Body& body : pair.world.bodies) numbers.push_back(body.velocity.norm());
  return numbers;
}

Numbers moved_out(Random& random, const WholeSolver& answer) {
  Pair pair(random, -random.between(Real(0.1), Real(0.3)));
  pair.contact().depth = random.between(Real(0.02), Real(0.1));
  return corrected(pair, answer, few(random));
}

/// They part by themselves, so that less is left; not so fast that nothing is.
Numbers less_is_left(Random& random, const WholeSolver& answer) {
  Pair pair(random, random.between(Real(0.4), Real(0.8)));
  pair.contact().depth = random.between(Real(0.05), Real(0.1));
  return corrected(pair, answer, few(random));
}

Numbers at_most(Random& random, const WholeSolver& answer) {
  Pair pair(random, -random.between(Real(0.1), Real(0.3)));
  pair.contact().depth = random.between(Real(0.4), Real(0.8));
  return corrected(pair, answer, few(random));
}

Numbers left_alone(Random& random, const WholeSolver& answer) {
  Pair pair(random, meeting(random));
  pair.contact().depth = random.between(Real(-0.01), Real(0.0045));
  return corrected(pair, answer, few(random));
}

Numbers no_speed(Random& random, const WholeSolver& answer) {
  Pair pair(random, slow(random));
  pair.contact().depth = random.between(Real(0.02), Real(0.1));
  return solved(pair, answer, few(random));
}

}  // namespace

std::vector<CheckOfChapter> checks_of_corrections() {
  const std::vector<int> all{};
  const std::vector<Quantity> of_a_correction{
      {"your correction moves the lower body by", "mm", exact}, {"and turns it by", "mrad", 1e-4},
      {"your correction moves the upper body by", "mm", exact}, {"and turns it by", "mrad", 1e-4},
      {"after it, your lower body moves with", "m/s", exact},   {"after it, your upper body moves with", "m/s", exact}};
  return {
      {10, all, {"the push-out has left the bias: no speed comes of an overlap", 1, of_a_pair, no_speed}},
      {10, all, {"who overlaps is moved, by the part β of what is left", 1, of_a_correction, moved_out}},
      {10, all, {"what the bodies' own velocities close is not closed twice", 1, of_a_correction, less_is_left}},
      {10, all, {"no contact corrects more than 50 mm", 1, of_a_correction, at_most}},
      {10, all, {"who is less deep than the slop is not moved", 1, of_a_correction, left_alone}},
  };
}

}  // namespace pushback
