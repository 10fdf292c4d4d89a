#include "pushback/tools/classroom/mine/verdict.h"

#include "pushback/common/basics/files.h"
#include "pushback/tools/classroom/attempt.h"
#include "pushback/tools/classroom/mine/chapters.h"

namespace pushback {

namespace {

/// Behind the reader's text, so that its lines keep their numbers.
constexpr const char* as_answer = R"(
#include "pushback/common/exercise/whole_solver.h"
namespace mine {}
namespace empty_file {}
namespace student {
using namespace mine;
using namespace empty_file;
const pushback::WholeSolver answer = pushback::whole_solver<MySolver>();
}
)";

}  // namespace

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
  write_text_file(scratch.path / "solver.h", text + as_answer);
  made.outcome = attempt(made.exercise, scratch.path / "solver.h", seed, nullptr);
  made.verdict = judge(made.exercise, seed, made.outcome);
  return made;
}

}  // namespace pushback
