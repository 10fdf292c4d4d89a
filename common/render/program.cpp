#include "pushback/common/render/program.h"

#include <fmt/format.h>

#include <array>
#include <stdexcept>

namespace pushback {
namespace {

GLuint compile(const char* name, GLenum kind, std::vector<const char*> parts) {
  parts.insert(parts.begin(), shaders::prologue);
  const GLuint shader = glCreateShader(kind);
  glShaderSource(shader, static_cast<GLsizei>(parts.size()), parts.data(), nullptr);
  glCompileShader(shader);
  GLint fine = GL_FALSE;
  glGetShaderiv(shader, GL_COMPILE_STATUS, &fine);
  if (!fine) {
    std::array<char, 2000> words{};
    glGetShaderInfoLog(shader, static_cast<GLsizei>(words.size()), nullptr, words.data());
    throw std::runtime_error(fmt::format("the {} shader '{}' does not compile:\n{}",
                                         kind == GL_VERTEX_SHADER ? "vertex" : "fragment", name, words.data()));
  }
  return shader;
}

}  // namespace

Program::Program(const char* name, std::vector<const char*> vertex, std::vector<const char*> fragment)
    : handle_(glCreateProgram()) {
  for (const GLuint shader : {compile(name, GL_VERTEX_SHADER, vertex), compile(name, GL_FRAGMENT_SHADER, fragment)}) {
    glAttachShader(handle_, shader);
    glDeleteShader(shader);  // it is kept as long as the program
  }
  glLinkProgram(handle_);
  GLint fine = GL_FALSE;
  glGetProgramiv(handle_, GL_LINK_STATUS, &fine);
  if (!fine) {
    std::array<char, 2000> words{};
    glGetProgramInfoLog(handle_, static_cast<GLsizei>(words.size()), nullptr, words.data());
    throw std::runtime_error(fmt::format("the shaders '{}' do not link:\n{}", name, words.data()));
  }
}

}  // namespace pushback
