/// The tables of scenes from outside.
#pragma once

#include "pushback/tools/measure/outside/play.h"

namespace pushback::outside {

/// Three tables, a row for each scene and a column for each solver: what came of it; overlap and energy; time. First the scenes in
/// which most of `ours` fail.
std::string tables(const std::vector<Played>& all, const std::vector<std::string>& ours);

/// All scenes, with their sources and with what must come of each.
std::string list_of_scenes();

}  // namespace pushback::outside
