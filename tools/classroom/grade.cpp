#include "pushback/tools/classroom/grade.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <future>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <random>
#include <sstream>

#include "pushback/common/basics/files.h"
#include "pushback/common/basics/input.h"
#include "pushback/common/basics/process.h"
#include "pushback/tools/classroom/handed_in.h"
#include "pushback/tools/classroom/student_files.h"

namespace pushback {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

namespace {

std::string dumped(const Json& json) {
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

constexpr int no_stage = std::numeric_limits<int>::max();

int first_failing_stage(const Exercise& exercise, const Verdict& verdict) {
  int first = no_stage;
  for (std::size_t i = 0; i < exercise.checks.size(); ++i)
    if (verdict.checks[i] != Passed::yes) first = std::min(first, exercise.checks[i].stage);
  return first;
}

/// The last chapter that passes, with all before it: "05", or "none".
std::string stands_at(const Exercise& exercise, int fails) {
  int last = -1;
  for (const Exercise::Line& check : exercise.checks)
    if (check.stage < fails) last = std::max(last, check.stage);
  return last < 0 ? "none" : fmt::format("{:02}", last);
}

Json graded(const Grading& grading, const Exercise& exercise, const HandedIn& handed_in, std::uint64_t seed,
            const Sandbox* sandbox) {
  const std::optional<fs::path> file = handed_in.file(exercise);
  Verdict verdict;
  std::string printed;
  const auto not_graded = [&](const std::string& why, const std::string& sentence) {
    verdict.mistake = why;
    verdict.sentence = sentence;
    verdict.checks.assign(exercise.checks.size(), Passed::not_reached);
  };
  if (!handed_in.problem().empty()) {
    not_graded("not taken", fmt::format("the submission is not accepted: {}.", handed_in.problem()));
  } else if (!file) {
    not_graded("not handed in", fmt::format("there is no regular file {} of less than 1 MB.", file_of(exercise)));
  } else if (!exercise.whole() && untouched(read_text_file(*file), read_text_file(stub_of(exercise)))) {
    not_graded("nothing written", "the gap is unchanged.");
  } else {
    Exercise own = exercise;
    if (exercise.whole()) own.folder = file->parent_path().string();  // with the headers next to it
    const Attempt outcome = attempt(own, *file, seed, sandbox, grading.limits);
    verdict = judge(exercise, seed, outcome);
    printed = outcome.printed.substr(0, 1000);
  }
  Json made{{"exercise", short_name(exercise)},
            {"points", 0},
            {"of", 0},
            {"mistake", verdict.mistake},
            {"verdict", verdict.sentence},
            {"printed", printed},
            {"checks", Json::array()}};
  // A whole solver's checks count up to the chapter that fails first: a solver that does nothing passes some of later ones.
  const int fails = first_failing_stage(exercise, verdict);
  if (exercise.whole()) made["stands"] = stands_at(exercise, fails);
  int points = 0, of = 0;
  for (std::size_t i = 0; i < exercise.checks.size(); ++i) {
    if (exercise.whole() && exercise.checks[i].points == 0) continue;  // it ended with an earlier chapter
    const bool passed = verdict.checks[i] == Passed::yes &&
                        !verdict.changes_nothing() &&  // the gap itself passes these checks
                        (!exercise.whole() || exercise.checks[i].stage <= fails);
    const int worth = grading.points.of(exercise, i);
    of += worth;
    if (passed) points += worth;
    made["checks"].push_back({{"check", exercise.checks[i].says},
                              {"passed", passed},
                              {"reached", verdict.checks[i] != Passed::not_reached},
                              {"of", worth}});
  }
  made["points"] = points;
  made["of"] = of;
  return made;
}

/// A hash of everything that a student's result depends on.
std::string fingerprint(const Grading& grading, const HandedIn& handed_in, std::uint64_t seed) {
  const AttemptLimits& limits = grading.limits;
  std::string all = fmt::format("{} {} {} {} {} {}", seed, grading.sandboxed, limits.seconds, limits.megabytes,
                                limits.compile_seconds, limits.compile_megabytes);
  for (const Exercise* exercise : grading.exercises) {
    all += short_name(*exercise);
    for (std::size_t i = 0; i < exercise->checks.size(); ++i)
      all += fmt::format(" {}", grading.points.of(*exercise, i));
  }
  return fmt::format("{:016x}", hash_of(all + handed_in.problem() + handed_in.contents()));
}

std::optional<Json> read_result(const fs::path& file) {
  if (!fs::exists(file)) return std::nullopt;
  Json result = Json::parse(read_text_file(file), nullptr, false);
  if (result.is_discarded() || !result.contains("fingerprint")) return std::nullopt;
  return result;
}

std::string xml(const std::string& text) {
  static const std::map<char, std::string> spelled{{'&', "&amp;"}, {'<', "&lt;"}, {'>', "&gt;"}, {'"', "&quot;"}};
  std::string out;
  for (const char c : text) {
    const auto found = spelled.find(c);
    if (found != spelled.end()) out += found->second;
    else out += static_cast<unsigned char>(c) < 0x20 ? ' ' : c;
  }
  return out;
}

std::string junit(const Json& results) {
  std::string text = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites>\n";
  for (const Json& student : results) {
    const std::string name = student["student"];
    int tests = 0, failures = 0;
    std::string cases;
    for (const Json& exercise : student["exercises"]) {
      bool explained = false;
      for (const Json& check : exercise["checks"]) {
        ++tests;
        cases += fmt::format("    <testcase classname=\"{}\" name=\"{}: {}\"", xml(name), xml(exercise["exercise"]),
                             xml(check["check"]));
        if (check["passed"]) {
          cases += "/>\n";
          continue;
        }
        ++failures;
        cases += fmt::format("><failure message=\"{}\"/></testcase>\n", explained ? "" : xml(exercise["verdict"]));
        explained = true;
      }
    }
    text += fmt::format("  <testsuite name=\"{}\" tests=\"{}\" failures=\"{}\">\n{}  </testsuite>\n", xml(name), tests,
                        failures, cases);
  }
  return text + "</testsuites>\n";
}

void print_table(const Json& results) {
  std::size_t wide = 7;
  for (const Json& student : results) wide = std::max(wide, student["student"].get<std::string>().size());
  for (const Json& student : results) {
    int points = 0, of = 0;
    std::string each;
    for (const Json& exercise : student["exercises"]) {
      points += exercise["points"].get<int>();
      of += exercise["of"].get<int>();
      const std::string mistake = exercise["mistake"];
      const std::string stands =
          exercise.contains("stands") ? fmt::format(", stands at {}", exercise["stands"].get<std::string>()) : "";
      each += fmt::format("  {} {}/{}{}{}", exercise["exercise"].get<std::string>(), exercise["points"].get<int>(),
                          exercise["of"].get<int>(), stands, mistake.empty() ? "" : " (" + mistake + ")");
    }
    fmt::print("{:<{}}  {:>3} of {}{}\n", student["student"].get<std::string>(), wide, points, of, each);
  }
}

std::uint64_t kept_seed(const Grading& grading) {
  const fs::path file = grading.out / "seed";
  if (grading.seed != 0) return grading.seed;
  if (!fs::exists(file)) {  // of parts that begin together the first draws, and the others read
    std::random_device random;
    const std::uint64_t drawn = (std::uint64_t{random()} << 32) | random();
    const fs::path own = grading.out / fmt::format("seed.{:016x}", drawn);
    write_text_file(own, fmt::format("{}\n", drawn));
    std::error_code there_already;
    fs::create_hard_link(own, file, there_already);
    fs::remove(own);
  }
  return std::stoull(read_text_file(file));
}

}  // namespace

std::string points_text(const std::vector<const Exercise*>& exercises) {
  std::string text = "# Points of each check: exercise, number of the check, points. Text after # is a note for you.\n";
  for (const Exercise* exercise : exercises)
    for (std::size_t i = 0; i < exercise->checks.size(); ++i)
      if (!exercise->whole() || exercise->checks[i].points > 0)
        text += fmt::format("{} {} {}  # {}{}\n", short_name(*exercise), i + 1, exercise->checks[i].points,
                            exercise->whole() ? fmt::format("{:02}: ", exercise->checks[i].stage) : "",
                            exercise->checks[i].says);
  return text;
}

Points::Points(const std::vector<Exercise>& all, const fs::path& file) {
  constexpr int most = 1000000;  // so that no sum overflows
  int number = 0;
  for (const std::string& line : lines_of(read_text_file(file))) {
    ++number;
    const std::string text = line.substr(0, line.find('#'));
    if (text.find_first_not_of(" \t\r") == std::string::npos) continue;
    std::istringstream in(text);
    std::string word, rest;
    std::size_t check = 0;
    int points = 0;
    const bool read = static_cast<bool>(in >> word >> check >> points) && !(in >> rest);
    const Exercise* exercise = read ? &exercise_named(all, word) : nullptr;
    if (!read || check < 1 || check > exercise->checks.size() || points < 0 || points > most)
      throw InvalidInput(fmt::format(
          "{}, line {}: '{}': an exercise, the number of one of its checks, and points from 0 to {} are needed",
          file.string(), number, line, most));
    set_[{exercise->name, check - 1}] = points;
  }
}

int Points::of(const Exercise& exercise, std::size_t check) const {
  const auto found = set_.find({exercise.name, check});
  return found == set_.end() ? exercise.checks[check].points : found->second;
}

void grade(const Grading& grading) {
  std::map<std::string, fs::path> students;  // by name
  std::vector<std::string> refused;          // a file among the folders of a class
  for (const fs::path& given : grading.given) {
    std::string name;
    try {
      name = students_name(given);
    } catch (const InvalidInput& problem) {
      refused.emplace_back(problem.what());
      continue;
    }
    if (!students.emplace(name, given).second)
      throw InvalidInput(fmt::format("two students are named '{}': a name for each student is needed", name));
  }
  if (students.empty() && !refused.empty()) throw InvalidInput(refused.front());
  for (const std::string& problem : refused) fmt::print(stderr, "not graded: {}\n", problem);
  const std::unique_ptr<const Sandbox> sandbox = grading.sandboxed ? std::make_unique<const Sandbox>() : nullptr;
  make_writable_folder(grading.out / "students");
  const std::uint64_t seed = kept_seed(grading);

  std::vector<std::pair<std::string, fs::path>> mine;
  std::size_t number = 0;
  for (const auto& student : students)
    if (grading.shard.has(number++)) mine.push_back(student);
  std::atomic<std::size_t> next = 0;
  const auto work = [&] {
    for (std::size_t i = next++; i < mine.size(); i = next++) {
      const auto& [name, given] = mine[i];
      const HandedIn handed_in(given, grading.exercises, sandbox.get());
      const fs::path file = grading.out / "students" / (name + ".json");
      const std::string follows_from = fingerprint(grading, handed_in, seed);
      const std::optional<Json> before = read_result(file);
      if (before && (*before)["fingerprint"] == follows_from) continue;
      Json result{{"student", name}, {"fingerprint", follows_from}, {"exercises", Json::array()}};
      for (const Exercise* exercise : grading.exercises)
        result["exercises"].push_back(graded(grading, *exercise, handed_in, seed ^ hash_of(name), sandbox.get()));
      write_text_file(file, dumped(result));
      fmt::print(stderr, "graded: {}\n", name);
    }
  };
  std::vector<std::future<void>> jobs;
  for (int i = 0; i < grading.jobs; ++i) jobs.push_back(std::async(std::launch::async, work));
  for (std::future<void>& job : jobs) job.get();

  Json results = Json::array();
  for (const auto& [name, given] : students) {
    const std::optional<Json> result = read_result(grading.out / "students" / (name + ".json"));
    if (result) results.push_back(*result);
  }
  write_text_file(grading.out / "results.json", dumped(results));
  write_text_file(grading.out / "results.xml", junit(Json::parse(dumped(results))));
  print_table(results);
  if (results.size() < students.size()) fmt::print("{} of {} students are graded\n", results.size(), students.size());
}

}  // namespace pushback
