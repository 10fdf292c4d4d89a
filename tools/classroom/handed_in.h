/// What a student has handed in: a folder, or an archive of one. Nothing is unpacked by its own name: the files that are
/// wanted are read one by one, as text, into folders of ours.
#pragma once

#include <filesystem>
#include <optional>

#include "pushback/tools/classroom/attempt.h"

namespace pushback {

/// Control characters, those that turn the direction of writing, and bytes that are no UTF-8 as `\x1b`. A name that a student
/// chose could otherwise rewrite a terminal, or break a file of results.
std::string visible(const std::string& text);

/// Of the student, `visible`: that of the folder, or of the archive without its ending. Throws InvalidInput where it is neither.
std::string students_name(const std::filesystem::path& given);

/// 03_baumgarte.h; solver.h.
std::string file_of(const Exercise& exercise);

class HandedIn {
 public:
  /// Throws InvalidInput where the program that reads such an archive is not installed.
  HandedIn(const std::filesystem::path& given, const std::vector<const Exercise*>& exercises, const Sandbox* sandbox);
  /// A copy of its file, of less than 1 MB and no link, in the folder or at most two folders deeper; none if there is none. A
  /// whole solver's is solver.h, next to copies of the headers there.
  std::optional<std::filesystem::path> file(const Exercise& exercise) const;
  /// Why nothing is taken, in words; empty: there is no reason.
  const std::string& problem() const { return problem_; }

 private:
  ScratchFolder files_, solver_;
  std::string problem_;
};

}  // namespace pushback
