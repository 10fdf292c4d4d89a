#include "pushback/tools/classroom/mine/below_command.h"

#include <fmt/format.h>

#include "pushback/common/basics/files.h"
#include "pushback/common/basics/input.h"
#include "pushback/common/basics/process.h"

namespace pushback {

namespace fs = std::filesystem;

bool check_page(const PageOfMine& page, const MyFolder& mine, std::uint64_t seed) {
  for (const PageOfMine& before : pages_of_mine())
    if (before.number < page.number && !fs::exists(mine.path() / before.file()))
      throw InvalidInput(fmt::format("{} stands on {}, and {} is not there: ./course mine {} begins it", page.file(),
                                     before.file(), (mine.path() / before.file()).string(), before.word));
  const fs::path file = mine.path() / page.file();
  if (!fs::exists(file)) {
    write_text_file(file, page.begun_with);
    fmt::print("Yours is {}. What to write: {}\n", file.string(), page.page);
    return true;
  }
  fmt::print("{}: {}\n", page.word, page.title);
  const Exercise exercise = exercise_of_page(page);
  const Attempt outcome = attempt_of_page(exercise, page, mine.path(), seed);
  const Verdict verdict = judge(exercise, seed, outcome);
  for (std::size_t i = 0; i < exercise.checks.size(); ++i)
    fmt::print("  {} {}\n",
               verdict.checks[i] == Passed::yes  ? "✓"
               : verdict.checks[i] == Passed::no ? "✗"
                                                 : "·",
               exercise.checks[i].says);
  if (verdict.passed()) fmt::print("\n  Passed. The page's own beside yours: ./course mine {} --diff\n", page.word);
  else
    fmt::print("\n  {}\n\n  One hint more: ./course mine {} --hint. The same scenes again: --seed {}\n",
               verdict.in_words(), page.word, seed);
  return verdict.passed();
}

void show_hints(const PageOfMine& page, MyFolder& mine) {
  const std::size_t count = std::min(mine.hints(-page.number) + 1, page.hints.size());
  for (std::size_t i = 0; i < count; ++i) fmt::print("  {}. {}\n", i + 1, page.hints[i]);
  if (count == page.hints.size()) fmt::print("  That was the last one. {} has the rest.\n", page.page);
  mine.set_hints(-page.number, count);
}

void show_difference(const PageOfMine& page, const MyFolder& mine) {
  const fs::path file = mine.path() / page.file();
  if (!fs::exists(file))
    throw InvalidInput(fmt::format("{} is not there yet: ./course mine {}", file.string(), page.word));
  const ScratchFolder scratch;
  write_text_file(scratch.path / page.file(), header_of(page));
  const Ended ended =
      run_program({"diff", "-u", "--label", page.page, "--label", file, scratch.path / page.file(), file});
  if (ended.status > 1) throw std::runtime_error("diff failed: " + ended.err);
  fmt::print("{}", ended.status == 0 ? "There is no difference.\n" : ended.out);
}

}  // namespace pushback
