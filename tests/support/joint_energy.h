/// What joints that feed nothing back do to the energy.
#pragma once

#include "pushback/chapters/13_joints/hinge.h"
#include "pushback/common/bodies/random.h"
#include "pushback/common/world/measure.h"

namespace pushback {

/// Spheres from the origin in any directions, held in turn by a ball and socket and by a hinge; each of 1 to 3 kg and moving.
/// `load`: kg, of the last, where it is above 0.
inline World crooked_chain(int count, Random& random, Real load = 0) {
  World world;
  Vec3 end = Vec3::Zero();
  for (int link = 0; link < count; ++link) {
    const Vec3 next = end + random.direction();
    const Real mass = load > 0 && link == count - 1 ? load : random.between(1, 3);
    world.add(sphere(Real(0.1), mass).at((end + next) / 2).moving(random.direction()));
    world.joints.push_back(link % 2 == 0 ? ball_and_socket(world, link - 1, link, end)
                                         : hinge(world, link - 1, link, end, random.direction()));
    end = next;
  }
  return world;
}

/// v' solves J v' = 0 and differs from v + h g by M^-1 J^T lambda, so v' . M (v' - v - h g) = 0. The positions gain h v'.
/// Hence  E' = |v'|^2/2 - g.(x + h v') = E - |v' - v|^2/2,  M left out. Inertia the same about all axes, or I would turn.
struct EnergyOfAStep {
  Real energy;  ///< J, before it
  Real lost;    ///< J, that |v' - v|^2 / 2
  Real off;     ///< J, that E' is from it
};
template <class JointSolver>
EnergyOfAStep energy_of_a_step(World& world, JointSolver& solver, Real dt, int sweeps) {
  const std::vector<Body> before = world.bodies;
  const auto energy = [&world] { return kinetic_energy(world) + potential_energy(world); };
  const Real start = energy();
  world.step(solver, dt, sweeps);
  Real lost = 0;
  for (std::size_t i = 0; i < before.size(); ++i) {
    const Body& body = world.bodies[i];
    lost += (body.velocity - before[i].velocity).squaredNorm() / (2 * body.inverse_mass);
    lost +=
        (body.angular_velocity - before[i].angular_velocity).squaredNorm() / (2 * body.principal_inverse_inertia.x());
  }
  return {start, lost, std::abs(energy() - (start - lost))};
}

}  // namespace pushback
