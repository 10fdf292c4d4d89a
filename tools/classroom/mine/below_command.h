/// `./course mine body`, `touch` and `names`, as a reader calls them.
#pragma once

#include "pushback/tools/classroom/mine/below.h"
#include "pushback/tools/classroom/mine/my_file.h"

namespace pushback {

/// Compiles the page's header and prints its verdict, a line a check; true where all checks pass. Where there is no header yet,
/// it begins one and says so. Throws InvalidInput where that of the page before is missing.
bool check_page(const PageOfMine& page, const MyFolder& mine, std::uint64_t seed);

/// One hint more than last time.
void show_hints(const PageOfMine& page, MyFolder& mine);

/// The page's header beside the reader's.
void show_difference(const PageOfMine& page, const MyFolder& mine);

}  // namespace pushback
