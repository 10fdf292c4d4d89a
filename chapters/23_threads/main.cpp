#include "pushback/chapters/23_threads/study.h"
#include "pushback/common/experiment/experiment.h"
#include "pushback/common/experiment/marks.h"
#include "pushback/common/render/palette.h"
#include "pushback/common/world/steps_in.h"
#include "pushback/engine/substeps/thread_pool.h"

using namespace pushback;
using namespace pushback::threads_scenes;

namespace {

PairSets sets_in(const World& world) {
  return colour_pairs(touching_pairs(world.contacts), world);
}

/// From dark to light, unlike chapter 22's colours, which stand for sets.
Ink ink_of_thread(std::size_t thread) {
  constexpr std::array<Ink, 4> inks{{{21, 24, 43}, {190, 70, 10}, {255, 184, 77}, {255, 255, 255}}};
  return inks[thread % inks.size()];
}

std::vector<std::pair<Ink, std::string>> colours_of(int threads) {
  std::vector<std::pair<Ink, std::string>> colours;
  for (int i = 0; i < std::min(threads, 4); ++i)
    colours.emplace_back(ink_of_thread(static_cast<std::size_t>(i)), fmt::format("thread {}", i + 1));
  return colours;
}

/// Draws the set with this number: lines, in front of boxes of 1 m, from the middle of each box of a pair to their contact.
void draw_set(Picture& picture, const World& world, std::size_t set, std::size_t threads, const Vec3& shift) {
  const PairSets sets = sets_in(world);
  if (set >= sets.size()) return;
  for (std::size_t k = 0; k < sets[set].size(); ++k) {
    const TouchingPair& pair = sets[set][k];
    const std::size_t thread = thread_of(k / lanes_per_bundle, bundles_of(sets[set]), threads);
    Vec3 touch = Vec3::Zero();
    for (std::size_t i = 0; i < pair.count; ++i)
      touch += world.contacts[pair.first + i].point / static_cast<Real>(pair.count);
    touch.z() = Real(0.55);
    for (const std::size_t body : {pair.a, pair.b}) {
      if (!world.bodies[body].movable()) continue;
      const Vec3& middle = world.bodies[body].position;
      add_line(picture, {Vec3(middle.x(), middle.y(), touch.z()) + shift, touch + shift}, linear(ink_of_thread(thread)),
               6);
    }
  }
}

/// A pool of threads. In a page, which has only one thread, that one does the parts of all, the last first, with the same bits.
std::shared_ptr<Workers> pool_of(int threads, [[maybe_unused]] bool always_split = false) {
#ifdef __EMSCRIPTEN__
  return std::make_shared<OneAfterTheOther>(4 * static_cast<std::size_t>(threads), true);
#else
  return std::make_shared<ThreadPool>(threads, always_split);
#endif
}

/// A world to compare others with. It continues from the time of the last call.
class Beside {
 public:
  Beside(std::function<void(World&)> fill, WideSolver<float> solver)
      : fill_(std::move(fill)), solver_(std::move(solver)) {}

  const World& after(Real seconds, Real dt) {
    const int steps = steps_in(seconds, dt);
    if (steps < done_ || done_ == 0) {
      world_ = World();
      fill_(world_);
      done_ = 0;
    }
    for (; done_ < steps; ++done_) world_.step(solver_, dt);
    return world_;
  }

 private:
  std::function<void(World&)> fill_;
  WideSolver<float> solver_;
  World world_;
  int done_ = 0;
};

/// The largest possible speedup of a pass over a pyramid, against its number of boxes.
Panel at_best_by_boxes(const std::vector<int>& threads) {
  Panel panel{.title = "a pass over a pyramid, counted in bundles",
              .x_label = "boxes",
              .y_label = "times as fast, at best",
              .log_x = true};
  for (std::size_t k = 0; k < threads.size(); ++k) {
    Curve& curve = panel.curves.emplace_back();
    curve.label = fmt::format("{} threads", threads[k]);
    curve.colour = line_colour(k);
    curve.style = Curve::Style::line_and_points;
    for (const int base : {3, 5, 8, 12, 16, 20, 26, 34, 44}) {
      World world;
      pyramid(world, base);
      world.find_contacts();
      curve.x.push_back(static_cast<Real>(world.bodies.size() - 1));
      curve.y.push_back(at_best(sets_in(world), static_cast<std::size_t>(threads[k])));
    }
  }
  return panel;
}

}  // namespace

