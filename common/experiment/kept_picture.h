/// Pictures that git keeps: small files, replaced only where they show something else.
#pragma once

#include <filesystem>

#include "pushback/common/render/image.h"

namespace pushback {

/// Whether an eye sees the same in both. Within the tolerance from one OpenGL to the next, and no four pixels differ
/// so clearly as those of a digit that has changed.
bool shows_the_same(const Image& a, const Image& b);

/// Leaves the file as it is where it shows the same already. Else writes it whole or not at all, with a palette where that
/// shows the same and pngquant is there, in true colour otherwise. Throws InvalidInput, naming the file, where it cannot.
void keep_picture(const std::filesystem::path& file, const Image& image);

}  // namespace pushback
