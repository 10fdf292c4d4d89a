/// Chapter 19: frozen problems, what is traced on them, and performance profiles. Nothing here depends on a clock.
#include <filesystem>
#include <random>
#include <set>

#include "pushback/chapters/16_whole_problem/matrix.h"
#include "pushback/chapters/17_direct_contacts/smoothed_newton.h"
#include "pushback/common/basics/files.h"
#include "pushback/common/basics/shard.h"
#include "pushback/common/world/situations.h"
#include "pushback/tools/frozen/frozen.h"
#include "pushback/tools/frozen/methods.h"
#include "pushback/tools/frozen/pictures.h"
#include "pushback/tools/frozen/words.h"
#include "pushback/tools/shards/origin.h"
#include "tests/support/call.h"
#include "tests/support/catch.h"
#include "tests/support/complaint.h"

using namespace pushback;
using namespace pushback::frozen;

namespace {

/// As far as `sweeps` go, however long that takes.
TraceLimits limited_to(int sweeps) {
  return {.sweeps = sweeps, .seconds = 1e9, .enough = 0, .ladder = {1e-6}, .asked = {1e-6}};
}

const std::vector<FrozenProblem>& ours() {
  static const std::vector<FrozenProblem> problems = own_problems();  // a second's work
  return problems;
}

const FrozenProblem& named(const std::string& name) {
  for (const FrozenProblem& problem : ours())
    if (problem.name == name) return problem;
  throw std::runtime_error("no problem is called " + name);
}

}  // namespace

TEST_CASE("a profile of known costs is the known one") {
  const Costs costs{{1, 2}, {4, 1}, {not_reached, 3}, {not_reached, not_reached}};
  CHECK(part_within(costs, 0, 1) == 0.25);
  CHECK(part_within(costs, 0, 3.99) == 0.25);
  CHECK(part_within(costs, 0, 4) == 0.5);
  CHECK(part_within(costs, 0, 1e300) == 0.5);
  CHECK(part_within(costs, 1, 1) == 0.5);
  CHECK(part_within(costs, 1, 1.99) == 0.5);
  CHECK(part_within(costs, 1, 2) == 0.75);
  CHECK(part_within({}, 0, 2) == 0);
}

TEST_CASE("profiles rise from who is cheapest to what is solved, between 0 and 1") {
  std::mt19937 random(14);
  for (int trial = 0; trial < 50; ++trial) {
    const std::size_t problems = 1 + random() % 30, methods = 1 + random() % 6;
    Costs costs(problems, std::vector<double>(methods));
    std::size_t by_any = 0;
    std::vector<std::size_t> by(methods, 0);
    for (std::vector<double>& of : costs) {
      bool any = false;
      for (std::size_t m = 0; m < methods; ++m) {
        of[m] = random() % 3 == 0 ? not_reached : std::pow(10, static_cast<double>(random() % 7) / 2);
        any = any || of[m] < not_reached;
        by[m] += of[m] < not_reached ? 1 : 0;
      }
      by_any += any ? 1 : 0;
    }
    double cheapest = 0;
    for (std::size_t m = 0; m < methods; ++m) {
      double last = 0;
      for (double tau = 1; tau < 2e4; tau *= 1.2) {
        const double part = part_within(costs, m, tau);
        CHECK(part >= last);
        CHECK(part <= 1);
        last = part;
      }
      CHECK(last == static_cast<double>(by[m]) / static_cast<double>(problems));
      cheapest += part_within(costs, m, 1);
    }
    CHECK(cheapest >= static_cast<double>(by_any) / static_cast<double>(problems) - 1e-12);
  }
}

TEST_CASE("every frozen problem of ours is one, and the small ones can be solved") {
  CHECK(ours().size() >= 15);
  std::set<std::string> names;
  for (const FrozenProblem& frozen : ours()) {
    INFO(frozen.name);
    const ContactProblem& problem = frozen.problem;
    CHECK(names.insert(frozen.name).second);
    CHECK(frozen.name.find(',') == std::string::npos);  // it goes into a table of values separated by commas
    REQUIRE(problem.contacts() > 0);
    CHECK(problem.w.rows() == 3 * problem.contacts());
    CHECK(problem.q.allFinite());
    CHECK(problem.q.norm() > 0);
    CHECK(problem.mu.allFinite());
    CHECK(problem.mu.minCoeff() >= 0);
    CHECK(asymmetry(problem) <= (std::is_same_v<Real, float> ? 1e-5 : 1e-12));
    if (problem.contacts() <= 60) CHECK(solve_best(problem, {.tolerance = 1e-10}).residual <= 1e-10);
  }
}

