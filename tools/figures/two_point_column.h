/// Chapter 02's column in the plane, three times as high as wide, that lands on two corners: two contacts, made by hand.
#pragma once

#include <array>

#include "pushback/chapters/01_velocity_constraint/row.h"

namespace pushback::figures {

struct TwoPointColumn {
  World world;

  TwoPointColumn() {
    constexpr Real w = Real(0.5), high = 3 * w;
    world.add(ground());
    world.add(box({w, high, w}, 1).at({0, high, 0}).moving({0, -1, 0}));  // m v = 1
    for (const Real x : {-w, w}) {
      Contact contact;
      contact.id = {0, 1, static_cast<std::uint32_t>(world.contacts.size())};
      contact.point = {x, 0, 0};
      contact.normal = Vec3::UnitY();
      world.contacts.push_back(contact);
    }
  }
  Body& column() { return world.bodies[1]; }
  Row row(std::size_t i) { return {world, world.contacts[i], world.contacts[i].normal, i}; }
  /// K_ij = J_i M^-1 J_j^T, 1/kg.
  Real coupling(std::size_t i, std::size_t j) const {
    TwoPointColumn other = *this;
    const Row one = other.row(i), two = other.row(j);
    return one.n.dot(two.dvb) + one.rb_n.dot(two.dwb);
  }

  /// After each solve of a row: first row 1, then row 2, and so on.
  struct Solved {
    std::vector<std::array<Real, 2>> sums, speeds;
  };
};

/// Twelve solves of each row. `each_correction`: none may be negative; else their sum may not.
inline TwoPointColumn::Solved solved_in_turn(bool each_correction) {
  TwoPointColumn column;
  Rows rows{column.row(0), column.row(1)};
  for (Row& row : rows) row.lo = 0;
  TwoPointColumn::Solved solved;
  const auto note = [&] {
    solved.sums.push_back({rows[0].impulse, rows[1].impulse});
    solved.speeds.push_back({rows[0].speed(), rows[1].speed()});
  };
  note();
  for (int sweep = 0; sweep < 12; ++sweep) {
    for (Row& row : rows) {
      row.solve();
      if (each_correction) row.lo = row.impulse;
      note();
    }
  }
  return solved;
}

}  // namespace pushback::figures
