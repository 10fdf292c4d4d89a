/// An exercise that checks itself: scenes that are played with an answer, and the numbers that they measure.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "pushback/common/bodies/random.h"

namespace pushback {

using Numbers = std::vector<Real>;

/// A number that a check looks at, as a sentence says it: "your box leaves with 0.31 m/s".
struct Quantity {
  std::string words;  ///< "your box leaves with"
  std::string unit;
  double tolerance;  ///< how far it may be from the right one
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
  std::string says;  ///< of a right answer: "a column that lands flat stays on the ground"
  int points;
  /// Plays a random scene and returns its readings. Their quantities and order are the same for every answer.
  std::function<std::vector<Reading>(Random&, const Answer&)> play;
  /// What is physically wrong with any answer that fails: goes on from "your column leaves with 0.31 m/s where 0 is right: ".
  std::string hint = {};
};

/// The same for every kind of answer.
struct Exercise {
  struct Line {
    std::string says;
    int points;
    std::vector<Quantity> quantities;
    std::string hint;
    int stage = 0;  ///< of a whole solver's: the chapter that asks for it
  };
  /// Plays a known answer in a scene of this check, and returns the measured numbers.
  using Played = std::function<Numbers(std::size_t check, Random&)>;

  std::string title;               ///< "accumulate, clamp, apply the difference"
  std::vector<std::string> hints;  ///< one more at each `--hint`
  std::vector<Line> checks;
  Played right;
  Played untouched = {};    ///< the file with the gap, as students get it
  std::string name = {};    ///< of its file: 03_baumgarte, 15_limits_motors_springs_transfer; from its folder
  std::string folder = {};  ///< chapters/03_baumgarte/exercise
  std::string object = {};  ///< of a teacher's own, and of a whole solver: what a student's program is linked with
  /// Of a whole solver alone, whose file is solver.h with headers beside it: what is compiled behind the student's text, which
  /// keeps the numbers of its lines.
  std::string behind = {};
  bool in_page = false;  ///< the chapter's page has the answer

  /// The second exercise of a chapter, whose first one rebuilds what the page shows.
  bool transfer() const { return !own() && name.ends_with("_transfer"); }
  /// A solver of the student's own.
  bool whole() const { return !behind.empty(); }
  /// In no chapter's folder: of a teacher, or a whole solver.
  bool own() const { return !object.empty(); }
  /// What is in no page. A whole solver is graded where it is asked for.
  bool graded() const { return !in_page && !whole(); }
};

/// The number of scenes in which each check is played.
inline constexpr std::size_t scenes_of_a_check = 3;

/// The random numbers of one of them.
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

/// The same of a rebuild, in which students write what the chapter's page shows.
template <class Answer>
Exercise rebuild_of(std::string title, std::vector<std::string> hints, const Answer& right) {
  Exercise made = exercise_of(std::move(title), std::move(hints), right);
  made.in_page = true;
  return made;
}

}  // namespace pushback
