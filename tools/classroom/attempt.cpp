#include "pushback/tools/classroom/attempt.h"

#include <fmt/format.h>

#include <charconv>
#include <chrono>
#include <csignal>
#include <random>

#include "pushback/common/basics/files.h"
#include "pushback/common/basics/input.h"
#include "pushback/common/basics/process.h"
#include "pushback/tools/classroom/kit.h"
#include "pushback/tools/classroom/student_files.h"

namespace pushback {

namespace fs = std::filesystem;

namespace {

Command limited(int seconds, int megabytes, const Command& command) {
  Command limits{"env",
                 "LC_ALL=C",
                 "prlimit",
                 "--core=0",
                 fmt::format("--cpu={}:{}", seconds, seconds + 1),
                 "--fsize=67108864",
                 "--nofile=64"};
#ifndef __SANITIZE_ADDRESS__  // which takes terabytes of addresses for itself
  limits.push_back(fmt::format("--as={}", std::int64_t{megabytes} << 20));
#endif
  return limits + command;
}

std::string word_of_this_run() {
  std::random_device random;
  return fmt::format("{:08x}{:08x}", random(), random());
}

Numbers numbers_in(std::string_view text) {
  Numbers numbers;
  while (!text.empty()) {
    text.remove_prefix(std::min(text.find_first_not_of(' '), text.size()));
    const std::string_view word = text.substr(0, text.find(' '));
    if (word.empty()) break;
    Real value = std::numeric_limits<Real>::quiet_NaN();
    std::from_chars(word.data(), word.data() + word.size(), value);
    numbers.push_back(value);
    text.remove_prefix(word.size());
  }
  return numbers;
}

/// Shortens text whose length a student controls.
std::string shortened(std::string text, std::size_t most) {
  if (text.size() <= most) return text;
  while (most > 0 && (static_cast<unsigned char>(text[most]) & 0xc0) == 0x80) --most;  // in the middle of a letter
  return text.substr(0, most) + " ...";
}

struct Problem {
  std::string kind, text;
};

/// Why a program that did not come to its end has ended. The sandbox gives signals back as a shell does. The kernel ends a
/// program that is over its processor time by SIGXCPU or SIGKILL, and a program may send both to itself. The time by the clock
/// tells them apart.
Problem problem_of(const Ended& ended, double seconds, const std::string& where, const AttemptLimits& limits,
                   const std::string& last_printed) {
  const auto by_signal = [&](int signal) { return ended.signal == signal || ended.status == 128 + signal; };
  if (ended.out_of_time || ((by_signal(SIGXCPU) || by_signal(SIGKILL)) && seconds >= limits.seconds))
    return {"time", fmt::format("{}, your program had no answer after {} s of processor time, or {} s by the clock. "
                                "Look for an endless loop.",
                                where, limits.seconds, AttemptLimits::patience * limits.seconds)};
  if (by_signal(SIGABRT))
    return {"crash",
            fmt::format("{}, your program aborted{}.", where, last_printed.empty() ? "" : ": " + last_printed)};
  if (by_signal(SIGFPE)) return {"crash", where + ", your program divided an integer by 0."};
  if (by_signal(SIGXFSZ))
    return {"files", where + ", your program wrote more than 64 MB. Look for a loop that prints."};
  for (const int signal : {SIGALRM, SIGHUP, SIGINT, SIGKILL, SIGPIPE, SIGQUIT, SIGTERM, SIGUSR1, SIGUSR2, SIGXCPU})
    if (by_signal(signal)) return {"crash", fmt::format("{}, your program was ended by the signal {}.", where, signal)};
  if (ended.status < 0 || ended.status > 128)
    return {"crash", where +
                         ", your program accessed memory that is not its own, and was stopped. Look for an index past "
                         "the end of a list, a null pointer, or an endless recursion."};
  return {"exit", fmt::format("{}, your program exited with the status {} before it had answered. A solution returns "
                              "numbers and does not exit.",
                              where, ended.status)};
}

/// "/tmp/x/03.h:12:30: error: ..." or "In file included from /tmp/x/03.h:3:": the line, if it is one of this file.
std::size_t line_in(const std::string& message, const std::string& file) {
  const std::size_t at = message.find(file + ":");
  if (at == std::string::npos || (at > 0 && message[at - 1] != '/')) return 0;
  return std::strtoul(message.c_str() + at + file.size() + 1, nullptr, 10);
}

/// "expected ';' before '}' token", or empty if this is no error.
std::string error_in(const std::string& message) {
  constexpr std::string_view error = "error: ", undefined = "undefined reference to";
  if (const std::size_t at = message.find(error); at != std::string::npos) return message.substr(at + error.size());
  if (const std::size_t at = message.find(undefined); at != std::string::npos)
    return message.substr(at) + ", which is declared but never defined";
  return "";
}

/// The first error in the student's file among these messages of g++, clang++ or the linker, with the line that it is in. If all
/// show elsewhere: the first of them, with the line of the file that is named first.
std::string first_error(const std::string& messages, const fs::path& students_file) {
  const std::vector<std::string> lines = lines_of(read_text_file(students_file));
  std::size_t line = 0;  // of the student's file
  std::string said;      // the first error, which may show in what the file includes or instantiates
  bool in_the_file = false;
  for (const std::string& message : lines_of(messages)) {
    const std::size_t here = line_in(message, students_file.filename());
    const std::string error = error_in(message);
    in_the_file = here > 0 && !error.empty();
    if (in_the_file || said.empty()) said = error;
    if (in_the_file || line == 0) line = here;
    if (in_the_file) break;
  }
  if (said.empty()) return "it does not compile. The compiler does not say why.";
  const std::string words = fmt::format("the compiler says: {}.", said);
  if (line == 0 || line > lines.size()) return "it does not compile: " + words;
  return fmt::format("it does not compile. Line {}: \n\n    {}\n\n  {}", line, lines[line - 1], words);
}

/// Why there is no program.
std::string built_not(const Ended& ended, const fs::path& own, const AttemptLimits& limits) {
  if (ended.out_of_time || ended.err.find("CPU time limit exceeded") != std::string::npos)
    return fmt::format("the compiler did not finish after {} s of processor time, or {} s by the clock.",
                       limits.compile_seconds, AttemptLimits::patience * limits.compile_seconds);
  return shortened(first_error(shortened(ended.err, 100'000), own), 1000);
}

}  // namespace

Attempt attempt(const Exercise& exercise, const fs::path& file, std::uint64_t seed, const Sandbox* sandbox,
                const AttemptLimits& limits) {
  Attempt outcome;
  const ScratchFolder scratch;
  const fs::path own = scratch.path / file.filename(), object = scratch.path / "answer.o",
                 program = scratch.path / "answer", headers = kit().folder / "headers.h",
                 answer = kit().folder / "answer.cpp";
  write_text_file(own, read_text_file(file) + exercise.behind);
  if (exercise.own())  // as "asked.h"; the folder itself has the answer
    for (const auto& entry : fs::directory_iterator(exercise.folder))
      if (entry.path().extension() == ".h" && entry.path().filename() != "student.h")
        fs::copy_file(entry.path(), scratch.path / entry.path().filename(), fs::copy_options::skip_existing);
  /// Apart from us, within limits.
  const auto run = [&](const Command& command, const std::vector<fs::path>& readable, Sandbox::Folder may_be,
                       int seconds, int megabytes, const std::string& input) {
    const Command within = limited(seconds, megabytes, command);
    return run_program(sandbox ? sandbox->around(within, scratch.path, readable, may_be) : within,
                       AttemptLimits::patience * seconds, input);
  };
  const auto build = [&](const Command& command, const std::vector<fs::path>& readable) {
    return run(command, readable, Sandbox::Folder::writable, limits.compile_seconds, limits.compile_megabytes, "");
  };

  const Command compile =
      kit().words_of("compile.txt") + Command{"-include", headers, "-include", own, "-c", answer, "-o", object};
  std::vector<fs::path> needed{headers, answer};
  for (const char* parsed : {"headers.h.gch", "headers.h.pch"})
    if (fs::exists(kit().folder / parsed)) needed.push_back(kit().folder / parsed);
  Ended ended = build(compile, needed);
  if (ended.status == 0) {
    // Not before now, because the compiler could put their contents, which include the right answers, into the program.
    Command link = kit().words_of("link.txt");
    std::vector<fs::path> libraries;
    for (const std::string& word : link)
      if (word.starts_with("/") && !word.starts_with("/usr/")) libraries.emplace_back(word);
    link.insert(link.begin() + 1, {"-fno-use-linker-plugin", "-o", program, object});
    if (exercise.own()) {
      link.insert(link.begin() + 5, exercise.object);
      libraries.emplace_back(exercise.object);
    }
    ended = build(link, libraries);
  }
  if (ended.status != 0) {
    outcome.kind = "does not compile";
    outcome.problem = built_not(ended, own, limits);
    return outcome;
  }

  const std::string word = word_of_this_run();
  const auto begin = std::chrono::steady_clock::now();
  ended = run({program}, {}, Sandbox::Folder::readable, limits.seconds, limits.megabytes,
              fmt::format("{} {} {}\n", word, seed, exercise.checks.size()));
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - begin;
  bool complete = false;
  for (const std::string& line : lines_of(ended.out)) {
    if (!line.starts_with(word + " ")) continue;
    const std::string said = line.substr(word.size() + 1);
    if (said.starts_with("check ")) {  // who knows the word may write anything
      std::size_t check = 0;
      std::from_chars(said.data() + 6, said.data() + said.size(), check);
      if (check < exercise.checks.size()) outcome.numbers.resize(std::max(outcome.numbers.size(), check + 1));
    } else if (said.starts_with("numbers") && !outcome.numbers.empty())
      outcome.numbers.back().push_back(numbers_in(said.substr(7)));
    else if (said == "end") complete = true;
    else if (said == "memory") outcome.kind = "memory";
    else if (said.starts_with("exception ")) outcome.kind = said;
  }
  outcome.printed = ended.err;
  if (complete) return outcome;

  const std::string where = outcome.numbers.empty()
                                ? "before the first check"
                                : fmt::format("in the check '{}'", exercise.checks[outcome.numbers.size() - 1].says);
  if (outcome.kind == "memory") {
    outcome.problem =
        fmt::format("{}, your program asked for more than {} MB of memory. Look for a list that keeps growing.", where,
                    limits.megabytes);
  } else if (!outcome.kind.empty()) {
    outcome.problem = fmt::format("{}, your program threw an exception: {}.", where, outcome.kind.substr(10));
    outcome.kind = "exception";
  } else {
    const std::vector<std::string> printed = lines_of(ended.err);
    const Problem problem = problem_of(ended, seconds.count(), where, limits, printed.empty() ? "" : printed.back());
    outcome.kind = problem.kind;
    outcome.problem = problem.text;
  }
  outcome.problem = shortened(outcome.problem, 1000);
  return outcome;
}

}  // namespace pushback
