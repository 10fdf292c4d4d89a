/// The folder in which a student works: a file for each exercise, and what is remembered of them.
#pragma once

#include "pushback/tools/classroom/reader.h"

namespace pushback {

/// Every exercise, by chapter. A transfer follows the rebuild of its chapter.
std::vector<Exercise> all_exercises();
/// 03, 15-transfer: as typed.
std::string short_name(const Exercise& exercise);
/// The exercise that a word names: 03, 3, baumgarte, 03_baumgarte; with -transfer or _transfer for the second one of a chapter.
/// Throws InvalidInput, naming all there are.
const Exercise& exercise_named(const std::vector<Exercise>& all, std::string_view word);
/// Where the task and the file with the gap are.
std::filesystem::path task_of(const Exercise& exercise);
std::filesystem::path stub_of(const Exercise& exercise);
/// The chapter's page, from the top of the project on: chapters/03_baumgarte/README.md. Empty for a teacher's own exercise.
std::filesystem::path page_of(const Exercise& exercise);
/// The file with the gap, in which the task is said to be `task`.
std::string gap_of(const Exercise& exercise, const std::string& task);
/// The number of the first line with the TODO.
std::size_t line_of_todo(const std::string& text);
/// FNV-1a, which is the same on every machine.
std::uint64_t hash_of(const std::string& text);
/// Whether nothing but comments and spaces has changed.
bool untouched(const std::string& text, const std::string& stub);

class StudentFiles : public WorkFolder {
 public:
  /// `folder`: where it is empty, exercises/ of the project, which need not be there; the current one where Pushback is installed.
  /// Throws InvalidInput where a folder is named that does not exist, or is a file.
  explicit StudentFiles(const std::filesystem::path& folder);
  std::filesystem::path file(const Exercise& exercise) const { return path() / (exercise.name + ".h"); }
  /// Beside it, or where all tasks are.
  std::filesystem::path task(const Exercise& exercise) const;
  bool has(const Exercise& exercise) const { return std::filesystem::exists(file(exercise)); }
  /// Whether its code differs from the file with the gap.
  bool begun(const Exercise& exercise) const;
  /// The exercises whose tasks or files are in the folder if it has tasks (a handout), otherwise all.
  std::vector<const Exercise*> listed(const std::vector<Exercise>& all) const;
  /// Writes the file with the gap. Returns where a previous file is kept, or empty if there was none.
  std::filesystem::path reset(const Exercise& exercise);
  /// With the code that it has now, comments aside.
  bool solved(const Exercise& exercise) const;
  void set_solved(const Exercise& exercise);
};

}  // namespace pushback
