/// The programs `motion_bullet`, `motion_ode` ..., and `motion_adapter`, whose adapter PUSHBACK_ADAPTER in the environment names: another
/// engine plays motions.
#include "pushback/common/basics/input.h"
#include "pushback/tools/measure/peers/peer.h"

using namespace pushback;

int main(int argc, char** argv) {
  std::vector<Method> methods;
  std::string version;
  try {
    methods = peer_methods();
    version = peer_version();
  } catch (const InvalidInput& problem) {
    fmt::print(stderr, "{}\n", problem.what());
    return 2;
  } catch (const std::exception& problem) {
    fmt::print(stderr, "{}\n", problem.what());
    return 1;
  }
  return play_program(argc, argv, "Plays a motion by another engine: how far from the truth, in what time.", version,
                      methods);
}
