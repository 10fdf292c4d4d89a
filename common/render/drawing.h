/// Draws frames with their light and shadows onto any framebuffer, through OpenGL 3.3 core or WebGL 2.
#pragma once

#include <vector>

#include "pushback/common/render/frame.h"
#include "pushback/common/render/program.h"
#include "pushback/common/render/resources.h"

namespace pushback {

/// How much is spent on the light in one pass: maps, and the programs that read them. Lives in the context that is
/// current when it is made, and goes with it.
struct Lighting {
  Lighting(int key_resolution, int sky_resolution, float key_radius, float sky_radius, const char* taps);
  /// Of a single pass, which has to blur its few shadows.
  static Lighting of_single_pass() { return {1024, 256, 0.005f, 0.03f, "#define KEY_TAPS 9\n#define SKY_TAPS 3\n"}; }
  /// Of one that has to be quick: shadows with hard edges.
  static Lighting of_coarse_pass() { return {512, 16, 0, 0, "#define KEY_TAPS 1\n#define SKY_TAPS 1\n"}; }
  /// Of one of many passes, which blur shadows by moving the lights.
  static Lighting of_many_passes() { return {1024, 512, 0.005f, 0, "#define KEY_TAPS 5\n#define SKY_TAPS 1\n"}; }

  ShadowMap key, sky;
  float key_blur, sky_blur;  ///< radius of the filter over the distance to the target; at least a texel is taken
  Program solid, plane;
};

/// From where the light comes.
struct Lights {
  Eigen::Vector3f key;
  std::vector<Eigen::Vector3f> sky;
};

/// The key light is a disc, seen at another of its points in each pass; the sky is a hemisphere, of which each pass
/// takes a few directions.
Lights lights_for(const Frame& frame, int pass, int passes);

/// The part after the point of a sum of steps: points that fill the line evenly, however many are taken.
float sequence(int index, double step);

/// A rectangle of a framebuffer, pixels from its lower left corner.
struct Pane {
  int x, y, width, height;
};

/// Lives in the context that is current when it is made, and goes with it.
class Drawing {
 public:
  Drawing();

  /// What `draw` draws.
  void load(const Frame& frame) { geometry_.load(frame); }
  /// The frame that is loaded, onto a framebuffer. `shift`: by so many pixels.
  void draw(const Frame& frame, GLuint framebuffer, const Pane& pane, const Lights& lights,
            const Eigen::Vector2f& shift, const Lighting& lighting);

  // For who has to be quick:
  bool coarse = false;     ///< the sky casts no shadows, and the shadows of balls have corners
  float out_of_round = 0;  ///< pixels by which the outline of a ball may be off its circle

 private:
  void draw_balls(const Frame& frame, int height, Geometry::Which finest) const;
  void draw_shadows(const Frame& frame, int height, const Lighting& lighting,
                    const std::vector<ShadowView>& views) const;
  void set_lights(const Program& program, const Frame& frame, const Lights& lights, const Lighting& lighting,
                  const std::vector<ShadowView>& views) const;
  void draw_planes(const Frame& frame, const Program& plane) const;
  void draw_marks(const Frame& frame, int height) const;

  Program mark_, depth_, background_;
  Geometry geometry_;
};

}  // namespace pushback
