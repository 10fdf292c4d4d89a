/// The program `motion_mine`: a reader's solver plays motions. PUSHBACK_MINE in the environment names its library: every program
/// that plays motions is called alike.
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <string_view>

#include "pushback/common/basics/input.h"
#include "pushback/common/experiment/loaded_solver.h"
#include "pushback/tools/measure/results/built_by.h"
#include "pushback/tools/measure/study/ours.h"

using namespace pushback;

namespace {

constexpr unsigned patience = 20;  // s, for one frame

void give_up(int) {
  constexpr std::string_view said = "no end of 1/60 s within 20 s\n";
  [[maybe_unused]] const auto written = write(STDERR_FILENO, said.data(), said.size());
  _exit(1);
}

class Mine : public Ours {
 public:
  using Ours::Ours;
  void steps(int count, double h) override {
    alarm(patience);
    Ours::steps(count, h);
  }
};

}  // namespace

int main(int argc, char** argv) {
  std::signal(SIGALRM, give_up);
  const char* const library = std::getenv("PUSHBACK_MINE");
  std::vector<Method> methods;
  try {
    if (!library) throw InvalidInput("PUSHBACK_MINE is not set: the name of a library is needed");
    const AnySolver solver = loaded_solver(library);
    methods.push_back(
        {.name = "mine",
         .title = "your own",
         .plays = [solver](const Motion& motion) { return motion.pins.empty() || solver.supports_joints(); },
         .begin = [solver](const World& world, const Setting& setting) -> std::unique_ptr<Player> {
           return std::make_unique<Mine>(world, solver, setting.sweeps, false);
         }});
  } catch (const InvalidInput& problem) {
    fmt::print(stderr, "{}\n", problem.what());
    return 2;
  }
  return play_program(argc, argv, "Plays a motion by a solver of the reader's own.",
                      fmt::format("your own; {}", built_by()), methods);
}
