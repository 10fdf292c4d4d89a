/// The hard cases under the methods of tools/methods: a table of its own, for docs/methods.md.
#include <thread>

#include "pushback/chapters/11_substeps/substeps.h"
#include "pushback/common/basics/files.h"
#include "pushback/common/experiment/program.h"
#include "pushback/tools/measure/hard_cases/table.h"
#include "pushback/tools/measure/results/markdown.h"
#include "pushback/tools/methods/methods.h"

using namespace pushback;

namespace {

/// In substeps, each of so many sweeps; from one start, as it is.
template <class ContactSolver>
Stage stage(const std::string& name, int substeps, int sweeps) {
  ContactSolver solver;
  if constexpr (requires { solver.slop; }) solver.slop = Real(1e-4);  // as in the study
  Stage made{{name, "", solver, {}}};
  if constexpr (std::same_as<ContactSolver, Xpbd>) {
    solver.substeps = substeps;
    made.solver = solver;
  } else {
    made.solver = Substeps<ContactSolver>(solver, substeps, sweeps);
  }
  made.most_starts = 1;
  return made;
}

std::vector<Stage> compared() {
  using Cone = Solver<Clamping, Baumgarte, Slop, Restitution, FrictionCone, WarmStart>;
  return {stage<Cone>("slim", 4, 4), stage<Xpbd>("xpbd", 16, 1), stage<Avbd>("avbd", 4, 4),
          stage<ConjugateSolver>("nncg", 4, 4), stage<Sap>("sap", 4, 1)};
}

/// Whether all numbers are, whatever invariant broke.
bool within_limits(const Table& table, std::size_t row, std::size_t column) {
  Outcome outcome = table.at(row, column);
  outcome.broken.clear();
  return outcome.passed(table.cases[row]);
}

/// A row a case: a check mark, or the number that is furthest beyond its limit and the invariant that broke. First how many pass, and
/// in how many the numbers alone are within their limits.
std::string page_of(const Table& table) {
  std::vector<std::string> heads{"case"}, sums{"*passed*"}, alone{"*the numbers alone*"};
  for (std::size_t column = 0; column < table.stages.size(); ++column) {
    int within = 0;
    for (std::size_t row = 0; row < table.cases.size(); ++row) within += within_limits(table, row, column) ? 1 : 0;
    heads.push_back(fmt::format("`{}`", table.stages[column].name));
    sums.push_back(fmt::format("{} of {}", table.passes(column), table.cases.size()));
    alone.push_back(std::to_string(within));
  }
  std::string text = markdown_heads(heads) + markdown_row(sums) + markdown_row(alone);
  for (std::size_t row = 0; row < table.cases.size(); ++row) {
    std::vector<std::string> cells{table.cases[row].title};
    for (std::size_t column = 0; column < table.stages.size(); ++column) {
      const Outcome& outcome = table.at(row, column);
      const bool refused = outcome.broken.find("joints") != std::string::npos;  // none, or none with bounds
      cells.push_back(table.passed(row, column) ? "✓"
                      : refused                 ? "refused"
                      : outcome.broken.empty()
                          ? worst_number(table, row, column)
                          : fmt::format("{}, {}", worst_number(table, row, column), in_a_word(outcome.broken)));
    }
    text += markdown_row(cells);
  }
  return text;
}

}  // namespace

int main(int argc, char** argv) {
  CommandLine line("The hard cases under the methods of docs/methods.md.");
  std::vector<std::string> names;
  std::string out = "renders";
  bool redraw = false;
  line.option("NAME", names, "Only these cases are played; the others stay as they are in cases.csv");
  line.option("--out", out, "The folder to write to, into methods/ in it").shows_default();
  line.flag("--redraw", redraw, "Nothing is played: the page of what is in cases.csv");
  return line.run(argc, argv, [&] {
    const std::filesystem::path folder = std::filesystem::path(out) / "methods";
    make_writable_folder(folder);
    if (redraw)
      return write_text_file(folder / "cases.md",
                             page_of(read_table_csv(read_text_file(folder / "cases.csv"), compared())));
    std::vector<HardCase> cases = hard_cases();
    if (!names.empty()) cases.clear();
    for (const std::string& name : names) cases.push_back(hard_case_named(name));
    Table table =
        play(std::move(cases), compared(), static_cast<int>(std::max(1U, std::thread::hardware_concurrency())),
             [](const Table& so_far, std::size_t, std::size_t done) {
               fmt::print("\r{} of {}", done, so_far.outcomes.size());
               std::fflush(stdout);
             });
    if (!names.empty())
      table = renewed(read_table_csv(read_text_file(folder / "cases.csv"), compared()), table, compared());
    write_text_file(folder / "cases.csv", table_csv(table));
    write_text_file(folder / "cases.md", page_of(table));
    fmt::print("\n{}\n", page_of(table));
  });
}
