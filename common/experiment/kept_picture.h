/// Pictures that git tracks: small files, rewritten only if the picture looks different.
#pragma once

#include <filesystem>

#include "pushback/common/render/image.h"

namespace pushback {

/// Whether both images look the same. They may differ as much as two OpenGL implementations do, but no square of four pixels may
/// differ as clearly as in a changed digit.
bool shows_the_same(const Image& a, const Image& b);

/// Keeps the file if it already looks the same. Otherwise writes it, whole or not at all. The file has a palette if pngquant makes one
/// that is smaller and looks the same, and true colour otherwise. Throws InvalidInput, naming the file, if it cannot be written.
void keep_picture(const std::filesystem::path& file, const Image& image);

}  // namespace pushback
