/// An OpenGL 3.3 core context without a window. The build picks one of the two files that implement it.
#pragma once

#include <memory>

namespace pushback {

/// The context has no usable framebuffer. Draw to a framebuffer of your own.
class Context {
 public:
  /// Makes the new context current. Throws std::runtime_error if no context can be created.
  Context();
  ~Context();
  Context(const Context&) = delete;
  Context& operator=(const Context&) = delete;

  /// Directs this thread's OpenGL calls to this context. Throws std::runtime_error if that fails.
  void make_current();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace pushback
