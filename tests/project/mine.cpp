/// A solver of one's own: the checks of each chapter, what later chapters keep of them, the known mistakes, and ./course mine as
/// a reader calls it.
#include "pushback/common/basics/files.h"
#include "pushback/common/basics/input.h"
#include "pushback/tools/classroom/kit.h"
#include "pushback/tools/classroom/mine/chapters.h"
#include "pushback/tools/classroom/mine/played.h"
#include "pushback/tools/classroom/mine/verdict.h"
#include "tests/support/call.h"

using namespace pushback;

namespace {

/// The numbers that a solver of ours would have sent: right ones in the checks of which it knows nothing.
Attempt sent(int chapter, int its, const WholeSolver& solver, std::uint64_t seed) {
  const Exercise exercise = exercise_of_chapter(chapter);
  Attempt outcome;
  for (std::size_t check = 0; check < exercise.checks.size(); ++check) {
    const WholeSolver& answer = holds(check, its) ? solver : plain_solver(chapter);
    outcome.numbers.push_back(
        scenes_of([&](std::size_t i, Random& random) { return play(i, random, answer); }, seed, check));
  }
  return outcome;
}

/// What is right in the chapter that asks for a check is right in all that keep it.
void keep(std::uint64_t seed) {
  for (std::size_t check = 0; check < checks_of_chapters().size(); ++check) {
    const auto numbers = [&](int chapter) {
      return scenes_of([&](std::size_t i, Random& random) { return play(i, random, plain_solver(chapter)); }, seed,
                       check);
    };
    const NumbersOfScenes right = numbers(chapter_of_check(check));
    for (const ChapterOfMine& chapter : chapters_of_mine()) {
      if (!holds(check, chapter.number)) continue;
      INFO(chapter.number << ": " << checks_of_chapters()[check].says << ", seed " << seed);
      const NumbersOfScenes its = numbers(chapter.number);
      for (std::size_t scene = 0; scene < its.size(); ++scene)
        CHECK(passes(checks_of_chapters()[check].scene.quantities, right[scene], its[scene]));
    }
  }
}

void tell_apart(std::uint64_t seed, int from, int to) {
  for (int chapter = from; chapter <= to; ++chapter) {
    for (const Slip& slip : slips_in(chapter)) {
      if (slip.chapter != chapter) continue;
      const VerdictOfMine made = verdict_of_numbers(chapter, sent(chapter, chapter, slip.solver, seed), seed);
      INFO(chapter << ", " << slip.name << ", seed " << seed << ": " << made.sentence());
      CHECK_FALSE(made.verdict.passed());
      CHECK(made.slips.size() == 1);
      CHECK(contains(made.sentence(), "You get these numbers if " + slip.name + ". " + slip.hint));
    }
  }
}

/// The plain loop with its first `what` replaced.
std::string edited(int chapter, const std::string& what, const std::string& by) {
  std::string text = plain_loop(chapter);
  REQUIRE(contains(text, what));
  return text.replace(text.find(what), what.size(), by);
}

/// What a stage's lines of a table.csv say, without its name.
std::vector<std::vector<std::string>> column_of(const fs::path& table, const std::string& stage) {
  std::vector<std::vector<std::string>> column;
  for (const std::string& line : lines_of(text_of(table))) {
    std::vector<std::string> fields = fields_of(line);
    if (fields[1] != stage) continue;
    fields.erase(fields.begin() + 1);
    column.push_back(fields);
  }
  return column;
}

/// `does`: what `solve` does with `world`.
std::string solver_that(const std::string& does) {
  return "#include <cstdlib>\n#include <stdexcept>\n#include \"pushback/common/world/step_solver.h\"\n"
         "struct MySolver : pushback::StepSolver {\n  volatile int turns = 0;\n"
         "  void solve(pushback::World& world, pushback::Real, int) override {\n" +
         does + "\n  }\n};\n";
}

/// ./course mine in a folder of its own.
struct Reader {
  Scratch folder;
  Ended call(const std::string& words) const {
    return call_program(MINE_PROGRAM, words + " --in " + (folder / "").string(), 120);
  }
  void write(const std::string& text) const { write_text_file(folder / "solver.h", text); }
};

}  // namespace

TEST_CASE("a right solver of any chapter passes the checks that are kept of earlier ones") {
  keep(1);
}

TEST_CASE("each known mistake of chapters 00 to 05 is told apart") {
  tell_apart(1, 0, 5);
}

