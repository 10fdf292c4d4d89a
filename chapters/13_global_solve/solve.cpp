/// ./course solve: contact problems from files, by any of the methods; or a table of all.
#include <chrono>

#include "chapters/13_global_solve/methods.h"
#include "chapters/13_global_solve/problem_file.h"
#include "common/program.h"

using namespace pushback;

namespace {

struct Asked {
  std::vector<std::string> files;
  std::string method = "best";
  int sweeps = 1000;
  double tolerance = 1e-13;
  bool table = false;
};

void print(const Asked& asked, const std::string& file, const ContactProblem& problem) {
  const auto begin = std::chrono::steady_clock::now();
  const Solution found = solve(problem, asked.method, asked.sweeps, asked.tolerance);
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  if (!std::isfinite(found.residual))
    throw std::runtime_error(
        fmt::format("{}: {} has left the range of numbers after {} sweeps; another method is needed", file,
                    asked.method, found.sweeps));
  fmt::print("{}: {} contacts, W symmetric to {:.0e}\n", file, problem.contacts(), asymmetry(problem));
  fmt::print("{}: {} sweeps, {} linear systems\n", asked.method, found.sweeps, found.systems);
  fmt::print("time {:.2f} s\nresidual {:.1e}\n", seconds, found.residual);
}

/// The residual of each method after 10, 100, 1000 sweeps, and of the best.
void print_row(const std::string& file, const ContactProblem& problem) {
  std::string row = fmt::format("| {} | {} ", std::filesystem::path(file).stem().string(), problem.contacts());
  for (const std::string& method : method_names()) {
    if (method == "best") row += fmt::format("| {:.0e} ", solve(problem, method, 0, 1e-13).residual);
    else
      for (const int sweeps : {10, 100, 1000})
        row += fmt::format("{} {:.0e} ", sweeps == 10 ? "|" : "/", solve(problem, method, sweeps, 0).residual);
  }
  fmt::print("{}|\n", row);
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"Contact problems in the format of Siconos: how well a method solves them."};
  Asked asked;
  app.add_option("file", asked.files, "Files of contact problems")->required();
  app.add_option("--method", asked.method, "How")->check(CLI::IsMember(method_names()))->capture_default_str();
  app.add_option("--sweeps", asked.sweeps, "At most; best takes what it needs")
      ->check(CLI::Range(0, 100000000))
      ->capture_default_str();
  app.add_option("--tolerance", asked.tolerance, "The relative residual that is good enough")
      ->check(CLI::Range(0.0, 1e6))
      ->capture_default_str();
  app.add_flag("--table", asked.table, "A row a file: all methods after 10 / 100 / 1000 sweeps, and best");
  return run_program(app, argc, argv, [&] {
    std::vector<ContactProblem> problems;  // all read before anything is solved
    for (const std::string& file : asked.files) problems.push_back(read_problem_file(file));
    if (asked.table)
      fmt::print("| problem | contacts | {} |\n|{}\n", fmt::join(method_names(), " | "),
                 " --- | --- | --- | --- | --- | --- | --- |");
    for (std::size_t i = 0; i < problems.size(); ++i) {
      if (asked.table) print_row(asked.files[i], problems[i]);
      else print(asked, asked.files[i], problems[i]);
    }
  });
}
