/// A reader's solver as one more variant in the chapter's own sheet and plot.
#pragma once

#include <filesystem>
#include <string>

namespace pushback {

/// The first scene is there in a few seconds; each further one takes a second or more.
enum class ScenesDrawn { first_scene, all, films_too };

/// Fills `to` with sheet.png, plot.png and numbers.md (and films) of the chapter's program, in which the solver in `library`
/// plays each scene with the sweeps and the step of the last variant. Returns what went wrong, in words; empty: nothing.
std::string draw_mine(int chapter, const std::filesystem::path& library, const std::filesystem::path& to,
                      ScenesDrawn drawn);

}  // namespace pushback
