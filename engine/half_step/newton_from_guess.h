/// All rows of a stage at once, from a guess that is near: Newton's method, with a matrix between bodies.
#pragma once

#include <array>

#include "pushback/chapters/13_joints/joint_row.h"
#include "pushback/engine/half_step/body_matrix.h"

namespace pushback {

/// What each row is after, as an equation f = 0 in its impulse l and its speed u = J V + b:
///
///   a contact          chapter 17's CoulombEquation, Coulomb's, of three rows
///   a joint's row      f = l - clamp(l - u / (K + gamma), lo, hi),  u = J V + b + gamma l      without limits u / (K + gamma)
///
/// Chapter 17's step for f, with its pull p that keeps it solvable where rows say the same thing twice,
///
///   df_dl dl + df_du (J dV + p dl) = -f,     dV = M^-1 J^T dl
///
/// is solved for dV: with E = df_dl + p df_du
///
///   (1 + M^-1 J^T E^-1 df_du J) dV = -M^-1 J^T E^-1 f,     dl = -E^-1 (f + df_du J dV)
///
/// A box on a box has 12 rows and 2 bodies. The matrix is kept from one step to the next, and for the next system where the same act
/// on the same, as long as |f| falls well.
class NewtonFromGuess {
 public:
  /// No rows.
  void clear() { groups_.clear(); }
  /// No matrix either.
  void forget() { kept_.clear(); }
  void add_contact(Row& normal, Row& tangent1, Row& tangent2, Real friction);
  void add(JointRow& row);
  /// l >= 0, u >= 0, one of them 0.
  void add_normal(Row& row);
  /// The largest speed that a row is wrong by, m/s.
  double off();
  /// Sweeps over each contact and row as if it were alone, l <- l - f.
  void sweep(int times);
  /// Goes on until no row is wrong by more than `enough`, m/s, and then as far as steps are cheap. False where it does not get there:
  /// rows and bodies are then as at the best point met. Where `just` is reached, it does not try hard.
  bool solve(World& world, double enough, double just = 0);
  int factored = 0;  ///< matrices, since the caller reset it to 0
  double near = 0;   ///< m/s: where no row is wrong by more, it needs little pull, and little is faster
  /// Multiplications, roughly, that are left to it. Once they are spent, it stops where it is.
  double work = std::numeric_limits<double>::infinity();
  double largest = std::numeric_limits<double>::infinity();  ///< multiplications that a single matrix may take
  bool too_large = false;                                    ///< whether the latest one would have taken more

 private:
  using Three = Eigen::Vector3d;
  struct Group {  // a contact, or one row: then the other two numbers are 0
    std::array<Row*, 3> rows;
    int count;
    double mu, softness;
    Eigen::Matrix3d w;             // J M^-1 J^T of its rows
    int a, b;                      // places of its bodies; not_moving
    Three l, u, f;                 // now
    Eigen::Matrix3d df_du, df_dl;  // now
    Three change;                  // dl
  };
  struct Kept {  // of a group, as the matrix has it
    int a, b, count;
    Eigen::Matrix3d df_du, inverse;  // df_du, E^-1
  };
  struct Total {  // of all f, m/s
    double sum, largest;
  };
  struct State {
    std::vector<Real> impulses;
    std::vector<std::pair<Vec3, Vec3>> velocities;  // of all bodies
  };
  void add(const std::array<Row*, 3>& rows, int count, double mu, double softness);
  void find_places(const World& world);
  Total evaluate();
  void look(Group& group) const;
  bool has_matrix() const;
  bool factor(double pull);
  bool find_changes();
  static void move(const Group& group, double part);
  void keep(const World& world, State& state) const;
  void give(World& world, const State& state) const;
  void come_back_from(World& world, const State& begun);

  std::vector<Group> groups_;
  std::vector<Kept> kept_;
  std::vector<int> places_;  // of each body, in the matrix
  int bodies_ = 0;
  BodyMatrix::Pairs pairs_;
  BodyMatrix matrix_;
  std::vector<BodyMatrix::Six> speeds_;
  State best_, before_;  // so far; a step
};

}  // namespace pushback
