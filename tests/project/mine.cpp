/// A solver of one's own: the checks of each chapter, what later chapters keep of them, whole files right and wrong, and
/// ./course mine as a reader calls it.
#include "pushback/common/basics/files.h"
#include "pushback/common/basics/input.h"
#include "pushback/tools/classroom/mine/chapters.h"
#include "pushback/tools/classroom/mine/slips.h"
#include "pushback/tools/classroom/mine/verdict.h"
#include "tests/support/call.h"

using namespace pushback;

namespace {

/// The numbers that a solver of ours would have sent.
Attempt sent(const Exercise& exercise, const Exercise::Played& answer, std::uint64_t seed) {
  Attempt outcome;
  for (std::size_t check = 0; check < exercise.checks.size(); ++check)
    outcome.numbers.push_back(scenes_of(answer, seed, check));
  return outcome;
}

void keep_and_tell_apart(std::uint64_t seed) {
  for (int chapter = 0; chapter <= 8; ++chapter) {
    const Exercise exercise = exercise_of_chapter(chapter);
    const Attempt right = sent(exercise, exercise.right, seed);
    for (int earlier = 0; earlier < chapter; ++earlier) {
      INFO(chapter << " against the checks of " << earlier << ", seed " << seed);
      const Exercise asked = exercise_of_chapter(earlier);
      Attempt outcome = right;
      outcome.numbers.resize(asked.checks.size());
      const Verdict verdict = judge(asked, seed, outcome);
      for (std::size_t check = 0; check < asked.checks.size(); ++check)
        if (holds(check, chapter)) CHECK(verdict.checks[check] == Passed::yes);
    }
    for (const auto& mistake : exercise.mistakes) {
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

struct Written {
  std::string name, text;
};

/// tests/mine/NN.txt: under the name of each mistake the lines to be replaced in the plain loop, and by which.
std::vector<Written> wrong_files(int chapter) {
  std::vector<Written> files;
  std::string out, in;
  const auto edit = [&] {
    if (out.empty()) return;
    std::string& text = files.back().text;
    const std::size_t at = text.find(out);
    INFO(chapter << ", " << files.back().name << ": " << out);
    REQUIRE(at != text.npos);
    text.replace(at, out.size(), in);
    out = in = "";
  };
  for (const std::string& line :
       lines_of(text_of(fs::path(SOURCE_DIR) / "tests/mine" / (two_digits(chapter) + ".txt")))) {
    if (line.starts_with("== ")) {
      edit();
      files.push_back({line.substr(3), plain_loop(chapter)});
    } else if (line.starts_with("- ")) {
      if (!in.empty()) edit();
      out += line.substr(2) + "\n";
    } else if (line.starts_with("+")) {
      in += (line.size() > 2 ? line.substr(2) : "") + "\n";
    }
  }
  edit();
  return files;
}

void judge_wrong_files(std::size_t most) {
  const Scratch folder;
  for (int chapter = 1; chapter <= 8; ++chapter) {
    const std::vector<Written> files = wrong_files(chapter);
    CHECK(files.size() >= 8);
    for (std::size_t i = 0; i < std::min(most, files.size()); ++i) {
      const Verdict verdict = verdict_of_mine(chapter, files[i].text, folder / "", 1).verdict;
      INFO(chapter << ", " << files[i].name << ": " << verdict.sentence);
      CHECK(verdict.mistake == files[i].name);
    }
  }
}

}  // namespace

TEST_CASE("a right solver of a later chapter passes what is kept of earlier ones, and each mistake is told apart") {
  keep_and_tell_apart(1);
}

TEST_CASE("a solver of one's own: the same with more seeds", "[long]") {
  for (std::uint64_t seed = 2; seed <= 6; ++seed) keep_and_tell_apart(seed);
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
  for (int chapter = 0; chapter <= 8; ++chapter) {
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
