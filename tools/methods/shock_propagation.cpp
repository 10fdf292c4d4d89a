#include "pushback/tools/methods/shock_propagation.h"

namespace pushback {

void ShockPropagation::find_heights(const StepContext& step) {
  heights_.assign(step.world.bodies.size(), none);
  for (std::size_t i = 0; i < heights_.size(); ++i)
    if (!step.world.bodies[i].movable()) heights_[i] = 0;
  const auto height = [this](const Body* body) -> int& { return heights_[static_cast<std::size_t>(body->index)]; };
  for (bool changed = true; changed;) {
    changed = false;
    for (std::size_t i = 0; i < step.contacts.size(); ++i) {
      int &a = height(step.rows[i].a), &b = height(step.rows[i].b);
      for (const auto& [from, to] : {std::pair{&a, &b}, {&b, &a}}) {
        if (*from == none || *to <= *from + 1) continue;
        *to = *from + 1;
        changed = true;
      }
    }
  }
  contacts_.clear();
  for (std::size_t i = 0; i < step.contacts.size(); ++i) {
    const int lower = std::min(height(step.rows[i].a), height(step.rows[i].b));
    if (lower == none) continue;  // it hangs in the air
    if (contacts_.size() <= static_cast<std::size_t>(lower)) contacts_.resize(static_cast<std::size_t>(lower) + 1);
    contacts_[static_cast<std::size_t>(lower)].push_back(i);
  }
}

Row ShockPropagation::on_the_upper(const Row& row) const {
  Row upper = row;
  const int a = heights_[static_cast<std::size_t>(row.a->index)], b = heights_[static_cast<std::size_t>(row.b->index)];
  if (a < b) upper.dva.setZero(), upper.dwa.setZero();
  if (b < a) upper.dvb.setZero(), upper.dwb.setZero();
  upper.effective_mass =
      1 / (upper.n.dot(upper.dvb - upper.dva) + upper.rb_n.dot(upper.dwb) - upper.ra_n.dot(upper.dwa));
  return upper;
}

void ShockPropagation::finish(StepContext& step) {
  find_heights(step);
  tangents_.assign(step.contacts.size(), 0);
  for (std::size_t i = step.rows.size(); i-- > step.contacts.size();) tangents_[step.rows[i].owner] = i;
  for (const std::vector<std::size_t>& of_height : contacts_) {
    for (int round = 0; round < rounds; ++round) {
      for (const std::size_t i : of_height) {
        Row normal = on_the_upper(step.rows[i]);
        normal.solve();
        step.rows[i].impulse = normal.impulse;
        ++rows_solved;
        if (tangents_[i] == 0) continue;
        Row one = on_the_upper(step.rows[tangents_[i]]), two = on_the_upper(step.rows[tangents_[i] + 1]);
        const Real size = 1 / TangentBlock(one, two).larger_eigenvalue();
        Real total1 = one.impulse - size * one.speed(), total2 = two.impulse - size * two.speed();
        const Real length = std::hypot(total1, total2), radius = step.contacts[i].friction * normal.impulse;
        if (length > radius) total1 *= radius / length, total2 *= radius / length;
        one.reach(total1);
        two.reach(total2);
        step.rows[tangents_[i]].impulse = one.impulse;
        step.rows[tangents_[i] + 1].impulse = two.impulse;
        rows_solved += 2;
      }
    }
  }
}

}  // namespace pushback
