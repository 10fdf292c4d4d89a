/// What stands under a solver of one's own: the checks of the three pages, and a solver on the pages' bodies.
#include "pushback/common/basics/files.h"
#include "pushback/tools/classroom/mine/below.h"
#include "pushback/tools/classroom/mine/chapters.h"
#include "pushback/tools/classroom/mine/verdict.h"
#include "tests/support/call.h"

using namespace pushback;

namespace {

Verdict verdict_of(const Exercise& exercise, const Exercise::Played& played, std::uint64_t seed) {
  Attempt outcome;
  for (std::size_t check = 0; check < exercise.checks.size(); ++check)
    outcome.numbers.push_back(scenes_of(played, seed, check));
  return judge(exercise, seed, outcome);
}

/// Each page's own mistakes: those of pages before come first among its exercise's.
void tell_apart(std::uint64_t seed) {
  std::size_t earlier = 0;
  for (const PageOfMine& page : pages_of_mine()) {
    const Exercise exercise = exercise_of_page(page);
    CHECK(verdict_of(exercise, exercise.right, seed).passed());
    for (; earlier < exercise.mistakes.size(); ++earlier) {
      const auto& mistake = exercise.mistakes[earlier];
      const Verdict verdict = verdict_of(exercise, mistake.played, seed);
      INFO(page.word << ", " << mistake.name << ", seed " << seed << ": " << verdict.sentence);
      CHECK(verdict.mistake == mistake.name);
    }
  }
}

struct Wrong {
  int page;
  std::string name, line, by;
};

void write_pages(const Scratch& folder, int up_to) {
  for (const PageOfMine& page : pages_of_mine())
    if (page.number <= up_to) write_text_file(folder / page.file(), header_of(page));
}

void judge_wrong_headers(const std::vector<Wrong>& all) {
  const Scratch scratch;
  for (const Wrong& wrong : all) {
    write_pages(scratch, 3);
    const PageOfMine& page = pages_of_mine()[static_cast<std::size_t>(wrong.page - 1)];
    std::string text = header_of(page);
    REQUIRE(contains(text, wrong.line));
    text.replace(text.find(wrong.line), wrong.line.size(), wrong.by);
    write_text_file(scratch / page.file(), text);
    const Exercise exercise = exercise_of_page(page);
    const Verdict verdict = judge(exercise, 1, attempt_of_page(exercise, page, scratch / "", 1));
    INFO(wrong.name << ": " << verdict.sentence);
    CHECK(verdict.mistake == wrong.name);
  }
}

}  // namespace

TEST_CASE("each known mistake in a body, a touch or a name is told apart, and the pages' own code passes") {
  tell_apart(1);
}

TEST_CASE("bodies, touches and names of one's own: the same with more seeds", "[long]") {
  for (std::uint64_t seed = 2; seed <= 10; ++seed) tell_apart(seed);
}

TEST_CASE("from an empty file: the way of a reader through the three pages") {
  const Scratch scratch;
  const auto call = [&](const std::string& words) {
    return call_program(MINE_PROGRAM, words + " --in " + (scratch / "").string(), 120);
  };
  const Ended early = call("touch");
  CHECK(early.status == 2);
  CHECK(contains(early.err, "touch.h stands on body.h, and "));
  for (const PageOfMine& page : pages_of_mine()) {
    const Ended begun = call(page.word);
    CHECK(begun.status == 0);
    CHECK(contains(begun.out, "What to write: " + page.page));
    CHECK(call(page.word + " --diff").status == 0);
    const Ended nothing = call(page.word + " --seed 3");
    INFO(nothing.out);
    CHECK(nothing.status == 1);
    CHECK(contains(nothing.out, page.number == 1   ? "this is the file as it began"
                                : page.number == 2 ? "no points were found"
                                                   : "boxes were found to touch nowhere"));
    CHECK_FALSE(contains(call(page.word + " --hint").out, "  2. "));
    CHECK(contains(call(page.word + " --hint").out, "  2. "));
    write_pages(scratch, page.number);
    CHECK(call(page.word).status == 0);
    CHECK(contains(call(page.word + " --diff").out, "There is no difference."));
  }
  CHECK(call("body --reset").status == 0);
  CHECK(text_of(scratch / "body.h.old") == header_of(pages_of_mine()[0]));
  CHECK(contains(text_of(scratch / "body.h"), "./course mine body"));
}

TEST_CASE("a wrong header is called by its name") {
  judge_wrong_headers(
      {{2, "cross products of any length", "(n.dot(way) < 0 ? -1 : 1) / length", "(n.dot(way) < 0 ? -1 : 1)"}});
}

TEST_CASE("wrong headers of each page are called by their names", "[checked]") {
  judge_wrong_headers({{1, "masses, not their inverses", "body.inverse_mass = 1 / mass", "body.inverse_mass = mass"},
                       {1, "ω kept", "  body.angular_velocity = world_inverse_inertia(body) * momentum;\n", ""},
                       {1, "the quaternion grows", "turned.normalized()", "turned"},
                       {1, "P × r", "(point - body.position).cross(impulse)", "impulse.cross(point - body.position)"},
                       {1, "what nothing moves falls", "if (body.inverse_mass > 0) body.velocity", "body.velocity"},
                       {2, "six axes", "if (!overlaps(axes_a.col(i).cross(axes_b.col(j)), i, j)) return false;", "{}"},
                       {3, "faces left out", "36 * faces + corner.name", "corner.name"},
                       {3, "no names", "36 * faces + corner.name", "0"},
                       {3, "not clipped", "    polygon = clip(", "    clip("}});
}

TEST_CASE("a solver of chapter 07 on the bodies of the first page passes the checks of 07") {
  const Scratch scratch;
  write_pages(scratch, 1);
  const std::string text = text_of(fs::path(SOURCE_DIR) / "docs/from_an_empty_file/solver.h");
  const Verdict verdict = verdict_of_mine(7, text, scratch / "", 1).verdict;
  INFO(verdict.sentence);
  CHECK(verdict.passed());
}