TEST_CASE("each known mistake of chapters 06 to 14 and 21 is told apart", "[checked]") {
  tell_apart(1, 6, 14);
  tell_apart(1, 21, 21);
}

TEST_CASE("a solver of one's own: the same with more seeds", "[long]") {
  for (std::uint64_t seed = 2; seed <= 6; ++seed) {
    keep(seed);
    tell_apart(seed, 0, 14);
    tell_apart(seed, 21, 21);
  }
}

TEST_CASE("a mistake of an earlier chapter is told in the solver of a later one") {
  const Scratch folder;
  const VerdictOfMine lost = verdict_of_mine(8, edited(8, "normal.lo = 0;", ""), folder / "", 1);
  CHECK(contains(lost.sentence(), "You get these numbers if the addition of chapter 02 is missing."));
  const VerdictOfMine slip =
      verdict_of_mine(8, edited(8, "beta / dt * separation", "beta * separation"), folder / "", 1);
  CHECK(contains(slip.sentence(), "You get these numbers if 1/h is forgotten."));
}

TEST_CASE("each chapter's plain loop passes as a whole file, also with its rows in another order", "[checked]") {
  const Scratch folder;
  for (const ChapterOfMine& chapter : chapters_of_mine()) {
    const VerdictOfMine made = verdict_of_mine(chapter.number, plain_loop(chapter.number), folder / "", 1);
    INFO(chapter.number << ": " << made.sentence());
    CHECK(made.verdict.passed());
  }
  const std::string forwards = "for (Row& row : normals_) {\n      const Real lambda",
                    backwards =
                        "for (std::size_t i = normals_.size(); i-- > 0;) {\n      Row& row = normals_[i];\n"
                        "      const Real lambda";
  CHECK(verdict_of_mine(8, edited(8, forwards, backwards), folder / "", 1).verdict.passed());
}

TEST_CASE("a whole file that crashes, throws, has no end or does not compile is told so", "[checked]") {
  const Scratch folder;
  const auto kind = [&](const std::string& text) { return verdict_of_mine(0, text, folder / "", 1).outcome.kind; };
  CHECK(kind(solver_that("std::abort();")) == "crash");
  CHECK(kind(solver_that("throw std::runtime_error(\"I give up\");")) == "exception");
  CHECK(kind(solver_that("for (;;) turns = turns + 1;")) == "time");
  CHECK(kind("class MySolver {\n  int x = ;\n};\n") == "does not compile");
}

TEST_CASE("the way of a reader: a file, a verdict, hints, the difference, and back") {
  const Reader reader;
  const auto call = [&](const std::string& words) { return reader.call(words + " --no-sheet"); };
  const Ended first = call("");
  CHECK(first.status == 0);
  CHECK(contains(first.out, "  00  next "));
  const Ended nothing = call("00 --seed 3");
  CHECK(nothing.status == 1);
  CHECK(contains(nothing.out, "nothing changes the bodies"));
  CHECK(call("00 --seed 3").out == nothing.out);
  CHECK_FALSE(contains(call("02 --hint").out, "  2. "));
  CHECK(contains(call("02 --hint").out, "  2. "));
  CHECK(call("02 --diff").status == 2);

  reader.write(plain_loop(2));
  CHECK(call("02").status == 0);
  CHECK(contains(call("").out, "  02  passed "));
  CHECK(contains(call("02 --diff").out, "There is no difference."));

  reader.write(plain_loop(8));
  CHECK(call("08").status == 0);
  CHECK(contains(call("").out, "  11  next "));  // the branches 09 and 10 can wait

  reader.write(edited(3, "normal.lo = 0;", ""));
  CHECK(contains(call("03").out, "Chapter 02, which you had passed: "));
  CHECK(contains(call("").out, "  02  next "));

  reader.write("class MySolver {\n  int x = ;\n};\n");
  CHECK(contains(call("03").out, "int x = ;"));
  reader.write("// none\n");
  CHECK(contains(call("03").err, "no class MySolver"));
  CHECK(call("--reset").status == 0);
  CHECK(text_of(reader.folder / "solver.h.old") == "// none\n");

  const Ended unknown = call("99");
  CHECK(unknown.status == 2);
  CHECK(contains(unknown.err, "unknown chapter '99': one of these is needed: 00, 01"));
  CHECK(call("--hint").status == 2);
  CHECK(call("03 04").status == 2);
  const Ended nowhere = call_program(MINE_PROGRAM, "--in /proc/none");
  CHECK(nowhere.status == 2);
  CHECK(contains(nowhere.err, "proc/none' cannot be written to"));
}

