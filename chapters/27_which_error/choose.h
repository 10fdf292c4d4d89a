/// ./course choose for any scenes. With `e.command("--choose", choose)` your own program has the command, too.
#pragma once

#include <filesystem>
#include <functional>
#include <vector>

#include "pushback/common/experiment/scene.h"

namespace pushback {

/// Plays a scene within an error, or with the least error for a time. Prints the predicted time and error, then the measured ones,
/// compared with finer steps, and writes pictures to OUT/choose/SCENE/. Reads its own arguments, where argv[0] is the command's name.
/// The name of the scene is optional if there is only one. Returns the program's exit status, as Experiment::run does.
int choose(const std::vector<Scene>& scenes, int argc, const char* const* argv);

/// The same, but a scene can also be a file. A name that ends in .json is passed to `read`.
int choose_or_read(const std::vector<Scene>& scenes, const std::function<World(const std::filesystem::path&)>& read,
                   int argc, const char* const* argv);

}  // namespace pushback
