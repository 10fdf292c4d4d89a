/// Chapter 18: the matrix of all joints in blocks, its factors and its order.
#include "pushback/engine/direct/joint_matrix.h"

#include <Eigen/Cholesky>

#include "pushback/chapters/13_joints/ball_and_socket.h"
#include "pushback/chapters/13_joints/distance.h"
#include "pushback/chapters/13_joints/hinge.h"
#include "pushback/chapters/13_joints/weld.h"
#include "pushback/chapters/14_joints_under_load/structures.h"
#include "pushback/common/bodies/random.h"
#include "pushback/engine/direct/direct_joints.h"
#include "tests/support/catch.h"
#include "tests/support/yardstick.h"

using namespace pushback;
using namespace pushback::joints_under_load_scenes;

namespace {

void join(World& world, Random& random, int a, int b) {
  const Vec3 at = random.vector(2);
  switch (random.below(4)) {
    case 0:
      world.joints.push_back(ball_and_socket(world, a, b, at));
      break;
    case 1:
      world.joints.push_back(hinge(world, a, b, at, random.direction()));
      break;
    case 2:
      world.joints.push_back(weld(world, a, b, at));
      break;
    default:
      world.joints.push_back(distance(world, a, at, b, at + random.direction()));
      break;
  }
}

void add_body(World& world, Random& random) {
  world.add(box({Real(0.2), Real(0.3), Real(0.4)}, random.over_decades(Real(0.3), 30))
                .oriented(random.orientation())
                .at(random.vector(3)));
}

/// Every body hangs from one that came before it, or from the world; so do some others of its trees once more.
World random_trees(Random& random, int count) {
  World world;
  for (int i = 0; i < count; ++i) {
    add_body(world, random);
    const bool begins_a_tree = i == 0 || random.below(8) == 0;
    if (!begins_a_tree) join(world, random, static_cast<int>(random.below(static_cast<std::size_t>(i))), i);
    if (random.below(6) == 0) join(world, random, the_world, i);
  }
  return world;
}

/// Rows, and the joints that they belong to.
struct Asked {
  JointRows rows;
  std::vector<JointMatrix::JointBodies> joints;
  std::vector<char> taken;

  explicit Asked(World& world) {
    Solver<Joints> solver;
    world.begin_step(h);
    solver.solve(world, h, 0);
    rows = solver.joint_rows();
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const Joint& joint = world.joints[rows[i].owner];
      if (i == 0 || rows[i].owner != rows[i - 1].owner) joints.push_back({joint.a, joint.b, 0});
      ++joints.back().rows;
    }
    taken.assign(rows.size(), true);
  }
  /// From J and M^-1, written out.
  Eigen::MatrixXd dense() const {
    const auto count = static_cast<Eigen::Index>(rows.size());
    Eigen::MatrixXd a = Eigen::MatrixXd::Zero(count, count);
    for (Eigen::Index i = 0; i < count; ++i)
      for (Eigen::Index j = 0; j < count; ++j) {
        const JointRow &r = rows[static_cast<std::size_t>(i)], &s = rows[static_cast<std::size_t>(j)];
        const auto part = [&](const Body* body, Real sign, const Vec3& r_n, const Vec3& dv, const Vec3& dw,
                              const Body* of_s) {
          if (body == of_s && body->movable()) a(i, j) += static_cast<double>(sign * (r.n.dot(dv) + r_n.dot(dw)));
        };
        part(r.a, -1, r.ra_n, s.dva, s.dwa, s.a), part(r.a, -1, r.ra_n, s.dvb, s.dwb, s.b);
        part(r.b, 1, r.rb_n, s.dva, s.dwa, s.a), part(r.b, 1, r.rb_n, s.dvb, s.dwb, s.b);
      }
    return a;
  }
  std::size_t pairs_that_share_a_body() const {
    std::size_t pairs = 0;
    for (std::size_t i = 0; i < joints.size(); ++i)
      for (std::size_t j = 0; j < i; ++j) {
        const auto same = [](int a, int b) { return a != not_moving && a == b; };
        pairs += same(joints[i].a, joints[j].a) || same(joints[i].a, joints[j].b) || same(joints[i].b, joints[j].a) ||
                 same(joints[i].b, joints[j].b);
      }
    return pairs;
  }
};

}  // namespace

