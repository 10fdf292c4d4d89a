/// ./course mine: a solver of the reader's own, one file that grows from chapter to chapter.
#include <algorithm>
#include <future>
#include <random>

#include "pushback/common/basics/files.h"
#include "pushback/common/basics/process.h"
#include "pushback/common/experiment/program.h"
#include "pushback/tools/classroom/attempt.h"
#include "pushback/tools/classroom/mine/chapters.h"
#include "pushback/tools/classroom/mine/my_file.h"
#include "pushback/tools/classroom/mine/played.h"
#include "pushback/tools/classroom/mine/verdict.h"

using namespace pushback;

namespace fs = std::filesystem;

namespace {

struct Asked {
  std::vector<std::string> words;
  std::string folder;      // empty: mine/ of the project
  std::uint64_t seed = 0;  // 0: another one each time
  bool hint = false, watch = false, reset = false, diff = false, no_sheet = false;
};

/// The next chapter of the trunk, from which the last chapter grows. After the trunk, the next one of a branch, or null.
const ChapterOfMine* next_of(const MyFolder& mine) {
  const std::vector<ChapterOfMine>& chapters = chapters_of_mine();
  for (const bool on_trunk : {true, false}) {
    const auto next = std::ranges::find_if(chapters, [&](const ChapterOfMine& chapter) {
      return grows_from(chapters.back().number, chapter.number) == on_trunk && !mine.passed(chapter.number);
    });
    if (next != chapters.end()) return &*next;
  }
  return nullptr;
}

void list(const MyFolder& mine) {
  const ChapterOfMine* next = next_of(mine);
  for (const ChapterOfMine& chapter : chapters_of_mine()) {
    const char* stands = mine.passed(chapter.number) ? "passed" : next == &chapter ? "next" : "";
    fmt::print("  {}  {:<7} {}\n", two_digits(chapter.number), stands, chapter.title);
  }
  if (next)
    fmt::print("next: chapters/{}/README.md, then {}, then ./course mine {}\n", folder_of(next->number),
               mine.file().string(), two_digits(next->number));
  else fmt::print("all chapters are passed. ./course mine 21 --diff compares the plain loop with your file\n");
}

/// Prints the checks of earlier chapters in one line if they pass, and a line for each check of this one.
void print_checks(const ChapterOfMine& chapter, const VerdictOfMine& made) {
  const auto line = [&](std::size_t i) {
    fmt::print("{}", line_of(made.verdict.checks[i], made.exercise.checks[i].says));
  };
  std::size_t earlier = 0, kept = 0;
  for (std::size_t i = 0; i < made.exercise.checks.size() && chapter_of_check(i) < chapter.number; ++i) {
    if (!holds(i, chapter.number)) continue;
    ++earlier;
    kept += made.verdict.checks[i] == Passed::yes;
    if (made.verdict.checks[i] == Passed::no) line(i);
  }
  if (earlier > 0 && kept == earlier) fmt::print("  ✓ checks of earlier chapters: {} pass\n", earlier);
  for (std::size_t i = 0; i < made.exercise.checks.size(); ++i)
    if (chapter_of_check(i) == chapter.number) line(i);
}

void remember(const ChapterOfMine& chapter, const VerdictOfMine& made, MyFolder& mine) {
  if (made.verdict.passed()) {
    for (const ChapterOfMine& each : chapters_of_mine())
      if (grows_from(chapter.number, each.number)) mine.set_passed(each.number, true);
  }
  for (std::size_t i = 0; i < made.verdict.checks.size(); ++i)
    if (made.verdict.checks[i] == Passed::no) mine.set_passed(chapter_of_check(i), false);
}

/// "Chapter 02, which you had passed: the points ..."
std::string sentence(const ChapterOfMine& chapter, const VerdictOfMine& made, const MyFolder& mine) {
  const std::size_t first = made.first_failing();
  const int its = chapter_of_check(std::min(first, made.verdict.checks.size() - 1));
  if (made.verdict.checks[first] != Passed::no || its == chapter.number) return made.sentence();
  return fmt::format("Chapter {}, which {}: {}", two_digits(its), mine.passed(its) ? "you had passed" : "comes before",
                     made.sentence());
}

/// Prints the verdict, line by line, then draws the picture. True if all checks pass.
bool check(const ChapterOfMine& chapter, MyFolder& mine, const Asked& asked) {
  const std::string number = two_digits(chapter.number), text = mine.text();
  fmt::print("{}: {}\n", number, chapter.title);
  const std::uint64_t seed = asked.seed != 0 ? asked.seed : std::random_device{}();
  // The picture's library is compiled in parallel with the verdict's program, because the reader waits for both.
  const ScratchFolder scratch;
  const fs::path library = scratch.path / "solver.so";
  std::future<std::string> compiled;
  if (!asked.no_sheet)
    compiled = std::async(std::launch::async,
                          [&] { return make_library(text, fs::absolute(mine.path()), library, CompiledAs::exercise); });
  const VerdictOfMine made = verdict_of_mine(chapter.number, text, mine.path(), seed);
  print_checks(chapter, made);
  fmt::print("{}", lines_printed(made.outcome));
  const bool passed = made.verdict.passed();
  if (passed) fmt::print("\n  Passed. Compare the chapter's plain loop with yours: ./course mine {} --diff\n", number);
  else
    fmt::print("\n  {}\n\n  For another hint: ./course mine {} --hint. For the same scenes again: --seed {}\n",
               capital(sentence(chapter, made, mine)), number, seed);
  remember(chapter, made, mine);
  std::fflush(stdout);  // the picture takes a moment
  // What did not come to its end in a scene would not in the picture.
  if (!asked.no_sheet && made.outcome.problem.empty()) {
    const std::string uncompiled = compiled.get();
    const fs::path to = mine.path() / number;
    const auto draw = [&](bool all_scenes, const std::string& files) {
      const std::string wrong = uncompiled.empty() ? draw_mine(chapter.number, library, to, all_scenes) : uncompiled;
      if (wrong.empty()) fmt::print("  Yours next to the chapter's: {}\n", (to / files).string());
      else fmt::print("  No picture was drawn: {}\n", wrong);
      std::fflush(stdout);
      return wrong.empty();
    };
    // While you still write, you wait for one picture.
    if (draw(false, "sheet.png, plot.png, numbers.md") && passed) draw(true, "*.png: all scenes");
  }
  return passed;
}

void show_difference(const ChapterOfMine& chapter, const MyFolder& mine) {
  const std::string number = two_digits(chapter.number);
  if (!mine.passed(chapter.number))
    throw InvalidInput(
        fmt::format("--diff shows the plain loop after your solver has passed: ./course mine {}", number));
  const ScratchFolder scratch;
  write_text_file(scratch.path / "plain.h", plain_loop(chapter.number));
  const Ended ended = run_program({"diff", "-u", "--label", "the plain loop of chapter " + number, "--label",
                                   mine.file(), scratch.path / "plain.h", mine.file()});
  if (ended.status > 1) throw std::runtime_error("diff failed: " + ended.err);
  fmt::print("{}", ended.status == 0 ? "There is no difference.\n" : ended.out);
}

/// `hard-cases` or `study`; true where the solver came to its end.
bool compare(const MyFolder& mine, const Asked& asked) {
  const std::vector<std::string> words(asked.words.begin() + 1, asked.words.end());
  if (asked.words[0] == "hard-cases") {
    const bool ended = play_hard_cases(mine, words);
    fmt::print("Your solver next to the stages: {}, table.md\n",
               (mine.path() / "hard_cases" / "overview.png").string());
    return ended;
  }
  study_with_mine(mine, words);
  fmt::print("Error against time, your solver next to ours: {}, others.md\n",
             (mine.path() / "study" / "work_precision.png").string());
  return true;
}

}  // namespace

