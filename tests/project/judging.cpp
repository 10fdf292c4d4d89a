/// Which mistake a verdict names, and the picture of the bodies beside it.
#include <fmt/format.h>

#include <map>

#include "pushback/common/exercise/shown.h"
#include "pushback/tools/classroom/all_exercises.h"
#include "pushback/tools/classroom/bodies_picture.h"
#include "pushback/tools/classroom/judge.h"
#include "pushback/tools/classroom/telling_instant.h"
#include "tests/support/call.h"

using namespace pushback;

namespace {

/// Plays known numbers: one number for each check, whatever the seed.
Exercise::Played numbers(std::vector<Real> of_checks) {
  return [of_checks](std::size_t check, Random&) { return Numbers{of_checks[check]}; };
}

Attempt sent(const Exercise& exercise, const Exercise::Played& answer) {
  Attempt outcome;
  for (std::size_t check = 0; check < exercise.checks.size(); ++check)
    outcome.numbers.push_back(scenes_of(answer, 1, check));
  return outcome;
}

Exercise with_mistakes(std::vector<Exercise::Known> mistakes) {
  const std::vector<Quantity> quantities{{"your ball leaves with", "m/s", 1e-6}};
  return {"", {}, {{"first", 1, quantities, {}}, {"second", 1, quantities, {}}}, numbers({0, 0}), std::move(mistakes)};
}

bool fails(const Exercise& exercise, const Exercise::Played& answer, std::size_t check) {
  return judge(exercise, 1, sent(exercise, answer)).checks[check] == Passed::no;
}

/// Names may have " or " in them, too.
bool names(const Verdict& verdict, const std::string& mistake) {
  return contains(" or " + verdict.mistake + " or ", " or " + mistake + " or ");
}

World of_two() {
  World world;
  world.bodies.push_back(ground());
  for (const Real x : {Real(-0.6), Real(0.7)}) {
    Body ball = sphere(Real(0.5), 1);
    ball.position = {x, Real(0.5), 0};
    ball.velocity = {x, 2, 0};
    world.bodies.push_back(ball);
  }
  Contact contact;
  contact.point = {Real(-0.6), 0, 0};
  contact.normal = {0, 1, 0};
  contact.impulse = {0, 3, 0};
  world.contacts.push_back(contact);
  return world;
}

bool same(const Image& one, const Image& other) {
  return one.width == other.width && one.height == other.height && difference(one, other).mean == 0;
}

}  // namespace

TEST_CASE("no mistake is named that fails a check which the answer has passed") {
  std::size_t half_right = 0, named = 0;
  for (const Exercise& exercise : all_exercises()) {
    for (const auto& mistake : exercise.mistakes) {
      const Attempt mistaken = sent(exercise, mistake.played);
      for (std::size_t check = 0; check < exercise.checks.size(); ++check) {
        Attempt outcome = sent(exercise, exercise.right);  // but for one check, which shows the mistake
        outcome.numbers[check] = mistaken.numbers[check];
        const Verdict verdict = judge(exercise, 1, outcome);
        if (verdict.passed()) continue;
        ++half_right;
        INFO(exercise.name << ", " << mistake.name << " in check " << check + 1 << ": " << verdict.mistake);
        std::map<std::string, bool> possible;  // a mistake that can be written in two ways stands there twice
        for (const auto& known : exercise.mistakes) {
          if (!names(verdict, known.name)) continue;
          bool contradicted = false;
          for (std::size_t other = 0; other < exercise.checks.size(); ++other)
            contradicted =
                contradicted || (verdict.checks[other] == Passed::yes && fails(exercise, known.played, other));
          possible[known.name] = possible[known.name] || !contradicted;
        }
        named += possible.size();
        for (const auto& [name, is_possible] : possible) {
          INFO(name);
          CHECK(is_possible);
        }
      }
    }
  }
  CHECK(half_right > 100);
  CHECK(named > 50);
}

TEST_CASE("a mistake that fails a check which was passed gives way to one that does not, or to none") {
  const Exercise::Known both{"both fail", "hint of both.", numbers({1, 5})},
      first{"the first fails", "hint of the first.", numbers({1, 0})};
  CHECK(judge(with_mistakes({both}), 1, sent(with_mistakes({}), numbers({1, 0}))).mistake.empty());
  CHECK(judge(with_mistakes({both, first}), 1, sent(with_mistakes({}), numbers({1, 0}))).mistake == "the first fails");
  CHECK(judge(with_mistakes({first, both}), 1, sent(with_mistakes({}), numbers({1, 5}))).mistake == "both fail");
}

