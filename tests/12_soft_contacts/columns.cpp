/// A column of boxes on soft contacts is a mast: it buckles at Greenhill's height, and below it sways as boxes on springs do.
#include <Eigen/Eigenvalues>

#include "pushback/chapters/12_soft_contacts/mast.h"
#include "tests/12_soft_contacts/soft_contacts.h"

using namespace pushback;

namespace {

/// What the substeps of a step allow, rad/s, h long each.
Real stiffness_of(int count) {
  return SoftContacts{}.angular_frequency(h / static_cast<Real>(count));
}

/// The smallest w^2 with which n cubes of 1 m on springs sway, 1/s^2; negative: they do not come back.
///
///   x_i = sum_j<i theta_j + theta_i / 2            they do not slide
///   M = sum x x^T + I / m,  K = the springs between neighbours, and what stands above each: all over m
Real square_of_sway(int n, Real w) {
  const Real K_theta = w * w / 8;  // over m; the ground's springs are twice as stiff: 1/K = m / 4
  Eigen::MatrixXd mass = Eigen::MatrixXd::Identity(n, n) / 6, stiffness = Eigen::MatrixXd::Zero(n, n);
  for (int i = 0; i < n; ++i) {
    Eigen::VectorXd x = Eigen::VectorXd::Zero(n);
    x.head(i).setOnes();
    x[i] = 0.5;
    mass += x * x.transpose();
    stiffness(i, i) += static_cast<double>((i == 0 ? 2 : 1) * K_theta - g * (static_cast<Real>(n - 1 - i) + Real(0.5)));
    if (i == 0) continue;
    stiffness(i - 1, i - 1) += static_cast<double>(K_theta);
    stiffness(i, i - 1) -= static_cast<double>(K_theta);
    stiffness(i - 1, i) -= static_cast<double>(K_theta);
  }
  const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> modes(stiffness, mass, Eigen::EigenvaluesOnly);
  return static_cast<Real>(modes.eigenvalues()[0]);
}

/// A column bent by 10 mm, and where the middle of its topmost box is after each step, m.
struct Watched {
  World world;
  std::vector<Real> aside;

  Watched(int boxes, int count, Real damping_ratio, Real seconds, Real until = 100) {
    BentColumn{boxes, stiffness_of(count)}(world);
    Substeps<SoftSolver> solver({}, count);
    solver.damping_ratio = damping_ratio;
    for (Real t = 0; t < seconds && std::abs(top()) < until; t += h) {
      world.step(solver, h);
      aside.push_back(top());
    }
  }
  Real top() const { return world.bodies.back().position.x(); }
  /// The instants when it is upright, s.
  std::vector<Real> upright() const {
    std::vector<Real> at;
    for (std::size_t i = 1; i < aside.size(); ++i)
      if ((aside[i - 1] < 0) != (aside[i] < 0))
        at.push_back(h * (static_cast<Real>(i) + aside[i - 1] / (aside[i - 1] - aside[i])));
    return at;
  }
};

}  // namespace

TEST_CASE("a mast's shape: upright at its foot, no moment at its top, and in balance between") {
  CHECK(std::abs(mast_shape(0).slope) < (in_double ? Real(1e-9) : Real(1e-6)));  // the constant has nine digits
  CHECK(mast_shape(0).aside == 0);
  CHECK(mast_shape(1).aside == Approx(1));
  const Real d = in_double ? Real(1e-4) : Real(0.02);
  for (const Real up : {Real(0.1), Real(0.5), Real(0.9)}) {
    const Real before = mast_shape(up - d).slope, here = mast_shape(up).slope, after = mast_shape(up + d).slope;
    CHECK((after - 2 * here + before) / (d * d) ==
          Approx(-greenhill * (1 - up) * here).epsilon(in_double ? 1e-6 : 0.01));
    CHECK((mast_shape(up + d).aside - mast_shape(up - d).aside) / (2 * d) ==
          Approx(here).epsilon(in_double ? 1e-6 : 0.01));
  }
}