TEST_CASE("a scene is frozen in the same bits again") {
  const std::vector<FrozenProblem>& one = ours();
  const std::vector<FrozenProblem> two = own_problems();
  REQUIRE(one.size() == two.size());
  for (std::size_t i = 0; i < one.size(); ++i) {
    INFO(one[i].name);
    CHECK(one[i].name == two[i].name);
    CHECK(one[i].problem.q == two[i].problem.q);
    CHECK(one[i].problem.mu == two[i].problem.mu);
    REQUIRE(one[i].problem.w.nonZeros() == two[i].problem.w.nonZeros());
    CHECK(SparseRows(one[i].problem.w - two[i].problem.w).norm() == 0);
  }
}

TEST_CASE("where bodies are known, W is B B^T, and the smoothed method solves between them") {
  for (const FrozenProblem& frozen : ours()) {
    INFO(frozen.name);
    const SparseRows transposed = frozen.factor.transpose(), product = frozen.factor * transposed;
    CHECK(SparseRows(product - frozen.problem.w).norm() <=
          (std::is_same_v<Real, float> ? 1e-5 : 1e-12) * frozen.problem.w.norm());
  }
  const FrozenProblem& frozen = named("pyramid of 5");
  const double from_bodies = Trace(frozen.problem, "smoothed", limited_to(1), frozen.factor).points().back().residual;
  CHECK(from_bodies == solve_smoothed(frozen.problem, {.tolerance = 1e-6}, frozen.factor).residual);
  CHECK(from_bodies != solve_smoothed(frozen.problem, {.tolerance = 1e-6}).residual);  // rounded otherwise
}

TEST_CASE("large problems are studied once, and every method that reaches something is in their table") {
  const FrozenPoints points = read_frozen_csv(study_large({named("pyramid of 5"), named("stack of 5")}, true));
  CHECK(points.problems.size() == 2);
  for (const std::string& method : method_names())
    CHECK(std::count(points.methods.begin(), points.methods.end(), method) == 1);
}

TEST_CASE("a trace ends where the method itself ends, and passes where it passes") {
  for (const char* name : {"small pile after 1 s", "twelve planks sliding", "heavy on light 1:100"}) {
    const ContactProblem& problem = named(name).problem;
    for (const std::string& method : method_names()) {
      INFO(name << ", " << method);
      Trace trace(problem, method, limited_to(137));
      REQUIRE(!trace.points().empty());
      const TracePoint last = trace.points().back();
      if (counts_sweeps(method)) {  // stopped after single sweeps
        CHECK(last.sweeps == 137);
        for (const TracePoint& point : trace.points())
          CHECK(point.residual == solve(problem, method, point.sweeps, 0).residual);
      } else {
        CHECK(last.residual == solve(problem, method, 137, 1e-6).residual);
        CHECK(last.residual <= 1e-6);
      }
      CHECK(trace.row_solves(last) == 3.0 * static_cast<double>(problem.contacts()) * last.sweeps);
    }
  }
}

TEST_CASE("another round changes nothing but adds a time") {
  const ContactProblem& problem = named("arch of 11 stones").problem;
  for (const std::string& method : frozen_methods()) {
    INFO(method);
    Trace trace(problem, method, limited_to(300));
    const std::vector<TracePoint> before = trace.points();
    trace.again();
    REQUIRE(trace.points().size() == before.size());
    for (std::size_t i = 0; i < before.size(); ++i) {
      const TracePoint& point = trace.points()[i];
      CHECK(point.sweeps == before[i].sweeps);
      CHECK(point.systems == before[i].systems);
      CHECK(point.residual == before[i].residual);
      CHECK(before[i].seconds.size() == 1);
      CHECK(point.seconds.size() == 2);
      if (i > 0) CHECK((point.sweeps > before[i - 1].sweeps || point.systems > before[i - 1].systems));
    }
    const TracePoint* hundredth = trace.reaching(1e-2);
    for (const TracePoint& point : trace.points()) {
      if (&point == hundredth) break;
      CHECK(point.residual > 1e-2);
    }
    if (hundredth != nullptr) CHECK(hundredth->residual <= 1e-2);
    CHECK(trace.reaching(0) == nullptr);
  }
}

