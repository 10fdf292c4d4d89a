/// What ./course exercise and ./course mine have in common: a folder to work in, verdicts line by line, hints, watching a file.
#pragma once

#include <filesystem>
#include <functional>
#include <map>

#include "pushback/tools/classroom/judge.h"

namespace pushback {

/// From its capital letter on.
std::string capital(std::string words);

std::string line_of(Passed passed, const std::string& check);

/// The first ten lines that the reader's program printed.
std::string lines_printed(const Attempt& outcome);

/// Calls `check` whenever a header in the folder was written, until interrupted.
[[noreturn]] void watch(const std::filesystem::path& folder, const std::function<void()>& check);

/// A reader's working folder. It stores, for each exercise or chapter by name, whether it is solved and how many hints were shown.
class WorkFolder {
 public:
  explicit WorkFolder(const std::filesystem::path& folder);
  const std::filesystem::path& path() const { return folder_; }
  /// Writes the file. An existing file is kept under the same name with .old, .old2, ... Returns that path, or an empty one.
  std::filesystem::path begin_anew(const std::filesystem::path& file, const std::string& text) const;
  /// What stood there when it was solved; 0: it was not.
  std::uint64_t solved(const std::string& name) const;
  void set_solved(const std::string& name, std::uint64_t state);
  /// Those that were shown already and one more. `page`: has the rest.
  void show_hints(const std::string& name, const std::vector<std::string>& hints, const std::string& page);
  void forget(const std::string& name);
  void forget_all();

 private:
  struct Remembered {
    std::uint64_t solved = 0;
    std::size_t hints = 0;
  };
  void write() const;
  std::filesystem::path folder_;
  std::map<std::string, Remembered> remembered_;
};

}  // namespace pushback