TEST_CASE("mistakes that show the same are all named, up to three, and the one that explains more is named alone") {
  const auto known = [](const std::string& name, std::vector<Real> of_checks) {
    return Exercise::Known{name, "hint of " + name + ".", numbers(std::move(of_checks))};
  };
  const Attempt outcome = sent(with_mistakes({}), numbers({1, 7}));
  const auto verdict_with = [&](const std::vector<Exercise::Known>& mistakes) {
    return judge(with_mistakes(mistakes), 1, outcome);
  };
  const Verdict two = verdict_with({known("a", {1, 2}), known("b", {1, 3}), known("c", {4, 7})});
  CHECK(two.mistake == "a or b");
  CHECK(two.resembles != nullptr);
  CHECK(two.sentence ==
        "your ball leaves with 1 m/s where 0 m/s is right: it is one of these: hint of a. Or: hint of b.");
  CHECK(verdict_with({known("a", {1, 2}), known("a", {1, 3}), known("b", {1, 4})}).mistake == "a or b");
  CHECK(verdict_with({known("a", {1, 2}), known("b", {1, 3}), known("c", {1, 4})}).mistake == "a or b or c");
  const Verdict four = verdict_with({known("a", {1, 2}), known("b", {1, 3}), known("c", {1, 4}), known("d", {1, 5})});
  CHECK(four.mistake.empty());
  CHECK(contains(four.sentence, "None of the mistakes that are known here shows these numbers alone."));
  CHECK(verdict_with({known("a", {1, 2}), known("b", {1, 7})}).mistake == "b");
}

TEST_CASE("numbers of the untouched file say that nothing changes, beside the mistake that shows the same") {
  const Exercise exercise = with_mistakes({{"forgotten", "it was forgotten.", numbers({1, 0})}});
  const Attempt outcome = sent(exercise, numbers({1, 0}));
  const Verdict same_as_gap = judge(exercise, 1, outcome, [&] { return outcome; });
  CHECK(same_as_gap.changes_nothing);
  CHECK(same_as_gap.mistake == "nothing changes or forgotten");
  CHECK(contains(same_as_gap.sentence, "your lines change nothing"));
  const Verdict another = judge(exercise, 1, outcome, [&] { return sent(exercise, numbers({2, 0})); });
  CHECK_FALSE(another.changes_nothing);
  CHECK(another.mistake == "forgotten");
}

TEST_CASE("two numbers that differ in their fourth digit are told with four") {
  Exercise exercise = with_mistakes({});
  exercise.right = numbers({Real(3.45123), 0});
  const std::string sentence = judge(exercise, 1, sent(exercise, numbers({Real(3.45223), 0}))).sentence;
  CHECK(contains(sentence, "leaves with 3.452 m/s where 3.451 m/s is right"));
}

TEST_CASE("what is said of bodies is taken only if it makes sense, and then comes back as it was") {
  const World right = of_two();
  const Numbers said = numbers_of({0, {}, right});
  const auto is_taken = [&](const Numbers& changed) { return with_numbers(right, changed).has_value(); };
  REQUIRE(is_taken(said));
  CHECK(numbers_of({0, {}, *with_numbers(right, said)}) == said);
  for (std::size_t i = 0; i < said.size(); ++i) {
    for (const Real bad : {std::numeric_limits<Real>::quiet_NaN(), std::numeric_limits<Real>::infinity(), Real(1e30)}) {
      Numbers changed = said;
      changed[i] = bad;
      CHECK_FALSE(is_taken(changed));
    }
    CHECK_FALSE(is_taken(Numbers(said.begin(), said.begin() + static_cast<std::ptrdiff_t>(i))) ==
                (i != 1 + 14 * right.bodies.size()));  // those of all bodies and of no contact are an instant
  }
  Numbers more = said;
  more.insert(more.end(), 14, Real(1));  // a body more
  CHECK_FALSE(is_taken(more));
  more = said;
  for (std::size_t i = 1; i < most_contacts; ++i) more.insert(more.end(), said.end() - 12, said.end());
  CHECK(is_taken(more));
  more.insert(more.end(), said.end() - 12, said.end());
  CHECK_FALSE(is_taken(more));
  Numbers names = said;  // bodies and state of a contact that are none
  for (std::size_t i = 1; i <= 3; ++i) names[names.size() - i] = i == 2 ? Real(-7) : Real(99999);
  const std::optional<World> world = with_numbers(right, names);
  REQUIRE(world);
  CHECK(world->contacts[0].id.body_a < right.bodies.size());
  CHECK(world->contacts[0].id.body_b < right.bodies.size());
}

TEST_CASE("equal bodies give equal halves of the picture, and those that differ do not") {
  const World right = of_two();
  World yours = right;
  const BodiesPicture equal = picture_of_bodies(yours, right, 320, 240);
  CHECK(same(equal.yours, equal.right));
  CHECK(equal.note.empty());
  yours.bodies[1].position.y() += Real(0.4);
  const BodiesPicture moved = picture_of_bodies(yours, right, 320, 240);
  CHECK_FALSE(same(moved.yours, moved.right));
  CHECK(contains(moved.note, "Thin lines: where the right ones are."));
  yours = right;
  yours.bodies[2].velocity *= Real(0.5);
  const BodiesPicture slower = picture_of_bodies(yours, right, 320, 240);
  CHECK_FALSE(same(slower.yours, slower.right));
  for (const Real far : {Real(9e5), Real(-9e5)}) {  // as far as is taken at all
    yours = right;
    yours.bodies[1].position = yours.bodies[1].velocity = yours.bodies[1].angular_velocity = Vec3::Constant(far);
    CHECK_FALSE(picture_of_bodies(yours, right, 320, 240).note.empty());
  }
}
