/// Chapter 16: contact problems, their files, and what sweeps do to them; `best` of chapter 17 where all methods are asked.
#include <random>

#include "pushback/chapters/06_friction/friction.h"
#include "pushback/chapters/16_whole_problem/iterated.h"
#include "pushback/chapters/16_whole_problem/problem_file.h"
#include "pushback/chapters/16_whole_problem/study.h"
#include "pushback/chapters/17_direct_contacts/methods.h"
#include "tests/support/call.h"
#include "tests/support/catch.h"
#include "tests/support/complaint.h"
#include "tests/support/frame.h"

using namespace pushback;
using namespace pushback::whole_problem_scenes;

namespace {

using Eigen::Index;

Rows normals_of(World& world) {
  Rows rows;
  for (std::size_t i = 0; i < world.contacts.size(); ++i)
    rows.emplace_back(world, world.contacts[i], world.contacts[i].normal, i);
  return rows;
}

/// One contact with the given block, so that the answer can be said.
ContactProblem one_contact(const Eigen::Matrix3d& block, const Eigen::Vector3d& q, double mu) {
  ContactProblem problem;
  problem.w = SparseMatrix(block.sparseView(0, 0));
  problem.q = q;
  problem.mu = Vector::Constant(1, mu);
  return problem;
}

const char* const small_file = "3\n1\n0\n3\n3\n3 3\n 15 -1 -2\n -1 14 1\n -2 1 16\n -1 2 3\n 0.1\n";

std::string with(std::string text, const std::string& part, const std::string& instead) {
  const std::size_t at = text.find(part);
  REQUIRE(at != std::string::npos);
  return text.replace(at, part.size(), instead);
}

}  // namespace

TEST_CASE("sequential impulses are projected Gauss-Seidel on the matrix of all rows, row by row") {
  const auto fill = GENERATE(0, 1);
  Frame frame([&](World& world) {
    if (fill == 0) stack(world, 6);
    else pyramid(world, 5);
    for (Body& body : world.bodies)
      if (body.movable()) body.velocity += Vec3(Real(0.3), 0, Real(0.1));
  });
  Contacts& contacts = frame.world.contacts;
  // The rows as the solver makes them, before it moves anything.
  Rows rows = normals_of(frame.world);
  for (Row& row : rows) row.lo = 0;
  Friction friction;
  StepContext step{frame.world, contacts, rows, h};
  friction.build(step);
  const SparseMatrix a = matrix_of(rows);
  const Vector b = speeds_of(rows);
  Vector impulses = Vector::Zero(b.size());
  const Index normals = std::ssize(contacts);
  for (int sweep = 0; sweep < 20; ++sweep) {
    for (Index i = 0; i < normals; ++i) project_row(a, b, i, 0, 1e300, impulses);
    for (Index i = normals; i < b.size(); ++i) {
      const std::size_t contact = rows[static_cast<std::size_t>(i)].owner;
      const double bound = static_cast<double>(contacts[contact].friction) * impulses[static_cast<Index>(contact)];
      project_row(a, b, i, -bound, bound, impulses);
    }
  }
  Solver<Clamping, Friction> solver;
  solver.solve(frame.world, h, 20);
  double largest = 0, apart = 0;
  for (std::size_t i = 0; i < solver.rows().size(); ++i) {
    largest = std::max(largest, std::abs(impulses[static_cast<Index>(i)]));
    apart = std::max(apart, std::abs(impulses[static_cast<Index>(i)] - static_cast<double>(solver.rows()[i].impulse)));
  }
  INFO("apart by " << apart << " of " << largest);
  CHECK(largest > 1);
  CHECK(apart <= 200 * static_cast<double>(std::numeric_limits<Real>::epsilon()) * largest);
}

