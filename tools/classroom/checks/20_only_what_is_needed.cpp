#include "pushback/chapters/20_only_what_is_needed/exercise/asked.h"
#include "pushback/chapters/20_only_what_is_needed/islands.h"
#include "pushback/common/exercise/shown.h"

namespace pushback::exercise_20 {

namespace {

/// Boxes on the ground, which is the first body, and who of them rests.
struct Piles {
  World world;
  std::vector<bool> rests{true};
  Random& random;
  Real x = 0;  ///< m, of the latest pile

  explicit Piles(Random& its_random) : random(its_random) { world.add(ground()); }

  int add(bool resting, bool on_top = false) {
    rests.push_back(resting);
    if (!on_top) x += Real(1.6);
    const Real y = on_top ? world.bodies.back().position.y() + 1 : Real(0.5);  // for the eye: nothing here asks where
    return world.add(box(Vec3::Constant(Real(0.5)), random.between(10, 100)).at({x, y, 0}));
  }
  void touch(int a, int b) {
    Contact contact;
    const Vec3 at_b = world.body(b).position;
    contact.point = a == 0 ? Vec3(at_b.x(), 0, 0) : Vec3((world.body(a).position + at_b) / 2);
    contact.normal = {0, 1, 0};
    contact.id = {static_cast<std::uint32_t>(std::min(a, b)), static_cast<std::uint32_t>(std::max(a, b)), 0};
    world.contacts.push_back(contact);
  }
  void join(int a, int b) {
    const auto line = [](const Body& one, const Body& other) {
      return std::vector<Vec3>{one.position, other.position};
    };
    world.joints.push_back({.name = "a rope", .a = a, .b = b, .ask = {}, .line = line});
  }
  /// From the ground up; the last is the top.
  int pile(std::size_t boxes, bool resting) {
    int below = 0;
    for (; boxes > 0; --boxes) {
      const int above = add(resting, below > 0);
      touch(below, above);
      below = above;
    }
    return below;
  }
  /// How many bodies sleep, and how heavy they are together, kg. What nothing moves has no weight here.
  Numbers asleep(const Answer& answer) const {
    const std::vector<bool> sleeps = answer.asleep(world, rests);
    World slept = world;
    for (std::size_t i = 0; i < world.bodies.size(); ++i) slept.bodies[i].asleep = sleeps.at(i);
    show(slept);
    Real count = 0, mass = 0;
    for (std::size_t i = 0; i < world.bodies.size(); ++i) {
      if (!sleeps.at(i)) continue;
      ++count;
      if (world.bodies[i].movable()) mass += 1 / world.bodies[i].inverse_mass;
    }
    return {count, mass};
  }
};

std::vector<Check<Answer>> checks() {
  const std::vector<Quantity> quantities{{"the number of bodies asleep is", "", 1e-9},
                                         {"those asleep in your world weigh together", "kg", 1e-3}};
  return {
      {"a pile that rests sleeps, though another on the same ground moves", 1, quantities,
       [](Random& random, const Answer& answer) -> Numbers {
         Piles piles(random);
         piles.pile(2 + random.below(3), true);
         piles.pile(2 + random.below(3), false);
         piles.pile(1, true);
         return piles.asleep(answer);
       }},
      {"nobody in a pile sleeps while its top moves", 1, quantities,
       [](Random& random, const Answer& answer) -> Numbers {
         Piles piles(random);
         for (const std::size_t boxes : {4 + random.below(3), std::size_t(2)})
           piles.rests[static_cast<std::size_t>(piles.pile(boxes, true))] = false;
         piles.pile(2 + random.below(2), true);
         return piles.asleep(answer);
       }},
      {"it does not matter in which order contacts come", 1, quantities,
       [](Random& random, const Answer& answer) -> Numbers {
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
       }},
      {"bodies that are joined sleep and wake together; those that hang on the same fixed beam need not", 1, quantities,
       [](Random& random, const Answer& answer) -> Numbers {
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
       }},
  };
}

bool any_pair(const World&, int, int) {
  return true;
}

bool both_movable(const World& world, int a, int b) {
  return world.body(a).movable() && world.body(b).movable();
}

int body_a(const Contact& contact) {
  return static_cast<int>(contact.id.body_a);
}

int body_b(const Contact& contact) {
  return static_cast<int>(contact.id.body_b);
}

/// Of what touches and what is joined, those pairs that are linked.
template <class OfContact, class OfJoint>
std::vector<std::pair<int, int>> links(const World& world, const OfContact& of_contact, const OfJoint& of_joint) {
  std::vector<std::pair<int, int>> found;
  for (const Contact& at : world.contacts)
    if (of_contact(world, body_a(at), body_b(at))) found.emplace_back(body_a(at), body_b(at));
  for (const Joint& joint : world.joints)
    if (of_joint(world, joint.a, joint.b)) found.emplace_back(joint.a, joint.b);
  return found;
}

/// The island of each body, linked by the chapter's own.
std::vector<int> islands_by(const World& world, const std::vector<std::pair<int, int>>& links) {
  std::vector<int> found(world.bodies.size());
  std::iota(found.begin(), found.end(), 0);
  Islands islands;
  islands.separate(found, found.size());
  for (const auto& [a, b] : links) islands.join(a, b);
  for (int& island : found) island = islands.island_of(island);
  return found;
}

std::vector<bool> sleeping(const World& world, const std::vector<bool>& rests, const std::vector<int>& islands) {
  std::vector<bool> sleeps(rests.size());
  for (std::size_t i = 0; i < rests.size(); ++i) {
    sleeps[i] = world.bodies[i].movable();
    for (std::size_t j = 0; j < rests.size(); ++j)
      if (islands[j] == islands[i] && !rests[j]) sleeps[i] = false;
  }
  return sleeps;
}

std::vector<bool> right(const World& world, const std::vector<bool>& rests) {
  std::vector<int> found(world.bodies.size());
  std::iota(found.begin(), found.end(), 0);
  Islands islands;
  islands.separate(found, found.size());
  islands.join(world.contacts, world);
  islands.join(world.joints, world);
  for (int& island : found) island = islands.island_of(island);
  return sleeping(world, rests, found);
}

bool never_linked(const World&, int, int) {
  return false;
}

/// Whoever rests is woken by these, gone through so often at most.
void wake(std::vector<bool>& awake, const std::vector<std::pair<int, int>>& by, int most) {
  bool changed = true;
  for (int i = 0; changed && i < most; ++i) {
    changed = false;
    for (const auto& [a, b] : by) {
      if (awake[std::size_t(a)] == awake[std::size_t(b)]) continue;
      awake[std::size_t(a)] = awake[std::size_t(b)] = changed = true;
    }
  }
}

template <int most_contacts, int most_joints>
std::vector<bool> woken(const World& world, const std::vector<bool>& rests) {
  std::vector<bool> awake = rests, sleeps(rests.size());
  awake.flip();
  wake(awake, links(world, both_movable, never_linked), most_contacts);
  wake(awake, links(world, never_linked, both_movable), most_joints);
  for (std::size_t i = 0; i < rests.size(); ++i) sleeps[i] = world.bodies[i].movable() && !awake[i];
  return sleeps;
}

std::vector<Mistake<Answer>> mistakes() {
  const std::string once =
      "it looks as if contacts and joints were not gone through to the end. Who is woken by a joint wakes who touches "
      "it, and so on: begin again until nobody is woken any more.";
  const std::string hand =
      "it looks as if two islands were joined by one body each. Who is joined brings along all of its island: each "
      "body that had the one number has to get the other.";
  return {
      {"not to the end", once, {woken<1000, 1>}},
      {"not to the end", once, {woken<1000, 1000>}},
      {"not to the end", once, {woken<1, 1>}},
      {"not to the end", once, {woken<2, 1>}},
      {"the first joint alone",
       "it looks as if joints after the first were left out. Each of world.joints holds two bodies together.",
       {[](const World& world, const std::vector<bool>& rests) {
         std::vector<std::pair<int, int>> found = links(world, both_movable, never_linked);
         if (!world.joints.empty() && both_movable(world, world.joints[0].a, world.joints[0].b))
           found.emplace_back(world.joints[0].a, world.joints[0].b);
         return sleeping(world, rests, islands_by(world, found));
       }}},
      {"a fixed body wakes",
       "it looks as if a body that nothing moves woke who touches it or hangs on it. It passes nothing on, and belongs "
       "to no island.",
       {[](const World& world, const std::vector<bool>& rests) {
         std::vector<bool> at_rest = rests;
         for (const auto& [a, b] : links(world, any_pair, any_pair)) {
           if (!world.body(a).movable() && !rests[std::size_t(a)]) at_rest[std::size_t(b)] = false;
           if (!world.body(b).movable() && !rests[std::size_t(b)]) at_rest[std::size_t(a)] = false;
         }
         return right(world, at_rest);
       }}},
      {"joined through the ground",
       "it looks as if bodies were joined through the ground. It passes nothing on: nothing moves it. Where it counts, "
       "a whole world is one island, and a marble keeps it awake.",
       {[](const World& world, const std::vector<bool>& rests) {
         return sleeping(world, rests, islands_by(world, links(world, any_pair, any_pair)));
       }}},
      {"joined through the ground",
       "it looks as if bodies were joined through the ground. It passes nothing on: nothing moves it. Where it counts, "
       "a whole world is one island, and a marble keeps it awake.",
       {[](const World& world, const std::vector<bool>& rests) {
         return sleeping(world, rests, islands_by(world, links(world, any_pair, both_movable)));
       }}},
      {"joined through what holds a joint",
       "it looks as if bodies were joined through a fixed one that holds them both. It passes nothing on, neither by "
       "contacts nor by joints.",
       {[](const World& world, const std::vector<bool>& rests) {
         return sleeping(world, rests, islands_by(world, links(world, both_movable, any_pair)));
       }}},
      {"half an island asleep",
       "it looks as if each body fell asleep by itself. When the one below it has slid away, it hangs asleep in "
       "mid-air. An island sleeps and wakes as a whole.",
       {[](const World& world, const std::vector<bool>& rests) {
         std::vector<bool> sleeps = rests;
         for (std::size_t i = 0; i < rests.size(); ++i) sleeps[i] = rests[i] && world.bodies[i].movable();
         return sleeps;
       }}},
      {"only neighbours",
       "it looks as if only those were kept awake that touch a moving body. A push goes on from them to the next: an "
       "island is all that can be reached, however many steps away.",
       {[](const World& world, const std::vector<bool>& rests) {
         std::vector<bool> sleeps = rests;
         for (std::size_t i = 0; i < rests.size(); ++i) sleeps[i] = rests[i] && world.bodies[i].movable();
         for (const auto& [a, b] : links(world, both_movable, both_movable)) {
           if (!rests[std::size_t(a)]) sleeps[std::size_t(b)] = false;
           if (!rests[std::size_t(b)]) sleeps[std::size_t(a)] = false;
         }
         return sleeps;
       }}},
      {"one body instead of its island", hand, {[](const World& world, const std::vector<bool>& rests) {
         std::vector<int> islands(rests.size());
         std::iota(islands.begin(), islands.end(), 0);
         for (const auto& [a, b] : links(world, both_movable, both_movable))
           islands[std::size_t(b)] = islands[std::size_t(a)];
         return sleeping(world, rests, islands);
       }}},
      {"one body instead of its island", hand, {[](const World& world, const std::vector<bool>& rests) {
         std::vector<int> islands(rests.size());
         std::iota(islands.begin(), islands.end(), 0);
         for (const auto& [a, b] : links(world, both_movable, both_movable))
           islands[std::size_t(a)] = islands[std::size_t(b)];
         return sleeping(world, rests, islands);
       }}},
      {"one body instead of its island", hand, {[](const World& world, const std::vector<bool>& rests) {
         std::vector<int> islands(rests.size());
         std::iota(islands.begin(), islands.end(), 0);
         for (const auto& [a, b] : links(world, both_movable, both_movable))
           islands[std::size_t(a)] = islands[std::size_t(b)] =
               std::min(islands[std::size_t(a)], islands[std::size_t(b)]);
         return sleeping(world, rests, islands);
       }}},
      {"joints forgotten",
       "it looks as if only what touches were joined. A rope pulls as a contact pushes: who is joined to a body that "
       "moves is not left alone.",
       {[](const World& world, const std::vector<bool>& rests) {
         return sleeping(world, rests,
                         islands_by(world, links(world, both_movable, [](const auto&...) { return false; })));
       }}},
      {"contacts forgotten",
       "it looks as if only what is joined were an island. What touches pushes: it belongs together, too.",
       {[](const World& world, const std::vector<bool>& rests) {
         return sleeping(world, rests,
                         islands_by(world, links(world, [](const auto&...) { return false; }, both_movable)));
       }}},
      {"one that rests is enough",
       "it looks as if an island fell asleep as soon as one of its bodies rests. The others would stop in mid-motion: "
       "all of them have to rest.",
       {[](const World& world, const std::vector<bool>& rests) {
         std::vector<bool> moves = rests;
         moves.flip();
         std::vector<bool> sleeps = sleeping(world, moves, islands_by(world, links(world, both_movable, both_movable)));
         for (std::size_t i = 0; i < rests.size(); ++i) sleeps[i] = !sleeps[i] && world.bodies[i].movable();
         return sleeps;
       }}},
      {"the ground asleep",
       "it looks as if what nothing moves fell asleep, too. The ground is in no island: it has nothing to sleep from.",
       {[](const World& world, const std::vector<bool>& rests) {
         std::vector<bool> sleeps = right(world, rests);
         for (std::size_t i = 0; i < rests.size(); ++i) sleeps[i] = sleeps[i] || !world.bodies[i].movable();
         return sleeps;
       }}},
      {"who is alone stays awake",
       "it looks as if a body that touches nothing but the ground stayed awake. It is an island of its own.",
       {[](const World& world, const std::vector<bool>& rests) {
         std::vector<bool> sleeps = right(world, rests), linked(rests.size(), false);
         for (const auto& [a, b] : links(world, both_movable, both_movable))
           linked[std::size_t(a)] = linked[std::size_t(b)] = true;
         for (std::size_t i = 0; i < rests.size(); ++i) sleeps[i] = sleeps[i] && linked[i];
         return sleeps;
       }}},
  };
}

}  // namespace

Numbers play(std::size_t check, Random& random, const Answer& answer) {
  return checks()[check].play(random, answer);
}

Exercise exercise() {
  return rebuild_of<Answer>(
      "islands",
      {"Give each body a number, at first its own index. Bodies of one island are to end with the same number.",
       "For each contact and each joint of two movable bodies with different numbers: everybody who has the one number "
       "gets the other, not only the two that touch.",
       "An island is awake if one of its movable bodies does not rest. All other movable bodies sleep."},
      checks(), {right}, mistakes());
}

}  // namespace pushback::exercise_20
