/// The hard cases under the methods of tools/methods: a table of its own, for docs/methods.md.
#include "pushback/chapters/11_substeps/substeps.h"
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
  return {stage<Cone>("slim", 4, 4), stage<Xpbd>("xpbd", 16, 1),
          stage<Avbd>("avbd", 4, 4), stage<ConjugateSolver>("nncg", 4, 4),
          stage<Sap>("sap", 4, 1),   stage<SapLagged>("sap-lagged", 4, 1)};
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
  CommandLine line("The hard cases under the methods of docs/methods.md.", "hard_cases_methods");
  return table_program(argc, argv, line, [] {
    return TableKind{.folder = "methods",
                     .file = "cases",
                     .picture = "",
                     .stages = compared(),
                     .page = [](const Table& table, const std::filesystem::path&) { return page_of(table); }};
  });
}
