/// A solver of one's own: the checks of each chapter, what later chapters keep of them, whole files right and wrong, and
/// ./course mine as a reader calls it.
#include "pushback/common/basics/files.h"
#include "pushback/common/basics/input.h"
#include "pushback/tools/classroom/mine/chapters.h"
#include "pushback/tools/classroom/mine/edits.h"
#include "pushback/tools/classroom/mine/lap.h"
#include "pushback/tools/classroom/mine/library.h"
#include "pushback/tools/classroom/mine/slips.h"
#include "pushback/tools/classroom/mine/slips_of_loops.h"
#include "pushback/tools/classroom/mine/verdict.h"
#include "tests/support/call.h"

using namespace pushback;

namespace {

/// The numbers that a solver of ours would have sent: those that are right, where nothing is known of a mistake.
Attempt sent(const Exercise& exercise, const Exercise::Played& answer, std::uint64_t seed) {
  Attempt outcome;
  for (std::size_t check = 0; check < exercise.checks.size(); ++check) {
    outcome.numbers.push_back(scenes_of(answer, seed, check));
    if (outcome.numbers.back()[0].empty()) outcome.numbers.back() = scenes_of(exercise.right, seed, check);
  }
  return outcome;
}

std::vector<int> numbers_of_chapters() {
  std::vector<int> numbers;
  for (const ChapterOfMine& chapter : chapters_of_mine()) numbers.push_back(chapter.number);
  return numbers;
}

bool is_of(int chapter, const std::string& mistake) {
  const auto is_it = [&](const auto& slip) { return slip.name == mistake; };
  const auto& slips = slips_of_loop(chapter);
  return mistake == "nothing new" || std::any_of(slips.begin(), slips.end(), is_it) ||
         (chapter < 8 && std::any_of(known_slips().begin(), known_slips().end(), is_it));
}

void keep_and_tell_apart(std::uint64_t seed, int from, int to) {
  for (const int chapter : numbers_of_chapters()) {
    if (chapter < from || chapter > to) continue;
    const Exercise exercise = exercise_of_chapter(chapter);
    const Attempt right = sent(exercise, exercise.right, seed);
    for (const int earlier : numbers_of_chapters()) {
      if (earlier >= chapter) break;
      INFO(chapter << " against the checks of " << earlier << ", seed " << seed);
      const Exercise asked = exercise_of_chapter(earlier);
      Attempt outcome = right;
      outcome.numbers.resize(asked.checks.size());
      const Verdict verdict = judge(asked, seed, outcome);
      for (std::size_t check = 0; check < asked.checks.size(); ++check)
        if (holds(check, chapter)) CHECK(verdict.checks[check] == Passed::yes);
    }
    for (const auto& mistake : exercise.mistakes) {
      // Those of earlier chapters are there, too. In 08 all are told apart; from 09 on some cannot be seen any more.
      if (chapter != 8 && !is_of(chapter, mistake.name)) continue;
      const Verdict verdict = judge(exercise, seed, sent(exercise, mistake.played, seed));
      INFO(chapter << ", " << mistake.name << ", seed " << seed << ": " << verdict.sentence);
      CHECK_FALSE(verdict.passed());
      CHECK(verdict.mistake == mistake.name);
    }
  }
}

/// Rows from the last contact to the first.
struct Reversed : StepSolver {
  std::unique_ptr<StepSolver> inner = loop_with(8, Slip::none).make();
  void solve(World& world, Real dt, int sweeps) override {
    std::reverse(world.contacts.begin(), world.contacts.end());
    inner->solve(world, dt, sweeps);
    std::reverse(world.contacts.begin(), world.contacts.end());
  }
};

/// Whole files that are wrong: tests/mine/NN.txt has, under the name of each mistake, the lines to be replaced in the plain
/// loop. From 09 on the known mistakes themselves are written in this way.
std::vector<EditedLoop> wrong_files(int chapter) {
  const std::string folder = chapter <= 8 ? "tests/mine/" : "tools/classroom/mine/slips/";
  const fs::path file = fs::path(SOURCE_DIR) / (folder + two_digits(chapter) + ".txt");
  return fs::exists(file) ? edited_loops(text_of(file), plain_loop(chapter)) : std::vector<EditedLoop>();
}

void judge_wrong_files(std::size_t most) {
  const Scratch folder;
  for (const int chapter : numbers_of_chapters()) {
    if (chapter == 0) continue;
    const std::vector<EditedLoop> files = wrong_files(chapter);
    CHECK(files.size() >= 8);
    for (std::size_t i = 0; i < std::min(most, files.size()); ++i) {
      const Verdict verdict = verdict_of_mine(chapter, files[i].text, folder / "", 1).verdict;
      INFO(chapter << ", " << files[i].name << ": " << verdict.sentence);
      CHECK(verdict.mistake == files[i].name);
    }
  }
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

/// Does one wrong thing for each number of bodies: the hard cases `slopes`, `squeezed`, `densities-1-1-100`, `far-1e5`, `born-deep`.
constexpr const char* wrong_in_each_case = R"(
#include <cstdlib>
#include <stdexcept>
#include "pushback/common/world/step_solver.h"
class MySolver : public pushback::StepSolver {
 public:
  void solve(pushback::World& world, pushback::Real, int) override {
    const std::size_t bodies = world.bodies.size();
    if (bodies == 2) throw std::runtime_error("I give up");
    if (bodies == 3) std::abort();
    if (bodies == 4) world.bodies.back().velocity.setConstant(std::nan(""));
    while (bodies == 5) turns_ = turns_ + 1;
    if (bodies == 6) std::exit(0);
  }
 private:
  volatile int turns_ = 0;
};
)";

}  // namespace

