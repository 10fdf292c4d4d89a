// A context from EGL on Mesa's surfaceless platform, which needs no window system or screen and has no default framebuffer.
#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <fmt/format.h>

#include <array>
#include <stdexcept>

#include "pushback/common/render/context.h"

namespace pushback {
namespace {

[[noreturn]] void fail(const char* what) {
  throw std::runtime_error(fmt::format("EGL {} (error {:#x})", what, static_cast<unsigned>(eglGetError())));
}

/// One display for the whole process. It is never closed, because that would destroy the other contexts.
EGLDisplay display() {
  static const EGLDisplay opened = [] {
    const EGLDisplay found = eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
    if (found == EGL_NO_DISPLAY) fail("has no surfaceless platform");
    if (!eglInitialize(found, nullptr, nullptr)) fail("does not start");
    return found;
  }();
  return opened;
}

}  // namespace

struct Context::State {
  EGLContext handle = EGL_NO_CONTEXT;

  ~State() {
    if (handle == EGL_NO_CONTEXT) return;
    if (eglGetCurrentContext() == handle) eglMakeCurrent(display(), EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    eglDestroyContext(display(), handle);
  }
};

Context::Context() : state_(std::make_unique<State>()) {
  const EGLDisplay where = display();
  if (!eglBindAPI(EGL_OPENGL_API)) fail("knows no desktop OpenGL");
  const std::array<EGLint, 7> wishes = {
      EGL_CONTEXT_MAJOR_VERSION,           3,       EGL_CONTEXT_MINOR_VERSION, 3, EGL_CONTEXT_OPENGL_PROFILE_MASK,
      EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT, EGL_NONE};
  state_->handle = eglCreateContext(where, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, wishes.data());
  if (state_->handle == EGL_NO_CONTEXT) fail("gives no OpenGL 3.3 core context");
  make_current();
}

Context::~Context() = default;

void Context::make_current() {
  if (!eglBindAPI(EGL_OPENGL_API) || !eglMakeCurrent(display(), EGL_NO_SURFACE, EGL_NO_SURFACE, state_->handle)) {
    fail("does not make its OpenGL context current");
  }
}

}  // namespace pushback
