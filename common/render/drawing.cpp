#include "pushback/common/render/drawing.h"

#include <algorithm>
#include <cmath>

#include "pushback/common/render/shaders.h"

namespace pushback {
namespace {

using namespace shaders;
using Eigen::Vector2f;
using Eigen::Vector3f;

constexpr int sky_count = 4;  // as in the shader

/// The radius in pixels, in a picture of this height.
float radius_of(const Instance& one, const Frame& frame, int height) {
  return (one.radius + one.half_extents.x()) / one.position.norm() * static_cast<float>(height) / frame.field_of_view;
}

}  // namespace

Lighting::Lighting(int key_resolution, int sky_resolution, float key_radius, float sky_radius, const char* taps)
    : key(GL_TEXTURE_2D, key_resolution, 1),
      sky(GL_TEXTURE_2D_ARRAY, sky_resolution, sky_count),
      key_blur(key_radius),
      sky_blur(sky_radius),
      solid("solid", {instance_vertex}, {taps, common_fragment, light_fragment, solid_fragment}),
      plane("plane", {plane_vertex}, {taps, common_fragment, light_fragment, plane_fragment}) {}

float sequence(int index, double step) {
  const double x = 0.5 + step * index;
  return static_cast<float>(x - std::floor(x));
}

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

Drawing::Drawing()
    : mark_("mark", {instance_vertex}, {common_fragment, mark_fragment}),
      depth_("depth", {instance_vertex}, {depth_fragment}),
      background_("background", {background_vertex}, {common_fragment, background_fragment}) {
  glEnable(GL_CULL_FACE);
  glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
}

/// Draws each ball with as many corners as it needs, in runs of balls that need the same mesh.
void Drawing::draw_balls(const Frame& frame, int height, Geometry::Which finest) const {
  const auto mesh = [&](std::size_t i) {
    const float radius = radius_of(frame.balls[i], frame, height);
    const auto enough = [&](float corners) {  // limits the distance from a chord to its circle
      return radius * (1 - std::cos(static_cast<float>(pi) / corners)) <= out_of_round;
    };
    return std::min(finest, enough(4)    ? Geometry::sharp_box
                            : enough(12) ? Geometry::bevelled_box
                            : enough(20) ? Geometry::coarse_ball
                                         : Geometry::ball);
  };
  for (std::size_t from = 0, to = 0; from < frame.balls.size(); from = to) {
    const Geometry::Which same = mesh(from);
    for (to = from + 1; to < frame.balls.size() && mesh(to) == same;) ++to;
    geometry_.draw(same, frame.boxes.size() + from, to - from);
  }
}

void Drawing::draw_shadows(const Frame& frame, int height, const Lighting& lighting,
                           const std::vector<ShadowView>& views) const {
  depth_.use();
  depth_.set("pull", 0.0f);
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_LESS);
  glDepthMask(GL_TRUE);
  glDisable(GL_BLEND);
  Eigen::Matrix4f clip_from_map = Eigen::Matrix4f::Identity();  // maps 0 to 1 onto -1 to 1
  clip_from_map.diagonal().head<3>().setConstant(2);
  clip_from_map.topRightCorner<3, 1>().setConstant(-1);
  for (std::size_t i = 0; i < views.size(); ++i) {
    if (i == 0) lighting.key.begin_layer(0);
    else lighting.sky.begin_layer(static_cast<int>(i) - 1);
    if (coarse && i > 0) continue;
    depth_.set("clip_from_eye", Eigen::Matrix4f(clip_from_map * views[i].map_from_eye));
    geometry_.draw(Geometry::sharp_box, 0, frame.boxes.size());
    draw_balls(frame, height, coarse ? Geometry::sharp_box : Geometry::coarse_ball);
    geometry_.draw_hulls(true);
  }
}

