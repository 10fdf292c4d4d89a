/// The table as a picture.
#pragma once

#include "pushback/common/render/image.h"
#include "tests/hard_cases/table.h"

namespace pushback {

/// What stands beside each row: the case's scene, as `ends` has it. One a case.
std::vector<Image> portraits(const Table& table, const std::vector<World>& ends);

/// A row a case: its portrait, what it is, and a cell for each stage with its number.
Image draw_table(const Table& table, const std::vector<Image>& portraits);

/// The cells alone, small enough for a slide.
Image draw_overview(const Table& table);

}  // namespace pushback
