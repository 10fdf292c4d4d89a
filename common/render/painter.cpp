#include "pushback/common/render/painter.h"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <string>

#include "pushback/common/basics/input.h"
#include "pushback/common/render/context.h"
#include "pushback/common/render/drawing.h"
#include "pushback/common/render/light.h"

namespace pushback {
namespace {

using Eigen::Vector2f;

constexpr int longest_side = 8192;

void require_side(const char* what, int side) {
  if (side < 1 || side > longest_side) {
    throw InvalidInput(
        fmt::format("the {} of the picture is {} pixels: from 1 to {} is needed", what, side, longest_side));
  }
}

}  // namespace

struct Painter::State {
  State(int wide, int high) : width(wide), height(high) {
    glEnable(GL_FRAMEBUFFER_SRGB);
    glEnable(GL_DEPTH_CLAMP);
    plain.make(width, height, 0);
  }

  /// Draws one pass of the loaded frame onto `target`.
  void render(const Frame& frame, const Target& target, const Lights& lights, const Vector2f& shift,
              const Lighting& lighting) {
    drawing.draw(frame, target.handle, {0, 0, width, height}, lights, shift, lighting);
    glDisable(GL_SCISSOR_TEST);
  }
  /// Reads the pixels of `plain`.
  void read(std::vector<std::uint8_t>& rgba) const {
    rgba.resize(4 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    glBindFramebuffer(GL_READ_FRAMEBUFFER, plain.handle);
    glPixelStorei(GL_PACK_ALIGNMENT, 4);
    glReadPixels(0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE, rgba.data());
    if (const GLenum error = glGetError(); error != GL_NO_ERROR)
      throw std::runtime_error(fmt::format("OpenGL failed while drawing (error {:#x})", error));
  }

  Context context;
  int width, height;
  Drawing drawing;
  Lighting single = Lighting::of_single_pass();
  Lighting one_of_many = Lighting::of_many_passes();
  Target plain, multisampled;
  std::vector<std::uint8_t> levels;
};

Painter::Painter(int width, int height) {
  require_side("width", width);
  require_side("height", height);
  state_ = std::make_unique<State>(width, height);
}

Painter::~Painter() = default;

Image Painter::draw(const Picture& picture) {
  const Frame frame(picture);
  State& state = *state_;
  state.context.make_current();
  if (state.multisampled.handle == 0) state.multisampled.make(state.width, state.height, 4);
  state.drawing.load(frame);
  state.render(frame, state.multisampled, lights_for(frame, 0, 1), Vector2f::Zero(), state.single);
  glBindFramebuffer(GL_READ_FRAMEBUFFER, state.multisampled.handle);
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, state.plain.handle);
  glBlitFramebuffer(0, 0, state.width, state.height, 0, 0, state.width, state.height, GL_COLOR_BUFFER_BIT, GL_NEAREST);
  state.read(state.levels);
  Image image(state.width, state.height);
  const std::size_t row = 4 * static_cast<std::size_t>(state.width);
  for (int y = 0; y < state.height; ++y)
    std::copy_n(&state.levels[row * static_cast<std::size_t>(state.height - 1 - y)], row, image.at(0, y));
  return image;
}

Image Painter::draw_still(const Picture& picture, int passes) {
  if (passes < 1 || passes > 4096)
    throw InvalidInput(fmt::format("a still of {} passes is asked for: from 1 to 4096", passes));
  const Frame frame(picture);
  State& state = *state_;
  state.context.make_current();
  state.drawing.load(frame);
  Image image(state.width, state.height);
  std::vector<float> light(image.pixels.size(), 0.0f);
  for (int pass = 0; pass < passes; ++pass) {
    const Vector2f shift(sequence(pass, 0.7548776662) - 0.5f, sequence(pass, 0.5698402910) - 0.5f);
    state.render(frame, state.plain, lights_for(frame, pass, passes), shift, state.one_of_many);
    state.read(state.levels);
    float* to = light.data();
    for (int y = state.height - 1; y >= 0; --y) {
      const std::uint8_t* from = &state.levels[4 * static_cast<std::size_t>(y) * static_cast<std::size_t>(state.width)];
      for (int x = 0; x < state.width; ++x, from += 4, to += 4) {
        for (int i = 0; i < 3; ++i) to[i] += linear_of(from[i]);
      }
    }
  }
  std::array<std::uint8_t, 4096> encoded{};  // as good as level_of, and much faster
  for (std::size_t i = 0; i < encoded.size(); ++i) encoded[i] = level_of(static_cast<float>(i) / 4095);
  const float scale = 4095 / static_cast<float>(passes);
  for (std::size_t i = 0; i < light.size(); ++i)
    image.pixels[i] = encoded[static_cast<std::size_t>(std::min(light[i] * scale + 0.5f, 4095.0f))];
  return image;
}

}  // namespace pushback
