/// The motions of the study, which come from chapter 19, from later chapters and from further_motions.h.
#pragma once

#include "pushback/chapters/19_accuracy_and_time/motion.h"

namespace pushback {

/// Chapter 19's ten motions, then top (chapter 24, on a pin), pendulum-at-wall (chapter 25, of two bodies), gaps, superball, conveyor,
/// grasp, chaplygin and hulls-1015.
const std::vector<Motion>& every_motion();

/// One of every_motion. Throws InvalidInput, listing all names, if none has this name.
const Motion& any_motion_named(const std::string& name);

/// Whether bodies of the motion may touch, which is so if there are no pins or if there is an immovable body.
bool has_contacts(const Motion& motion);

/// The number of movable bodies.
int moving_bodies(const Motion& motion);

/// Whether any body has a restitution above 0.
bool has_bounces(const Motion& motion);

/// Whether any body is a conveyor, which some engines and the adapters' format do not have.
bool has_conveyor(const Motion& motion);

}  // namespace pushback