TEST_CASE("of boxes on springs the first column that does not come back is the first above Greenhill's height") {
  for (const int count : {4, 8, 16, 32}) {
    const Real w = stiffness_of(count), law = tallest_column(w);
    int boxes = 2;
    while (square_of_sway(boxes, w) > 0) ++boxes;
    INFO(count << " substeps: " << law << " boxes by the law; " << boxes << " do not come back");
    CHECK(boxes == static_cast<int>(std::ceil(law)));
  }
}

TEST_CASE("a bent column comes back below nine tenths of Greenhill's height, and falls above eleven tenths") {
  // The push-out's damping decides how fast it goes, not where to.
  for (const auto& [count, zeta] : {std::pair{4, Real(1)}, {4, Real(5)}, {4, Real(20)}, {8, Real(5)}, {16, Real(5)}}) {
    const Real law = tallest_column(stiffness_of(count));
    const int lower = static_cast<int>(std::floor(Real(0.9) * law));
    const int higher = static_cast<int>(std::ceil(Real(1.1) * law));
    const Watched stands(lower, count, zeta, 10), falls(higher, count, zeta, 20, 1);
    INFO(count << " substeps, zeta " << zeta << ": " << law << " boxes by the law; the top of " << lower << " is "
               << 1000 * stands.top() << " mm aside after 10 s, that of " << higher << " after "
               << h * static_cast<Real>(falls.aside.size()) << " s " << 1000 * falls.top() << " mm");
    CHECK_FALSE(stands.upright().empty());
    CHECK(std::abs(stands.top()) < Real(0.01));
    CHECK(falls.upright().empty());
    CHECK(falls.top() > 1);
  }
}

TEST_CASE("below that height a column sways as boxes on springs do, slower the higher it is") {
  for (const auto& [count, boxes] :
       {std::pair{4, 10}, {4, 12}, {4, 13}, {8, 16}, {8, 18}, {8, 20}, {16, 26}, {16, 30}}) {
    const Watched column(boxes, count, 5, 10);
    const std::vector<Real> upright = column.upright();
    REQUIRE(upright.size() >= 2);
    const Real measured = pi / (upright[1] - upright[0]),
               wanted = std::sqrt(square_of_sway(boxes, stiffness_of(count)));
    INFO(boxes << " boxes, " << count << " substeps: " << measured << " rad/s, should be " << wanted);
    CHECK(measured == Approx(wanted).epsilon(0.015));
  }
}

TEST_CASE("above it what it is bent by grows as fast as of boxes on springs, and it has the shape of a mast") {
  for (const auto& [count, boxes] : {std::pair{4, 18}, {4, 20}, {8, 29}, {8, 32}, {16, 52}}) {
    const Watched column(boxes, count, 5, 20, Real(0.5));
    const std::size_t last = column.aside.size() - 1, second = static_cast<std::size_t>(std::lround(1 / h));
    REQUIRE(last > 3 * second);
    const Real measured = std::log(column.aside[last] / column.aside[last - second]);
    const Real wanted = std::sqrt(-square_of_sway(boxes, stiffness_of(count)));
    Real off = 0;
    const Real height = static_cast<Real>(boxes), top = mast_shape(1 - Real(0.5) / height).aside;
    for (int i = 0; i < boxes; ++i) {
      const Real should = mast_shape((static_cast<Real>(i) + Real(0.5)) / height).aside * column.top() / top;
      off = std::max(off, std::abs(column.world.bodies[static_cast<std::size_t>(i) + 1].position.x() - should));
    }
    INFO(boxes << " boxes, " << count << " substeps: e-fold " << measured << " times a second, should be " << wanted
               << "; off the mast's shape by " << off / std::abs(column.top()));
    CHECK(measured == Approx(wanted).epsilon(0.06));
    CHECK(off < Real(0.02) * std::abs(column.top()));
  }
}