TEST_CASE("one contact that sticks, slides and parts, in closed form") {
  const Eigen::Matrix3d w = Eigen::Vector3d(2, 4, 4).asDiagonal();
  struct Case {
    Eigen::Vector3d q, r;
  };
  const double mu = 0.5;
  for (const Case& c : {Case{{-4, 1, 0}, {2, -0.25, 0}}, Case{{-4, 10, 0}, {2, -1, 0}}, Case{{3, 1, 1}, {0, 0, 0}}}) {
    const ContactProblem problem = one_contact(w, c.q, mu);
    CHECK(relative_residual(problem, c.r) < 1e-15);
    for (const std::string& method : method_names()) {
      const Solution found = solve(problem, method, 100, 1e-14);
      INFO(method);
      CHECK((found.r - c.r).norm() < 1e-12);
      CHECK(found.residual < 1e-13);
    }
  }
}

TEST_CASE("a contact that pressed, and is opened by another") {
  ContactProblem problem;
  Eigen::MatrixXd w = Eigen::MatrixXd::Identity(6, 6);
  w(0, 3) = w(3, 0) = 0.9;
  problem.w = SparseMatrix(w.sparseView(0, 0));
  problem.q = Vector::Zero(6);
  problem.q[0] = -1;
  problem.q[3] = -10;  // 10 N s there open the first contact with 8 m/s
  problem.mu = Vector::Constant(2, 0.5);
  for (const std::string& method : method_names()) {
    INFO(method);
    const Solution found = solve(problem, method, 1000, 1e-15);
    CHECK((found.r - 10 * Vector::Unit(6, 3)).norm() < 1e-12);
  }
}

TEST_CASE("the relative residual is the natural map's error, of the length of q") {
  const ContactProblem problem = one_contact(Eigen::Vector3d(2, 4, 4).asDiagonal(), {-4, 1, 0}, 0.5);
  // r = 0, s = (-4 + 0.5, 1, 0), and -s is in the cone.
  CHECK(relative_residual(problem, Vector::Zero(3)) == Approx(std::sqrt((3.5 * 3.5 + 1) / 17)));
}

TEST_CASE("the problem of a solver's rows has their biases, and friction only where there are tangents") {
  Frame frame([](World& world) { stack(world, 2); });
  const Contacts& contacts = frame.world.contacts;
  Rows rows = normals_of(frame.world);
  for (std::size_t i = 0; i < rows.size(); ++i) rows[i].bias = static_cast<Real>(i);
  const Tangents tangents = tangents_of(contacts[3].normal);
  for (const Vec3& tangent : {tangents.tangent1, tangents.tangent2})
    rows.emplace_back(frame.world, contacts[3], tangent, 3);
  const ContactProblem whole = problem_of(frame.world), problem = problem_of(contacts, rows);
  CHECK(Eigen::MatrixXd(problem.w) == Eigen::MatrixXd(whole.w));
  for (Index c = 0; c < problem.contacts(); ++c) {
    const Contact& contact = contacts[static_cast<std::size_t>(c)];
    CHECK(problem.q[3 * c] == Approx(whole.q[3 * c] + double(c)));
    CHECK(whole.mu[c] == static_cast<double>(contact.friction));
    CHECK(problem.mu[c] == (c == 3 ? whole.mu[c] : 0));
  }
}

TEST_CASE("conjugate gradients come further in the same sweeps, for the same law") {
  Frame frame([](World& world) { stack(world, 20); });
  const ContactProblem problem = problem_of(frame.world);
  const double plain = solve(problem, "cone", 1000, 0).residual, conjugate = solve(problem, "nscg", 1000, 0).residual;
  INFO(plain << " against " << conjugate);
  CHECK(3 * conjugate < plain);
  const Solution enough = solve(problem, "cone", 1000, 2 * plain);  // looked at after every tenth
  CHECK(enough.sweeps < 1000);
  CHECK(enough.sweeps % 10 == 0);
  CHECK(enough.residual <= 2 * plain);
}

TEST_CASE("a method that does not sweep is refused by name, with those that do") {
  const ContactProblem problem = one_contact(Eigen::Matrix3d::Identity(), {-1, 0, 0}, 0);
  const std::string said = complaint([&] { solve_by_sweeps(problem, "best", 1, 0); });
  CHECK(contains(said, "is 'best': one of these is needed: pgs, scaled-back, cone, nscg"));
}

