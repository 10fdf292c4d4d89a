/// Formats names and numbers.
#pragma once

#include <string>

#include "pushback/common/basics/types.h"

namespace pushback {

struct Scene;

/// Three significant digits, or all digits before the point; "< 1e-6" for rounding noise, "–" if the value is not finite.
std::string in_words(Real value, const std::string& unit);
/// A name for file names and the command line, in lower case. ASCII letters, digits and dots stay, symbols are spelt out, and a run of
/// other characters becomes one hyphen.
std::string slug(std::string name);
/// The key of a scene's sheet: see Scene::key.
std::string key_of(const Scene& scene);

}  // namespace pushback
