/// The programs hard_cases_bullet, hard_cases_ode ...: another engine plays hard cases.
#include <algorithm>

#include "pushback/common/basics/files.h"
#include "pushback/common/basics/named.h"
#include "pushback/common/experiment/program.h"
#include "pushback/tools/measure/peers/engine.h"
#include "pushback/tools/measure/peers/peer.h"

using namespace pushback;

int main(int argc, char** argv) {
  std::string name, setting_name, out = "renders";
  int starts = peer_starts;
  CommandLine line("Plays a hard case by another engine; what it did goes to hard_cases/part, as of hard_cases_table.");
  line.version(peer_version(), "Which engine plays, of which version, built how");
  line.option("NAME", name, "The case");
  line.option("--setting", setting_name, "Which setting of the engine");
  line.option("--starts", starts, "At most so many starts").between(1, peer_starts);
  line.option("--out", out, "Folder in which the folder hard_cases is made");
  return line.run(argc, argv, [&] {
    HardCase hard_case = hard_case_named(name);
    hard_case.starts = std::min(hard_case.starts, starts);
    const std::vector<PeerSetting> settings = settings_of_peer();
    const PeerSetting& setting = named("setting", settings, setting_name);
    Stage stage{{setting.name, setting.what, EngineSolver(begin_engine, setting), {}}};
    stage.epsilon = setting.epsilon;
    stage.most_starts = peer_starts;
    const Table table = play({hard_case}, {stage}, 1, [](const Table&, std::size_t, std::size_t) {});
    const std::filesystem::path folder = std::filesystem::path(out) / "hard_cases" / "part";
    make_writable_folder(folder);
    write_text_file(folder / "table.csv", table_csv(table));
    write_text_file(folder / "times.csv", times_csv(table));
  });
}
