/// Draws frames with their light and shadows onto any framebuffer, through OpenGL 3.3 core or WebGL 2.
#pragma once

#include <vector>

#include "pushback/common/render/frame.h"
#include "pushback/common/render/program.h"
#include "pushback/common/render/resources.h"

namespace pushback {

/// The quality of the light in one pass: shadow maps, and the programs that read them. Belongs to the context that is current when
/// it is made, and is destroyed with that context.
struct Lighting {
  Lighting(int key_resolution, int sky_resolution, float key_radius, float sky_radius, const char* taps);
  /// For a single pass, which has to blur its few shadows.
  static Lighting of_single_pass() { return {1024, 256, 0.005f, 0.03f, "#define KEY_TAPS 9\n#define SKY_TAPS 3\n"}; }
  /// For a fast pass, with hard-edged shadows.
  static Lighting of_coarse_pass() { return {512, 16, 0, 0, "#define KEY_TAPS 1\n#define SKY_TAPS 1\n"}; }
  /// For one of many passes, which blur shadows by moving the lights.
  static Lighting of_many_passes() { return {1024, 512, 0.005f, 0, "#define KEY_TAPS 5\n#define SKY_TAPS 1\n"}; }

  ShadowMap key, sky;
  float key_blur, sky_blur;  ///< filter radius divided by the distance to the target; at least 1.3 texels are used
  Program solid, plane;
};

/// The directions to the lights.
struct Lights {
  Eigen::Vector3f key;
  std::vector<Eigen::Vector3f> sky;
};

/// The lights for one pass. The key light is a disc, and each pass takes another of its points. The sky is a hemisphere, and each pass
/// takes a few of its directions.
Lights lights_for(const Frame& frame, int pass, int passes);

/// The fractional part of 0.5 + step * index. For a suitable step, these numbers fill [0, 1) evenly, however many are taken.
float sequence(int index, double step);

/// A rectangle of a framebuffer, pixels from its lower left corner.
struct Pane {
  int x, y, width, height;
};

/// Belongs to the context that is current when it is made, and is destroyed with that context.
class Drawing {
 public:
  Drawing();

  /// Loads the frame that `draw` draws.
  void load(const Frame& frame) { geometry_.load(frame); }
  /// Draws the loaded frame onto a framebuffer. `shift`: displacement in pixels.
  void draw(const Frame& frame, GLuint framebuffer, const Pane& pane, const Lights& lights,
            const Eigen::Vector2f& shift, const Lighting& lighting);

  // For fast drawing:
  bool coarse = false;     ///< the sky casts no shadows, and the shadows of balls have corners
  float out_of_round = 0;  ///< pixels by which the outline of a ball may deviate from its circle

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
