/// What students' files may do to whoever checks them, and how the verdict calls it.
#include "pushback/common/basics/input.h"
#include "pushback/common/exercise/shown.h"
#include "pushback/tools/classroom/all_exercises.h"
#include "pushback/tools/classroom/result_sheet.h"
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
  CHECK(verdict_on_lines(right).passed());
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
  fails_as(verdict_with_helper("inline int deep(int n) { return n == -1 ? 0 : 1 + deep(n + 1) % 7; }",
                               "if (deep(1) > 3) normal.apply(1);\n"),
           "crash", "memory that is not its own");
}

TEST_CASE("to print that all has passed, on whatever it prints to, is no pass") {
  for (const std::string to : {"stdout", "stderr"})
    CHECK_FALSE(verdict_with_helper("#include <cstdio>", "std::fputs(\"passed\\nend\\n\", " + to + ");\n").passed());
  const std::string everywhere =
      "#include <unistd.h>\n#include <cstdlib>\nnamespace { const int said = [] {\n"
      "  for (int file = 1; file < 10; ++file) if (write(file, \"x check 0\\nx numbers 0 0\\nx end\\n\", 30) < 0) "
      "continue;\n"
      "  _exit(0);\n  return 0;\n}(); }";
  fails_as(verdict_with_helper(everywhere, right), "exit", "before the first check");
}

TEST_CASE("to answer in the place of the program that asks is no pass") {
  const auto forged = [](const std::string& lines) {
    return "#include <iostream>\n#include <unistd.h>\nnamespace { const int said = [] {\n  std::string word;\n  "
           "std::cin >> word;\n"
           "  for (const std::string line : {" +
           lines + "}) std::cout << word << ' ' << line << std::endl;\n  _exit(0);\n  return 0;\n}(); }";
  };
  fails_as(verdict_with_helper(forged("\"end\""), right), "exit", "before it had given all numbers");
  fails_as(verdict_with_helper(forged("\"check 3\", \"end\""), right), "exit", "before it had given all numbers");
  CHECK_FALSE(
      verdict_with_helper(
          forged("\"check 0\", \"numbers 0\", \"numbers\", \"numbers 0 0 0 0 0 0\", \"check 99999999999999999999\", "
                 "\"check -1\", \"check\", \"nonsense\", \"numbers 1e999 nan x\", \"end\""),
          right)
          .passed());
  fails_as(verdict_with_helper(forged("\"check 0\", \"numbers 0 0 0\", \"numbers 0 0 0\", \"numbers 0 0 0\", \"end\""),
                               right),
           "max for min or sign of the push-out or sign of the cap", "your shallow ball leaves with 0 m/s where ");
}

TEST_CASE("whatever is said of bodies changes no verdict, and no more of it is kept than a picture takes") {
  const std::string helper = R"(#include <cstdio>
#include <string>
#include <unistd.h>
inline bool say_nonsense() {
  char text[200] = {}, word[40] = {};
  if (pread(0, text, sizeof text - 1, 0) < 0 || std::sscanf(text, "%39s", word) != 1) _exit(9);
  const std::string begin = std::string(word) + " shown ";
  std::string lines;
  for (const char* one : {"", "x", "nan", "0 nan nan nan", "1e300 1e300", "-1 -1"}) lines += begin + one + "\n";
  for (int i = 0; i < 1000; ++i) {
    lines += begin + "0";
    for (int j = 0; j < 500; ++j) lines += " 1e300";
    lines += "\n";
  }
  lines += begin + std::string(10000000, '1') + "\n";
  for (int file = 3; file < 10; ++file)
    for (std::size_t at = 0; at < lines.size();) {
      const ssize_t written = write(file, lines.data() + at, lines.size() - at);
      if (written <= 0) break;
      at += static_cast<std::size_t>(written);
    }
  return true;
}
)";
  const auto sent = [&](const std::string& lines) {
    const ScratchFolder scratch;
    const fs::path file = scratch.path / (example().name + ".h");
    std::string text = filled_in(example(), lines);
    write_text_file(file, text.insert(text.find("namespace student"), helper));
    return attempt(example(), file, 1, nullptr, {.seconds = 3, .megabytes = 512});
  };
  const std::string wrong = "normal.apply(-normal.effective_mass * normal.speed());\n";
  for (const std::string& lines : {std::string(right), wrong}) {
    const Attempt quiet = sent(lines), loud = sent("static const bool said = say_nonsense();\n(void)said;\n" + lines);
    const Verdict verdict = judge(example(), 1, loud);
    CHECK(verdict.passed() == (lines == right));
    CHECK(loud.numbers == quiet.numbers);
    CHECK(verdict.sentence == judge(example(), 1, quiet).sentence);
    const auto kept = loud.shown.find({0, 0});
    REQUIRE(kept != loud.shown.end());
    CHECK(kept->second.size() == most_instants);
    CHECK(loud.shown.size() <= example().checks.size() * scenes_of_a_check);
    for (const Numbers& instant : kept->second) CHECK(instant.size() <= most_numbers_shown);
    const Scratch drawn;
    CHECK(write_result_sheet(drawn / "sheet.png", example(), 1, loud, verdict));
  }
}

