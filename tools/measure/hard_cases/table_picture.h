/// The table as a picture.
#pragma once

#include "pushback/common/render/image.h"
#include "pushback/tools/measure/hard_cases/table.h"

namespace pushback {

/// A row a case, a cell for each stage: which of them pass, without numbers.
Image draw_overview(const Table& table);

}  // namespace pushback
