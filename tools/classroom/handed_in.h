/// A student's submission, which is a folder or an archive of one.
#pragma once

#include <filesystem>
#include <optional>

#include "pushback/tools/classroom/attempt.h"

namespace pushback {

/// Control characters, those that turn the direction of writing, and bytes that are no UTF-8 as `\x1b`. A name that a student
/// chose could otherwise rewrite a terminal, or break a file of results.
std::string visible(const std::string& text);

/// The student's name, `visible`, from the folder or the archive without its ending. Throws InvalidInput if it is neither.
std::string students_name(const std::filesystem::path& given);

/// 03_baumgarte.h, or solver.h.
std::string file_of(const Exercise& exercise);

class HandedIn {
 public:
  /// An archive is unpacked in the sandbox, if there is one. Throws InvalidInput if tar or unzip is missing.
  HandedIn(const std::filesystem::path& given, const std::vector<const Exercise*>& exercises, const Sandbox* sandbox);
  /// A copy of its file, of less than 1 MB and no link, in the folder or at most two folders deeper, or none. A
  /// whole solver's is solver.h, next to copies of the headers there.
  std::optional<std::filesystem::path> file(const Exercise& exercise) const;
  /// The names and texts of all copies.
  std::string contents() const;
  /// The reason why the submission is not accepted, or empty if it is.
  const std::string& problem() const { return problem_; }

 private:
  void take(const std::filesystem::path& folder, const std::vector<const Exercise*>& exercises);
  ScratchFolder files_, solver_;
  std::string problem_;
};

}  // namespace pushback
