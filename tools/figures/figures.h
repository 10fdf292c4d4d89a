/// The figures of the pages. What can be computed is: contacts are found, and rows solved, by the code that they are about.
#pragma once

#include <string>
#include <vector>

namespace pushback::figures {

/// A body A and a body B that overlap, with all that a row is made of.
std::string two_bodies();
/// What a step does, in its order.
std::string one_step();
/// What impulse and separating speed of a solved contact may be.
std::string complementarity();
/// Two rows solved in turn, in the plane of their impulses: their sums clamped, or each correction.
std::string two_points();
/// The speed that Baumgarte's bias wants, and the way that a ball takes to 0.
std::string bias_along_separation();
/// The same with slop: the way ends there.
std::string slop_along_separation();
/// Coulomb's cone, and the pyramid around it.
std::string cone_and_pyramid();
/// The friction that three solvers arrive at in one contact.
std::string friction_of_three();
/// The contact points of a box that slides over an edge, in two consecutive steps.
std::string ids_from_step_to_step();
/// Who touches whom, and what sleeps, when a ball has hit one of five piles.
std::string graph_and_islands();
/// A box that spins about its middle axis: with its angular momentum kept, with its angular velocity kept, and with a torque.
std::string free_spin();
/// The intervals that two boxes cover along an axis of each.
std::string separating_axes();

struct Figure {
  const char* file;  ///< in docs/figures/
  std::string (*draw)();
};
inline const std::vector<Figure>& all_figures() {
  static const std::vector<Figure> figures{
      {"two_bodies.svg", two_bodies},
      {"one_step.svg", one_step},
      {"complementarity.svg", complementarity},
      {"two_points.svg", two_points},
      {"bias.svg", bias_along_separation},
      {"slop.svg", slop_along_separation},
      {"cone_and_pyramid.svg", cone_and_pyramid},
      {"friction_of_three.svg", friction_of_three},
      {"contact_ids.svg", ids_from_step_to_step},
      {"islands.svg", graph_and_islands},
      {"free_spin.svg", free_spin},
      {"separating_axes.svg", separating_axes},
  };
  return figures;
}

}  // namespace pushback::figures
