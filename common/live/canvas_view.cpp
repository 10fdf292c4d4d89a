#include "pushback/common/live/canvas_view.h"

#include <emscripten/html5.h>

#include <stdexcept>

namespace pushback {

struct CanvasView::State {
  Drawing drawing;
  Lighting whole = Lighting::of_single_pass(), coarse = Lighting::of_coarse_pass();
};

CanvasView::CanvasView(const std::string& selector) {
  EmscriptenWebGLContextAttributes wishes;
  emscripten_webgl_init_context_attributes(&wishes);
  wishes.majorVersion = 2;
  wishes.alpha = false;
  wishes.stencil = true;
  wishes.antialias = true;
  context_ = static_cast<int>(emscripten_webgl_create_context(selector.c_str(), &wishes));
  if (context_ <= 0) throw std::runtime_error("this browser shows no WebGL 2");
  emscripten_webgl_make_context_current(context_);
  state_ = std::make_unique<State>();
}

CanvasView::~CanvasView() {
  state_.reset();
  emscripten_webgl_destroy_context(context_);
}

void CanvasView::draw(const Picture& picture, const Pane& pane, bool coarse) {
  emscripten_webgl_make_context_current(context_);
  const Frame frame(picture);
  state_->drawing.coarse = coarse;
  state_->drawing.out_of_round = coarse ? 1.2f : 0.1f;
  state_->drawing.load(frame);
  state_->drawing.draw(frame, 0, pane, lights_for(frame, 0, 1), Eigen::Vector2f::Zero(),
                       coarse ? state_->coarse : state_->whole);
}

}  // namespace pushback
