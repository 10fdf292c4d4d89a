/// What a student has handed in: a folder, or an archive of one. Of an archive nothing is unpacked by its own names: the files
/// that are wanted come out of it one by one, as text.
#pragma once

#include <filesystem>
#include <optional>

#include "pushback/tools/classroom/attempt.h"

namespace pushback {

/// Of the student: that of the folder, or of the archive without its ending. Throws InvalidInput where it is neither.
std::string students_name(const std::filesystem::path& given);

/// 03_baumgarte.h; solver.h.
std::string file_of(const Exercise& exercise);

class HandedIn {
 public:
  /// Throws InvalidInput where the program that reads such an archive is not installed.
  HandedIn(const std::filesystem::path& given, const std::vector<const Exercise*>& exercises, const Sandbox* sandbox);
  /// Its file, of less than 1 MB and no link, in the folder or in its folder exercises; none where there is none. A whole
  /// solver's is solver.h, in the folder or in its folder mine: a copy of it, beside copies of the headers there.
  std::optional<std::filesystem::path> file(const Exercise& exercise) const;
  /// Of an archive that cannot be read, in words; empty: there is none.
  const std::string& problem() const { return problem_; }

 private:
  std::optional<ScratchFolder> unpacked_, solver_;
  std::filesystem::path folder_;
  std::string problem_;
};

}  // namespace pushback
