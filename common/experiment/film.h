/// Films of frames that are already drawn, put together by ffmpeg.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace pushback {

inline constexpr int frames_per_second = 30;

/// "mp4", "webm", "webp" and "gif".
const std::vector<std::string>& film_formats();

/// Throws std::runtime_error where ffmpeg is missing.
void require_ffmpeg();

/// Plays the frames of these folders (frame_0000.png and on) beside each other, up to three in a row, for `seconds`. A folder
/// with fewer frames stays at its last. The ending of `file` is one of film_formats. Throws std::runtime_error where ffmpeg
/// refuses, InvalidInput where `file` cannot be written.
void write_film(const std::filesystem::path& file, const std::vector<std::filesystem::path>& folders, double seconds);

}  // namespace pushback