TEST_CASE("sweeps give each body its g h back, and corrections and closing speeds fall with what is still wrong") {
  for (const bool stacked : {true, false}) {
    const Snapshot at_rest([=](World& world) { stacked ? stack(world, 4) : pyramid(world, 4); }, h);
    const Signs found = signs(at_rest, 2000);
    REQUIRE(found.error.size() == 2000);
    CHECK(found.error.front() > 0.3);
    CHECK(found.error.back() < (in_double ? 1e-9 : 1e-4));
    CHECK(found.speed.back() < (in_double ? 1e-9 : 1e-4));
    CHECK(found.correction.back() < (in_double ? 1e-9 : 1e-4));
  }
}

TEST_CASE("a problem comes back from its file in the same bits") {
  Frame frame([](World& world) { pyramid(world, 4); });
  const ContactProblem problem = problem_of(frame.world), read = read_problem(problem_text(problem));
  CHECK(Eigen::MatrixXd(problem.w) == Eigen::MatrixXd(read.w));
  CHECK(problem.q == read.q);
  CHECK(problem.mu == read.mu);
}

TEST_CASE("what is wrong with a file is said") {
  const auto said = [](const std::string& text) { return complaint([&] { read_problem(text); }); };
  CHECK(said(small_file).empty());
  CHECK(said(std::string(small_file) + "0\n").empty());          // some have a flag
  CHECK(said(std::string(small_file) + "1\n 1 2 3\n").empty());  // and a first guess
  CHECK(contains(said(""), "ends where dimension"));
  CHECK(contains(said(with(small_file, "3\n1", "2\n1")), "dimension is '2': 3 is needed"));
  CHECK(contains(said(with(small_file, "3\n1", "3\n0")), "number of contacts is '0'"));
  CHECK(contains(said(with(small_file, "3\n1", "3\n-1")), "number of contacts is '-1'"));
  CHECK(contains(said(with(small_file, "3\n1", "3\n1.5")), "number of contacts is '1.5'"));
  CHECK(contains(said(with(small_file, "3\n1", "3\n99999999999999999999")), "number of contacts"));
  CHECK(contains(said(with(small_file, "3\n1\n0\n3\n3\n3 3", "3\n900000\n0\n2700000\n2700000\n2700000 2700000")),
                 "W: 7290000000000 numbers are needed"));
  CHECK(contains(said(with(small_file, "1\n0", "1\n7")), "storage is '7'"));
  CHECK(contains(said(with(small_file, "3\n3\n3 3", "3\n6\n3 3")), "number of columns is '6'"));
  CHECK(contains(said(with(small_file, "14", "nan")), "W(1, 1) is 'nan'"));
  CHECK(contains(said(with(small_file, "14", "inf")), "W(1, 1) is 'inf'"));
  CHECK(contains(said(with(small_file, "14", "1e300")), "W(1, 1) is '1e300'"));
  CHECK(contains(said(with(small_file, "14", "-14")), "W(1, 1) is -14"));
  CHECK(contains(said(with(small_file, "14", "1x4")), "W(1, 1) is '1x4'"));
  CHECK(contains(said(with(small_file, "-1 2 3", "-1 2 oops")), "q(2) is 'oops'"));
  CHECK(contains(said(with(small_file, " 0.1", " -0.1")), "mu(0) is -0.1"));
  CHECK(contains(said(with(small_file, " 0.1", "")), "mu"));
  CHECK(contains(said(std::string(small_file) + "0.3\n"), "what follows the last mu is '0.3'"));
}

TEST_CASE("a file cut short anywhere, or with a word spoilt, is refused or read, never worse") {
  Frame frame([](World& world) { stack(world, 2); });
  const std::string text = problem_text(problem_of(frame.world));
  const std::size_t whole = text.find_last_not_of(" \n") + 1;
  for (std::size_t length = 0; length + 3 < whole; length += 7)
    CHECK(!complaint([&] { read_problem(text.substr(0, length)); }).empty());
  std::mt19937 random(3);
  for (int i = 0; i < 3000; ++i) {
    std::string spoilt = text;
    for (int k = 0; k < 3; ++k) spoilt[random() % spoilt.size()] = "0123456789-.e \nx"[random() % 16];
    complaint([&] { read_problem(spoilt); });
  }
}
