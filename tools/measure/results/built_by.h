#pragma once

#include <string>

namespace pushback {

/// The compiler of this program, its version and its arguments.
std::string built_by();

}  // namespace pushback
