/// Frames per second of the renderer with everything on, and the share of shadows and multisampling in them.
#include <benchmark/benchmark.h>

#include "pushback/chapters/07_warm_start/full_solver.h"
#include "pushback/common/experiment/picture_of.h"
#include "pushback/common/render/context.h"
#include "pushback/common/render/drawing.h"
#include "pushback/common/render/painter.h"
#include "pushback/common/world/situations.h"
#include "pushback/tools/bench/in_turn.h"

using namespace pushback;

namespace {

/// A pyramid of 210 boxes with its contact points and impulses.
Picture busy_picture() {
  World world;
  pyramid(world, 20);
  FullSolver solver;
  for (int step = 0; step < 30; ++step) world.step(solver, Real(1) / 60, 10);
  return picture_of(world, {{8, 10, 26}, {0, 8, 0}}, fitting_arrow(world, Real(1) / 60));
}

void frame(benchmark::State& state) {
  const Picture picture = busy_picture();
  Painter painter(640, 360);
  for (auto _ : state) benchmark::DoNotOptimize(painter.draw(picture).pixels.data());
  state.counters["frames per second"] = benchmark::Counter(1, benchmark::Counter::kIsIterationInvariantRate);
}
BENCHMARK(frame)->Unit(benchmark::kMillisecond)->UseRealTime();

void still_of_sixteen_passes(benchmark::State& state) {
  const Picture picture = busy_picture();
  Painter painter(640, 360);
  for (auto _ : state) benchmark::DoNotOptimize(painter.draw_still(picture, 16).pixels.data());
}
BENCHMARK(still_of_sixteen_passes)->Unit(benchmark::kMillisecond)->UseRealTime()->Iterations(3);

/// A pass as the painter makes it, but for what is left out.
class Pass {
  static constexpr int width = 640, height = 360;
  Context context_;

 public:
  Lighting single = Lighting::of_single_pass(), one_of_many = Lighting::of_many_passes();

  explicit Pass(const Picture& picture) : frame_(picture) {
    glEnable(GL_FRAMEBUFFER_SRGB);
    glEnable(GL_DEPTH_CLAMP);
    plain_.make(width, height, 0);
    multisampled_.make(width, height, 4);
    drawing_.load(frame_);
  }
  /// s. `lighting`: with shadows, or nullptr.
  double seconds(Lighting* lighting, bool multisampling) {
    return seconds_of([&] {
      const Lights lights = lights_for(frame_, 0, 1);
      const Target& target = multisampling ? multisampled_ : plain_;
      drawing_.draw(frame_, target.handle, {0, 0, width, height}, lighting ? lights : Lights{lights.key, {}},
                    Eigen::Vector2f::Zero(), lighting ? *lighting : dark_);
      glDisable(GL_SCISSOR_TEST);
      if (multisampling) {
        glBindFramebuffer(GL_READ_FRAMEBUFFER, multisampled_.handle);
        glBindFramebuffer(GL_DRAW_FRAMEBUFFER, plain_.handle);
        glBlitFramebuffer(0, 0, width, height, 0, 0, width, height, GL_COLOR_BUFFER_BIT, GL_NEAREST);
      }
      glBindFramebuffer(GL_READ_FRAMEBUFFER, plain_.handle);
      glReadPixels(0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE, pixels_.data());
    });
  }

 private:
  Drawing drawing_;
  Frame frame_;
  // No map is looked at. One light still draws the bodies' corners onto a map of one pixel.
  Lighting dark_{1, 1, 0, 0, "#define KEY_TAPS 1\n#define SKY_TAPS 1\n#define texture(map, at) 1.0\n"};
  Target plain_, multisampled_;
  std::vector<std::uint8_t> pixels_ = std::vector<std::uint8_t>(std::size_t{4} * width * height);
};

/// Each left out by itself, in turn: of a frame, and of one of a still's sixteen passes, which need no multisampling.
void shadows_and_multisampling(benchmark::State& state) {
  const Picture picture = busy_picture();
  Pass pass(picture);
  Lighting *frame = &pass.single, *still = &pass.one_of_many;
  InTurn turns;
  for (auto _ : state)
    turns.round({[&] { return pass.seconds(frame, true); }, [&] { return pass.seconds(nullptr, true); },
                 [&] { return pass.seconds(frame, false); }, [&] { return pass.seconds(nullptr, false); },
                 [&] { return pass.seconds(still, false); }});
  state.counters["frame, ms"] = 1000 * turns.time(0);
  state.counters["without shadows"] = turns.ratio(1, 0);
  state.counters["without multisampling"] = turns.ratio(2, 0);
  state.counters["without both"] = turns.ratio(3, 0);
  state.counters["still's pass, ms"] = 1000 * turns.time(4);
  state.counters["that without shadows"] = turns.ratio(3, 4);
}
BENCHMARK(shadows_and_multisampling)->Iterations(40)->Unit(benchmark::kMillisecond);

}  // namespace