int main(int argc, char** argv) {
  Experiment e("23_threads", "What do threads wait for?");
  int substeps = 8;
  e.parameter({"--substeps", "", "", "Substeps per step", 1, 128}, &substeps);
  int base = 14;
  e.parameter({"--base", "n", "", "Boxes in the pyramid's lowest row", 1, 20}, &base);
  int threads = 4;
  e.parameter({"--threads", "T", "", "Number of threads in the picture", 1, 16}, &threads);
  return e.run(argc, argv, [&] {
    const auto fill_pyramid = [base](World& world) {
      pyramid(world, base);
      for (Body& body : world.bodies)
        if (body.movable()) body.coloured(1);
    };
    const auto wide_with = [substeps](std::shared_ptr<Workers> pool) {
      WideSolver<float> solver;
      solver.substeps = substeps;
      solver.workers = std::move(pool);
      return solver;
    };
    const Real wide = static_cast<Real>(base), apart = wide + 2;
    constexpr Real every = Real(0.25);  // s per set

    e.scene({.name = "four sets of a pyramid",
             .fill = fill_pyramid,
             .camera = {{Real(1.5) * apart, Real(0.47) * wide, 8 * wide},
                        {Real(1.5) * apart, Real(0.47) * wide, 0},
                        Real(0.162)},
             .seconds = 1,
             .contacts = Drawn::nothing,
             .caption =
                 "The same pyramid four times, with the pairs of its first, second, third and fourth set. Each line is "
                 "a pair of touching boxes, in the colour of its thread. Thread 1 solves eight pairs of each set, and "
                 "then waits for the threads that solve sixteen.",
             .colours = colours_of(threads),
             .start_shown = false,
             .marks =
                 [threads, apart](Picture& picture, const World& world, Real time) {
                   // In a page the sets appear one after the other, the first from the start.
                   const auto here = std::clamp<std::size_t>(static_cast<std::size_t>(time / every + Real(0.01)), 1, 4);
                   for (std::size_t set = 0; set < here; ++set)
                     draw_set(picture, world, set, static_cast<std::size_t>(threads),
                              static_cast<Real>(set) * apart * Vec3::UnitX());
                 },
             .strobe = Strobe{.every = every,
                              .shift_per_second = {apart / every, 0, 0},
                              .from = every,
                              .height = 420,
                              .note = "the sets, in the order in which they are solved"}});
    e.variant(fmt::format("{} threads", threads), wide_with(pool_of(threads)))
        .with_exactly(1)
        .coloured(1)
        .without_curves();
    e.number("sets", "", [](const Run& run) { return static_cast<Real>(sets_in(run.world).size()); });
    e.number("bundles", "", [](const Run& run) {
      Real count = 0;
      for (const auto& set : sets_in(run.world)) count += static_cast<Real>(bundles_of(set));
      return count;
    });
    e.number("times as fast, at best", "",
             [threads](const Run& run) { return at_best(sets_in(run.world), static_cast<std::size_t>(threads)); });

    e.scene({.name = "other numbers of threads", .fill = fill_pyramid, .seconds = 1, .pictures = false});
    const auto alone = std::make_shared<Beside>(fill_pyramid, wide_with(nullptr));
    e.number("bodies elsewhere than with one thread", "",
             [alone](const Run& run) { return elsewhere(run.world, alone->after(run.world.time, run.dt)); });
    for (const int count : {2, 3, 4, 7})
      e.variant(fmt::format("{} threads", count), wide_with(pool_of(count, true))).with_exactly(1).without_curves();

    e.study([=, &e] {
      const auto of_parts = [&](PairSets (*make_sets)(const std::vector<TouchingPair>&, const World&),
                                bool from_the_last) -> World {
        WideSolver<float> solver = wide_with(std::make_shared<OneAfterTheOther>(4, from_the_last));
        solver.make_sets = make_sets;
        return Beside(fill_pyramid, solver).after(e.dt(), e.dt());
      };
      const Real by_colours = elsewhere(of_parts(colour_pairs, true), of_parts(colour_pairs, false)),
                 in_one_set = elsewhere(of_parts(all_in_one, true), of_parts(all_in_one, false));
      e.remark(fmt::format(
          "Each set has four parts, which are solved from the last to the first instead of from the first to the "
          "last. After one step {} of {} boxes differ by colours, and {} if all pairs are one set.",
          by_colours, base * (base + 1) / 2, in_one_set));
      e.panel(at_best_by_boxes({2, 4, 8}));
    });
  });
}
