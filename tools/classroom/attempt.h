/// A student's file, compiled and run: apart from us, with limits, in a sandbox where that is wanted.
#pragma once

#include <filesystem>

#include "pushback/tools/classroom/judge.h"
#include "pushback/tools/classroom/sandbox.h"

namespace pushback {

/// The most that a process of the compiler, and the program, may use. Seconds are processor time. Six times as many by the clock
/// end all of it, so that no student loses points on a machine that compiles many at once.
struct AttemptLimits {
  int seconds = 10;
  int megabytes = 1024;  ///< of memory
  int compile_seconds = 60;
  int compile_megabytes = 2048;
  static constexpr int patience = 6;
};

/// `sandbox`: none where it is null.
Attempt attempt(const Exercise& exercise, const std::filesystem::path& file, std::uint64_t seed, const Sandbox* sandbox,
                const AttemptLimits& limits = {});

}  // namespace pushback
