/// A student's file, compiled and run: apart from us, with limits, in a sandbox where that is wanted.
#pragma once

#include <filesystem>

#include "pushback/tools/classroom/judge.h"
#include "pushback/tools/classroom/sandbox.h"

namespace pushback {

/// What is more ends the compiler or the program with all that it has started. Seconds are each process's of the processor;
/// six times as many by the clock end all of it: on a machine that compiles many students at once nobody should lose points.
struct Limits {
  int seconds = 10;
  /// Of memory, with all children, and with files in /tmp and /dev/shm, which are memory: added up by a Watch. The kernel's
  /// own limit (RLIMIT_AS) besides holds for each process, so that one that asks for too much at once is told so.
  int megabytes = 1024;
  int processes = 32;  ///< and threads, of the program and of the compiler: counted by a Watch
  int compile_seconds = 60;
  int compile_megabytes = 2048;
  static constexpr int patience = 6;
};

/// `sandbox`: none where it is null.
Attempt attempt(const Exercise& exercise, const std::filesystem::path& file, std::uint64_t seed, const Sandbox* sandbox,
                const Limits& limits = {});

}  // namespace pushback
