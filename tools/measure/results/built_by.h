#pragma once

#include <string>

namespace pushback {

/// The compiler of this program, its version, and how it was called.
std::string built_by();

}  // namespace pushback
