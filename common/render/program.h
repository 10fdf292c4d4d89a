/// A vertex and a fragment shader, linked, and the way to set what they read.
#pragma once

#include <string>
#include <vector>

#include "pushback/common/basics/types.h"
#include "pushback/common/render/gl.h"

namespace pushback {

/// Lives in the context that is current when it is made, and goes with it.
class Program {
 public:
  /// The parts of each shader are joined. Throws std::runtime_error with the compiler's words where they don't compile.
  Program(const char* name, std::vector<const char*> vertex, std::vector<const char*> fragment);

  void use() const { glUseProgram(handle_); }
  // Each sets a value of the program in use; names that it does not read are ignored.
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
