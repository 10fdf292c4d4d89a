/// The exercises, how numbers become a verdict, and what is said of a file that does not compile.
#include <fmt/format.h>

#include "pushback/common/basics/input.h"
#include "tests/support/answers.h"
#include "tests/support/call.h"

using namespace pushback;

namespace {

const Exercise& example() {  // whose gap is the body of a function
  static const std::vector<Exercise> all = all_exercises();
  return exercise_named(all, "02");
}

/// The numbers that an answer of ours would have sent.
Attempt sent(const Exercise& exercise, const Exercise::Played& answer, std::uint64_t seed) {
  Attempt outcome;
  for (std::size_t check = 0; check < exercise.checks.size(); ++check)
    outcome.numbers.push_back(scenes_of(answer, seed, check));
  return outcome;
}

}  // namespace

TEST_CASE("what is right passes, and the file with the gap changes nothing, whatever the seed") {
  for (const Exercise& exercise : all_exercises()) {
    for (std::uint64_t seed = 1; seed <= 6; ++seed) {
      INFO(exercise.name << ", seed " << seed);
      CHECK(judge(exercise, seed, sent(exercise, exercise.right, seed)).passed());
      const Verdict verdict = judge(exercise, seed, sent(exercise, exercise.untouched, seed));
      CHECK(verdict.changes_nothing());
    }
  }
}

TEST_CASE("a check measures something that differs from student to student: nobody passes by table") {
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

TEST_CASE("a number off by a little more than its tolerance fails its check, with the hint of that check") {
  for (const Exercise& exercise : all_exercises()) {
    const Attempt right = sent(exercise, exercise.right, 1);
    for (std::size_t check = 0; check < exercise.checks.size(); ++check) {
      const std::vector<Quantity>& quantities = exercise.checks[check].quantities;
      for (std::size_t i = 0; i < quantities.size(); ++i) {
        Attempt outcome = right;
        outcome.numbers[check][1][i] += std::max(Real(1.5) * static_cast<Real>(quantities[i].tolerance), Real(1e-12));
        const Verdict verdict = judge(exercise, 1, outcome);
        INFO(verdict.sentence);
        CHECK(verdict.checks[check] == Passed::no);
        CHECK(verdict.mistake.empty());
        CHECK(verdict.sentence.starts_with(quantities[i].words));
        CHECK(verdict.sentence.ends_with(" is right: " + exercise.checks[check].hint));
      }
    }
  }
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

TEST_CASE("only comments and spaces are no answer") {
  const std::string stub = read_text_file(stub_of(example()));
  CHECK(untouched(stub + "\n// I do not know\n/* yet */", stub));
  CHECK_FALSE(untouched(filled_in(example(), "rows[0].apply(0);\n"), stub));
}

TEST_CASE("a file that does not compile gets the compiler's first error in it, with its line") {
  const std::vector<Exercise> all = all_exercises();
  const Exercise& capped = exercise_named(all, "03");
  const auto says = [&](const std::string& text, const std::string& words) {
    const Verdict verdict = verdict_on(capped, text, 1);
    INFO(verdict.sentence);
    CHECK(verdict.mistake == "does not compile");
    CHECK(contains(verdict.sentence, words));
  };
  const auto lines = [&](const std::string& written) { return filled_in(capped, written); };
  says(lines("normal.impuls = 0;\nnormal.n = 0;\n"),
       "it does not compile. Line 15: \n\n    normal.impuls = 0;\n\n  the compiler says: ");
  says(lines("std::vector<void> none;\n"), "Line 15: ");  // it shows in <vector>
  says(lines("extern void helper();\nhelper();\n"), "declared but never defined");
#ifdef __clang__
  says("#include \"mine.h\"\n" + lines(""), "'mine.h' file not found");
#else
  says("#include \"mine.h\"\n" + lines(""), "mine.h: No such file");
#endif
  says("#pragma once\n", "the compiler says: ");
}