TEST_CASE("a right solver of a later chapter passes what is kept of earlier ones, and each mistake is told apart") {
  keep_and_tell_apart(1, 0, 8);
}

TEST_CASE("the same of the chapters behind 08, whose mistakes are edits of their loops", "[checked]") {
  keep_and_tell_apart(1, 9, 99);
}

TEST_CASE("a solver of one's own: the same with more seeds", "[long]") {
  for (std::uint64_t seed = 2; seed <= 6; ++seed) keep_and_tell_apart(seed, 0, 99);
}

TEST_CASE("rows in another order pass") {
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    const Exercise exercise = exercise_of_chapter(8);
    const auto played = [](std::size_t check, Random& random) { return play(check, random, whole_solver<Reversed>()); };
    const Verdict verdict = judge(exercise, seed, sent(exercise, played, seed));
    INFO(verdict.sentence);
    CHECK(verdict.passed());
  }
}

TEST_CASE("each chapter's plain loop passes as a whole file") {
  const Scratch folder;
  for (const int chapter : numbers_of_chapters()) {
    const Verdict verdict = verdict_of_mine(chapter, plain_loop(chapter), folder / "", 1).verdict;
    INFO(chapter << ": " << verdict.sentence);
    CHECK(verdict.passed());
  }
}

TEST_CASE("a wrong whole file of each chapter gets its own hint") {
  judge_wrong_files(1);
}

TEST_CASE("every wrong whole file of each chapter gets its own hint", "[checked]") {
  judge_wrong_files(100);
}

TEST_CASE("the way of a reader: a file, a verdict, hints, the difference, and back") {
  const Scratch scratch;
  const auto call = [&](const std::string& words) {
    return call_program(MINE_PROGRAM, words + " --no-sheet --in " + (scratch / "").string(), 120);
  };
  const fs::path file = scratch / "solver.h";
  const Ended first = call("");
  CHECK(first.status == 0);
  CHECK(contains(first.out, "  00  next "));
  const Ended nothing = call("00 --seed 3");
  CHECK(nothing.status == 1);
  CHECK(contains(nothing.out, "nothing has changed the bodies"));
  CHECK(call("00 --seed 3").out == nothing.out);
  CHECK_FALSE(contains(call("02 --hint").out, "  2. "));
  CHECK(contains(call("02 --hint").out, "  2. "));
  CHECK(call("02 --diff").status == 2);

  write_text_file(file, plain_loop(2));
  CHECK(call("02").status == 0);
  CHECK(contains(call("").out, "  02  passed "));
  CHECK(contains(call("02 --diff").out, "There is no difference."));

  std::string broken = plain_loop(3);
  const std::string clamped = "normal.lo = 0;";
  broken.replace(broken.find(clamped), clamped.size(), "");
  write_text_file(file, broken);
  CHECK(contains(call("03").out, "Chapter 02, which you had passed: "));
  CHECK(contains(call("").out, "  02  broken "));

  write_text_file(file, "class MySolver {\n  int x = ;\n};\n");
  CHECK(contains(call("03").out, "int x = ;"));
  write_text_file(file, "// none\n");
  CHECK(contains(call("03").err, "no class MySolver"));

  CHECK(call("--reset").status == 0);
  CHECK(text_of(scratch / "solver.h.old") == "// none\n");
  const Ended unknown = call("99");
  CHECK(unknown.status == 2);
  CHECK(contains(unknown.err, "unknown chapter '99': one of these is needed: 00, 01"));
  CHECK(call("--hint").status == 2);
  const Ended nowhere = call_program(MINE_PROGRAM, "--in /proc/none");
  CHECK(nowhere.status == 2);
  CHECK(contains(nowhere.err, "--in: folder '"));
  CHECK(contains(nowhere.err, "proc/none' cannot be written to"));  // as seen from where one stands
}

