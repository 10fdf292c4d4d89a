/// What students may write, exercise by exercise: compiles each answer of tests/NN_name/exercise/*.txt as `./course exercise`
/// would, compares the verdict with its title, and counts: how many wrong answers are named rightly, not at all, and wrongly.
/// Called with the name of an exercise, it looks at that one, otherwise at all.
#include <fmt/format.h>

#include <atomic>
#include <set>
#include <thread>

#include "pushback/common/basics/input.h"
#include "pushback/tools/classroom/all_exercises.h"
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

/// The answers of one exercise, and what came of them.
struct Looked {
  const Exercise& exercise;
  std::vector<WrittenAnswer> answers;  // the gap as it is comes last
  std::vector<Verdict> verdicts;
  std::atomic<std::size_t> done = 0;

  explicit Looked(const Exercise& of)
      : exercise(of), answers(written_answers(of, SOURCE_DIR "/tests")), verdicts(answers.size() + 1) {
    answers.push_back({"nothing changes", ""});
  }

  void look(std::size_t i, UntouchedFiles& untouched_files) {
    const bool of_the_gap = i + 1 == answers.size();
    const std::string text = of_the_gap ? read_text_file(stub_of(exercise)) : filled_in(exercise, answers[i].lines);
    verdicts[i] =
        verdict_on(exercise, text, of_the_gap ? 1 : std::hash<std::string>{}(text), nullptr, {}, &untouched_files);
  }

  /// How many verdicts are not as they should be.
  int say(Count& all) const {
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
  const std::vector<Exercise> all = all_exercises();
  std::vector<std::unique_ptr<Looked>> looked;
  std::vector<std::pair<Looked*, std::size_t>> waiting;
  try {
    for (int i = 1; i < argc; ++i) looked.push_back(std::make_unique<Looked>(exercise_named(all, argv[i])));
    if (argc == 1)
      for (const Exercise& exercise : all) looked.push_back(std::make_unique<Looked>(exercise));
  } catch (const InvalidInput& problem) {
    fmt::print(stderr, "{}\n", problem.what());
    return 2;
  }
  for (const auto& one : looked)
    for (std::size_t i = 0; i < one->answers.size(); ++i) waiting.emplace_back(one.get(), i);
  UntouchedFiles untouched_files;
  std::atomic<std::size_t> next = 0;
  // One alone is a test, of which others run beside it.
  const unsigned jobs = looked.size() == 1 ? 1 : std::max(1U, std::thread::hardware_concurrency());
  std::vector<std::thread> threads;
  for (unsigned job = 0; job < jobs; ++job)
    threads.emplace_back([&] {
      for (std::size_t i = next++; i < waiting.size(); i = next++) {
        const auto& [one, answer] = waiting[i];
        one->look(answer, untouched_files);
        if (++one->done == one->answers.size()) one->done.notify_all();
      }
    });
  int failures = 0;
  Count count;
  for (const auto& one : looked) {
    for (std::size_t done = one->done; done < one->answers.size(); done = one->done) one->done.wait(done);
    failures += one->say(count);
  }
  for (std::thread& thread : threads) thread.join();
  if (looked.size() > 1) fmt::print("all {} exercises: {}\n", looked.size(), count.words());
  return failures > 0;
}
