/// ./course grade: grades many students at once, each apart from all others. Writes a table, JUnit XML and JSON.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "pushback/common/basics/shard.h"
#include "pushback/tools/classroom/attempt.h"

namespace pushback {

/// A teacher's points of each check, by exercise and check. Without them, the check's own points count.
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
  /// A folder or an archive for each student, named after the student. Anything else is reported and left out.
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

/// Writes a file for each student into out/students. A student whose file has the same answers, points and seed is not
/// graded again. Then it writes results.json, results.xml and the table of all students in it.
void grade(const Grading& grading);

}  // namespace pushback
