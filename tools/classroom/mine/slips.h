/// The known mistakes of a whole solver: the plain loop of any chapter from 00 to 08, with a slip in it. Those of later
/// chapters: slips_of_loops.h.
#pragma once

#include <string>
#include <vector>

#include "pushback/tools/classroom/mine/scenes.h"

namespace pushback {

enum class Slip {
  none,
  nothing_done,
  // 00
  against_itself,
  same_direction,
  only_upper,
  no_spin,
  arm_crossed,
  arm_from_origin,
  inertia_of_body_axes,
  spin_unread,
  k_without_arms,
  k_not_inverted,
  k_of_upper,
  impulse_not_kept,
  no_bounce,
  bounces_when_leaving,
  not_moved_apart,
  moved_alike,
  heavier_further,
  // 01
  one_sweep,
  speeds_read_first,
  last_impulse_kept,
  rows_not_cleared,
  already_let_go,
  // 02
  each_clamped,
  pulls_only,
  sum_clamped_alone,
  clamped_at_the_end,
  difference_forgotten,
  size_of_sum,
  no_clamp,
  // 03
  no_one_over_h,
  h_for_one_over_h,
  no_beta,
  sign_of_bias,
  bias_not_divided,
  bias_once,
  gap_pushed,
  gap_let_in,
  depth_halved,
  // 04
  slop_added,
  shallow_held,
  slop_all_or_nothing,
  slop_in_millimetres,
  slop_outside,
  min_before_slop,
  // 05
  velocity_now,
  no_threshold,
  threshold_turned,
  bounce_added,
  max_for_min,
  bounce_alone,
  one_more,
  spin_not_bounced,
  bounce_reread,
  // 06
  friction_first,
  friction_not_summed,
  one_sided,
  bound_of_last,
  bound_by_place,
  one_tangent,
  no_mu,
  mu_squared,
  slip_without_spin,
  friction_not_kept,
  friction_speeds_up,
  // 07
  no_scale,
  scale_turned,
  by_place,
  tangents_cold,
  stored_not_applied,
  applied_not_stored,
  applied_twice,
  step_before_last,
  guess_as_length,
  guess_before_bias,
  // 08
  square,
  second_late,
  no_k12,
  smaller_k,
  each_its_own,
  each_step_bounded,
  factor_squared,
  half_disc,
};

struct KnownSlip {
  Slip slip;
  int chapter;  ///< whose idea it spoils
  int last;     ///< the last one in which it can be made
  std::string name, hint;
};

/// Without Slip::none.
const std::vector<KnownSlip>& known_slips();

/// With Slip::none, it has the bits of the chapter's own.
WholeSolver loop_with(int chapter, Slip slip);

}  // namespace pushback
