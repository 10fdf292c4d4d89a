#include "pushback/common/render/painter.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <string>

#include "pushback/common/basics/input.h"
#include "pushback/common/render/context.h"
#include "pushback/common/render/frame.h"
#include "pushback/common/render/light.h"
#include "pushback/common/render/program.h"
#include "pushback/common/render/resources.h"
#include "pushback/common/render/shaders.h"

namespace pushback {
namespace {

using namespace shaders;
using Eigen::Vector2f;
using Eigen::Vector3f;

constexpr int longest_side = 8192;
constexpr int sky_count = 4;  // as in the shader

void require_side(const char* what, int side) {
  if (side < 1 || side > longest_side) {
    throw InvalidInput(
        fmt::format("the {} of the picture is {} pixels: from 1 to {} is needed", what, side, longest_side));
  }
}

/// How much is spent on the light in one pass: maps, and the programs that read them.
struct Lighting {
  Lighting(int key_resolution, int sky_resolution, float key_radius, float sky_radius, const char* taps)
      : key(GL_TEXTURE_2D, key_resolution, 1),
        sky(GL_TEXTURE_2D_ARRAY, sky_resolution, sky_count),
        key_blur(key_radius),
        sky_blur(sky_radius),
        solid("solid", {version, instance_vertex}, {version, taps, common_fragment, light_fragment, solid_fragment}),
        plane("plane", {version, plane_vertex}, {version, taps, common_fragment, light_fragment, plane_fragment}) {}

  ShadowMap key, sky;
  float key_blur, sky_blur;  ///< radius of the filter over the distance to the target; at least a texel is taken
  Program solid, plane;
};

// ---- where the light comes from --------------------------------------------------------------------------------------

/// The part after the point of a sum of steps: points that fill the line evenly, however many are taken.
float sequence(int index, double step) {
  const double x = 0.5 + step * index;
  return static_cast<float>(x - std::floor(x));
}

struct Lights {
  Vector3f key;
  std::vector<Vector3f> sky;
};

/// The key light is a disc, seen at another of its points in each pass; the sky is a hemisphere, of which each pass
/// takes a few directions.
Lights lights_for(const Frame& frame, int pass, int passes) {
  const float full_turn = 2 * static_cast<float>(pi);
  Lights lights{frame.key_direction(), {}};
  if (passes > 1) {
    const Vector3f aside = lights.key.cross(Vector3f::UnitY()).normalized(), over = lights.key.cross(aside);
    const float radius = 0.06f * std::sqrt((static_cast<float>(pass) + 0.5f) / static_cast<float>(passes));
    const float angle = full_turn * sequence(pass, 0.6180339887);
    lights.key = (lights.key + radius * (std::cos(angle) * aside + std::sin(angle) * over)).normalized();
  }
  const Vector3f ahead = frame.right.cross(Vector3f::UnitY());
  for (int k = 0; k < sky_count; ++k) {
    const int index = pass * sky_count + k;
    const float height = passes == 1 ? 0.62f : 0.12f + 0.86f * sequence(index, 0.7548776662);
    const float angle =
        full_turn * (passes == 1 ? (static_cast<float>(k) + 0.5f) / sky_count : sequence(index, 0.5698402910));
    const float level = std::sqrt(1 - height * height);
    lights.sky.push_back(level * (std::cos(angle) * frame.right + std::sin(angle) * ahead) +
                         height * Vector3f::UnitY());
  }
  return lights;
}

}  // namespace

// ---- the painter -----------------------------------------------------------------------------------------------------

struct Painter::State {
  State(int wide, int high) : width(wide), height(high) {
    glEnable(GL_FRAMEBUFFER_SRGB);
    glEnable(GL_CULL_FACE);
    glEnable(GL_DEPTH_CLAMP);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    plain.make(width, height, 0);
  }

