#include "pushback/common/basics/process.h"

#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <memory>
#include <stdexcept>

namespace pushback {

namespace {

/// An unnamed file for the input or output of a program. Unlike a pipe, it never makes one side wait for the other.
class Passage {
 public:
  Passage() : file_(std::tmpfile(), std::fclose) {
    if (!file_) throw std::runtime_error("no file for what goes to a program and comes from it");
  }
  int number() const { return fileno(file_.get()); }
  void fill(std::string_view text) {
    if (std::fwrite(text.data(), 1, text.size(), file_.get()) != text.size())
      throw std::runtime_error("no place for what goes to a program");
    to_begin();
  }
  std::string text() {
    to_begin();
    std::string all;
    std::array<char, 4096> part{};
    while (const std::size_t count = std::fread(part.data(), 1, part.size(), file_.get()))
      all.append(part.data(), count);
    return all;
  }

 private:
  void to_begin() {
    if (std::fseek(file_.get(), 0, SEEK_SET) != 0) throw std::runtime_error("no way back in a file of a program");
  }
  std::unique_ptr<std::FILE, int (*)(std::FILE*)> file_;
};

}  // namespace

Ended run_program(std::vector<std::string> command, double seconds, std::string_view input) {
  // In the foreground, so that an interrupt from the keyboard reaches the program as well.
  command.insert(command.begin(), {"timeout", "--foreground", "--kill-after=5", fmt::format("{}", seconds)});
  std::vector<char*> words;
  for (std::string& word : command) words.push_back(word.data());
  words.push_back(nullptr);
  std::array<Passage, 3> passages;
  passages[0].fill(input);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  for (int i = 0; i < 3; ++i)
    posix_spawn_file_actions_adddup2(&actions, passages[static_cast<std::size_t>(i)].number(), i);
  // Close all other files, because the input and output of another thread's program may be among them.
  posix_spawn_file_actions_addclosefrom_np(&actions, 3);
  pid_t child = 0;
  const auto begin = std::chrono::steady_clock::now();
  const int failure = posix_spawnp(&child, words[0], &actions, nullptr, words.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  if (failure != 0) throw std::runtime_error(fmt::format("'{}' could not be started", fmt::join(command, " ")));
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) continue;
  const int ended = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  // `timeout` returns 124, or 137 if the program still runs five seconds after the signal to end. A program that returns 124
  // or 137 before its time is over was not ended by `timeout`.
  const bool out_of_time = (ended == 124 || ended == 128 + SIGKILL) && seconds > 0 &&
                           std::chrono::steady_clock::now() - begin >= std::chrono::duration<double>(seconds);
  return {out_of_time ? 124 : ended, passages[1].text(), passages[2].text(), WIFSIGNALED(status) ? WTERMSIG(status) : 0,
          out_of_time};
}

}  // namespace pushback
