#include <Eigen/SparseCholesky>

#include "pushback/chapters/13_joints/ball_and_socket.h"
#include "pushback/chapters/13_joints/joints.h"
#include "pushback/chapters/16_whole_problem/matrix.h"
#include "pushback/chapters/18_direct_joints/exercise/asked.h"
#include "pushback/common/exercise/shown.h"

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

  /// `aside`, m: so far is its centre from where its pins would have it.
  void hang(Real mass, Real length, const Vec3& aside = Vec3::Zero(), const Vec3& velocity = Vec3::Zero()) {
    const Vec3 centre = end - length / 2 * Vec3::UnitY() + aside;
    const int here = world.add(sphere(length / 4, mass).at(centre).moving(velocity));
    world.joints.push_back(ball_and_socket(world, here == 0 ? the_world : here - 1, here, end));
    world.joints.back().line = [socket = point_on(world.body(here), end)](const Body& a, const Body& b) {
      return std::vector<Vec3>{a.position, point_of(b, socket), b.position};
    };
    end.y() -= length;
  }
  void hang_crooked(Random& random) {
    const Real length = random.between(Real(0.3), Real(0.6));
    const Vec3 aside = Real(0.3) * random.direction();
    hang(random.between(1, 4), length, aside, 2 * random.direction());
  }
  /// After gravity of a step: the sizes of the first and of the last joint's impulse, N s, and the largest speed with which
  /// a joint still comes apart, m/s.
  Numbers solved(const Answer& answer) {
    constexpr Real h = Real(1) / 60;
    for (Body& body : world.bodies) integrate_velocity(body, world.gravity, h);
    Solver<Eliminated> solver;
    solver.answer = answer;
    solver.solve(world, h, 1);
    show(world);
    const JointRows& rows = solver.joint_rows();
    const auto size = [&rows](std::size_t i) {
      return Vec3(rows[i].impulse, rows[i + 1].impulse, rows[i + 2].impulse).norm();
    };
    Real apart = 0;
    for (const JointRow& row : rows) apart = std::max(apart, std::abs(row.speed_error()));
    return {size(0), size(rows.size() - 3), apart};
  }
};

std::vector<Check<Answer>> checks() {
  const std::vector<Quantity> quantities{{"your hook bears", "N s", 1e-5},
                                         {"the joint at the free end of your chain bears", "N s", 1e-5},
                                         {"your joints still come apart with", "m/s", 1e-6}};
  return {
      {"the hook bears what all links weigh", 1, quantities,
       [](Random& random, const Answer& answer) -> Numbers {
         Chain chain;
         for (std::size_t left = 3 + random.below(4); left > 0; --left) {
           const Real mass = random.between(1, 4);
           chain.hang(mass, random.between(Real(0.3), Real(0.6)));
         }
         return chain.solved(answer);
       }},
      {"a crooked chain that is let go stays together", 2, quantities,
       [](Random& random, const Answer& answer) -> Numbers {
         Chain chain;
         for (std::size_t left = 4 + random.below(5); left > 0; --left) chain.hang_crooked(random);
         return chain.solved(answer);
       }},
      {"a long chain bears a thousandfold load", 1, quantities,
       [](Random& random, const Answer& answer) -> Numbers {
         Chain chain;
         for (std::size_t left = 15 + random.below(10); left > 0; --left) chain.hang_crooked(random);
         chain.hang(random.between(1000, 2000), 1);
         return chain.solved(answer);
       }},
  };
}

/// As DirectJoints has it: any matrix, in an order that is found.
Threes right(Blocks own, const Blocks& next, Threes wanted) {
  const Index rows = 3 * std::ssize(own);
  Eigen::MatrixXd a = Eigen::MatrixXd::Zero(rows, rows);
  Vector b(rows);
  for (Index i = 0; i < std::ssize(own); ++i) {
    const auto block = static_cast<std::size_t>(i);
    a.block<3, 3>(3 * i, 3 * i) = own[block];
    b.segment<3>(3 * i) = wanted[block];
    if (block == next.size()) break;
    a.block<3, 3>(3 * i, 3 * i + 3) = next[block];
    a.block<3, 3>(3 * i + 3, 3 * i) = next[block].transpose();
  }
  const Eigen::SparseMatrix<double> sparse = a.sparseView();
  const Vector impulses = Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>>(sparse).solve(b);
  for (Index i = 0; i < std::ssize(own); ++i) wanted[static_cast<std::size_t>(i)] = impulses.segment<3>(3 * i);
  return wanted;
}

/// An elimination, and what may be wrong with it.
struct Slip {
  bool transposed_back = true;           // in the substitution
  int block = -1, side = -1, back = -1;  // the signs; 0: left out
  bool transposed = true, old_block = false, old_side = false, free_end = true;
};

