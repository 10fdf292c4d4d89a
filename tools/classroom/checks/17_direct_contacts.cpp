#include <algorithm>
#include <array>
#include <cmath>

#include "pushback/chapters/17_direct_contacts/exercise/asked.h"
#include "pushback/tools/classroom/checks/scenes.h"

namespace pushback::exercise_17 {

namespace {

using Eigen::Index;

/// For five contacts: u_0 ... u_4, the impulses of all, z. The impulses are basic.
struct Scene {
  Tableau tableau;
  Index entering;

  /// The approximate decrease of each basic variable per unit of `entering`, and its value.
  Scene(Random& random, const std::array<std::array<double, 2>, 5>& falls_and_values) {
    constexpr Index n = 5;
    tableau.t.resize(n, 2 * n + 2);
    for (double& entry : tableau.t.reshaped()) entry = between(random, -1, 1);
    for (Index i = 0; i < n; ++i) tableau.basis.push_back(n + i);
    random.shuffle(tableau.basis);
    const std::size_t free = random.below(n + 1);
    entering = free == n ? 2 * n : static_cast<Index>(free);
    for (Index i = 0; i < n; ++i) {
      const auto row = static_cast<std::size_t>(i);
      for (const Index basic : tableau.basis) tableau.t(i, basic) = basic == tableau.basis[row] ? 1 : 0;
      tableau.t(i, entering) = falls_and_values[row][0] * between(random, 0.95, 1.05);
      tableau.t(i, 2 * n + 1) = falls_and_values[row][1] * between(random, 0.95, 1.05);
    }
  }
};

/// In one row the value is the least, in one the fall is the largest, and in one their ratio is the least.
Scene scene(Random& random) {
  std::array<std::array<double, 2>, 5> rows{{{-0.5, 1.5}, {2, 3}, {1, 1}, {0.25, 0.7}, {-0.3, 2.4}}};
  for (std::size_t i = 4; i > 1; --i) std::swap(rows[i], rows[1 + random.below(i)]);
  return Scene(random, rows);
}

Scene ray(Random& random) {
  return Scene(random, {{{-0.5, 1.5}, {-2, 3}, {-1, 1}, {-0.2, 0.7}, {-0.3, 2.4}}});
}

std::vector<double> values_of(const Tableau& tableau) {
  std::vector<double> values(static_cast<std::size_t>(tableau.t.cols() - 1), 0);
  for (std::size_t i = 0; i < tableau.basis.size(); ++i)
    values.at(static_cast<std::size_t>(tableau.basis[i])) = tableau.t(static_cast<Index>(i), tableau.t.cols() - 1);
  return values;
}

/// Lemke's method with these pivots, for u = A l + b: the largest |min(l, u)|, at most `hopeless`; and how many pivots it took.
std::vector<Reading> solved(const Eigen::MatrixXd& a, const Eigen::VectorXd& b, const Answer& answer) {
  constexpr double hopeless = 1000;
  const Index n = b.size(), z = 2 * n;
  Tableau tableau{Eigen::MatrixXd(n, 2 * n + 2), {}};
  tableau.t << Eigen::MatrixXd::Identity(n, n), -a, -Eigen::VectorXd::Ones(n), b;
  for (Index i = 0; i < n; ++i) tableau.basis.push_back(i);
  Index lowest = 0;
  b.minCoeff(&lowest);
  tableau.t.row(lowest) *= -1;  // its entry under z is -1
  for (Index i = 0; i < n; ++i)
    if (i != lowest) tableau.t.row(i) += tableau.t.row(lowest).eval();
  tableau.basis[static_cast<std::size_t>(lowest)] = z;
  int pivots = 1;
  for (Index left = lowest; left >= 0 && left < z && pivots < 200; ++pivots)
    left = answer.pivot(tableau, left < n ? left + n : left - n);
  const std::vector<double> values = values_of(tableau);
  const Eigen::VectorXd impulses = Eigen::Map<const Eigen::VectorXd>(values.data() + n, n);
  const double error = impulses.cwiseMin(a * impulses + b).cwiseAbs().maxCoeff();
  return {{"with your pivots the largest |min(λ, u)| is", error < hopeless ? error : hopeless},
          {"the number of your pivots is", pivots}};
}

Index right(Tableau& tableau, Index entering) {
  Eigen::MatrixXd& t = tableau.t;
  const auto ratio = [&](Index i) { return t(i, t.cols() - 1) / t(i, entering); };
  Index row = -1;
  for (Index i = 0; i < t.rows(); ++i)
    if (t(i, entering) > 0 && (row < 0 || ratio(i) < ratio(row))) row = i;
  if (row < 0) return -1;
  t.row(row) /= t(row, entering);
  for (Index i = 0; i < t.rows(); ++i)
    if (i != row) t.row(i) -= t(i, entering) * t.row(row).eval();
  return std::exchange(tableau.basis[static_cast<std::size_t>(row)], entering);
}

}  // namespace

std::vector<Check<Answer>> checks_of(const Answer& /*any*/) {
  return {
      {"the first variable to reach 0 leaves", 1,
       [](Random& random, const Answer& answer) -> std::vector<Reading> {
         auto [tableau, entering] = scene(random);
         const Index left = answer.pivot(tableau, entering);
         const double entered = values_of(tableau)[static_cast<std::size_t>(entering)];
         return {{"the number of the variable that leaves is", left},
                 {"the value of the variable that enters becomes", entered},
                 {"the smallest value in your tableau is", tableau.t.rightCols<1>().minCoeff()}};
       },
       "the first variable to reach 0 leaves. It has the smallest value / entry among the rows with a positive entry. "
       "With any other row a value becomes negative, so a contact pulls."},
      {"the equations stay equivalent", 1,
       [](Random& random, const Answer& answer) -> std::vector<Reading> {
         auto [tableau, entering] = scene(random);
         answer.pivot(tableau, entering);
         return {{"the entries of your tableau add up to", tableau.t.sum(), "", 1e-5},
                 {"the values in your last column add up to", tableau.t.rightCols<1>().sum(), "", 1e-5}};
       },
       "solve the leaving variable's row for the entering variable, and substitute the result into all other rows. A "
       "pivot rewrites the same equations, including the last column."},
      {"if no variable ever reaches 0, none leaves", 1,
       [](Random& random, const Answer& answer) -> std::vector<Reading> {
         auto [tableau, entering] = ray(random);
         const Index left = answer.pivot(tableau, entering);
         return {{"the number of the variable that leaves is", left},
                 {"the entries of your tableau add up to", tableau.t.sum(), "", 1e-5}};
       },
       "a variable whose entry is not positive never reaches 0. If this holds for all, no variable leaves, you return "
       "-1, and the tableau stays as it is."},
      {"repeated pivots solve all contacts", 2,
       [](Random& random, const Answer& answer) -> std::vector<Reading> {
         const Index n = static_cast<Index>(40 + random.below(10));
         Eigen::MatrixXd mixed(n, n);
         for (double& entry : mixed.reshaped()) entry = between(random, -1, 1);
         Eigen::VectorXd b(n);
         for (double& speed : b) speed = between(random, -2, 1);
         return solved(mixed * mixed.transpose() / static_cast<double>(n) + 0.1 * Eigen::MatrixXd::Identity(n, n), b,
                       answer);
       },
       "in each pivot, return the first variable to reach 0, because its partner enters next. The basis lists the "
       "variable that each row is solved for."},
  };
}

Exercise exercise() {
  return rebuild_of("one pivot",
                    {"A basic variable has the value t(i, last), and falls by t(i, entering) if the entering one grows "
                     "by 1. At which value of the entering one does it reach 0, and for which signs never?",
                     "Choose the row with the smallest t(i, last) / t(i, entering) among those with t(i, entering) > "
                     "0. If there is none, return -1. Start with no row, not with row 0.",
                     "Divide that row by its entry under `entering`. Subtract it from each other row, times that row's "
                     "entry under `entering`. Save basis[row], write `entering` into it, and return the saved number."},
                    Answer{right});
}

}  // namespace pushback::exercise_17
