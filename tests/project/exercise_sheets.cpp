/// The picture of an answer's numbers: a disc for yours, a bar for what is right, a ring for the mistake that shows.
#include <set>

#include "pushback/common/basics/files.h"
#include "pushback/common/exercise/shown.h"
#include "pushback/common/render/canvas.h"
#include "pushback/tools/classroom/all_exercises.h"
#include "pushback/tools/classroom/result_sheet.h"
#include "pushback/tools/classroom/student_files.h"
#include "pushback/tools/classroom/telling_instant.h"
#include "tests/support/call.h"

using namespace pushback;

namespace {

constexpr int strips_end = 975;  // to the right of it stand the numbers

bool is(const Image& image, int x, int y, Ink ink) {
  const std::uint8_t* pixel = image.at(x, y);
  return pixel[0] == ink.red && pixel[1] == ink.green && pixel[2] == ink.blue;
}

constexpr Ink yours{0, 114, 178}, mistaken{213, 94, 0}, right{28, 32, 40};

/// The middle of each disc: of what is in one piece, as wide as it is high. It is drawn above all else, so it is whole.
std::vector<std::pair<int, int>> discs(Image image) {
  std::vector<std::pair<int, int>> found;
  for (int from_y = 150; from_y < image.height; ++from_y) {  // below the legend
    for (int from_x = 130; from_x < strips_end; ++from_x) {
      std::vector<std::pair<int, int>> left{{from_x, from_y}};
      int low_x = from_x, high_x = from_x, high_y = from_y;
      while (!left.empty()) {
        const auto [x, y] = left.back();
        left.pop_back();
        if (y >= image.height || !is(image, x, y, yours)) continue;
        *image.at(x, y) = 255;  // seen
        low_x = std::min(low_x, x);
        high_x = std::max(high_x, x);
        high_y = std::max(high_y, y);
        for (const auto& [dx, dy] : {std::pair{1, 0}, {-1, 0}, {0, 1}, {0, -1}}) left.emplace_back(x + dx, y + dy);
      }
      const int wide = high_x - low_x + 1, high = high_y - from_y + 1;
      if (wide >= 9 && wide <= 15 && std::abs(wide - high) <= 1)
        found.emplace_back((low_x + high_x + 1) / 2, (from_y + high_y + 1) / 2);
    }
  }
  return found;
}

struct Drawn {
  Scratch scratch;
  Image image;
  Verdict verdict;
  Drawn(const Exercise& exercise, Attempt outcome) {
    verdict = judge(exercise, 1, outcome);
    REQUIRE(write_result_sheet(scratch / "sheet.png", exercise, 1, outcome, verdict));
    image = read_png(scratch / "sheet.png");
  }
};

Attempt sent(const Exercise& exercise, const Exercise::Played& answer) {
  Attempt outcome;
  for (std::size_t check = 0; check < exercise.checks.size(); ++check)
    outcome.numbers.push_back(scenes_of(answer, 1, check));
  return outcome;
}

/// The same with what its scenes show.
Attempt sent_with_bodies(const Exercise& exercise, const Exercise::Played& answer) {
  Attempt outcome = sent(exercise, answer);
  for (std::size_t check = 0; check < exercise.checks.size(); ++check) {
    for (std::size_t scene = 0; scene < scenes_of_a_check; ++scene) {
      Random random = random_of(1, check, scene);
      const Recording recording;
      answer(check, random);
      for (const Instant& instant : recording.instants()) outcome.shown[{check, scene}].push_back(numbers_of(instant));
    }
  }
  return outcome;
}

/// Checks, from 0 on, whose numbers no body shows: of equations and tables, of a separation alone.
bool is_without_bodies(const Exercise& exercise, std::size_t check) {
  static const std::map<std::string, std::set<std::size_t>> some{{"21_detected_once", {0, 1}}};
  static const std::set<std::string> all{"16_whole_problem",
                                         "17_direct_contacts",
                                         "19_accuracy_and_time",
                                         "19_accuracy_and_time_transfer",
                                         "22_wide",
                                         "23_threads",
                                         "24_half_step",
                                         "24_half_step_transfer",
                                         "25_moment_of_impact",
                                         "26_to_each_its_own",
                                         "27_which_error"};
  const auto found = some.find(exercise.name);
  return all.contains(exercise.name) || (found != some.end() && found->second.contains(check));
}

/// Mistakes whose bodies are the right ones, or out of all reach.
const std::set<std::pair<std::string, std::string>> not_to_be_seen{
    {"01_velocity_constraint", "sign of λ"},
    {"02_clamping", "stored unlimited"},
    {"15_limits_motors_springs_transfer", "another order"},
    {"20_only_what_is_needed", "the ground asleep"},
    {"21_detected_once", "relaxed by where the bodies are now"},
    {"21_detected_once", "the push-out turned round"}};

const Exercise& example() {
  static const std::vector<Exercise> all = all_exercises();
  return exercise_named(all, "03");
}

std::size_t strips(const Exercise& exercise) {
  std::size_t count = 0;
  for (const auto& check : exercise.checks) count += check.quantities.size() * scenes_of_a_check;
  return count;
}

}  // namespace

