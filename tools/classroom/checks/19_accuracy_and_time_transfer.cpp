#include <cmath>

#include "pushback/chapters/08_friction_cone/friction_cone.h"
#include "pushback/chapters/19_accuracy_and_time/exercise/transfer/asked.h"

namespace pushback::exercise_19_transfer {

namespace {

double between(Random& random, double low, double high) {
  return static_cast<double>(random.between(static_cast<Real>(low), static_cast<Real>(high)));
}

/// A box, and a moment at which one asks where it is.
struct Push {
  double speed, slope, mu, t;

  /// When it stops, s.
  double turn() const { return speed / (g * (std::sin(slope) + mu * std::cos(slope))); }
  Real asked(const Answer& answer) const { return static_cast<Real>(answer.way(speed, slope, mu, t)); }
};

/// `held`: mu as a part of what would just hold it; `turns`: the moment, as a part of when it stops.
Push push_of(Random& random, double held, double turns) {
  Push push{between(random, 2, 4), between(random, 0.5, 0.8), 0, 0};
  push.mu = held * std::tan(push.slope);
  push.t = turns * push.turn();
  return push;
}

/// How far off a simulation is, mm: a ball that cannot turn, so that it slides as a box does, on a slope along x.
Real off(const Push& push, int substeps, const Answer& answer) {
  constexpr int frames = 30;
  const Real h = Real(1) / static_cast<Real>(60 * substeps), slope = static_cast<Real>(push.slope);
  World world;
  world.gravity = -static_cast<Real>(g) * Vec3(std::sin(slope), std::cos(slope), 0);
  world.add(ground());
  world.add(sphere(Real(0.5), 2).at({0, Real(0.5), 0}).moving({static_cast<Real>(push.speed), 0, 0}));
  Body& ball = world.bodies[1];
  ball.inverse_inertia.setZero();
  Contact contact;
  contact.normal = {0, 1, 0};
  contact.friction = static_cast<Real>(push.mu);
  contact.id = {0, 1, 0};
  world.contacts = {contact};
  Solver<Clamping, FrictionCone> solver;
  for (int step = 0; step < frames * substeps; ++step) {
    integrate_velocity(ball, world.gravity, h);
    solver.solve(world, h, 1);
    ball.position += h * ball.velocity;
  }
  const double true_way = answer.way(push.speed, push.slope, push.mu, frames / 60.0);
  return 1000 * std::abs(ball.position.x() - static_cast<Real>(true_way));
}

std::vector<Check<Answer>> checks() {
  return {
      {"on the way up, its weight and friction brake it",
       1,
       {{"on its way up your box is at", "m", 1e-6}},
       [](Random& random, const Answer& answer) -> Numbers {
         return {push_of(random, between(random, 0.3, 0.7), between(random, 0.4, 0.9)).asked(answer)};
       }},
      {"where friction holds it, it stays",
       1,
       {{"long after it has stopped, your box, which friction holds, is at", "m", 1e-6},
        {"your box that starts at rest, and that friction holds, is at", "m", 1e-6}},
       [](Random& random, const Answer& answer) -> Numbers {
         const Push stays = push_of(random, between(random, 1.2, 1.6), between(random, 2, 3));
         Push rests = stays;
         rests.speed = 0;
         return {stays.asked(answer), rests.asked(answer)};
       }},
      {"where friction does not hold it, it slides back",
       2,
       {{"after it has stopped your box, which slides back, is at", "m", 1e-6},
        {"your box, which slides back and which friction nearly holds, is at", "m", 1e-6},
        {"your box that starts at rest, and that friction does not hold, is at", "m", 1e-6},
        {"your box on a steep slope, which slides back, is at", "m", 1e-6},
        {"your box on a gentle slope, which slides back, is at", "m", 1e-6}},
       [](Random& random, const Answer& answer) -> Numbers {
         const Push back = push_of(random, between(random, 0.3, 0.6), between(random, 3, 4));
         Push nearly = push_of(random, 1, 0), starts = push_of(random, between(random, 0.3, 0.6), 0);
         const double part = between(random, 0.3, 0.7);
         nearly.mu = part * std::sin(nearly.slope) + (1 - part) * std::tan(nearly.slope);
         nearly.t = between(random, 3, 4) * nearly.turn();
         starts.speed = 0;
         starts.t = between(random, 0.5, 1);
         Numbers numbers{back.asked(answer), nearly.asked(answer), starts.asked(answer)};
         for (const double slope : {between(random, 0.95, 1.1), between(random, 0.2, 0.4)}) {
           Push push{between(random, 2, 4), slope, 0.92 * std::tan(slope), 0};
           push.t = between(random, 3, 4) * push.turn();
           numbers.push_back(push.asked(answer));
         }
         return numbers;
       }},
      {"without friction it comes back as it went",
       1,
       {{"without friction your box is on its way back at", "m", 1e-6}},
       [](Random& random, const Answer& answer) -> Numbers {
         return {push_of(random, 0, between(random, 1.2, 1.8)).asked(answer)};
       }},
      {"a solver comes nearer to it with shorter steps",
       1,
       {{"a simulation with 2 substeps is away from your truth by", "mm", 1e-2},
        {"a simulation with 8 substeps is away from your truth by", "mm", 1e-2}},
       [](Random& random, const Answer& answer) -> Numbers {
         Push push = push_of(random, between(random, 0.1, 0.3), 0);
         push.speed = between(random, 1, 2);  // it has stopped after 0.3 s at most
         return {off(push, 2, answer), off(push, 8, answer)};
       }},
  };
}

/// With these accelerations down the slope, m/s^2, on the way up and on the way back.
double way_of(double speed, double up, double back, bool held, double t) {
  const double turn = speed / up;
  if (t < turn) return speed * t - up * t * t / 2;
  const double top = speed * speed / (2 * up);
  return held ? top : top - back * (t - turn) * (t - turn) / 2;
}

/// What pulls down the slope, and what friction can do, m/s^2.
struct Pulls {
  double pull, rub;
  Pulls(double slope, double mu) : pull(g * std::sin(slope)), rub(g * mu * std::cos(slope)) {}
  bool held() const { return rub >= pull; }
};

double right(double speed, double slope, double mu, double t) {
  const Pulls its(slope, mu);
  return way_of(speed, its.pull + its.rub, its.pull - its.rub, its.held(), t);
}

std::vector<Mistake<Answer>> mistakes() {
  const std::string turns =
      "it looks as if friction pulled down the slope all the time. It opposes the motion: once the box slides back, "
      "friction pulls up.";
  return {
      {"friction does not turn round", turns, {[](double speed, double slope, double mu, double t) {
         const Pulls its(slope, mu);
         return way_of(speed, its.pull + its.rub, its.pull + its.rub, false, t);
       }}},
      {"friction does not turn round", turns, {[](double speed, double slope, double mu, double t) {
         const Pulls its(slope, mu);
         return way_of(speed, its.pull + its.rub, its.pull + its.rub, its.held(), t);
       }}},
      {"never held",
       "it looks as if nothing ever held the box. Where μ > tan of the slope, friction can bear all that pulls it "
       "down, and bears just that: it is no force that moves a box up.",
       {[](double speed, double slope, double mu, double t) {
         const Pulls its(slope, mu);
         return way_of(speed, its.pull + its.rub, its.pull - its.rub, false, t);
       }}},
      {"always held",
       "it looks as if a box that has stopped always stayed. Friction bears no more than μ m g cos of the slope; where "
       "its weight pulls more than that, it slides back.",
       {[](double speed, double slope, double mu, double t) {
         const Pulls its(slope, mu);
         return way_of(speed, its.pull + its.rub, 0, true, t);
       }}},
      {"held the wrong way round",
       "it looks as if μ and the slope were compared the wrong way round. It is a rough box that stays.",
       {[](double speed, double slope, double mu, double t) {
         const Pulls its(slope, mu);
         return way_of(speed, its.pull + its.rub, its.pull - its.rub, !its.held(), t);
       }}},
      {"μ compared with the sine",
       "it looks as if μ were compared with the sine of the slope. On a slope the box presses with m g cos only, so "
       "that its tangent counts.",
       {[](double speed, double slope, double mu, double t) {
         const Pulls its(slope, mu);
         return way_of(speed, its.pull + its.rub, its.pull - its.rub, g * mu >= its.pull, t);
       }}},
      {"time from the start",
       "it looks as if the time of the way back were counted from the start. It slides back from rest, at the moment "
       "at which it stopped.",
       {[](double speed, double slope, double mu, double t) {
         const Pulls its(slope, mu);
         const double up = its.pull + its.rub, turn = speed / up;
         if (t < turn || its.held()) return way_of(speed, up, 0, true, t);
         return speed * turn / 2 - (its.pull - its.rub) * t * t / 2;
       }}},
      {"the top forgotten",
       "it looks as if the way back were counted from the start's place. It slides back from where it stopped, v² / 2a "
       "further up.",
       {[](double speed, double slope, double mu, double t) {
         const Pulls its(slope, mu);
         const double up = its.pull + its.rub, top = speed * speed / (2 * up);
         const double found = way_of(speed, up, its.pull - its.rub, its.held(), t);
         return t < speed / up || its.held() ? found : found - top;
       }}},
      {"the weight for the pressing force",
       "it looks as if friction were μ m g. On a slope the box presses with m g cos of the slope only.",
       {[](double speed, double slope, double mu, double t) {
         const double pull = g * std::sin(slope), rub = g * mu;
         return way_of(speed, pull + rub, pull - rub, rub >= pull, t);
       }}},
      {"the weight for the pressing force",
       "it looks as if friction were μ m g. On a slope the box presses with m g cos of the slope only.",
       {[](double speed, double slope, double mu, double t) {
         const double pull = g * std::sin(slope), rub = g * mu;
         return way_of(speed, pull + rub, pull - rub, mu >= std::tan(slope), t);
       }}},
      {"sine and cosine exchanged",
       "it looks as if sine and cosine were exchanged. On flat ground, nothing pulls along the slope, and all of the "
       "weight presses.",
       {[](double speed, double slope, double mu, double t) {
         const double pull = g * std::cos(slope), rub = g * mu * std::sin(slope);
         return way_of(speed, pull + rub, pull - rub, rub >= pull, t);
       }}},
      {"sine and cosine exchanged",
       "it looks as if sine and cosine were exchanged. On flat ground, nothing pulls along the slope, and all of the "
       "weight presses.",
       {[](double speed, double slope, double mu, double t) {
         const double pull = g * std::cos(slope), rub = g * mu * std::sin(slope);
         return way_of(speed, pull + rub, pull - rub, mu >= std::tan(slope), t);
       }}},
      {"no weight on the way up",
       "it looks as if only friction braked the box on its way up, as on flat ground. Its weight pulls it down the "
       "slope as well.",
       {[](double speed, double slope, double mu, double t) {
         const Pulls its(slope, mu);
         if (its.rub <= 0) return speed * t;
         return way_of(speed, its.rub, its.pull - its.rub, its.held(), t);
       }}},
      {"no friction on the way up",
       "it looks as if only its weight braked the box on its way up. Friction opposes the motion, upwards too.",
       {[](double speed, double slope, double mu, double t) {
         const Pulls its(slope, mu);
         return way_of(speed, its.pull, its.pull - its.rub, its.held(), t);
       }}},
      {"½ forgotten",
       "it looks as if ½ were forgotten before a t². The mean speed of a motion that starts or ends at rest is half of "
       "its largest.",
       {[](double speed, double slope, double mu, double t) {
         const Pulls its(slope, mu);
         const double up = its.pull + its.rub, back = its.pull - its.rub, turn = speed / up;
         if (t < turn) return speed * t - up * t * t;
         return speed * turn - up * turn * turn - (its.held() ? 0 : back * (t - turn) * (t - turn));
       }}},
  };
}

}  // namespace

Numbers play(std::size_t check, Random& random, const Answer& answer) {
  return checks()[check].play(random, answer);
}

Exercise exercise() {
  return exercise_of<Answer>(
      "a truth of one's own",
      {"Three motions: up, held, back. Which force acts along the slope in each, and when does one end?",
       "A truth knows no steps. Work out when the box stops and how far up it is then; the way back begins there, at "
       "that moment.",
       "Whether it is held is a question of two forces: what pulls it down the slope, and the most that friction can "
       "bear."},
      checks(), {right}, mistakes());
}

}  // namespace pushback::exercise_19_transfer
