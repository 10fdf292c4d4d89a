/// ./course run solve: solves contact problems from files by any of the methods, or makes a table of all.
#include <chrono>

#include "pushback/chapters/16_whole_problem/laws.h"
#include "pushback/chapters/16_whole_problem/problem_file.h"
#include "pushback/chapters/17_direct_contacts/methods.h"
#include "pushback/common/basics/files.h"
#include "pushback/common/experiment/program.h"

using namespace pushback;

namespace {

struct Asked {
  std::vector<std::string> files;
  std::string method = "best";
  int sweeps = 1000;
  double tolerance = 1e-13;
  bool table = false, laws = false;
  std::string write;  // empty: nowhere
};

/// Before anything is solved, since that may take a minute.
void check_place_of_solution(const Asked& asked) {
  const std::filesystem::path to = asked.write, folder = std::filesystem::absolute(to).parent_path();
  if (asked.table || asked.laws) throw InvalidInput("--write with a table: one method is needed");
  if (asked.files.size() != 1)
    throw InvalidInput(fmt::format("--write with {} problems: one is needed", asked.files.size()));
  std::error_code error;
  if (std::filesystem::equivalent(to, asked.files[0], error))
    throw InvalidInput(fmt::format("--write is '{}', the problem itself: another file is needed", asked.write));
  if (std::filesystem::is_directory(to, error) || !std::filesystem::is_directory(folder, error))
    throw InvalidInput(
        fmt::format("--write is '{}': the name of a file in a folder that is there is needed", asked.write));
  require_writable_file(to);
}

const std::string pivoting = "pivoting";  // no column of the tables, because they are for problems with friction

std::vector<std::string> methods_to_ask_for() {
  std::vector<std::string> names = method_names();
  names.push_back(pivoting);
  return names;
}

void print(const Asked& asked, const std::string& file, ContactProblem problem) {
  const bool pivots = asked.method == pivoting;
  if (pivots) problem.mu.setZero();
  const auto begin = std::chrono::steady_clock::now();
  const Solution found =
      pivots ? solve_frictionless(problem) : solve(problem, asked.method, asked.sweeps, asked.tolerance);
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  if (!std::isfinite(found.residual))
    throw std::runtime_error(
        fmt::format("{}: {} has left the range of numbers after {} sweeps; another method is needed", file,
                    asked.method, found.sweeps));
  fmt::print("{}: {} contacts, W symmetric to {:.0e}\n", file, problem.contacts(), asymmetry(problem));
  if (pivots) fmt::print("pivoting: {} pivots, friction left out: every mu is taken as 0\n", found.pivots);
  else
    fmt::print("{}: {} sweeps, {} linear systems{}\n", asked.method, found.sweeps, found.systems,
               found.work > 0 ? fmt::format(", {:.1e} multiplications", found.work) : "");
  fmt::print("time {:.2f} s\nunitless residual {:.1e}\nresidual {:.1e}\n", seconds, unitless_residual(problem, found.r),
             found.residual);
  if (!asked.write.empty()) write_text_file(asked.write, solution_text(problem, found.r));
}

/// A row per method: by how much it breaks each law after `sweeps`.
void print_laws(const std::string& file, const ContactProblem& problem, int sweeps) {
  for (const std::string& method : method_names()) {
    const Solution found = solve(problem, method, sweeps, counts_sweeps(method) ? 0 : 1e-13);
    const BrokenLaws broken = broken_laws(problem, found.r);
    fmt::print("| {} | {} | {:.0e} | {:.0e} | {:.0e} | {:.0e} | {:.0e} | {:.0e} |\n",
               std::filesystem::path(file).stem().string(), method, broken.overlap, broken.pull, broken.complementarity,
               broken.cone, broken.dissipation, unitless_residual(problem, found.r));
  }
}

/// The residual of each method after 10, 100, 1000 sweeps, and of the best.
void print_row(const std::string& file, const ContactProblem& problem) {
  std::string row = fmt::format("| {} | {} ", std::filesystem::path(file).stem().string(), problem.contacts());
  for (const std::string& method : method_names()) {
    if (!counts_sweeps(method)) row += fmt::format("| {:.0e} ", solve(problem, method, 0, 1e-13).residual);
    else
      for (const int sweeps : {10, 100, 1000})
        row += fmt::format("{} {:.0e} ", sweeps == 10 ? "|" : "/", solve(problem, method, sweeps, 0).residual);
  }
  fmt::print("{}|\n", row);
}

}  // namespace

int main(int argc, char** argv) {
  CommandLine line("Contact problems in the format of Siconos: how well a method solves them.");
  Asked asked;
  line.option("file", asked.files, "Files of contact problems").required();
  line.option("--method", asked.method, "The method; pivoting leaves friction out")
      .one_of(methods_to_ask_for())
      .shows_default();
  line.option("--sweeps", asked.sweeps,
              "Largest number of sweeps; smoothed, best and pivoting take as many as they need")
      .between(0, 100000000)
      .shows_default();
  line.option("--tolerance", asked.tolerance, "The relative residual that is good enough")
      .between(0.0, 1e6)
      .shows_default();
  const CommandLine::Option table = line.flag(
      "--table", asked.table, "A row per file, with all methods after 10 / 100 / 1000 sweeps, smoothed and best");
  line.flag("--laws", asked.laws, "A row per method, with the amount by which it breaks each law after --sweeps")
      .without(table);
  line.option("--write", asked.write, "The file for r and u, six numbers per contact");
  return line.run(argc, argv, [&] {
    if (!asked.write.empty()) check_place_of_solution(asked);
    std::vector<ContactProblem> problems;  // all read before anything is solved
    for (const std::string& file : asked.files) problems.push_back(read_problem_file(file));
    if (asked.table)
      fmt::print("| problem | contacts | {} |\n|{}\n", fmt::join(method_names(), " | "),
                 " --- | --- | --- | --- | --- | --- | --- | --- |");
    if (asked.laws)
      fmt::print(
          "| problem | method | overlap | pull | push and part | outside the cone | not against the slip | all |\n"
          "| --- | --- | --- | --- | --- | --- | --- | --- |\n");
    for (std::size_t i = 0; i < problems.size(); ++i) {
      if (asked.laws) print_laws(asked.files[i], problems[i], asked.sweeps);
      else if (asked.table) print_row(asked.files[i], problems[i]);
      else print(asked, asked.files[i], problems[i]);
    }
  });
}
