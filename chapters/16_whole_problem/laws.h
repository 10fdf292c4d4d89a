/// Which law of contact an answer breaks, and by how much.
///
///   Signorini:            u_n >= 0 (no overlap), r_n >= 0 (no pull), r_n u_n = 0 (nothing pushes what parts)
///   Coulomb:              |r_t| <= mu r_n
///   maximum dissipation:  mu r_n u_t + |u_t| r_t = 0: what slides is rubbed with all that there is, straight against the slip
///
/// Together they are s in K*, r in K, r . s = 0 of contact_problem.h. The natural map adds all five up in one number.
///   Q. Le Lidec, W. Jallet, L. Montaut, I. Laptev, C. Schmid, J. Carpentier, "Contact Models in Robotics: a Comparative
///   Analysis", 2024, ask of each simulator which of these it keeps.
#pragma once

#include "pushback/engine/direct/contact_problem.h"

namespace pushback {

/// Without units, as unitless_residual: r times sqrt(d), u divided by sqrt(d), all relative to ||q|| / sqrt(d). Each is the
/// length of the vector that has a number for each contact.
struct BrokenLaws {
  double overlap = 0;          ///< max(0, -u_n)
  double pull = 0;             ///< max(0, -r_n)
  double complementarity = 0;  ///< max(0, r_n) max(0, u_n), relative to ||q||^2
  double cone = 0;             ///< max(0, |r_t| - mu max(0, r_n))
  double dissipation = 0;  ///< |mu r_n u_t + |u_t| r_t|, relative to ||q||^2; of r_t that part which is within the cone
};

/// Each law is asked of its own numbers only. What pulls or overlaps is not held against complementarity too, nor what is
/// outside the cone against dissipation: its r_t is first drawn back to mu r_n.
BrokenLaws broken_laws(const ContactProblem& problem, const Vector& r);

}  // namespace pushback
