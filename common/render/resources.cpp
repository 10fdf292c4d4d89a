#include "pushback/common/render/resources.h"

#include <fmt/format.h>

#include <stdexcept>

namespace pushback {
namespace {

GLuint made(void (*make)(GLsizei, GLuint*)) {
  GLuint handle = 0;
  make(1, &handle);
  return handle;
}

void attach(GLenum where, GLenum format, int width, int height, int samples) {
  const GLuint buffer = made(glGenRenderbuffers);
  glBindRenderbuffer(GL_RENDERBUFFER, buffer);
  glRenderbufferStorageMultisample(GL_RENDERBUFFER, samples, format, width, height);
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, where, GL_RENDERBUFFER, buffer);
}

// Position and radius are read as one vector of four, and there is no padding between the numbers.
static_assert(sizeof(Instance) == 14 * sizeof(float) && offsetof(Instance, radius) == 3 * sizeof(float));

template <class Record>
void attribute(GLuint place, GLint numbers, std::size_t offset, GLuint divisor) {
  glEnableVertexAttribArray(place);
  glVertexAttribPointer(place, numbers, GL_FLOAT, GL_FALSE, sizeof(Record), reinterpret_cast<const void*>(offset));
  glVertexAttribDivisor(place, divisor);
}

}  // namespace

void Target::make(int width, int height, int samples) {
  const GLuint framebuffer = made(glGenFramebuffers);
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  attach(GL_COLOR_ATTACHMENT0, GL_SRGB8_ALPHA8, width, height, samples);
  attach(GL_DEPTH_STENCIL_ATTACHMENT, GL_DEPTH24_STENCIL8, width, height, samples);
  if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE || glGetError() != GL_NO_ERROR) {
    throw std::runtime_error(fmt::format("OpenGL cannot draw pictures of {} x {} pixels", width, height));
  }
  handle = framebuffer;
}

ShadowMap::ShadowMap(GLenum kind_, int resolution_, int layers)
    : kind(kind_), resolution(resolution_), texture(made(glGenTextures)), framebuffer(made(glGenFramebuffers)) {
  glBindTexture(kind, texture);
  if (kind == GL_TEXTURE_2D) {
    glTexImage2D(kind, 0, GL_DEPTH_COMPONENT24, resolution, resolution, 0, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT,
                 nullptr);
  } else {
    glTexImage3D(kind, 0, GL_DEPTH_COMPONENT24, resolution, resolution, layers, 0, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT,
                 nullptr);
  }
  glTexParameteri(kind, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  glTexParameteri(kind, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  glTexParameteri(kind, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  glTexParameteri(kind, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  glTexParameteri(kind, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
  glTexParameteri(kind, GL_TEXTURE_COMPARE_FUNC, GL_LEQUAL);
}

void ShadowMap::begin_layer(int layer) const {
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  if (kind == GL_TEXTURE_2D) glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, kind, texture, 0);
  else glFramebufferTextureLayer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, texture, 0, layer);
  const GLenum none = GL_NONE;
  glDrawBuffers(1, &none);
  glReadBuffer(GL_NONE);
  glViewport(0, 0, resolution, resolution);
  glClear(GL_DEPTH_BUFFER_BIT);
}

Geometry::Part Geometry::append(const Mesh& mesh) {
  const Part part{indices_.size(), static_cast<GLsizei>(mesh.indices.size())};
  const auto first_vertex = static_cast<std::uint32_t>(vertices_.size());
  vertices_.insert(vertices_.end(), mesh.vertices.begin(), mesh.vertices.end());
  for (const std::uint16_t index : mesh.indices) indices_.push_back(first_vertex + index);
  return part;
}

void Geometry::upload(GLenum usage) const {
  glBindBuffer(GL_ARRAY_BUFFER, vertex_buffer_);
  glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(vertices_.size() * sizeof(Vertex)), vertices_.data(), usage);
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, index_buffer_);
  glBufferData(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLsizeiptr>(indices_.size() * sizeof(std::uint32_t)),
               indices_.data(), usage);
}

Geometry::Geometry()
    : vertex_buffer_(made(glGenBuffers)), index_buffer_(made(glGenBuffers)), instances_(made(glGenBuffers)) {
  glBindVertexArray(made(glGenVertexArrays));
  const std::array<Mesh, count> meshes = {
      rounded_box(0), rounded_box(1),          rounded_box(2), rounded_box(7),
      shaft(10),      cone(16, head_slimness), shaft(4),       cone(6, head_slimness)};
  for (std::size_t i = 0; i < meshes.size(); ++i) parts_[i] = append(meshes[i]);
  fixed_vertices_ = vertices_.size();
  fixed_indices_ = indices_.size();
  upload(GL_STATIC_DRAW);
  glBindBuffer(GL_ARRAY_BUFFER, vertex_buffer_);
  attribute<Vertex>(0, 3, offsetof(Vertex, corner), 0);
  attribute<Vertex>(1, 3, offsetof(Vertex, normal), 0);
}

void Geometry::load(const Frame& frame) {
  all_.clear();
  for (const auto* list : {&frame.boxes, &frame.balls, &frame.shafts, &frame.heads, &frame.dots}) {
    all_.insert(all_.end(), list->begin(), list->end());
  }
  vertices_.resize(fixed_vertices_);
  indices_.resize(fixed_indices_);
  hulls_.clear();
  for (const HullInstances& hull : frame.hulls) {
    const Mesh mesh = bevelled(*hull.solid, hull.bevel);
    hulls_.push_back({append(mesh), append(cut_back(mesh)), all_.size(), hull.instances.size()});
    all_.insert(all_.end(), hull.instances.begin(), hull.instances.end());
  }
  if (!hulls_.empty()) upload(GL_STREAM_DRAW);
  glBindBuffer(GL_ARRAY_BUFFER, instances_);
  glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(all_.size() * sizeof(Instance)), all_.data(), GL_STREAM_DRAW);
}

void Geometry::draw(Which which, std::size_t first, std::size_t many) const {
  if (many > 0) draw(parts_[which], first, many);
}

void Geometry::draw_hulls(bool for_shadows) const {
  for (const HullPart& hull : hulls_) draw(for_shadows ? hull.casts : hull.looks, hull.first, hull.many);
}

void Geometry::draw(const Part& part, std::size_t first, std::size_t many) const {
  const std::size_t base = first * sizeof(Instance);
  glBindBuffer(GL_ARRAY_BUFFER, instances_);
  attribute<Instance>(2, 4, base + offsetof(Instance, position), 1);
  attribute<Instance>(3, 4, base + offsetof(Instance, turn), 1);
  attribute<Instance>(4, 3, base + offsetof(Instance, half_extents), 1);
  attribute<Instance>(5, 3, base + offsetof(Instance, colour), 1);
  glDrawElementsInstanced(GL_TRIANGLES, part.size, GL_UNSIGNED_INT,
                          reinterpret_cast<const void*>(part.first_index * sizeof(std::uint32_t)),
                          static_cast<GLsizei>(many));
}

}  // namespace pushback
