/// Other programs, run without a shell.
#pragma once

#include <chrono>
#include <functional>
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

/// Is called while a program runs, with the process that is the root of all that it starts. Says after how long it wants to be
/// called again.
using ProcessWatcher = std::function<std::chrono::milliseconds(int process)>;

/// Runs command[0], looked up as a shell does, with the rest as its arguments and `input` on its standard input; no other
/// file of ours is open in it. After `seconds` it is ended; 0: it may take as long as it likes.
Ended run_program(std::vector<std::string> command, double seconds = 0, std::string_view input = "",
                  const ProcessWatcher& watcher = {});

inline std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

}  // namespace pushback
