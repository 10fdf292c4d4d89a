/// ./course hard-cases --peers: the hard cases under other engines, as a file, a page and a picture.
#include <cstdlib>

#include "pushback/common/basics/files.h"
#include "pushback/tools/measure/adapters/adapter.h"
#include "pushback/tools/measure/hard_cases/peers.h"
#include "pushback/tools/measure/hard_cases/table.h"

using namespace pushback;
namespace fs = std::filesystem;

int main(int argc, char** argv) {
  CommandLine line("Every hard case under other engines, each as it comes and tuned, beside ours.", "hard_cases_peers");
  std::string adapter;
  line.option("--adapter", adapter, "A program that hands cases to another engine, whose settings replace all others");
  return table_program(argc, argv, line, [&] {
    TableKind kind{.file = "peers",
                   .times = "peers_times.csv",
                   .picture = "peers",
                   .whole = adapter.empty(),
                   .giving_up = {.seconds = 900, .times = std::numeric_limits<int>::max()},
                   .page = peers_md,
                   .shown = [](const Table& peers) {
                     return beside_peers(read_table_csv(read_text_file("renders/hard_cases/table.csv")), peers);
                   }};
    const fs::path programs = fs::canonical("/proc/self/exe").parent_path();
    if (adapter.empty()) {
      kind.stages = peer_stages(programs);
    } else {
      setenv("PUSHBACK_ADAPTER", fs::absolute(adapter).c_str(), 1);  // where its program looks for it
      kind.stages = peer_stages(programs, the_adapter().settings());
    }
    return kind;
  });
}