TEST_CASE("on the sheet of a right answer each number of yours stands on the right one, and there is no mistake") {
  const Drawn drawn(example(), sent(example(), example().right));
  const auto all = discs(drawn.image);
  CHECK(all.size() == strips(example()));
  for (const auto& [x, y] : all) {
    INFO(x << ", " << y);
    CHECK((is(drawn.image, x, y - 11, right) && is(drawn.image, x, y + 11, right)));
  }
  bool any = false;
  for (int y = 0; y < drawn.image.height; ++y)
    for (int x = 0; x < drawn.image.width; ++x) any = any || is(drawn.image, x, y, mistaken);
  CHECK_FALSE(any);
}

TEST_CASE("on the sheet of a mistake each number of yours stands in the ring of the mistake") {
  for (std::size_t i = 0; i < example().mistakes.size(); i += 5) {  // a picture takes a second
    const auto& mistake = example().mistakes[i];
    INFO(mistake.name);
    const Drawn drawn(example(), sent(example(), mistake.played));
    REQUIRE(drawn.verdict.resembles);
    CHECK(drawn.verdict.resembles->name == mistake.name);
    std::size_t in_ring = 0, off = 0;
    for (const auto& [x, y] : discs(drawn.image)) {
      in_ring += is(drawn.image, x - 10, y, mistaken) && is(drawn.image, x + 10, y, mistaken);
      off += !is(drawn.image, x, y - 11, right);
    }
    CHECK(in_ring == strips(example()));
    CHECK(off > 0);
  }
}

TEST_CASE("numbers that lie far off, or are none, leave the others readable, and what was never sent has no disc") {
  Attempt outcome = sent(example(), example().right);
  outcome.numbers[0][0][0] = 1e300;
  outcome.numbers[1][0][0] = -std::numeric_limits<Real>::infinity();
  outcome.numbers[1][1][1] = std::numeric_limits<Real>::quiet_NaN();
  const Drawn drawn(example(), outcome);
  CHECK(discs(drawn.image).size() == strips(example()) - 3);
  outcome.numbers.pop_back();
  CHECK(discs(Drawn(example(), outcome).image).size() ==
        strips(example()) - 3 - scenes_of_a_check * example().checks.back().quantities.size());
}

TEST_CASE("each check shows the bodies that its numbers are of, but for those of no body") {
  for (const Exercise& exercise : all_exercises()) {
    for (std::size_t check = 0; check < exercise.checks.size(); ++check) {
      Random random = random_of(1, check, 0);
      const Recording recording;
      exercise.right(check, random);
      for (std::size_t quantity = 0; quantity < exercise.checks[check].quantities.size(); ++quantity) {
        INFO(exercise.name << ", check " << check << ": " << exercise.checks[check].quantities[quantity].words);
        CHECK((is_without_bodies(exercise, check) ||
               std::any_of(recording.instants().begin(), recording.instants().end(), [&](const Instant& instant) {
                 const auto& of = instant.quantities;
                 return of.empty() || std::count(of.begin(), of.end(), quantity) > 0;
               })));
      }
    }
  }
}

TEST_CASE("the first check that a mistake fails has bodies that differ from the right ones") {
  for (const Exercise& exercise : all_exercises()) {
    for (const auto& mistake : exercise.mistakes) {
      if (not_to_be_seen.contains({exercise.name, mistake.name})) continue;
      INFO(exercise.name << ": " << mistake.name);
      const Attempt outcome = sent_with_bodies(exercise, mistake.played);
      const Verdict verdict = judge(exercise, 1, outcome);
      const auto first = std::find(verdict.checks.begin(), verdict.checks.end(), Passed::no);
      REQUIRE(first != verdict.checks.end());
      if (is_without_bodies(exercise, static_cast<std::size_t>(first - verdict.checks.begin()))) continue;
      CHECK(telling_instant(exercise, 1, outcome, verdict));
    }
  }
}

TEST_CASE("where nothing was sent there is no picture, not even an old one") {
  const Scratch scratch;
  write_text_file(scratch / "sheet.png", "of last time");
  CHECK_FALSE(write_result_sheet(scratch / "sheet.png", example(), 1, {}, judge(example(), 1, {})));
  CHECK_FALSE(fs::exists(scratch / "sheet.png"));
}

TEST_CASE("what is recorded during a scene is drawn below, and is no part of the verdict") {
  const auto falling = [](Real speed) {
    return Exercise::Played([speed](std::size_t, Random& random) {
      Numbers numbers{random.between(1, 2)};
      for (int step = 0; step < 30; ++step) numbers.push_back(speed * static_cast<Real>(step));
      return numbers;
    });
  };
  Exercise exercise{"falling", {}, {{"it falls", 1, {{"it begins at", "m", 1e-6}}, {}}}, falling(1), {}};
  exercise.name = "00_example";
  const int without = Drawn(exercise, {{{{1}, {1}, {1}}}, {}, {}, {}}).image.height;
  exercise.checks[0].recorded = Recorded{"its height", "m", "step"};
  const Drawn same(exercise, sent(exercise, falling(1))), other(exercise, sent(exercise, falling(2)));
  CHECK(other.verdict.passed());
  CHECK(same.image.height > without + 300);
  CHECK(difference(same.image, other.image).mean > 0);
  for (const Numbers& numbers : {Numbers{1}, Numbers{1, 2, 3, 4}}) {  // fewer, and more than were asked for
    Attempt outcome = sent(exercise, falling(1));
    outcome.numbers[0][0] = numbers;
    CHECK(discs(Drawn(exercise, outcome).image).size() >= scenes_of_a_check - 1);
  }
}
