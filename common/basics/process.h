/// Other programs, run without a shell.
#pragma once

#include <sstream>
#include <string>
#include <string_view>
#include <vector>

namespace pushback {

/// How a program ended.
struct Ended {
  int status = -1;  ///< 127 where there is no such program, 124 where it took too long, -1 where a signal ended it
  std::string out, err;
  int signal = 0;            ///< the one that ended it; 0: none
  bool out_of_time = false;  ///< it took too long; a program may also return 124 by itself
};

/// Runs command[0], looked up as a shell does, with the rest as its arguments and `input` on its standard input; no other
/// file of ours is open in it. After `seconds` it is ended; 0: it may take as long as it likes.
Ended run_program(std::vector<std::string> command, double seconds = 0, std::string_view input = "");

inline std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

}  // namespace pushback
