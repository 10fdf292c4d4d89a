/// Draws pictures through OpenGL 3.3 core, offscreen, on the processor where there is no graphics card.
#pragma once

#include <memory>

#include "pushback/common/render/image.h"
#include "pushback/common/render/picture.h"

namespace pushback {

/// Holds a context of its own, so that any number may live side by side; each belongs to the thread that made it.
/// The same picture gives the same bytes on one machine; another version of the driver may differ in the last bit.
class Painter {
 public:
  /// Throws InvalidInput where a side is below 1 or above 8192, std::runtime_error where no context can be had.
  Painter(int width, int height);
  ~Painter();
  Painter(const Painter&) = delete;
  Painter& operator=(const Painter&) = delete;

  /// One pass with multisampling and a filtered shadow: for animations. Solids that are nowhere (not a number, or out
  /// of all reach) are left out. Throws InvalidInput where the camera is not one.
  Image draw(const Picture& picture);
  /// The average of `passes` pictures with jittered light and sub-pixel offsets: soft shadows, ambient occlusion.
  /// Edges are smooth from about 8 passes on. Throws InvalidInput where `passes` is below 1, or as draw does.
  Image draw_still(const Picture& picture, int passes = 16);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace pushback
