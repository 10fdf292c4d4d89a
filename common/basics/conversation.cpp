#include "pushback/common/basics/conversation.h"

#include <fmt/ranges.h>
#include <poll.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <stdexcept>
#include <thread>

namespace pushback {

Conversation::Conversation(std::vector<std::string> command) : name_(fmt::format("{}", fmt::join(command, " "))) {
  std::array<int, 2> ends{};
  if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0)
    throw std::runtime_error(fmt::format("no line to '{}'", name_));
  std::vector<char*> words;
  for (std::string& word : command) words.push_back(word.data());
  words.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, ends[1], 0);
  posix_spawn_file_actions_adddup2(&actions, ends[1], 1);
  const int failure = posix_spawnp(&child_, words[0], &actions, nullptr, words.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  close(ends[1]);
  line_ = ends[0];
  if (failure != 0) {
    close(line_);
    throw std::runtime_error(fmt::format("'{}' could not be started", name_));
  }
}

Conversation::~Conversation() {
  shutdown(line_, SHUT_WR);
  int status = 0;
  for (int i = 0; i < 100; ++i) {
    if (waitpid(child_, &status, WNOHANG) != 0) {
      close(line_);
      return;
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  kill(child_, SIGKILL);
  while (waitpid(child_, &status, 0) < 0 && errno == EINTR) {
  }
  close(line_);
}

void Conversation::say(const std::string& line) {
  for (std::size_t said = 0; said < line.size();) {
    const ssize_t now =
        send(line_, line.data() + said, line.size() - said, MSG_NOSIGNAL);  // no SIGPIPE if it has ended
    if (now < 0 && errno == EINTR) continue;
    if (now <= 0) throw std::runtime_error(fmt::format("'{}' has ended, and was to be asked more", name_));
    said += static_cast<std::size_t>(now);
  }
}

std::string Conversation::answer(const std::string& question, double patience) {
  using Clock = std::chrono::steady_clock;
  const auto until =
      Clock::now() + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(patience));
  say(question + "\n");
  while (true) {
    if (const std::size_t end = heard_.find('\n'); end != std::string::npos) {
      const std::string line = heard_.substr(0, end);
      heard_.erase(0, end + 1);
      return line;
    }
    const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(until - Clock::now()).count();
    pollfd there{line_, POLLIN, 0};
    const int ready = left > 0 ? poll(&there, 1, static_cast<int>(left)) : 0;
    if (ready < 0 && errno == EINTR) continue;
    if (ready <= 0) throw std::runtime_error(fmt::format("'{}' gave no answer within {:g} s", name_, patience));
    std::array<char, 65536> part{};
    const ssize_t count = recv(line_, part.data(), part.size(), 0);
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) throw std::runtime_error(fmt::format("'{}' ended without an answer", name_));
    heard_.append(part.data(), static_cast<std::size_t>(count));
  }
}

}  // namespace pushback