TEST_CASE("beside the hard cases' stages, the plain loop of 08 is stage 08 in every digit") {
  const Scratch scratch;
  write_text_file(scratch / "solver.h", plain_loop(8));
  const Ended played = call_program(MINE_PROGRAM, "hard-cases heavy-1 slopes --in " + (scratch / "").string(), 120);
  CHECK(played.status == 0);
  CHECK(played.err.empty());
  CHECK(contains(played.out, "08 friction cone 1, mine 1\n"));
  const fs::path folder = scratch / "hard_cases";
  const auto mine = column_of(folder / "table.csv", "mine");
  CHECK(mine.size() == 5);
  CHECK(mine == column_of(folder / "table.csv", "08 friction cone"));
  CHECK(mine != column_of(folder / "table.csv", "07 warm start"));
  CHECK(contains(text_of(folder / "table.md"), "| mine |"));
  CHECK(fs::exists(folder / "overview.png"));
  CHECK(column_of(folder / "table.csv", "18 direct joint solve").empty());
}

TEST_CASE("a solver that throws, crashes, never ends or leaves ends its case, not the table of hard cases") {
  const Scratch scratch;
  write_text_file(scratch / "solver.h", wrong_in_each_case);
  const std::string in = " --at-most 2 --in " + (scratch / "").string();
  const Ended played = call_program(
      MINE_PROGRAM, "hard-cases slopes squeezed densities-1-1-100 far-1e5 born-deep middle-axis" + in, 120);
  CHECK(played.status == 1);
  CHECK(lines_of(played.err) ==
        std::vector<std::string>{"mine: slopes: threw: I give up", "mine: born-deep: crashed: it left the program",
                                 "mine: squeezed: crashed: Aborted", "mine: far-1e5: no end within 2 s"});
  CHECK(contains(played.out, "mine 1\n"));  // one body that nothing touches
  const std::string table = text_of(scratch / "hard_cases" / "table.md");
  for (const char* word : {"threw", "crash", "no end", "NaN"}) CHECK(contains(table, fmt::format("✗ –<br>{} |", word)));

  const Ended raced = call_program(MINE_PROGRAM, "race 00-one-box" + in, 120);
  CHECK(raced.status == 1);
  CHECK(contains(raced.out, fmt::format("\n{:<18} I give up\n", "mine")));
  CHECK(contains(raced.out, "\n21 detected once "));
}

TEST_CASE("after three cases without an end, no other is played") {
  const Scratch scratch;
  const fs::path library = scratch / "solver.so";
  REQUIRE(make_library(wrong_in_each_case, scratch / "", library).empty());
  const Ended played =
      call_program(TABLE_PROGRAM, fmt::format("far-1e5 far-1e7 row-sequential row-simultaneous middle-axis --stages 02 "
                                              "--jobs 1 --no-images --at-most 0.2 --mine {} --out {}",
                                              library.string(), (scratch / "").string()));
  CHECK(played.status == 1);
  CHECK(contains(played.err, "mine: row-sequential: no end within 0.2 s\n"));
  CHECK(contains(played.err, "mine: far-1e7: not played: 3 cases before it had no end\n"));
  CHECK(lines_of(played.err).size() == 5);
}

