#include <Eigen/Cholesky>

#include "pushback/chapters/13_joints/ball_and_socket.h"
#include "pushback/chapters/13_joints/joints.h"
#include "pushback/chapters/18_direct_joints/exercise/asked.h"
#include "pushback/engine/direct/row_matrix.h"

namespace pushback::exercise_18 {

namespace {

using Eigen::Index;

/// Joints whose rows are eliminated by the answer.
struct Eliminated : Joints {
  Answer answer{};

  void sweep(StepContext&) {
    const Eigen::MatrixXd a = matrix_of(Rows(joint_rows().begin(), joint_rows().end()));
    Blocks own, next;
    Threes wanted;
    for (std::size_t i = 0; i < joint_rows().size(); i += 3) {
      const Index at = static_cast<Index>(i);
      own.push_back(a.block<3, 3>(at, at));
      if (at > 0) next.push_back(a.block<3, 3>(at - 3, at));
      const auto error = [&](std::size_t row) { return static_cast<double>(joint_rows()[row].speed_error()); };
      wanted.emplace_back(-error(i), -error(i + 1), -error(i + 2));
    }
    const Threes impulses = answer.solve(own, next, wanted);
    for (std::size_t i = 0; i < joint_rows().size(); ++i)
      joint_rows_[i].reach(static_cast<Real>(impulses.at(i / 3)[static_cast<Index>(i % 3)]));
  }
};

/// Balls that hang from the origin, each on a pin at its top.
struct Chain {
  World world;
  Vec3 end = Vec3::Zero();

  /// `aside`, m: the distance of its centre from the place that its pins give.
  void hang(Real mass, Real length, const Vec3& aside = Vec3::Zero(), const Vec3& velocity = Vec3::Zero()) {
    const Vec3 centre = end - length / 2 * Vec3::UnitY() + aside;
    const int here = world.add(sphere(length / 4, mass).at(centre).moving(velocity));
    world.joints.push_back(ball_and_socket(world, here == 0 ? the_world : here - 1, here, end));
    end.y() -= length;
  }
  void hang_crooked(Random& random) {
    const Real length = random.between(Real(0.3), Real(0.6));
    const Vec3 aside = Real(0.3) * random.direction();
    const Vec3 velocity = 2 * random.direction();
    hang(random.between(1, 4), length, aside, velocity);
  }
  /// After gravity of a step.
  std::vector<Reading> solved(const Answer& answer) {
    constexpr Real h = Real(1) / 60;
    for (Body& body : world.bodies) integrate_velocity(body, world.gravity, h);
    Solver<Eliminated> solver;
    solver.answer = answer;
    solver.solve(world, h, 1);
    const JointRows& rows = solver.joint_rows();
    Real apart = 0;
    for (const JointRow& row : rows) apart = std::max(apart, std::abs(row.speed_error()));
    return {{"the force on your hook is", Vec3(rows[0].impulse, rows[1].impulse, rows[2].impulse).norm(), "N s", 1e-5},
            {"the remaining separation speed of your joints is", apart, "m/s"}};
  }
};

/// All at once: any matrix.
Threes right(Blocks own, const Blocks& next, Threes wanted) {
  Eigen::MatrixXd a = Eigen::MatrixXd::Zero(3 * std::ssize(own), 3 * std::ssize(own));
  Vector b(a.rows());
  for (std::size_t i = 0; i < own.size(); ++i) {
    const Index at = 3 * static_cast<Index>(i);
    a.block<3, 3>(at, at) = own[i];
    b.segment<3>(at) = wanted[i];
    if (i == next.size()) break;
    a.block<3, 3>(at, at + 3) = next[i];
    a.block<3, 3>(at + 3, at) = next[i].transpose();
  }
  const Vector impulses = a.ldlt().solve(b);
  for (std::size_t i = 0; i < own.size(); ++i) wanted[i] = impulses.segment<3>(3 * static_cast<Index>(i));
  return wanted;
}

}  // namespace

std::vector<Check<Answer>> checks_of(const Answer& /*any*/) {
  return {
      {"the hook carries the weight of all links", 1,
       [](Random& random, const Answer& answer) -> std::vector<Reading> {
         Chain chain;
         for (std::size_t left = 3 + random.below(4); left > 0; --left) {
           const Real mass = random.between(1, 4);
           chain.hang(mass, random.between(Real(0.3), Real(0.6)));
         }
         return chain.solved(answer);
       },
       "each joint passes on the load below it, so the hook carries all links. From the free end up, eliminate each "
       "joint's block and target speed from the joint above."},
      {"a crooked chain stays together when it is released", 2,
       [](Random& random, const Answer& answer) -> std::vector<Reading> {
         Chain chain;
         for (std::size_t left = 4 + random.below(5); left > 0; --left) chain.hang_crooked(random);
         return chain.solved(answer);
       },
       "next[i] couples joint i + 1 to joint i, and its transpose couples joint i to joint i + 1. In a crooked chain "
       "the two differ, both on the way up and on the way back."},
      {"a long chain carries a thousandfold load", 1,
       [](Random& random, const Answer& answer) -> std::vector<Reading> {
         Chain chain;
         for (std::size_t left = 15 + random.below(10); left > 0; --left) chain.hang_crooked(random);
         chain.hang(random.between(1000, 2000), 1);
         return chain.solved(answer);
       },
       "the load at the free end reaches the hook only if you eliminate each joint with its updated block and target "
       "speed, after the elimination of the joints below."},
  };
}

Exercise exercise() {
  return rebuild_of("the elimination of a chain",
                    {"Row i of A λ = wanted is next[i-1]ᵀ λ_i-1 + own[i] λ_i + next[i] λ_i+1 = wanted[i]. At the free "
                     "end there is no λ_i+1, so solve for λ_i and substitute it into row i - 1.",
                     "This changes only row i - 1. Subtract next[i-1] own[i]⁻¹ next[i-1]ᵀ from own[i-1] and next[i-1] "
                     "own[i]⁻¹ wanted[i] from wanted[i-1]. Continue with i - 1, down to 1.",
                     "Now the hook's row contains only λ_0. Solve it, and then each next joint: own[i] λ_i = wanted[i] "
                     "- next[i-1]ᵀ λ_i-1."},
                    Answer{right});
}

}  // namespace pushback::exercise_18
