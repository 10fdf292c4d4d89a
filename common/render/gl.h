/// The OpenGL functions, linked by name: the offscreen libraries bring them all, so that no loader is needed.
#pragma once

#define GL_GLEXT_PROTOTYPES
#include <GL/glcorearb.h>