TEST_CASE("a method of Siconos has a point for each tolerance that it reached, and none where it did not") {
  const ContactProblem& problem = named("twelve planks sliding").problem;
  const ContactProblem& hard = named("heavy on four 1:1000").problem;
  for (const std::string& method : siconos_methods()) {
    INFO(method);
    TraceLimits limits = limited_to(100000);
    limits.ladder = {1e-2, 1e-4, 1e-6};
    const Trace trace(problem, method, limits);
    CHECK(!trace.counts_rows());
    REQUIRE(!trace.points().empty());
    for (std::size_t i = 0; i < trace.points().size(); ++i) CHECK(trace.points()[i].residual <= limits.ladder[i]);
    CHECK(Trace(hard, method, limited_to(1)).reaching(1e-6) == nullptr);  // one iteration does not do
  }
}

TEST_CASE("medians and quartiles of times") {
  const TracePoint point{.seconds = {5, 1, 3, 2, 4}};
  CHECK(point.time() == 3);
  CHECK(point.time(0.25) == 2);
  CHECK(point.time(0.75) == 4);
  CHECK(TracePoint{.seconds = {1, 2}}.time() == 1.5);
  CHECK(TracePoint{.seconds = {7}}.time(0.75) == 7);
}

TEST_CASE("what pgs leaves of a pyramid at rest is impulses in the corners of the friction pyramid, and nothing else") {
  const ContactProblem& problem = named("pyramid of 10").problem;
  const Solution found = solve(problem, "pgs", 10000, 0);
  const Vector u = problem.speeds(found.r);
  CHECK(u.cwiseAbs().maxCoeff() < 1e-8);  // m/s: nothing slides
  int outside = 0;
  double inside_error = 0, all_error = 0, farthest = 0;  // squares of the natural map's error; |r_t| / (mu r_n)
  for (Eigen::Index i = 0; i < problem.contacts(); ++i) {
    const Eigen::Vector3d r = found.r.segment<3>(3 * i), v = u.segment<3>(3 * i);
    const double bound = problem.mu[i] * r[0], tangential = r.tail<2>().norm();
    CHECK(r.tail<2>().cwiseAbs().maxCoeff() <= bound + 1e-9);  // each tangent by itself is as the pyramid allows
    const Eigen::Vector3d lifted(v[0] + problem.mu[i] * v.tail<2>().norm(), v[1], v[2]);
    const double error = (r - projected_to_cone(r - lifted, problem.mu[i])).squaredNorm();
    all_error += error;
    if (tangential > bound + 1e-9) {
      ++outside;
      farthest = std::max(farthest, tangential / bound);
    } else {
      inside_error += error;
    }
  }
  CHECK(outside == 49);  // of 400: the page says so
  CHECK(farthest == Approx(std::sqrt(2.0)));
  CHECK(std::sqrt(all_error) / problem.q.norm() == Approx(0.125).margin(0.001));
  CHECK(std::sqrt(inside_error) / problem.q.norm() < 1e-7);
}

TEST_CASE("the pyramid does not reach what slides askew, and the table says so") {
  const std::vector<std::string> methods = frozen_methods();
  std::vector<Traced> all;
  for (const char* name : {"twelve planks sliding", "small pile after 1 s"}) {
    all.push_back({&named(name), {}});
    for (const std::string& method : methods)
      all.back().traces.emplace_back(all.back().frozen->problem, method, limited_to(400));
  }
  const FrozenPoints points = read_frozen_csv(csv_of(all));
  for (const double tolerance : tolerances) {
    const Costs times = times_to(tolerance, points);
    for (std::size_t m = 0; m < methods.size(); ++m) {
      INFO(methods[m] << " to " << tolerance);
      const bool wrong_law = methods[m] == "pgs" || methods[m] == "scaled-back";
      if (wrong_law) CHECK(times[0][m] == not_reached);
      if (methods[m] == "cone") CHECK(times[0][m] < not_reached);
    }
  }
  CHECK(tables_of(points).size() == tolerances.size());
  CHECK(contains(tables_of(points)[0], "| twelve planks sliding | 48 | - | - |"));
  const std::string reached = reached_of(points);
  CHECK(contains(reached, "Of 2 problems"));
  CHECK(contains(reached, "| scaled-back | 1, "));  // the pile that rests, and not what slides
  for (const std::string& method : methods) CHECK(contains(reached, "| " + method + " | "));
  const std::vector<std::string> csv = lines_of(csv_of(all));
  const auto commas = std::count(csv[0].begin(), csv[0].end(), ',');
  for (const std::string& line : csv) CHECK(std::count(line.begin(), line.end(), ',') == commas);
  for (const Panel& panel : profile_panels(points))
    for (const Curve& curve : panel.curves) CHECK(std::is_sorted(curve.y.begin(), curve.y.end()));
}

