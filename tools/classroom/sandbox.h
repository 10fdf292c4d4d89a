/// Where what others wrote is unpacked, compiled and run.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "pushback/common/basics/files.h"

namespace pushback {

using Command = std::vector<std::string>;

inline Command operator+(Command first, const Command& then) {
  first.insert(first.end(), then.begin(), then.end());
  return first;
}

/// A program for the kernel (seccomp), as bubblewrap takes it, for system calls that bubblewrap leaves open, and that no limit of a
/// process covers. It refuses memory that belongs to no process, looking into other processes, and sandboxes within the sandbox.
/// With `one_process`, it also refuses to start another process, so that the limit of one process's memory is the limit of all.
/// Threads may start.
std::string refused_calls(bool one_process);

/// bubblewrap: no network, no environment, at most 32 processes and threads, and nothing to be read but the compiler, the
/// headers of `common` and `chapters`, and what is named: no checks, no answers, no other student. If root calls, the command
/// runs as a user of its own.
class Sandbox {
 public:
  /// Throws InvalidInput where none works here.
  Sandbox();
  /// `writable` is for our tools that read a student's files. They write into the folder and 64 MB of /tmp, and may
  /// start other programs. `readable` is for the student's program, which writes nowhere and remains one process.
  enum class Folder { writable, readable };
  /// `command` in the sandbox, in this folder, and with these files to read.
  Command around(const Command& command, const std::filesystem::path& folder,
                 const std::vector<std::filesystem::path>& readable, Folder may_be = Folder::writable) const;

 private:
  ScratchFolder filters_;  // of system calls
};

}  // namespace pushback
