/// Other programs, run without a shell.
#pragma once

#include <sstream>
#include <string>
#include <string_view>
#include <vector>

namespace pushback {

/// How a program ended.
struct Ended {
  int status = -1;  ///< 127 if there is no such program, 124 if it ran out of time, -1 if a signal ended it
  std::string out, err;
  int signal = 0;            ///< the signal that ended it; 0: none
  bool out_of_time = false;  ///< it ran out of time; a program may also return 124 by itself
};

/// Runs command[0], found as a shell finds it, with the other words as its arguments and `input` on its standard input. The
/// program inherits no other open file. It is ended after `seconds`; 0: no limit. Throws std::runtime_error if it cannot be
/// started, or if a temporary file cannot be made or written.
Ended run_program(std::vector<std::string> command, double seconds = 0, std::string_view input = "");

inline std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

}  // namespace pushback
