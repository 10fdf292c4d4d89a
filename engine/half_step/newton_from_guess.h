/// Solves all rows of a stage at once from a close guess, by Newton's method with a matrix of body blocks.
#pragma once

#include <array>

#include "pushback/chapters/13_joints/joint_row.h"
#include "pushback/engine/half_step/body_matrix.h"

namespace pushback {

/// Each contact or row is an equation f = 0 in its impulse l and its speed u = J V + b:
///
///   a contact          CoulombEquation of chapter 17, of three rows
///   a joint's row      f = l - clamp(l - u / (K + gamma), lo, hi),  u = J V + b + gamma l      without limits u / (K + gamma)
///
/// Chapter 17's Newton step for f, with the proximal term p that keeps it solvable if rows are redundant,
///
///   df_dl dl + df_du (J dV + p dl) = -f,     dV = M^-1 J^T dl
///
/// is solved for dV. With E = df_dl + p df_du,
///
///   (1 + M^-1 J^T E^-1 df_du J) dV = -M^-1 J^T E^-1 f,     dl = -E^-1 (f + df_du J dV)
///
/// A box on a box has 12 rows but only 2 bodies. The matrix is kept for the next Newton step, and for the next system with the same
/// bodies and rows, as long as each step reduces |f| to a tenth.
class NewtonFromGuess {
 public:
  /// Removes all rows.
  void clear() { groups_.clear(); }
  /// Discards the matrix.
  void discard_matrix() { factored_groups_.clear(); }
  void add_contact(Row& normal, Row& tangent1, Row& tangent2, Real friction);
  void add(JointRow& row);
  /// Adds a row with l >= 0, u >= 0, l u = 0.
  void add_normal(Row& row);
  /// The largest error of a row, as a speed, m/s.
  double largest_error();
  /// Sweeps over the contacts and rows, and solves each as if it were alone, l <- l - f.
  void sweep(int times);
  /// Iterates until no row has an error above `enough`, m/s, and then as long as steps are cheap. Returns whether it has reached this.
  /// Rows and bodies are left at the best point found. Once the error is at most `acceptable`, no step that increases |f| is tried.
  bool solve(World& world, double enough, double acceptable = 0);
  int factorizations = 0;  ///< number of matrices factored since the caller reset it to 0
  double small_error = 0;  ///< m/s; if no row has a larger error, it starts with a smaller p, which converges faster
  /// The approximate multiplications that it may still take. It stops once they are spent.
  double work_left = std::numeric_limits<double>::infinity();
  double most_matrix_work = std::numeric_limits<double>::infinity();  ///< multiplications that a single matrix may take
  bool too_large = false;  ///< whether the latest matrix would have taken more

 private:
  using Three = Eigen::Vector3d;
  struct Group {  // a contact, or a single row, for which the other two numbers are 0
    std::array<Row*, 3> rows;
    int count;
    double mu, softness;
    Eigen::Matrix3d w;             // J M^-1 J^T of its rows
    int a, b;                      // indices of its bodies in the matrix, or not_moving
    Three l, u, f;                 // now
    Eigen::Matrix3d df_du, df_dl;  // now
    Three change;                  // dl
  };
  struct FactoredGroup {  // the data of a group from which the matrix was made
    int a, b, count;
    Eigen::Matrix3d df_du, inverse;  // df_du, E^-1
  };
  struct Total {  // error of all groups, m/s
    double sum, largest;
  };
  struct State {
    std::vector<Real> impulses;
    std::vector<std::pair<Vec3, Vec3>> velocities;  // of all bodies
  };
  void add(const std::array<Row*, 3>& rows, int count, double mu, double softness);
  void index_bodies(const World& world);
  Total evaluate();
  void evaluate(Group& group) const;
  bool has_matrix() const;
  bool factor(double proximal);
  bool find_changes();
  static void apply_change(const Group& group, double part);
  void save(const World& world, State& state) const;
  void restore(World& world, const State& state) const;
  void recompute_velocities(World& world, const State& begun);

  std::vector<Group> groups_;
  std::vector<FactoredGroup> factored_groups_;
  std::vector<int> body_indices_;  // index of each body of the world in the matrix
  int bodies_ = 0;
  BodyMatrix::Pairs pairs_;
  BodyMatrix matrix_;
  std::vector<BodyMatrix::Six> speeds_;
  State best_, before_;  // the best point so far, and the point before a step
};

}  // namespace pushback