TEST_CASE("the committed measurement is drawn: six problems, two diagrams each, and four profiles") {
  const FrozenPoints all = read_frozen_csv(text_of("renders/19_accuracy_and_time/frozen.csv"));
  CHECK(all.problems.size() == 33);
  CHECK(all.methods == std::vector<std::string>{"pgs", "scaled-back", "cone", "nscg", "smoothed", "best",
                                                "Siconos NSGS", "Siconos NSN_AC", "Siconos ADMM"});
  const std::vector<Panel> traces = trace_panels(all);
  REQUIRE(traces.size() == 12);
  for (std::size_t i = 0; i < traces.size(); i += 2) {
    CHECK(traces[i].title == traces[i + 1].title);  // so that they are in one figure
    CHECK(traces[i].curves.size() == all.methods.size());
    for (const Curve& curve : traces[i].curves) CHECK((curve.x.empty() == contains(curve.label, ": not reached")));
    for (const Curve& curve : traces[i + 1].curves)
      CHECK((!contains(curve.label, "Siconos") && curve.label != "smoothed"));
  }
  const std::vector<Panel> profiles = profile_panels(all);
  REQUIRE(profiles.size() == 4);
  // As reached.md has it: nscg is the fastest to 1e-3 on 17 of 33, smoothed to 1e-10 on as many, and best solves all.
  CHECK(profiles[0].curves[3].y.front() == Approx(17.0 / 33).margin(1e-9));
  CHECK(profiles[2].curves[4].y.front() == Approx(17.0 / 33).margin(1e-9));
  CHECK(profiles[2].curves[5].y.back() == 1);
  CHECK(profiles[3].curves.size() == 4);  // those whose work row solves are
}

TEST_CASE("what is no line of points is refused, with the line") {
  const std::string head = std::string(csv_heading) + "\n";
  CHECK(read_frozen_csv(head).problems.empty());
  const FrozenPoints two = read_frozen_csv(head + "a,3,pgs,1,9,0,1e-3,2e-6,1,1\nb,4,cone,2,-,5,1e-4,1,1,1\n");
  REQUIRE(two.problems.size() == 2);
  CHECK((two.problems[0].contacts == 3 && two.problems[0].of_method[0][0].row_solves == 9));
  CHECK((two.problems[1].of_method[0].empty() && !two.problems[1].of_method[1][0].row_solves));
  CHECK(two.problems[1].of_method[1][0].systems == 5);
  CHECK(contains(complaint([] { read_frozen_csv("problem\n"); }), "'problem'"));
  for (const std::string line :
       {"a,3,pgs,1,9,0,1e-3", "a,x,pgs,1,9,0,1e-3,1,1,1", "a,3,,1,9,0,1e-3,1,1,1", "a,3,pgs,one,9,0,1e-3,1,1,1",
        "a,3,pgs,1,nine,0,1e-3,1,1,1", "a,3,pgs,1,,0,1e-3,1,1,1", ""})
    CHECK(contains(complaint([&line] { read_frozen_csv(std::string(csv_heading) + "\n" + line + "\n"); }),
                   "'" + line + "'"));
}

