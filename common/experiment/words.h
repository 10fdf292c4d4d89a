/// How names and numbers are written.
#pragma once

#include <string>

#include "pushback/common/basics/types.h"

namespace pushback {

struct Scene;

/// Three significant digits; what is rounding noise, or no number, says so.
std::string in_words(Real value, const std::string& unit);
/// A name as part of a file's name and as a word on the command line: letters and digits stay, symbols are spelt out, a run
/// of anything else becomes one hyphen.
std::string slug(std::string name);
/// Of a scene's sheet.
std::string key_of(const Scene& scene);

}  // namespace pushback
