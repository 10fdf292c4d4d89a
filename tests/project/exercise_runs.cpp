/// What students' files may do to whoever checks them, and how the verdict calls it.
#include "pushback/common/basics/input.h"
#include "tests/support/answers.h"
#include "tests/support/call.h"

using namespace pushback;

namespace {

const Exercise& example() {  // 03, whose gap is the body of a function
  static const std::vector<Exercise> all = all_exercises();
  return exercise_named(all, "03");
}

constexpr const char* right = "normal.bias = std::min(normal.bias, std::max(-cap, beta / h * normal.separation));\n";

Verdict verdict_on_lines(const std::string& lines, const Sandbox* sandbox = nullptr) {
  return verdict_on(example(), filled_in(example(), lines), 1, sandbox, {.seconds = 3, .megabytes = 512});
}

/// Lines that stand before the function: includes, helpers.
Verdict verdict_with_helper(const std::string& helper, const std::string& lines, const Sandbox* sandbox = nullptr) {
  std::string text = filled_in(example(), lines);
  text.insert(text.find("namespace student"), helper + "\n");
  return verdict_on(example(), text, 1, sandbox, {.seconds = 3, .megabytes = 512});
}

void fails_as(const Verdict& verdict, const std::string& mistake, const std::string& words) {
  INFO(verdict.mistake << ": " << verdict.sentence);
  CHECK_FALSE(verdict.passed());
  CHECK(verdict.mistake == mistake);
  CHECK(contains(verdict.sentence, words));
}

}  // namespace

TEST_CASE("what is right passes, whatever it prints") {
  CHECK(verdict_with_helper("#include <cstdio>", std::string("std::puts(\"failed\");\n") + right).passed());
}

TEST_CASE("an endless loop, NaN, a crash, too much memory, an exception, an exit: each has its words") {
  fails_as(verdict_on_lines("while (normal.impulse == 0) normal.apply(0);\n"), "time", "a loop that never ends");
  fails_as(verdict_on_lines("normal.apply(std::sqrt(-1 - normal.effective_mass));\n"), "not a number", "NaN");
  fails_as(verdict_on_lines("*reinterpret_cast<volatile int*>(normal.owner) = 1;\n"), "crash",
           "memory that is not its own");
  fails_as(verdict_with_helper(
               "#include <vector>\ninline std::vector<double>& kept() { static std::vector<double> all; return all; }",
               "for (;;) kept().resize(2 * kept().size() + 1000, normal.impulse);\n"),
           "memory", "more than 512 MB");
  fails_as(verdict_with_helper("#include <stdexcept>", "throw std::runtime_error(\"no idea\");\n"), "exception",
           "no idea");
  fails_as(verdict_with_helper("#include <cstdlib>", "std::exit(0);\n"), "exit", "before it had answered");
  fails_as(verdict_with_helper("#include <cstdlib>", "std::abort();\n"), "crash", "stopped itself");
  fails_as(verdict_with_helper("#include <cstdio>",
                               "for (;;) std::puts(\"and another thing that goes on and on and on\");\n"),
           "files", "more than 64 MB");
}

TEST_CASE("a file that does not compile gets the compiler's first error in it, with its line") {
  fails_as(verdict_on_lines("normal.impuls = 0;\nnormal.n = 0;\n"), "does not compile",
           "it does not compile. Line 15: \n\n    normal.impuls = 0;\n\n  the compiler says: ");
  fails_as(verdict_on_lines("normal.impulse = std::max(1, 1.0);\n"), "does not compile", "Line 15: ");
  fails_as(verdict_on_lines("std::vector<void> none;\n"), "does not compile", "Line 15: ");  // it shows in <vector>
  fails_as(verdict_on_lines("extern void helper();\nhelper();\n"), "does not compile", "declared but never defined");
  fails_as(verdict_with_helper("#include \"mine.h\"", right), "does not compile", "No such file");
  fails_as(verdict_on(example(), "#pragma once\n", 1), "does not compile", "the compiler says: ");
}

TEST_CASE("to answer in the place of the program that asks, or to ask it for what is right, is no pass") {
  const auto forged = [](const std::string& lines) {
    return "#include <iostream>\n#include <unistd.h>\nnamespace { const int said = [] {\n  std::string word;\n  "
           "std::cin >> word;\n  for (const std::string line : {" +
           lines + "}) std::cout << word << ' ' << line << std::endl;\n  _exit(0);\n  return 0;\n}(); }";
  };
  fails_as(verdict_with_helper(forged("\"check 3\", \"end\""), right), "exit", "before it had given all numbers");
  CHECK_FALSE(
      verdict_with_helper(
          forged("\"check 0\", \"numbers 0\", \"numbers\", \"numbers 0 0 0 0 0 0\", \"check 99999999999999999999\", "
                 "\"check -1\", \"check\", \"nonsense\", \"numbers 1e999 nan x\", \"end\""),
          right)
          .passed());
  fails_as(
      verdict_with_helper("namespace pushback::exercise_03 {\nExercise exercise();\nNumbers play(std::size_t check, "
                          "Random& random, const Answer&) { return exercise().right(check, random); } }",
                          "\n"),
      "does not compile", "declared but never defined");
}

TEST_CASE("a sandbox holds a few hundred processes, whoever watches it") {
  if (const std::string why = no_sandbox(); !why.empty()) {
    WARN("skipped: " << why);
    return;
  }
  const Sandbox sandbox;
  const ScratchFolder folder;
  const auto started = [&](int count) {
    return run_program(sandbox.around({"sh", "-c",
                                       "i=0; while [ $i -lt " + std::to_string(count) +
                                           " ]; do sleep 60 & i=$((i+1)); done; echo all"},
                                      folder.path, {}),
                       60);
  };
  CHECK(started(20).out == "all\n");
  const Ended many = started(2000);
  INFO(many.err);
  CHECK(many.out == "");
  CHECK(many.status != 0);
}
