/// OpenGL objects for drawing: render targets, shadow maps, meshes. They belong to the context that is current when they are made, and
/// are destroyed with that context.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "pushback/common/render/frame.h"
#include "pushback/common/render/gl.h"
#include "pushback/common/render/mesh.h"

namespace pushback {

/// A picture to draw on, with depth and stencil buffers.
struct Target {
  GLuint handle = 0;  ///< 0 until it is made

  /// Throws std::runtime_error if OpenGL cannot draw pictures of this size.
  void make(int width, int height, int samples);
};

/// Layers of depth as seen from lights.
struct ShadowMap {
  /// `kind`: GL_TEXTURE_2D, or GL_TEXTURE_2D_ARRAY for several layers.
  ShadowMap(GLenum kind, int resolution, int layers);
  /// Clears this layer, and directs all further drawing to it.
  void begin_layer(int layer) const;

  GLenum kind;
  int resolution;
  GLuint texture, framebuffer;
};

/// One buffer with all meshes, a frame's hulls last, and another with all instances of a frame.
class Geometry {
 public:
  enum Which { sharp_box, bevelled_box, coarse_ball, ball, arrow_shaft, arrow_head, thin_shaft, thin_head, count };

  Geometry();
  /// Loads a frame's boxes, balls, shafts, heads and dots, in this order, and its hulls.
  void load(const Frame& frame);
  /// Draws `many` of the loaded instances, from the `first` on.
  void draw(Which which, std::size_t first, std::size_t many) const;
  /// Draws all hulls. `for_shadows`: with the meshes that cast shadows.
  void draw_hulls(bool for_shadows) const;

 private:
  struct Part {
    std::size_t first_index;
    GLsizei size;
  };

  struct HullPart {
    Part looks, casts;
    std::size_t first, many;  // instances
  };

  Part append(const Mesh& mesh);
  void upload(GLenum usage) const;
  void draw(const Part& part, std::size_t first, std::size_t many) const;

  GLuint vertex_buffer_, index_buffer_, instances_;
  std::vector<Vertex> vertices_;
  std::vector<std::uint32_t> indices_;                  // absolute, because WebGL has no base vertex
  std::size_t fixed_vertices_ = 0, fixed_indices_ = 0;  // sizes without the hulls of a frame
  std::array<Part, count> parts_{};
  std::vector<HullPart> hulls_;
  std::vector<Instance> all_;
};

}  // namespace pushback
