/// A linked vertex and fragment shader, with setters for their uniforms.
#pragma once

#include <string>
#include <vector>

#include "pushback/common/basics/types.h"
#include "pushback/common/render/gl.h"

namespace pushback {

/// Belongs to the context that is current when it is made, and is destroyed with that context.
class Program {
 public:
  /// Joins the parts of each shader. Throws std::runtime_error with the compiler's log if they do not compile or link.
  Program(const char* name, std::vector<const char*> vertex, std::vector<const char*> fragment);

  void use() const { glUseProgram(handle_); }
  // Each sets a uniform of the program, which must be in use. Names that the shaders do not read are ignored.
  void set(const char* name, int value) const { glUniform1i(place(name), value); }
  void set(const char* name, float value) const { glUniform1f(place(name), value); }
  void set(const char* name, const Eigen::Vector2f& value) const { glUniform2fv(place(name), 1, value.data()); }
  void set(const char* name, const Eigen::Vector3f& value) const { glUniform3fv(place(name), 1, value.data()); }
  void set(const char* name, const Eigen::Matrix4f& value) const {
    glUniformMatrix4fv(place(name), 1, GL_FALSE, value.data());
  }
  void set(const char* name, const std::vector<Eigen::Vector2f>& values) const {
    glUniform2fv(place(name), static_cast<GLsizei>(values.size()), values.front().data());
  }
  void set(const char* name, const std::vector<Eigen::Vector3f>& values) const {
    glUniform3fv(place(name), static_cast<GLsizei>(values.size()), values.front().data());
  }
  void set(const char* name, const std::vector<Eigen::Matrix4f>& values) const {
    glUniformMatrix4fv(place(name), static_cast<GLsizei>(values.size()), GL_FALSE, values.front().data());
  }

 private:
  GLint place(const char* name) const { return glGetUniformLocation(handle_, name); }
  GLuint handle_;
};

}  // namespace pushback
