/// Draws pictures offscreen with OpenGL 3.3 core, on the processor if there is no graphics card.
#pragma once

#include <memory>

#include "pushback/common/render/image.h"
#include "pushback/common/render/picture.h"

namespace pushback {

/// Has its own context, so that any number of painters may exist. Each belongs to the thread that made it. The same picture gives the
/// same bytes on one machine, but another version of the driver may differ in the last bit.
class Painter {
 public:
  /// Throws InvalidInput if a side is below 1 or above 8192, std::runtime_error if no context can be created.
  Painter(int width, int height);
  ~Painter();
  Painter(const Painter&) = delete;
  Painter& operator=(const Painter&) = delete;

  /// One pass with multisampling and filtered shadows, for animations. Omits solids whose pose is not finite or has a
  /// coordinate of 1e9 m or more. Throws InvalidInput if the camera cannot be used.
  Image draw(const Picture& picture);
  /// The average of `passes` pictures with jittered light and sub-pixel offsets, for soft shadows and ambient occlusion. Edges are
  /// smooth from about 8 passes on. Throws InvalidInput if `passes` is below 1 or above 4096, or as `draw` does.
  Image draw_still(const Picture& picture, int passes = 16);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace pushback
