/// What students may write into the gap of an exercise, and how the verdict calls each: tests/NN_name/exercise/*.txt.
#pragma once

#include "pushback/common/basics/files.h"
#include "pushback/common/basics/input.h"
#include "pushback/common/basics/process.h"
#include "pushback/tools/classroom/attempt.h"
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
  std::string
      name;  ///< "right", the name of its mistake, "nothing changes", or "unnamed: " and what no hint is known for
  std::string lines;
};

inline std::vector<WrittenAnswer> written_answers(const Exercise& exercise, const std::filesystem::path& tests) {
  const std::filesystem::path file =
      tests / std::filesystem::path(exercise.folder).lexically_relative("chapters").begin()->string() / "exercise" /
      (exercise.transfer() ? "transfer.txt" : "answers.txt");
  std::vector<WrittenAnswer> answers;
  for (const std::string& line : lines_of(read_text_file(file))) {
    if (line.starts_with("== ")) answers.push_back({line.substr(3), ""});
    else if (!answers.empty()) answers.back().lines += line + "\n";
  }
  return answers;
}

/// The verdict on this text as a student's file; compared with the untouched one where there are `untouched_files`.
inline Verdict verdict_on(const Exercise& exercise, const std::string& text, std::uint64_t seed,
                          const Sandbox* sandbox = nullptr, const Limits& limits = {},
                          UntouchedFiles* untouched_files = nullptr) {
  const ScratchFolder scratch;
  const std::filesystem::path file = scratch.path / (exercise.name + ".h");
  write_text_file(file, text);
  const Attempt outcome = attempt(exercise, file, seed, sandbox, limits);
  if (!untouched_files) return judge(exercise, seed, outcome);
  return judge(exercise, seed, outcome, [&] { return untouched_files->attempt(exercise, seed); });
}

/// Why there is none here; empty: there is.
inline std::string no_sandbox() {
  try {
    const Sandbox here;
    return "";
  } catch (const InvalidInput& problem) {
    return problem.what();
  }
}

}  // namespace pushback