int main(int argc, char** argv) {
  Asked asked;
  CommandLine line("Check a solver of your own, one file that grows from chapter to chapter.", "./course mine");
  line.option(
      "CHAPTER", asked.words,
      "00 to 14 or 21, or a chapter's name; without it, show your progress. hard-cases [NAME...] compares your solver "
      "with the stages in the table of hard cases. study [MOTION...] compares error against time with our solvers");
  line.flag("--hint", asked.hint, "Show one more hint each time");
  line.flag("--watch", asked.watch, "Check again at each save, until interrupted");
  line.flag("--diff", asked.diff, "Show the difference between the chapter's plain loop and your file, once it passes");
  line.flag("--reset", asked.reset, "Start again; your file is kept, renamed to end in .old, then .old2, ...");
  line.flag("--no-sheet", asked.no_sheet, "Do not draw your solver next to the chapter's");
  line.option("--seed", asked.seed, "Use this seed, for the same random scenes as last time");
  line.option("--in", asked.folder, "The folder with your file, mine/ by default");
  bool passed = true;
  const int status = line.run(argc, argv, [&] {
    const bool compares = !asked.words.empty() && (asked.words[0] == "hard-cases" || asked.words[0] == "study");
    if (!compares && asked.words.size() > 1)
      throw InvalidInput(fmt::format("only one chapter at a time is allowed, but '{}' was also given", asked.words[1]));
    const ChapterOfMine* chapter = asked.words.empty() || compares ? nullptr : &chapter_of_mine(asked.words[0]);
    if (!chapter && (asked.hint || asked.watch || asked.diff))
      throw InvalidInput("a chapter is needed, 03 for example");
    MyFolder mine(asked.folder);
    if (asked.reset || !mine.begun()) {
      mine.reset();
      fmt::print("Your solver is {}. It compiles, but does nothing yet.\n", mine.file().string());
      if (!asked.watch) return list(mine);
    }
    if (compares) passed = compare(mine, asked);
    else if (!chapter) list(mine);
    else if (asked.hint)
      mine.show_hints(std::to_string(chapter->number), chapter->hints,
                      fmt::format("chapters/{}/README.md", folder_of(chapter->number)));
    else if (asked.diff) show_difference(*chapter, mine);
    else if (asked.watch) watch(mine.path(), [&] { check(*chapter, mine, asked); });
    else passed = check(*chapter, mine, asked);
  });
  return status == 0 && !passed ? 1 : status;
}
