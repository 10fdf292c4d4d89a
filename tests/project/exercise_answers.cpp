/// What students may write, exercise by exercise: each answer of tests/NN_name/exercise/*.txt is run and judged as `./course exercise`
/// would, its verdict compared with its title, and counted: how many wrong answers are named rightly, not at all, and wrongly.
/// All answers of an exercise are compiled as one program: one by one they would take ten times as long.
/// Called with names of exercises, it looks at those, otherwise at all; `--seeds 20` looks at each answer with twenty sets of
/// random numbers, in the place of one.
#include <fmt/format.h>

#include <atomic>
#include <set>
#include <stdexcept>
#include <thread>

#include "pushback/common/experiment/program.h"
#include "pushback/tools/classroom/all_exercises.h"
#include "pushback/tools/classroom/kit.h"
#include "tests/support/answers.h"

using namespace pushback;

namespace {

/// Of wrong answers, as their titles say.
struct Count {
  int wrong = 0;
  int named = 0;         ///< rightly
  int with_another = 0;  ///< of these: beside one that shows the same
  int unnamed = 0, misnamed = 0, passing = 0;
  void operator+=(const Count& other) {
    wrong += other.wrong;
    named += other.named;
    with_another += other.with_another;
    unnamed += other.unnamed;
    misnamed += other.misnamed;
    passing += other.passing;
  }
  std::string words() const {
    return fmt::format(
        "{} wrong answers: {} named rightly ({} beside another that shows the same), {} unnamed, {} named wrongly, {} "
        "passing",
        wrong, named, with_another, unnamed, misnamed, passing);
  }
};

/// A program that has all answers in it, each in a namespace of its own, and plays the one that ANSWER of its environment says.
class Together {
 public:
  Together(const Exercise& exercise, const std::vector<WrittenAnswer>& answers) {
    const std::filesystem::path source = scratch_.path / "together.cpp", object = scratch_.path / "together.o";
    std::string cases, namespaces;
    for (std::size_t i = 0; i < answers.size(); ++i) {
      std::string text = filled_in(exercise, answers[i].lines);
      constexpr std::string_view begin = "namespace student {";
      text.replace(text.find(begin), begin.size(), fmt::format("namespace student_{} {{", i));
      namespaces += text;
      cases += fmt::format("    case {0}: return play(check, random, student_{0}::answer);\n", i);
    }
    std::string once;  // "#pragma once" would do for headers that include the file, of which this is none
    for (const std::string& line : lines_of(namespaces))
      if (!line.starts_with("#pragma once")) once += line + "\n";
    write_text_file(source,
                    fmt::format("#include <cstdlib>\n{}\npushback::Numbers pushback::students_numbers(std::size_t "
                                "check, Random& random) {{\n  switch (std::atoi(std::getenv(\"ANSWER\"))) {{\n{}  "
                                "}}\n  std::abort();\n}}\n",
                                once, cases));
    std::vector<std::string> compile = kit().words_of("compile.txt"), link = kit().words_of("link.txt");
    for (const std::string& word : {std::string("-include"), (kit().folder / "headers.h").string(), std::string("-c"),
                                    source.string(), std::string("-o"), object.string()})
      compile.push_back(word);
    link.insert(link.begin() + 1, {"-o", all().string(), object.string()});
    for (const auto& command : {compile, link})
      if (const Ended ended = run_program(command, 600); ended.status != 0) throw std::runtime_error(ended.err);
  }

  /// Runs the answer: for attempt(), which is handed a program without words.
  std::filesystem::path program(std::size_t answer) const {
    const std::filesystem::path script = scratch_.path / fmt::format("answer_{}", answer);
    write_text_file(script, fmt::format("#!/bin/sh\nANSWER={} exec {}\n", answer, all().string()));
    std::filesystem::permissions(script, std::filesystem::perms::owner_all);
    return script;
  }

 private:
  std::filesystem::path all() const { return scratch_.path / "all"; }
  ScratchFolder scratch_;
};

/// The answers of one exercise, and what came of them.
struct Looked {
  const Exercise& exercise;
  std::vector<WrittenAnswer> answers;  // the gap as it is comes last
  std::vector<Verdict> verdicts;
  std::string problem;  // that kept it from looking
  std::atomic<bool> done = false;

