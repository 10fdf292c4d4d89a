/// A column in the plane, three times as high as wide, that lands on two corners: the table of the chapter's page and its figure.
#include <fmt/format.h>

#include <array>

#include "pushback/chapters/01_velocity_constraint/row.h"
#include "tests/support/call.h"

using namespace pushback;

namespace {

/// The column, 1 kg at 1 m/s, so that impulses are in units of m v; its two contacts are made by hand.
struct TwoPointColumn {
  World world;

  TwoPointColumn() {
    constexpr Real w = Real(0.5), high = 3 * w;
    world.add(ground());
    world.add(box({w, high, w}, 1).at({0, high, 0}).moving({0, -1, 0}));
    for (const Real x : {-w, w}) {
      Contact contact;
      contact.id = {0, 1, static_cast<std::uint32_t>(world.contacts.size())};
      contact.point = {x, 0, 0};
      contact.normal = Vec3::UnitY();
      world.contacts.push_back(contact);
    }
  }
  Row row(std::size_t i) { return {world, world.contacts[i], world.contacts[i].normal, i}; }
};

/// The sums of both impulses and the speeds of both points after each solve of a row.
struct AfterEachSolve {
  std::vector<std::array<Real, 2>> sums, speeds;
};

/// Twelve solves of each row in turn. `each_correction`: none may be negative; otherwise their sum may not.
AfterEachSolve solved_in_turn(bool each_correction) {
  TwoPointColumn column;
  Rows rows{column.row(0), column.row(1)};
  for (Row& row : rows) row.lo = 0;
  AfterEachSolve solved;
  for (int sweep = 0; sweep < 12; ++sweep) {
    for (Row& row : rows) {
      row.solve();
      if (each_correction) row.lo = row.impulse;
      solved.sums.push_back({rows[0].impulse, rows[1].impulse});
      solved.speeds.push_back({rows[0].speed(), rows[1].speed()});
    }
  }
  return solved;
}

}  // namespace

TEST_CASE("02: two points of a column, row by row: the page's table and its figure") {
  TwoPointColumn column;
  const Row one = column.row(0), two = column.row(1);
  CHECK(one.n.dot(one.dvb) + one.rb_n.dot(one.dwb) == Approx(1.3));
  CHECK(one.n.dot(two.dvb) + one.rb_n.dot(two.dwb) == Approx(0.7));
  const AfterEachSolve sum = solved_in_turn(false), each = solved_in_turn(true);
  const std::string page = text_of("chapters/02_clamping/README.md"), figure = text_of("docs/figures/two_points.svg");
  for (std::size_t solve = 0; solve < 4; ++solve) {
    CHECK(contains(figure, fmt::format("{}, row {}: {:.3f}, {:.3f}<", solve / 2 + 1, solve % 2 + 1, sum.sums[solve][0],
                                       sum.sums[solve][1])));
    for (std::size_t i = 0; i < 2; ++i) {
      if (sum.sums[solve][i] > 0) CHECK(contains(page, fmt::format("{:.3f}", sum.sums[solve][i])));
      const Real speed = std::abs(sum.speeds[solve][i]);
      if (speed > Real(0.01)) CHECK(contains(page, fmt::format("{:.3f}", speed)));
    }
  }
  // The sum's error falls by (K12/K11)^2 in each iteration; with each correction clamped, nothing moves after the first.
  const Real factor = Real(0.7 * 0.7 / (1.3 * 1.3));
  for (std::size_t solve = 3; solve + 2 < sum.sums.size(); solve += 2)
    CHECK(sum.sums[solve + 2][1] - Real(0.5) == Approx(factor * (sum.sums[solve][1] - Real(0.5))));
  for (std::size_t solve = 1; solve < each.sums.size(); ++solve) {
    CHECK(each.sums[solve][0] == Approx(1 / Real(1.3)));
    CHECK(each.sums[solve][1] == Approx(Real(0.6) / (Real(1.3) * Real(1.3))));
  }
}
