/// The same bits, whoever does the work: any number of threads, and parts in any order.
#include <numeric>
#include <set>

#include "pushback/common/basics/input.h"
#include "pushback/common/bodies/random.h"
#include "pushback/common/collision/broad_phase.h"
#include "pushback/common/world/any_solver.h"
#include "pushback/common/world/measure.h"
#include "pushback/common/world/situations.h"
#include "pushback/engine/substeps/thread_pool.h"
#include "pushback/engine/substeps/wide_solver.h"
#include "pushback/tools/catalogue/catalogue.h"
#include "tests/support/catch.h"
#include "tests/support/yardstick.h"

using namespace pushback;

namespace {

/// Parts one after the other in an order that is another each time: what depends on the order shows, whatever the machine does.
class InAnyOrder : public Workers {
 public:
  explicit InAnyOrder(std::size_t parts) : Workers(parts, true) {}

 private:
  void share(std::size_t count, const std::function<void(std::size_t)>& act) override {
    std::vector<std::size_t> order(count);
    std::iota(order.begin(), order.end(), 0);
    random_.shuffle(order);
    for (const std::size_t k : order) act(k);
  }
  Random random_{1};
};

template <class Scalar>
WideSolver<Scalar> wide_with(std::shared_ptr<Workers> pool, int substeps = 4) {
  WideSolver<Scalar> solver;
  solver.substeps = substeps;
  solver.workers = std::move(pool);
  return solver;
}

/// What a world is like after some steps, the impulses in its contacts included.
std::vector<std::uint64_t> bits_of(const World& world) {
  std::vector<std::uint64_t> bits{hash_of(world), world.contacts.size()};
  for (const Contact& contact : world.contacts)
    for (const Real number : {contact.impulse.x(), contact.impulse.y(), contact.impulse.z(), contact.depth})
      bits.push_back(std::bit_cast<std::conditional_t<in_double, std::uint64_t, std::uint32_t>>(number));
  return bits;
}

/// Boxes, balls and capsules in a heap.
void heap(World& world) {
  Random random(3);
  world.add(ground());
  for (int i = 0; i < 300; ++i) {
    const Vec3 place{static_cast<Real>(i % 6), 1 + static_cast<Real>(i / 36) * Real(0.9), static_cast<Real>(i / 6 % 6)};
    world.add(random.body(10).at(place + random.vector(Real(0.1))).moving(random.vector(1)));
  }
}

}  // namespace

TEST_CASE("threads: every scene moves in the same bits with 1, 2, 3, 4 and 7 threads, and with parts in any order") {
  std::vector<std::shared_ptr<Workers>> pools;
  for (const int threads : {1, 2, 3, 4, 7}) pools.push_back(std::make_shared<ThreadPool>(threads, true));
  for (const std::size_t parts : {2, 5}) pools.push_back(std::make_shared<InAnyOrder>(parts));
  for (const NamedScene& scene : all_scenes()) {
    World world;
    scene.fill(world);
    WideSolver<float> alone = wide_with<float>(nullptr);
    for (int stretch = 0; stretch < 4; ++stretch) {
      const World begin = world;
      for (int i = 0; i < 2; ++i) world.step(alone, h);
      const auto expected = bits_of(world);
      for (std::size_t k = 0; k < pools.size(); ++k) {
        INFO(scene.name << ", pool " << k << ", from " << begin.time << " s on");
        World copy = begin;
        WideSolver<float> shared = wide_with<float>(pools[k]);
        for (int i = 0; i < 2; ++i) copy.step(shared, h);
        REQUIRE(bits_of(copy) == expected);
      }
      for (int i = 0; i < 28; ++i) world.step(alone, h);
    }
  }
}

TEST_CASE("threads: detection finds the same contacts in the same order, whoever looks") {
  World world;
  heap(world);
  const Margin margin{.least = Real(0.02), .ahead = h};
  const std::vector<BodyPair> pairs = near_pairs(world.bodies, margin);
  REQUIRE(pairs.size() > 600);
  world.find_contacts(margin);
  REQUIRE(world.contacts.size() > 300);
  const auto expected = bits_of(world);
  InAnyOrder five(5);
  ThreadPool three(3, true);
  for (Workers* workers : {static_cast<Workers*>(&five), static_cast<Workers*>(&three)}) {
    CHECK(near_pairs(world.bodies, margin, *workers) == pairs);
    world.find_contacts(margin, *workers);
    CHECK(bits_of(world) == expected);
  }
}

