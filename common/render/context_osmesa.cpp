// A context from OSMesa, the part of Mesa that draws into plain memory.
#include <GL/osmesa.h>

#include <array>
#include <stdexcept>

#include "pushback/common/render/context.h"

namespace pushback {

struct Context::State {
  OSMesaContext handle = nullptr;
  std::array<unsigned char, 4 * 4 * 4> unused{};  // OSMesa requires a colour buffer: 4 x 4 pixels of 4 bytes

  ~State() {
    if (handle) OSMesaDestroyContext(handle);
  }
};

Context::Context() : state_(std::make_unique<State>()) {
  const std::array<int, 13> wishes = {OSMESA_FORMAT,
                                      OSMESA_RGBA,
                                      OSMESA_DEPTH_BITS,
                                      0,
                                      OSMESA_PROFILE,
                                      OSMESA_CORE_PROFILE,
                                      OSMESA_CONTEXT_MAJOR_VERSION,
                                      3,
                                      OSMESA_CONTEXT_MINOR_VERSION,
                                      3,
                                      OSMESA_STENCIL_BITS,
                                      0,
                                      0};
  state_->handle = OSMesaCreateContextAttribs(wishes.data(), nullptr);
  if (!state_->handle) throw std::runtime_error("OSMesa gives no OpenGL 3.3 core context");
  make_current();
}

Context::~Context() = default;

void Context::make_current() {
  if (!OSMesaMakeCurrent(state_->handle, state_->unused.data(), 0x1401 /* GL_UNSIGNED_BYTE */, 4, 4)) {
    throw std::runtime_error("OSMesa does not make its OpenGL context current");
  }
}

}  // namespace pushback
