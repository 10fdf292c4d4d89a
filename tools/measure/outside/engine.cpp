/// outside_ENGINE SCENE SETTING SECONDS: plays a scene by another engine, and prints a line of results.
#include <cstdlib>

#include "pushback/common/basics/named.h"
#include "pushback/tools/measure/outside/play.h"
#include "pushback/tools/measure/peers/peer.h"

using namespace pushback;
using namespace pushback::outside;

int main(int argc, char** argv) try {
  if (argc != 4) throw InvalidInput("outside_ENGINE SCENE SETTING SECONDS is needed");
  const std::vector<PeerSetting> settings = settings_of_peer();
  const PeerSetting& setting = named("setting", settings, std::string(argv[2]));
  const Stage stage{{setting.name, setting.what, EngineSolver(begin_engine, setting), {}}};
  fmt::print("{}", line_of(play(scene_named(argv[1]), stage, std::atof(argv[3]))));
  return 0;
} catch (const InvalidInput& problem) {
  fmt::print(stderr, "{}\n", problem.what());
  return 2;
}
