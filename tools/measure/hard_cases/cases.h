/// The hard cases, in groups.
#pragma once

#include "pushback/tools/measure/hard_cases/hard_case.h"

namespace pushback {

std::vector<HardCase> stack_cases();     ///< one on the other: stacks, a pyramid, heavy on light
std::vector<HardCase> pile_cases();      ///< card house, Jenga, wall, tower of planks
std::vector<HardCase> stone_cases();     ///< hulls: an arch, a heap of rubble
std::vector<HardCase> friction_cases();  ///< what must stick, and how far it slides
std::vector<HardCase> guided_cases();    ///< over tiles, on a turntable, in a groove, into a hole; a ball upon a ball
std::vector<HardCase> bounce_cases();    ///< how high, how fast, how elastic
std::vector<HardCase> impact_cases();    ///< dominoes, bodies born in each other, hits at 500 m/s, thin walls
std::vector<HardCase> no_solution_cases();  ///< what forces alone cannot solve: Painleve's rod, a body squeezed
std::vector<HardCase> scale_cases();        ///< far, thin, tiny, spinning
std::vector<HardCase> joint_cases();        ///< chains and a bridge with heavy loads
std::vector<HardCase> ball_cases();         ///< a tennis ball on a basketball
std::vector<HardCase> edge_cases();         ///< just before, and just beyond, what friction and thickness hold
std::vector<HardCase> mechanism_cases();    ///< a linkage through its dead points, a motor against a limit
std::vector<HardCase> step_cases();         ///< other time steps, contacts given twice, bodies in another order

}  // namespace pushback
