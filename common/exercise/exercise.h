/// A self-checking exercise plays scenes with an answer and compares the measured numbers with the right ones.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "pushback/common/bodies/random.h"

namespace pushback {

using Numbers = std::vector<Real>;

/// A number that a check compares, with its words for a sentence: "your box leaves with 0.31 m/s".
struct Quantity {
  std::string words;  ///< "your box leaves with"
  std::string unit;
  double tolerance;  ///< allowed absolute difference from the right value, in `unit`
};

/// One measured value of a scene, with its quantity.
struct Reading : Quantity {
  template <class Value>
  Reading(std::string its_words, Value its_value, std::string its_unit = "", double its_tolerance = 1e-6)
      : Quantity{std::move(its_words), std::move(its_unit), its_tolerance}, value(static_cast<Real>(its_value)) {}
  Real value;
};

/// `Answer`: the functions, or the effect, that the student writes. `checks_of`, declared after it, lists the checks of the exercise.
template <class Answer>
struct Check {
  std::string says;  ///< about a right answer: "a column that lands flat stays on the ground"
  int points;
  /// Plays a random scene and returns its readings. Their quantities and order are the same for every answer.
  std::function<std::vector<Reading>(Random&, const Answer&)> play;
  /// The physical error of every answer that fails. It continues "your column leaves at 0.31 m/s, but 0 is right: ".
  std::string hint = {};
};

/// An exercise, whatever the type of its answer.
struct Exercise {
  struct Line {
    std::string says;
    int points;
    std::vector<Quantity> quantities;
    std::string hint;
    int stage = 0;  ///< for a whole solver: the chapter that introduces this check
  };
  /// Plays a known answer in a scene of this check, and returns the measured numbers.
  using Played = std::function<Numbers(std::size_t check, Random&)>;

  std::string title;               ///< "accumulate, clamp, apply the difference"
  std::vector<std::string> hints;  ///< each `--hint` shows one more
  std::vector<Line> checks;
  Played right;
  Played untouched = {};    ///< the file with the gap, as students receive it
  std::string name = {};    ///< 03_baumgarte, 15_limits_motors_springs_transfer; a teacher's own: its folder's
  std::string folder = {};  ///< chapters/03_baumgarte/exercise
  std::string object = {};  ///< only for a teacher's own and a whole solver: the file that a student's program links
  /// Only for a whole solver, whose file is solver.h with headers next to it. This code is compiled after the student's text, so the
  /// student's line numbers stay the same.
  std::string behind = {};
  bool in_page = false;  ///< whether the chapter's page shows the answer

  /// Whether it is the second exercise of a chapter. The first one rebuilds the code on the page.
  bool transfer() const { return !own() && name.ends_with("_transfer"); }
  /// Whether the answer is a whole solver of the student's own.
  bool whole() const { return !behind.empty(); }
  /// Whether it is outside the chapters' folders: a teacher's own exercise, or a whole solver.
  bool own() const { return !object.empty(); }
  /// Whether it is graded by default, because its answer is on no page. A whole solver is graded on request.
  bool graded() const { return !in_page && !whole(); }
};

/// The number of scenes in which each check is played.
inline constexpr std::size_t scenes_of_a_check = 3;

/// The random numbers of one scene of a check.
inline Random random_of(std::uint64_t seed, std::size_t check, std::size_t scene) {
  std::uint64_t mixed = seed;
  for (const std::uint64_t part : {check, scene}) mixed = (mixed ^ (part + 1)) * 0x9e3779b97f4a7c15u + (mixed >> 29);
  return Random(mixed);
}

/// The numbers that a scene of a check measures.
template <class Answer>
Numbers play(std::size_t check, Random& random, const Answer& answer) {
  Numbers numbers;
  for (const Reading& reading : checks_of(answer)[check].play(random, answer)) numbers.push_back(reading.value);
  return numbers;
}

template <class Answer>
Exercise exercise_of(std::string title, std::vector<std::string> hints, const Answer& right) {
  Exercise made{std::move(title), std::move(hints), {}, [right](std::size_t check, Random& random) {
                  return play(check, random, right);
                }};
  for (const Check<Answer>& check : checks_of(right)) {
    Random random = random_of(0, made.checks.size(), 0);
    const std::vector<Reading> readings = check.play(random, right);
    made.checks.push_back({check.says, check.points, {readings.begin(), readings.end()}, check.hint});
  }
  return made;
}

/// The same for a rebuild, in which students write the code on the chapter's page.
template <class Answer>
Exercise rebuild_of(std::string title, std::vector<std::string> hints, const Answer& right) {
  Exercise made = exercise_of(std::move(title), std::move(hints), right);
  made.in_page = true;
  return made;
}

}  // namespace pushback