template <Slip slip>
Threes eliminated(Blocks own, const Blocks& next, Threes wanted) {
  const Blocks old_own = own;
  const Threes old_wanted = wanted;
  for (std::size_t i = own.size() - (slip.free_end ? 1 : 2); i > 0; --i) {
    const Eigen::Matrix3d part = next[i - 1] * (slip.old_block ? old_own : own)[i].inverse();
    const Eigen::Matrix3d back = slip.transposed ? Eigen::Matrix3d(next[i - 1].transpose()) : next[i - 1];
    own[i - 1] += slip.block * part * back;
    wanted[i - 1] += slip.side * part * (slip.old_side ? old_wanted : wanted)[i];
  }
  Threes impulses;
  for (std::size_t i = 0; i < own.size(); ++i) {
    Eigen::Vector3d side = wanted[i];
    if (i > 0) {
      const bool turned = slip.transposed && slip.transposed_back;
      const Eigen::Matrix3d back = turned ? Eigen::Matrix3d(next[i - 1].transpose()) : next[i - 1];
      side += slip.back * back * impulses[i - 1];
    }
    impulses.push_back(own[i].inverse() * side);
  }
  return impulses;
}

std::vector<Mistake<Answer>> mistakes() {
  const std::string sign =
      "it looks as if the elimination had the wrong sign. A joint that holds up what is below it is harder to move, so "
      "its A_ii (1/kg) becomes less: what is eliminated is taken away from it, and from what is wanted.";
  return {
      {"transpose forgotten",
       "it looks as if a block stood where its transpose belongs. next[i] says what joint i + 1 does to joint i; the "
       "other way it is next[i].transpose(). In a straight chain the two are equal, in a crooked one not.",
       {eliminated<Slip{.transposed = false}>}},
      {"transpose forgotten",
       "it looks as if next[i - 1] stood in the substitution, where its transpose belongs. next[i] says what joint i + "
       "1 does to joint i; the other way it is next[i].transpose().",
       {eliminated<Slip{.transposed_back = false}>}},
      {"sign of the elimination", sign, {eliminated<Slip{.block = 1}>}},
      {"sign of the elimination", sign, {eliminated<Slip{.side = 1}>}},
      {"sign of the elimination", sign, {eliminated<Slip{.block = 1, .side = 1}>}},
      {"sign of the substitution",
       "it looks as if the substitution had the wrong sign. What the joint above does to this one is done already: "
       "take it away from what is wanted.",
       {eliminated<Slip{.back = 1}>}},
      {"what is wanted not eliminated",
       "it looks as if only blocks were eliminated. What the joints below ask for has to go up the chain, too, or the "
       "hook does not know that somebody hangs there.",
       {eliminated<Slip{.side = 0}>}},
      {"blocks not eliminated",
       "it looks as if only what is wanted were eliminated. Without its block, a joint would be the mass of its two "
       "links alone, where it has to move all that hangs below.",
       {eliminated<Slip{.block = 0}>}},
      {"the old blocks",
       "it looks as if A_ii were used as it was before the joints below had been eliminated. Each joint then feels its "
       "neighbour, and not the load below that.",
       {eliminated<Slip{.old_block = true}>}},
      {"the old wanted speeds",
       "it looks as if the wanted speed of the joint below were used as it was before the elimination. What is further "
       "below then never gets to the hook.",
       {eliminated<Slip{.old_side = true}>}},
      {"substitution forgotten",
       "it looks as if the way back were left out. After the elimination only the hook knows its impulse; each next "
       "joint needs that of the one above.",
       {eliminated<Slip{.back = 0}>}},
      {"each joint by itself",
       "it looks as if each joint were solved by itself. That is one iteration of Jacobi's method, and the chain "
       "stretches.",
       {eliminated<Slip{.block = 0, .side = 0, .back = 0}>}},
      {"one sweep",
       "it looks as if joints were solved one after the other, from the hook down. That is one sweep of Sequential "
       "Impulses: the load does not come up to the hook.",
       {eliminated<Slip{.block = 0, .side = 0}>}},
      {"the free end left out",
       "it looks as if the elimination began one joint too late. The last joint has nobody below it: it is the first "
       "to be eliminated.",
       {eliminated<Slip{.free_end = false}>}},
  };
}

}  // namespace

Numbers play(std::size_t check, Random& random, const Answer& answer) {
  return checks()[check].play(random, answer);
}

Exercise exercise() {
  return rebuild_of<Answer>(
      "the elimination of a chain",
      {"Row i of A λ = wanted: next[i-1]ᵀ λ_i-1 + own[i] λ_i + next[i] λ_i+1 = wanted[i]. At the free end there is no "
       "λ_i+1: solve for λ_i, and put that into row i - 1.",
       "That changes only row i - 1: own[i-1] loses next[i-1] own[i]⁻¹ next[i-1]ᵀ, and wanted[i-1] loses next[i-1] "
       "own[i]⁻¹ wanted[i]. Go on with i - 1, down to 1.",
       "Now the hook's row has only λ_0. Solve it; then each next joint: own[i] λ_i = wanted[i] - next[i-1]ᵀ λ_i-1."},
      checks(), {right}, mistakes());
}

}  // namespace pushback::exercise_18
