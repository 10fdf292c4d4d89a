/// What stands under a solver, from an empty file: `./course mine body`, `touch` and `names`, one for each of the three pages in
/// docs/from_an_empty_file.
#pragma once

#include <filesystem>

#include "pushback/tools/classroom/judge.h"

namespace pushback {

struct PageOfMine {
  int number;         ///< 1 to 3
  std::string word;   ///< body
  std::string page;   ///< docs/from_an_empty_file/1_a_body_and_its_step.md
  std::string title;  ///< "a body and its step"
  std::vector<std::string> hints;
  std::string begun_with;  ///< it compiles, and nothing in it is right

  std::string file() const { return word + ".h"; }
};

const std::vector<PageOfMine>& pages_of_mine();
/// None where `word` is not of a page.
const PageOfMine* page_of_mine(const std::string& word);

/// The checks of this page and of those before, with the known mistakes of all.
Exercise exercise_of_page(const PageOfMine& page);

/// The page's header, as the project has it.
std::string header_of(const PageOfMine& page);

/// Of the headers in `folder`.
Attempt attempt_of_page(const Exercise& exercise, const PageOfMine& page, const std::filesystem::path& folder,
                        std::uint64_t seed);

}  // namespace pushback