  /// One pass onto `target`.
  void render(const Frame& frame, const Target& target, const Lights& lights, const Vector2f& shift,
              const Lighting& lighting);
  /// The pixels of `plain`.
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
  Program mark{"mark", {version, instance_vertex}, {version, common_fragment, mark_fragment}};
  Program depth{"depth", {version, instance_vertex}, {version, depth_fragment}};
  Program background{"background", {version, background_vertex}, {version, common_fragment, background_fragment}};
  Geometry geometry;
  // A single pass has to blur its few shadows; many passes blur them by moving the lights.
  Lighting single{1024, 256, 0.005f, 0.03f, "#define KEY_TAPS 9\n#define SKY_TAPS 3\n"};
  Lighting one_of_many{1024, 512, 0.005f, 0, "#define KEY_TAPS 5\n#define SKY_TAPS 1\n"};
  Target plain, multisampled;
  std::vector<std::uint8_t> levels;

 private:
  void draw_shadows(const Frame& frame, const Lighting& lighting, const std::vector<ShadowView>& views);
  void set_lights(const Program& program, const Frame& frame, const Lights& lights, const Lighting& lighting,
                  const std::vector<ShadowView>& views) const;
  void draw_planes(const Frame& frame, const Program& plane) const;
  void draw_marks(const Frame& frame) const;
};

void Painter::State::draw_shadows(const Frame& frame, const Lighting& lighting, const std::vector<ShadowView>& views) {
  depth.use();
  depth.set("pull", 0.0f);
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_LESS);
  glDepthMask(GL_TRUE);
  glDisable(GL_BLEND);
  Eigen::Matrix4f clip_from_map = Eigen::Matrix4f::Identity();  // from 0 to 1, to -1 to 1
  clip_from_map.diagonal().head<3>().setConstant(2);
  clip_from_map.topRightCorner<3, 1>().setConstant(-1);
  for (std::size_t i = 0; i < views.size(); ++i) {
    if (i == 0) lighting.key.begin_layer(0);
    else lighting.sky.begin_layer(static_cast<int>(i) - 1);
    depth.set("clip_from_eye", Eigen::Matrix4f(clip_from_map * views[i].map_from_eye));
    geometry.draw(Geometry::sharp_box, 0, frame.boxes.size());
    geometry.draw(Geometry::coarse_ball, frame.boxes.size(), frame.balls.size());
    geometry.draw_hulls(true);
  }
}

void Painter::State::set_lights(const Program& program, const Frame& frame, const Lights& lights,
                                const Lighting& lighting, const std::vector<ShadowView>& views) const {
  const auto texel = [](const ShadowView& view, int resolution) {
    return view.size.head<2>().maxCoeff() / static_cast<float>(resolution);
  };
  const float key_texel = texel(views[0], lighting.key.resolution);
  program.set("key_map", 0);
  program.set("key_from_eye", views[0].map_from_eye);
  program.set("key_size", views[0].size);
  program.set("key_direction", lights.key);
  program.set("key_texel", key_texel);
  std::vector<Eigen::Matrix4f> maps;
  std::vector<Vector3f> sizes;
  float sky_texel = 0;
  for (std::size_t i = 1; i < views.size(); ++i) {
    maps.push_back(views[i].map_from_eye);
    sizes.push_back(views[i].size);
    sky_texel = std::max(sky_texel, texel(views[i], lighting.sky.resolution));
  }
  program.set("sky_map", 1);
  program.set("sky_from_eye", maps);
  program.set("sky_size", sizes);
  program.set("sky_direction", lights.sky);
  program.set("sky_texel", sky_texel);
  program.set("key_blur", std::max(lighting.key_blur * frame.scale, 1.3f * key_texel));
  program.set("sky_blur", std::max(lighting.sky_blur * frame.scale, 1.3f * sky_texel));
}

void Painter::State::draw_planes(const Frame& frame, const Program& plane) const {
  const auto smooth = [](float from, float to, float x) {
    const float t = std::clamp((x - from) / (to - from), 0.0f, 1.0f);
    return t * t * (3 - 2 * t);
  };
  plane.set("fine", smooth(3, 0.8f, frame.scale));
  plane.set("coarse", smooth(40, 120, frame.scale));
  for (const Plane& one : frame.planes) {
    plane.set("centre", one.centre);
    plane.set("across", one.across);
    plane.set("along", one.along);
    plane.set("normal", one.normal);
    plane.set("half_size", one.half_size);
    plane.set("phase", one.phase);
    plane.set("fade", one.fade);
    glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
  }
}