  explicit Looked(const Exercise& of) : exercise(of), answers(written_answers(of, SOURCE_DIR "/tests")) {
    answers.push_back({"nothing changes", lines_of_the_gap(of)});
  }

  /// `others`: which scenes its random numbers make, of those that a student may get.
  void look(std::uint64_t others) {
    try {
      const Together together(exercise, answers);
      const auto attempt_of = [&](std::size_t i, std::uint64_t seed) {
        return attempt(exercise, stub_of(exercise), seed, nullptr, {}, together.program(i));
      };
      for (std::size_t i = 0; i < answers.size(); ++i) {
        const std::uint64_t seed =
            hash_of(i + 1 == answers.size() ? "" : filled_in(exercise, answers[i].lines)) + others;
        verdicts.push_back(
            judge(exercise, seed, attempt_of(i, seed), [&] { return attempt_of(answers.size() - 1, seed); }));
      }
    } catch (const std::exception& caught) {
      problem = caught.what();
    }
    done = true;
    done.notify_all();
  }

  /// How many verdicts are not as they should be.
  int say(Count& all) const {
    if (!problem.empty()) {
      fmt::print("FAILED {}: {}\n", short_name(exercise), problem);
      return 1;
    }
    int failures = 0;
    Count count;
    std::set<std::string> missing{"right"};
    for (const auto& mistake : exercise.mistakes) missing.insert(mistake.name);
    for (std::size_t i = 0; i < answers.size(); ++i) {
      const std::string& name = answers[i].name;
      const Verdict& verdict = verdicts[i];
      const bool of_the_gap = i + 1 == answers.size();
      bool fine = verdict.passed();
      if (name != "right") {
        const bool is_named = (" or " + verdict.mistake + " or ").find(" or " + name + " or ") != std::string::npos;
        fine = !verdict.passed() && (name.starts_with("unnamed: ") ? verdict.mistake.empty() : is_named);
        if (!of_the_gap) {
          ++count.wrong;
          count.passing += verdict.passed();
          count.named += is_named;
          count.with_another += is_named && verdict.mistake != name;
          count.unnamed += !verdict.passed() && verdict.mistake.empty();
          count.misnamed += !is_named && !verdict.mistake.empty();
        }
      }
      fmt::print("{} {}: {}{}\n", fine ? "fine  " : "FAILED", of_the_gap ? "the gap as it is" : name,
                 fine || verdict.mistake.empty() ? "" : "[" + verdict.mistake + "] ",
                 verdict.passed() ? "passes" : verdict.sentence);
      failures += !fine;
      missing.erase(name);
    }
    for (const std::string& name : missing) fmt::print("FAILED: nobody writes '{}'\n", name);
    fmt::print("{}: {}\n\n", short_name(exercise), count.words());
    std::fflush(stdout);
    all += count;
    return failures + static_cast<int>(missing.size());
  }
};

}  // namespace

int main(int argc, char** argv) {
  std::vector<std::string> names;
  std::uint64_t others = 0;
  CommandLine line("Says how true the hints of the exercises are.", "./course exercise --quality");
  line.option("EXERCISE", names, "Those to look at, such as 15-transfer; all by default");
  line.option("--seed", others, "Other random numbers in all scenes");
  int failures = 0;
  const int status = line.run(argc, argv, [&] {
    const std::vector<Exercise> all = all_exercises();
    std::vector<std::unique_ptr<Looked>> looked;
    for (const std::string& name : names) looked.push_back(std::make_unique<Looked>(exercise_named(all, name)));
    if (names.empty())
      for (const Exercise& exercise : all) looked.push_back(std::make_unique<Looked>(exercise));
    std::atomic<std::size_t> next = 0;
    std::vector<std::thread> threads;
    for (unsigned job = 0; job < std::max(1U, std::thread::hardware_concurrency()); ++job)
      threads.emplace_back([&] {
        for (std::size_t i = next++; i < looked.size(); i = next++) looked[i]->look(others);
      });
    Count count;
    for (const auto& one : looked) {
      one->done.wait(false);
      failures += one->say(count);
    }
    for (std::thread& thread : threads) thread.join();
    if (looked.size() > 1) fmt::print("all {} exercises: {}\n", looked.size(), count.words());
  });
  return status != 0 ? status : failures > 0;
}
