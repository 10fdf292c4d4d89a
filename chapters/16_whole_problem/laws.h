/// The laws of contact that a solution violates, and by how much.
///
///   Signorini:            u_n >= 0 (no overlap), r_n >= 0 (no pull), r_n u_n = 0 (no push while separating)
///   Coulomb:              |r_t| <= mu r_n
///   maximum dissipation:  mu r_n u_t + |u_t| r_t = 0 (friction of a slipping contact is largest and opposes the slip)
///
/// Together they are s in K*, r in K, r . s = 0 of contact_problem.h. The natural map combines all five in one number.
///   Q. Le Lidec, W. Jallet, L. Montaut, I. Laptev, C. Schmid, J. Carpentier, "Contact Models in Robotics: a Comparative
///   Analysis", 2024, check which of these laws each simulator satisfies.
#pragma once

#include "pushback/engine/direct/contact_problem.h"

namespace pushback {

/// Dimensionless, as unitless_residual: r times sqrt(d), u divided by sqrt(d), all relative to ||q|| / sqrt(d). Each value is
/// the norm of a vector with one number per contact.
struct BrokenLaws {
  double overlap = 0;          ///< max(0, -u_n)
  double pull = 0;             ///< max(0, -r_n)
  double complementarity = 0;  ///< max(0, r_n) max(0, u_n), relative to ||q||^2
  double cone = 0;             ///< max(0, |r_t| - mu max(0, r_n))
  double dissipation = 0;      ///< |mu r_n u_t + |u_t| r_t|, relative to ||q||^2; r_t drawn back into the cone
};

/// Each violation counts against one law only. A pull or an overlap does not count against complementarity. An impulse outside
/// the cone does not count against dissipation, because its r_t is first drawn back to mu r_n.
BrokenLaws broken_laws(const ContactProblem& problem, const Vector& r);

}  // namespace pushback