void Painter::State::draw_marks(const Frame& frame) const {
  const std::size_t shafts = frame.boxes.size() + frame.balls.size(), heads = shafts + frame.shafts.size(),
                    dots = heads + frame.heads.size();
  // What is only a few pixels wide needs few corners.
  const auto widest = [&](const std::vector<Instance>& marks) {
    float radius = 0;
    for (const Instance& one : marks)
      radius = std::max(radius, (one.radius + one.half_extents.x()) / one.position.norm());
    return radius * static_cast<float>(height) / frame.field_of_view;
  };
  const float dot_radius = widest(frame.dots);
  const Geometry::Which dot_mesh = dot_radius < 2   ? Geometry::sharp_box
                                   : dot_radius < 6 ? Geometry::bevelled_box
                                                    : Geometry::coarse_ball;
  const bool thin = widest(frame.heads) < 3;
  const auto draw_arrows = [&] {
    mark.set("pull", 0.0f);
    mark.set("outline", 0.0f);
    geometry.draw(thin ? Geometry::thin_head : Geometry::arrow_head, heads, frame.heads.size());
    geometry.draw(thin ? Geometry::thin_shaft : Geometry::arrow_shaft, shafts, frame.shafts.size());
  };
  const auto draw_dots = [&] {
    mark.set("pull", 2.0f);
    mark.set("outline", 1.0f);
    geometry.draw(dot_mesh, dots, frame.dots.size());
  };
  // First what is hidden, over the bodies that hide it, each pixel once.
  glDepthMask(GL_FALSE);
  glDepthFunc(GL_GREATER);
  glEnable(GL_BLEND);
  glEnable(GL_STENCIL_TEST);
  glStencilFunc(GL_EQUAL, 0, 0xFF);
  glStencilOp(GL_KEEP, GL_KEEP, GL_INCR);
  mark.set("opacity", 0.62f);
  draw_dots();
  mark.set("opacity", 0.3f);
  draw_arrows();
  glDisable(GL_STENCIL_TEST);
  glDisable(GL_BLEND);
  glDepthFunc(GL_LESS);
  glDepthMask(GL_TRUE);
  mark.set("opacity", 1.0f);
  draw_arrows();
  draw_dots();
}

void Painter::State::render(const Frame& frame, const Target& target, const Lights& lights, const Vector2f& shift,
                            const Lighting& lighting) {
  std::vector<ShadowView> views{{frame, lights.key, lighting.key.resolution}};
  for (const Vector3f& direction : lights.sky) views.emplace_back(frame, direction, lighting.sky.resolution);
  draw_shadows(frame, lighting, views);

  glBindFramebuffer(GL_FRAMEBUFFER, target.handle);
  glViewport(0, 0, width, height);
  glClear(GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
  glActiveTexture(GL_TEXTURE1);
  glBindTexture(GL_TEXTURE_2D_ARRAY, lighting.sky.texture);
  glActiveTexture(GL_TEXTURE0);
  glBindTexture(GL_TEXTURE_2D, lighting.key.texture);

  const Eigen::Matrix4f clip_from_eye = frame.clip_from_eye(width, height, shift);
  const Vector2f picture_size(static_cast<float>(width), static_cast<float>(height));
  const auto begin = [&](const Program& program) {
    program.use();
    program.set("clip_from_eye", clip_from_eye);
    program.set("picture_size", picture_size);
    program.set("pull", 0.0f);
  };
  begin(background);
  glDisable(GL_DEPTH_TEST);
  glDrawArrays(GL_TRIANGLES, 0, 3);
  glEnable(GL_DEPTH_TEST);
  begin(lighting.solid);
  set_lights(lighting.solid, frame, lights, lighting, views);
  geometry.draw(Geometry::bevelled_box, 0, frame.boxes.size());
  geometry.draw(Geometry::ball, frame.boxes.size(), frame.balls.size());
  geometry.draw_hulls(false);
  begin(lighting.plane);
  set_lights(lighting.plane, frame, lights, lighting, views);
  glDisable(GL_CULL_FACE);
  draw_planes(frame, lighting.plane);
  glEnable(GL_CULL_FACE);
  begin(mark);
  draw_marks(frame);
}

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
  state.geometry.load(frame);
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
  state.geometry.load(frame);
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
