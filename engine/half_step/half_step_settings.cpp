#include "pushback/engine/half_step/half_step_settings.h"

#include "pushback/common/basics/input.h"

namespace pushback {

void HalfStepSettings::check() const {
  if (substeps < 1) throw InvalidInput(fmt::format("substeps is {}: a whole number, 1 or more, is needed", substeps));
  if (most_rounds < 1)
    throw InvalidInput(fmt::format("most_rounds is {}: a whole number, 1 or more, is needed", most_rounds));
  if (most_halvings < 0)
    throw InvalidInput(fmt::format("most_halvings is {}: a whole number, 0 or more, is needed", most_halvings));
  require_positive("tolerance", tolerance);
  if (!(most_work > 0)) throw InvalidInput(fmt::format("most_work is {}: a number above 0 is needed", most_work));
  require_not_negative("threshold", threshold);
}

}  // namespace pushback
