#include "pushback/tools/classroom/reader.h"

#include <fmt/format.h>

#include <chrono>
#include <sstream>
#include <thread>

#include "pushback/common/basics/files.h"
#include "pushback/common/basics/process.h"

namespace pushback {

namespace fs = std::filesystem;

namespace {

constexpr const char* memory = ".remembered";

constexpr auto never = fs::file_time_type::min();

/// When a header in the folder was last written. An editor may delete a file before it saves it, or rename a new file into its place,
/// so a missing file is no error.
fs::file_time_type last_written(const fs::path& folder) {
  std::error_code gone;
  fs::file_time_type last = never;
  for (const auto& entry : fs::directory_iterator(folder, gone)) {
    if (entry.path().extension() != ".h" || !fs::is_regular_file(entry.path(), gone)) continue;
    const fs::file_time_type its = fs::last_write_time(entry.path(), gone);
    if (!gone) last = std::max(last, its);
  }
  return last;
}

}  // namespace

std::string capital(std::string words) {
  if (!words.empty()) words[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(words[0])));
  return words;
}

std::string line_of(Passed passed, const std::string& check) {
  return fmt::format("  {} {}\n", passed == Passed::yes ? "✓" : passed == Passed::no ? "✗" : "·", check);
}

std::string lines_printed(const Attempt& outcome) {
  const std::vector<std::string> printed = lines_of(outcome.printed);
  std::string lines;
  for (std::size_t i = 0; i < std::min<std::size_t>(printed.size(), 10); ++i)
    lines += fmt::format("  | {}\n", printed[i]);
  if (printed.size() > 10)
    lines += fmt::format("  | ... and {} more lines that your file printed\n", printed.size() - 10);
  return lines;
}

void watch(const fs::path& folder, const std::function<void()>& check) {
  for (fs::file_time_type seen = never;;) {
    const fs::file_time_type now = last_written(folder);
    if (now != seen && now != never) {
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

WorkFolder::WorkFolder(const fs::path& folder) : folder_(folder) {
  if (!fs::exists(folder_ / memory)) return;
  std::istringstream lines(read_text_file(folder_ / memory));
  std::string name;
  for (Remembered one; lines >> name >> one.solved >> one.hints;) remembered_[name] = one;
}

fs::path WorkFolder::begin_anew(const fs::path& file, const std::string& text) const {
  fs::create_directories(folder_);
  fs::path old;
  if (fs::exists(file)) {
    old = file.string() + ".old";
    for (int i = 2; fs::exists(old); ++i) old.replace_extension(fmt::format(".old{}", i));
    fs::rename(file, old);
  }
  write_text_file(file, text);
  return old;
}

std::uint64_t WorkFolder::solved(const std::string& name) const {
  const auto found = remembered_.find(name);
  return found == remembered_.end() ? 0 : found->second.solved;
}

void WorkFolder::set_solved(const std::string& name, std::uint64_t state) {
  remembered_[name].solved = state;
  write();
}

void WorkFolder::show_hints(const std::string& name, const std::vector<std::string>& hints, const std::string& page) {
  std::size_t& count = remembered_[name].hints;
  count = std::min(count + 1, hints.size());
  for (std::size_t i = 0; i < count; ++i) fmt::print("  {}. {}\n", i + 1, hints[i]);
  if (count == hints.size()) fmt::print("  That was the last hint. {} explains the rest.\n", page);
  write();
}

void WorkFolder::forget(const std::string& name) {
  remembered_.erase(name);
  write();
}

void WorkFolder::forget_all() {
  remembered_.clear();
  write();
}

void WorkFolder::write() const {
  std::string text;
  for (const auto& [name, remembered] : remembered_)
    text += fmt::format("{} {} {}\n", name, remembered.solved, remembered.hints);
  write_text_file(folder_ / memory, text);
}

}  // namespace pushback
