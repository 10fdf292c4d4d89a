/// The tables of scenes from outside.
#pragma once

#include "pushback/tools/measure/outside/play.h"

namespace pushback::outside {

/// Three tables with a row per scene and a column per solver, for results, for overlap and energy, and for times. Scenes in which most
/// of `ours` fail come first.
std::string tables(const std::vector<Played>& all, const std::vector<std::string>& ours);

/// All scenes, with their sources and their criteria.
std::string list_of_scenes();

}  // namespace pushback::outside