TEST_CASE("a folder of problems that is none is refused by name") {
  const Scratch scratch;
  const fs::path empty = scratch / "no_problems";
  make_writable_folder(empty);
  const std::string missing = complaint([&] { foreign_problems(empty / "nowhere"); });
  CHECK(contains(missing, (empty / "nowhere").string()));
  CHECK(!contains(missing, ".dat"));  // not as if there were a folder, with nothing in it
  CHECK(contains(complaint([&] { foreign_problems(empty); }), empty.string()));
  const Ended ended =
      call_program(FROZEN_PROGRAM, fmt::format("--quick --problems '{0}/nowhere' --out '{0}'", empty.string()));
  CHECK(ended.status == 2);
  CHECK(contains(ended.err, "nowhere"));
  CHECK(fs::is_empty(empty));
  write_text_file(empty / "bad.dat", "3 1 oops");
  CHECK(contains(complaint([&] { foreign_problems(empty); }), "bad.dat"));
}

TEST_CASE("parts of the frozen problems, each solved on a machine of its own, make the whole") {
  const Scratch scratch;
  const fs::path folder = scratch / "19_accuracy_and_time";
  constexpr std::size_t count = 3;
  std::string whole = std::string(csv_heading) + "\n";
  std::vector<std::string> parts(count, whole);
  std::set<std::string> so_far;
  for (const std::string& line : lines_of(text_of("renders/19_accuracy_and_time/frozen.csv"))) {
    const std::string name = fields_of(line)[0];
    if (std::none_of(ours().begin(), ours().end(), [&](const FrozenProblem& of) { return of.name == name; })) continue;
    so_far.insert(name);
    whole += line + "\n";
    parts[(so_far.size() - 1) % count] += line + "\n";
  }
  REQUIRE(so_far.size() == ours().size());
  const auto call = [&](const std::string& what) {
    return call_program(FROZEN_PROGRAM, what + " --out '" + (scratch / "").string() + "'", 100);
  };
  for (std::size_t i = 1; i <= count; ++i) {
    const fs::path part = folder / Shard{i, count}.folder();
    fs::create_directories(part);
    if (i < count) write_text_file(part / "frozen.csv", parts[i - 1]);
    write_text_file(part / "frozen_origin.txt", origin_text({"machine", "compiler", "commit"}));
  }
  const Ended early = call("--join 3");
  CHECK(early.status == 2);
  CHECK(contains(early.err, "shard_3_of_3"));
  write_text_file(folder / "shard_3_of_3/frozen.csv", parts[2]);
  const Ended ended = call("--join 3");
  INFO(ended.err);
  REQUIRE(ended.status == 0);
  CHECK(text_of(folder / "frozen.csv") == whole);
  for (const std::string file : {"frozen.png", "profiles.png"}) CHECK(fs::exists(folder / file));
  std::string said;
  for (const std::string& remark : remarks_of(read_frozen_csv(whole), ours())) said += "- " + remark + "\n";
  CHECK(contains(said, "of 21 problems"));
  CHECK(contains(text_of(folder / "reached.md"), said));
  CHECK(contains(text_of(folder / "frozen.md"), said));

  write_text_file(folder / "shard_2_of_3/frozen_origin.txt", origin_text({"another", "compiler", "commit"}));
  const Ended mixed = call("--join 3");  // times of two machines
  CHECK(mixed.status == 2);
  CHECK(contains(mixed.err, "one machine"));

  REQUIRE(call("--quick --shard 1/21").status == 0);  // that is one problem, and no word on the whole
  const fs::path first = folder / "shard_1_of_21";
  CHECK(read_origin(first / "frozen_origin.txt") == origin_here());
  const FrozenPoints points = read_frozen_csv(text_of(first / "frozen.csv"));
  REQUIRE(points.problems.size() == 1);
  CHECK(points.problems[0].name == ours()[0].name);
  CHECK(!fs::exists(first / "frozen.md"));
  CHECK(contains(call("--shard 1/99").err, "there are 21 problems"));
  CHECK(contains(call("--shard 0/2").err, "--shard is '0/2'"));
}

TEST_CASE("remarks on a problem that is not there are refused, and say what is missing") {
  const FrozenPoints points = read_frozen_csv(std::string(csv_heading) + "\nof others,3,pgs,1,9,0,1e-3,2e-6,1,1\n");
  const std::string said = complaint([&] { remarks_of(points, ours()); });
  CHECK(contains(said, "'of others'"));
  CHECK(contains(said, "--problems"));
}
