/// ./course hard-cases: every case under every stage, as files and as a picture; or these again from table.csv.
#include "pushback/common/basics/files.h"
#include "pushback/common/experiment/loaded_solver.h"
#include "pushback/tools/measure/hard_cases/table.h"

using namespace pushback;

namespace {

/// The solver of a shared object; see common/experiment/loaded_solver.h. Throws InvalidInput where it is none.
Stage mine(const std::string& library) {
  return {{"mine", "your own, as it was when the table was made", loaded_solver(library), {}}};
}

}  // namespace

int main(int argc, char** argv) {
  if (is_called_apart(argc, argv)) return program_apart(argc, argv, mine);
  CommandLine line("Every hard case under every stage of the solver: which feature keeps which case stable?",
                   "hard_cases_table");
  std::string library;
  bool quick = false;
  line.flag("--quick", quick, "Only the chapters' stages, without the later stages");
  line.option("--mine", library,
              "A solver as a shared object, added as a column 'mine'; each of its cases is played in its own process");
  return table_program(argc, argv, line, [&] {
    TableKind kind{.stages = table_stages(), .whole = library.empty() && !quick};
    if (quick) kind.stages.erase(kind.stages.begin() + chapter_stages, kind.stages.end());
    if (library.empty()) return kind;
    kind.further = {mine(library)};
    kind.further.back().apart = {std::filesystem::canonical("/proc/self/exe"), "--setting", library};
    return kind;
  });
}