TEST_CASE("joint matrix: in trees, L has a block where A has one, and no other") {
  Random random(1);
  for (int i = 0; i < 50; ++i) {
    World world = random_trees(random, 1 + static_cast<int>(random.below(60)));
    const Asked asked(world);
    JointMatrix matrix;
    matrix.factor(asked.rows, asked.joints, asked.taken);
    REQUIRE(matrix.off_diagonal_blocks() == asked.pairs_that_share_a_body());
  }
}

TEST_CASE("joint matrix: solves A x = b, in trees and with loops") {
  Random random(2);
  for (int i = 0; i < 60; ++i) {
    World world = random_trees(random, 2 + static_cast<int>(random.below(25)));
    const auto bodies = world.bodies.size();
    for (std::size_t loops = i % 2 == 0 ? 0 : 1 + random.below(3); loops > 0; --loops) {
      const std::size_t one = random.below(bodies), other = random.below(bodies);
      if (one != other) join(world, random, static_cast<int>(one), static_cast<int>(other));
    }
    const Asked asked(world);
    const Eigen::MatrixXd a = asked.dense();
    JointMatrix matrix;
    matrix.factor(asked.rows, asked.joints, asked.taken);
    if (matrix.solved_rows() < asked.rows.size()) continue;  // more joints than bodies can follow
    Eigen::VectorXd b(a.rows());
    for (Eigen::Index k = 0; k < b.size(); ++k) b[k] = static_cast<double>(random.between(-1, 1));
    std::vector<double> x(b.data(), b.data() + b.size());
    matrix.solve(x);
    const Eigen::VectorXd solution = Eigen::Map<Eigen::VectorXd>(x.data(), b.size());
    INFO(i << ": " << bodies << " bodies");
    REQUIRE((a * solution - b).norm() < (in_double ? 1e-9 : 1e-3) * (1 + a.norm() * solution.norm()));
    REQUIRE((solution - a.ldlt().solve(b)).norm() < (in_double ? 1e-6 : 0.1) * solution.norm());
  }
}

TEST_CASE("joint matrix: a row that is not taken is as if it were not there") {
  Random random(3);
  World world = random_trees(random, 12);
  Asked asked(world);
  const auto count = static_cast<Eigen::Index>(asked.rows.size());
  std::vector<Eigen::Index> there;
  for (Eigen::Index i = 0; i < count; ++i) {
    asked.taken[static_cast<std::size_t>(i)] = random.below(3) != 0;
    if (asked.taken[static_cast<std::size_t>(i)]) there.push_back(i);
  }
  const Eigen::MatrixXd a = asked.dense();
  JointMatrix matrix;
  matrix.factor(asked.rows, asked.joints, asked.taken);
  std::vector<double> x(asked.rows.size(), 1);
  matrix.solve(x);
  const Eigen::VectorXd expected = a(there, there).ldlt().solve(Eigen::VectorXd::Ones(std::ssize(there)));
  for (Eigen::Index i = 0, k = 0; i < count; ++i) {
    const auto place = static_cast<std::size_t>(i);
    if (!asked.taken[place]) CHECK(x[place] == 0);
    else CHECK(x[place] == Approx(expected[k++]).epsilon(in_double ? 1e-7 : 1e-2).margin(in_double ? 1e-9 : 1e-3));
  }
}

TEST_CASE("joint matrix: what is added, taken or joined to another body is analysed anew") {
  Random random(4);
  JointMatrix kept;
  World world = random_trees(random, 10);
  for (int change = 0; change < 30; ++change) {
    const std::size_t what = random.below(3);  // one less, one more, one in the place of another
    if (world.joints.size() > 3 && what != 1)
      world.joints.erase(world.joints.begin() + static_cast<std::ptrdiff_t>(random.below(world.joints.size())));
    if (what != 0) join(world, random, static_cast<int>(random.below(9)), 9);
    const Asked asked(world);
    JointMatrix fresh;
    kept.factor(asked.rows, asked.joints, asked.taken);
    fresh.factor(asked.rows, asked.joints, asked.taken);
    std::vector<double> of_kept(asked.rows.size(), 1), of_fresh(asked.rows.size(), 1);
    kept.solve(of_kept);
    fresh.solve(of_fresh);
    REQUIRE(of_kept == of_fresh);
  }
}
