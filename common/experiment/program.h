/// What every small program does around its work.
#pragma once

#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "pushback/common/basics/input.h"

namespace pushback {

/// Reads the command line and does the work. Returns the program's exit status: 0; 2 after a message where a value cannot be
/// used; 1 where something else went wrong.
template <class Work>
int run_program(CLI::App& app, int argc, const char* const* argv, const Work& work) {
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& problem) {
    return app.exit(problem) == 0 ? 0 : 2;
  }
  try {
    work();
  } catch (const InvalidInput& problem) {
    fmt::print(stderr, "{}\n", problem.what());
    return 2;
  } catch (const std::exception& problem) {
    fmt::print(stderr, "{}\n", problem.what());
    return 1;
  }
  return 0;
}

}  // namespace pushback
