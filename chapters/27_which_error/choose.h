/// ./course choose, for scenes of anybody's: with `e.command("--choose", choose)` a program of one's own has it, too.
#pragma once

#include <filesystem>
#include <functional>
#include <vector>

#include "pushback/common/experiment/scene.h"

namespace pushback {

/// A scene within an error, or the least error for a time: what it takes and what it will be off by, then what it took and was,
/// measured against finer steps, and pictures in OUT/choose/SCENE/. Reads its own words, argv[0] being how it was called; a scene
/// need not be named where there is one. Returns the program's exit status, as Experiment::run does.
int choose(const std::vector<Scene>& scenes, int argc, const char* const* argv);

/// The same, where a scene may be a file: a word that ends in .json is handed to `read`.
int choose_or_read(const std::vector<Scene>& scenes, const std::function<World(const std::filesystem::path&)>& read,
                   int argc, const char* const* argv);

}  // namespace pushback
