#include <algorithm>
#include <array>
#include <cmath>

#include "pushback/chapters/17_direct_contacts/exercise/asked.h"

namespace pushback::exercise_17 {

namespace {

using Eigen::Index;

double between(Random& random, double low, double high) {
  return static_cast<double>(random.between(static_cast<Real>(low), static_cast<Real>(high)));
}

/// Of five contacts: u_0 ... u_4, the impulses of all, z. The impulses are basic.
struct Scene {
  Tableau tableau;
  Index entering;

  /// What falls of each basic variable as `entering` grows by 1, and its value: nearly these.
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

/// The largest |left side - right side| of these equations.
double off(const Eigen::MatrixXd& equations, const std::vector<double>& values) {
  const Eigen::Map<const Eigen::VectorXd> x(values.data(), std::ssize(values));
  return (equations.leftCols(x.size()) * x - equations.rightCols<1>()).cwiseAbs().maxCoeff();
}

/// Lemke's method with these pivots, for u = A l + b: the largest |min(l, u)|, at most `hopeless`; and how many pivots it took.
Numbers solved(const Eigen::MatrixXd& a, const Eigen::VectorXd& b, const Answer& answer) {
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
  return {static_cast<Real>(error < hopeless ? error : hopeless), static_cast<Real>(pivots)};
}

std::vector<Check<Answer>> checks() {
  const Quantity leaves{"the number of the variable that leaves is", "", 1e-6},
      entries{"the entries of your tableau add up to", "", 1e-5};
  return {
      {"the first variable to reach 0 leaves",
       1,
       {leaves,
        {"the variable that enters becomes", "", 1e-6},
        {"the least value in your tableau is", "", 1e-6},
        {"in a second tableau the number of the variable that leaves is", "", 1e-6},
        {"in a third tableau the number of the variable that leaves is", "", 1e-6}},
       [](Random& random, const Answer& answer) -> Numbers {
         auto [tableau, entering] = scene(random);
         const Index left = answer.pivot(tableau, entering);
         const double entered = values_of(tableau)[static_cast<std::size_t>(entering)];
         Numbers numbers{static_cast<Real>(left), static_cast<Real>(entered),
                         static_cast<Real>(tableau.t.rightCols<1>().minCoeff())};
         for (int more = 0; more < 2; ++more) {
           auto [another, enters] = scene(random);
           numbers.push_back(static_cast<Real>(answer.pivot(another, enters)));
         }
         return numbers;
       }},
      {"the equations say the same as before",
       1,
       {{"put into the equations as they were, your values are off by", "", 1e-6}, entries},
       [](Random& random, const Answer& answer) -> Numbers {
         auto [tableau, entering] = scene(random);
         const Eigen::MatrixXd before = tableau.t;
         answer.pivot(tableau, entering);
         return {static_cast<Real>(off(before, values_of(tableau))), static_cast<Real>(tableau.t.sum())};
       }},
      {"where no variable ever reaches 0, none leaves",
       1,
       {leaves, entries},
       [](Random& random, const Answer& answer) -> Numbers {
         auto [tableau, entering] = ray(random);
         const Index left = answer.pivot(tableau, entering);
         return {static_cast<Real>(left), static_cast<Real>(tableau.t.sum())};
       }},
      {"pivot after pivot, all contacts are solved",
       2,
       {{"with your pivots the largest |min(λ, u)| is", "", 1e-6}, {"the number of your pivots is", "", 1e-6}},
       [](Random& random, const Answer& answer) -> Numbers {
         const Index n = static_cast<Index>(40 + random.below(10));
         Eigen::MatrixXd mixed(n, n);
         for (double& entry : mixed.reshaped()) entry = between(random, -1, 1);
         Eigen::VectorXd b(n);
         for (double& speed : b) speed = between(random, -2, 1);
         return solved(mixed * mixed.transpose() / static_cast<double>(n) + 0.1 * Eigen::MatrixXd::Identity(n, n), b,
                       answer);
       }},
  };
}

/// The row with the least of this among those that count; -1 where none does.
template <class Counts, class Of>
Index least(const Tableau& tableau, const Counts& counts, const Of& of) {
  Index best = -1;
  for (Index i = 0; i < tableau.t.rows(); ++i)
    if (counts(i) && (best < 0 || of(i) < of(best))) best = i;
  return best;
}

Index first_to_leave(const Tableau& tableau, Index entering) {
  const Eigen::MatrixXd& t = tableau.t;
  return least(
      tableau, [&](Index i) { return t(i, entering) > 0; },
      [&](Index i) { return t(i, t.cols() - 1) / t(i, entering); });
}

void eliminate(Eigen::MatrixXd& t, Index row, Index entering) {
  t.row(row) /= t(row, entering);
  for (Index i = 0; i < t.rows(); ++i)
    if (i != row) t.row(i) -= t(i, entering) * t.row(row).eval();
}

template <class Choose, class Eliminate>
Index pivoted(Tableau& tableau, Index entering, const Choose& choose, const Eliminate& eliminated) {
  const Index row = choose(tableau, entering);
  if (row < 0) return -1;
  eliminated(tableau.t, row, entering);
  return std::exchange(tableau.basis[static_cast<std::size_t>(row)], entering);
}

Index right(Tableau& tableau, Index entering) {
  return pivoted(tableau, entering, first_to_leave, eliminate);
}

template <class Choose>
Index chosen_by(Tableau& tableau, Index entering, const Choose& choose) {
  return pivoted(tableau, entering, choose, eliminate);
}

template <class Eliminate>
Index eliminated_by(Tableau& tableau, Index entering, const Eliminate& eliminated) {
  return pivoted(tableau, entering, first_to_leave, eliminated);
}

/// Column by column from the left, in place.
void eliminate_in_place(Eigen::MatrixXd& t, Index row, Index entering) {
  for (Index i = 0; i < t.rows(); ++i)
    for (Index j = 0; j < t.cols() && i != row; ++j) t(i, j) -= t(i, entering) * t(row, j);
}

std::vector<Mistake<Answer>> mistakes() {
  const std::string in_use =
      "it looks as if a number were changed while it was still in use. Once the loop over the columns has passed the "
      "entering one, its entry is 1 or 0, and the rest of the row is divided or taken away by that: keep it first.";
  return {
      {"the largest ratio",
       "it looks as if the last variable to reach 0 left, instead of the first. By then the first is negative: a "
       "contact pulls.",
       {[](Tableau& tableau, Index entering) {
         return chosen_by(tableau, entering, [](const Tableau& its, Index e) {
           const Eigen::MatrixXd& t = its.t;
           return least(
               its, [&](Index i) { return t(i, e) > 0; }, [&](Index i) { return -t(i, t.cols() - 1) / t(i, e); });
         });
       }}},
      {"negative entries too",
       "it looks as if a row with a negative entry were chosen. Its variable grows with the entering one, and never "
       "reaches 0: the entering one would have to fall.",
       {[](Tableau& tableau, Index entering) {
         return chosen_by(tableau, entering, [](const Tableau& its, Index e) {
           const Eigen::MatrixXd& t = its.t;
           return least(
               its, [&](Index i) { return t(i, e) != 0; }, [&](Index i) { return t(i, t.cols() - 1) / t(i, e); });
         });
       }}},
      {"the first row to begin with",
       "it looks as if the search began with row 0, whatever its entry. Where that is negative, its ratio is, too, and "
       "no other row comes below it.",
       {[](Tableau& tableau, Index entering) {
         return chosen_by(tableau, entering, [](const Tableau& its, Index e) {
           const Eigen::MatrixXd& t = its.t;
           return least(
               its, [&](Index i) { return i == 0 || t(i, e) > 0; },
               [&](Index i) { return t(i, t.cols() - 1) / t(i, e); });
         });
       }}},
      {"the largest entry",
       "it looks as if the row with the largest entry were chosen, as Gauss would for small rounding errors. Here the "
       "row says who leaves: the first to reach 0.",
       {[](Tableau& tableau, Index entering) {
         return chosen_by(tableau, entering, [](const Tableau& its, Index e) {
           return least(its, [&](Index i) { return its.t(i, e) > 0; }, [&](Index i) { return -its.t(i, e); });
         });
       }}},
      {"the least value",
       "it looks as if the variable with the least value left. Who is first to reach 0 depends on how fast it falls, "
       "too: the ratio counts.",
       {[](Tableau& tableau, Index entering) {
         return chosen_by(tableau, entering, [](const Tableau& its, Index e) {
           return least(
               its, [&](Index i) { return its.t(i, e) > 0; }, [&](Index i) { return its.t(i, its.t.cols() - 1); });
         });
       }}},
      {"row not divided",
       "it looks as if the row of the one that leaves were not divided by its entry. It has to be solved for the "
       "entering variable, with 1 before it.",
       {[](Tableau& tableau, Index entering) {
         return eliminated_by(tableau, entering, [](Eigen::MatrixXd& t, Index row, Index e) {
           const Eigen::VectorXd whole = t.row(row);
           eliminate(t, row, e);
           t.row(row) = whole;
         });
       }}},
      {"row not divided",
       "it looks as if the row of the one that leaves were not divided by its entry, neither before nor while it was "
       "taken away from the others.",
       {[](Tableau& tableau, Index entering) {
         return eliminated_by(tableau, entering, [](Eigen::MatrixXd& t, Index row, Index e) {
           for (Index i = 0; i < t.rows(); ++i)
             if (i != row) t.row(i) -= t(i, e) * t.row(row).eval();
         });
       }}},
      {"the row taken away from itself",
       "it looks as if the row were taken away from itself as well, which leaves nothing of it. It is put into all "
       "other rows.",
       {[](Tableau& tableau, Index entering) {
         return eliminated_by(tableau, entering, [](Eigen::MatrixXd& t, Index row, Index e) {
           eliminate(t, row, e);
           t.row(row).setZero();
         });
       }}},
      {"others left as they were",
       "it looks as if only the row of the one that leaves were changed. The entering variable stands in the other "
       "equations, too: put it in there.",
       {[](Tableau& tableau, Index entering) {
         return eliminated_by(tableau, entering,
                              [](Eigen::MatrixXd& t, Index row, Index e) { t.row(row) /= t(row, e); });
       }}},
      {"values forgotten",
       "it looks as if the last column were left as it was. What each equation equals is part of it.",
       {[](Tableau& tableau, Index entering) {
         return eliminated_by(tableau, entering, [](Eigen::MatrixXd& t, Index row, Index e) {
           const Eigen::VectorXd values = t.rightCols<1>();
           eliminate(t, row, e);
           t.rightCols<1>() = values;
         });
       }}},
      {"only the values",
       "it looks as if only the last column were changed. The next pivot finds the equations as they were, with values "
       "that belong to others.",
       {[](Tableau& tableau, Index entering) {
         return eliminated_by(tableau, entering, [](Eigen::MatrixXd& t, Index row, Index e) {
           Eigen::MatrixXd all = t;
           eliminate(all, row, e);
           t.rightCols<1>() = all.rightCols<1>();
         });
       }}},
      {"changed while in use", in_use, {[](Tableau& tableau, Index entering) {
         return eliminated_by(tableau, entering, [](Eigen::MatrixXd& t, Index row, Index e) {
           for (Index j = 0; j < t.cols(); ++j) t(row, j) /= t(row, e);
           eliminate_in_place(t, row, e);
         });
       }}},
      {"changed while in use", in_use, {[](Tableau& tableau, Index entering) {
         return eliminated_by(tableau, entering, [](Eigen::MatrixXd& t, Index row, Index e) {
           t.row(row) /= t(row, e);
           eliminate_in_place(t, row, e);
         });
       }}},
      {"changed while in use", in_use, {[](Tableau& tableau, Index entering) {
         return eliminated_by(tableau, entering, [](Eigen::MatrixXd& t, Index row, Index e) {
           for (Index j = 0; j < t.cols(); ++j) t(row, j) /= t(row, e);
           for (Index i = 0; i < t.rows(); ++i)
             if (i != row) t.row(i) -= t(i, e) * t.row(row).eval();
         });
       }}},
      {"sign",
       "it looks as if the row were added to the others. The entering variable is to vanish from them: take the row "
       "away, times their entry.",
       {[](Tableau& tableau, Index entering) {
         return eliminated_by(tableau, entering, [](Eigen::MatrixXd& t, Index row, Index e) {
           t.row(row) /= t(row, e);
           for (Index i = 0; i < t.rows(); ++i)
             if (i != row) t.row(i) += t(i, e) * t.row(row).eval();
         });
       }}},
      {"basis not written",
       "it looks as if basis[row] were left as it was. The row is solved for the entering variable now, and nobody "
       "knows.",
       {[](Tableau& tableau, Index entering) {
         const Index row = first_to_leave(tableau, entering);
         if (row < 0) return Index(-1);
         eliminate(tableau.t, row, entering);
         return tableau.basis[static_cast<std::size_t>(row)];
       }}},
      {"the one that enters given back",
       "it looks as if basis[row] were read after it was written: the variable that enters is given back, instead of "
       "the one that leaves.",
       {[](Tableau& tableau, Index entering) { return right(tableau, entering) < 0 ? -1 : entering; }}},
      {"the row given back",
       "it looks as if the row were given back. Asked is which variable leaves: its number stands in basis[row].",
       {[](Tableau& tableau, Index entering) {
         const Index row = first_to_leave(tableau, entering);
         right(tableau, entering);
         return row;
       }}},
  };
}

}  // namespace

Numbers play(std::size_t check, Random& random, const Answer& answer) {
  return checks()[check].play(random, answer);
}

Exercise exercise() {
  return rebuild_of<Answer>(
      "one pivot",
      {"A basic variable has the value t(i, last), and falls by t(i, entering) for each 1 that the entering one grows. "
       "At which size of the entering one is it 0, and for which signs never?",
       "The row with the least t(i, last) / t(i, entering) among those with t(i, entering) > 0. If there is none, give "
       "back -1. Begin with no row, not with row 0.",
       "Divide that row by its entry under `entering`. Then take it away from each other row, times that row's entry "
       "under `entering`. Remember basis[row], write `entering` into it, and give back what you remembered."},
      checks(), {right}, mistakes());
}

}  // namespace pushback::exercise_17
