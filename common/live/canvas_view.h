/// Pictures on the canvas of a page, through WebGL 2.
#pragma once

#include <string>

#include "pushback/common/render/drawing.h"

namespace pushback {

/// Its context is current from its making on. A browser may take the context away: then another view has to be made.
class CanvasView {
 public:
  /// `selector`: "#id". Throws std::runtime_error where there is no WebGL 2.
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
