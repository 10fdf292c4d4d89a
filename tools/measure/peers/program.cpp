/// The programs `motion_bullet`, `motion_ode` ..., and `motion_adapter`, whose adapter PUSHBACK_ADAPTER in the environment names: another
/// engine plays motions, or a hard case.
#include "pushback/common/basics/input.h"
#include "pushback/common/basics/named.h"
#include "pushback/tools/measure/peers/peer.h"

using namespace pushback;

namespace {

Stage stage_of(const std::string& name) {
  const std::vector<PeerSetting> settings = settings_of_peer();
  const PeerSetting& setting = named("setting", settings, name);
  Stage stage{{setting.name, setting.what, EngineSolver(begin_engine, setting), {}}};
  stage.epsilon = setting.epsilon;
  stage.most_starts = peer_starts;
  return stage;
}

}  // namespace

int main(int argc, char** argv) {
  if (is_called_apart(argc, argv)) return program_apart(argc, argv, stage_of);
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
