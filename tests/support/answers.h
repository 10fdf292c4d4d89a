/// What students may write into the gap of an exercise: tests/NN_name/exercise/*.txt.
#pragma once

#include <set>
#include <sstream>

#include "pushback/common/basics/files.h"
#include "pushback/common/basics/input.h"
#include "pushback/common/basics/process.h"
#include "pushback/tools/classroom/attempt.h"
#include "pushback/tools/classroom/mine/edits.h"
#include "pushback/tools/classroom/student_files.h"

namespace pushback {

/// Where the gap of this text begins and ends: whole lines, with both TODOs.
inline std::pair<std::size_t, std::size_t> gap_in(const std::string& stub) {
  return {stub.rfind('\n', stub.find("TODO")) + 1, stub.find('\n', stub.find("TODO ends")) + 1};
}

/// The exercise's own file with `lines` in the place of its gap.
inline std::string filled_in(const Exercise& exercise, const std::string& lines) {
  const std::string stub = read_text_file(stub_of(exercise));
  const auto [from, to] = gap_in(stub);
  return stub.substr(0, from) + lines + stub.substr(to);
}

/// What stands there as students get it.
inline std::string lines_of_the_gap(const Exercise& exercise) {
  const std::string stub = read_text_file(stub_of(exercise));
  const auto [from, to] = gap_in(stub);
  return stub.substr(from, to - from);
}

struct WrittenAnswer {
  std::string title;                 ///< "right", or "1 3: cap forgotten"
  std::set<std::size_t> fails = {};  ///< the numbers of the checks, from 1 on
  std::string lines = {};
};

/// `== title`, and its lines; where they begin with - and +, they are an edit of the first answer.
inline std::vector<WrittenAnswer> written_answers(const Exercise& exercise, const std::filesystem::path& tests) {
  const std::filesystem::path file =
      tests / std::filesystem::path(exercise.folder).lexically_relative("chapters").begin()->string() / "exercise" /
      (exercise.transfer() ? "transfer.txt" : "answers.txt");
  std::vector<WrittenAnswer> answers;
  for (const std::string& line : lines_of(read_text_file(file))) {
    if (line.starts_with("== ")) {
      answers.push_back({line.substr(3)});
      std::istringstream numbers(line.substr(3));
      for (std::size_t number; numbers >> number;) answers.back().fails.insert(number);
    } else if (!answers.empty()) {
      answers.back().lines += line + "\n";
    }
  }
  for (WrittenAnswer& answer : answers)
    if (answer.lines.starts_with("- "))
      answer.lines = edited_loops("== " + answer.title + "\n" + answer.lines, answers[0].lines)[0].text;
  return answers;
}

/// The verdict on this text as a student's file.
inline Verdict verdict_on(const Exercise& exercise, const std::string& text, std::uint64_t seed,
                          const Sandbox* sandbox = nullptr, const AttemptLimits& limits = {}) {
  const ScratchFolder scratch;
  const std::filesystem::path file = scratch.path / (exercise.name + ".h");
  write_text_file(file, text);
  return judge(exercise, seed, attempt(exercise, file, seed, sandbox, limits));
}

/// Says why a test is skipped, where there is none.
inline bool has_sandbox() {
  try {
    const Sandbox here;
    return true;
  } catch (const InvalidInput& problem) {
    fmt::print(stderr, "skipped: {}\n", problem.what());
    return false;
  }
}

}  // namespace pushback
