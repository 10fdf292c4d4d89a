/// The folder in which a reader's own solver grows, and what is remembered of it.
#pragma once

#include <filesystem>
#include <map>
#include <string>

namespace pushback {

class MyFolder {
 public:
  /// Where `folder` is empty: mine/ of the project. Throws InvalidInput where it cannot be made or written to.
  explicit MyFolder(const std::filesystem::path& folder);
  const std::filesystem::path& path() const { return folder_; }
  std::filesystem::path file() const { return folder_ / "solver.h"; }
  bool begun() const { return std::filesystem::exists(file()); }
  /// Some ten lines that compile and do nothing right. What may be there is kept: its name gets .old at its end, or .old2, ...
  void reset();
  /// The text of the file. Throws InvalidInput, saying what to do, where it has no class MySolver.
  std::string text() const;
  /// When the file, or one beside it, was written last.
  std::filesystem::file_time_type written() const;

  bool passed(int chapter) const;
  void set_passed(int chapter, bool passed);
  std::size_t hints(int chapter) const;
  void set_hints(int chapter, std::size_t count);

 private:
  struct Remembered {
    bool passed = false;
    std::size_t hints = 0;
  };
  void write() const;
  std::filesystem::path folder_;
  std::map<int, Remembered> remembered_;
};

}  // namespace pushback
