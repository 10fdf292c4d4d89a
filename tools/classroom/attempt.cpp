#include "pushback/tools/classroom/attempt.h"

#include <fmt/format.h>

#include <charconv>
#include <csignal>
#include <random>

#include "pushback/common/basics/files.h"
#include "pushback/common/basics/input.h"
#include "pushback/common/basics/process.h"
#include "pushback/common/exercise/shown.h"
#include "pushback/tools/classroom/compiler_words.h"
#include "pushback/tools/classroom/kit.h"
#include "pushback/tools/classroom/student_files.h"

namespace pushback {

namespace fs = std::filesystem;

namespace {

using Command = std::vector<std::string>;

Command operator+(Command first, const Command& then) {
  first.insert(first.end(), then.begin(), then.end());
  return first;
}

/// Seconds by the clock for one of the processor: on a machine that compiles many students at once nobody should lose points.
constexpr int patience = 6;

Command limited(int seconds, int megabytes, const Command& command) {
  Command limits{"env",        "LC_ALL=C", "prlimit", "--core=0", fmt::format("--cpu={}", seconds), "--fsize=67108864",
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

/// Of the scene whose numbers come next. No more and no longer ones than a scene has: who knows the word may write anything.
void keep_shown(Attempt& outcome, std::string_view text) {
  constexpr std::size_t longest = 25 * most_numbers_shown;  // characters
  const std::size_t check = outcome.numbers.size() - 1, scene = outcome.numbers.back().size();
  if (scene >= scenes_of_a_check || text.size() > longest) return;
  std::vector<Numbers>& instants = outcome.shown[{check, scene}];
  if (instants.size() < most_instants) instants.push_back(numbers_in(text));
}

struct Problem {
  std::string kind, text;
};

/// Why a program that did not come to its end has ended. The sandbox gives signals back as a shell does.
Problem problem_of(const Ended& ended, const std::string& where, const Limits& limits,
                   const std::string& last_printed) {
  const auto by_signal = [&](int signal) { return ended.signal == signal || ended.status == 128 + signal; };
  if (ended.status == 124 || by_signal(SIGXCPU) || by_signal(SIGKILL))
    return {"time", fmt::format("{}, your program had no answer after {} s. Look for a loop that never ends.", where,
                                limits.seconds)};
  if (by_signal(SIGABRT))
    return {"crash",
            fmt::format("{}, your program stopped itself{}.", where, last_printed.empty() ? "" : ": " + last_printed)};
  if (by_signal(SIGFPE)) return {"crash", where + ", your program divided a whole number by 0."};
  if (by_signal(SIGXFSZ))
    return {"files", where + ", your program wrote more than 64 MB. Look for a line that prints, in a loop."};
  if (ended.status < 0 || ended.status > 128)
    return {
        "crash",
        where +
            ", your program used memory that is not its own, and was stopped. Look for an index that is past the end "
            "of a list, a pointer to nothing, or a function that calls itself without an end."};
  return {"exit",
          fmt::format(
              "{}, your program ended by itself, with the status {}, before it had answered. A solution gives numbers "
              "back; it does not end the program.",
              where, ended.status)};
}

}  // namespace

ScratchFolder::ScratchFolder()
    : path([] {
        std::string name = (fs::temp_directory_path() / "pushback_XXXXXX").string();
        if (mkdtemp(name.data()) == nullptr) throw std::runtime_error("no scratch folder in " + name);
        return name;
      }()) {}

ScratchFolder::~ScratchFolder() {
  std::error_code ignored;
  fs::remove_all(path, ignored);
}

Sandbox::Sandbox() {
  const fs::path& source = kit().sources;
  for (const char* part : {"common", "chapters"}) {
    for (const auto& entry : fs::recursive_directory_iterator(source / part)) {
      if (entry.path().extension() != ".h") continue;
      const fs::path copy = headers_.path / "pushback" / fs::relative(entry.path(), source);
      fs::create_directories(copy.parent_path());
      fs::copy_file(entry.path(), copy);
    }
  }
  const ScratchFolder folder;
  const Ended ended = run_program(around({"true"}, folder.path, {}), 10);
  if (ended.status != 0)
    throw InvalidInput(
        fmt::format("there is no sandbox here (bubblewrap: {}): install the package bubblewrap, or say --no-sandbox "
                    "and run what students wrote with all that you may do yourself",
                    ended.status == 127 ? "not installed" : lines_of(ended.err + "no reason given").front()));
}

Command Sandbox::around(Command command, const fs::path& folder, const std::vector<fs::path>& readable,
                        Folder may_be) const {
  constexpr const char* most_bytes = "67108864";
  // bubblewrap is the first process in there: its own environment can be read from /proc/1/environ.
  const char* path = std::getenv("PATH");
  Command made{"env", "-i", fmt::format("PATH={}", path == nullptr ? "/usr/bin" : path), "bwrap"};
  made = made +
         Command{"--unshare-all", "--die-with-parent", "--new-session", "--clearenv", "--setenv", "PATH", "/usr/bin"};
  made = made + Command{"--ro-bind", "/usr", "/usr", "--proc", "/proc", "--dev", "/dev"};
  for (const char* memory : {"/dev/shm", "/tmp"}) made = made + Command{"--size", most_bytes, "--tmpfs", memory};
  for (const char* link : {"bin", "lib", "lib64"})
    made = made + Command{"--symlink", fmt::format("usr/{}", link), fmt::format("/{}", link)};
  made =
      made + Command{"--ro-bind-try", "/etc/alternatives", "/etc/alternatives"};  // where Debian's /usr/bin/c++ leads
  made = made + Command{"--ro-bind", headers_.path, kit().headers, may_be == Folder::writable ? "--bind" : "--ro-bind",
                        folder,      folder,        "--chdir",     folder};
  for (const fs::path& readable_path : readable) made = made + Command{"--ro-bind", readable_path, readable_path};
  return made + Command{"--remount-ro", "/dev", "--remount-ro", "/", "--"} + command;
}

Attempt attempt(const Exercise& exercise, const fs::path& file, std::uint64_t seed, const Sandbox* sandbox,
                const Limits& limits, const fs::path& kept) {
  Attempt outcome;
  const ScratchFolder scratch;
  const fs::path own = scratch.path / file.filename(), object = scratch.path / "answer.o",
                 program = kept.empty() ? scratch.path / "answer" : kept, headers = kit().folder / "headers.h",
                 answer = kit().folder / "answer.cpp";
  fs::copy_file(file, own);
  if (exercise.own())  // as "asked.h"; the folder itself has the answer
    for (const auto& entry : fs::directory_iterator(exercise.folder))
      if (entry.path().extension() == ".h" && entry.path().filename() != "student.h")
        fs::copy_file(entry.path(), scratch.path / entry.path().filename(), fs::copy_options::skip_existing);
  const auto apart = [&](const Command& command, const std::vector<fs::path>& readable,
                         Sandbox::Folder may_be = Sandbox::Folder::writable) {
    return sandbox ? sandbox->around(command, scratch.path, readable, may_be) : command;
  };

  const Command compile =
      kit().words_of("compile.txt") + Command{"-include", headers, "-include", own, "-c", answer, "-o", object};
  std::vector<fs::path> needed{headers, answer};
  for (const char* parsed : {"headers.h.gch", "headers.h.pch"})
    if (fs::exists(kit().folder / parsed)) needed.push_back(kit().folder / parsed);
  const bool built = fs::exists(program);
  Ended ended{.status = 0, .out = {}, .err = {}};
  if (!built)
    ended =
        run_program(apart(limited(limits.compile_seconds, 4096, compile), needed), patience * limits.compile_seconds);
  if (!built && ended.status == 0)
    ended = run_program(Command{"env", "LC_ALL=C"} + [&] {
      Command link = kit().words_of("link.txt");
      link.insert(link.begin() + 1, {"-o", program, object});
      if (exercise.own()) link.insert(link.begin() + 4, exercise.object);
      return link;
    }());
  if (ended.status != 0) {
    outcome.kind = "does not compile";
    const bool too_long = ended.status == 124 || ended.err.find("CPU time limit exceeded") != std::string::npos;
    outcome.problem = too_long ? fmt::format("the compiler was not done after {} s.", limits.compile_seconds)
                               : first_error(ended.err, own);
    return outcome;
  }

  const std::string word = word_of_this_run();
  ended = run_program(apart(limited(limits.seconds, limits.megabytes, {program}), {}, Sandbox::Folder::readable),
                      patience * limits.seconds, fmt::format("{} {} {}\n", word, seed, exercise.checks.size()));
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
    else if (said.starts_with("shown ") && !outcome.numbers.empty())
      keep_shown(outcome, std::string_view(said).substr(6));
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
        fmt::format("{}, your program asked for more than {} MB of memory. Look for a list that grows and grows.",
                    where, limits.megabytes);
  } else if (!outcome.kind.empty()) {
    outcome.problem = fmt::format("{}, your program threw an exception: {}.", where, outcome.kind.substr(10));
    outcome.kind = "exception";
  } else {
    const std::vector<std::string> printed = lines_of(ended.err);
    const Problem problem = problem_of(ended, where, limits, printed.empty() ? "" : printed.back());
    outcome.kind = problem.kind;
    outcome.problem = problem.text;
  }
  return outcome;
}

Attempt UntouchedFiles::attempt(const Exercise& exercise, std::uint64_t seed) {
  const std::lock_guard alone(of(exercise));
  return pushback::attempt(exercise, stub_of(exercise), seed, nullptr, {}, programs_.path / exercise.name);
}

std::mutex& UntouchedFiles::of(const Exercise& exercise) {
  const std::lock_guard alone(talking_);
  return compiling_[exercise.name];
}

}  // namespace pushback
