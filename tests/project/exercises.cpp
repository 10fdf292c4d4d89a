/// The exercises: their checks can fail, each mistake is known by its own hint, and nothing that a student's file does breaks
/// anything else.
#include <set>

#include "pushback/common/basics/input.h"
#include "pushback/tools/classroom/all_exercises.h"
#include "tests/support/answers.h"
#include "tests/support/call.h"

using namespace pushback;

namespace {

const Exercise& example() {  // 02, whose gap is the body of a function
  static const std::vector<Exercise> all = all_exercises();
  return exercise_named(all, "02");
}

/// The numbers that an answer of ours would have sent.
Attempt sent(const Exercise& exercise, const Exercise::Played& answer, std::uint64_t seed) {
  Attempt outcome;
  for (std::size_t check = 0; check < exercise.checks.size(); ++check) {
    outcome.numbers.emplace_back();
    for (std::size_t scene = 0; scene < scenes_of_a_check; ++scene) {
      Random random = random_of(seed, check, scene);
      outcome.numbers.back().push_back(answer(check, random));
    }
  }
  return outcome;
}

}  // namespace

namespace {

void tell_mistakes_apart(std::uint64_t seeds) {
  for (const Exercise& exercise : all_exercises()) {
    for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
      INFO(exercise.name << ", seed " << seed);
      CHECK(judge(exercise, seed, sent(exercise, exercise.right, seed)).passed());
      for (const auto& mistake : exercise.mistakes) {
        const Verdict verdict = judge(exercise, seed, sent(exercise, mistake.played, seed));
        INFO(mistake.name << ": " << verdict.sentence);
        CHECK(verdict.mistake == mistake.name);
        CHECK(contains(verdict.sentence, mistake.hint));
        CHECK(contains(verdict.sentence, " is right: "));
      }
    }
  }
}

void give_the_same_points(std::uint64_t seeds) {
  for (const Exercise& exercise : all_exercises()) {
    for (const auto& mistake : exercise.mistakes) {
      INFO(exercise.name << ": " << mistake.name);
      const std::vector<Passed> once = judge(exercise, 1, sent(exercise, mistake.played, 1)).checks;
      for (std::uint64_t seed = 2; seed <= seeds; ++seed)
        CHECK(judge(exercise, seed, sent(exercise, mistake.played, seed)).checks == once);
    }
  }
}

}  // namespace

TEST_CASE("each exercise: what is right passes, and each mistake is told apart from all others, whatever the seed") {
  tell_mistakes_apart(6);
}

TEST_CASE("a mistake fails the same checks whatever the seed: points are no matter of luck") {
  give_the_same_points(6);
}

TEST_CASE("the same with many more seeds", "[long]") {
  tell_mistakes_apart(20);
  give_the_same_points(30);
}

TEST_CASE("each check measures something that differs from student to student: nobody passes by table") {
  for (const Exercise& exercise : all_exercises()) {
    const Attempt one = sent(exercise, exercise.right, 1), other = sent(exercise, exercise.right, 2);
    for (std::size_t check = 0; check < exercise.checks.size(); ++check) {
      INFO(exercise.name << ": " << exercise.checks[check].says);
      bool differs = false;
      for (std::size_t i = 0; i < exercise.checks[check].quantities.size(); ++i)
        differs = differs || std::abs(one.numbers[check][0][i] - other.numbers[check][0][i]) >
                                 exercise.checks[check].quantities[i].tolerance;
      CHECK(differs);
    }
  }
}

TEST_CASE(
    "each check has its words, points and numbers, and each exercise its task, its gap, hints, and no answer in its "
    "task") {
  std::set<std::string> names;
  for (const Exercise& exercise : all_exercises()) {
    INFO(exercise.name);
    CHECK(names.insert(exercise.name).second);
    CHECK(exercise.hints.size() >= 2);
    CHECK(fs::exists(task_of(exercise)));
    CHECK(lines_of(read_text_file(task_of(exercise))).size() <= 45);  // a page
    const std::string stub = read_text_file(stub_of(exercise));
    CHECK(contains(stub, "// TODO ends"));
    for (std::size_t check = 0; check < exercise.checks.size(); ++check) {
      CHECK(exercise.checks[check].points > 0);
      CHECK_FALSE(exercise.checks[check].says.empty());
      Random random = random_of(1, check, 0);
      const std::size_t sent = exercise.right(check, random).size(), asked = exercise.checks[check].quantities.size();
      CHECK((exercise.checks[check].recorded ? sent > asked : sent == asked));
    }
  }
}

TEST_CASE("an exercise goes by its number or its name, and an unknown one is refused") {
  const std::vector<Exercise> all = all_exercises();
  for (const std::string word : {"03", "3", "baumgarte", "03_baumgarte", "exercises/03_baumgarte.h"})
    CHECK(exercise_named(all, word).name == "03_baumgarte");
  const std::string transfer = "15_limits_motors_springs_transfer";
  for (const std::string& word : {std::string("15-transfer"), std::string("15_transfer"), transfer + ".h"})
    CHECK(exercise_named(all, word).name == transfer);
  for (const std::string word : {"99", "", "03-", "baum", "03-transfer", "3_transfer"})
    CHECK_THROWS_AS(exercise_named(all, word), InvalidInput);
}

TEST_CASE("a number that is not one says so, and no number at all is no pass") {
  const Exercise& exercise = example();
  Attempt outcome = sent(exercise, exercise.right, 1);
  outcome.numbers[0][1][0] = std::numeric_limits<Real>::quiet_NaN();
  CHECK(judge(exercise, 1, outcome).mistake == "not a number");
  outcome = sent(exercise, exercise.right, 1);
  outcome.numbers.back().back().pop_back();
  CHECK_FALSE(judge(exercise, 1, outcome).passed());
  CHECK(judge(exercise, 1, outcome).mistake == "exit");
  CHECK_FALSE(judge(exercise, 1, {}).passed());
  outcome = sent(exercise, exercise.right, 1);
  outcome.numbers.pop_back();
  outcome.problem = "it ended";
  const Verdict verdict = judge(exercise, 1, outcome);
  CHECK(verdict.checks.back() == Passed::not_reached);
  CHECK(verdict.sentence == "it ended");
}

TEST_CASE(
    "a number off by a little more than its tolerance fails, whatever it looks like, and the hint is then a general "
    "one") {
  const Exercise& exercise = example();
  for (std::size_t check = 0; check < exercise.checks.size(); ++check) {
    for (std::size_t i = 0; i < exercise.checks[check].quantities.size(); ++i) {
      for (std::size_t scene = 0; scene < scenes_of_a_check; ++scene) {
        Attempt outcome = sent(exercise, exercise.right, 1);
        outcome.numbers[check][scene][i] += Real(1.5) * exercise.checks[check].quantities[i].tolerance;
        const Verdict verdict = judge(exercise, 1, outcome);
        CHECK(verdict.checks[check] == Passed::no);
        CHECK(verdict.mistake.empty());
        CHECK(contains(verdict.sentence, exercise.checks[check].quantities[i].words));
      }
    }
  }
}

TEST_CASE("only comments and spaces are no answer") {
  const std::string stub = read_text_file(stub_of(example()));
  CHECK(untouched(stub + "\n// I do not know\n/* yet */", stub));
  CHECK_FALSE(untouched(filled_in(example(), "rows[0].apply(0);\n"), stub));
  CHECK(line_of_todo("a\nb\n// TODO\n") == 3);
}
