#include "pushback/tools/classroom/mine/verdict.h"

#include "pushback/common/basics/files.h"
#include "pushback/tools/classroom/attempt.h"
#include "pushback/tools/classroom/mine/chapters.h"

namespace pushback {

std::size_t VerdictOfMine::first_failing() const {
  std::size_t first = 0;
  while (first < verdict.checks.size() && verdict.checks[first] == Passed::yes) ++first;
  return first;
}

VerdictOfMine verdict_of_mine(int chapter, const std::string& text, const std::filesystem::path& folder,
                              std::uint64_t seed) {
  VerdictOfMine made{exercise_of_chapter(chapter), {}, {}};
  made.exercise.folder = folder.string();
  const ScratchFolder scratch;
  write_text_file(scratch.path / "solver.h", text);
  made.outcome = attempt(made.exercise, scratch.path / "solver.h", seed, nullptr);
  made.verdict = judge(made.exercise, seed, made.outcome);
  return made;
}

}  // namespace pushback
