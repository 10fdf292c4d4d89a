/// Plain loops with lines replaced: a mistake is written as what it changes.
#pragma once

#include <string>
#include <vector>

namespace pushback {

struct EditedLoop {
  std::string name, hint;
  std::string text;  ///< the loop's, after the edits
};

/// `edits`: after `== name` lines of the hint, each behind `> `, then the lines to be replaced, behind `- `, and those in
/// their place, behind `+ `. Any number of such replacements may follow. Text before the first name is ignored. Throws
/// std::runtime_error where the loop does not have the lines.
std::vector<EditedLoop> edited_loops(const std::string& edits, const std::string& loop);

/// A chapter's plain loop, its header and its source one after the other, as it stands in another namespace, under another name.
std::string renamed(const std::string& loop, const std::string& space_begins, const std::string& space_ends,
                    const std::string& solver);

}  // namespace pushback
