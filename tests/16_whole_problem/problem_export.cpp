/// ./course run export and ./course run solve: a step of a scene as a file, and what is said where that cannot be.
#include <fmt/format.h>

#include <fstream>

#include "pushback/chapters/16_whole_problem/problem_file.h"
#include "pushback/chapters/17_direct_contacts/methods.h"
#include "pushback/common/basics/input.h"
#include "pushback/common/world/situations.h"
#include "pushback/engine/direct/row_matrix.h"
#include "tests/support/call.h"
#include "tests/support/catch.h"

using namespace pushback;

namespace {

std::string in_quotes(const fs::path& file) {
  return fmt::format("'{}'", file.string());
}

}  // namespace

TEST_CASE("steps that go before it change it, and what comes out is solved, and in the same bits again") {
  const Scratch scratch;
  std::string before;
  for (const std::string& scene :
       std::vector<std::string>{"06-slope", "07-ten-boxes", "14-bridge", "11-heavy", "16-gate"}) {
    const fs::path file = scratch / "one.dat", other = scratch / "other.dat";
    INFO(scene);
    const Ended ended = call_program(EXPORT_PROGRAM, scene + " --step 60 " + in_quotes(file));
    REQUIRE(ended.status == 0);
    REQUIRE(call_program(EXPORT_PROGRAM, scene + " --step 60 " + in_quotes(other)).status == 0);
    CHECK(text_of(file) == text_of(other));
    REQUIRE(call_program(EXPORT_PROGRAM, scene + " --step 59 " + in_quotes(other)).status == 0);
    CHECK(text_of(file) != text_of(other));
    CHECK(contains(ended.out, "joints are not in it") == (scene == "14-bridge"));
    const Solution found = solve_best(read_problem_file(file));
    INFO(found.residual);
    CHECK(found.residual < 1e-10);
  }
}

TEST_CASE("what cannot be written is refused, and nothing is left behind") {
  const Scratch scratch;
  const auto refused = [&](const std::string& arguments, const std::string& said) {
    const Ended ended = call_program(EXPORT_PROGRAM, arguments);
    INFO(arguments << ": " << ended.out << ended.err);
    CHECK(ended.status == 2);
    CHECK(contains(ended.err, said));
  };
  const std::string file = in_quotes(scratch / "a.dat");
  refused("", "scene is required");
  refused("07-pyramid", "file is required");
  refused("07-pyramd " + file, "scene is '07-pyramd': one of these is needed: 00-one-hit, ");
  refused(file + " 07-pyramid", "scene is '");
  refused("07-pyramid --step -1 " + file, "--step: '-1' is not allowed: a whole number from 0 to 1000000 is needed");
  refused("07-pyramid --step 1.5 " + file, "--step");
  refused("07-pyramid --step many " + file, "--step");
  refused("13-beads --step 3 " + file, "13-beads has no contacts after 3 steps");
  refused("07-pyramid " + in_quotes(scratch / "no" / "a.dat"), "cannot be written");
  refused("07-pyramid " + in_quotes(scratch / ""), "' cannot be written: it is a folder");
  refused("07-pyramid --step 1000000 " + in_quotes(scratch / "no" / "a.dat"), "cannot be written");  // at once
  CHECK(!fs::exists(scratch / "a.dat"));
  CHECK(!fs::exists(scratch / "a.dat.part"));
  const Ended help = call_program(EXPORT_PROGRAM, "--help");
  CHECK(help.status == 0);
  CHECK(contains(help.out, "--step"));
  CHECK(contains(help.out, "20-ice"));
}

TEST_CASE("solve writes r and u, so that another program can check them") {
  const Scratch scratch;
  const fs::path problem_file = scratch / "a.dat", solution_file = scratch / "a.txt";
  REQUIRE(call_program(EXPORT_PROGRAM, "07-ten-boxes " + in_quotes(problem_file)).status == 0);
  const std::string file = in_quotes(problem_file), write = " --write " + in_quotes(solution_file);
  for (const std::string& method : method_names()) {
    INFO(method);
    REQUIRE(call_program(SOLVE_PROGRAM, file + " --sweeps 30 --method " + method + write).status == 0);
    const ContactProblem problem = read_problem_file(problem_file);
    std::ifstream in(solution_file);
    Eigen::Index contacts = 0;
    in >> contacts;
    REQUIRE(contacts == problem.contacts());
    Vector r(3 * contacts), u(3 * contacts);
    for (Eigen::Index i = 0; i < 3 * contacts; i += 3)
      in >> r[i] >> r[i + 1] >> r[i + 2] >> u[i] >> u[i + 1] >> u[i + 2];
    REQUIRE(in);
    std::string more;
    CHECK(!(in >> more));
    const Solution known = solve(problem, method, 30, 1e-13);
    CHECK(r == known.r);
    CHECK(u == problem.speeds(r));
    CHECK(relative_residual(problem, r) == known.residual);
  }
}
