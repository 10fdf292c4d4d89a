/// A reader's solver as a shared object, for the programs that load one: common/experiment/loaded_solver.h.
#pragma once

#include <filesystem>
#include <string>

#include "pushback/tools/classroom/sandbox.h"

namespace pushback {

enum class CompiledAs {
  exercise,  ///< quickly
  chapter    ///< with the settings of this build: for who takes times
};

/// Compiles the solver in `text` to `library`. Headers in `folder` are found by the text. Returns what went wrong, in words;
/// empty: nothing. `sandbox`: for what others wrote; where it is null, there is none.
std::string make_library(const std::string& text, const std::filesystem::path& folder,
                         const std::filesystem::path& library, CompiledAs as = CompiledAs::exercise,
                         const Sandbox* sandbox = nullptr);

/// The last line of what a program said; never empty.
std::string last_line(const std::string& text);

/// The program of this name, beside ours: it may not be built.
std::filesystem::path program_beside(const std::string& name);

}  // namespace pushback