TEST_CASE("beside the hard cases' stages, the plain loop of 08 is stage 08 in every digit") {
  const Reader reader;
  reader.write(plain_loop(8));
  const Ended played = reader.call("hard-cases heavy-1 slopes");
  CHECK(played.status == 0);
  CHECK(played.err.empty());
  CHECK(contains(played.out, "08 friction cone 1, mine 1\n"));
  const fs::path folder = reader.folder / "hard_cases";
  const auto mine = column_of(folder / "table.csv", "mine");
  CHECK(mine.size() == 5);
  CHECK(mine == column_of(folder / "table.csv", "08 friction cone"));
  CHECK(mine != column_of(folder / "table.csv", "07 warm start"));
  CHECK(contains(text_of(folder / "table.md"), "| mine |"));
  CHECK(fs::exists(folder / "overview.png"));
  const Ended unknown = reader.call("hard-cases none");
  CHECK(unknown.status == 2);
  CHECK(contains(unknown.err, "case is 'none': one of these is needed: stack-10, "));

  fs::remove_all(folder);
  reader.write("class MySolver {\n  int x = ;\n};\n");
  const Ended broken = reader.call("hard-cases slopes");
  CHECK(broken.status == 1);
  CHECK(contains(broken.err, "it does not compile as a library: error: expected"));
  CHECK_FALSE(fs::exists(folder));
}

TEST_CASE("a solver that throws, crashes, never ends or leaves ends its case, not the table of hard cases") {
  const Scratch scratch;
  const fs::path library = scratch / "solver.so";
  // One wrong thing for each number of bodies: slopes, squeezed, densities-1-1-100, far-1e5 and its like, born-deep.
  const std::string wrong = solver_that(R"(
    const std::size_t bodies = world.bodies.size();
    if (bodies == 2) throw std::runtime_error("I give up");
    if (bodies == 3) std::abort();
    if (bodies == 4) world.bodies.back().velocity.setConstant(std::nan(""));
    while (bodies == 5) turns = turns + 1;
    if (bodies == 6) std::exit(0);)");
  REQUIRE(make_library(wrong, scratch / "", library, CompiledAs::exercise).empty());
  const auto play = [&](const std::string& cases) {
    return call_program(TABLE_PROGRAM,
                        fmt::format("{} --stages 02 --jobs 1 --no-images --at-most 0.5 --mine {} --out {}", cases,
                                    library.string(), (scratch / "").string()));
  };
  const Ended played = play("slopes squeezed densities-1-1-100 far-1e5 born-deep middle-axis");
  CHECK(played.status == 1);
  CHECK(lines_of(played.err) ==
        std::vector<std::string>{"mine: slopes: threw: I give up", "mine: born-deep: crashed: it left the program",
                                 "mine: squeezed: crashed: Aborted", "mine: far-1e5: no end within 0.5 s"});
  CHECK(contains(played.out, "mine 1\n"));  // one body that nothing touches
  const Ended endless = play("far-1e5 far-1e7 row-sequential row-simultaneous");
  CHECK(contains(endless.err, "mine: row-sequential: no end within 0.5 s\n"));
  CHECK(contains(endless.err, "mine: far-1e7: not played: 3 cases before it had no end\n"));
}

TEST_CASE("error against time: a curve of a reader's solver, or a line that says why there is none", "[checked]") {
  const Reader reader;
  reader.write(solver_that("throw std::runtime_error(\"I give up\");"));
  const Ended wrong = reader.call("study rolling");
  CHECK(wrong.status == 1);
  CHECK(wrong.err == "no diagrams were made: I give up\n");
  CHECK_FALSE(fs::exists(reader.folder / "study"));
  reader.write(plain_loop(8));
  CHECK(reader.call("study rolling").status == 0);
  CHECK(fs::exists(reader.folder / "study" / "work_precision.png"));
  double best = 1;  // m
  for (const std::string& line : lines_of(text_of(reader.folder / "study" / "study.csv")))
    if (const auto fields = fields_of(line); fields[1] == "motion_mine") best = std::min(best, std::stod(fields[5]));
  CHECK(best > 1e-4);
  CHECK(best < 1e-3);
  const Ended unknown = reader.call("study none");
  CHECK(unknown.status == 2);
  CHECK(contains(unknown.err, "motion is 'none': one of these is needed: bounce, "));
}
