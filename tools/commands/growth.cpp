/// ./course run growth: measures the cost of a direct solve as problems grow.
#include <array>
#include <chrono>

#include "pushback/chapters/11_substeps/substeps.h"
#include "pushback/chapters/12_soft_contacts/steady_solver.h"
#include "pushback/chapters/16_whole_problem/problem_file.h"
#include "pushback/chapters/17_direct_contacts/growth.h"
#include "pushback/common/experiment/program.h"
#include "pushback/common/world/situations.h"
#include "pushback/engine/direct/newton_system.h"
#include "pushback/engine/direct/row_matrix.h"
#include "pushback/engine/direct/smoothed_newton.h"

using namespace pushback;

namespace {

constexpr Real dt = Real(1) / 60;

struct Costs {
  std::vector<std::pair<double, double>> entries, fill, work, seconds;
};

/// A row of the table. What did not reach the tolerance is no part of the growth.
void print_row(const std::string& name, const ContactProblem& problem, const SparseMatrix& factor, double tolerance,
               Costs* costs) {
  const auto begin = std::chrono::steady_clock::now();
  const SmoothedSolution found = solve_smoothed(problem, {.tolerance = tolerance, .work = 1e12}, factor);
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  fmt::print("| {} | {} | {} | {} | {:.0f} | {:.0f} | {:.1e} | {:.1e}{} | {:.3f} |\n", name, problem.contacts(),
             factor.rows() > 0 ? "bodies" : "contacts", found.systems, found.entries, found.fill, found.work,
             found.residual, found.residual <= tolerance ? "" : ": not reached", seconds);
  std::fflush(stdout);
  if (costs == nullptr || !(found.residual <= tolerance)) return;
  const double contacts = static_cast<double>(problem.contacts());
  costs->entries.emplace_back(contacts, found.entries);
  costs->fill.emplace_back(contacts, found.fill);
  costs->work.emplace_back(contacts, found.work / found.systems);
  costs->seconds.emplace_back(contacts, seconds);
}

void print_growth(const std::string& between, const Costs& costs) {
  if (costs.entries.size() < 2) return;
  fmt::print(
      "pyramids, between {}: contacts to the power of {:.2f} in the matrix, {:.2f} with fill, {:.2f} in "
      "multiplications a system, {:.2f} in time\n",
      between, growth_exponent(costs.entries), growth_exponent(costs.fill), growth_exponent(costs.work),
      growth_exponent(costs.seconds));
}

/// A heap of a thousand boxes as it falls apart, and as it lies.
void print_heaps(double tolerance) {
  World world;
  heap(world, 10, 10, Real(-4.5));
  Substeps<SteadySolver> solver({}, 8);
  int seconds = 0;
  for (const int upto : {4, 12}) {
    for (; seconds < upto; ++seconds)
      for (int step = 0; step < 60; ++step) world.step(solver, dt);
    World frame = world;
    frame.begin_step(dt);
    print_row(fmt::format("heap of 1000 boxes after {} s", seconds), problem_of(frame), factor_of(frame), tolerance,
              nullptr);
  }
}

}  // namespace

int main(int argc, char** argv) {
  CommandLine line("All contacts solved at once by linear systems: pyramids of growing size, a heap, and files.");
  double tolerance = 1e-8;
  bool largest = false, heaped = false;
  std::vector<std::string> files;
  line.option("file", files, "Contact problems to solve as well, in the format of Siconos");
  line.option("--tolerance", tolerance, "The relative residual that is good enough").between(0.0, 1e6).shows_default();
  line.flag("--largest", largest, "Also solve a pyramid of 2016 boxes, which has 15,876 contacts");
  line.flag("--heap", heaped, "Also solve a heap of 1000 boxes, which takes a minute");
  return line.run(argc, argv, [&] {
    std::vector<ContactProblem> problems;  // all read before anything is solved
    for (const std::string& file : files) problems.push_back(read_problem_file(file));
    fmt::print(
        "| problem | contacts | systems between | systems | numbers in the matrix | in its factors | multiplications "
        "| residual | s |\n| --- | --- | --- | --- | --- | --- | --- | --- | --- |\n");
    Costs bodies, contacts;
    for (const int base : {5, 10, 20, 32, 63}) {
      if (base == 63 && !largest) continue;
      World world;
      pyramid(world, base);
      world.begin_step(dt);
      const ContactProblem problem = problem_of(world);
      const std::string name = fmt::format("pyramid of {} boxes", world.bodies.size() - 1);
      print_row(name, problem, factor_of(world), tolerance, &bodies);
      if (base <= 20) print_row(name, problem, {}, tolerance, &contacts);
    }
    if (heaped) print_heaps(tolerance);
    for (std::size_t i = 0; i < files.size(); ++i)
      print_row(std::filesystem::path(files[i]).stem().string(), problems[i], {}, tolerance, nullptr);
    print_growth("bodies", bodies);
    print_growth("contacts", contacts);
  });
}