TEST_CASE("to ask for what is right, or to play the scenes with it, is no pass") {
  const std::string plays = "\nNumbers play(std::size_t check, Random& random, const Answer&) { return ";
  for (const std::string& stolen :
       {"namespace pushback::exercise_03 { Exercise exercise();" + plays + "exercise().right(check, random); } }",
        "namespace pushback::exercise_03 { Exercise stolen() __asm__(\"_ZN8pushback11exercise_038exerciseEv\");" +
            plays + "stolen().right(check, random); } }",
        std::string("namespace pushback::exercise_03 { Exercise exercise(); }\n"
                    "namespace { const pushback::Exercise known = pushback::exercise_03::exercise(); }")})
    fails_as(verdict_with_helper(stolen, "\n"), "does not compile", "declared but never defined");
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

TEST_CASE("in the sandbox there is no answer to be read, nothing to be written outside, and no network") {
  if (const std::string why = no_sandbox(); !why.empty()) {
    WARN("skipped: " << why);
    return;
  }
  const Sandbox sandbox;
  const ScratchFolder folder;
  for (const char* compiler : {"c++", "cc", "g++"})  // Debian has the first two by way of /etc/alternatives
    if (fs::exists(fs::path("/usr/bin") / compiler))
      CHECK(run_program(sandbox.around({compiler, "--version"}, folder.path, {}), 10).status == 0);
  CHECK(verdict_on_lines(right, &sandbox).passed());
  fails_as(verdict_on_lines("while (normal.impulse == 0) normal.apply(0);\n", &sandbox), "time",
           "a loop that never ends");
  fails_as(verdict_on_lines("*reinterpret_cast<volatile int*>(normal.owner) = 1;\n", &sandbox), "crash",
           "memory that is not its own");
  const std::string tests = SOURCE_DIR "/tests/03_baumgarte/exercise/answers.txt",
                    checks = SOURCE_DIR "/tools/classroom/checks/03_baumgarte.cpp";
  REQUIRE(fs::exists(tests));
  REQUIRE(fs::exists(checks));
  for (const std::string& file :
       {tests, checks, std::string("pushback/tools/classroom/checks/03_baumgarte.cpp"), std::string("/etc/passwd")})
    fails_as(verdict_with_helper("#include \"" + file + "\"", right, &sandbox), "does not compile", "there is no file");
  // It throws where it could do what it should not: so to pass is to have been kept from it.
  const std::string helper =
      "#include <fstream>\n#include <stdexcept>\n#include <sys/socket.h>\n#include <netinet/in.h>\n#include "
      "<arpa/inet.h>\n"
      "#include <unistd.h>\n";
  std::string reads;
  for (const std::string& file : {tests, checks, std::string("/etc/passwd"), std::string(SOURCE_DIR "/README.md")})
    reads += "if (std::ifstream(\"" + file + "\")) throw std::runtime_error(\"read\");\n";
  CHECK(verdict_with_helper(helper, reads + right, &sandbox).passed());
  // Nor is the code of mistakes and of what is right in the program that the file becomes.
  const std::string reads_itself =
      "std::ifstream self(\"/proc/self/exe\");\n"
      "static const std::string all{std::istreambuf_iterator<char>(self), {}};\n"
      "if (all.size() < 10000) throw std::runtime_error(\"not read\");\n"
      "if (all.find(std::string(\"8mistakes\") + \"Ev\") != all.npos) throw std::runtime_error(\"read\");\n";
  CHECK(verdict_with_helper(helper + "#include <string>\n#include <iterator>\n", reads_itself + right, &sandbox)
            .passed());
  setenv("SECRET_TOKEN", "of the teacher", 1);
  CHECK(verdict_with_helper(helper + "#include <string>\n#include <iterator>\n",
                            "for (const char* process : {\"1\", \"self\"}) {\n"
                            "  std::ifstream its(std::string(\"/proc/\") + process + \"/environ\");\n"
                            "  const std::string all{std::istreambuf_iterator<char>(its), {}};\n"
                            "  if (all.find(\"SECRET\") != all.npos) throw std::runtime_error(\"read\");\n}\n" +
                                std::string(right),
                            &sandbox)
            .passed());
  for (const std::string file : {"/tmp/x", "/dev/shm/x", "/tmp/y", "x", "/x", "/dev/x"})
    CHECK(verdict_with_helper(
              helper + "#include <vector>\n",
              "static const bool filled = [] {\n  long megabytes = 0;\n"
              "  for (int k = 0; k < 3; ++k) {\n    std::ofstream into(\"" +
                  file +
                  "\" + std::to_string(k));\n"
                  "    for (int i = 0; i < 40 && into.write(std::vector<char>(1 << 20).data(), 1 << 20) && "
                  "into.flush(); ++i) ++megabytes;\n  }\n  return megabytes > 64;\n}();\n"
                  "if (filled) throw std::runtime_error(\"filled\");\n" +
                  right,
              &sandbox)
              .passed());
  const Scratch outside;
  CHECK(verdict_with_helper(
            helper,
            "if (std::ofstream(\"" + (outside / "x").string() + "\")) throw std::runtime_error(\"written\");\n" + right,
            &sandbox)
            .passed());
  CHECK(verdict_with_helper(helper,
                            "sockaddr_in at{}; at.sin_family = AF_INET; at.sin_port = htons(53); at.sin_addr.s_addr = "
                            "inet_addr(\"10.0.0.1\");\n"
                            "const int line = socket(AF_INET, SOCK_DGRAM, 0);\n"
                            "if (line >= 0 && connect(line, reinterpret_cast<sockaddr*>(&at), sizeof at) == 0) throw "
                            "std::runtime_error(\"connected\");\n"
                            "close(line);\n" +
                                std::string(right),
                            &sandbox)
            .passed());
}

TEST_CASE("a file that does not compile gets the first error in plain words, with its line") {
  fails_as(verdict_on_lines("normal.impulse = 0\n"), "does not compile", "a semicolon is missing");
  fails_as(verdict_on_lines("normal.impulse = 0\n"), "does not compile", "    normal.impulse = 0");
  fails_as(verdict_on_lines("normal.impuls = 0;\n"), "does not compile", "has nothing called 'impuls'");
  fails_as(verdict_on_lines("sum = 0;\n"), "does not compile", "nothing here has the name 'sum'");
  fails_as(verdict_on_lines("if (normal.impulse < 0) {\n"), "does not compile",
           "this { is never closed: each { needs a }.");
  fails_as(verdict_on_lines("normal.impulse = normal.n;\n"), "does not compile", "another kind");
  fails_as(verdict_on_lines("extern void helper();\nhelper();\n"), "does not compile", "declared but never defined");
  fails_as(verdict_on(example(), "#pragma once\n", 1), "does not compile", "the last line of the file is missing");
  fails_as(verdict_with_helper("#include \"mine.h\"", right), "does not compile", "there is no file mine.h here");
}
