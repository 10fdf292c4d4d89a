/// A student's file, compiled and run: apart from us, with limits, in a sandbox where that is wanted.
#pragma once

#include <filesystem>
#include <map>
#include <mutex>

#include "pushback/tools/classroom/judge.h"

namespace pushback {

struct Limits {
  int seconds = 10;      ///< of the run, of processor time; six times as many by the clock
  int megabytes = 1024;  ///< of memory
  int compile_seconds = 60;
};

/// A folder that is gone with this.
class ScratchFolder {
 public:
  ScratchFolder();
  ~ScratchFolder();
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;
  const std::filesystem::path path;
};

/// bubblewrap: no network, no writing but in a scratch folder, and to be read only the compiler and the headers: no checks, no
/// answers, no other student.
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
};

/// `sandbox`: none where it is null. `program`: where it is kept, to be run again; one that is there is not compiled anew.
Attempt attempt(const Exercise& exercise, const std::filesystem::path& file, std::uint64_t seed, const Sandbox* sandbox,
                const Limits& limits = {}, const std::filesystem::path& program = {});

/// The files with a gap, as students get them: compiled at most once each, and run with the seed of whoever is compared with them.
/// May be asked by several threads.
class UntouchedFiles {
 public:
  /// Trusted, and so in no sandbox.
  Attempt attempt(const Exercise& exercise, std::uint64_t seed);

 private:
  std::mutex& of(const Exercise& exercise);
  ScratchFolder programs_;
  std::mutex talking_;
  std::map<std::string, std::mutex> compiling_;  // by exercise
};

}  // namespace pushback
