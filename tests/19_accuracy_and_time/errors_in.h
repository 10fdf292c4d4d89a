/// The errors of a motion, as the program that plays it prints them.
#pragma once

#include "tests/support/call.h"

/// m, of settings that a program plays.
inline std::vector<double> errors_in(const fs::path& program, const std::string& motion, const std::string& settings) {
  const Ended ended = call_program(program, motion + " " + settings + " --at-least 0 --at-most 600", 120);
  INFO(motion << " " << settings << ": " << ended.err);
  REQUIRE(ended.status == 0);
  std::vector<double> found;
  for (const std::string& line : lines_of(ended.out)) found.push_back(std::stod(line.substr(line.find(" error ") + 7)));
  return found;
}
