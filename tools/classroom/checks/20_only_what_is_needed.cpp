#include "pushback/chapters/20_only_what_is_needed/exercise/asked.h"
#include "pushback/common/world/islands.h"

namespace pushback::exercise_20 {

namespace {

/// Boxes on the ground, which is the first body, and who of them rests.
struct Piles {
  World world;
  std::vector<bool> rests{true};
  Random& random;

  explicit Piles(Random& its_random) : random(its_random) { world.add(ground()); }

  int add(bool resting) {
    rests.push_back(resting);
    return world.add(box(Vec3::Constant(Real(0.5)), random.between(10, 100)));
  }
  void touch(int a, int b) {
    const auto first = static_cast<std::uint32_t>(std::min(a, b)), second = static_cast<std::uint32_t>(std::max(a, b));
    world.contacts.push_back({.id = {first, second, 0}});
  }
  void join(int a, int b) { world.joints.push_back({.name = "a rope", .a = a, .b = b, .ask = {}}); }
  /// From the ground up; the last is the top.
  int pile(std::size_t boxes, bool resting) {
    int below = 0;
    for (; boxes > 0; --boxes) {
      const int above = add(resting);
      touch(below, above);
      below = above;
    }
    return below;
  }
  /// What nothing moves has no weight here.
  std::vector<Reading> asleep(const Answer& answer) const {
    const std::vector<bool> sleeps = answer.asleep(world, rests);
    Real count = 0, mass = 0;
    for (std::size_t i = 0; i < world.bodies.size(); ++i) {
      if (!sleeps.at(i)) continue;
      ++count;
      if (world.bodies[i].movable()) mass += 1 / world.bodies[i].inverse_mass;
    }
    return {{"the number of bodies asleep is", count},
            {"the total mass of the sleeping bodies in your world is", mass, "kg", 1e-3}};
  }
};

std::vector<bool> right(const World& world, const std::vector<bool>& rests) {
  std::vector<int> island(world.bodies.size());
  std::iota(island.begin(), island.end(), 0);
  Islands islands;
  islands.separate(island, island.size());
  islands.join(world.contacts, world);
  islands.join(world.joints, world);
  for (int& one : island) one = islands.island_of(one);
  std::vector<bool> sleeps(rests.size());
  for (std::size_t i = 0; i < rests.size(); ++i) {
    sleeps[i] = world.bodies[i].movable();
    for (std::size_t j = 0; j < rests.size(); ++j)
      if (island[j] == island[i] && !rests[j]) sleeps[i] = false;
  }
  return sleeps;
}

}  // namespace

std::vector<Check<Answer>> checks_of(const Answer& /*any*/) {
  return {
      {"a resting pile sleeps although another one on the same ground moves", 1,
       [](Random& random, const Answer& answer) -> std::vector<Reading> {
         Piles piles(random);
         piles.pile(2 + random.below(3), true);
         piles.pile(2 + random.below(3), false);
         piles.pile(1, true);
         return piles.asleep(answer);
       },
       "the ground does not connect islands, because nothing moves it. Each pile on it is an island of its own, and so "
       "is a single box."},
      {"no body of a pile sleeps while the top moves", 1,
       [](Random& random, const Answer& answer) -> std::vector<Reading> {
         Piles piles(random);
         for (const std::size_t boxes : {4 + random.below(3), std::size_t(2)})
           piles.rests[static_cast<std::size_t>(piles.pile(boxes, true))] = false;
         piles.pile(2 + random.below(2), true);
         return piles.asleep(answer);
       },
       "an island sleeps and wakes as a whole. If one of its bodies moves, none of them sleeps. Otherwise the bodies "
       "on top could hang in mid-air."},
      {"the order of the contacts does not matter", 1,
       [](Random& random, const Answer& answer) -> std::vector<Reading> {
         Piles piles(random);
         const int first = piles.add(false);
         for (int i = 1; i < 6; ++i) piles.add(true);  // a row on the ground
         for (const int i : {0, 2, 4, 3, 1}) piles.touch(first + i, first + i + 1);
         for (int i = 0; i < 6; ++i) piles.touch(0, first + i);
         const int middle = piles.add(true), moves = piles.add(false), far = piles.add(true);
         piles.touch(middle, far);
         piles.touch(middle, moves);
         piles.pile(2, true);
         return piles.asleep(answer);
       },
       "an island contains all bodies that you can reach from body to body, over any number of contacts and in any "
       "order of the contacts."},
      {"joined bodies sleep and wake together, but bodies that hang on the same fixed beam need not", 1,
       [](Random& random, const Answer& answer) -> std::vector<Reading> {
         Piles piles(random);
         const int beside = piles.pile(1, true), moves = piles.pile(1, false), towed = piles.pile(1, true),
                   beam = piles.add(true);
         piles.join(moves, towed);
         const int next_to_it = piles.pile(1, true), last = piles.pile(1, true);  // towed in turn, and pushed
         piles.touch(towed, next_to_it);
         piles.join(last, next_to_it);
         piles.touch(beside, last);
         piles.world.bodies[static_cast<std::size_t>(beam)].fixed();
         piles.join(beam, piles.add(false));
         piles.join(piles.add(true), beam);
         const int turning = piles.add(false);  // by itself: fixed, and never at rest
         piles.world.bodies[static_cast<std::size_t>(turning)].fixed();
         piles.touch(turning, piles.add(true));
         piles.join(piles.add(true), turning);
         return piles.asleep(answer);
       },
       "a joint connects two bodies just as a contact does. A body that nothing moves does not connect islands, and "
       "does not sleep."},
  };
}

Exercise exercise() {
  return rebuild_of(
      "islands",
      {"Give each body a number, at first its own index. In the end, bodies of one island should have the same number.",
       "For each contact and each joint of two movable bodies with different numbers, give one number to all bodies "
       "that have the other one, not only to the two that touch.",
       "An island is awake if one of its movable bodies does not rest. All other movable bodies sleep."},
      Answer{right});
}

}  // namespace pushback::exercise_20
