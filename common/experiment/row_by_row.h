/// One step of bodies that stay where they are, solved row by row. An interactive page draws it.
#pragma once

#include <string>
#include <vector>

#include "pushback/common/render/picture.h"
#include "pushback/common/world/world.h"

namespace pushback {

struct RowByRow {
  struct Row {
    std::size_t contact;  ///< its index
    Vec3 direction;       ///< unit, world axes
    Real impulse;         ///< N s, accumulated
    Real limit;           ///< N s, of the impulse, when the row was solved last
    Real speed;           ///< m/s, along the direction
    Real error;           ///< m/s, the change of `speed` that another solve would make
  };
  struct State {
    World world;  ///< each contact with its impulse so far
    std::vector<Row> rows;
    int solved;  ///< the index of the row that was solved last; -1: none
  };

  Real speed;                 ///< m/s, of the fastest body before the step is solved: for the lengths of arrows
  std::vector<State> states;  ///< before the first row, and after each; consecutive rows of a contact count as one

  void add(World world, std::vector<Row> rows, int solved);
  /// The contacts' points, and for each state the text next to each contact and a sentence on the latest change, as JSON.
  std::string in_json() const;
  /// A state, seen from the front. An arrow shows the remaining relative velocity at each contact that is not solved yet.
  Picture picture(std::size_t state, const Camera& camera) const;
};

/// Boxes on each other on the ground as seen from the side, each on two corners in the plane z = 0, all with the same velocity.
World on_two_corners(int boxes, const Vec3& half_extents, Real mass, const Vec3& velocity, Real friction = 0);

/// The solver itself solves the step with 0, 1, ..., `sweeps` sweeps. A sweep solves each row once, in the order of the list. So a row
/// has applied the difference of its impulses, and applying it again row by row gives the solver's velocities to the last bit.
template <class ContactSolver>
RowByRow row_by_row(World world, const ContactSolver& solver, Real dt, int sweeps) {
  const std::vector<Body> before = world.bodies;
  const auto rows_after = [&](int count) {
    world.bodies = before;
    ContactSolver solves = solver;
    solves.solve(world, dt, count);
    return solves.rows();
  };
  std::vector<std::remove_cvref_t<decltype(solver.rows())>> swept;
  for (int count = 1; count <= sweeps; ++count) swept.push_back(rows_after(count));
  auto rows = rows_after(0);  // they refer to the bodies of `world`
  RowByRow all{0, {}};
  for (const Body& body : before) all.speed = std::max(all.speed, body.velocity.norm());
  const auto keep = [&](int solved) {
    std::vector<RowByRow::Row> kept;
    for (const auto& row : rows) kept.push_back({row.owner, row.n, row.impulse, row.hi, row.speed(), row.error()});
    all.add(world, kept, solved);
  };
  keep(-1);
  for (const auto& after : swept)
    for (std::size_t i = 0; i < rows.size(); ++i) {
      rows[i].apply(after[i].impulse - rows[i].impulse);
      rows[i].impulse = after[i].impulse;
      rows[i].lo = after[i].lo;
      rows[i].hi = after[i].hi;
      if (i + 1 == rows.size() || rows[i + 1].owner != rows[i].owner) keep(static_cast<int>(i));
    }
  return all;
}

}  // namespace pushback
