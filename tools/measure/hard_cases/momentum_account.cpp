#include "pushback/tools/measure/hard_cases/momentum_account.h"

#include <fmt/format.h>

#include <algorithm>

namespace pushback {

namespace {

/// N s, on B: what equations along the axes of the world have given. False where one is along another direction.
bool along_axes(const World& world, const Joint& joint, Vec3& impulse) {
  Equations equations;
  joint.ask(world.body(joint.a), world.body(joint.b), {world.time, 1}, equations);
  impulse.setZero();
  for (std::size_t i = 0; i < equations.size(); ++i) {
    const Vec3& n = equations[i].jacobian.n;
    const bool axis = n == Vec3::UnitX() || n == Vec3::UnitY() || n == Vec3::UnitZ();
    if (!axis && !n.isZero(0)) return false;
    if (i < joint.impulses.size()) impulse += joint.impulses[i] * n;
  }
  return true;
}

}  // namespace

MomentumAccount::MomentumAccount(const World& world) : before_(world) {}

std::string MomentumAccount::look(const World& after, Real dt, Real epsilon) {
  constexpr Real units = 1e4;   // of rounding: hundreds of substeps and sweeps, each of which rounds
  constexpr Real push_out = 3;  // m/s: so fast may a body be within a step, although it is taken back
  const std::size_t count = after.bodies.size();
  std::vector<Vec3> given(count, Vec3::Zero());
  std::vector<Real> size(count, 0);
  std::vector<bool> known(count, true);
  const auto give = [&](std::size_t a, std::size_t b, const Vec3& impulse) {
    given[a] -= impulse;
    given[b] += impulse;
    for (const std::size_t i : {a, b}) size[i] += impulse.norm();
  };
  for (const Contact& contact : after.contacts) give(contact.id.body_a, contact.id.body_b, contact.impulse);
  for (const Joint& joint : after.joints) {
    Vec3 impulse;
    const bool counts = along_axes(after, joint, impulse);
    for (const auto& [body, sign] : {std::pair(joint.a, -1), std::pair(joint.b, 1)}) {
      if (body == the_world) continue;
      const auto i = static_cast<std::size_t>(body);
      known[i] = known[i] && counts;
      given[i] += static_cast<Real>(sign) * impulse;
      size[i] += impulse.norm();
    }
  }
  const auto by_forces = [&](const Body& was) -> Vec3 { return dt * (before_.gravity / was.inverse_mass + was.force); };
  for (std::size_t i = 0; i < count; ++i) {
    const Body &was = before_.bodies[i], &is = after.bodies[i];
    if (!is.movable()) continue;
    const Real moved = (push_out + is.velocity.norm() + was.velocity.norm()) / is.inverse_mass;
    largest_ = std::max({largest_, size[i], moved, by_forces(was).norm()});
  }
  std::string wrong;
  for (std::size_t i = 0; i < count && wrong.empty(); ++i) {
    const Body &was = before_.bodies[i], &is = after.bodies[i];
    if (!is.movable() || !known[i]) continue;
    const Vec3 change = (is.velocity - was.velocity) / is.inverse_mass;
    const Real off = (change - by_forces(was) - given[i]).norm();
    if (!(off <= units * epsilon * largest_))
      wrong = fmt::format("body {} gained {:.6g} N s more than is reported, of {:.3g} N s", i, off, size[i]);
  }
  before_ = after;
  return wrong;
}

}  // namespace pushback
