#include "pushback/engine/islands/island_settings.h"

#include <algorithm>
#include <cmath>

#include "pushback/common/basics/input.h"

namespace pushback {

namespace {

void check_limits(const ClassifierLimits& limits) {
  if (limits.most < 0) throw InvalidInput(fmt::format("most is {}: a whole number, 0 or more, is needed", limits.most));
  for (const auto& [name, limit] :
       {std::pair("most_kept", limits.most_kept), {"most_single_contacts", limits.most_single_contacts}})
    if (limit < limits.most)
      throw InvalidInput(fmt::format("{} is {}: no less than most is needed, which is {}", name, limit, limits.most));
  if (limits.large_pile < 1)
    throw InvalidInput(fmt::format("large_pile is {}: a whole number, 1 or more, is needed", limits.large_pile));
  if (limits.most_layers < 0)
    throw InvalidInput(fmt::format("most_layers is {}: a whole number, 0 or more, is needed", limits.most_layers));
  require_not_negative("calm_speed", limits.calm_speed);
  require_positive("most_mass_ratio", limits.most_mass_ratio);
  if (limits.most_detections < 1 || limits.most_detections > 64)
    throw InvalidInput(
        fmt::format("most_detections is {}: a whole number from 1 to 64 is needed", limits.most_detections));
  require_positive("fast_turn", limits.fast_turn);
}

void require(const char* name, double number, bool allowed, const char* what) {
  if (!allowed || !std::isfinite(number))
    throw InvalidInput(fmt::format("{} is {}: a finite number{} is needed", name, number, what));
}

void check_budget(const WorkBudgetSettings& budget) {
  require("budget.per_contact", budget.per_contact, budget.per_contact > 0, " above 0");
  require("budget.fraction", budget.fraction, budget.fraction >= 0, ", 0 or more,");
  require("budget.at_first", budget.at_first, budget.at_first >= 0, ", 0 or more,");
  require("budget.most", budget.most, budget.most >= 1, ", 1 or more,");
  require("budget.at_once", budget.at_once, budget.at_once >= 1, ", 1 or more,");
}

}  // namespace

void GivenSteps::check(std::size_t bodies) const {
  if (of_body.empty()) return;
  if (of_body.size() != bodies)
    throw InvalidInput(
        fmt::format("given.of_body has {} numbers: one for each of {} bodies is needed", of_body.size(), bodies));
  const int least = *std::min_element(of_body.begin(), of_body.end());
  require("given.of_body", least, least >= 1, ", 1 or more,");
  require("given.most_of_many", most_of_many, most_of_many >= 1, ", 1 or more,");
  require("given.substeps", substeps, substeps >= 1, ", 1 or more,");
  require_positive("given.tolerance", tolerance);
  require_not_negative("given.threshold", threshold);
}

void IslandSettings::check() const {
  check_limits(limits);
  check_budget(budget);
  require_positive("energy", energy);
  contact_half_step.check();
  joint_half_step.check();
  if (most_half_steps < joint_half_step.substeps)
    throw InvalidInput(
        fmt::format("most_half_steps is {}: no less than joint_half_step.substeps is needed, which is {}",
                    most_half_steps, joint_half_step.substeps));
}

}  // namespace pushback
