/// Pictures on the canvas of a page, through WebGL 2.
#pragma once

#include <string>

#include "pushback/common/render/drawing.h"

namespace pushback {

/// The constructor makes its context current. If the browser takes the context away, make another view.
class CanvasView {
 public:
  /// `selector`: "#id". Throws std::runtime_error if there is no WebGL 2.
  explicit CanvasView(const std::string& selector);
  ~CanvasView();
  CanvasView(const CanvasView&) = delete;
  CanvasView& operator=(const CanvasView&) = delete;

  void draw(const Picture& picture, const Pane& pane, bool coarse);

 private:
  struct State;
  std::unique_ptr<State> state_;
  int context_;
};

}  // namespace pushback
