/// ./course grade: many students at once, each apart from all others; a table, JUnit XML and JSON.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "pushback/common/basics/shard.h"
#include "pushback/tools/classroom/attempt.h"

namespace pushback {

/// Points of each check as a teacher has set them, by exercise and check; where there are none, those of the check itself.
class Points {
 public:
  Points() = default;
  /// A file as `text_of` writes it. Throws InvalidInput, with the line.
  Points(const std::vector<Exercise>& all, const std::filesystem::path& file);
  int of(const Exercise& exercise, std::size_t check) const;
  /// Whether the file had a line on it.
  bool has(const Exercise& exercise) const {
    return set_.lower_bound({exercise.name, 0}) != set_.lower_bound({exercise.name, exercise.checks.size()});
  }

 private:
  std::map<std::pair<std::string, std::size_t>, int> set_;
};
/// A line for each check, to be edited.
std::string points_text(const std::vector<const Exercise*>& exercises);

struct Grading {
  /// A folder or an archive for each student, named after the student; anything else is named, and left out.
  std::vector<std::filesystem::path> given;
  std::vector<const Exercise*> exercises;
  Points points;
  std::filesystem::path out = "grades";
  std::uint64_t seed = 0;  ///< 0: drawn at the first time, and kept in `out`
  int jobs = 1;
  Shard shard;
  bool sandboxed = true;
  AttemptLimits limits;
};

/// Leaves a file for each student in out/students. A student whose file is of the same answers, points and seed is not
/// graded again. Then results.json, results.xml and the table are of all that are there.
void grade(const Grading& grading);

}  // namespace pushback
