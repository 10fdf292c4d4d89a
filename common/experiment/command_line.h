/// The command line of an experiment. Only this and command_line.cpp, of what experiments are made of, know CLI11.
#pragma once

#include <CLI/CLI.hpp>

#include "pushback/common/experiment/experiment.h"

namespace pushback {

struct Experiment::CommandLine {
  CLI::App app;
  std::vector<ParameterWithDefault> parameters;
};

}  // namespace pushback
