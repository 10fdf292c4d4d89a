/// What SAP minimises: laws against their conditions, Newton's method against the minimum.
#include "pushback/tools/methods/sap_problem.h"

#include <random>

#include "tests/support/catch.h"

using namespace pushback;

namespace {

using SapVector = SapProblem::Vector;

/// Numbers from -1 to 1, always the same.
class Numbers {
 public:
  explicit Numbers(unsigned seed) : engine_(seed) {}
  double number() { return std::ldexp(static_cast<double>(engine_()), -31) - 1; }
  double positive() { return std::pow(10, number()); }
  template <class Matrix>
  Matrix matrix() {
    return Matrix::NullaryExpr([this] { return number(); });
  }
  SapVector vector(Eigen::Index size) {
    return SapVector::NullaryExpr(size, [this] { return number(); });
  }
  SapContactLaw contact() {
    const double mu = number() < -0.6 ? 0 : positive();
    return {matrix<Eigen::Vector3d>().normalized(), mu, positive(), positive(), number()};
  }

 private:
  std::mt19937 engine_;
};

/// Bodies in a row, each with some contacts and a joint to the next, the first of them to what nothing moves.
SapProblem chain_of(Numbers& numbers, int bodies) {
  SapProblem problem;
  for (int i = 0; i < bodies; ++i) {
    SapProblem::Mat6 mass = numbers.matrix<SapProblem::Mat6>();
    mass = mass * mass.transpose() + SapProblem::Mat6::Identity();
    problem.add(std::pow(numbers.positive(), 2) * mass, numbers.matrix<SapProblem::Vec6>());
    for (int k = 0; k < 4; ++k) {
      using Contact = SapProblem::Contact;
      Contact contact{i,
                      i - 1,
                      numbers.matrix<Contact::Jacobian>(),
                      numbers.matrix<Contact::Jacobian>(),
                      numbers.matrix<Contact::Rows>(),
                      numbers.contact()};
      if (k % 2 == 1) std::swap(contact.a, contact.b);
      if (k == 3) contact.law.lagged = numbers.positive(), contact.law.slow = numbers.positive() / 10;
      problem.contacts.push_back(contact);
    }
    using Row = SapProblem::Row;
    problem.rows.push_back({i - 1,
                            i,
                            numbers.matrix<Row::Jacobian>(),
                            numbers.matrix<Row::Jacobian>(),
                            numbers.matrix<Row::Rows>(),
                            {numbers.positive(), numbers.number(), -0.2, 0.3}});
  }
  return problem;
}

}  // namespace

// The nearest point of a convex cone: gamma in F, R (gamma - y) in F*, and the two perpendicular.
TEST_CASE("sap: a contact's impulse is the nearest in the cone, in each of its three regions") {
  Numbers numbers(1);
  int parts = 0, sticks = 0, slides = 0;
  for (int i = 0; i < 2000; ++i) {
    const SapContactLaw law = numbers.contact();
    const auto u = Eigen::Vector3d(2 * numbers.matrix<Eigen::Vector3d>());
    const Eigen::Vector3d gamma = law.at(u).impulse, y = [&] {
      const double u_n = u.dot(law.n);
      return Eigen::Vector3d((law.wanted - u_n) / law.r_n * law.n - (u - u_n * law.n) / law.r_t);
    }();
    const auto weighed = [&](const Eigen::Vector3d& x) {
      return Eigen::Vector3d(law.r_t * x + (law.r_n - law.r_t) * x.dot(law.n) * law.n);
    };
    const auto parted = [&](const Eigen::Vector3d& x) {
      const double n = x.dot(law.n);
      return std::pair(n, (x - n * law.n).norm());
    };
    const auto [gamma_n, gamma_t] = parted(gamma);
    const Eigen::Vector3d dual = weighed(gamma - y);
    const auto [dual_n, dual_t] = parted(dual);
    const double unit = 1e-12 * (1 + weighed(y).norm()) * (1 + y.norm());
    REQUIRE(gamma_t <= law.mu * gamma_n + unit);
    REQUIRE(dual_n >= law.mu * dual_t - unit);
    REQUIRE(std::abs(gamma.dot(dual)) <= unit);
    REQUIRE(law.at(u).cost == Approx(gamma.dot(weighed(gamma)) / 2).epsilon(1e-12).margin(1e-300));
    const bool is_stuck = law.mu > 0 && (gamma - y).norm() < 1e-12 * y.norm();
    REQUIRE(law.sticks(u) == is_stuck);
    ++(gamma.norm() == 0 ? parts : is_stuck ? sticks : slides);
  }
  CHECK(std::min({parts, sticks, slides}) > 100);
}

TEST_CASE("sap: the gradient is 0 where Newton's method ends, and every start ends in one place") {
  Numbers numbers(5);
  for (int i = 0; i < 20; ++i) {
    SapProblem problem = chain_of(numbers, 8);
    SapVector v = problem.free();
    CHECK(problem.minimise(v, 1e-12, 60) < 30);
    for (Eigen::Index k = 0; k < v.size(); ++k) {
      const SapVector way = 1e-4 * SapVector::Unit(v.size(), k);
      CHECK(problem.cost(v) <= problem.cost(v + way));
      CHECK(problem.cost(v) <= problem.cost(v - way));
    }
    SapVector other = 100 * numbers.vector(48);
    problem.minimise(other, 1e-12, 60);
    CHECK((other - v).norm() < 1e-9 * v.norm());
  }
}
