/// The motions that the study plays: chapter 19's, two of later chapters, and those of further_motions.h.
#pragma once

#include "pushback/chapters/19_accuracy_and_time/motion.h"

namespace pushback {

/// Chapter 19's ten; then top, chapter 24's, on a pin; pendulum-at-wall, chapter 25's, of two bodies; gaps, superball, conveyor;
/// grasp, chaplygin, hulls-1015.
const std::vector<Motion>& every_motion();

/// One of them. Throws InvalidInput, with the names that there are, if none has this name.
const Motion& any_motion_named(const std::string& name);

/// Whether bodies of the motion may touch: whether nothing is pinned, or something stands there that nothing moves.
bool has_contacts(const Motion& motion);

/// How many bodies can move.
int moving_bodies(const Motion& motion);

/// Whether something has a restitution.
bool has_bounces(const Motion& motion);

/// Whether a body's surface moves: not every engine has that, and neither has the text in which adapters are asked.
bool has_conveyor(const Motion& motion);

}  // namespace pushback
