/// A dialogue with another program, in which each question and each answer is one line.
#pragma once

#include <sys/types.h>
#include <string>
#include <vector>

namespace pushback {

class Conversation {
 public:
  /// Starts command[0], found as a shell finds it, with the other words as its arguments. It shares our standard error. Throws
  /// std::runtime_error if it cannot be started.
  explicit Conversation(std::vector<std::string> command);
  /// Closes the program's input, and kills the program if it does not end within 1 s.
  ~Conversation();
  Conversation(const Conversation&) = delete;
  Conversation& operator=(const Conversation&) = delete;

  /// Sends the question and returns the answer, both without an end of line. Throws std::runtime_error, naming the program, if it has
  /// ended or has sent no whole line within `patience`, s.
  std::string answer(const std::string& question, double patience = 20);

 private:
  void say(const std::string& line);

  std::string name_;
  pid_t child_ = 0;
  int line_ = -1;      // a socket for both directions
  std::string heard_;  // received after the last answer
};

}  // namespace pushback