TEST_CASE("threads: each item is done once, whatever their number, and little is done alone") {
  for (const int threads : {1, 2, 3, 7}) {
    ThreadPool pool(threads);
    CHECK(pool.threads() == threads);
    for (const std::size_t items : {0, 1, 9, 10, 19, 20, 21, 64, 1000}) {
      std::vector<int> done(items, 0);
      std::vector<std::size_t> lengths(pool.parts(items, 10), 0);
      pool.each(items, 10, [&](Part part) {
        lengths[part.index] += part.end - part.begin;
        for (std::size_t i = part.begin; i < part.end; ++i) ++done[i];
      });
      CHECK(done == std::vector<int>(items, 1));
      CHECK(lengths.size() ==
            std::clamp<std::size_t>(items / 10, 1, threads == 1 ? 1 : 4 * static_cast<std::size_t>(threads)));
      if (lengths.size() > 1) CHECK(*std::min_element(lengths.begin(), lengths.end()) >= 10);
    }
  }
}

TEST_CASE("threads: a call of a pool that is at work elsewhere does its parts alone, at once") {
  ThreadPool pool(2);
  std::atomic<bool> begun = false, go_on = false;
  std::thread elsewhere([&] {
    pool.each(2, 1, [&](Part) {
      for (begun = true; !go_on;) std::this_thread::yield();
    });
  });
  while (!begun) std::this_thread::yield();
  std::set<std::thread::id> who;
  pool.each(2, 1, [&](Part) { who.insert(std::this_thread::get_id()); });
  go_on = true;
  elsewhere.join();
  CHECK(who == std::set{std::this_thread::get_id()});
}

TEST_CASE("threads: what fails in a part fails where it was called, the first part first, and the pool goes on") {
  ThreadPool pool(4);
  for (int i = 0; i < 20; ++i) {
    try {
      pool.each(4, 1, [&](Part part) {
        if (part.index > 0) throw InvalidInput(fmt::format("part {}", part.index));
      });
      FAIL("nothing was thrown");
    } catch (const InvalidInput& failed) {
      CHECK(std::string(failed.what()) == "part 1");
    }
  }
  int sum = 0;
  pool.each(1, 1, [&](Part) { ++sum; });
  CHECK(sum == 1);
}

TEST_CASE("threads: a part rounds as who calls does") {
  ThreadPool pool(3);
  const auto thirds = [&] {
    std::vector<double> found(3);
    pool.each(3, 1, [&](Part part) {
      volatile double one = 1, three = 3;
      found[part.index] = one / three;
      std::this_thread::sleep_for(std::chrono::milliseconds(1));  // so that others come to their parts
    });
    return found;
  };
  const std::vector<double> nearest = thirds();
  CHECK(nearest == std::vector<double>(3, 1.0 / 3));
  std::fesetround(FE_UPWARD);
  const std::vector<double> up = thirds();
  std::fesetround(FE_TONEAREST);
  CHECK(up == std::vector<double>(3, std::nextafter(1.0 / 3, 1)));
  CHECK(thirds() == nearest);
}

TEST_CASE("threads: a pool of no threads is refused, and so is one of too many") {
  for (const int threads : {-1, 0, ThreadPool::most_threads + 1})
    CHECK_THROWS_WITH(ThreadPool(threads),
                      fmt::format("the number of threads is {}: a whole number from 1 to {} is needed", threads,
                                  ThreadPool::most_threads));
}

TEST_CASE("threads: a pool is all that a program adds") {
  World world;
  heap(world);
  WideSolver<float> solver;
  solver.workers = std::make_shared<ThreadPool>(2);
  world.step(solver, 1.0 / 60);
  CHECK(world.time == Approx(1.0 / 60));
}
