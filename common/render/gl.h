/// The OpenGL functions, linked by name, and the prologue of every shader: for OpenGL 3.3 core, or for WebGL 2 in a browser. The
/// offscreen libraries of OpenGL define all functions, so no loader is needed.
#pragma once

#ifdef __EMSCRIPTEN__
#include <GLES3/gl3.h>
#else
#define GL_GLEXT_PROTOTYPES
#include <GL/glcorearb.h>
#endif

namespace pushback::shaders {

/// `shown` converts linear light to the values of the framebuffer. A canvas does not encode sRGB by itself, so its shaders do.
#ifdef __EMSCRIPTEN__
inline constexpr const char* prologue = R"(#version 300 es
precision highp float;
precision highp int;
precision highp sampler2DShadow;
precision highp sampler2DArrayShadow;
vec3 shown(vec3 light) {
  vec3 curve = 1.055 * pow(max(light, vec3(0.0031308)), vec3(1.0 / 2.4)) - 0.055;
  return mix(12.92 * light, curve, step(0.0031308, light));
}
)";
#else
inline constexpr const char* prologue = R"(#version 330 core
vec3 shown(vec3 light) { return light; }
)";
#endif

}  // namespace pushback::shaders
