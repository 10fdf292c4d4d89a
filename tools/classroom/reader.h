/// What ./course exercise and ./course mine have in common: how a verdict is printed, hints, watching a file, putting it away.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <functional>
#include <thread>

#include "pushback/common/basics/process.h"
#include "pushback/tools/classroom/judge.h"

namespace pushback {

inline std::string line_of(Passed passed, const std::string& check) {
  return fmt::format("  {} {}\n", passed == Passed::yes ? "✓" : passed == Passed::no ? "✗" : "·", check);
}

/// The first ten lines that the reader's program printed.
inline std::string lines_printed(const Attempt& outcome) {
  const std::vector<std::string> printed = lines_of(outcome.printed);
  std::string lines;
  for (std::size_t i = 0; i < std::min<std::size_t>(printed.size(), 10); ++i)
    lines += fmt::format("  | {}\n", printed[i]);
  if (printed.size() > 10)
    lines += fmt::format("  | ... and {} lines more that your file printed\n", printed.size() - 10);
  return lines;
}

/// Those that were shown already and one more. Returns how many these are. `page`: has the rest.
inline std::size_t show_hints(const std::vector<std::string>& hints, std::size_t shown, const std::string& page) {
  const std::size_t count = std::min(shown + 1, hints.size());
  for (std::size_t i = 0; i < count; ++i) fmt::print("  {}. {}\n", i + 1, hints[i]);
  if (count == hints.size()) fmt::print("  That was the last one. {} has the rest.\n", page);
  return count;
}

/// Calls `check` whenever `written`, when a file was written last, has changed, until interrupted.
[[noreturn]] inline void watch(const std::function<std::filesystem::file_time_type()>& written,
                               const std::function<void()>& check) {
  using Time = std::filesystem::file_time_type;
  const auto last_written = [&written] {
    try {
      return written();
    } catch (const std::filesystem::filesystem_error&) {  // an editor may save by deleting: it comes back
      return Time{};
    }
  };
  for (Time seen{};;) {
    const Time now = last_written();
    if (now != seen && now != Time{}) {
      fmt::print("\n");
      try {
        check();
      } catch (const std::exception& problem) {  // between being seen and being read a file may be gone
        fmt::print("{}\n", problem.what());
      }
      std::fflush(stdout);
    }
    seen = now;
    std::this_thread::sleep_for(std::chrono::milliseconds(200));
  }
}

/// A file of this name, if there is one, gets .old at its end, or .old2, ... Returns the new name; empty: there was none.
inline std::filesystem::path put_away(const std::filesystem::path& file) {
  if (!std::filesystem::exists(file)) return {};
  std::filesystem::path old = file.string() + ".old";
  for (int i = 2; std::filesystem::exists(old); ++i) old.replace_extension(fmt::format(".old{}", i));
  std::filesystem::rename(file, old);
  return old;
}

}  // namespace pushback
