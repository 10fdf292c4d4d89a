/// Where what others wrote is compiled and run.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "pushback/common/basics/files.h"

namespace pushback {

/// bubblewrap: no network, no writing but in a scratch folder, and to be read only the compiler and the headers: no checks, no
/// answers, no other student. Who is root outside is nobody inside, there are never more than 256 processes and threads, and system calls that no answer needs are
/// refused: those for memory that nobody could count, for looking into other processes, and for sandboxes in the sandbox.
class Sandbox {
 public:
  /// Throws InvalidInput where none works here.
  Sandbox();
  enum class Folder { writable, readable };
  /// `command` in it, with nothing of this process's environment; in this folder, and with these files to read. What it may
  /// write besides, in /tmp and /dev/shm, is memory, 64 MB each.
  std::vector<std::string> around(std::vector<std::string> command, const std::filesystem::path& folder,
                                  const std::vector<std::filesystem::path>& readable,
                                  Folder may_be = Folder::writable) const;

 private:
  ScratchFolder headers_;  // those of Pushback, and nothing else of it
  ScratchFolder filter_;   // of system calls
};

}  // namespace pushback
