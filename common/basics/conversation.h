/// A program that is asked, a line at a time, and answers each with a line.
#pragma once

#include <sys/types.h>
#include <string>
#include <vector>

namespace pushback {

class Conversation {
 public:
  /// Starts command[0], looked up as a shell does, with the rest as its arguments. Its standard error stays ours. Throws
  /// std::runtime_error where it cannot be started.
  explicit Conversation(std::vector<std::string> command);
  /// It is told that nothing more comes, and ended if it does not end by itself within a second.
  ~Conversation();
  Conversation(const Conversation&) = delete;
  Conversation& operator=(const Conversation&) = delete;

  /// `question`: without an end of line. Throws std::runtime_error, naming the program, where it has ended, or has said no whole line
  /// after `patience`, s.
  std::string answer(const std::string& question, double patience = 20);

 private:
  void say(const std::string& line);

  std::string name_;
  pid_t child_ = 0;
  int line_ = -1;      // a socket: what both sides write to and read from
  std::string heard_;  // of the line after the last answer
};

}  // namespace pushback
