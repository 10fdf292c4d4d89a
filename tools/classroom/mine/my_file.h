/// The folder in which a reader's own solver grows, and what is remembered of it.
#pragma once

#include "pushback/tools/classroom/reader.h"

namespace pushback {

class MyFolder : public WorkFolder {
 public:
  /// Where `folder` is empty: mine/ of the project. Throws InvalidInput where it cannot be made or written to.
  explicit MyFolder(const std::filesystem::path& folder);
  std::filesystem::path file() const { return path() / "solver.h"; }
  bool begun() const { return std::filesystem::exists(file()); }
  /// Some ten lines that compile and do nothing right. What may be there is kept.
  void reset();
  /// The text of the file. Throws InvalidInput, saying what to do, where it has no class MySolver.
  std::string text() const;
  bool passed(int chapter) const { return solved(std::to_string(chapter)) != 0; }
  void set_passed(int chapter, bool passed) { set_solved(std::to_string(chapter), passed ? 1 : 0); }
};

}  // namespace pushback
