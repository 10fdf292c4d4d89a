/// An OpenGL 3.3 core context without a window. Two files implement it; the build picks one.
#pragma once

#include <memory>

namespace pushback {

/// Has no framebuffer worth drawing to: whoever uses it brings their own.
class Context {
 public:
  /// Throws std::runtime_error where no context can be had.
  Context();
  ~Context();
  Context(const Context&) = delete;
  Context& operator=(const Context&) = delete;

  /// From here on, OpenGL calls of this thread mean this context. Throws std::runtime_error where that fails.
  void make_current();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace pushback
