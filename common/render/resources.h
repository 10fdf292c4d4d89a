/// What a context holds for the painter: pictures to draw on, shadow maps, meshes. All of it lives in the context that
/// is current when it is made, and goes with it.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "pushback/common/render/frame.h"
#include "pushback/common/render/gl.h"
#include "pushback/common/render/mesh.h"

namespace pushback {

/// A picture to draw on, with depth and stencil.
struct Target {
  GLuint handle = 0;  ///< 0 until it is made

  /// Throws std::runtime_error where there is no room.
  void make(int width, int height, int samples);
};

/// Layers of depth as lights see it.
struct ShadowMap {
  /// `kind`: GL_TEXTURE_2D, or GL_TEXTURE_2D_ARRAY for several layers.
  ShadowMap(GLenum kind, int resolution, int layers);
  /// What is drawn from here on goes to this layer, which is empty to begin with.
  void begin_layer(int layer) const;

  GLenum kind;
  int resolution;
  GLuint texture, framebuffer;
};

/// All meshes in one buffer, those of a frame's hulls last; all instances of a frame in another.
class Geometry {
 public:
  enum Which { sharp_box, bevelled_box, coarse_ball, ball, arrow_shaft, arrow_head, thin_shaft, thin_head, count };

  Geometry();
  /// Takes over a frame's boxes, balls, shafts, heads and dots, in this order, and its hulls.
  void load(const Frame& frame);
  /// Draws `many` instances from the `first` of those loaded.
  void draw(Which which, std::size_t first, std::size_t many) const;
  /// Draws all hulls, as they look or as they cast shadows.
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
  std::vector<std::uint32_t> indices_;                  // WebGL knows no base vertex
  std::size_t fixed_vertices_ = 0, fixed_indices_ = 0;  // how many belong to the meshes that all frames share
  std::array<Part, count> parts_{};
  std::vector<HullPart> hulls_;
  std::vector<Instance> all_;
};

}  // namespace pushback