void Drawing::set_lights(const Program& program, const Frame& frame, const Lights& lights, const Lighting& lighting,
                         const std::vector<ShadowView>& views) const {
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

void Drawing::draw_planes(const Frame& frame, const Program& plane) const {
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

void Drawing::draw_marks(const Frame& frame, int height) const {
  const std::size_t shafts = frame.boxes.size() + frame.balls.size(), heads = shafts + frame.shafts.size(),
                    dots = heads + frame.heads.size();
  // Marks that are only a few pixels wide need few corners.
  const auto widest = [&](const std::vector<Instance>& marks) {
    float radius = 0;
    for (const Instance& one : marks) radius = std::max(radius, radius_of(one, frame, height));
    return radius;
  };
  const float dot_radius = widest(frame.dots);
  const Geometry::Which dot_mesh = dot_radius < 2   ? Geometry::sharp_box
                                   : dot_radius < 6 ? Geometry::bevelled_box
                                                    : Geometry::coarse_ball;
  const bool thin = widest(frame.heads) < 3;
  const auto draw_arrows = [&] {
    mark_.set("pull", 0.0f);
    mark_.set("outline", 0.0f);
    geometry_.draw(thin ? Geometry::thin_head : Geometry::arrow_head, heads, frame.heads.size());
    geometry_.draw(thin ? Geometry::thin_shaft : Geometry::arrow_shaft, shafts, frame.shafts.size());
  };
  const auto draw_dots = [&] {
    mark_.set("pull", 2.0f);
    mark_.set("outline", 1.0f);
    geometry_.draw(dot_mesh, dots, frame.dots.size());
  };
  // First the hidden parts, over the bodies that hide them, each pixel once.
  glDepthMask(GL_FALSE);
  glDepthFunc(GL_GREATER);
  glEnable(GL_BLEND);
  glEnable(GL_STENCIL_TEST);
  glStencilFunc(GL_EQUAL, 0, 0xFF);
  glStencilOp(GL_KEEP, GL_KEEP, GL_INCR);
  mark_.set("opacity", 0.62f);
  draw_dots();
  mark_.set("opacity", 0.3f);
  draw_arrows();
  glDisable(GL_STENCIL_TEST);
  glDisable(GL_BLEND);
  glDepthFunc(GL_LESS);
  glDepthMask(GL_TRUE);
  mark_.set("opacity", 1.0f);
  draw_arrows();
  draw_dots();
}

void Drawing::draw(const Frame& frame, GLuint framebuffer, const Pane& pane, const Lights& lights,
                   const Vector2f& shift, const Lighting& lighting) {
  glDisable(GL_SCISSOR_TEST);
  std::vector<ShadowView> views{{frame, lights.key, lighting.key.resolution}};
  for (const Vector3f& direction : lights.sky) views.emplace_back(frame, direction, lighting.sky.resolution);
  draw_shadows(frame, pane.height, lighting, views);

  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  glViewport(pane.x, pane.y, pane.width, pane.height);
  glScissor(pane.x, pane.y, pane.width, pane.height);
  glEnable(GL_SCISSOR_TEST);
  glClear(GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
  glActiveTexture(GL_TEXTURE1);
  glBindTexture(GL_TEXTURE_2D_ARRAY, lighting.sky.texture);
  glActiveTexture(GL_TEXTURE0);
  glBindTexture(GL_TEXTURE_2D, lighting.key.texture);

  const Eigen::Matrix4f clip_from_eye = frame.clip_from_eye(pane.width, pane.height, shift);
  const Vector2f picture_corner(static_cast<float>(pane.x), static_cast<float>(pane.y));
  const Vector2f picture_size(static_cast<float>(pane.width), static_cast<float>(pane.height));
  const auto begin = [&](const Program& program) {
    program.use();
    program.set("clip_from_eye", clip_from_eye);
    program.set("picture_corner", picture_corner);
    program.set("picture_size", picture_size);
    program.set("pull", 0.0f);
  };
  begin(background_);
  glDisable(GL_DEPTH_TEST);
  glDrawArrays(GL_TRIANGLES, 0, 3);
  glEnable(GL_DEPTH_TEST);
  begin(lighting.solid);
  set_lights(lighting.solid, frame, lights, lighting, views);
  geometry_.draw(Geometry::bevelled_box, 0, frame.boxes.size());
  draw_balls(frame, pane.height, Geometry::ball);
  geometry_.draw_hulls(false);
  begin(lighting.plane);
  set_lights(lighting.plane, frame, lights, lighting, views);
  glDisable(GL_CULL_FACE);
  draw_planes(frame, lighting.plane);
  glEnable(GL_CULL_FACE);
  begin(mark_);
  draw_marks(frame, pane.height);
}

}  // namespace pushback
