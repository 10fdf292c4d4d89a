/// Makes films from drawn frames, with ffmpeg.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace pushback {

inline constexpr int frames_per_second = 30;

/// "mp4", "webm", "webp" and "gif".
const std::vector<std::string>& film_formats();

/// Throws std::runtime_error if ffmpeg is missing.
void require_ffmpeg();

/// Writes a film, `seconds` long, of the frames in these folders (frame_0000.png, ...) side by side, three in a row, or two by two for
/// four folders. A folder with fewer frames repeats its last one. The extension of `file` is one of film_formats. Throws
/// std::runtime_error if ffmpeg fails, InvalidInput if `file` has another extension or cannot be written.
void write_film(const std::filesystem::path& file, const std::vector<std::filesystem::path>& folders, double seconds);

}  // namespace pushback