TEST_CASE("a race: what is off in the plain loop of 08 is off in the same file as a reader's") {
  const Scratch scratch;
  write_text_file(scratch / "solver.h", plain_loop(8));
  const auto call = [&](const std::string& words) {
    return call_program(MINE_PROGRAM, words + " --in " + (scratch / "").string(), 120);
  };
  const Ended raced = call("race 03-three-boxes");
  CHECK(raced.status == 0);
  const std::vector<std::string> lines = lines_of(raced.out);
  REQUIRE(lines.size() == 8);
  const auto off = [&](std::size_t line) { return lines[line].substr(lines[line].find(')')); };
  CHECK(lines[2].starts_with("mine "));
  CHECK(off(2) == off(3));
  CHECK(off(2) != off(4));
  CHECK(contains(off(2), " 4.06 mm "));
  const std::optional<Lap> lap = read_lap(call_program(LAP_PROGRAM, "03-three-boxes --solver 'plain loop of 08'").out);
  REQUIRE(lap);
  CHECK(std::abs(lap->overlap - 4.06) < 0.005);
  CHECK(lap->ms_per_step > 0);
  CHECK(call_program(LAP_PROGRAM, "13-door --solver 'plain loop of 08'").status == 2);  // it holds no joints

  const Ended scene = call("race none"), scenes = call("race"), cases = call("hard-cases none");
  CHECK(scene.status == 2);
  CHECK(contains(scene.err, "scene is 'none': one of these is needed: 00-one-hit, "));
  CHECK(scenes.status == 2);
  CHECK(cases.status == 2);
  CHECK(contains(cases.err, "case is 'none': one of these is needed: stack-10, "));
  CHECK(call("03 04").status == 2);
  CHECK(call("race 03-three-boxes --at-most nan").status == 2);
  write_text_file(scratch / "solver.h", "class MySolver {\n  int x = ;\n};\n");
  const Ended broken = call("hard-cases slopes");
  CHECK(broken.status == 1);
  CHECK(contains(broken.err, "it does not compile as a library: error: expected"));
  CHECK_FALSE(fs::exists(scratch / "hard_cases"));
}

TEST_CASE("error against time: a curve of a reader's solver, or a line that says why there is none", "[checked]") {
  const Scratch scratch;
  const auto study = [&](const std::string& text) {
    write_text_file(scratch / "solver.h", text);
    return call_program(MINE_PROGRAM, "study rolling --in " + (scratch / "").string(), 120);
  };
  const Ended wrong = study(
      "#include <stdexcept>\n#include \"pushback/common/world/step_solver.h\"\n"
      "struct MySolver : pushback::StepSolver {\n"
      "  void solve(pushback::World&, pushback::Real, int) { throw std::runtime_error(\"I give up\"); }\n};\n");
  CHECK(wrong.status == 1);
  CHECK(wrong.err == "there are no diagrams: I give up\n");
  CHECK_FALSE(fs::exists(scratch / "study"));
  CHECK(study(plain_loop(8)).status == 0);
  CHECK(fs::exists(scratch / "study" / "work_precision.png"));
  double best = 1;  // m
  for (const std::string& line : lines_of(text_of(scratch / "study" / "study.csv")))
    if (const auto fields = fields_of(line); fields[1] == "motion_mine") best = std::min(best, std::stod(fields[5]));
  CHECK(best > 1e-4);
  CHECK(best < 1e-3);
  const Ended unknown = call_program(MINE_PROGRAM, "study none --in " + (scratch / "").string());
  CHECK(unknown.status == 2);
  CHECK(contains(unknown.err, "motion is 'none': one of these is needed: bounce, "));
}

TEST_CASE("in the sheet of 07 a reader's loop stands in half steps, as the chapter's own does", "[checked]") {
  const Scratch scratch;
  write_text_file(scratch / "solver.h", plain_loop(7));
  CHECK(call_program(MINE_PROGRAM, "07 --seed 1 --in " + (scratch / "").string(), 120).status == 0);
  std::string warm, mine;  // of the first scene
  for (const std::string& line : lines_of(text_of(scratch / "07/numbers.md"))) {
    if (warm.empty() && contains(line, " warm, 5 sweeps |")) warm = line.substr(line.find("sweeps") + 8);
    if (mine.empty() && contains(line, " mine, 5 sweeps |")) mine = line.substr(line.find("sweeps") + 8);
  }
  REQUIRE_FALSE(warm.empty());
  const auto column = [](std::string line, int number) {
    for (; number > 0; --number) line.erase(0, line.find('|') + 1);
    return line.substr(0, line.find('|'));
  };
  CHECK(column(mine, 0) == column(warm, 0));  // drift
  CHECK(column(mine, 1) == " – ");            // of rows it says nothing
  CHECK(column(mine, 2) == column(warm, 2));  // overlap
}
