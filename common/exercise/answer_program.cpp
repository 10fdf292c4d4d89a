/// Input: a word that is new in each run, the seed, and the number of checks. Output: lines that begin with that word.
#include <fmt/format.h>
#include <unistd.h>

#include <iostream>

#include "pushback/common/exercise/answer_program.h"

using namespace pushback;

int main() {
  std::string word;
  std::uint64_t seed = 0;
  std::size_t checks = 0;
  std::cin >> word >> seed >> checks;
  std::FILE* out = fdopen(dup(STDOUT_FILENO), "w");
  dup2(STDERR_FILENO, STDOUT_FILENO);  // output of the student's file is not an answer
  const auto say = [&](const std::string& line) {
    fmt::print(out, "{} {}\n", word, line);
    std::fflush(out);
  };
  for (std::size_t check = 0; check < checks; ++check) {
    for (std::size_t scene = 0; scene < scenes_of_a_check; ++scene) {
      say(fmt::format("check {}", check));
      Random random = random_of(seed, check, scene);
      try {
        say(fmt::format("numbers {}", fmt::join(students_numbers(check, random), " ")));
      } catch (const std::bad_alloc&) {
        say("memory");
        return 1;
      } catch (const std::exception& problem) {
        say(fmt::format("exception {}", problem.what()));
        return 1;
      }
    }
  }
  say("end");
}
